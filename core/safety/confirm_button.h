/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The button at the box with which the operator confirms that the positions shown are those of the
 * robot. A press counts once, when it was held long enough, and only after the button was seen
 * released: a stuck or jammed button says nothing. The controller owns one.
 */
#ifndef BORESIGHT_CONFIRM_BUTTON_H
#define BORESIGHT_CONFIRM_BUTTON_H

#include <stdbool.h>
#include <stdint.h>

/** Under seal. */
typedef struct {
    uint32_t held_cycles; /**< Cycles of the present press. */
    uint32_t is_proven;   /**< Seen released since it counted or was barred: 0 or 1. */
} confirm_button_sealed_t;

/** All zero at the start: not seen released. */
typedef struct {
    confirm_button_sealed_t sealed;
} confirm_button_t;

/**
 * One cycle. `is_barred`: nothing is to be confirmed now; the button must be released afterwards.
 *
 * @return true in the cycle in which it has been held for LIMIT_CONFIRM_HOLD_US
 *
 * @satisfies SWR-REF-006
 */
bool confirm_button_step(confirm_button_t *self, bool is_pressed, bool is_barred);

/**
 * It means something else from now on: a press that has begun does not count.
 *
 * @satisfies SWR-AUTH-009
 */
static inline void confirm_button_renew(confirm_button_t *self)
{
    self->sealed.held_cycles = 0U;
    self->sealed.is_proven = 0U;
}

#endif
