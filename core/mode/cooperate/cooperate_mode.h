/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Cooperative insertion: the hand on the handle moves the needle towards its depth at the target,
 * as fast as it pushes (motion/admittance.h), and never back but to vibrate: a puncture stops the
 * needle, which then goes back and forward again a few times (motion/vibration.h), while the hand
 * still pushes and is not followed. All other axes rest but the rotation of a needle that is
 * steered, for which a push waits as an insertion does. A design of this project after thesis 5.5,
 * which names the mode and gives no law.
 */
#ifndef BORESIGHT_COOPERATE_MODE_H
#define BORESIGHT_COOPERATE_MODE_H

#include "mode/leg/mode_frame.h"
#include "mode/move/move_mode.h"
#include "robot/joints.h"

#include <stdbool.h>
#include <stdint.h>

/** Stage of an insertion by hand. */
typedef enum {
    COOPERATE_FOLLOWS = 0, /**< It follows the hand. */
    COOPERATE_BRAKES = 1,  /**< A puncture was found: its set-point comes to rest. */
    COOPERATE_VIBRATES = 2,
    COOPERATE_ENDED = 3 /**< It has vibrated: the hand is to be seen off before it is followed. */
} cooperate_stage_t;

/** At first all zero. */
typedef struct {
    int32_t rest;        /**< Part by which the set-point is less than its place, of RAMP_TICK. */
    uint32_t stage;      /**< cooperate_stage_t. */
    uint32_t cycle;      /**< While it vibrates: cycles of the train that are over. */
    int32_t begin_ticks; /**< While it vibrates: where it began. */
} cooperate_mode_t;

/**
 * May a hand move the needle?
 *
 * @return status STATUS_OK, STATUS_NO_HAND, STATUS_NOT_ALIGNED, STATUS_TOO_DEEP
 *
 * @satisfies SWR-FLOW-007
 * @satisfies SWR-COOP-009
 */
solution_t cooperate_mode_judge(const move_mode_t *move, const robot_t *robot,
                                const axis_t axes[ROBOT_AXIS_MAX]);

/**
 * One cycle with a trusted force; done once the needle rests at its depth. Fails as
 * cooperate_mode_judge() says, without a drive in that cycle.
 *
 * @satisfies SWR-COOP-001
 * @satisfies SWR-COOP-002
 * @satisfies SWR-COOP-003
 * @satisfies SWR-COOP-004
 * @satisfies SWR-COOP-005
 * @satisfies SWR-COOP-007
 * @satisfies SWR-VIB-700
 * @satisfies SWR-VIB-703
 * @satisfies SWR-VIB-704
 * @satisfies SWR-VIB-707
 */
void cooperate_mode_step(cooperate_mode_t *self, const move_mode_t *move, steer_t *steer,
                         const mode_frame_t *frame, mode_result_t *result);

/** The pedal does not let it run: a vibration is over. */
static inline void cooperate_mode_pause(cooperate_mode_t *self)
{
    self->stage = (uint32_t)COOPERATE_FOLLOWS;
}

/** The needle comes to rest for a vibration, or vibrates. */
static inline bool cooperate_mode_is_vibrating(const cooperate_mode_t *self)
{
    return self->stage != (uint32_t)COOPERATE_FOLLOWS;
}

/** The needle vibrates: it is never deeper than where that began. */
static inline bool cooperate_mode_is_stroke(const cooperate_mode_t *self)
{
    return self->stage == (uint32_t)COOPERATE_VIBRATES;
}

/** The hand is to be seen off before the needle follows it again. */
static inline bool cooperate_mode_wants_hand_off(const cooperate_mode_t *self)
{
    return self->stage == (uint32_t)COOPERATE_ENDED;
}

#endif
