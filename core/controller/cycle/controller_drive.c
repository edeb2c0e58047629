/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/cycle/controller_drive.h"

#include "controller/cycle/controller_dialect.h"
#include "controller/controller_facts.h"
#include "controller/controller_force.h"

#include "base/clear.h"
#include "card/card_dialect.h"
#include "safety/coupled_guard.h"
#include "safety/needle.h"
#include "safety/permit.h"

#include <string.h>

/* Facts that are the same for every axis. */
static permit_common_facts_t common_facts(const controller_t *self, const cycle_t *cycle,
                                          uint32_t guards, mode_kind_t kind, uint32_t of_hand)
{
    const pedal_gate_state_t pedal = self->pedal.chart.state;
    const permit_common_facts_t facts = {
        .is_estop_pulled = (self->estop.state == ESTOP_LATCH_STATE_PULLED),
        .is_estop_latched = (self->estop.state == ESTOP_LATCH_STATE_LATCHED),
        .is_loop_stopped = (self->loop.chart.state == LOOP_GUARD_STATE_STOPPED),
        .is_link_lost = !guards_have(guards, GUARD_LINKED),
        .is_pedal_faulty = (pedal == PEDAL_GATE_STATE_FAULT),
        .is_scanner_active = (cycle->inputs->scanner_active != 0U),
        .is_armed = procedure_is_armed(&self->procedure),
        .is_pedal_unproven = (pedal == PEDAL_GATE_STATE_UNPROVEN),
        .is_pedal_pressed = pedal_gate_is_open(&self->pedal),
        .is_every_axis_homed = guards_have(guards, GUARD_HOMED),
        .is_memory_damaged = controller_is_table_invalid(self),
        .are_cards_unprotected = (cycle->inputs->dialect != (uint32_t)CARD_DIALECT_OWN) &&
                                 (cycle->inputs->is_dialect_accepted == 0U),
        .may_be_unhomed = mode_may_be_unhomed(kind),
        .hand_reasons = of_hand,
    };
    return facts;
}

/* Data that the parts of this file share about all axes. */
typedef struct {
    permit_common_facts_t facts;
    permit_common_t common;
    coupled_view_t axes;
    uint32_t at_coupled_limit; /* coupled_guard_blocks(); nothing without a table. */
    uint32_t driven;           /* The axes that ask for a drive. */
    uint32_t heeding_needle;   /* mode_heeding_needle() while armed. */
    uint32_t unsteered;        /* The needle's axis, while mode_waits_for_rotation(). */
} view_t;

static uint32_t driven_axes(const controller_t *self, const card_drive_t requests[ROBOT_AXIS_MAX])
{
    uint32_t driven = 0U;
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
        const bool is_on = requests[i].mode != (uint32_t)CARD_DRIVE_OFF;
        driven |= (is_on ? (uint32_t)1U : (uint32_t)0U) << i;
    }
    return driven;
}

/* The permit of one axis for its request. */
static permit_t decide(const controller_t *self, const cycle_t *cycle, uint32_t index,
                       const view_t *view)
{
    const axis_t *const axis = &self->axes[index];
    const card_drive_t *const request = &view->axes.requests[index];
    const axis_config_t *const config = &cycle->robot->axes[index];
    const uint32_t bit = (uint32_t)1U << index;
    const bool is_on = (view->driven & bit) != 0U;
    const permit_facts_t facts = {
        .is_axis_faulty = axis_is_faulty(axis),
        .is_axis_enabled = axis_is_enabled(axis),
        .is_homed = axis_is_homed(axis),
        .is_towards_switch = is_on && axis_is_towards_switch(axis, config, request),
        .is_beyond_soft_limit = is_on && axis_is_beyond_limit(axis, config, request),
        .is_coupled_limit = (view->at_coupled_limit & bit) != 0U,
        .is_needle_in = ((view->heeding_needle & bit) != 0U) &&
                        needle_forbids_jog(cycle->robot, self->axes, index,
                                           is_on && motor_model_is_upwards(config, request)),
        .is_unsteered =
            ((view->unsteered & bit) != 0U) && is_on && motor_model_is_upwards(config, request),
    };
    return permit_decide(&view->common, &facts);
}

