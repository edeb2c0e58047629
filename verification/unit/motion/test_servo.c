/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the request pushes towards the set-point, never harder than the axis' largest
 * word, never from one direction into the other without a rest, and brings a motor with rise time,
 * fall time and a late answer to rest within the deadband.
 */
#include "unity.h"

#include "card/card_frame.h"
#include "limits/requirement_limits.h"
#include "motion/motor_model.h"
#include "motion/profile.h"
#include "motion/servo.h"
#include "robot/robot_neuro.h"

#include <math.h>
#include <string.h>

#define CYCLE_US 1000U
#define FAR_TICKS 100000

/* A motor that gains speed with 15 ms, loses it with 1.5 ms, and hears of a drive after a few
 * cycles. */
#define DELAY_CYCLES 3U
#define SUBSTEPS 10U
#define SUBSTEP_S 0.0001
#define RISE_S 0.015
#define FALL_S 0.0015
#define SLOWEST_SHARE 0.1

static servo_t servo;

static const axis_config_t *const pwm = &robot_neuro.axes[NEURO_AXIS_INSERTION];
static const axis_config_t *const non_pwm = &robot_neuro.axes[NEURO_AXIS_PITCH];
static const axis_config_t *const inverted_non_pwm = &robot_neuro.axes[NEURO_AXIS_HEAD];

/* A non-pwm axis whose card takes the magnitudes of the needle's. */
static axis_config_t with_magnitudes(const axis_config_t *config)
{
    axis_config_t other = *config;

    other.minimum_duty = pwm->minimum_duty;
    other.maximum_duty = pwm->maximum_duty;
    other.gain_per_s = pwm->gain_per_s;
    return other;
}

static card_drive_t step(const axis_config_t *config, int32_t error_ticks)
{
    return servo_step(&servo, config, error_ticks, 0, CYCLE_US);
}

static card_drive_t step_late(const axis_config_t *config, int32_t error_ticks, uint32_t elapsed_us)
{
    return servo_step(&servo, config, error_ticks, 0, elapsed_us);
}

static bool is_off(const card_drive_t *drive)
{
    return (drive->mode == CARD_DRIVE_OFF) && (drive->direction == 0U) && (drive->duty == 0U);
}

static void expect_off(card_drive_t drive)
{
    TEST_ASSERT_TRUE(is_off(&drive));
}

static void expect_drive(card_drive_t drive, uint32_t mode, uint32_t direction, uint32_t duty)
{
    TEST_ASSERT_EQUAL_UINT32(mode, drive.mode);
    TEST_ASSERT_EQUAL_UINT32(direction, drive.direction);
    TEST_ASSERT_EQUAL_UINT32(duty, drive.duty);
}

void setUp(void)
{
    (void)memset(&servo, 0x5A, sizeof servo);
    servo_init(&servo);
}

void tearDown(void)
{
}

void test_SWR_AXIS_007_a_pwm_word_saturates_at_the_configured_maximum(void)
{
    expect_drive(step(pwm, FAR_TICKS), CARD_DRIVE_PWM, 1U, pwm->maximum_duty);
    expect_drive(step(pwm, INT32_MAX), CARD_DRIVE_PWM, 1U, pwm->maximum_duty);
    servo_init(&servo);
    expect_drive(step(pwm, -FAR_TICKS), CARD_DRIVE_PWM, 0U, pwm->maximum_duty);
    expect_drive(step(pwm, INT32_MIN), CARD_DRIVE_PWM, 0U, pwm->maximum_duty);
}

void test_SWR_AXIS_007_full_speed_is_the_largest_word_and_less_is_less(void)
{
    const int32_t full_q8 = pwm->full_speed_ticks_per_s * 256;

    expect_drive(servo_step(&servo, pwm, 0, full_q8, CYCLE_US), CARD_DRIVE_PWM, 1U,
                 pwm->maximum_duty);
    TEST_ASSERT_TRUE(servo_step(&servo, pwm, 0, full_q8 - 256, CYCLE_US).duty < pwm->maximum_duty);
    const uint32_t half = motor_model_duty(pwm, full_q8 / 2);
    expect_drive(servo_step(&servo, pwm, 0, full_q8 / 2, CYCLE_US), CARD_DRIVE_PWM, 1U, half);
}

