/* SPDX-License-Identifier: Apache-2.0 */
#include "servo.h"

#include "requirement_limits.h"

#include <string.h>

/* Speed demanded for each tick of error: ticks/s, found on the simulated box (rise time constant 15
 * ms). */
#define GAIN_PER_S INT64_C(60)
/* A motor below a tenth of its full speed sticks; leave some margin. */
#define SLOWEST_PERCENT INT64_C(15)
#define PWM_PULSE_PERCENT INT64_C(50)

static int64_t magnitude(int64_t value)
{
    return (value < 0) ? -value : value;
}

static uint32_t duty_for(const axis_config_t *config, int64_t demand_q8)
{
    const int64_t span = (int64_t)config->maximum_duty - (int64_t)config->minimum_duty;
    const int64_t full_q8 = (int64_t)config->full_speed_ticks_per_s * 256;
    const int64_t duty = (int64_t)config->minimum_duty + ((span * demand_q8) / full_q8);
    return (duty > (int64_t)config->maximum_duty) ? config->maximum_duty : (uint32_t)duty;
}

static uint32_t direction_bit(const axis_config_t *config, bool is_upwards)
{
    const bool is_inverted = config->is_motor_inverted != 0U;
    return (is_upwards != is_inverted) ? 1U : 0U;
}

/* Speed of a pulse, or 0 when this cycle pauses. */
static int64_t pulse(servo_t *self, int64_t demand_q8, int64_t pulse_q8)
{
    self->pulse_debt_q8 += demand_q8;
    if (self->pulse_debt_q8 < pulse_q8) {
        return 0;
    }
    self->pulse_debt_q8 -= pulse_q8;
    return pulse_q8;
}

static int64_t run_speed(servo_t *self, const axis_config_t *config, int64_t demand_q8)
{
    const int64_t full_q8 = (int64_t)config->full_speed_ticks_per_s * 256;
    if (config->card_type == (uint8_t)CARD_TYPE_NON_PWM) {
        return pulse(self, (demand_q8 > full_q8) ? full_q8 : demand_q8, full_q8);
    }
    if (demand_q8 < ((full_q8 * SLOWEST_PERCENT) / 100)) {
        return pulse(self, demand_q8, (full_q8 * PWM_PULSE_PERCENT) / 100);
    }
    self->pulse_debt_q8 = 0;
    return demand_q8;
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
    self->pulse_debt_q8 = 0;
    pass_time(self, elapsed_us);
}

bool servo_is_upwards(const axis_config_t *config, const card_drive_t *drive)
{
    return (drive->direction != 0U) != (config->is_motor_inverted != 0U);
}

card_drive_t servo_step(servo_t *self, const axis_config_t *config, int32_t error_ticks,
                        int32_t setpoint_speed_ticks_per_s_q8, uint32_t elapsed_us)
{
    card_drive_t drive = {.mode = (uint32_t)CARD_DRIVE_OFF, .direction = 0U, .duty = 0U};
    pass_time(self, elapsed_us);
    const bool is_arrived = magnitude((int64_t)error_ticks) <= (int64_t)config->deadband_ticks;
    if (is_arrived && (setpoint_speed_ticks_per_s_q8 == 0)) {
        self->pulse_debt_q8 = 0;
        return drive;
    }
    const int64_t demand_q8 =
        (int64_t)setpoint_speed_ticks_per_s_q8 + ((int64_t)error_ticks * GAIN_PER_S * 256);
    const uint32_t direction = direction_bit(config, demand_q8 > 0);
    if ((direction != self->direction) && (self->rest_us < LIMIT_REVERSAL_DWELL_US)) {
        self->pulse_debt_q8 = 0;
        return drive;
    }
    const int64_t speed_q8 = run_speed(self, config, magnitude(demand_q8));
    if (speed_q8 == 0) {
        return drive;
    }
    self->direction = direction;
    self->is_driving = 1U;
    drive.mode = (uint32_t)CARD_DRIVE_NON_PWM;
    drive.direction = direction;
    if (config->card_type == (uint8_t)CARD_TYPE_PWM) {
        drive.mode = (uint32_t)CARD_DRIVE_PWM;
        drive.duty = duty_for(config, speed_q8);
    }
    return drive;
}