static uint32_t system_state(const controller_t *self, const cycle_t *cycle)
{
    uint32_t state = (uint32_t)procedure_workphase(&self->procedure) << 8U;
    state |= pedal_gate_is_open(&self->pedal) ? CARD_SYSTEM_PEDAL : 0U;
    state |= (cycle->inputs->estop_open != 0U) ? CARD_SYSTEM_ESTOP : 0U;
    state |= (cycle->inputs->scanner_active != 0U) ? CARD_SYSTEM_SCANNER : 0U;
    state |=
        (procedure_workphase(&self->procedure) == WORKPHASE_START_UP) ? CARD_SYSTEM_HOMING : 0U;
    return state;
}

/* Stepped in every cycle, with or without a drive. */
static bool is_too_fast(controller_t *self, const cycle_t *cycle, uint32_t index, bool is_homed)
{
    return speed_cap_step(&self->records[index].sealed.speed_cap, &cycle->robot->axes[index],
                          permit_cap_percent(is_homed),
                          self->axes[index].sealed.encoder.position_ticks,
                          controller_link(self, index)->reported_us);
}

static uint32_t control_of(const link_t *link, uint32_t state)
{
    const bool is_allowed = (state & CARD_SYSTEM_PERMIT) != 0U;
    return link_is_usable(link) ? (is_allowed ? CARD_CONTROL_AMPLIFIER : 0U)
                                : CARD_CONTROL_CLEAR_FAULT;
}

static inline void send(controller_t *self, const cycle_t *cycle, const card_command_t *command)
{
    card_frame_write_command(command, cycle->outputs->frames[command->slot]);
    cycle->outputs->frames_to_send |= (uint32_t)1U << command->slot;
    link_note_sent(&self->links[command->slot], self->sealed.sequence, &command->drive);
}

/* The only place where a drive enters an outgoing frame; it comes from the permit. */
static void send_to_axis(controller_t *self, const cycle_t *cycle, uint32_t index, uint32_t state,
                         const card_drive_t *drive)
{
    const axis_config_t *const config = &cycle->robot->axes[index];
    const link_t *const link = controller_link(self, index);
    card_command_t command = {
        .slot = self->cards.slots[index],
        .sequence = self->sealed.sequence,
        .time_us = self->sealed.time_us,
        .system_state = state,
        .control = control_of(link, state),
        .drive = *drive,
        .watchdog_us = LIMIT_CARD_WATCHDOG_US,
        .overspeed_ticks_per_s = (uint32_t)config->full_speed_ticks_per_s * 2U,
        .guard_minimum_ticks = 0,
        .guard_maximum_ticks = 0,
        .axis_id = index,
    };
    if (link_is_usable(link) && !controller_is_table_invalid(self)) {
        axis_guard(&self->axes[index], config, (state & CARD_SYSTEM_PERMIT) != 0U,
                   &command.guard_minimum_ticks, &command.guard_maximum_ticks);
    }
    send(self, cycle, &command);
}

/* A card without an axis: its drive stays off. */
static void send_to_sensor(controller_t *self, const cycle_t *cycle, uint32_t slot, uint32_t state)
{
    const card_command_t command = {
        .slot = slot,
        .sequence = self->sealed.sequence,
        .time_us = self->sealed.time_us,
        .system_state = state,
        .control = control_of(&self->links[slot], state),
        .watchdog_us = LIMIT_CARD_WATCHDOG_US,
        .axis_id = CARD_NO_AXIS,
    };
    send(self, cycle, &command);
}

/* While nothing is driven, one slot after the other that is empty as far as one knows. */
static uint32_t probed_slot(const controller_t *self, bool is_driven)
{
    if (is_driven || ((self->sealed.cycle % LIMIT_PROBE_CYCLES) != 0U)) {
        return 0U;
    }
    const uint32_t slot = (self->sealed.cycle / LIMIT_PROBE_CYCLES) % CARD_SLOT_COUNT;
    return (uint32_t)1U << slot;
}

