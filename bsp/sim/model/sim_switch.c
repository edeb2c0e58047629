/* SPDX-License-Identifier: Apache-2.0 */
#include "sim/model/sim_switch.h"

#include "sim/model/sim_motor.h"

static bool is_pressed(const sim_switch_t *self, double position_ticks)
{
    const double slack = self->is_operated ? self->hysteresis_ticks : 0.0;
    bool pressed = false;

    switch (self->end) {
    case LIMIT_SWITCH_UPPER:
        pressed = position_ticks >= self->operate_ticks - slack;
        break;
    case LIMIT_SWITCH_LOWER:
        pressed = position_ticks <= self->operate_ticks + slack;
        break;
    case LIMIT_SWITCH_NONE:
    default:
        break;
    }
    return pressed;
}

void sim_switch_init(sim_switch_t *self, const axis_config_t *axis, double position_ticks,
                     uint32_t seed)
{
    const double unit_per_tick = (double)axis->unit_per_tick_q16 / 65536.0;
    const double hysteresis = (axis->unit == (uint8_t)AXIS_UNIT_MM)
                                  ? (double)SIM_SWITCH_HYSTERESIS_NM
                                  : (double)SIM_SWITCH_HYSTERESIS_BAM;

    *self = (sim_switch_t){.random = {seed},
                           .end = (limit_switch_t)axis->limit_switch,
                           .operate_ticks = axis->home_ticks,
                           .hysteresis_ticks = hysteresis / unit_per_tick};
    self->is_operated = is_pressed(self, position_ticks);
    self->is_closed = self->is_operated;
    self->is_active = self->is_operated;
}

static void step_contact(sim_switch_t *self, bool was_operated)
{
    const uint32_t spread_us = SIM_SWITCH_BOUNCE_MAXIMUM_US - SIM_SWITCH_BOUNCE_MINIMUM_US;

    if (self->is_operated != was_operated) {
        self->bounce_us =
            SIM_SWITCH_BOUNCE_MINIMUM_US + sim_random_below(&self->random, spread_us + 1U);
        self->is_closed = self->is_operated;
    } else if (self->bounce_us > SIM_STEP_US) {
        self->bounce_us -= SIM_STEP_US;
        /* One step in four changes the contact: open and closed times of 0.1 to about 1 ms. */
        if (sim_random_below(&self->random, 4U) == 0U) {
            self->is_closed = !self->is_closed;
        }
    } else {
        self->bounce_us = 0U;
        self->is_closed = self->is_operated;
    }
}

static void chatter(sim_switch_t *self)
{
    const uint32_t spread_us = SIM_SWITCH_CHATTER_MAXIMUM_US - SIM_SWITCH_CHATTER_MINIMUM_US;

    if (self->chatter_us > SIM_STEP_US) {
        self->chatter_us -= SIM_STEP_US;
    } else {
        self->is_active = !self->is_active;
        self->chatter_us =
            SIM_SWITCH_CHATTER_MINIMUM_US + sim_random_below(&self->random, spread_us + 1U);
    }
}

/* As the card sees a contact whose wire is not loose. */
static bool is_seen_active(const sim_switch_t *self)
{
    bool active = self->is_closed;

    switch (self->fault) {
    case SIM_SWITCH_STUCK:
        active = true;
        break;
    case SIM_SWITCH_OPEN:
        active = false;
        break;
    case SIM_SWITCH_REVERSED:
        active = !self->is_closed;
        break;
    case SIM_SWITCH_CHATTER:
    case SIM_SWITCH_NORMAL:
    default:
        break;
    }
    return active;
}

void sim_switch_step(sim_switch_t *self, double position_ticks)
{
    const bool was_operated = self->is_operated;

    self->is_operated = is_pressed(self, position_ticks);
    step_contact(self, was_operated);
    if (self->fault == SIM_SWITCH_CHATTER) {
        chatter(self);
    } else {
        self->is_active = is_seen_active(self);
    }
}

bool sim_switch_is_settled(const sim_switch_t *self, double position_ticks)
{
    return (self->fault != SIM_SWITCH_CHATTER) && (self->bounce_us == 0U) &&
           (self->is_closed == self->is_operated) && (self->is_active == is_seen_active(self)) &&
           (is_pressed(self, position_ticks) == self->is_operated);
}
