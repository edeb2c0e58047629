/* SPDX-License-Identifier: Apache-2.0 */
/** @file What a person does at the box with foot and hand: here, by an order, or from afar. */
#include "sim/box.h"

void box_press(box_t *self, box_held_t what, bool is_pressed)
{
    self->holds[what].holder = 0U;
    if (what == BOX_HELD_PEDAL) {
        box_contact_set(&self->pedal_a, is_pressed, is_pressed ? BOX_PEDAL_CLOSE_SPREAD_US : 0U);
        box_contact_set(&self->pedal_b, is_pressed, is_pressed ? 0U : BOX_PEDAL_OPEN_SPREAD_US);
    } else if (what == BOX_HELD_BUTTON) {
        self->button_pressed = is_pressed;
    } else if (is_pressed) {
        sim_hand_press(&self->force.hand, (double)self->force.grip_mn / 1000.0);
    } else {
        sim_hand_release(&self->force.hand);
    }
}

bool box_hold(box_t *self, box_held_t what, uint32_t who)
{
    box_hold_t *const hold = &self->holds[what];

    if ((hold->holder != 0U) && (hold->holder != who)) {
        return false;
    }
    if (hold->holder == 0U) {
        box_press(self, what, true);
        hold->holder = who;
    }
    hold->renewals++;
    return true;
}

void box_keep(box_t *self, uint32_t who)
{
    for (uint32_t i = 0U; i < BOX_HOLDS; i++) {
        if (self->holds[i].holder == who) {
            self->holds[i].renewals++;
        }
    }
}

void box_drop(box_t *self, box_held_t what, uint32_t who)
{
    if (self->holds[what].holder == who) {
        box_press(self, what, false);
    }
}
