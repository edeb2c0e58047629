/* SPDX-License-Identifier: Apache-2.0 */
/** @file A row of a trajectory, and the checksums by which it and a list of them are known. */
#ifndef BORESIGHT_TRAJECTORY_ROW_H
#define BORESIGHT_TRAJECTORY_ROW_H

#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** One row. No padding. */
typedef struct {
    uint32_t time_ms;
    int32_t ticks[ROBOT_AXIS_MAX];
    int32_t speeds_ticks_per_s[ROBOT_AXIS_MAX];
    uint32_t crc; /**< trajectory_row_crc() of all before it. */
} trajectory_row_t;

/** CRC-32C of a row: time, positions, speeds, as they lie in memory. */
uint32_t trajectory_row_crc(const trajectory_row_t *row);

/** The row is as it was taken. */
bool trajectory_row_is_whole(const trajectory_row_t *row);

/** Checksum of a list that was `crc` (0 of none) with one row more: CRC-32C of that and the row's.
 */
uint32_t trajectory_list_crc(uint32_t crc, const trajectory_row_t *row);

#endif
