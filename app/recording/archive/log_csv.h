/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Events as a table for spreadsheets (RFC 4180): a line with the names of the columns, then a line
 * for each. No cell is a formula.
 */
#ifndef BORESIGHT_LOG_CSV_H
#define BORESIGHT_LOG_CSV_H

#include "recording/archive/log_search.h"
#include "robot/robot.h"

#include <stddef.h>

/**
 * Writes what was found, with the names of `robot`.
 *
 * @param size  set to its bytes
 * @return text for free(); NULL without memory
 *
 * @satisfies SWR-HTTP-042
 */
char *log_csv_write(const log_search_t *found, const robot_t *robot, size_t *size);

#endif