/* Cards of the robot without an axis, and others that are known to be there or are looked for. */
static void send_to_others(controller_t *self, const cycle_t *cycle, uint32_t state, bool is_driven)
{
    const uint32_t others = self->sealed.unexpected_cards | probed_slot(self, is_driven);
    const uint32_t slots = self->cards.sensor_slots | (others & ~self->cards.named_slots);
    for (uint32_t i = 0U; (slots >> i) != 0U; i++) {
        if (((slots >> i) & 1U) != 0U) {
            send_to_sensor(self, cycle, i, state);
        }
    }
}

/* All in one go: an encoder writes only the words that are not zero. */
static void clear_frames(const cycle_t *cycle)
{
    controller_outputs_t *const outputs = cycle->outputs;
    clear_aligned_words(outputs->frames[0], sizeof outputs->frames);
}

/* Keeps the part of an axis' permit that is shown. */
static void remember(controller_t *self, const cycle_t *cycle, uint32_t index,
                     const permit_t *permit)
{
    axis_record_t *const record = &self->records[index];
    const uint32_t shown_before = record->sealed.reason_hold.shown;
    reason_hold_step(&record->sealed.reason_hold, permit->reasons, cycle->inputs->elapsed_us);
    if (record->sealed.reason_hold.shown != shown_before) {
        record->sealed.permit_since_cycle = self->sealed.cycle;
    }
    record->sealed.speed_cap_percent = permit->speed_cap_percent;
}

/* Drives that the cards of the axes apply now. */
static void gather_sent(const controller_t *self, card_drive_t sent[ROBOT_AXIS_MAX])
{
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
        sent[i] = controller_link(self, i)->sealed.sent;
    }
}

void controller_drive(controller_t *self, const cycle_t *cycle, uint32_t guards,
                      const card_drive_t requests[ROBOT_AXIS_MAX])
{
    card_drive_t sent[ROBOT_AXIS_MAX];
    const mode_kind_t kind = mode_in(&self->mode, procedure_workphase(&self->procedure));
    const permit_common_facts_t facts =
        common_facts(self, cycle, guards, kind, controller_hand_reasons(self, cycle, kind));
    view_t view = {.facts = facts,
                   .common = permit_decide_common(&facts, cycle->inputs->unread),
                   .axes = {.axes = self->axes, .sent = sent, .requests = requests},
                   .driven = driven_axes(self, requests)};
    const uint32_t state = system_state(self, cycle);
    uint32_t modes = 0U;
    clear_frames(cycle);
    gather_sent(self, sent);
    if (facts.is_armed) {
        view.heeding_needle = mode_heeding_needle(&self->mode, kind, cycle->robot, view.driven);
    }
    if (facts.is_armed && mode_waits_for_rotation(&self->mode, kind, cycle->robot, self->axes)) {
        view.unsteered = (uint32_t)1U << (cycle->robot->needle_axis % ROBOT_AXIS_MAX);
    }
    if (!facts.is_memory_damaged) {
        view.at_coupled_limit = coupled_guard_blocks(cycle->robot, &view.axes);
    }
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
        const permit_t permit = decide(self, cycle, i, &view);
        remember(self, cycle, i, &permit);
        card_drive_t drive = permit_apply(
            &permit, is_too_fast(self, cycle, i, view.facts.is_every_axis_homed), &requests[i]);
        modes |= drive.mode;
        motor_heat_tune(&self->axes[i].sealed.heat, &drive);
        send_to_axis(self, cycle, i, state | (permit.is_allowed ? CARD_SYSTEM_PERMIT : 0U), &drive);
    }
    send_to_others(self, cycle, state, modes != (uint32_t)CARD_DRIVE_OFF);
    controller_translate(cycle);
    self->sealed.sequence++;
}
