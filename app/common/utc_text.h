/* SPDX-License-Identifier: Apache-2.0 */
/** @file UTC as ISO 8601 has it: 2026-11-22T17:50:00.123Z. */
#ifndef BORESIGHT_UTC_TEXT_H
#define BORESIGHT_UTC_TEXT_H

#include <stdbool.h>
#include <stdint.h>

#define UTC_TEXT_SIZE 25U /**< With its end. */

/** Writes `utc_us`, since 1970 and before the year 10000, to the millisecond. */
void utc_text_write(uint64_t utc_us, char text[UTC_TEXT_SIZE]);

/**
 * Reads a date and a time with a Z behind them, with up to six digits of a fraction or none, from
 * 1970 on. False: `text` is none, or something stands behind it.
 */
bool utc_text_read(const char *text, uint64_t *utc_us);

#endif
