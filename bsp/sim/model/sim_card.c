/* SPDX-License-Identifier: Apache-2.0 */
#include "sim/model/sim_card.h"

#include "limits/requirement_limits.h"

#include <string.h>

#define TOO_HOT_C 95.0

static const card_drive_t drive_off = {CARD_DRIVE_OFF, 0U, 0U, 0U};

void sim_card_init(sim_card_t *self, const axis_config_t *axis, const sim_encoder_t *encoder,
                   bool is_limit_active, uint32_t time_us)
{
    *self = (sim_card_t){.slot = axis->slot,
                         .card_type = axis->card_type,
                         .has_magnitudes = axis->maximum_duty != 0U,
                         .firmware = SIM_CARD_FIRMWARE,
                         .limit_bit = axis->limit_switch,
                         .clock_offset_us = UINT32_MAX - 30000000U * (uint32_t)axis->slot,
                         .time_us = time_us,
                         .limit_raw = is_limit_active,
                         .limit_debounced = is_limit_active,
                         .count = sim_encoder_count(encoder),
                         .even_steps = SIM_CARD_SPEED_STEPS,
                         .motor_temperature_c = SIM_MOTOR_AIR_C,
                         .heat = sim_motor_heat(axis),
                         .supply_mv = SIM_CARD_SUPPLY_MV,
                         .is_powered = true};
    for (uint32_t i = 0U; i < SIM_CARD_SPEED_STEPS; i++) {
        self->window[i] = self->count;
    }
}

static void trip(sim_card_t *self, uint32_t status_bit)
{
    self->faults |= status_bit;
    self->applied = drive_off;
    self->has_sequence = false;
}

static bool is_drive_suitable(const sim_card_t *self, const card_drive_t *drive)
{
    if (drive->mode == (uint32_t)CARD_DRIVE_OFF) {
        return true;
    }
    return (drive->mode == card_drive_mode_of(self->card_type)) &&
           ((drive->mode != (uint32_t)CARD_DRIVE_NON_PWM) || (drive->duty == 0U) ||
            self->has_magnitudes);
}

static void apply_command(sim_card_t *self)
{
    const card_command_t *command = &self->command;
    const bool clears = (command->control & CARD_CONTROL_CLEAR_FAULT) != 0U;

    self->applied = drive_off;
    if (clears) {
        /* The frame that clears does not also drive. */
        self->faults = 0U;
    } else if (!is_drive_suitable(self, &command->drive)) {
        trip(self, CARD_STATUS_DRIVER_FAULT);
    } else if ((self->faults == 0U) && ((command->control & CARD_CONTROL_AMPLIFIER) != 0U)) {
        self->applied = command->drive;
    } else {
        /* stays off */
    }
}

/* The next in sequence, or the first of a new one. */
static bool is_expected(const sim_card_t *self, const card_command_t *command)
{
    const uint32_t step = command->sequence - self->command.sequence;

    if (!self->has_sequence) {
        return ((command->control & CARD_CONTROL_CLEAR_FAULT) != 0U) &&
               (command->drive.mode == (uint32_t)CARD_DRIVE_OFF);
    }
    return (step >= 1U) && (step <= LIMIT_SEQUENCE_WINDOW);
}

void sim_card_receive(sim_card_t *self, const uint8_t bytes[CARD_FRAME_BYTES])
{
    card_command_t command;

    if (card_frame_decode_command(bytes, self->slot, &command) != CARD_FRAME_OK) {
        self->rx_crc_errors++;
        self->passing |= CARD_STATUS_RX_CRC;
        return;
    }
    if (!is_expected(self, &command)) {
        self->sequence_gaps++;
        return;
    }
    if (self->has_sequence && (command.sequence != self->command.sequence + 1U)) {
        self->sequence_gaps++;
    }
    self->command = command;
    self->has_command = true;
    self->has_sequence = true;
    self->is_watched = true;
    self->valid_age_us = 0U;
    apply_command(self);
}

static uint32_t watchdog_us(const sim_card_t *self)
{
    const uint32_t asked_us = self->command.watchdog_us;

    if ((asked_us == 0U) || (asked_us > LIMIT_CARD_WATCHDOG_US)) {
        return LIMIT_CARD_WATCHDOG_US;
    }
    return asked_us;
}

static void step_watchdog(sim_card_t *self)
{
    if (!self->is_watched) {
        return;
    }
    self->valid_age_us += SIM_STEP_US;
    if (self->valid_age_us >= watchdog_us(self)) {
        self->is_watched = false;
        self->watchdog_trips++;
        trip(self, CARD_STATUS_WATCHDOG);
    }
}

