/* SPDX-License-Identifier: Apache-2.0 */
#include "axis.h"

#include "fixed.h"
#include "requirement_limits.h"

#include <stddef.h>
#include <string.h>

#define CYCLES_PER_S (INT32_C(1000000) / (int32_t)LIMIT_CYCLE_US)

static int32_t error_ticks(const axis_t *self)
{
    return fixed_saturate((int64_t)self->setpoint_ticks - (int64_t)self->encoder.position_ticks);
}

static int64_t magnitude(int64_t value)
{
    return (value < 0) ? -value : value;
}

static bool is_switch_active(const axis_t *self)
{
    return self->limit_switches != 0U;
}

static uint32_t dispatch(axis_t *self, const axis_config_t *config, axis_event_t event,
                         bool is_fault_present)
{
    const axis_inputs_t inputs = {.is_fault_present = is_fault_present,
                                  .is_switch_active = is_switch_active(self)};
    const uint32_t actions = axis_chart_dispatch(&self->chart, &inputs, event);
    if ((actions & AXIS_ACTION_SET_POSITION) == 0U) {
        return 0U;
    }
    self->home_correction_ticks =
        fixed_saturate((int64_t)config->home_ticks - (int64_t)self->encoder.position_ticks);
    encoder_set_position(&self->encoder, config->home_ticks);
    self->setpoint_ticks = config->home_ticks;
    return AXIS_NOTE_HOMED;
}

/* For events that never set the position. */
static void tell(axis_t *self, axis_event_t event, bool is_fault_present)
{
    (void)dispatch(self, NULL, event, is_fault_present);
}

void axis_init(axis_t *self)
{
    (void)memset(self, 0, sizeof *self);
    encoder_init(&self->encoder);
    servo_init(&self->servo);
    axis_chart_init(&self->chart);
    stall_watchdog_chart_init(&self->stall);
}

static uint32_t follow_switch(axis_t *self, const axis_config_t *config)
{
    uint32_t notes = 0U;
    if (is_switch_active(self)) {
        self->switch_ticks = self->encoder.position_ticks;
        notes = dispatch(self, config, AXIS_EVENT_SWITCH_ON, false);
    } else {
        const int64_t clear_ticks = ((int64_t)config->home_speed_ticks_per_s / 20) + 2;
        const int64_t way_ticks =
            magnitude((int64_t)self->encoder.position_ticks - (int64_t)self->switch_ticks);
        if (way_ticks >= clear_ticks) {
            notes = dispatch(self, config, AXIS_EVENT_CLEAR_OF_SWITCH, false);
        }
    }
    return notes;
}

uint32_t axis_observe(axis_t *self, const axis_config_t *config, const card_report_t *report)
{
    uint32_t notes = 0U;
    if (axis_chart_check(&self->chart) != 0U) {
        notes |= AXIS_NOTE_CHART_REPAIRED;
    }
    if (stall_watchdog_chart_check(&self->stall) != 0U) {
        /* Its safe state watches nothing: the axis must not be driven until it is enabled anew. */
        tell(self, AXIS_EVENT_FAILED, false);
        notes |= AXIS_NOTE_CHART_REPAIRED;
    }
    if (encoder_step(&self->encoder, config, report)) {
        tell(self, AXIS_EVENT_FAILED, false);
        notes |= AXIS_NOTE_ENCODER_FAULT;
    }
    if (report != NULL) {
        self->limit_switches =
            (config->limit_switch == (uint8_t)LIMIT_SWITCH_NONE) ? 0U : report->limits;
        notes |= follow_switch(self, config);
    }
    return notes;
}

void axis_enable(axis_t *self, bool is_fault_present)
{
    tell(self, AXIS_EVENT_ENABLE, is_fault_present);
    if (axis_is_enabled(self)) {
        (void)stall_watchdog_chart_dispatch(&self->stall, STALL_WATCHDOG_EVENT_RESET);
    }
}

void axis_disable(axis_t *self)
{
    tell(self, AXIS_EVENT_DISABLE, false);
}

void axis_lose_reference(axis_t *self)
{
    tell(self, AXIS_EVENT_LOSE_REFERENCE, false);
}

void axis_stop_homing(axis_t *self)
{
    tell(self, AXIS_EVENT_STOP_HOMING, false);
}

