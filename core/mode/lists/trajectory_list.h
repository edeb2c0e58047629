/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The trajectory that is held: rows of time, positions and speeds, which come one by one and are
 * judged as they come, each against the one before. So a whole list is one that may be driven:
 * between two rows each axis goes on a cubic (motion/cubic.h), within its soft limits, its speed
 * and acceleration and the limits that it shares with others. The caller owns head and rows; the
 * rows lie outside of what it seals, each with a checksum of its own.
 */
#ifndef BORESIGHT_TRAJECTORY_LIST_H
#define BORESIGHT_TRAJECTORY_LIST_H

#include "interface/status.h"
#include "limits/requirement_limits.h"
#include "mode/lists/trajectory_row.h"
#include "motion/cubic.h"
#include "robot/joints.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** The head of the list; all zero is the empty one. */
typedef struct {
    uint32_t total;    /**< Number of rows that it shall have. */
    uint32_t count;    /**< Number of rows that it has. */
    uint32_t crc;      /**< trajectory_list_crc() of them. */
    uint32_t is_whole; /**< All have come, and are those that were sent: 0 or 1. */
    uint32_t source;   /**< trajectory_source_t. */
    uint32_t peer;     /**< Peer that sent it. */
} trajectory_list_t;

/** Nothing is held. */
void trajectory_list_clear(trajectory_list_t *self);

/**
 * A list of `total` rows shall come; what was held is gone. 0 rows: nothing is held.
 *
 * @return STATUS_OK; STATUS_OUT_OF_RANGE for more than LIMIT_TRAJECTORY_ROWS, and nothing changes
 *
 * @satisfies SWR-TRAJ-001
 */
status_t trajectory_list_begin(trajectory_list_t *self, uint32_t total);

/**
 * The next row, `index` from 0 on. Its checksum is made here. A refused one empties the list.
 *
 * @return STATUS_OK; STATUS_TRAJECTORY_ORDER, STATUS_AXIS_LIMIT, STATUS_SWITCH_ZONE,
 * STATUS_TRAJECTORY_SPEED, the refusal of a limit that axes share, STATUS_NEEDLE_IN, with axis and
 * end; STATUS_MEMORY_DAMAGED when the row before is not what it was
 *
 * @satisfies SWR-TRAJ-001
 * @satisfies SWR-TRAJ-002
 * @satisfies SWR-TRAJ-003
 * @satisfies SWR-TRAJ-004
 * @satisfies SWR-TRAJ-005
 */
solution_t trajectory_list_add(trajectory_list_t *self,
                               trajectory_row_t rows[LIMIT_TRAJECTORY_ROWS], const robot_t *robot,
                               uint32_t index, const trajectory_row_t *row);

/**
 * Ends the list: all rows have come. `crc` is trajectory_list_crc() of the rows that the client
 * sent. A refusal empties the list.
 *
 * @return STATUS_OK; STATUS_TRAJECTORY_ORDER while rows are missing; STATUS_TRAJECTORY_SUM
 *
 * @satisfies SWR-TRAJ-001
 */
status_t trajectory_list_end(trajectory_list_t *self, uint32_t crc);

/** Time of the last of its `rows`, ms; 0 of an empty list. */
uint32_t trajectory_list_end_ms(const trajectory_list_t *self, const trajectory_row_t *rows);

/** `ticks` is where the limit switch of the axis may be active: it may stand there, but is not
 * driven to it.
 */
bool trajectory_list_is_in_zone(const axis_config_t *config, int32_t ticks);

/** The way of axis `axis` from one row to the next; of a row to itself it stands there. */
void trajectory_list_way(const trajectory_row_t *from, const trajectory_row_t *to, uint32_t axis,
                         cubic_t *way);

#endif
