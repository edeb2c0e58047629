/* SPDX-License-Identifier: Apache-2.0 */
#include "axis/axis.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"
#include "robot/joints.h"

#include <stddef.h>
#include <string.h>

static int32_t error_ticks(const axis_t *self)
{
    return fixed_saturate((int64_t)self->sealed.setpoint_ticks -
                          (int64_t)self->sealed.encoder.position_ticks);
}

/* The permitted following error grows with the speed of the set-point. */
static inline int32_t following_error_ticks(const axis_t *self, const axis_config_t *config)
{
    const int64_t speed_q8 = fixed_magnitude((int64_t)self->sealed.setpoint_speed_ticks_per_s_q8);
    const int64_t product = speed_q8 * (int64_t)config->following_time_ms;
    if (product == 0) {
        return config->following_error_ticks;
    }
    const int64_t way_q8 = fixed_divide_by(product, 1000U);
    return fixed_saturate((int64_t)config->following_error_ticks + (way_q8 / 256));
}

static bool is_switch_active(const axis_t *self)
{
    return self->sealed.limit_switches != 0U;
}

static bool has_switch(const axis_config_t *config)
{
    return config->home_method == (uint8_t)HOME_BY_SWITCH;
}

/* Farther apart than switch and counts may be. */
static bool is_beyond_margin(const axis_config_t *config, int64_t apart_ticks)
{
    return joints_is_beyond(config, apart_ticks, LIMIT_SWITCH_MARGIN_NM, LIMIT_SWITCH_MARGIN_BAM);
}

/* The axis stands at `position_ticks`; what was counted of the way stays true. */
static void set_position(axis_t *self, int32_t position_ticks)
{
    self->sealed.home_correction_ticks =
        fixed_saturate((int64_t)position_ticks - (int64_t)self->sealed.encoder.position_ticks);
    encoder_set_position(&self->sealed.encoder, position_ticks);
    supervision_shift(&self->supervision, self->sealed.home_correction_ticks);
    supervision_settle(&self->supervision);
    drift_audit_settle(&self->sealed.drift);
    self->sealed.setpoint_ticks = position_ticks;
    self->sealed.place = AXIS_PLACE_COUNTED;
    homing_forget(&self->sealed.homing);
}

/* For events that depend on the axis' table; `position_ticks`: where it stands, if they set it. */
static uint32_t dispatch(axis_t *self, const axis_config_t *config, axis_event_t event,
                         int32_t position_ticks)
{
    const axis_inputs_t inputs = {.is_fault_present = false,
                                  .is_switch_active = is_switch_active(self),
                                  .is_confirmable =
                                      !has_switch(config) || axis_is_contradicted(self)};
    const uint32_t actions = axis_chart_dispatch(&self->chart, &inputs, event);
    if ((actions & AXIS_ACTION_SET_POSITION) == 0U) {
        return 0U;
    }
    set_position(self, position_ticks);
    return AXIS_NOTE_HOMED;
}

/* For the others. */
static void notify(axis_t *self, axis_event_t event, bool is_fault_present)
{
    const axis_inputs_t inputs = {.is_fault_present = is_fault_present};
    (void)axis_chart_dispatch(&self->chart, &inputs, event);
}

void axis_init(axis_t *self)
{
    (void)memset(self, 0, sizeof *self);
    encoder_init(&self->sealed.encoder);
    servo_init(&self->sealed.servo);
    axis_chart_init(&self->chart);
    supervision_init(&self->supervision);
}

void axis_break_place(axis_t *self)
{
    self->sealed.place |= (self->sealed.place != 0U) ? AXIS_PLACE_BROKEN : 0U;
}

void axis_refuse_parking(axis_t *self)
{
    self->sealed.place = axis_is_as_parked(self) ? AXIS_PLACE_BROKEN : self->sealed.place;
}

/* Reports the `found` faults, if any, to the chart of the axis, and distrusts its counts. */
static uint32_t fail(axis_t *self, uint32_t found)
{
    if (found != 0U) {
        notify(self, AXIS_EVENT_FAILED, false);
        axis_break_place(self);
    }
    return found;
}

/* The switch was met at home. Where the counts had that, the axis is homed; elsewhere, one of the
 * two is wrong. */
static uint32_t arrive(axis_t *self, const axis_config_t *config)
{
    const int64_t away = (int64_t)config->home_ticks -
                         (int64_t)self->sealed.encoder.position_ticks +
                         (int64_t)self->sealed.elsewhere_ticks;
    if (((self->sealed.place & AXIS_PLACE_COUNTED) != 0U) &&
        is_beyond_margin(config, fixed_magnitude(away))) {
        set_position(self, config->home_ticks);
        self->sealed.elsewhere_ticks = fixed_saturate(away);
        self->sealed.contradiction_ticks = fixed_saturate(-away);
        return fail(self, AXIS_NOTE_SWITCH_ELSEWHERE);
    }
    self->sealed.elsewhere_ticks = 0;
    return dispatch(self, config, AXIS_EVENT_SWITCH_ON, config->home_ticks);
}