void test_SWR_AXIS_007_a_motor_without_pwm_gets_no_duty(void)
{
    expect_drive(step(non_pwm, FAR_TICKS), CARD_DRIVE_NON_PWM, 1U, 0U);
    servo_init(&servo);
    expect_drive(step(non_pwm, -FAR_TICKS), CARD_DRIVE_NON_PWM, 0U, 0U);
}

void test_SWR_MOTION_022_a_card_without_pwm_that_takes_magnitudes_gets_them(void)
{
    const axis_config_t config = with_magnitudes(non_pwm);
    const int32_t half_q8 = config.full_speed_ticks_per_s * 128;

    expect_drive(step(&config, FAR_TICKS), CARD_DRIVE_NON_PWM, 1U, config.maximum_duty);
    expect_drive(servo_step(&servo, &config, 0, half_q8, CYCLE_US), CARD_DRIVE_NON_PWM, 1U,
                 motor_model_duty(&config, half_q8));
    servo_init(&servo);
    expect_drive(step(&config, -FAR_TICKS), CARD_DRIVE_NON_PWM, 0U, config.maximum_duty);
}

void test_SWR_AXIS_007_no_demand_makes_more_pulses_than_cycles(void)
{
    for (uint32_t i = 0U; i < 100U; i++) {
        expect_drive(step(non_pwm, INT32_MAX), CARD_DRIVE_NON_PWM, 1U, 0U);
    }
}

void test_SWR_AXIS_007_an_inverted_motor_has_its_direction_bit_the_other_way(void)
{
    const card_drive_t bit_0 = {CARD_DRIVE_NON_PWM, 0U, 0U, 0U};
    const card_drive_t bit_1 = {CARD_DRIVE_NON_PWM, 1U, 0U, 0U};

    expect_drive(step(inverted_non_pwm, FAR_TICKS), CARD_DRIVE_NON_PWM, 0U, 0U);
    servo_init(&servo);
    expect_drive(step(inverted_non_pwm, -FAR_TICKS), CARD_DRIVE_NON_PWM, 1U, 0U);
    TEST_ASSERT_TRUE(motor_model_is_upwards(inverted_non_pwm, &bit_0));
    TEST_ASSERT_FALSE(motor_model_is_upwards(inverted_non_pwm, &bit_1));
    TEST_ASSERT_TRUE(motor_model_is_upwards(non_pwm, &bit_1));
    TEST_ASSERT_FALSE(motor_model_is_upwards(non_pwm, &bit_0));
}

/* Number of cycles without drive after the error has changed its sign. */
static uint32_t dwell_cycles(const axis_config_t *config, int32_t error_ticks)
{
    uint32_t cycles = 0U;

    (void)step(config, error_ticks);
    card_drive_t drive = step(config, -error_ticks);
    while (is_off(&drive) && (cycles < 100U)) {
        cycles++;
        drive = step(config, -error_ticks);
    }
    return cycles;
}

void test_SWR_AXIS_008_a_reversal_takes_ten_milliseconds_without_drive(void)
{
    TEST_ASSERT_EQUAL_UINT32(LIMIT_REVERSAL_DWELL_US / CYCLE_US, dwell_cycles(pwm, FAR_TICKS));
    servo_init(&servo);
    TEST_ASSERT_EQUAL_UINT32(LIMIT_REVERSAL_DWELL_US / CYCLE_US, dwell_cycles(non_pwm, -FAR_TICKS));
}

void test_SWR_AXIS_008_one_microsecond_less_is_not_enough(void)
{
    (void)step(pwm, FAR_TICKS);
    expect_off(step(pwm, -FAR_TICKS));
    expect_off(step_late(pwm, -FAR_TICKS, LIMIT_REVERSAL_DWELL_US - 1U));
    expect_drive(step_late(pwm, -FAR_TICKS, 1U), CARD_DRIVE_PWM, 0U, pwm->maximum_duty);
}

void test_SWR_AXIS_008_the_time_of_the_last_driven_cycle_does_not_count(void)
{
    (void)step(pwm, FAR_TICKS);
    expect_off(step_late(pwm, -FAR_TICKS, LIMIT_REVERSAL_DWELL_US));
    expect_off(step_late(pwm, -FAR_TICKS, LIMIT_REVERSAL_DWELL_US - 1U));
}

