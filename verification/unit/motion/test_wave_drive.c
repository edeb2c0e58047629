/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: an axis on a high-frequency card is driven by words of which the smaller is the
 * faster, never outside its own, and goes where its model goes.
 */
#include "unity.h"

#include "card/card_frame.h"
#include "limits/requirement_limits.h"
#include "motion/motor_model.h"
#include "motion/servo.h"
#include "robot/robot_prostate.h"
#include "sim/model/sim_motor.h"

#define CYCLE_US 1000U
#define FAR_TICKS 100000
#define WORDS_PER_KHZ 22009000.0

static const axis_config_t *const rotation = &robot_prostate.axes[PROSTATE_AXIS_ROTATION];
static servo_t servo;
static sim_motor_t motor;

void setUp(void)
{
    servo_init(&servo);
    sim_motor_init(&motor, rotation, 0.0, 0.0);
}

void tearDown(void)
{
}

static card_drive_t wave(uint32_t direction, double khz)
{
    return (card_drive_t){CARD_DRIVE_HIGH_FREQUENCY, direction,
                          (uint32_t)(khz * WORDS_PER_KHZ + 0.5), rotation->amplitude};
}

static int64_t full_q8(void)
{
    return (int64_t)rotation->full_speed_ticks_per_s * 256;
}

void test_SWR_DRIVE_005_the_word_falls_as_the_speed_grows(void)
{
    uint32_t before = UINT32_MAX;
    for (int64_t percent = 11; percent <= 99; percent++) {
        const uint32_t word = motor_model_duty(rotation, full_q8() * percent / 100);
        TEST_ASSERT_LESS_THAN_UINT32(before, word);
        before = word;
    }
}

void test_SWR_DRIVE_005_the_word_of_any_speed_is_one_of_the_axis(void)
{
    TEST_ASSERT_EQUAL_UINT32(1151907042U, rotation->minimum_duty); /* 52.338 kHz */
    TEST_ASSERT_EQUAL_UINT32(1119421758U, rotation->maximum_duty); /* 50.862 kHz */
    TEST_ASSERT_EQUAL_UINT32(rotation->minimum_duty, motor_model_duty(rotation, INT32_MIN));
    TEST_ASSERT_EQUAL_UINT32(rotation->minimum_duty, motor_model_duty(rotation, 0));
    TEST_ASSERT_EQUAL_UINT32(rotation->maximum_duty, motor_model_duty(rotation, full_q8()));
    TEST_ASSERT_EQUAL_UINT32(rotation->maximum_duty, motor_model_duty(rotation, 9 * full_q8()));
}

void test_SWR_DRIVE_005_the_speed_of_a_word_is_the_one_that_it_was_chosen_for(void)
{
    for (int64_t percent = 11; percent <= 100; percent++) {
        const int64_t speed_q8 = full_q8() * percent / 100;
        card_drive_t drive = wave(1U, 0.0);
        drive.duty = motor_model_duty(rotation, speed_q8);
        TEST_ASSERT_INT64_WITHIN(full_q8() / 500, speed_q8,
                                 motor_model_steady_q8(rotation, &drive));
    }
}

void test_SWR_SWEEP_009_in_the_dead_zone_no_speed_is_known(void)
{
    const card_drive_t unknown = wave(1U, 52.359);
    const card_drive_t slow = wave(1U, 52.357);
    const card_drive_t fast = wave(1U, 45.0);
    card_drive_t slowest = slow;
    motor_model_t model = {.speed_ticks_per_s_q8 = 0};
    slowest.duty = rotation->minimum_duty;
    TEST_ASSERT_EQUAL_INT64(0, motor_model_steady_q8(rotation, &unknown));
    TEST_ASSERT_EQUAL_INT64(0, motor_model_step_q16(&model, rotation, &unknown, CYCLE_US));
    TEST_ASSERT_EQUAL_INT64(motor_model_steady_q8(rotation, &slowest),
                            motor_model_steady_q8(rotation, &slow));
    TEST_ASSERT_GREATER_THAN_INT64(full_q8() / 10, motor_model_steady_q8(rotation, &slow));
    TEST_ASSERT_EQUAL_INT64(full_q8(), motor_model_steady_q8(rotation, &fast));
}

static void expect_drive(card_drive_t drive, uint32_t direction, uint32_t duty)
{
    TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_HIGH_FREQUENCY, drive.mode);
    TEST_ASSERT_EQUAL_UINT32(direction, drive.direction);
    TEST_ASSERT_EQUAL_UINT32(duty, drive.duty);
    TEST_ASSERT_EQUAL_UINT32(rotation->amplitude, drive.amplitude);
}

void test_SWR_DRIVE_005_the_servo_asks_for_the_fastest_word_and_no_smaller_one(void)
{
    expect_drive(servo_step(&servo, rotation, FAR_TICKS, 0, CYCLE_US), 1U, rotation->maximum_duty);
    servo_init(&servo);
    expect_drive(servo_step(&servo, rotation, -FAR_TICKS, 0, CYCLE_US), 0U, rotation->maximum_duty);
    servo_init(&servo);
    for (int32_t error = -200; error <= 200; error++) {
        const card_drive_t drive = servo_step(&servo, rotation, error, 0, CYCLE_US);
        if (drive.mode != (uint32_t)CARD_DRIVE_OFF) {
            TEST_ASSERT_LESS_OR_EQUAL_UINT32(rotation->minimum_duty, drive.duty);
            TEST_ASSERT_GREATER_OR_EQUAL_UINT32(rotation->maximum_duty, drive.duty);
        }
    }
}

