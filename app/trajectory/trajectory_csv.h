/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A trajectory as a table of text: a line that names columns with their units, then a line for each
 * row. "time s" or "time ms" comes once; of an axis "NAME ticks", "NAME mm" or "NAME deg" is its
 * position, "NAME ticks/s", "NAME mm/s" or "NAME deg/s" its speed. Without a column an axis stays
 * where it is. Without a speed it has one that lets it overshoot no row: none where it turns and at
 * both ends, otherwise the harmonic mean of the speeds before and behind (Butland 1980). The limits
 * of the robot are not judged here.
 */
#ifndef BORESIGHT_TRAJECTORY_CSV_H
#define BORESIGHT_TRAJECTORY_CSV_H

#include "limits/requirement_limits.h"
#include "mode/lists/trajectory_row.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct {
    uint32_t count;
    trajectory_row_t rows[LIMIT_TRAJECTORY_ROWS];
} trajectory_csv_t;

/** The line of row `row`, from 1 on. */
static inline uint32_t trajectory_csv_line(uint32_t row)
{
    return row + 2U;
}

/**
 * Reads `text`, which ends with a zero byte. `stands`: where each axis stands, ticks;
 * NULL: that is not known, and each needs a column.
 *
 * @return 0, or the line, from 1 on, that cannot be read or is one too many; an empty line ends
 * the table, and only empty ones may follow
 *
 * @satisfies SWR-TRAJ-015
 */
uint32_t trajectory_csv_read(trajectory_csv_t *self, const char *text, const robot_t *robot,
                             const int32_t stands[ROBOT_AXIS_MAX]);

#endif
