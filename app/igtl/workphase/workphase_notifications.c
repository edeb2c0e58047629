/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/workphase/workphase_notifications.h"

#include "charts/arming_chart.h"
#include "charts/axis_chart.h"
#include "charts/card_link_chart.h"
#include "charts/estop_latch_chart.h"
#include "charts/loop_guard_chart.h"
#include "charts/pedal_gate_chart.h"
#include "charts/stall_watchdog_chart.h"
#include "igtl/workphase/workphase_peer.h"
#include "interface/app/names.h"
#include "robot/robot_cards.h"
#include "procedure/command_kinds.h"

#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

static void observe(workphase_facts_t *facts, const robot_t *robot, const snapshot_t *snapshot)
{
    *facts = (workphase_facts_t){
        .workphase = snapshot->workphase,
        .estop = snapshot->estop,
        .pose_status = snapshot->pose_status,
        .is_loop_stopped = (snapshot->loop == (uint32_t)LOOP_GUARD_STATE_STOPPED) ? 1U : 0U,
        .is_pedal_faulty = (snapshot->pedal == (uint32_t)PEDAL_GATE_STATE_FAULT) ? 1U : 0U};
    for (uint32_t i = 0U; i < CARD_SLOT_COUNT; i++) {
        if ((snapshot->cards[i].link == (uint32_t)CARD_LINK_STATE_LOST) &&
            (robot_cards_type(robot, i) != (uint32_t)CARD_TYPE_NONE)) {
            facts->lost_cards |= 1U << i;
        }
    }
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        if ((snapshot->axes[i].power == (uint32_t)AXIS_POWER_FAULT) ||
            (snapshot->axes[i].stall == (uint32_t)STALL_WATCHDOG_STATE_STALLED)) {
            facts->axis_faults |= 1U << i;
        }
    }
}

/* The failures of `now` that were not there `before`. */
static void find_failures(workphase_facts_t *fresh, const workphase_facts_t *before,
                          const workphase_facts_t *now)
{
    *fresh =
        (workphase_facts_t){.lost_cards = now->lost_cards & ~before->lost_cards,
                            .axis_faults = now->axis_faults & ~before->axis_faults,
                            .is_loop_stopped = now->is_loop_stopped & ~before->is_loop_stopped,
                            .is_pedal_faulty = now->is_pedal_faulty & ~before->is_pedal_faulty};
}

static bool is_failing(const workphase_facts_t *facts)
{
    return (facts->lost_cards | facts->axis_faults | facts->is_loop_stopped |
            facts->is_pedal_faulty) != 0U;
}

static void add(char text[IGTL_REASON_SIZE], const char *format, ...)
    __attribute__((format(printf, 2, 3)));

static void add(char text[IGTL_REASON_SIZE], const char *format, ...)
{
    const size_t used = strlen(text);
    va_list arguments;

    va_start(arguments, format);
    (void)vsnprintf(&text[used], IGTL_REASON_SIZE - used, format, arguments);
    va_end(arguments);
}

/** @satisfies SWR-IGTL-080 */
static void write_lateness(const snapshot_t *shown, char text[IGTL_REASON_SIZE])
{
    add(text, " The loop was late too often: %s by %.1f ms, %u in %.1f ms.",
        loop_stage_name((int32_t)shown->late_stage), (double)shown->late_us / 1000.0,
        (unsigned)shown->late_count, (double)shown->late_span_us / 1000.0);
}

/* `ender`: the axis that ended an order, which may show no fault of its own. */
static void write_failures(const robot_t *robot, const workphase_facts_t *facts, uint32_t ender,
                           const snapshot_t *shown, char text[IGTL_REASON_SIZE])
{
    const bool is_ended_by_axis =
        (ender < robot->axis_count) && ((facts->axis_faults & (1U << ender)) == 0U);

    (void)snprintf(text, IGTL_REASON_SIZE, "HARDWARE_FAILURE:");
    for (uint32_t i = 0U; i < CARD_SLOT_COUNT; i++) {
        if ((facts->lost_cards & (1U << i)) != 0U) {
            add(text, " Card %u is lost.", (unsigned)i);
        }
    }
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        if ((facts->axis_faults & (1U << i)) != 0U) {
            add(text, " Axis %s has a fault.", robot->axes[i].name);
        }
    }
    if (facts->is_loop_stopped != 0U) {
        write_lateness(shown, text);
    }
    if (facts->is_pedal_faulty != 0U) {
        add(text, " The pedal's channels disagree.");
    }
    if (is_ended_by_axis) {
        add(text, " Axis %s could not go on; the log of events says why.", robot->axes[ender].name);
    } else if (!is_failing(facts)) {
        add(text, " %s", status_text((int32_t)STATUS_FAULT_PRESENT));
    } else {
        /* All is said. */
    }
}

