/* SPDX-License-Identifier: Apache-2.0 */
/** @file The one file of a module that has no system below it: bytes that a page has put there.
 * Output on the standard error is kept for the page. */
#ifndef BORESIGHT_ONE_FILE_H
#define BORESIGHT_ONE_FILE_H

#include <stdint.h>

/** Room for the bytes of the file; NULL: there is none. Any file opened from now on is that
 * file. */
uint8_t *one_file_make(uint32_t size);

/** Output so far, as a text; output without room is left out. */
const char *one_file_printed(void);

#endif