/* A homed axis knows where its switch is. */
static uint32_t compare_switch(axis_t *self, const axis_config_t *config)
{
    const int64_t away = homing_way_from_switch(config, self->sealed.encoder.position_ticks);
    const int64_t apart =
        is_switch_active(self) ? (away - (int64_t)config->switch_hysteresis_ticks) : -away;
    if (!has_switch(config) || !axis_is_homed(self) || !is_beyond_margin(config, apart)) {
        return 0U;
    }
    self->sealed.contradiction_ticks =
        fixed_saturate((int64_t)self->sealed.encoder.position_ticks - (int64_t)config->home_ticks);
    return fail(self, AXIS_NOTE_SWITCH_ELSEWHERE);
}

/* Away from its switch only homing has something to see. */
static homing_sight_t see_switch(axis_t *self, const axis_config_t *config)
{
    const bool is_active = is_switch_active(self);
    homing_sight_t sight = HOMING_NOTHING;
    if (is_active || axis_is_homing(self)) {
        sight = homing_see(&self->sealed.homing, config, self->chart.reference,
                           self->sealed.encoder.position_ticks, is_active);
    }
    return sight;
}

static uint32_t follow_switch(axis_t *self, const axis_config_t *config)
{
    const axis_reference_t leg = self->chart.reference;
    uint32_t notes = 0U;
    switch (see_switch(self, config)) {
    case HOMING_SWITCH:
        if (leg == AXIS_REFERENCE_APPROACH) {
            homing_meet(&self->sealed.homing, config, self->supervision.sealed.position_ticks);
        }
        notes = (leg == AXIS_REFERENCE_LATCH)
                    ? arrive(self, config)
                    : dispatch(self, config, AXIS_EVENT_SWITCH_ON, config->home_ticks);
        break;
    case HOMING_CLEAR:
        notify(self, AXIS_EVENT_CLEAR_OF_SWITCH, false);
        break;
    case HOMING_WRONG:
        notes = fail(self, AXIS_NOTE_SWITCH_FAULT);
        break;
    case HOMING_NOTHING:
    default:
        break;
    }
    return notes | compare_switch(self, config);
}

bool axis_check(axis_t *self)
{
    const bool is_repaired = axis_chart_check(&self->chart) != 0U;
    const bool is_unwatched = supervision_check(&self->supervision);
    if (is_unwatched) {
        /* The axis must not be driven until it is enabled anew. */
        notify(self, AXIS_EVENT_FAILED, false);
    }
    return is_repaired || is_unwatched;
}

uint32_t axis_observe(axis_t *self, const axis_config_t *config, const card_report_t *report,
                      uint32_t elapsed_us)
{
    uint32_t notes = 0U;
    (void)axis_chart_advance(&self->chart, elapsed_us);
    if (encoder_step(&self->sealed.encoder, config, report)) {
        notes |= fail(self, AXIS_NOTE_ENCODER_FAULT);
        homing_forget(&self->sealed.homing);
    }
    if (report != NULL) {
        self->sealed.limit_switches =
            (config->limit_switch == (uint8_t)LIMIT_SWITCH_NONE) ? 0U : report->limits;
        notes |= follow_switch(self, config);
    }
    return notes;
}

void axis_warm(axis_t *self, const axis_config_t *config, int32_t heat_dc)
{
    self->sealed.heat = motor_heat_of(config, heat_dc);
}

void axis_enable(axis_t *self, bool is_fault_present)
{
    notify(self, AXIS_EVENT_ENABLE, is_fault_present);
    if (axis_is_enabled(self)) {
        supervision_reset(&self->supervision, axis_is_homed(self));
    }
}

void axis_disable(axis_t *self)
{
    notify(self, AXIS_EVENT_DISABLE, false);
}

void axis_lose_reference(axis_t *self)
{
    notify(self, AXIS_EVENT_LOSE_REFERENCE, false);
}

void axis_doubt(axis_t *self)
{
    notify(self, AXIS_EVENT_DOUBT, false);
}

void axis_restore(axis_t *self, const axis_config_t *config, int32_t position_ticks)
{
    (void)dispatch(self, config, AXIS_EVENT_RESTORED, position_ticks);
}

void axis_place(axis_t *self, const axis_config_t *config, int32_t position_ticks)
{
    self->sealed.elsewhere_ticks = 0;
    (void)dispatch(self, config, AXIS_EVENT_PLACED, position_ticks);
}

void axis_forget(axis_t *self)
{
    if (axis_is_fresh(self)) {
        axis_refuse_parking(self);
    }
    notify(self, AXIS_EVENT_FORGET, false);
}