void test_SWR_AXIS_008_the_time_at_rest_counts(void)
{
    (void)step(pwm, FAR_TICKS);
    servo_rest(&servo, CYCLE_US);
    servo_rest(&servo, LIMIT_REVERSAL_DWELL_US - 1U);
    expect_off(step_late(pwm, -FAR_TICKS, 0U));
    expect_drive(step_late(pwm, -FAR_TICKS, 1U), CARD_DRIVE_PWM, 0U, pwm->maximum_duty);
}

void test_SWR_AXIS_008_a_long_rest_does_not_wrap(void)
{
    (void)step(pwm, FAR_TICKS);
    servo_rest(&servo, CYCLE_US);
    servo_rest(&servo, UINT32_MAX - 1U);
    servo_rest(&servo, 1U);
    servo_rest(&servo, 1U);
    servo_rest(&servo, CYCLE_US);
    expect_drive(step(pwm, -FAR_TICKS), CARD_DRIVE_PWM, 0U, pwm->maximum_duty);
}

void test_SWR_AXIS_008_the_same_direction_goes_on_at_once(void)
{
    (void)step(pwm, FAR_TICKS);
    servo_rest(&servo, CYCLE_US);
    expect_drive(step(pwm, FAR_TICKS), CARD_DRIVE_PWM, 1U, pwm->maximum_duty);
}

void test_SWR_AXIS_008_a_direction_asked_for_but_not_driven_begins_no_dwell(void)
{
    (void)step(pwm, FAR_TICKS);
    expect_off(step(pwm, -FAR_TICKS));
    expect_drive(step(pwm, FAR_TICKS), CARD_DRIVE_PWM, 1U, pwm->maximum_duty);
}

void test_SWR_MOTION_021_a_lag_is_made_up_for_with_the_gain_of_the_axis(void)
{
    const int32_t speed = 10000;
    const int32_t lag_ticks = 30;
    axis_config_t config = *pwm;

    for (config.gain_per_s = 20U; config.gain_per_s <= 100U; config.gain_per_s += 40U) {
        const int32_t demand = speed + (lag_ticks * (int32_t)config.gain_per_s);
        servo_init(&servo);
        expect_drive(servo_step(&servo, &config, lag_ticks, speed * 256, CYCLE_US), CARD_DRIVE_PWM,
                     1U, motor_model_duty(&config, demand * 256));
    }
}

void test_SWR_MOTION_004_nothing_is_driven_within_the_deadband(void)
{
    for (int32_t error = -pwm->deadband_ticks; error <= pwm->deadband_ticks; error++) {
        for (uint32_t i = 0U; i < 1000U; i++) {
            expect_off(step(pwm, error));
        }
    }
}

static uint32_t driven_cycles(const axis_config_t *config, int32_t error_ticks, uint32_t cycles)
{
    uint32_t driven = 0U;

    for (uint32_t i = 0U; i < cycles; i++) {
        const card_drive_t drive = step(config, error_ticks);
        driven += is_off(&drive) ? 0U : 1U;
    }
    return driven;
}

void test_SWR_MOTION_004_one_tick_outside_of_the_deadband_is_driven_in_pulses(void)
{
    TEST_ASSERT_TRUE(driven_cycles(pwm, pwm->deadband_ticks + 1, 1000U) > 0U);
    servo_init(&servo);
    TEST_ASSERT_TRUE(driven_cycles(pwm, -pwm->deadband_ticks - 1, 1000U) > 0U);
    servo_init(&servo);
    TEST_ASSERT_TRUE(driven_cycles(non_pwm, 1, 1000U) > 0U);
}

/* Cycles of the first burst from rest. */
static uint32_t burst_cycles(const axis_config_t *config, int32_t error_ticks)
{
    uint32_t cycles = 0U;

    servo_init(&servo);
    card_drive_t drive = step(config, error_ticks);
    while (!is_off(&drive) && (cycles < 1000U)) {
        cycles++;
        drive = step(config, error_ticks);
    }
    return cycles;
}

