/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A hand moves the needle: what stands against that, whatever the mode asks for. The controller
 * owns one and steps it every cycle of a robot that has a sensor for the hand.
 */
#ifndef BORESIGHT_HAND_GUARD_H
#define BORESIGHT_HAND_GUARD_H

#include "interface/permit_reason.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** Force of the hand in one cycle. */
typedef struct {
    int32_t force_mn; /**< Positive towards the patient. */
    bool is_trusted;  /**< The sensor is zeroed, and nothing speaks against it. */
} hand_t;

/** At first all zero: no hand, and none was seen to let go. */
typedef struct {
    uint32_t left_us;   /**< Until the last push has been over for LIMIT_HAND_OFF_US; 0: it has. */
    uint32_t quiet_us;  /**< No force beyond the dead zone for so long, to LIMIT_HAND_PROOF_US. */
    uint32_t proven_us; /**< So long may what the hand does now go on: it was seen off before; 0: it
                           may not, or was not. */
} hand_guard_t;

/**
 * One cycle, `elapsed_us` after the one before. `is_moving`: the pedal lets the armed order run,
 * and nothing asks for the hand to be seen off anew.
 *
 * @return the force that may move the needle: that of the hand, and 0 until it was seen off, and
 * from LIMIT_HAND_PUSH_US after that on
 *
 * @satisfies SWR-COOP-012
 * @satisfies SWR-COOP-013
 */
int32_t hand_guard_step(hand_guard_t *self, const hand_law_t *law, const hand_t *hand,
                        bool is_moving, uint32_t elapsed_us);

/**
 * Reasons against every drive while a hand moves the needle, which goes in alone: its force is not
 * trusted, it was not seen off for LIMIT_HAND_PUSH_US, it has not pushed by more than the dead zone
 * for LIMIT_HAND_OFF_US, or the needle has no way left (`left_ticks`, to its depth).
 *
 * @return bit mask of permit_reason_t
 *
 * @satisfies SWR-COOP-008
 */
uint32_t hand_guard_reasons(const hand_guard_t *self, const hand_t *hand, int64_t left_ticks);

#endif
