/* SPDX-License-Identifier: Apache-2.0 */
/** @file A mode of a test: the first axis goes a little way, and back. */
#ifndef BORESIGHT_TREMBLE_MODE_H
#define BORESIGHT_TREMBLE_MODE_H

#include "mode/leg/leg.h"
#include "mode/leg/mode_frame.h"
#include "robot/joints.h"

#include <stdint.h>

typedef struct {
    uint32_t legs; /**< That have begun. */
    int32_t start_ticks;
} tremble_mode_t;

/** @return status STATUS_OK, or STATUS_NEEDLE_IN */
solution_t tremble_mode_judge(const tremble_mode_t *self, const robot_t *robot,
                              const axis_t axes[ROBOT_AXIS_MAX]);

/** One cycle; done once the axis is back. */
void tremble_mode_step(tremble_mode_t *self, leg_t *leg, const mode_frame_t *frame,
                       mode_result_t *result);

#endif