/* Way of a motor `percent` as fast as its table says that runs for `cycles` from rest. */
static double way_of(const axis_config_t *config, uint32_t cycles, double percent)
{
    double speed = 0.0;
    double way = 0.0;

    for (uint32_t i = 0U; i < cycles * SUBSTEPS; i++) {
        speed += (config->full_speed_ticks_per_s * percent / 100.0 - speed) *
                 (1.0 - exp(-SUBSTEP_S / RISE_S));
        way += speed * SUBSTEP_S;
    }
    return way;
}

void test_SWR_MOTION_004_a_burst_takes_not_even_a_fast_motor_beyond_and_a_slow_one_on(void)
{
    const uint32_t cycles = burst_cycles(non_pwm, 1);
    TEST_ASSERT_TRUE(way_of(non_pwm, cycles, 120.0) <= 1.0);
    TEST_ASSERT_TRUE(way_of(non_pwm, cycles, 80.0) >= 0.1);
}

/* The request `way_ticks` before the set-point, after one driven cycle of `elapsed_us`. */
static card_drive_t after_cycle(const axis_config_t *config, int32_t way_ticks, uint32_t elapsed_us)
{
    servo_init(&servo);
    (void)step(config, FAR_TICKS);
    return step_late(config, way_ticks, elapsed_us);
}

void test_SWR_MOTION_020_a_motor_that_ran_on_in_a_late_cycle_is_stopped_in_time(void)
{
    const uint32_t late_us = 9000U;

    TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_NON_PWM, after_cycle(non_pwm, 1, CYCLE_US).mode);
    expect_off(after_cycle(non_pwm, 1, late_us));
    TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_PWM, after_cycle(pwm, 25, CYCLE_US).mode);
    expect_off(after_cycle(pwm, 25, late_us));
}

void test_SWR_MOTION_020_a_late_cycle_at_rest_changes_nothing(void)
{
    (void)step_late(non_pwm, 0, 9000U);
    TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_NON_PWM, step_late(non_pwm, 1, 9000U).mode);
}

void test_SWR_MOTION_004_a_slow_demand_of_a_pwm_motor_is_met_in_bursts_of_its_slowest_speed(void)
{
    const int32_t full_q8 = pwm->full_speed_ticks_per_s * 256;
    const int32_t slowest_q8 = full_q8 * 15 / 100;

    expect_off(servo_step(&servo, pwm, 0, slowest_q8 - 256, CYCLE_US));
    expect_drive(servo_step(&servo, pwm, 0, slowest_q8, CYCLE_US), CARD_DRIVE_PWM, 1U,
                 motor_model_duty(pwm, slowest_q8));
    expect_drive(step(pwm, pwm->deadband_ticks + 1), CARD_DRIVE_PWM, 1U,
                 motor_model_duty(pwm, slowest_q8));
}

void test_SWR_MOTION_004_a_moving_set_point_is_followed_within_the_deadband_too(void)
{
    const card_drive_t drive = servo_step(&servo, pwm, 1, 256 * 10000, CYCLE_US);

    TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_PWM, drive.mode);
    TEST_ASSERT_EQUAL_UINT32(1U, drive.direction);
}

void test_SWR_MOTION_004_an_axis_ahead_of_its_set_point_waits_for_it(void)
{
    expect_off(servo_step(&servo, pwm, -10, 256 * 600, CYCLE_US));
}

typedef struct {
    card_drive_t late[DELAY_CYCLES];
    double position_ticks;
    double speed_ticks_per_s;
} motor_t;

static double steady_speed(const axis_config_t *config, const card_drive_t *drive)
{
    double share = 0.0;

    if ((drive->mode != CARD_DRIVE_OFF) && (config->maximum_duty == 0U)) {
        share = 1.0;
    } else if (drive->mode != CARD_DRIVE_OFF) {
        share =
            SLOWEST_SHARE + ((1.0 - SLOWEST_SHARE) * ((double)drive->duty - config->minimum_duty) /
                             (config->maximum_duty - config->minimum_duty));
    }
    share = (share < SLOWEST_SHARE) ? 0.0 : share;
    return share * config->full_speed_ticks_per_s *
           (motor_model_is_upwards(config, drive) ? 1.0 : -1.0);
}

