/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/cycle/controller_observe.h"

#include "controller/orders/controller_authority.h"
#include "controller/controller_cards.h"
#include "controller/controller_facts.h"
#include "controller/controller_order.h"
#include "controller/memory/controller_restore.h"
#include "controller/show/controller_ready.h"

#include "base/fixed.h"
#include "safety/permit.h"

#include <stddef.h>

/* Value that an event of the supervision states of its axis, besides its name. */
static int32_t supervised_detail(const axis_t *axis, event_id_t id)
{
    int32_t value = 0;
    switch ((uint32_t)id) {
    case (uint32_t)EVENT_AXIS_STALLED:
        value = axis->sealed.encoder.position_ticks;
        break;
    case (uint32_t)EVENT_AXIS_FOLLOWING_ERROR:
        value = fixed_saturate((int64_t)axis->sealed.setpoint_ticks -
                               (int64_t)axis->sealed.encoder.position_ticks);
        break;
    case (uint32_t)EVENT_AXIS_WRONG_WAY:
        value = axis->supervision.sealed.backwards_ticks;
        break;
    case (uint32_t)EVENT_AXIS_MOVED_OFF:
        value = axis->supervision.sealed.off_ticks;
        break;
    case (uint32_t)EVENT_AXIS_NO_COUNTS:
        value = axis->supervision.sealed.missing_ticks;
        break;
    case (uint32_t)EVENT_AXIS_WRONG_SPEED:
        value = axis->supervision.sealed.account.percent;
        break;
    default:
        value = 0;
        break;
    }
    return value;
}

/* The same of any event. */
static int32_t detail(const axis_t *axis, event_id_t id)
{
    int32_t value = 0;
    switch ((uint32_t)id) {
    case (uint32_t)EVENT_AXIS_HOMED:
        value = axis->sealed.home_correction_ticks;
        break;
    case (uint32_t)EVENT_AXIS_ENCODER_FAULT:
        value = axis->sealed.encoder.jump_ticks;
        break;
    case (uint32_t)EVENT_AXIS_SWITCH_FAULT:
        value = fixed_saturate((int64_t)axis->sealed.encoder.position_ticks -
                               (int64_t)axis->sealed.homing.start_ticks);
        break;
    case (uint32_t)EVENT_AXIS_SWITCH_ELSEWHERE:
        value = axis->sealed.contradiction_ticks;
        break;
    case (uint32_t)EVENT_AXIS_DRIFTED:
        value = axis->sealed.drift.idle_ticks;
        break;
    default:
        value = supervised_detail(axis, id);
        break;
    }
    return value;
}

typedef struct {
    uint32_t note;
    event_id_t event;
} axis_note_t;

static const axis_note_t axis_notes[] = {
    {AXIS_NOTE_HOMED, EVENT_AXIS_HOMED},
    {AXIS_NOTE_ENCODER_FAULT, EVENT_AXIS_ENCODER_FAULT},
    {AXIS_NOTE_STALLED, EVENT_AXIS_STALLED},
    {AXIS_NOTE_FOLLOWING_ERROR, EVENT_AXIS_FOLLOWING_ERROR},
    {AXIS_NOTE_HOME_TIMEOUT, EVENT_AXIS_HOME_TIMEOUT},
    {AXIS_NOTE_SWITCH_FAULT, EVENT_AXIS_SWITCH_FAULT},
    {AXIS_NOTE_WRONG_WAY, EVENT_AXIS_WRONG_WAY},
    {AXIS_NOTE_MOVED_OFF, EVENT_AXIS_MOVED_OFF},
    {AXIS_NOTE_NO_COUNTS, EVENT_AXIS_NO_COUNTS},
    {AXIS_NOTE_WRONG_SPEED, EVENT_AXIS_WRONG_SPEED},
    {AXIS_NOTE_DRIFTED, EVENT_AXIS_DRIFTED},
    {AXIS_NOTE_SWITCH_ELSEWHERE, EVENT_AXIS_SWITCH_ELSEWHERE},
    {AXIS_NOTE_UNEVEN_COUNTS, EVENT_AXIS_UNEVEN_COUNTS},
};

