/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The reasons against motion as they are shown: one that flickers is shown as standing. For eyes
 * only; the permit itself is never held. The controller owns one per axis and steps it every cycle.
 */
#ifndef BORESIGHT_REASON_HOLD_H
#define BORESIGHT_REASON_HOLD_H

#include "safety/permit.h"

#include <stdint.h>

#define REASON_HOLD_COUNT (PERMIT_REASON_END_OF_PLACE - PERMIT_REASON_FIRST_OF_PLACE)

/** At first all zero. */
typedef struct {
    uint32_t shown;      /**< Bit mask of permit_reason_t. */
    uint32_t flickering; /**< Those that came back soon after they had gone. */
    /** LIMIT_REASON_HOLD_US while it stands, then down to 0. */
    uint32_t left_us[REASON_HOLD_COUNT];
} reason_hold_t;

/** Part of reason_hold_step() for reasons that stand or have stood lately. */
void reason_hold_watch(reason_hold_t *self, uint32_t reasons, uint32_t elapsed_us);

/**
 * One cycle, `elapsed_us` after the one before, with the `reasons` of the permit. A reason that is
 * back within LIMIT_REASON_HOLD_US is shown from then on, until it has been gone for as long.
 *
 * @satisfies SWR-PERMIT-006
 */
static inline void reason_hold_step(reason_hold_t *self, uint32_t reasons, uint32_t elapsed_us)
{
    uint32_t recent = reasons >> PERMIT_REASON_FIRST_OF_PLACE;
    for (uint32_t i = 0U; i < REASON_HOLD_COUNT; i++) {
        recent |= self->left_us[i];
    }
    /* Mostly all have been gone for long. */
    if (recent != 0U) {
        reason_hold_watch(self, reasons, elapsed_us);
    }
    self->shown = reasons | self->flickering;
}

#endif
