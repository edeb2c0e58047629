/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A trajectory is driven: from where the axes stand on a leg to the first row, then through all
 * rows in their time, then on a leg to where the last one says. Released, the pedal stops its time;
 * pressed again, the axes go on a leg to where it was stopped, and time gains its pace from rest.
 */
#ifndef BORESIGHT_TRAJECTORY_MODE_H
#define BORESIGHT_TRAJECTORY_MODE_H

#include "mode/leg/leg.h"
#include "mode/leg/mode_asked.h"
#include "mode/leg/mode_frame.h"
#include "mode/lists/trajectory_list.h"
#include "robot/joints.h"

#include <stdbool.h>
#include <stdint.h>

/** Trajectory that is driven. */
typedef struct {
    const trajectory_list_t *list;
    const trajectory_row_t *rows;
} trajectory_t;

/** Times of its list, in ms. */
typedef struct {
    uint32_t start_ms; /**< Time of its first row, */
    uint32_t end_ms;   /**< and of its last one. */
} trajectory_span_t;

typedef struct {
    uint32_t row;       /**< The last one that was passed. */
    uint32_t time_us;   /**< Time of the list. */
    uint32_t is_on_way; /**< Between rows, and not on a leg: 0 or 1. */
    uint32_t pace;      /**< Cycles since a pause, at most those until time has its pace. */
    uint32_t behind_us; /**< Lead of real time over it, pauses and ramps apart. */
} trajectory_mode_t;

/**
 * May the list that has checksum `crc` be driven from where the axes stand?
 *
 * @return status STATUS_OK; STATUS_TRAJECTORY_EMPTY without a whole list; STATUS_TRAJECTORY_SUM;
 * STATUS_MEMORY_DAMAGED of its first row; STATUS_NOT_HOMED; STATUS_TRAJECTORY_FAR when the first
 * row is more than LIMIT_TRAJECTORY_LEAD_NM or LIMIT_TRAJECTORY_LEAD_BAM away; STATUS_NEEDLE_IN;
 * STATUS_SWITCH_ZONE; the refusal of a limit that the way to it would leave; with the axis
 *
 * @satisfies SWR-TRAJ-006
 * @satisfies SWR-TRAJ-007
 */
solution_t trajectory_mode_judge(const trajectory_t *asked, uint32_t crc, const robot_t *robot,
                                 const axis_t axes[ROBOT_AXIS_MAX]);

/**
 * The same of its first row, at `ticks`, alone.
 *
 * @return status STATUS_OK; STATUS_NOT_HOMED; STATUS_TRAJECTORY_FAR; STATUS_NEEDLE_IN;
 * STATUS_SWITCH_ZONE; the refusal of a limit that the way to it would leave; with the axis
 */
solution_t trajectory_mode_judge_start(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                                       const int32_t ticks[ROBOT_AXIS_MAX]);

/** It was armed: from the first row on, whose time is `start_ms`. */
void trajectory_mode_begin(trajectory_mode_t *self, uint32_t start_ms);

/** Rest of the time of a list that ends at `end_ms`, ms; it stands on the ways to a row. */
uint32_t trajectory_mode_left_ms(const trajectory_mode_t *self, uint32_t end_ms);

/** A cycle without the pedal: time stands. */
void trajectory_mode_pause(trajectory_mode_t *self);

/**
 * One cycle; done once all axes have arrived at the last row.
 *
 * Fails with EVENT_MEMORY_DAMAGED at a row that is not what was judged, and with
 * EVENT_TRAJECTORY_LATE when real time is LIMIT_TRAJECTORY_LATE_US ahead.
 *
 * @satisfies SWR-TRAJ-008
 * @satisfies SWR-TRAJ-009
 * @satisfies SWR-TRAJ-010
 * @satisfies SWR-TRAJ-011
 * @satisfies SWR-TRAJ-012
 */
void trajectory_mode_step(trajectory_mode_t *self, const trajectory_list_t *list, leg_t *leg,
                          const mode_frame_t *frame, mode_result_t *result);

/**
 * From the first row of the list that is held to its last one.
 *
 * @return 0: all axes
 */
uint32_t trajectory_mode_ask(const mode_asked_t *asked, trajectory_span_t *span);

#endif
