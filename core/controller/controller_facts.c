/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/controller_facts.h"

static bool is_hardware_ready(const controller_t *self, const controller_inputs_t *inputs)
{
    bool is_ready = (inputs->estop_open == 0U) && (inputs->pedal_a == inputs->pedal_b);
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        is_ready = is_ready && link_is_healthy_now(controller_link(self, i));
    }
    return is_ready;
}

static bool is_of(uint32_t axes, uint32_t index)
{
    return ((axes >> index) & 1U) != 0U;
}

/* What START_UP clears must be clear before a motion is armed that needs these axes; every card is
 * needed. */
static bool is_able(const controller_t *self, uint32_t axes)
{
    bool is_every_part_able = (self->estop.state == ESTOP_LATCH_STATE_CLEAR) &&
                              (self->loop.chart.state != LOOP_GUARD_STATE_STOPPED) &&
                              (self->pedal.chart.state != PEDAL_GATE_STATE_FAULT);
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        is_every_part_able = is_every_part_able && link_is_usable(controller_link(self, i)) &&
                             (!is_of(axes, i) || axis_is_enabled(&self->axes[i]));
    }
    return is_every_part_able;
}

static bool is_confirmation_due(const controller_t *self, const robot_t *robot)
{
    bool is_any_due = false;
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        is_any_due = is_any_due || axis_needs_confirmation(&self->axes[i], &robot->axes[i]);
    }
    return is_any_due;
}

bool controller_is_homed(const controller_t *self)
{
    for (uint32_t i = 0U; i < self->axis_count; i++) {
        if (!axis_is_homed(&self->axes[i])) {
            return false;
        }
    }
    return true;
}

workphase_inputs_t controller_guards(const controller_t *self, const cycle_t *cycle,
                                     mode_kind_t kind, uint32_t axes)
{
    const workphase_inputs_t guards = {
        .is_hardware_ready = is_hardware_ready(self, cycle->inputs),
        .is_confirmation_due = is_confirmation_due(self, cycle->robot),
        .is_motion_allowed_here = mode_runs_in(kind, procedure_workphase(&self->procedure)),
        .is_able = is_able(self, axes),
        .is_homed = mode_may_be_unhomed(kind) || controller_is_homed(self),
        .is_registered = (self->plan.is_registered != 0U),
        .has_target = (self->plan.has_target != 0U),
    };
    return guards;
}
