/* SPDX-License-Identifier: Apache-2.0 */
/** @file JSON inside of a page. */
#ifndef BORESIGHT_PAGE_TEXT_H
#define BORESIGHT_PAGE_TEXT_H

#include <stddef.h>
#include <stdio.h>

/**
 * Writes `size` bytes of JSON such that a page takes none of it for the beginning of a tag: JSON
 * has that letter in its texts only, which may say it otherwise.
 *
 * @satisfies SWR-REPLAY-019
 */
void page_text_write(FILE *file, const char *json, size_t size);

#endif