/* A position that is in doubt by a small drift alone leaves the target where it was. */
static bool leaves_target(const controller_t *self, const cycle_t *cycle, uint32_t index,
                          uint32_t notes)
{
    return ((notes & ~AXIS_NOTE_HOMED) == AXIS_NOTE_DRIFTED) &&
           !drift_audit_is_far(&self->axes[index].sealed.drift, &cycle->robot->axes[index]);
}

/* Trouble that begins ends every order; an axis that has it already, those that need this axis. */
static void note_axis(controller_t *self, const cycle_t *cycle, uint32_t index, uint32_t notes)
{
    const uint32_t count = (uint32_t)(sizeof(axis_notes) / sizeof(axis_notes[0]));
    for (uint32_t i = 0U; (notes != 0U) && (i < count); i++) {
        const event_id_t event = axis_notes[i].event;
        if ((notes & axis_notes[i].note) != 0U) {
            controller_note(self, cycle, event, index, detail(&self->axes[index], event));
        }
    }
    const bool is_trouble = (notes & ~AXIS_NOTE_HOMED) != 0U;
    if (is_trouble && !leaves_target(self, cycle, index, notes)) {
        plan_forget_target(&self->plan);
    }
    if (axis_is_faulty(&self->axes[index]) && (is_trouble || mode_needs(&self->mode, index))) {
        controller_fail_order(self, cycle, EVENT_CAUSE_AXIS, index);
    }
}

/* Reports a change of the trust in a position, whatever the cause; a fault reports it itself. */
static void note_grade(controller_t *self, const cycle_t *cycle, uint32_t index, uint32_t notes)
{
    const axis_t *const axis = &self->axes[index];
    const uint32_t before = self->records[index].sealed.grade;
    const uint32_t now = (uint32_t)axis->chart.reference;
    const bool was_known = (before == (uint32_t)AXIS_REFERENCE_UNVERIFIED) ||
                           (before == (uint32_t)AXIS_REFERENCE_TAKEN) ||
                           (before == (uint32_t)AXIS_REFERENCE_VERIFIED);
    self->records[index].sealed.grade = now;
    if (now == before) {
        return;
    }
    const bool is_in_doubt = now == (uint32_t)AXIS_REFERENCE_UNVERIFIED;
    if ((is_in_doubt && !leaves_target(self, cycle, index, notes)) ||
        (now == (uint32_t)AXIS_REFERENCE_LOST)) {
        plan_forget_target(&self->plan);
    }
    if (is_in_doubt) {
        controller_note(self, cycle, EVENT_AXIS_UNVERIFIED, index,
                        axis->sealed.encoder.position_ticks);
        const cycle_t because = controller_with_cause(cycle, EVENT_CAUSE_AXIS, index);
        controller_notify_order(self, &because, ARMING_EVENT_FAULT, STATUS_NOT_HOMED);
    }
    if ((now == (uint32_t)AXIS_REFERENCE_LOST) && was_known && !axis_is_faulty(axis)) {
        controller_note(self, cycle, EVENT_AXIS_REFERENCE_LOST, index,
                        axis->sealed.encoder.position_ticks);
    }
}

/* A card applies a drive no longer than its watchdog lets it. */
static axis_sample_t sample_of(const link_t *link)
{
    const bool is_whole = link->reported_us < LIMIT_CARD_WATCHDOG_US;
    const axis_sample_t sample = {.applied = link_applied(link),
                                  .elapsed_us =
                                      is_whole ? link->reported_us : LIMIT_CARD_WATCHDOG_US,
                                  .is_timed = is_whole && (link->is_timed != 0U)};
    return sample;
}

