/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/controller_facts.h"

#include "safety/needle.h"

bool controller_is_homed(const controller_t *self)
{
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
        if (!axis_is_homed(&self->axes[i])) {
            return false;
        }
    }
    return true;
}

bool controller_is_at_rest(const controller_t *self)
{
    bool is_every_one =
        !procedure_is_armed(&self->procedure) && (self->pedal.sealed.is_released != 0U);
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
        is_every_one = is_every_one && encoder_is_at_rest(&self->axes[i].sealed.encoder);
    }
    return is_every_one;
}

static uint32_t fact(bool stands, uint32_t name)
{
    return stands ? name : 0U;
}

/* A live link is healthy, and need not be asked (card_link.scxml). */
static uint32_t facts_against_card(const link_t *link)
{
    uint32_t against = 0U;
    if (link->chart.state != CARD_LINK_STATE_LIVE) {
        against = fact(!link_is_healthy_now(link), GUARD_HARDWARE_READY) |
                  fact(!link_is_usable(link), GUARD_LINKED);
    }
    return against;
}

/* The faults that START_UP clears must be clear before a motion is armed. */
static bool is_clear(const controller_t *self)
{
    return (self->estop.state == ESTOP_LATCH_STATE_CLEAR) &&
           (self->loop.chart.state != LOOP_GUARD_STATE_STOPPED) &&
           (self->pedal.chart.state != PEDAL_GATE_STATE_FAULT);
}

static bool is_box_ready(const controller_inputs_t *inputs)
{
    return (inputs->estop_open == 0U) && (inputs->pedal_a == inputs->pedal_b);
}

/* A robot that is there is looked at only where a recording is missing. */
bool controller_lacks_box(const controller_t *self, const cycle_t *cycle)
{
    return (cycle->inputs->lacks_black_box != 0U) && (self->sealed.is_box_settled == 0U) &&
           (self->sealed.awaited == 0U) && !controller_is_table_invalid(self) &&
           !needle_may_be_in(cycle->robot, self->axes);
}

uint32_t controller_bars(const controller_t *self, const cycle_t *cycle)
{
    return fact(controller_is_table_invalid(self), GUARD_BLIND) |
           fact(cycle->inputs->unfit != 0U, GUARD_UNFIT) |
           fact(controller_lacks_box(self, cycle), GUARD_NO_BOX) |
           fact(controller_is_spent(self), GUARD_SPENT);
}

uint32_t controller_facts(const controller_t *self, const cycle_t *cycle)
{
    uint32_t facts = controller_bars(self, cycle) | GUARD_HOMED | GUARD_LINKED |
                     fact(is_box_ready(cycle->inputs), GUARD_HARDWARE_READY) |
                     fact(is_clear(self), GUARD_CLEAR) |
                     fact(self->pedal.sealed.is_released != 0U, GUARD_PEDAL_RELEASED) |
                     fact(self->plan.is_registered != 0U, GUARD_REGISTERED) |
                     fact(self->plan.has_target != 0U, GUARD_TARGET);
    const uint32_t count = self->sealed.axis_count;
    for (uint32_t i = 0U; i < count; i++) {
        const axis_t *const axis = &self->axes[i];
        facts &= ~facts_against_card(controller_link(self, i));
        facts |= fact(!axis_is_enabled(axis), (uint32_t)1U << i);
        if (!axis_is_homed(axis)) {
            facts &= ~GUARD_HOMED;
            facts |=
                fact(axis_needs_confirmation(axis, &cycle->robot->axes[i]), GUARD_CONFIRMATION_DUE);
        }
    }
    return facts;
}

workphase_inputs_t controller_guards(const controller_t *self, const cycle_t *cycle,
                                     mode_kind_t kind, uint32_t axes)
{
    return guards_inputs(controller_facts(self, cycle), kind, axes,
                         procedure_workphase(&self->procedure));
}