uint32_t axis_begin_homing(axis_t *self, const axis_config_t *config)
{
    if (axis_is_homed(self) || axis_is_homing(self)) {
        return 0U;
    }
    self->homing_us = 0U;
    const bool has_switch = config->home_method == (uint8_t)HOME_BY_SWITCH;
    return dispatch(self, config, has_switch ? AXIS_EVENT_HOME : AXIS_EVENT_HOME_IN_PLACE, false);
}

card_drive_t axis_rest(axis_t *self, uint32_t elapsed_us)
{
    const card_drive_t off = {.mode = (uint32_t)CARD_DRIVE_OFF, .direction = 0U, .duty = 0U};
    self->setpoint_ticks = self->encoder.position_ticks;
    self->setpoint_speed_ticks_per_s_q8 = 0;
    self->home_reference = (uint32_t)AXIS_REFERENCE_UNHOMED;
    servo_rest(&self->servo, elapsed_us);
    return off;
}

card_drive_t axis_follow(axis_t *self, const axis_config_t *config, int32_t setpoint_ticks,
                         int32_t setpoint_speed_ticks_per_s_q8, uint32_t elapsed_us)
{
    self->setpoint_ticks = setpoint_ticks;
    self->setpoint_speed_ticks_per_s_q8 = setpoint_speed_ticks_per_s_q8;
    return servo_step(&self->servo, config, error_ticks(self), setpoint_speed_ticks_per_s_q8,
                      elapsed_us);
}

/* Homing speed wanted in the present state, signed. */
static int32_t home_speed_wanted_q8(const axis_t *self, const axis_config_t *config)
{
    int32_t speed_q8 = 256 * config->home_speed_ticks_per_s;
    if (config->limit_switch != (uint8_t)LIMIT_SWITCH_UPPER) {
        speed_q8 = -speed_q8;
    }
    if (self->chart.reference == AXIS_REFERENCE_BACK_OFF) {
        speed_q8 = -speed_q8 / 2;
    } else if (self->chart.reference == AXIS_REFERENCE_LATCH) {
        speed_q8 = speed_q8 / 4;
    } else {
        /* Fast approach. */
    }
    return speed_q8;
}

static int32_t ramp_towards(int32_t speed_q8, int32_t wanted_q8, int32_t step_q8)
{
    int32_t next_q8 = wanted_q8;
    if ((wanted_q8 - speed_q8) > step_q8) {
        next_q8 = speed_q8 + step_q8;
    } else if ((speed_q8 - wanted_q8) > step_q8) {
        next_q8 = speed_q8 - step_q8;
    } else {
        /* The wanted speed is within one step. */
    }
    return next_q8;
}

card_drive_t axis_home(axis_t *self, const axis_config_t *config, uint32_t elapsed_us)
{
    if (self->home_reference != (uint32_t)self->chart.reference) {
        self->home_reference = (uint32_t)self->chart.reference;
        self->home_setpoint_q8 = (int64_t)self->encoder.position_ticks * 256;
        self->home_speed_ticks_per_s_q8 = 0;
    }
    const int32_t wanted_q8 = home_speed_wanted_q8(self, config);
    const int32_t step_q8 = (config->acceleration_ticks_per_s2 * 256) / CYCLES_PER_S;
    const int32_t speed_q8 = ramp_towards(self->home_speed_ticks_per_s_q8, wanted_q8, step_q8);
    self->home_speed_ticks_per_s_q8 = speed_q8;
    self->home_setpoint_q8 += (int64_t)speed_q8 / CYCLES_PER_S;
    return axis_follow(self, config, fixed_saturate(self->home_setpoint_q8 / 256), speed_q8,
                       elapsed_us);
}

static uint32_t as_flag(bool value)
{
    return value ? 1U : 0U;
}

/* Progress counts in the direction in which the motor is driven; a set-point may be overtaken for a
 * while. */
static bool is_progressing(axis_t *self, const axis_config_t *config)
{
    const card_drive_t driven = {.mode = 0U, .direction = self->servo.direction, .duty = 0U};
    const bool is_upwards = servo_is_upwards(config, &driven);
    int64_t way = (int64_t)self->encoder.position_ticks - (int64_t)self->progress_mark_ticks;
    way = is_upwards ? way : -way;
    const uint32_t direction = as_flag(is_upwards);
    const bool has_turned = direction != self->is_progress_upwards;
    self->is_progress_upwards = direction;
    return has_turned || (way >= (int64_t)LIMIT_STALL_PROGRESS_TICKS);
}

