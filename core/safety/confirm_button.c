/* SPDX-License-Identifier: Apache-2.0 */
#include "safety/confirm_button.h"

#include "limits/requirement_limits.h"

bool confirm_button_step(confirm_button_t *self, bool is_pressed, bool is_barred)
{
    if (is_barred || !is_pressed) {
        self->sealed.held_cycles = 0U;
        self->sealed.is_proven = 0U;
        if (!is_barred) {
            self->sealed.is_proven = 1U;
        }
        return false;
    }
    self->sealed.held_cycles += self->sealed.is_proven;
    if ((self->sealed.held_cycles * LIMIT_CYCLE_US) < LIMIT_CONFIRM_HOLD_US) {
        return false;
    }
    self->sealed.held_cycles = 0U;
    self->sealed.is_proven = 0U;
    return true;
}