/* Of an undriven card, to which a trip in any of these steps is the same. */
static void rest_watchdog(sim_card_t *self, uint32_t steps)
{
    if (self->valid_age_us + (uint64_t)steps * SIM_STEP_US < watchdog_us(self)) {
        self->valid_age_us += self->is_watched ? (steps * SIM_STEP_US) : 0U;
        return;
    }
    for (uint32_t i = 0U; (i < steps) && self->is_watched; i++) {
        step_watchdog(self);
    }
}

static void step_limit(sim_card_t *self, bool is_active)
{
    self->limit_stable_us += SIM_STEP_US;
    if (is_active != self->limit_raw) {
        self->limit_raw = is_active;
        self->limit_stable_us = 0U;
    }
    if (self->limit_stable_us >= SIM_CARD_DEBOUNCE_US) {
        self->limit_stable_us = SIM_CARD_DEBOUNCE_US;
        self->limit_debounced = self->limit_raw;
    }
}

/* Once it has seen this state of the switch. */
static void rest_limit(sim_card_t *self, uint32_t steps)
{
    const uint64_t stable_us = self->limit_stable_us + (uint64_t)steps * SIM_STEP_US;

    self->limit_stable_us =
        (stable_us < SIM_CARD_DEBOUNCE_US) ? (uint32_t)stable_us : SIM_CARD_DEBOUNCE_US;
    if (self->limit_stable_us == SIM_CARD_DEBOUNCE_US) {
        self->limit_debounced = self->limit_raw;
    }
}

static bool is_outside_guard(const sim_card_t *self)
{
    const uint32_t minimum = (uint32_t)self->command.guard_minimum_ticks;
    const uint32_t width = (uint32_t)self->command.guard_maximum_ticks - minimum;

    /* Equal ends mean "no guard"; differences keep it right across the wrap of the reading. */
    return (width != 0U) && ((uint32_t)self->count - minimum > width);
}

static bool is_overspeed(const sim_card_t *self, int32_t oldest)
{
    const uint32_t limit = self->command.overspeed_ticks_per_s;
    const uint32_t difference = (uint32_t)self->count - (uint32_t)oldest;

    if (difference == 0U) {
        return false;
    }
    const uint32_t way = (difference <= (uint32_t)INT32_MAX) ? difference : 0U - difference;

    return (limit != 0U) && ((uint64_t)way * (1000000U / SIM_CARD_SPEED_WINDOW_US) > limit);
}

static void step_guards(sim_card_t *self, int32_t count)
{
    const int32_t oldest = self->window[self->window_at];
    const uint32_t even_steps = (count == self->count) ? (self->even_steps + 1U) : 1U;

    self->even_steps = (even_steps < SIM_CARD_SPEED_STEPS) ? even_steps : SIM_CARD_SPEED_STEPS;
    self->count = count;
    self->window[self->window_at] = count;
    self->window_at = (self->window_at == SIM_CARD_SPEED_STEPS - 1U) ? 0U : (self->window_at + 1U);
    if (!self->has_command) {
        return;
    }
    if (is_overspeed(self, oldest)) {
        trip(self, CARD_STATUS_OVERSPEED);
    }
    if (is_outside_guard(self)) {
        trip(self, CARD_STATUS_GUARD);
    }
}

/* A window that holds one reading alone holds it after any number of steps. */
static void rest_guards(sim_card_t *self, int32_t count, uint32_t steps)
{
    uint32_t left = steps;

    while ((left > 0U) && ((self->even_steps < SIM_CARD_SPEED_STEPS) || (count != self->count))) {
        step_guards(self, count);
        left--;
    }
    if (left > 0U) {
        step_guards(self, count);
        self->window_at = (self->window_at + left - 1U) % SIM_CARD_SPEED_STEPS;
    }
}

static void step_temperature(sim_card_t *self)
{
    const bool is_heated = self->is_powered && (self->applied.mode != (uint32_t)CARD_DRIVE_OFF);
    const double settled_c = SIM_MOTOR_AIR_C + (is_heated ? self->heat.settled_c : 0.0);

    self->motor_temperature_c += (settled_c - self->motor_temperature_c) * self->heat.warming_share;
    if (self->is_motor_hot) {
        self->motor_temperature_c = TOO_HOT_C;
    }
}

/* A motor as warm as the air stays so. */
static void rest_temperature(sim_card_t *self, uint32_t steps)
{
    const bool is_warm = (self->motor_temperature_c > SIM_MOTOR_AIR_C) ||
                         (self->motor_temperature_c < SIM_MOTOR_AIR_C);

    for (uint32_t i = 0U; (i < steps) && (is_warm || self->is_motor_hot); i++) {
        step_temperature(self);
    }
}

