/* SPDX-License-Identifier: Apache-2.0 */
#include "motion/motor_model.h"

#include "base/fixed.h"

/* Facts of the motors: time constants of gaining and losing speed while driven, share of full speed
 * at the smallest word. */
#define RISE_US 15000U
#define FALL_US 1500U
#define SLOWEST_PERCENT 10

#define US_PER_S 1000000U

static int64_t slowest_of(int64_t full_q8)
{
    return fixed_divide_by(full_q8 * SLOWEST_PERCENT, 100U);
}

static bool has_waves(const axis_config_t *config)
{
    return config->card_type == (uint8_t)CARD_TYPE_HIGH_FREQUENCY;
}

/* Speed after `step` of the steps to full speed, in 1 / ROBOT_CURVE_FULL of it. */
static int64_t curve_at(const axis_config_t *config, uint32_t step)
{
    return (step < ROBOT_CURVE_STEPS) ? (int64_t)config->speed_curve[step]
                                      : (int64_t)ROBOT_CURVE_FULL;
}

static int64_t clamp(int64_t value, int64_t most)
{
    const int64_t above = (value < 0) ? 0 : value;
    return (above > most) ? most : above;
}

/* From the slowest word to the fastest. */
static int64_t wave_span(const axis_config_t *config)
{
    return (int64_t)config->minimum_duty - (int64_t)config->maximum_duty;
}

/* Rounds to the slower word. */
static uint32_t wave_word(const axis_config_t *config, int64_t speed_q8)
{
    const int64_t full_q8 = (int64_t)config->full_speed_ticks_per_s * 256;
    const int64_t wanted_q8 = clamp((speed_q8 * (int64_t)ROBOT_CURVE_FULL * 256) / full_q8,
                                    (int64_t)ROBOT_CURVE_FULL * 256);
    uint32_t step = 0U;
    while ((step < (ROBOT_CURVE_STEPS - 1U)) &&
           (wanted_q8 >= (curve_at(config, step + 1U) * 256))) {
        step++;
    }
    const int64_t low = curve_at(config, step);
    const int64_t part_q8 =
        clamp((wanted_q8 - (low * 256)) / (curve_at(config, step + 1U) - low), 256);
    const int64_t down = (((int64_t)step * 256) + part_q8) * wave_span(config);
    const int64_t below = down / ((int64_t)ROBOT_CURVE_STEPS * 256);
    return config->minimum_duty - (uint32_t)below;
}

/* Beyond the slowest word lies the dead zone; its start is unknown. */
static int64_t wave_speed_q8(const axis_config_t *config, uint32_t word)
{
    const int64_t span = wave_span(config);
    const int64_t beyond = (int64_t)word - (int64_t)config->minimum_duty;
    const int64_t down = clamp(-beyond, span);
    if (beyond > (int64_t)LIMIT_SWEEP_MARGIN_WORDS) {
        return 0;
    }
    const int64_t steps_q8 = (down * (int64_t)ROBOT_CURVE_STEPS * 256) / span;
    const int64_t whole = steps_q8 / 256;
    const uint32_t step = (uint32_t)whole;
    const int64_t low = curve_at(config, step);
    const int64_t share_q8 =
        (low * 256) + ((curve_at(config, step + 1U) - low) * (steps_q8 - ((int64_t)step * 256)));
    return ((int64_t)config->full_speed_ticks_per_s * share_q8) / (int64_t)ROBOT_CURVE_FULL;
}

uint32_t motor_model_duty(const axis_config_t *config, int64_t speed_ticks_per_s_q8)
{
    if (has_waves(config)) {
        return wave_word(config, speed_ticks_per_s_q8);
    }
    const int64_t full_q8 = (int64_t)config->full_speed_ticks_per_s * 256;
    const int64_t slowest_q8 = slowest_of(full_q8);
    const int64_t span = (int64_t)config->maximum_duty - (int64_t)config->minimum_duty;
    const int64_t above =
        fixed_divide_signed(span * (speed_ticks_per_s_q8 - slowest_q8), full_q8 - slowest_q8);
    if (above < 0) {
        return config->minimum_duty;
    }
    return (above > span) ? config->maximum_duty : (config->minimum_duty + (uint32_t)above);
}

/* Below the smallest word the motor sticks; the largest saturates. */
static int64_t magnitude_speed_q8(const axis_config_t *config, uint32_t duty)
{
    const int64_t full_q8 = (int64_t)config->full_speed_ticks_per_s * 256;
    const int64_t slowest_q8 = slowest_of(full_q8);
    const int64_t span = (int64_t)config->maximum_duty - (int64_t)config->minimum_duty;
    const int64_t above = (int64_t)duty - (int64_t)config->minimum_duty;
    if (above < 0) {
        return 0;
    }
    return clamp(slowest_q8 + fixed_divide_signed((full_q8 - slowest_q8) * above, span), full_q8);
}

int64_t motor_model_steady_q8(const axis_config_t *config, const card_drive_t *drive)
{
    int64_t speed_q8 = (int64_t)config->full_speed_ticks_per_s * 256;
    if (has_waves(config)) {
        speed_q8 = wave_speed_q8(config, drive->duty);
    } else if (motor_model_has_magnitudes(config)) {
        speed_q8 = magnitude_speed_q8(config, drive->duty);
    } else {
        /* It runs. */
    }
    return speed_q8;
}

/* With its sign. */
static int64_t steady_q8(const axis_config_t *config, const card_drive_t *drive)
{
    const int64_t speed_q8 = motor_model_steady_q8(config, drive);
    return motor_model_is_upwards(config, drive) ? speed_q8 : -speed_q8;
}

/* Part of the `missing_q8` until the steady speed that is gained or lost. */
static int64_t change_q8(int64_t missing_q8, bool is_gaining, uint32_t elapsed_us)
{
    const uint32_t rise_us = (elapsed_us < RISE_US) ? elapsed_us : RISE_US;
    const uint32_t fall_us = (elapsed_us < FALL_US) ? elapsed_us : FALL_US;
    return is_gaining ? fixed_divide_by(missing_q8 * (int64_t)rise_us, RISE_US)
                      : fixed_divide_by(missing_q8 * (int64_t)fall_us, FALL_US);
}

int64_t motor_model_run_q16(motor_model_t *self, const axis_config_t *config,
                            const card_drive_t *drive, uint32_t elapsed_us)
{
    const int64_t steady = steady_q8(config, drive);
    const bool goes_on = ((steady > 0) && (self->speed_ticks_per_s_q8 > 0)) ||
                         ((steady < 0) && (self->speed_ticks_per_s_q8 < 0));
    const int64_t before = goes_on ? self->speed_ticks_per_s_q8 : 0;
    const bool is_gaining = (steady > 0) ? (before <= steady) : (before >= steady);
    self->speed_ticks_per_s_q8 = before + change_q8(steady - before, is_gaining, elapsed_us);
    const int64_t mean_q8 = (before + self->speed_ticks_per_s_q8) / 2;
    return fixed_divide_by(mean_q8 * 4 * (int64_t)elapsed_us, US_PER_S / 64U);
}