static void run_motor(motor_t *motor, const axis_config_t *config, const card_drive_t *drive)
{
    const double steady = steady_speed(config, &motor->late[DELAY_CYCLES - 1U]);

    for (uint32_t i = 0U; i < SUBSTEPS; i++) {
        const double time_s = (fabs(steady) > fabs(motor->speed_ticks_per_s)) ? RISE_S : FALL_S;
        motor->speed_ticks_per_s +=
            (steady - motor->speed_ticks_per_s) * (1.0 - exp(-SUBSTEP_S / time_s));
        motor->position_ticks += motor->speed_ticks_per_s * SUBSTEP_S;
    }
    for (uint32_t i = DELAY_CYCLES - 1U; i > 0U; i--) {
        motor->late[i] = motor->late[i - 1U];
    }
    motor->late[0] = *drive;
}

/* One cycle of one axis; the error that the servo saw. */
static int32_t run_axis(motor_t *motor, const axis_config_t *config, const profile_t *profile,
                        uint32_t axis)
{
    const int32_t error_ticks =
        profile_position_ticks(profile, axis) - (int32_t)floor(motor->position_ticks);
    const card_drive_t drive = servo_step(&servo, config, error_ticks,
                                          profile_speed_ticks_per_s_q8(profile, axis), CYCLE_US);

    run_motor(motor, config, &drive);
    return (error_ticks < 0) ? -error_ticks : error_ticks;
}

/* Moves `axis`, that is as `config` says, from `from` to `to`; it must be there two seconds after
 * the profile's end, and stay. */
static void expect_arrival(uint32_t axis, const axis_config_t *config, int32_t from, int32_t to)
{
    int32_t start[ROBOT_AXIS_MAX] = {0};
    int32_t end[ROBOT_AXIS_MAX] = {0};
    motor_t motor = {.position_ticks = from + 0.5};
    profile_t profile;

    start[axis] = from;
    end[axis] = to;
    servo_init(&servo);
    profile_plan(&profile, &robot_neuro, start, end, 100U);
    while (!profile_is_finished(&profile)) {
        TEST_ASSERT_TRUE(run_axis(&motor, config, &profile, axis) <= config->following_error_ticks);
        profile_step(&profile);
    }
    for (uint32_t i = 0U; i < 2000U; i++) {
        (void)run_axis(&motor, config, &profile, axis);
    }
    for (uint32_t i = 0U; i < 2000U; i++) {
        TEST_ASSERT_TRUE(run_axis(&motor, config, &profile, axis) <= config->deadband_ticks);
    }
}

static void expect_arrivals(uint32_t axis, const axis_config_t *config)
{
    const int32_t minimum = config->minimum_ticks;
    const int32_t maximum = config->maximum_ticks;
    const int32_t middle = minimum + (maximum - minimum) / 2;

    expect_arrival(axis, config, minimum, maximum);
    expect_arrival(axis, config, maximum, minimum);
    expect_arrival(axis, config, middle, middle + 1 + config->deadband_ticks);
    expect_arrival(axis, config, middle, middle - 1 - config->deadband_ticks);
    expect_arrival(axis, config, middle, middle + 20);
    expect_arrival(axis, config, middle, middle - 200);
}

static void expect_arrivals_with(card_type_t card_type, uint32_t axes)
{
    uint32_t checked = 0U;

    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        if (robot_neuro.axes[i].card_type == (uint8_t)card_type) {
            expect_arrivals(i, &robot_neuro.axes[i]);
            checked++;
        }
    }
    TEST_ASSERT_EQUAL_UINT32(axes, checked);
}

void test_SWR_MOTION_004_a_pwm_axis_comes_to_rest_within_its_deadband(void)
{
    expect_arrivals_with(CARD_TYPE_PWM, 3U);
}

void test_SWR_MOTION_004_a_non_pwm_axis_comes_to_rest_within_its_deadband(void)
{
    expect_arrivals_with(CARD_TYPE_NON_PWM, 4U);
}

void test_SWR_MOTION_022_an_axis_with_magnitudes_comes_to_rest_within_its_deadband(void)
{
    const uint32_t axes[] = {NEURO_AXIS_HEAD, NEURO_AXIS_FEET, NEURO_AXIS_LATERAL,
                             NEURO_AXIS_PITCH};

    for (uint32_t i = 0U; i < (sizeof axes / sizeof axes[0]); i++) {
        const axis_config_t config = with_magnitudes(&robot_neuro.axes[axes[i]]);
        expect_arrivals(axes[i], &config);
    }
}