static void observe_axis(controller_t *self, const cycle_t *cycle, uint32_t index)
{
    const axis_config_t *const config = &cycle->robot->axes[index];
    const link_t *const link = controller_link(self, index);
    const card_report_t *const report = (link->is_fresh != 0U) ? &link->report : NULL;
    if (axis_check(&self->axes[index])) {
        controller_note(self, cycle, EVENT_CHART_REPAIRED, (uint32_t)EVENT_CHART_AXIS,
                        (int32_t)index);
        plan_forget_target(&self->plan);
    }
    uint32_t notes = axis_observe(&self->axes[index], config, report, cycle->inputs->elapsed_us);
    if (self->sealed.awaited != 0U) {
        controller_compare(self, cycle, index);
    }
    const axis_sample_t sample = sample_of(link);
    notes |= axis_supervise(&self->axes[index], config,
                            self->records[index].sealed.speed_cap_percent != 0U, &sample);
    note_axis(self, cycle, index, notes);
    note_grade(self, cycle, index, notes);
}

/* A drift that has become too large for the target, in doubt or not: small ones that were confirmed
 * add up, and a bound may be nearer than what raises a doubt. */
static void watch_drift(controller_t *self, const cycle_t *cycle, uint32_t index)
{
    axis_t *const axis = &self->axes[index];
    const bool is_in_doubt = axis->chart.reference == AXIS_REFERENCE_UNVERIFIED;
    const bool is_asked = axis_is_homed(axis) || (is_in_doubt && (self->plan.has_target != 0U));
    if (is_asked && drift_audit_is_far(&axis->sealed.drift, &cycle->robot->axes[index])) {
        controller_note(self, cycle, EVENT_AXIS_DRIFTED, index, axis->sealed.drift.idle_ticks);
        plan_forget_target(&self->plan);
        axis_doubt(axis);
    }
}

/* A warm motor is driven as another one; a hot one is not driven. The position of its axis does not
 * depend on that. */
static void watch_heat(controller_t *self, const cycle_t *cycle, uint32_t index)
{
    const link_t *const link = controller_link(self, index);
    if (!link_is_usable(link)) {
        return;
    }
    const axis_config_t *const config = &cycle->robot->axes[index];
    const int32_t heat_dc = link->report.motor_temperature_dc;
    axis_warm(&self->axes[index], config, heat_dc);
    if ((heat_dc > config->hottest_dc) && axis_is_enabled(&self->axes[index])) {
        axis_disable(&self->axes[index]);
        controller_note(self, cycle, EVENT_AXIS_HOT, index, heat_dc);
        controller_fail_order(self, cycle, EVENT_CAUSE_AXIS, index);
    }
}

/* One axis a cycle, in turn: what gets hot or drifts takes its time. */
static void watch_axis(controller_t *self, const cycle_t *cycle)
{
    const uint32_t index = self->sealed.cycle % ROBOT_AXIS_MAX;
    if ((index < self->sealed.axis_count) && !controller_is_table_invalid(self)) {
        watch_drift(self, cycle, index);
        watch_heat(self, cycle, index);
    }
}

static inline bool is_read(const cycle_t *cycle, box_input_t input)
{
    return (cycle->inputs->unread & permit_input(input)) == 0U;
}

static void notify_estop(controller_t *self, const cycle_t *cycle)
{
    self->is_estop_reported = 1U;
    controller_note(self, cycle, EVENT_ESTOP_PULLED, 0U, 0);
}

/* Other inputs are unread than in the cycle before. An e-stop that was pulled meanwhile is reported
 * now: its latch has not changed. */
static void note_unread(controller_t *self, const cycle_t *cycle)
{
    const uint32_t unread = cycle->inputs->unread;
    const bool was_estop_read = (self->unread & permit_input(BOX_INPUT_ESTOP)) == 0U;
    if (self->unread == 0U) {
        controller_note(self, cycle, EVENT_INPUTS_UNREAD, 0U, 0);
    } else if (unread == 0U) {
        controller_note(self, cycle, EVENT_INPUTS_READ, 0U, 0);
    } else {
        /* More of them, or fewer. */
    }
    self->unread = unread;
    if (!was_estop_read && is_read(cycle, BOX_INPUT_ESTOP) && (cycle->inputs->estop_open != 0U) &&
        (self->is_estop_reported == 0U)) {
        notify_estop(self, cycle);
    }
}