void axis_remember(axis_t *self, int32_t position_ticks)
{
    set_position(self, position_ticks);
    axis_break_place(self);
}

bool axis_confirm(axis_t *self, const axis_config_t *config)
{
    const bool was_homed = axis_is_homed(self);
    const bool was_in_doubt = self->chart.reference == AXIS_REFERENCE_UNVERIFIED;
    (void)dispatch(self, config, AXIS_EVENT_CONFIRM, 0);
    const bool is_confirmed = axis_is_homed(self) && !was_homed;
    if (is_confirmed) {
        self->sealed.place = AXIS_PLACE_COUNTED;
        self->sealed.elsewhere_ticks = 0;
        homing_forget(&self->sealed.homing);
        supervision_settle(&self->supervision);
        if (was_in_doubt) {
            drift_audit_confirm(&self->sealed.drift, config);
        } else {
            drift_audit_settle(&self->sealed.drift);
        }
    }
    return is_confirmed;
}

void axis_distrust(axis_t *self)
{
    const axis_chart_t chart = self->chart;
    axis_init(self);
    self->chart = chart;
    self->sealed.place = AXIS_PLACE_BROKEN;
    notify(self, AXIS_EVENT_FAILED, false);
    axis_forget(self);
    axis_lose_reference(self);
}

void axis_stop_homing(axis_t *self)
{
    notify(self, AXIS_EVENT_STOP_HOMING, false);
}

uint32_t axis_begin_homing(axis_t *self, const axis_config_t *config)
{
    if (axis_is_homed(self) || axis_is_homing(self)) {
        return 0U;
    }
    if (!has_switch(config) && !encoder_is_at_rest(&self->sealed.encoder)) {
        return 0U;
    }
    homing_begin(&self->sealed.homing, self->sealed.encoder.position_ticks);
    return dispatch(self, config, has_switch(config) ? AXIS_EVENT_HOME : AXIS_EVENT_HOME_IN_PLACE,
                    config->home_ticks);
}

card_drive_t axis_rest(axis_t *self, uint32_t elapsed_us)
{
    const card_drive_t off = {.mode = (uint32_t)CARD_DRIVE_OFF, .direction = 0U, .duty = 0U};
    self->sealed.setpoint_ticks = self->sealed.encoder.position_ticks;
    self->sealed.setpoint_speed_ticks_per_s_q8 = 0;
    homing_rest(&self->sealed.homing);
    servo_rest(&self->sealed.servo, elapsed_us);
    return off;
}

card_drive_t axis_follow(axis_t *self, const axis_config_t *config, int32_t setpoint_ticks,
                         int32_t setpoint_speed_ticks_per_s_q8, uint32_t elapsed_us)
{
    self->sealed.setpoint_ticks = setpoint_ticks;
    self->sealed.setpoint_speed_ticks_per_s_q8 = setpoint_speed_ticks_per_s_q8;
    return servo_step(&self->sealed.servo, config, error_ticks(self), setpoint_speed_ticks_per_s_q8,
                      elapsed_us);
}

card_drive_t axis_home(axis_t *self, const axis_config_t *config, uint32_t elapsed_us)
{
    homing_step(&self->sealed.homing, config, self->chart.reference,
                self->sealed.encoder.position_ticks);
    return axis_follow(self, config, fixed_saturate(self->sealed.homing.setpoint_q8 / 256),
                       self->sealed.homing.speed_ticks_per_s_q8, elapsed_us);
}

static bool is_unverified(const axis_t *self)
{
    return self->chart.reference == AXIS_REFERENCE_UNVERIFIED;
}

/* Counts of an axis that stands add up to a doubt. */
static uint32_t audit(axis_t *self, const axis_config_t *config, int64_t way, bool is_off,
                      uint32_t elapsed_us)
{
    uint32_t notes = 0U;
    drift_audit_step(&self->sealed.drift, way, is_off, elapsed_us);
    if (axis_is_homed(self) && drift_audit_is_beyond(&self->sealed.drift, config)) {
        axis_doubt(self);
        notes = AXIS_NOTE_DRIFTED;
    }
    return notes;
}

