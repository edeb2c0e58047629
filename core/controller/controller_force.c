/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/controller_force.h"

#include "controller/controller_facts.h"

#include "robot/robot_damage.h"
#include "safety/needle.h"

static bool is_calm(const controller_t *self, const cycle_t *cycle)
{
    return controller_is_at_rest(self) && needle_is_out(cycle->robot, self->axes);
}

/* By its set-point: a slow drive is a row of bursts, off in between. */
static bool is_driven_in(const controller_t *self, const cycle_t *cycle)
{
    const uint32_t needle = cycle->robot->needle_axis;
    return procedure_is_moving(&self->procedure) &&
           (self->axes[needle].sealed.setpoint_speed_ticks_per_s_q8 > 0);
}

static void watch_pair(controller_t *self, const cycle_t *cycle)
{
    if (force_sensor_is_loaded(&self->force)) {
        const bool is_free =
            !procedure_is_moving(&self->procedure) && needle_is_out(cycle->robot, self->axes);
        force_sensor_judge_pair(&self->force, is_free, is_driven_in(self, cycle));
    } else {
        self->force.sealed.pair_cycles = 0U;
    }
}

static void note_doubts(controller_t *self, const cycle_t *cycle, uint32_t channel, uint32_t before)
{
    const uint32_t now = self->force.sealed.channels[channel].doubts;
    for (uint32_t i = 0U; i < (uint32_t)FORCE_DOUBT_COUNT; i++) {
        if (((now & ~before) & ((uint32_t)1U << i)) != 0U) {
            controller_note(self, cycle, EVENT_FORCE_DOUBTED, channel, (int32_t)i);
        }
    }
    if (now == 0U) {
        controller_note(self, cycle, EVENT_FORCE_BELIEVED, channel,
                        (int32_t)force_channel_noise_mn(&self->force.sealed.channels[channel],
                                                        &cycle->robot->force.channels[channel]));
    }
}

static void note_zeroed(controller_t *self, const cycle_t *cycle, const force_zeroed_t *zeroed)
{
    for (uint32_t i = 0U; i < ROBOT_FORCE_CHANNELS; i++) {
        if ((zeroed->ended & ((uint32_t)1U << i)) == 0U) {
            continue;
        }
        if (zeroed->ends[i] == FORCE_ZERO_END_DONE) {
            controller_note(self, cycle, EVENT_FORCE_ZEROED, i, zeroed->moved_mn[i]);
        } else {
            controller_note(self, cycle, EVENT_FORCE_NOT_ZEROED, i, (int32_t)zeroed->ends[i]);
        }
    }
}

/* The table of the sensor has its turn as the slots have. */
static bool is_table_damaged(const controller_t *self, const robot_t *robot)
{
    return ((self->sealed.cycle % CARD_SLOT_COUNT) == 0U) && robot_is_force_damaged(robot);
}

static bool is_heard(const link_t *link)
{
    return (link->is_fresh != 0U) && link_is_usable(link);
}

static void step_sensor(controller_t *self, const cycle_t *cycle, const link_t *link)
{
    const force_config_t *const config = &cycle->robot->force;
    if (is_heard(link)) {
        force_sensor_step(&self->force, config, link->report.adc_words,
                          procedure_is_moving(&self->procedure));
    } else if (!link_is_usable(link) || (link->sealed.age_cycles >= LIMIT_FORCE_STALE_CYCLES)) {
        force_sensor_miss(&self->force, !link_is_usable(link));
    } else {
        /* A report is missing, and what was read last still counts. */
    }
    if (force_sensor_is_zeroing(&self->force)) {
        const force_zeroed_t zeroed =
            force_sensor_zero(&self->force, config, is_heard(link), is_calm(self, cycle));
        note_zeroed(self, cycle, &zeroed);
    }
    watch_pair(self, cycle);
    /* Only where it can be taken anew: no insertion ends for its age. */
    if (force_sensor_is_old(&self->force) && is_calm(self, cycle)) {
        force_sensor_grow_old(&self->force);
    }
}

void controller_observe_force(controller_t *self, const cycle_t *cycle, uint32_t slot)
{
    uint32_t before[ROBOT_FORCE_CHANNELS];
    const force_config_t *const config = &cycle->robot->force;
    const bool is_damaged = (config->is_there != 0U) && is_table_damaged(self, cycle->robot);
    if ((config->is_there == 0U) || (!is_damaged && (config->slot != slot))) {
        return;
    }
    for (uint32_t i = 0U; i < ROBOT_FORCE_CHANNELS; i++) {
        before[i] = self->force.sealed.channels[i].doubts;
    }
    if (is_damaged) {
        force_sensor_distrust(&self->force);
    } else {
        step_sensor(self, cycle, &self->links[slot]);
    }
    for (uint32_t i = 0U; i < ROBOT_FORCE_CHANNELS; i++) {
        if (self->force.sealed.channels[i].doubts != before[i]) {
            note_doubts(self, cycle, i, before[i]);
        }
    }
}

status_t controller_obey_force(controller_t *self, const cycle_t *cycle, const command_t *command,
                               answer_t *answer)
{
    (void)answer;
    const force_config_t *const config = &cycle->robot->force;
    status_t status = STATUS_OK;
    if (!controller_is_of_workphase(self, command)) {
        status = STATUS_WRONG_WORKPHASE;
    } else if (config->is_there == 0U) {
        status = STATUS_NO_FORCE_SENSOR;
    } else if (!controller_is_at_rest(self)) {
        status = STATUS_NOT_AT_REST;
    } else if (!needle_is_out(cycle->robot, self->axes)) {
        status = STATUS_NEEDLE_IN;
    } else if (robot_is_force_damaged(cycle->robot)) {
        status = STATUS_MEMORY_DAMAGED;
    } else if (!link_is_healthy_now(&self->links[config->slot])) {
        status = STATUS_HARDWARE_NOT_READY;
    } else {
        force_sensor_begin_zero(&self->force);
        status = STATUS_OK;
    }
    return status;
}

uint32_t controller_hand_reasons(const controller_t *self, const cycle_t *cycle, mode_kind_t kind)
{
    uint32_t reasons = 0U;
    if (mode_is_by_hand(kind) && !procedure_is_armed(&self->procedure)) {
        reasons =
            permit_reason(!controller_hand(self, cycle).is_trusted, PERMIT_REASON_FORCE_DOUBTFUL);
    } else if (mode_is_by_hand(kind)) {
        const uint32_t needle =
            cycle->robot->needle_axis % ROBOT_AXIS_MAX; /* A damaged table may name none. */
        const hand_t hand = controller_hand(self, cycle);
        const int64_t left_ticks = (int64_t)self->mode.request.sealed.move.target_ticks[needle] -
                                   (int64_t)self->axes[needle].sealed.encoder.position_ticks;
        reasons = hand_guard_reasons(&self->sealed.hand_guard, &hand, left_ticks);
    } else {
        /* No hand moves the needle. */
    }
    return reasons;
}