/** @satisfies SWR-EVENT-030 */
static void observe_unread(controller_t *self, const cycle_t *cycle)
{
    if (cycle->inputs->unread != self->unread) {
        note_unread(self, cycle);
    }
}

/* The gate has opened or closed. Arming and scans close it over a pedal that is held. */
static void note_gate(controller_t *self, const cycle_t *cycle)
{
    const bool is_held = (cycle->inputs->pedal_a != 0U) && (cycle->inputs->pedal_b != 0U);
    event_cause_t cause = EVENT_CAUSE_PEDAL;
    if (!is_read(cycle, BOX_INPUT_PEDAL)) {
        cause = EVENT_CAUSE_INPUTS;
    } else if ((self->sealed.was_gate_open == 0U) && is_held) {
        cause = (self->sealed.was_scanner_active != 0U) ? EVENT_CAUSE_SCANNER : EVENT_CAUSE_NONE;
    } else {
        /* The pedal itself. */
    }
    const cycle_t because = controller_with_cause(cycle, cause, 0U);
    controller_note(self, &because,
                    (self->sealed.was_gate_open != 0U) ? EVENT_PEDAL_PRESSED : EVENT_PEDAL_RELEASED,
                    0U, 0);
}

/** @satisfies SWR-PERMIT-041 */
static void observe_pedal(controller_t *self, const cycle_t *cycle)
{
    const bool was_faulty = self->pedal.chart.state == PEDAL_GATE_STATE_FAULT;
    if (pedal_gate_check(&self->pedal)) {
        controller_note(self, cycle, EVENT_CHART_REPAIRED, (uint32_t)EVENT_CHART_PEDAL_GATE, 0);
    }
    pedal_gate_step(&self->pedal, cycle->inputs->pedal_a != 0U, cycle->inputs->pedal_b != 0U,
                    cycle->inputs->elapsed_us);
    if (!is_read(cycle, BOX_INPUT_PEDAL)) {
        pedal_gate_renew(&self->pedal); /* It was not seen released. */
    }
    const uint32_t is_open = pedal_gate_is_open(&self->pedal) ? 1U : 0U;
    if (is_open != self->sealed.was_gate_open) {
        self->sealed.was_gate_open = is_open;
        note_gate(self, cycle);
    }
    if ((self->pedal.chart.state == PEDAL_GATE_STATE_FAULT) && !was_faulty) {
        controller_note(self, cycle, EVENT_PEDAL_FAULT, 0U, 0);
        controller_fail_order(self, cycle, EVENT_CAUSE_PEDAL, 0U);
    }
}

/* Notes the release of a switch that was pulled; an unread one was only taken for pulled. */
static void note_release(controller_t *self, const cycle_t *cycle)
{
    if (self->is_estop_reported != 0U) {
        self->is_estop_reported = 0U;
        controller_note(self, cycle, EVENT_ESTOP_RELEASED, 0U, 0);
    }
}

static void observe_estop(controller_t *self, const cycle_t *cycle)
{
    const estop_latch_state_t before = self->estop.state;
    if (estop_latch_check(&self->estop)) {
        controller_note(self, cycle, EVENT_CHART_REPAIRED, (uint32_t)EVENT_CHART_ESTOP, 0);
    }
    estop_latch_step(&self->estop, cycle->inputs->estop_open != 0U, cycle->inputs->elapsed_us);
    if (self->estop.state == before) {
        return;
    }
    if (self->estop.state != ESTOP_LATCH_STATE_PULLED) {
        note_release(self, cycle);
        return;
    }
    const bool is_pulled = is_read(cycle, BOX_INPUT_ESTOP);
    if (is_pulled) {
        notify_estop(self, cycle);
    }
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
        axis_disable(&self->axes[i]);
    }
    const cycle_t because =
        controller_with_cause(cycle, is_pulled ? EVENT_CAUSE_ESTOP : EVENT_CAUSE_INPUTS, 0U);
    controller_enter_emergency(self, &because);
}

