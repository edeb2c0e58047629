/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The treatment program that is held: steps of depth, angle about the needle, dwell and gate, which
 * come one by one and are judged as they come for the accepted target, each with its way from the
 * one before. All axes but those along and about the needle stand at the target meanwhile. The
 * caller owns it; list and steps have checksums of their own.
 */
#ifndef BORESIGHT_PROGRAM_LIST_H
#define BORESIGHT_PROGRAM_LIST_H

#include "interface/status.h"
#include "limits/requirement_limits.h"
#include "mode/lists/program_step.h"
#include "robot/joints.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** All zero it holds nothing. No padding. */
typedef struct {
    uint32_t total;      /**< Number of steps that it shall have. */
    uint32_t count;      /**< Number of steps that it has. */
    uint32_t crc;        /**< program_list_crc() of them. */
    uint32_t is_whole;   /**< All have come, and are those that were sent: 0 or 1. */
    uint32_t source;     /**< command_source_t of its sender. */
    uint32_t target_crc; /**< CRC-32C of the positions of the target that it was sent for. */
    uint32_t seal;       /**< CRC-32C of all before it. */
    program_step_t steps[LIMIT_PROGRAM_STEPS];
} program_list_t;

/**
 * A list of `total` steps shall come for the target at `target_ticks`; what was held is gone. 0
 * steps: nothing is held.
 *
 * @return STATUS_OK; STATUS_OUT_OF_RANGE for more than LIMIT_PROGRAM_STEPS, and nothing changes
 *
 * @satisfies SWR-PROG-001
 */
status_t program_list_begin(program_list_t *self, uint32_t total, uint32_t source,
                            const int32_t target_ticks[ROBOT_AXIS_MAX]);

/**
 * The next step, `index` from 0 on. Its checksum is made here. A refused one empties the list.
 *
 * @return STATUS_OK; STATUS_PROGRAM_ORDER, STATUS_PROGRAM_OTHER for another target than it was
 * begun for, STATUS_PROGRAM_DWELL, STATUS_PROGRAM_DEPTH, STATUS_AXIS_LIMIT, STATUS_SWITCH_ZONE, the
 * refusal of a limit that axes share, with axis and end
 *
 * @satisfies SWR-PROG-001
 * @satisfies SWR-PROG-002
 * @satisfies SWR-PROG-003
 */
solution_t program_list_add(program_list_t *self, const robot_t *robot,
                            const int32_t target_ticks[ROBOT_AXIS_MAX], uint32_t index,
                            const program_step_t *step);

/**
 * Ends the list: all steps have come. `crc` is program_list_crc() of the steps that the client
 * sent. A refusal empties the list.
 *
 * @return STATUS_OK; STATUS_PROGRAM_ORDER while steps are missing, or with another checksum
 *
 * @satisfies SWR-PROG-001
 */
status_t program_list_end(program_list_t *self, uint32_t crc);

/**
 * It is whole, undamaged, has checksum `crc`, and was sent for the target at `target_ticks`.
 *
 * @satisfies SWR-PROG-004
 */
bool program_list_is_meant(const program_list_t *self, uint32_t crc,
                           const int32_t target_ticks[ROBOT_AXIS_MAX]);

/**
 * Step `index`.
 *
 * @return NULL: there is none, or it or the list is not what was judged
 *
 * @satisfies SWR-PROG-009
 */
const program_step_t *program_list_step(const program_list_t *self, uint32_t index);

/** target_crc of a list that was sent for the target at `target_ticks`. */
uint32_t program_list_target_crc(const int32_t target_ticks[ROBOT_AXIS_MAX]);

/** Positions of all axes at `step`. */
void program_list_ends(const robot_t *robot, const int32_t target_ticks[ROBOT_AXIS_MAX],
                       const program_step_t *step, int32_t ends[ROBOT_AXIS_MAX]);

#endif
