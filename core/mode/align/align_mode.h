/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Lines up with the entry point: a move to the target (move_mode.h) but for its last leg. The
 * needle is taken out if it is in, every other axis goes where it stands at the target, and the
 * needle stays out: it may be inserted by hand, or by an insertion (insert_mode.h).
 */
#ifndef BORESIGHT_ALIGN_MODE_H
#define BORESIGHT_ALIGN_MODE_H

#include "mode/move/move_mode.h"

#include <stdint.h>

/**
 * The move to run: to `target_ticks` with the needle out, where it stands if it
 * is out already, so that it never goes in.
 *
 * @satisfies SWR-ALIGN-002
 * @satisfies SWR-FLOW-004
 */
move_mode_t align_mode_move(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                            const int32_t target_ticks[ROBOT_AXIS_MAX]);

/** One cycle, as move_mode_step(). */
void align_mode_step(const move_mode_t *self, leg_t *leg, const mode_frame_t *frame,
                     mode_result_t *result);

#endif