/** @satisfies SWR-LOOP-011 */
static void observe_loop(controller_t *self, const cycle_t *cycle)
{
    const uint32_t overruns = self->loop.sealed.overruns;
    const loop_guard_state_t before = self->loop.chart.state;
    if (loop_guard_check(&self->loop)) {
        controller_note(self, cycle, EVENT_CHART_REPAIRED, (uint32_t)EVENT_CHART_LOOP_GUARD, 0);
    }
    loop_guard_step(&self->loop, cycle->inputs->elapsed_us, cycle->inputs->late_stage);
    if (self->loop.sealed.overruns != overruns) {
        controller_note(self, cycle, EVENT_OVERRUN, cycle->inputs->late_stage,
                        (int32_t)cycle->inputs->elapsed_us);
    }
    if ((self->loop.chart.state == LOOP_GUARD_STATE_STOPPED) &&
        (self->loop.chart.state != before)) {
        controller_note(self, cycle, EVENT_LOOP_STOPPED, self->loop.sealed.lateness.longest_stage,
                        (int32_t)self->loop.sealed.lateness.longest_us);
        controller_fail_order(self, cycle, EVENT_CAUSE_LOOP, 0U);
    }
}

/* A scan begins or has ended. */
static void audit_scan(controller_t *self, const cycle_t *cycle)
{
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
        drift_audit_t *const drift = &self->axes[i].sealed.drift;
        if (self->sealed.was_scanner_active != 0U) {
            drift_audit_begin_scan(drift);
        } else {
            controller_note(self, cycle, EVENT_SCAN_DRIFT, i, drift->scan_ticks);
        }
    }
}

/* After a scan the pedal must be released and pressed anew: the operator, not the scanner, restarts
 * a motion. */
static void observe_scanner(controller_t *self, const cycle_t *cycle)
{
    if (cycle->inputs->scanner_active != 0U) {
        pedal_gate_renew(&self->pedal);
    }
    if ((cycle->inputs->scanner_active != self->sealed.was_scanner_active) &&
        is_read(cycle, BOX_INPUT_SCANNER)) {
        self->sealed.was_scanner_active = cycle->inputs->scanner_active;
        controller_note(self, cycle, EVENT_SCANNER, 0U, (int32_t)self->sealed.was_scanner_active);
        if (!controller_is_table_invalid(self)) {
            audit_scan(self, cycle);
        }
    }
}

static bool is_confirmation_barred(const controller_t *self, const cycle_t *cycle)
{
    bool is_barred = procedure_is_armed(&self->procedure) || (cycle->inputs->estop_open != 0U) ||
                     controller_is_table_invalid(self);
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
        is_barred = is_barred || axis_is_moving_in_doubt(&self->axes[i]);
    }
    return is_barred;
}

/* The operator confirms the positions that are shown; that of a silent card is old. */
static void confirm(controller_t *self, const cycle_t *cycle)
{
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
        axis_t *const axis = &self->axes[i];
        if (controller_confirms_axis(self, i) && link_is_healthy_now(controller_link(self, i)) &&
            axis_confirm(axis, &cycle->robot->axes[i])) {
            controller_renew_account(self);
            controller_note(self, cycle, EVENT_AXIS_CONFIRMED, i,
                            axis->sealed.encoder.position_ticks);
        }
    }
}

/* Service is due and nothing comes before it, nor has anyone asked for another thing. */
static bool is_for_service(const controller_t *self, const cycle_t *cycle)
{
    return (self->authority.sealed.request == (uint32_t)AUTHORITY_REQUEST_NONE) &&
           (controller_ready(self, cycle).step == NEXT_STEP_SERVICE);
}