void workphase_notifications_fault_text(const workphase_dialect_t *self, uint32_t axis,
                                        const igtl_moment_t *moment, char text[IGTL_REASON_SIZE])
{
    workphase_facts_t facts = {.workphase = 0U};

    if (moment->snapshot != NULL) {
        observe(&facts, self->robot, moment->snapshot);
    }
    write_failures(self->robot, &facts, axis, moment->snapshot, text);
}

/* Distance of the pose of the needle from being known, 0: it is. */
static uint32_t doubt_of(uint32_t pose_status)
{
    switch (pose_status) {
    case STATUS_OK:
        return 0U;
    case STATUS_NOT_REGISTERED:
        return 1U;
    default:
        return 2U;
    }
}

/* Messages that are due about its last command go first. */
static void report(workphase_dialect_t *self, uint32_t workphase, const igtl_status_t *status,
                   const igtl_moment_t *moment)
{
    workphase_peer_t *peer = &self->peers[self->controller];

    workphase_peer_send_deferred(peer, moment->now_us, true);
    igtl_send_status(peer->outbox, workphase_name((int32_t)workphase), status, moment);
}

static void send_failures(workphase_dialect_t *self, const workphase_facts_t *failures,
                          uint32_t workphase, const igtl_moment_t *moment)
{
    char text[IGTL_REASON_SIZE];
    const igtl_status_t status = {IGTL_STATUS_HARDWARE_FAILURE, "HARDWARE_FAILURE", text};

    write_failures(self->robot, failures, ROBOT_AXIS_MAX, moment->snapshot, text);
    report(self, workphase, &status, moment);
}

static void send_doubt(workphase_dialect_t *self, const workphase_facts_t *now,
                       const igtl_moment_t *moment)
{
    const int32_t doubt = (int32_t)now->pose_status;
    char text[IGTL_REASON_SIZE];
    const igtl_status_t status = {igtl_reason_code((status_t)doubt), status_name(doubt), text};

    (void)snprintf(text, sizeof text, "%s: %s", status_name(doubt), status_text(doubt));
    report(self, now->workphase, &status, moment);
}

static bool is_pulled(const workphase_facts_t *before, const workphase_facts_t *now)
{
    return ((now->estop == (uint32_t)ESTOP_LATCH_STATE_PULLED) && (before->estop != now->estop)) ||
           ((now->estop == (uint32_t)ESTOP_LATCH_STATE_LATCHED) &&
            (before->estop == (uint32_t)ESTOP_LATCH_STATE_CLEAR));
}

/** @satisfies SWR-IGTL-110 */
static const char *reason_of_latch(const snapshot_t *snapshot)
{
    const uint32_t estop = (uint32_t)1U << (uint32_t)BOX_INPUT_ESTOP;
    if ((snapshot->unread_inputs & estop) != 0U) {
        return "PANIC_MODE: The e-stop is not read: check the box.";
    }
    return ((uint32_t)snapshot->estop == (uint32_t)ESTOP_LATCH_STATE_PULLED)
               ? "PANIC_MODE: The e-stop was pulled."
               : "PANIC_MODE: The e-stop was pulled, or not read, for a moment.";
}

static void send_stopped(workphase_dialect_t *self, const workphase_facts_t *before,
                         const workphase_facts_t *now, const igtl_moment_t *moment)
{
    const bool has_changed = now->workphase != before->workphase;
    const igtl_status_t pulled = {IGTL_STATUS_PANIC_MODE, "PANIC_MODE",
                                  reason_of_latch(moment->snapshot)};
    const igtl_status_t emergency = {
        IGTL_STATUS_PANIC_MODE, "PANIC_MODE",
        "PANIC_MODE: Another connection commanded it, or the controller for safety."};
    const igtl_status_t stop = {IGTL_STATUS_OK, "STOP",
                                "Another connection commanded it, or the console."};

    if (is_pulled(before, now)) {
        report(self, (uint32_t)WORKPHASE_EMERGENCY, &pulled, moment);
    } else if (has_changed && (now->workphase == (uint32_t)WORKPHASE_EMERGENCY)) {
        report(self, (uint32_t)WORKPHASE_EMERGENCY, &emergency, moment);
    } else if (has_changed && (now->workphase == (uint32_t)WORKPHASE_STOP)) {
        report(self, (uint32_t)WORKPHASE_STOP, &stop, moment);
    } else {
        /* A peer that commands another workphase gets the answer. */
    }
}

