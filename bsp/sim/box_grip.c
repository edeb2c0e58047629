/* SPDX-License-Identifier: Apache-2.0 */
#include "sim/box_grip.h"

#include "limits/requirement_limits.h"

bool box_grip_look(box_grip_t *self, box_t *box, uint64_t now_us)
{
    bool has_opened = false;

    for (uint32_t i = 0U; i < BOX_HOLDS; i++) {
        const box_hold_t *hold = &box->holds[i];
        if (hold->renewals != self->renewals[i]) {
            self->renewals[i] = hold->renewals;
            self->until_us[i] = now_us + LIMIT_BOX_GRIP_US;
        }
        if ((hold->holder != 0U) && (now_us >= self->until_us[i])) {
            box_press(box, (box_held_t)i, false);
            has_opened = true;
        }
    }
    return has_opened;
}
