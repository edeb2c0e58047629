/* SPDX-License-Identifier: Apache-2.0 */
#include "motion/servo.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"

#include <string.h>

/* A motor below a tenth of its full speed sticks; leave some margin. */
#define SLOWEST_PERCENT 15U
/* A motor may be faster than its model; its two directions differ by 3 % more, and a little. */
#define FASTEST_PERCENT (INT64_C(105) + (int64_t)LIMIT_MOTOR_SPREAD_PERCENT)
/* From an off word to a motor at rest. */
#define STOP_US INT64_C(1500)

static uint32_t direction_bit(const axis_config_t *config, bool is_upwards)
{
    const bool is_inverted = config->is_motor_inverted != 0U;
    return (is_upwards != is_inverted) ? 1U : 0U;
}

static card_drive_t drive_with(const axis_config_t *config, uint32_t direction, uint32_t duty)
{
    const card_drive_t drive = {.mode = card_drive_mode_of((uint32_t)config->card_type),
                                .direction = direction,
                                .duty = duty,
                                .amplitude = (uint32_t)config->amplitude};
    return drive;
}

/* Stopped after one more cycle of `drive`, even the fastest motor comes no farther than
 * `way_ticks`. */
static bool is_short(const servo_t *self, const axis_config_t *config, const card_drive_t *drive,
                     int64_t way_ticks)
{
    motor_model_t model = self->model;
    const int64_t more_q16 = motor_model_step_q16(&model, config, drive, LIMIT_CYCLE_US);
    const int64_t stop_q16 = fixed_divide_by(model.speed_ticks_per_s_q8 * 4 * STOP_US, 15625U);
    const int64_t farthest_q16 =
        fixed_magnitude(self->unseen_q16 + more_q16 + stop_q16) * FASTEST_PERCENT;
    return farthest_q16 <= (way_ticks * 65536 * 100);
}

/* A late cycle: the motor ran on in it. */
static void catch_up(servo_t *self, const axis_config_t *config, uint32_t elapsed_us)
{
    if ((elapsed_us > LIMIT_OVERRUN_US) && (self->is_driving != 0U)) {
        const card_drive_t drive = drive_with(config, self->direction, self->duty);
        (void)motor_model_step_q16(&self->model, config, &drive, elapsed_us - LIMIT_CYCLE_US);
    }
}

/* The time up to this cycle counts as rest only if the cycle before asked for nothing. */
static void pass_time(servo_t *self, uint32_t elapsed_us)
{
    if (self->is_driving != 0U) {
        self->rest_us = 0U;
    } else if (self->rest_us > (UINT32_MAX - elapsed_us)) {
        self->rest_us = UINT32_MAX;
    } else {
        self->rest_us += elapsed_us;
    }
    self->is_driving = 0U;
}

void servo_init(servo_t *self)
{
    (void)memset(self, 0, sizeof *self);
    self->rest_us = UINT32_MAX;
}

void servo_rest(servo_t *self, uint32_t elapsed_us)
{
    self->model.speed_ticks_per_s_q8 = 0;
    self->unseen_q16 = 0;
    pass_time(self, elapsed_us);
}

/* Drive that brings the axis on, `way_ticks` before the set-point that moves at `speed_q8`. */
static card_drive_t choose(const servo_t *self, const axis_config_t *config, uint32_t direction,
                           int64_t way_ticks, int64_t speed_q8)
{
    const card_drive_t off = {.mode = (uint32_t)CARD_DRIVE_OFF, .direction = 0U, .duty = 0U};
    const uint32_t full_speed = (uint32_t)config->full_speed_ticks_per_s; /* At most a million. */
    const uint32_t slowest = (full_speed * 256U * SLOWEST_PERCENT) / 100U;
    const int64_t slowest_q8 = (int64_t)slowest;
    const int64_t demand_q8 = speed_q8 + (way_ticks * (int64_t)config->gain_per_s * 256);
    const bool has_magnitudes = motor_model_has_magnitudes(config);
    const bool is_steady = has_magnitudes && (demand_q8 >= slowest_q8);
    const int64_t wanted_q8 = is_steady ? demand_q8 : slowest_q8;
    const uint32_t duty = has_magnitudes ? motor_model_duty(config, wanted_q8) : 0U;
    const card_drive_t drive = drive_with(config, direction, duty);
    return (is_steady || is_short(self, config, &drive, way_ticks)) ? drive : off;
}

card_drive_t servo_step(servo_t *self, const axis_config_t *config, int32_t error_ticks,
                        int32_t setpoint_speed_ticks_per_s_q8, uint32_t elapsed_us)
{
    card_drive_t drive = {.mode = (uint32_t)CARD_DRIVE_OFF, .direction = 0U, .duty = 0U};
    const int64_t speed_q8 = (int64_t)setpoint_speed_ticks_per_s_q8;
    const bool is_arrived =
        fixed_magnitude((int64_t)error_ticks) <= (int64_t)config->deadband_ticks;
    const bool is_upwards = (speed_q8 != 0) ? (speed_q8 > 0) : (error_ticks > 0);
    const uint32_t direction = direction_bit(config, is_upwards);
    catch_up(self, config, elapsed_us);
    pass_time(self, elapsed_us);
    const uint32_t dwell_us = (uint32_t)config->reversal_dwell_ms * 1000U;
    const bool is_turning = (direction != self->direction) && (self->rest_us < dwell_us);
    if (!is_turning && (!is_arrived || (speed_q8 != 0))) {
        const int64_t way_ticks = is_upwards ? (int64_t)error_ticks : -(int64_t)error_ticks;
        drive = choose(self, config, direction, way_ticks, fixed_magnitude(speed_q8));
    }
    self->unseen_q16 = motor_model_step_q16(&self->model, config, &drive, LIMIT_CYCLE_US);
    if (drive.mode != (uint32_t)CARD_DRIVE_OFF) {
        self->direction = direction;
        self->duty = drive.duty;
        self->is_driving = 1U;
    }
    return drive;
}
