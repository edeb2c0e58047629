/* SPDX-License-Identifier: Apache-2.0 */
#include "card/link.h"

#include "limits/requirement_limits.h"

#include <stddef.h>
#include <string.h>

#define CYCLES_PER_S (1000000U / LIMIT_CYCLE_US)

static bool are_drives_equal(const card_drive_t *a, const card_drive_t *b)
{
    return (a->mode == b->mode) && (a->direction == b->direction) && (a->duty == b->duty) &&
           (a->amplitude == b->amplitude);
}

/* A card that is not used yet, or not any more, may have begun to count anew. */
static bool is_old(const link_t *self, uint32_t heartbeat)
{
    const uint32_t step = heartbeat - self->report.heartbeat;
    return (self->sealed.has_report != 0U) &&
           ((step == 0U) || (link_is_usable(self) && (step > LIMIT_SEQUENCE_WINDOW)));
}

static void receive(link_t *self, uint32_t slot, const uint8_t *bytes)
{
    card_report_t old;
    self->is_fresh = 0U;
    self->last_error = (uint16_t)CARD_FRAME_OK;
    if (bytes == NULL) {
        link_note_missed(self);
        return;
    }
    /* An old report must not replace the last one. */
    const bool is_repeated = is_old(self, card_frame_heartbeat(bytes));
    card_report_t *report = &self->report;
    if (is_repeated) {
        report = &old;
    }
    card_frame_result_t result = card_frame_decode_report(bytes, slot, report);
    if ((result == CARD_FRAME_OK) && is_repeated) {
        result = CARD_FRAME_REPEATED;
        self->frames_out_of_order += (self->frames_out_of_order < UINT32_MAX) ? 1U : 0U;
    }
    self->last_error = (uint16_t)result;
    if (result != CARD_FRAME_OK) {
        self->sealed.frame_errors += (self->sealed.frame_errors < UINT32_MAX) ? 1U : 0U;
        return;
    }
    self->sealed.has_report = 1U;
    self->is_fresh = 1U;
}

static void compare_echo(link_t *self)
{
    if (self->is_fresh == 0U) {
        return;
    }
    const bool is_same = (self->report.accepted_sequence == self->sealed.sent_sequence_before) &&
                         are_drives_equal(&self->report.applied, &self->sealed.sent_before);
    self->sealed.echo_mismatches = is_same ? 0U : (self->sealed.echo_mismatches + 1U);
}

static void give_up(link_t *self, card_link_event_t event, link_cause_t cause)
{
    const card_link_inputs_t inputs = {.is_fresh = false};
    const card_link_state_t before = self->chart.state;
    (void)card_link_chart_dispatch(&self->chart, &inputs, event);
    if (self->chart.state != before) {
        self->sealed.cause = (uint16_t)cause;
        self->lost_heartbeat = self->report.heartbeat;
    }
}

void link_init(link_t *self, uint32_t card_type, uint32_t firmware)
{
    (void)memset(self, 0, sizeof *self);
    card_link_chart_init(&self->chart);
    self->sealed.card_type = card_type;
    self->sealed.firmware = firmware;
}

void link_distrust(link_t *self, uint32_t card_type, uint32_t firmware)
{
    const card_link_chart_t chart = self->chart;
    link_init(self, card_type, firmware);
    self->chart = chart;
    give_up(self, CARD_LINK_EVENT_CARD_FAULT, LINK_CAUSE_MEMORY);
}

void link_advance(link_t *self, uint32_t elapsed_us)
{
    (void)card_link_chart_advance(&self->chart, elapsed_us);
}

void link_judge(link_t *self, bool is_good)
{
    const card_link_inputs_t inputs = {.is_fresh = false};
    if (is_good && (self->chart.state == CARD_LINK_STATE_LIVE)) {
        self->sealed.age_cycles = 0U; /* LINK-I10: what is live ignores the event. */
        return;
    }
    if (is_good) {
        self->sealed.age_cycles = 0U;
        (void)card_link_chart_dispatch(&self->chart, &inputs, CARD_LINK_EVENT_GOOD);
    } else {
        self->sealed.age_cycles += (self->sealed.age_cycles < UINT32_MAX) ? 1U : 0U;
        (void)card_link_chart_dispatch(&self->chart, &inputs, CARD_LINK_EVENT_MISSED);
    }
    if (self->sealed.age_cycles >= LIMIT_LINK_AGE_CYCLES) {
        give_up(self, CARD_LINK_EVENT_TOO_OLD, LINK_CAUSE_AGE);
    }
}

