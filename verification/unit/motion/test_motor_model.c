/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: the model makes the way that the motor of the simulated box makes, at any word.
 */
#include "unity.h"

#include "card/card_frame.h"
#include "motion/motor_model.h"
#include "robot/robot_neuro.h"
#include "sim/model/sim_motor.h"

#define CYCLE_US 1000U

static motor_model_t model;
static sim_motor_t motor;
static double way_ticks;

void setUp(void)
{
}

void tearDown(void)
{
}

static void start(const axis_config_t *config)
{
    model = (motor_model_t){0};
    way_ticks = 0.0;
    sim_motor_init(&motor, config, 0.0, 0.0);
    motor.lowest_ticks = -1e9;
    motor.highest_ticks = 1e9;
}

/* Drives both for so many cycles. */
static void run(const axis_config_t *config, card_drive_t drive, uint32_t cycles)
{
    for (uint32_t i = 0U; i < cycles; i++) {
        way_ticks += (double)motor_model_step_q16(&model, config, &drive, CYCLE_US) / 65536.0;
        for (uint32_t us = 0U; us < CYCLE_US; us += SIM_STEP_US) {
            sim_motor_step(&motor, &drive, true);
        }
    }
}

static void expect_one_way(double within_share)
{
    const double way = motor.position_ticks;
    TEST_ASSERT_DOUBLE_WITHIN(((way < 0.0) ? -way : way) * within_share, way, way_ticks);
    TEST_ASSERT_TRUE(way != 0.0);
}

static int64_t steady_q8(const axis_config_t *config, uint32_t duty)
{
    const card_drive_t drive = {CARD_DRIVE_PWM, 1U, duty, 0U};
    return motor_model_steady_q8(config, &drive);
}

void test_SWR_AXIS_019_the_model_goes_where_the_motor_goes(void)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const axis_config_t *const config = &robot_neuro.axes[i];
        const bool is_pwm = config->card_type == (uint8_t)CARD_TYPE_PWM;
        const uint32_t duty = (config->minimum_duty + config->maximum_duty) / 2U;
        card_drive_t drive = {is_pwm ? CARD_DRIVE_PWM : CARD_DRIVE_NON_PWM, 1U, is_pwm ? duty : 0U,
                              0U};
        start(config);
        run(config, drive, 30U);
        expect_one_way(0.05);
        run(config, (card_drive_t){CARD_DRIVE_OFF, 0U, 0U, 0U}, 20U);
        drive.direction = 0U;
        run(config, drive, 200U);
        expect_one_way(0.05);
    }
}

void test_SWR_AXIS_019_a_reversal_without_rest_begins_anew(void)
{
    const axis_config_t *const config = &robot_neuro.axes[NEURO_AXIS_PITCH];
    start(config);
    run(config, (card_drive_t){CARD_DRIVE_NON_PWM, 1U, 0U, 0U}, 100U);
    const int64_t way_q16 = motor_model_step_q16(
        &model, config, &(card_drive_t){CARD_DRIVE_NON_PWM, 0U, 0U, 0U}, CYCLE_US);
    TEST_ASSERT_TRUE(way_q16 < 0);
    run(config, (card_drive_t){CARD_DRIVE_NON_PWM, 0U, 0U, 0U}, 100U);
    TEST_ASSERT_TRUE(motor_model_step_q16(&model, config,
                                          &(card_drive_t){CARD_DRIVE_NON_PWM, 1U, 0U, 0U},
                                          CYCLE_US) > 0);
}

void test_SWR_AXIS_019_the_model_loses_speed_faster_than_it_gains_it(void)
{
    const axis_config_t *const config = &robot_neuro.axes[NEURO_AXIS_INSERTION];
    const int64_t full_q8 = (int64_t)config->full_speed_ticks_per_s * 256;
    for (uint32_t direction = 0U; direction <= 1U; direction++) {
        const card_drive_t fast = {CARD_DRIVE_PWM, direction, config->maximum_duty, 0U};
        const card_drive_t slow = {CARD_DRIVE_PWM, direction, config->minimum_duty, 0U};
        const int64_t sign = motor_model_is_upwards(config, &slow) ? 1 : -1;
        start(config);
        run(config, fast, 5U);
        TEST_ASSERT_LESS_THAN_INT64(full_q8 / 2, sign * model.speed_ticks_per_s_q8);
        run(config, fast, 100U);
        run(config, slow, 5U);
        TEST_ASSERT_INT64_WITHIN(full_q8 / 50, full_q8 / 10, sign * model.speed_ticks_per_s_q8);
    }
}

void test_SWR_AXIS_019_the_model_goes_where_a_slowed_motor_goes(void)
{
    const axis_config_t *const config = &robot_neuro.axes[NEURO_AXIS_INSERTION];
    start(config);
    for (uint32_t i = 0U; i < 20U; i++) {
        run(config, (card_drive_t){CARD_DRIVE_PWM, 1U, config->maximum_duty, 0U}, 30U);
        run(config, (card_drive_t){CARD_DRIVE_PWM, 1U, config->minimum_duty, 0U}, 30U);
    }
    expect_one_way(0.03);
}