void sim_card_step(sim_card_t *self, const sim_encoder_t *encoder, bool is_limit_active,
                   bool is_powered)
{
    self->time_us += SIM_STEP_US;
    self->uptime_us += SIM_STEP_US;
    self->is_powered = is_powered;
    step_watchdog(self);
    step_limit(self, is_limit_active);
    step_guards(self, sim_encoder_count(encoder));
    step_temperature(self);
}

void sim_card_rest(sim_card_t *self, const sim_encoder_t *encoder, bool is_limit_active,
                   bool is_powered, uint32_t steps)
{
    if ((self->applied.mode != (uint32_t)CARD_DRIVE_OFF) || (steps == 0U)) {
        for (uint32_t i = 0U; i < steps; i++) {
            sim_card_step(self, encoder, is_limit_active, is_powered);
        }
        return;
    }
    self->time_us += steps * SIM_STEP_US;
    self->uptime_us += (uint64_t)steps * SIM_STEP_US;
    self->is_powered = is_powered;
    rest_watchdog(self, steps);
    step_limit(self, is_limit_active);
    rest_limit(self, steps - 1U);
    rest_guards(self, sim_encoder_count(encoder), steps);
    rest_temperature(self, steps);
}

static uint32_t status_bits(const sim_card_t *self, const sim_encoder_t *encoder)
{
    uint32_t status = self->faults | self->passing;

    if ((self->faults == 0U) && self->is_watched &&
        ((self->command.control & CARD_CONTROL_AMPLIFIER) != 0U)) {
        status |= CARD_STATUS_AMPLIFIER_ON;
    }
    if ((encoder->edges > 0U) || ((encoder->stamps_us[0] != 0U) &&
                                  (self->time_us - encoder->stamps_us[0] < SIM_CARD_MOVING_US))) {
        status |= CARD_STATUS_MOVING;
    }
    if (encoder->illegal_edges > 0U) {
        status |= CARD_STATUS_ILLEGAL_EDGE;
    }
    return status;
}

/* A driver is heated as the motor that it drives, half as much. */
static double driver_c(const sim_card_t *self)
{
    const double rise_c = self->motor_temperature_c - SIM_MOTOR_AIR_C;
    const double own_c = (rise_c < self->heat.settled_c) ? rise_c : self->heat.settled_c;

    return (self->feigned_driver_c > 0.0) ? self->feigned_driver_c
                                          : (SIM_MOTOR_AIR_C + 8.0 + own_c / 2.0);
}

static void report_health(const sim_card_t *self, card_report_t *report)
{
    const bool is_driven = self->is_powered && (self->applied.mode != (uint32_t)CARD_DRIVE_OFF);

    report->motor_temperature_dc = (int32_t)(self->motor_temperature_c * 10.0);
    report->driver_temperature_dc = (int32_t)(driver_c(self) * 10.0);
    report->supply_mv = self->is_powered ? self->supply_mv : 0U;
    report->current_ma = is_driven ? 350U : 0U;
    report->adc_words[0] = (self->adc[0] << 16U) | self->adc[1];
    report->adc_words[1] = (self->adc[2] << 16U) | self->adc[3];
    report->rx_crc_errors = self->rx_crc_errors;
    report->sequence_gaps = self->sequence_gaps;
    report->watchdog_trips = self->watchdog_trips;
    report->uptime_s = (uint32_t)(self->uptime_us / 1000000U);
}

void sim_card_report(sim_card_t *self, sim_encoder_t *encoder, uint8_t bytes[CARD_FRAME_BYTES])
{
    card_report_t report;

    self->heartbeat++;
    (void)memset(&report, 0, sizeof report);
    report.slot = self->slot;
    report.accepted_sequence = self->command.sequence;
    report.heartbeat = self->heartbeat;
    report.time_us = self->time_us + self->clock_offset_us;
    report.card_type = self->card_type;
    report.firmware = self->firmware;
    report.system_state = self->command.system_state;
    report.status = status_bits(self, encoder);
    report.limits_raw = self->limit_raw ? self->limit_bit : 0U;
    report.limits = self->limit_debounced ? self->limit_bit : 0U;
    report.encoder_count = sim_encoder_count(encoder);
    report.last_edge_us = encoder->stamps_us[0] + self->clock_offset_us;
    report.fourth_edge_us = encoder->stamps_us[4] + self->clock_offset_us;
    report.edges = encoder->edges;
    report.illegal_edges = encoder->illegal_edges;
    report.applied = self->applied;
    report_health(self, &report);
    self->passing = 0U;
    sim_encoder_take_edges(encoder);
    card_frame_encode_report(&report, bytes);
}
