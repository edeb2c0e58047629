/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A recording of force and depth as a table of text: a line that names its columns, then a line for
 * each row. "time_ms", "depth_mm" and "force_n" must be among the columns, in any order; others are
 * passed over. Any sensor may have made it: it is sampled anew, each millisecond.
 */
#ifndef BORESIGHT_FORCE_CSV_H
#define BORESIGHT_FORCE_CSV_H

#include <stdbool.h>
#include <stdint.h>

typedef struct {
    double time_ms;  /**< After that of the row before. */
    double depth_mm; /**< Deeper is larger; up to LIMIT_MEMBRANE_CSV_MOST_MM to either side. */
    double force_n;  /**< Against the needle, zeroed; up to LIMIT_MEMBRANE_MOST_MN so. */
} force_row_t;

/** Owns its rows. */
typedef struct {
    force_row_t *rows;
    uint32_t count;   /**< Two or more. */
    char refused[80]; /**< Why a line is refused, without a full stop. */
} force_csv_t;

/**
 * Reads `text`, which ends with a zero byte. Empty lines may follow the last row.
 *
 * @return 0, or the line, from 1 on, that is refused; then there is nothing to free
 *
 * @satisfies SWR-PUNCT-554
 */
uint32_t force_csv_read(force_csv_t *self, const char *text);

void force_csv_free(force_csv_t *self);

/** The line of row `row`, from 0 on. */
static inline uint32_t force_csv_line(uint32_t row)
{
    return row + 2U;
}

/** A way through the rows. All zero at first but `csv`. */
typedef struct {
    const force_csv_t *csv;
    uint32_t row;   /**< The last one that is not later than the sample. */
    uint32_t at_ms; /**< Of the next sample, after the first row. */
} force_samples_t;

/**
 * The sample of the next millisecond: on the straight line between two rows.
 *
 * @return false: none exists
 */
bool force_samples_next(force_samples_t *self, force_row_t *sample);

#endif
