/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A move to a target, in legs: the needle is retracted, every other axis is aligned, the needle is
 * inserted. Legs that are not needed are skipped, and each leg is chosen from where the axes stand.
 * A needle that is steered is inserted while its rotation turns.
 */
#ifndef BORESIGHT_MOVE_MODE_H
#define BORESIGHT_MOVE_MODE_H

#include "mode/leg/leg.h"
#include "mode/leg/mode_frame.h"
#include "mode/leg/steer.h"
#include "robot/steering.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct {
    int32_t target_ticks[ROBOT_AXIS_MAX];
    steering_t steering;
} move_mode_t;

/** Every axis but the needle, and the rotation of one that is steered, stands where it shall, but
 * for a slack of some ticks. */
bool move_mode_is_aligned(const move_mode_t *self, const robot_t *robot,
                          const axis_t axes[ROBOT_AXIS_MAX]);

/** One cycle of a needle that is not steered; done once the last leg has arrived. */
void move_mode_go(const move_mode_t *self, leg_t *leg, const mode_frame_t *frame,
                  mode_result_t *result);

/**
 * One cycle, as move_mode_go(); the last leg of a needle that is steered goes on only while its
 * rotation follows its law. At its depth it is not turned any more.
 *
 * @satisfies SWR-DEMO-001
 * @satisfies SWR-MOTION-002
 * @satisfies SWR-STEER-008
 * @satisfies SWR-STEER-015
 */
void move_mode_step(const move_mode_t *self, leg_t *leg, steer_t *steer, const mode_frame_t *frame,
                    mode_result_t *result);

#endif