/** @satisfies SWR-AXIS-080 */
static void observe_button(controller_t *self, const cycle_t *cycle)
{
    const bool is_for_authority = controller_awaits_grant(self);
    const bool is_barred = is_for_authority ? (self->pedal.sealed.is_released == 0U)
                                            : is_confirmation_barred(self, cycle);
    if (!confirm_button_step(&self->confirm, cycle->inputs->confirm_pressed != 0U, is_barred)) {
        return;
    }
    if (is_for_authority) {
        controller_grant(self, cycle);
    } else if (is_for_service(self, cycle)) {
        controller_be_mended(self, cycle);
    } else {
        confirm(self, cycle);
        controller_end_request(self);
    }
}

static void observe_procedure(controller_t *self, const cycle_t *cycle)
{
    const uint32_t repaired = procedure_check(&self->procedure);
    if ((repaired & PROCEDURE_WORKPHASE_REPAIRED) != 0U) {
        controller_note(self, cycle, EVENT_CHART_REPAIRED, (uint32_t)EVENT_CHART_WORKPHASES, 0);
    }
    if ((repaired & PROCEDURE_ARMING_REPAIRED) != 0U) {
        controller_note(self, cycle, EVENT_CHART_REPAIRED, (uint32_t)EVENT_CHART_ARMING, 0);
    }
    if (repaired != 0U) {
        controller_abandon_order(self, cycle);
    }
    const uint32_t actions = procedure_step(&self->procedure, cycle->inputs->elapsed_us);
    controller_report_order(self, cycle, actions, STATUS_OK);
}

/* The first cycle that is recorded again reports the gap, so that it is in the recording. */
static void note_gap(controller_t *self, const cycle_t *cycle, uint32_t lost)
{
    if (lost == 0U) {
        controller_note(self, cycle, EVENT_RECORDING_RESUMED, 0U, (int32_t)self->unrecorded);
        self->unrecorded = 0U;
    } else {
        if (self->unrecorded == 0U) {
            controller_note(self, cycle, EVENT_RECORDING_STOPPED, 0U,
                            (int32_t)cycle->inputs->is_recorder_failing);
        }
        self->unrecorded += lost;
        self->cycles_lost += lost;
    }
}

/*
 * Reported anew only once there has been twice the room.
 *
 * @satisfies SWR-REC-036
 */
static void note_room(controller_t *self, const cycle_t *cycle, uint32_t left_min)
{
    const bool is_soon = (left_min != 0U) && (left_min < LIMIT_RECORDING_LEFT_MIN);
    const bool is_far = (left_min == 0U) || (left_min >= (2U * LIMIT_RECORDING_LEFT_MIN));
    if (is_soon && (self->is_end_reported == 0U)) {
        controller_note(self, cycle, EVENT_RECORDING_ENDS_SOON, 0U, (int32_t)left_min);
        self->is_end_reported = 1U;
    }
    if (is_far) {
        self->is_end_reported = 0U;
    }
    self->recording_left_min = left_min;
}

/** @satisfies SWR-REC-021 */
static void observe_recording(controller_t *self, const cycle_t *cycle)
{
    const uint32_t lost = cycle->inputs->cycles_lost - self->cycles_lost;
    if ((lost != 0U) || (self->unrecorded != 0U)) {
        note_gap(self, cycle, lost);
    }
    if (cycle->inputs->recording_left_min != self->recording_left_min) {
        note_room(self, cycle, cycle->inputs->recording_left_min);
    }
}

void controller_observe(controller_t *self, const cycle_t *cycle)
{
    observe_procedure(self, cycle);
    observe_loop(self, cycle);
    observe_unread(self, cycle);
    observe_pedal(self, cycle);
    observe_estop(self, cycle);
    observe_scanner(self, cycle);
    observe_recording(self, cycle);
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
        controller_observe_card(self, cycle, i);
        if (!controller_is_table_invalid(self)) {
            observe_axis(self, cycle, i);
        }
    }
    watch_axis(self, cycle);
    controller_observe_other_cards(self, cycle);
    controller_watch_card(self, cycle);
    controller_observe_authority(self, cycle);
    observe_button(self, cycle);
}
