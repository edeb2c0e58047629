/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The needle alone goes to its depth at the target, once the base is aligned: the last leg of a
 * move (move_mode.h). All other axes are held; one that is not aligned any more ends it.
 */
#ifndef BORESIGHT_INSERT_MODE_H
#define BORESIGHT_INSERT_MODE_H

#include "mode/move/move_mode.h"
#include "robot/joints.h"

/**
 * May the needle go in alone?
 *
 * @return status STATUS_OK, or STATUS_NOT_ALIGNED
 *
 * @satisfies SWR-ALIGN-004
 */
solution_t insert_mode_judge(const move_mode_t *self, const robot_t *robot,
                             const axis_t axes[ROBOT_AXIS_MAX]);

/**
 * One cycle; done once the needle has arrived. It begins, at first and after each pause, only while
 * the base is aligned, and fails with STATUS_NOT_ALIGNED otherwise.
 *
 * @satisfies SWR-ALIGN-005
 */
void insert_mode_step(const move_mode_t *self, leg_t *leg, steer_t *steer,
                      const mode_frame_t *frame, mode_result_t *result);

#endif
