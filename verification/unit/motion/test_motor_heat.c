/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a motor loses speed and its resonance falls with each kelvin above that of its
 * table, up to the hottest that it may be; what a drive means and what is sent for it differ by
 * that alone.
 */
#include "motion/motor_heat.h"

#include "limits/requirement_limits.h"
#include "robot/robot_prostate.h"
#include "unity.h"

#define WORDS_PER_HZ 22009U
#define WARM_DC ((int32_t)LIMIT_MOTOR_TABLE_DC + 100)

static axis_config_t config;
static const card_drive_t off = {CARD_DRIVE_OFF, 0U, 0U, 0U};

void setUp(void)
{
    config = robot_prostate.axes[PROSTATE_AXIS_ROTATION];
}

void tearDown(void)
{
}

static card_drive_t wave(uint32_t word)
{
    return (card_drive_t){CARD_DRIVE_HIGH_FREQUENCY, 1U, word, 255U};
}

static uint32_t tuned(int32_t heat_dc, uint32_t word)
{
    const motor_heat_t heat = motor_heat_of(&config, heat_dc);
    card_drive_t drive = wave(word);
    motor_heat_tune(&heat, &drive);
    return drive.duty;
}

static int64_t left_of_a_thousand(motor_type_t type, int32_t heat_dc)
{
    config.motor_type = (uint8_t)type;
    return motor_heat_slow(motor_heat_of(&config, heat_dc).lost_q16, 1000);
}

void test_SWR_DRIVE_016_as_warm_as_its_table_a_motor_has_lost_nothing(void)
{
    for (int32_t heat_dc = -400; heat_dc <= (int32_t)LIMIT_MOTOR_TABLE_DC; heat_dc += 10) {
        TEST_ASSERT_EQUAL_UINT32(0U, motor_heat_of(&config, heat_dc).lost_q16);
        TEST_ASSERT_EQUAL_UINT32(0U, motor_heat_of(&config, heat_dc).shift_hz);
    }
    TEST_ASSERT_EQUAL_INT64(-12345, motor_heat_slow(0U, -12345));
}

void test_SWR_DRIVE_016_each_type_loses_its_share_for_each_kelvin(void)
{
    TEST_ASSERT_INT64_WITHIN(1, 960, left_of_a_thousand(MOTOR_TYPE_SHINSEI, WARM_DC));
    TEST_ASSERT_INT64_WITHIN(1, 990, left_of_a_thousand(MOTOR_TYPE_PIEZO, WARM_DC));
    TEST_ASSERT_INT64_WITHIN(1, 960, left_of_a_thousand(MOTOR_TYPE_DTI, WARM_DC));
}

void test_SWR_DRIVE_016_in_either_direction(void)
{
    const motor_heat_t heat = motor_heat_of(&config, WARM_DC);
    TEST_ASSERT_EQUAL_INT64(-motor_heat_slow(heat.lost_q16, 100000),
                            motor_heat_slow(heat.lost_q16, -100000));
}

void test_SWR_DRIVE_016_no_report_makes_a_motor_slower_than_the_hottest(void)
{
    const motor_heat_t hottest = motor_heat_of(&config, config.hottest_dc);
    const motor_heat_t absurd = motor_heat_of(&config, 32767);
    TEST_ASSERT_EQUAL_UINT32(hottest.lost_q16, absurd.lost_q16);
    TEST_ASSERT_EQUAL_UINT32(hottest.shift_hz, absurd.shift_hz);
    TEST_ASSERT_INT64_WITHIN(1, 880, motor_heat_slow(absurd.lost_q16, 1000));
}

void test_SWR_DRIVE_015_the_word_falls_by_20_hz_for_each_kelvin(void)
{
    TEST_ASSERT_EQUAL_UINT32(20U, config.resonance_hz_per_k);
    TEST_ASSERT_EQUAL_UINT32(config.maximum_duty, tuned(220, config.maximum_duty));
    TEST_ASSERT_EQUAL_UINT32(config.maximum_duty - 200U * WORDS_PER_HZ,
                             tuned(WARM_DC, config.maximum_duty));
    TEST_ASSERT_EQUAL_UINT32(config.minimum_duty - 600U * WORDS_PER_HZ,
                             tuned(32767, config.minimum_duty));
}

void test_SWR_DRIVE_015_no_word_falls_below_resonance(void)
{
    TEST_ASSERT_EQUAL_UINT32(LIMIT_RESONANCE_WORD, tuned(WARM_DC, LIMIT_RESONANCE_WORD + 5U));
    TEST_ASSERT_EQUAL_UINT32(LIMIT_RESONANCE_WORD, tuned(WARM_DC, LIMIT_RESONANCE_WORD));
}

static void expect_unchanged(const motor_heat_t *heat, const card_drive_t *meant)
{
    card_drive_t drive = *meant;
    motor_heat_tune(heat, &drive);
    TEST_ASSERT_EQUAL_MEMORY(meant, &drive, sizeof drive);
    motor_heat_untune(heat, &drive);
    TEST_ASSERT_EQUAL_MEMORY(meant, &drive, sizeof drive);
}

void test_SWR_DRIVE_015_what_was_meant_is_found_again(void)
{
    const motor_heat_t heat = motor_heat_of(&config, WARM_DC);
    const card_drive_t meant = wave(config.maximum_duty);
    card_drive_t drive = meant;
    motor_heat_tune(&heat, &drive);
    motor_heat_untune(&heat, &drive);
    TEST_ASSERT_EQUAL_MEMORY(&meant, &drive, sizeof meant);
}

void test_SWR_DRIVE_015_a_drive_that_is_off_or_without_waves_is_sent_as_it_is(void)
{
    const axis_config_t *const insertion = &robot_prostate.axes[PROSTATE_AXIS_INSERTION];
    const motor_heat_t heat = motor_heat_of(&config, WARM_DC);
    const motor_heat_t other = motor_heat_of(insertion, WARM_DC);
    const card_drive_t pwm = {CARD_DRIVE_PWM, 1U, insertion->minimum_duty, 0U};
    expect_unchanged(&heat, &off);
    expect_unchanged(&other, &pwm);
}