static void send_changes(workphase_dialect_t *self, const workphase_facts_t *now,
                         const igtl_moment_t *moment)
{
    const workphase_facts_t *before = &self->watch.facts;
    workphase_facts_t failures;

    find_failures(&failures, before, now);
    if (is_failing(&failures)) {
        send_failures(self, &failures, now->workphase, moment);
    } else if (doubt_of(now->pose_status) > doubt_of(before->pose_status)) {
        send_doubt(self, now, moment);
    } else {
        /* The machine is as it was. */
    }
    send_stopped(self, before, now, moment);
}

static bool is_owed_an_answer(const workphase_dialect_t *self, const igtl_moment_t *moment)
{
    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        const igtl_request_t *request = &self->requests.requests[i];

        if ((request->id != 0U) && (request->peer == self->controller) && !request->is_accepted &&
            !request->is_overdue) {
            return true;
        }
    }
    return workphase_peer_has_order(self, self->controller) &&
           (moment->snapshot->order == (uint32_t)ARMING_STATE_NONE);
}

/* Its own sequences go first; but a notification does not wait permanently. */
static bool must_wait(workphase_dialect_t *self, const igtl_moment_t *moment)
{
    workphase_notifications_t *watch = &self->watch;

    if (!is_owed_an_answer(self, moment)) {
        return false;
    }
    if (!watch->is_waiting) {
        watch->is_waiting = true;
        watch->waiting_since_us = moment->answer_clock_us;
    }
    return (moment->answer_clock_us - watch->waiting_since_us) < IGTL_ANSWER_TIMEOUT_US;
}

void workphase_notifications_step(workphase_dialect_t *self, const igtl_moment_t *moment)
{
    workphase_notifications_t *watch = &self->watch;
    workphase_facts_t now;

    if (moment->snapshot == NULL) {
        return;
    }
    watch->is_control_lost = watch->is_control_lost && (watch->cycle == moment->snapshot->cycle);
    observe(&now, self->robot, moment->snapshot);
    if (watch->has_facts && (self->controller != IGTL_NOBODY) &&
        (memcmp(&now, &watch->facts, sizeof now) != 0)) {
        if (must_wait(self, moment)) {
            return;
        }
        send_changes(self, &now, moment);
    }
    watch->facts = now;
    watch->has_facts = true;
    watch->is_waiting = false;
}

void workphase_notifications_note(workphase_dialect_t *self, const igtl_request_t *request,
                                  const answer_t *answer, const igtl_moment_t *moment)
{
    if ((request->peer != self->controller) || (moment->snapshot == NULL)) {
        return;
    }
    if ((answer->kind == (uint32_t)ANSWER_ACCEPTED) &&
        (request->command.kind == (uint32_t)COMMAND_WORKPHASE)) {
        self->watch.facts.workphase = (uint32_t)command_kinds_workphase(&request->command);
    } else if ((answer->kind == (uint32_t)ANSWER_ABORTED) &&
               (answer->status == (uint32_t)STATUS_FAULT_PRESENT)) {
        const uint32_t workphase = self->watch.facts.workphase;
        const uint32_t estop = self->watch.facts.estop;

        observe(&self->watch.facts, self->robot, moment->snapshot);
        self->watch.facts.workphase = workphase;
        self->watch.facts.estop = estop;
    } else {
        /* It says nothing of what happens by itself. */
    }
}

void workphase_notifications_control_lost(workphase_dialect_t *self, bool is_reported,
                                          const igtl_moment_t *moment)
{
    workphase_notifications_t *watch = &self->watch;

    if (!is_reported && !watch->is_control_lost && (self->controller != IGTL_NOBODY)) {
        igtl_send_refusal(self->peers[self->controller].outbox,
                          workphase_name((int32_t)watch->facts.workphase), STATUS_NO_ANSWER,
                          moment);
    }
    watch->is_control_lost = true;
    watch->cycle = (moment->snapshot == NULL) ? 0U : moment->snapshot->cycle;
}
