/* SPDX-License-Identifier: Apache-2.0 */
/** @file The page of the console's build that shows a recording; tools/compile/embed_page.rb puts
 * it into the program. */
#ifndef BORESIGHT_REPLAY_PAGE_H
#define BORESIGHT_REPLAY_PAGE_H

/** Behind this the recording is put, as JSON; it is in the page once. */
#define REPLAY_PAGE_MARK "<script id=\"recording\" type=\"application/json\">"

/** The page, with its end. */
extern const unsigned char replay_page[];

#endif