void test_SWR_AXIS_019_below_its_smallest_word_the_model_stands_as_the_motor_does(void)
{
    const axis_config_t *const config = &robot_neuro.axes[NEURO_AXIS_INSERTION];
    const card_drive_t fast = {CARD_DRIVE_PWM, 1U, config->maximum_duty, 0U};
    const uint32_t words[] = {0U, 1U, config->minimum_duty / 2U, config->minimum_duty - 1U};
    for (uint32_t i = 0U; i < (sizeof words / sizeof words[0]); i++) {
        start(config);
        run(config, (card_drive_t){CARD_DRIVE_PWM, 1U, words[i], 0U}, 100U);
        TEST_ASSERT_TRUE(motor.position_ticks == 0.0);
        TEST_ASSERT_TRUE(way_ticks == 0.0);
        run(config, fast, 100U);
        run(config, (card_drive_t){CARD_DRIVE_PWM, 1U, words[i], 0U}, 1U);
        TEST_ASSERT_EQUAL_INT64(0, model.speed_ticks_per_s_q8);
    }
}

void test_SWR_AXIS_019_the_smallest_word_is_the_slowest_speed_and_the_largest_saturates(void)
{
    const axis_config_t *const config = &robot_neuro.axes[NEURO_AXIS_INSERTION];
    const int64_t full_q8 = (int64_t)config->full_speed_ticks_per_s * 256;
    TEST_ASSERT_EQUAL_INT64(full_q8 / 10, steady_q8(config, config->minimum_duty));
    TEST_ASSERT_EQUAL_INT64(full_q8, steady_q8(config, config->maximum_duty));
    TEST_ASSERT_EQUAL_INT64(full_q8, steady_q8(config, config->maximum_duty + 1U));
    TEST_ASSERT_EQUAL_INT64(full_q8, steady_q8(config, UINT32_MAX));
}

/* The dead zone is narrow at first, and at last wide with few words above it. */
void test_SWR_AXIS_019_a_word_that_grows_is_never_slower_and_never_beyond_full_speed(void)
{
    axis_config_t config = robot_neuro.axes[NEURO_AXIS_INSERTION];
    const int64_t full_q8 = (int64_t)config.full_speed_ticks_per_s * 256;
    const uint32_t least[] = {1U, 13107U, 65536U, 131070U};
    for (uint32_t i = 0U; i < (sizeof least / sizeof least[0]); i++) {
        int64_t before_q8 = 0;
        config.minimum_duty = least[i];
        for (uint32_t duty = 0U; duty <= (config.maximum_duty + 10U); duty++) {
            const int64_t speed_q8 = steady_q8(&config, duty);
            TEST_ASSERT_TRUE((speed_q8 >= before_q8) && (speed_q8 <= full_q8));
            before_q8 = speed_q8;
        }
    }
}

void test_SWR_AXIS_019_a_late_cycle_ends_at_the_steady_speed(void)
{
    const axis_config_t *const config = &robot_neuro.axes[NEURO_AXIS_PITCH];
    start(config);
    (void)motor_model_step_q16(&model, config, &(card_drive_t){CARD_DRIVE_NON_PWM, 1U, 0U, 0U},
                               1000000U);
    TEST_ASSERT_EQUAL_INT64(256 * (int64_t)config->full_speed_ticks_per_s,
                            model.speed_ticks_per_s_q8);
}

void test_SWR_MOTION_004_the_word_for_a_speed_settles_to_it(void)
{
    const axis_config_t *const config = &robot_neuro.axes[NEURO_AXIS_INSERTION];
    for (int32_t percent = 10; percent <= 100; percent += 5) {
        const int64_t speed_q8 = (int64_t)config->full_speed_ticks_per_s * 256 * percent / 100;
        start(config);
        run(config, (card_drive_t){CARD_DRIVE_PWM, 1U, motor_model_duty(config, speed_q8), 0U},
            300U);
        TEST_ASSERT_DOUBLE_WITHIN(2.0, (double)speed_q8 / 256.0, motor.speed_ticks_per_s);
    }
}

void test_SWR_MOTION_022_the_model_goes_where_a_motor_with_magnitudes_but_without_pwm_goes(void)
{
    axis_config_t config = robot_neuro.axes[NEURO_AXIS_PITCH];
    config.minimum_duty = 6144U;
    config.maximum_duty = 61439U;
    for (int32_t percent = 10; percent <= 100; percent += 30) {
        const int64_t speed_q8 = (int64_t)config.full_speed_ticks_per_s * 256 * percent / 100;
        const uint32_t duty = motor_model_duty(&config, speed_q8);
        start(&config);
        run(&config, (card_drive_t){CARD_DRIVE_NON_PWM, 1U, duty, 0U}, 200U);
        expect_one_way(0.05);
        TEST_ASSERT_INT64_WITHIN(512, speed_q8, model.speed_ticks_per_s_q8);
    }
}

void test_SWR_AXIS_007_the_word_for_a_speed_stays_between_the_smallest_and_the_largest(void)
{
    const axis_config_t *const config = &robot_neuro.axes[NEURO_AXIS_INSERTION];
    const int64_t full_q8 = (int64_t)config->full_speed_ticks_per_s * 256;
    TEST_ASSERT_EQUAL_UINT32(config->minimum_duty, motor_model_duty(config, 0));
    TEST_ASSERT_EQUAL_UINT32(config->maximum_duty, motor_model_duty(config, 2 * full_q8));
}
