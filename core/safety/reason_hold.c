/* SPDX-License-Identifier: Apache-2.0 */
#include "safety/reason_hold.h"

#include "limits/requirement_limits.h"

static void watch(reason_hold_t *self, uint32_t index, uint32_t reasons, uint32_t elapsed_us)
{
    const uint32_t bit = (uint32_t)1U << (PERMIT_REASON_FIRST_OF_PLACE + index);
    const uint32_t left_us = self->left_us[index];
    if ((reasons & bit) != 0U) {
        if ((left_us > 0U) && (left_us < LIMIT_REASON_HOLD_US)) {
            self->flickering |= bit;
        }
        self->left_us[index] = LIMIT_REASON_HOLD_US;
    } else if (left_us > elapsed_us) {
        self->left_us[index] = left_us - elapsed_us;
    } else {
        self->left_us[index] = 0U;
        self->flickering &= ~bit;
    }
}

void reason_hold_watch(reason_hold_t *self, uint32_t reasons, uint32_t elapsed_us)
{
    for (uint32_t i = 0U; i < REASON_HOLD_COUNT; i++) {
        watch(self, i, reasons, elapsed_us);
    }
}