static uint32_t watch_stall(axis_t *self, const axis_config_t *config, bool is_pushing,
                            uint32_t elapsed_us)
{
    const uint32_t actions = stall_watchdog_chart_advance(&self->stall, elapsed_us);
    if ((actions & STALL_WATCHDOG_ACTION_REPORT_STALL) != 0U) {
        tell(self, AXIS_EVENT_FAILED, false);
        return AXIS_NOTE_STALLED;
    }
    if (!is_pushing) {
        (void)stall_watchdog_chart_dispatch(&self->stall, STALL_WATCHDOG_EVENT_NOT_DRIVEN);
        self->progress_mark_ticks = self->encoder.position_ticks;
        return 0U;
    }
    if (is_progressing(self, config)) {
        (void)stall_watchdog_chart_dispatch(&self->stall, STALL_WATCHDOG_EVENT_PROGRESS);
        self->progress_mark_ticks = self->encoder.position_ticks;
    }
    (void)stall_watchdog_chart_dispatch(&self->stall, STALL_WATCHDOG_EVENT_DRIVEN);
    return 0U;
}

static uint32_t watch_homing(axis_t *self, bool is_driven, uint32_t elapsed_us)
{
    if (!is_driven || !axis_is_homing(self)) {
        return 0U;
    }
    self->homing_us += elapsed_us;
    if (self->homing_us < LIMIT_HOME_TIMEOUT_US) {
        return 0U;
    }
    tell(self, AXIS_EVENT_FAILED, false);
    return AXIS_NOTE_HOME_TIMEOUT;
}

uint32_t axis_supervise(axis_t *self, const axis_config_t *config, bool is_driven,
                        uint32_t elapsed_us)
{
    (void)axis_chart_advance(&self->chart, elapsed_us);
    const int64_t distance = magnitude((int64_t)error_ticks(self));
    const bool is_pushing = is_driven && (distance >= (int64_t)LIMIT_STALL_PROGRESS_TICKS) &&
                            (distance > (int64_t)config->deadband_ticks);
    uint32_t notes = watch_stall(self, config, is_pushing, elapsed_us);
    notes |= watch_homing(self, is_driven, elapsed_us);
    if (is_driven && (distance > (int64_t)config->following_error_ticks)) {
        tell(self, AXIS_EVENT_FAILED, false);
        notes |= AXIS_NOTE_FOLLOWING_ERROR;
    }
    return notes;
}

bool axis_is_enabled(const axis_t *self)
{
    return self->chart.power == AXIS_POWER_ENABLED;
}

bool axis_is_faulty(const axis_t *self)
{
    return self->chart.power == AXIS_POWER_FAULT;
}

bool axis_is_homed(const axis_t *self)
{
    return self->chart.reference == AXIS_REFERENCE_HOMED;
}

bool axis_is_homing(const axis_t *self)
{
    return axis_chart_in_homing(&self->chart);
}

bool axis_is_at(const axis_t *self, const axis_config_t *config, int32_t target_ticks)
{
    return magnitude((int64_t)target_ticks - (int64_t)self->encoder.position_ticks) <=
           (int64_t)config->deadband_ticks;
}

bool axis_is_towards_switch(const axis_t *self, const axis_config_t *config,
                            const card_drive_t *drive)
{
    const bool is_upper = config->limit_switch == (uint8_t)LIMIT_SWITCH_UPPER;
    return (drive->mode != (uint32_t)CARD_DRIVE_OFF) && is_switch_active(self) &&
           (servo_is_upwards(config, drive) == is_upper);
}

bool axis_is_beyond_limit(const axis_t *self, const axis_config_t *config,
                          const card_drive_t *drive)
{
    if ((drive->mode == (uint32_t)CARD_DRIVE_OFF) || !axis_is_homed(self)) {
        return false;
    }
    return servo_is_upwards(config, drive)
               ? (self->encoder.position_ticks >= config->maximum_ticks)
               : (self->encoder.position_ticks <= config->minimum_ticks);
}