static uint32_t dwell_cycles(const axis_config_t *config)
{
    uint32_t cycles = 0U;
    servo_init(&servo);
    (void)servo_step(&servo, config, FAR_TICKS, 0, CYCLE_US);
    while (servo_step(&servo, config, -FAR_TICKS, 0, CYCLE_US).mode == (uint32_t)CARD_DRIVE_OFF) {
        cycles++;
    }
    return cycles;
}

void test_SWR_DRIVE_007_a_motor_rests_as_long_as_its_type_needs(void)
{
    axis_config_t config = *rotation;
    TEST_ASSERT_EQUAL_UINT32(LIMIT_SHINSEI_REVERSAL_DWELL_MS, rotation->reversal_dwell_ms);
    TEST_ASSERT_EQUAL_UINT32(LIMIT_SHINSEI_REVERSAL_DWELL_MS, dwell_cycles(&config));
    config.reversal_dwell_ms = LIMIT_DTI_REVERSAL_DWELL_MS;
    TEST_ASSERT_EQUAL_UINT32(LIMIT_DTI_REVERSAL_DWELL_MS, dwell_cycles(&config));
}

static double steady(uint32_t direction, double khz)
{
    const card_drive_t drive = wave(direction, khz);
    return sim_motor_steady_speed(&motor, &drive);
}

static double turns(double turns_a_minute)
{
    return turns_a_minute * rotation->full_speed_ticks_per_s / 139.8;
}

void test_SWR_DRIVE_009_the_motor_has_the_published_speed_of_each_direction(void)
{
    TEST_ASSERT_DOUBLE_WITHIN(turns(0.2), turns(141.4), steady(1U, 50.862));
    TEST_ASSERT_DOUBLE_WITHIN(turns(0.2), -turns(138.2), steady(0U, 50.862));
    TEST_ASSERT_DOUBLE_WITHIN(turns(0.02), turns(1.459), steady(1U, 53.077));
    TEST_ASSERT_DOUBLE_WITHIN(turns(0.02), -turns(3.222), steady(0U, 53.077));
    TEST_ASSERT_DOUBLE_WITHIN(turns(0.5), turns(397.8), steady(1U, 50.1));
}

void test_SWR_DRIVE_009_the_motor_stands_in_its_dead_zone_and_below_resonance(void)
{
    TEST_ASSERT_EQUAL_DOUBLE(0.0, steady(1U, 54.4));
    TEST_ASSERT_EQUAL_DOUBLE(0.0, steady(0U, 55.0));
    TEST_ASSERT_EQUAL_DOUBLE(0.0, steady(1U, 49.4));
    TEST_ASSERT_TRUE(steady(1U, 49.6) > 0.0);
}

void test_SWR_DRIVE_009_less_amplitude_is_less_speed(void)
{
    card_drive_t drive = wave(1U, 51.0);
    const double whole = sim_motor_steady_speed(&motor, &drive);
    drive.amplitude = 51U;
    TEST_ASSERT_DOUBLE_WITHIN(0.01, whole / 5.0, sim_motor_steady_speed(&motor, &drive));
}

void test_SWR_BOX_011_the_resonance_of_a_warm_motor_is_20_hz_lower_for_each_kelvin(void)
{
    const double cold = steady(1U, 51.2);
    motor.temperature_c = 45.0;
    TEST_ASSERT_DOUBLE_WITHIN(cold / 1000.0, cold * 0.92, steady(1U, 50.8));
    TEST_ASSERT_DOUBLE_WITHIN(cold / 10.0, cold * 0.55, steady(1U, 51.2));
    TEST_ASSERT_TRUE(steady(1U, 49.2) > 0.0);
    TEST_ASSERT_EQUAL_DOUBLE(0.0, steady(1U, 49.0));
}

void test_SWR_BOX_010_a_motor_by_waves_grows_warmer_than_by_its_driver(void)
{
    TEST_ASSERT_EQUAL_DOUBLE(30.0, motor.heat.settled_c);
    TEST_ASSERT_EQUAL_DOUBLE(
        25.0, sim_motor_heat(&robot_prostate.axes[PROSTATE_AXIS_INSERTION]).settled_c);
}

void test_SWR_AXIS_019_the_model_goes_where_a_motor_with_waves_goes(void)
{
    for (uint32_t direction = 0U; direction <= 1U; direction++) {
        for (int64_t percent = 20; percent <= 100; percent += 20) {
            motor_model_t model = {0};
            double way = 0.0;
            card_drive_t drive = wave(direction, 0.0);
            drive.duty = motor_model_duty(rotation, full_q8() * percent / 100);
            setUp();
            motor.lowest_ticks = -1e9;
            motor.highest_ticks = 1e9;
            for (uint32_t us = 0U; us < 400000U; us += SIM_STEP_US) {
                if ((us % CYCLE_US) == 0U) {
                    way +=
                        (double)motor_model_step_q16(&model, rotation, &drive, CYCLE_US) / 65536.0;
                }
                sim_motor_step(&motor, &drive, true);
            }
            TEST_ASSERT_DOUBLE_WITHIN(0.05 * (way < 0.0 ? -way : way), way, motor.position_ticks);
        }
    }
}