/* A clock that stands still is never believed. */
static bool is_clock_right(uint32_t card_us, uint32_t measured_us, uint32_t error_us)
{
    uint32_t apart_us = measured_us - card_us;
    if (card_us > measured_us) {
        apart_us = card_us - measured_us;
    }
    return (apart_us <= error_us) && (apart_us <= (measured_us / 2U));
}

static void time_report(link_t *self, uint32_t card_us, uint32_t measured_us, uint32_t error_us)
{
    const bool is_right = is_clock_right(card_us, measured_us, error_us);
    self->reported_us = is_right ? card_us : measured_us;
    self->is_timed = 0U;
    if (is_right && (self->sealed.age_cycles == 0U)) {
        self->is_timed = 1U;
    }
}

void link_step(link_t *self, uint32_t slot, const uint8_t *bytes, const card_samples_t *samples,
               uint32_t elapsed_us)
{
    const uint32_t before_us = self->report.time_us;
    const uint32_t sampled_us = samples->sampled_us[slot];
    const uint32_t measured_us = link_measured_us(self, sampled_us, elapsed_us);
    link_advance(self, elapsed_us);
    receive(self, slot, bytes);
    self->reported_us = 0U;
    if (self->is_fresh != 0U) {
        time_report(self, self->report.time_us - before_us, measured_us, samples->error_us);
        self->sampled_us = sampled_us;
    }
    compare_echo(self);
    link_judge(self, link_is_well(self));
    if ((self->is_fresh != 0U) && ((self->report.status & CARD_STATUS_FAULTS) != 0U)) {
        give_up(self, CARD_LINK_EVENT_CARD_FAULT, LINK_CAUSE_FAULT);
    }
    if ((self->is_fresh != 0U) && !link_is_right_card(self)) {
        give_up(self, CARD_LINK_EVENT_CARD_FAULT, LINK_CAUSE_WRONG_CARD);
    }
    if (self->sealed.echo_mismatches >= LIMIT_ECHO_MISMATCH_CYCLES) {
        give_up(self, CARD_LINK_EVENT_CARD_FAULT, LINK_CAUSE_ECHO);
    }
}

void link_reset(link_t *self)
{
    const card_link_inputs_t inputs = {.is_fresh = link_is_healthy_now(self)};
    (void)card_link_chart_dispatch(&self->chart, &inputs, CARD_LINK_EVENT_RESET);
}

bool link_was_only_silent(const link_t *self)
{
    const bool is_only_tripped = (self->report.status & CARD_STATUS_FAULTS) == CARD_STATUS_WATCHDOG;
    return (self->sealed.cause == (uint16_t)LINK_CAUSE_AGE) ||
           ((self->sealed.cause == (uint16_t)LINK_CAUSE_FAULT) && is_only_tripped);
}

bool link_has_broken(link_t *self, uint32_t missed_cycles)
{
    if (self->is_fresh == 0U) {
        return false;
    }
    const uint32_t step = self->report.heartbeat - self->lost_heartbeat;
    const uint32_t faults = self->report.status & CARD_STATUS_FAULTS & ~CARD_STATUS_WATCHDOG;
    const bool is_the_same = (faults == 0U) && link_is_right_card(self);
    /* One that began anew meanwhile is on for no longer than that. */
    const bool is_old_enough = self->report.uptime_s > (missed_cycles / CYCLES_PER_S);
    self->lost_heartbeat = self->report.heartbeat;
    return (step > (missed_cycles + LIMIT_SEQUENCE_WINDOW)) ||
           ((missed_cycles != 0U) && (!is_the_same || !is_old_enough));
}