uint32_t axis_supervise(axis_t *self, const axis_config_t *config, bool is_driven,
                        const axis_sample_t *sample)
{
    /* Before START_UP and after a fault no check needs the position: hands may move the axis. */
    const bool is_relied_on = axis_is_enabled(self) || axis_is_homed(self) || is_unverified(self);
    const axis_reference_t leg = self->chart.reference;
    const card_drive_t asked = {.mode = 0U, .direction = self->sealed.servo.direction, .duty = 0U};
    supervision_view_t view = {.position_ticks = self->sealed.encoder.position_ticks,
                               .setpoint_ticks = self->sealed.setpoint_ticks,
                               .following_error_ticks = following_error_ticks(self, config),
                               .is_driven = is_driven,
                               .is_upwards = motor_model_is_upwards(config, &asked),
                               .is_relied_on = is_relied_on,
                               .drive = *sample->applied,
                               .lost_q16 = self->sealed.heat.lost_q16,
                               .edge_age_us = sample->is_timed ? self->sealed.encoder.edge_age_us
                                                               : ENCODER_AGE_UNKNOWN,
                               .elapsed_us = sample->elapsed_us};
    motor_heat_untune(&self->sealed.heat, &view.drive);
    const int64_t way =
        (int64_t)view.position_ticks - (int64_t)self->supervision.sealed.position_ticks;
    uint32_t found = supervision_step(&self->supervision, config, &view);
    if (homing_is_too_long(&self->sealed.homing, config, leg, is_driven, sample->elapsed_us)) {
        found |= AXIS_NOTE_HOME_TIMEOUT;
    }
    if (homing_is_leg(leg) &&
        homing_is_too_far(&self->sealed.homing, config, leg, view.position_ticks)) {
        found |= AXIS_NOTE_SWITCH_FAULT;
    }
    const uint32_t faults = fail(self, found);
    const bool is_off = sample->applied->mode == (uint32_t)CARD_DRIVE_OFF;
    return faults | audit(self, config, way, is_off, sample->elapsed_us);
}

/* `way`: ticks, below 0 as their complement, as the reading wraps, too. */
static int32_t reading_at(const axis_t *self, const axis_config_t *config, uint32_t way)
{
    const uint32_t reading = (uint32_t)self->sealed.encoder.reading;
    uint32_t at = reading + way;
    if (config->is_encoder_inverted != 0U) {
        at = reading - way;
    }
    return (at > (uint32_t)INT32_MAX) ? (int32_t)((int64_t)at - INT64_C(4294967296)) : (int32_t)at;
}

void axis_guard(const axis_t *self, const axis_config_t *config, bool is_driven,
                int32_t *minimum_reading, int32_t *maximum_reading)
{
    uint32_t above = 2U * (uint32_t)self->supervision.sealed.rest_ticks;
    uint32_t below = 0U - above;
    if (is_driven) {
        const int32_t way = error_ticks(self);
        const uint32_t most = (uint32_t)following_error_ticks(self, config);
        below += ((way < 0) ? (uint32_t)way : 0U) - most;
        above += ((way > 0) ? (uint32_t)way : 0U) + most;
    }
    const bool is_inverted = config->is_encoder_inverted != 0U;
    *minimum_reading = reading_at(self, config, is_inverted ? above : below);
    *maximum_reading = reading_at(self, config, is_inverted ? below : above);
}

bool axis_is_placed(const axis_t *self)
{
    return axis_is_homed(self) || is_unverified(self) || (self->sealed.place == AXIS_PLACE_COUNTED);
}

bool axis_is_confirmable(const axis_t *self, const axis_config_t *config)
{
    return is_unverified(self) || axis_needs_confirmation(self, config) ||
           (axis_is_contradicted(self) && (self->chart.reference == AXIS_REFERENCE_LOST));
}

bool axis_needs_confirmation(const axis_t *self, const axis_config_t *config)
{
    return !has_switch(config) &&
           (is_unverified(self) || (self->chart.reference == AXIS_REFERENCE_LOST));
}

bool axis_is_contradicted(const axis_t *self)
{
    return self->sealed.elsewhere_ticks != 0;
}

bool axis_is_moving_in_doubt(const axis_t *self)
{
    const bool is_lost = self->chart.reference == AXIS_REFERENCE_LOST;
    return (is_unverified(self) || is_lost) && !encoder_is_at_rest(&self->sealed.encoder);
}

bool axis_is_at(const axis_t *self, const axis_config_t *config, int32_t target_ticks)
{
    return fixed_magnitude((int64_t)target_ticks - (int64_t)self->sealed.encoder.position_ticks) <=
           (int64_t)config->deadband_ticks;
}

bool axis_is_towards_switch(const axis_t *self, const axis_config_t *config,
                            const card_drive_t *drive)
{
    const bool is_upper = config->limit_switch == (uint8_t)LIMIT_SWITCH_UPPER;
    return (drive->mode != (uint32_t)CARD_DRIVE_OFF) && is_switch_active(self) &&
           (motor_model_is_upwards(config, drive) == is_upper);
}

bool axis_is_driven_out(const axis_t *self, const axis_config_t *config, const card_drive_t *drive)
{
    if (drive->mode == (uint32_t)CARD_DRIVE_OFF) {
        return false;
    }
    return motor_model_is_upwards(config, drive)
               ? (self->sealed.encoder.position_ticks >= config->maximum_ticks)
               : (self->sealed.encoder.position_ticks <= config->minimum_ticks);
}
