/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: an axis drives only while enabled and without fault, not into its switch nor
 * beyond its limits, and gives up when it falls behind.
 */
#include "unity.h"

#include "axis/axis.h"
#include "axis/supervision.h"
#include "card/card_frame.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"

#include "unit/support/axis_world.h"

#include <stddef.h>

void setUp(void)
{
    use(with_upper_switch);
}

void tearDown(void)
{
}

void test_SWR_AXIS_001_an_axis_starts_disabled_and_without_home(void)
{
    axis_init(&axis);
    TEST_ASSERT_FALSE(axis_is_enabled(&axis));
    TEST_ASSERT_FALSE(axis_is_faulty(&axis));
    TEST_ASSERT_FALSE(axis_is_homed(&axis));
    TEST_ASSERT_FALSE(axis_is_homing(&axis));
}

void test_SWR_AXIS_001_enabling_is_refused_while_the_cause_of_a_fault_is_there(void)
{
    axis_init(&axis);
    axis_enable(&axis, true);
    TEST_ASSERT_FALSE(axis_is_enabled(&axis));
    axis_enable(&axis, false);
    TEST_ASSERT_TRUE(axis_is_enabled(&axis));
}

void test_SWR_AXIS_001_a_faulty_axis_is_enabled_only_when_the_cause_is_gone(void)
{
    setpoint_ticks = config->following_error_ticks + 1;
    (void)driven_cycle(0);
    TEST_ASSERT_TRUE(axis_is_faulty(&axis));
    axis_enable(&axis, true);
    TEST_ASSERT_TRUE(axis_is_faulty(&axis));
    TEST_ASSERT_FALSE(axis_is_enabled(&axis));
    axis_enable(&axis, false);
    TEST_ASSERT_FALSE(axis_is_faulty(&axis));
    TEST_ASSERT_TRUE(axis_is_enabled(&axis));
}

static card_drive_t drive_up(void)
{
    return (card_drive_t){CARD_DRIVE_PWM, (config->is_motor_inverted != 0U) ? 0U : 1U, 0U, 0U};
}

static card_drive_t drive_down(void)
{
    return (card_drive_t){CARD_DRIVE_PWM, (config->is_motor_inverted != 0U) ? 1U : 0U, 0U, 0U};
}

static void expect_switch_blocks(bool blocks_up, bool blocks_down)
{
    const card_drive_t up = drive_up();
    const card_drive_t down = drive_down();
    const card_drive_t off = {CARD_DRIVE_OFF, 0U, 0U, 0U};

    TEST_ASSERT_EQUAL(blocks_up, axis_is_towards_switch(&axis, config, &up));
    TEST_ASSERT_EQUAL(blocks_down, axis_is_towards_switch(&axis, config, &down));
    TEST_ASSERT_FALSE(axis_is_towards_switch(&axis, config, &off));
}

void test_SWR_AXIS_005_a_switch_that_is_not_active_blocks_nothing(void)
{
    expect_switch_blocks(false, false);
    (void)observe_switch(true);
    (void)observe_switch(false);
    expect_switch_blocks(false, false);
}

void test_SWR_AXIS_005_an_upper_switch_blocks_upwards_only(void)
{
    (void)observe_switch(true);
    expect_switch_blocks(true, false);
    use(inverted);
    (void)observe_switch(true);
    expect_switch_blocks(true, false);
}

void test_SWR_AXIS_005_a_lower_switch_blocks_downwards_only(void)
{
    use(with_lower_switch);
    (void)observe_switch(true);
    expect_switch_blocks(false, true);
}

void test_SWR_AXIS_005_an_axis_without_switch_is_not_blocked_by_a_stray_bit(void)
{
    use(without_switch);
    (void)observe_switch(true);
    expect_switch_blocks(false, false);
}

void test_SWR_AXIS_005_a_switch_stays_active_while_no_report_comes(void)
{
    (void)observe_switch(true);
    TEST_ASSERT_EQUAL_HEX32(0U, axis_observe(&axis, config, NULL, CYCLE_US));
    expect_switch_blocks(true, false);
}

static void expect_limit_blocks(bool blocks_up, bool blocks_down)
{
    const card_drive_t up = drive_up();
    const card_drive_t down = drive_down();
    const card_drive_t off = {CARD_DRIVE_OFF, 0U, 0U, 0U};

    TEST_ASSERT_EQUAL(blocks_up, axis_is_beyond_limit(&axis, config, &up));
    TEST_ASSERT_EQUAL(blocks_down, axis_is_beyond_limit(&axis, config, &down));
    TEST_ASSERT_FALSE(axis_is_beyond_limit(&axis, config, &off));
}

void test_SWR_AXIS_004_a_homed_axis_is_not_driven_further_at_or_beyond_a_soft_limit(void)
{
    use(without_switch);
    home_in_place();
    expect_limit_blocks(false, false);
    move_to(config->maximum_ticks - 1);
    expect_limit_blocks(false, false);
    move_to(config->maximum_ticks);
    expect_limit_blocks(true, false);
    move_to(config->maximum_ticks + 100);
    expect_limit_blocks(true, false);
    move_to(config->minimum_ticks + 1);
    expect_limit_blocks(false, false);
    move_to(config->minimum_ticks);
    expect_limit_blocks(false, true);
    move_to(config->minimum_ticks - 100);
    expect_limit_blocks(false, true);
}

void test_SWR_AXIS_006_an_axis_not_homed_knows_no_soft_limits(void)
{
    use(without_switch);
    move_to(config->maximum_ticks + 1);
    expect_limit_blocks(false, false);
}

void test_SWR_AXIS_006_an_axis_that_lost_its_reference_is_not_homed(void)
{
    use(without_switch);
    home_in_place();
    axis_lose_reference(&axis);
    TEST_ASSERT_FALSE(axis_is_homed(&axis));
    TEST_ASSERT_TRUE(axis_is_enabled(&axis));
}

void test_SWR_AXIS_007_following_asks_for_no_more_than_the_largest_word(void)
{
    use(with_lower_switch);
    const card_drive_t drive =
        axis_follow(&axis, config, config->maximum_ticks, INT32_MAX, CYCLE_US);
    TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_PWM, drive.mode);
    TEST_ASSERT_EQUAL_UINT32(config->maximum_duty, drive.duty);
}

void test_SWR_AXIS_008_the_time_at_rest_is_part_of_the_dwell(void)
{
    use(with_lower_switch);
    (void)axis_follow(&axis, config, 1000, 0, CYCLE_US);
    card_drive_t drive = axis_rest(&axis, CYCLE_US);
    TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_OFF, drive.mode);
    (void)axis_rest(&axis, LIMIT_REVERSAL_DWELL_US - 1U);
    drive = axis_follow(&axis, config, -1000, 0, 0U);
    TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_OFF, drive.mode);
    drive = axis_follow(&axis, config, -1000, 0, 1U);
    TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_PWM, drive.mode);
}

void test_SWR_AXIS_009_a_following_error_at_the_limit_is_tolerated(void)
{
    setpoint_ticks = config->following_error_ticks;
    TEST_ASSERT_EQUAL_HEX32(0U, driven_cycle(0));
    setpoint_ticks = -config->following_error_ticks;
    TEST_ASSERT_EQUAL_HEX32(0U, driven_cycle(0));
    TEST_ASSERT_TRUE(axis_is_enabled(&axis));
}

void test_SWR_AXIS_009_a_following_error_above_the_limit_is_a_fault(void)
{
    setpoint_ticks = config->following_error_ticks + 1;
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_FOLLOWING_ERROR, driven_cycle(0));
    TEST_ASSERT_TRUE(axis_is_faulty(&axis));
    TEST_ASSERT_FALSE(axis_is_enabled(&axis));
    use(with_lower_switch);
    setpoint_ticks = -config->following_error_ticks - 1;
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_FOLLOWING_ERROR, driven_cycle(0));
    TEST_ASSERT_TRUE(axis_is_faulty(&axis));
}

void test_SWR_AXIS_009_the_error_is_that_of_the_position_of_this_cycle(void)
{
    setpoint_ticks = config->following_error_ticks + 1;
    TEST_ASSERT_EQUAL_HEX32(0U, driven_cycle(1));
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_FOLLOWING_ERROR, driven_cycle(-1));
}

/* The needle: 167 ticks and 20 ms of its speed. */
void test_SWR_AXIS_021_a_faster_axis_may_lag_more(void)
{
    const axis_config_t *const needle = &robot_neuro.axes[NEURO_AXIS_INSERTION];
    const int32_t speed_q8 = needle->speed_ticks_per_s * 256;
    const int32_t most = needle->following_error_ticks +
                         ((needle->speed_ticks_per_s * needle->following_time_ms) / 1000);
    const card_drive_t off = {0};
    const axis_sample_t sample = {.applied = &off, .elapsed_us = CYCLE_US, .is_timed = true};
    axis_enable(&axis, false);
    (void)axis_follow(&axis, needle, most, -speed_q8, CYCLE_US);
    TEST_ASSERT_EQUAL_HEX32(0U, axis_supervise(&axis, needle, true, &sample));
    (void)axis_follow(&axis, needle, most, speed_q8 / 2, CYCLE_US);
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_FOLLOWING_ERROR,
                            axis_supervise(&axis, needle, true, &sample));
}

void test_SWR_AXIS_009_an_axis_that_is_not_driven_has_no_following_error(void)
{
    (void)axis_follow(&axis, config, config->following_error_ticks + 1, 0, CYCLE_US);
    TEST_ASSERT_EQUAL_HEX32(0U, supervise(false, CYCLE_US));
    TEST_ASSERT_TRUE(axis_is_enabled(&axis));
}

void test_SWR_AXIS_009_a_following_error_ends_the_homing(void)
{
    begin_homing();
    setpoint_ticks = config->following_error_ticks + 1;
    (void)driven_cycle(0);
    TEST_ASSERT_FALSE(axis_is_homing(&axis));
}

void test_SWR_AXIS_009_at_rest_the_set_point_is_the_position(void)
{
    setpoint_ticks = 50;
    (void)driven_cycle(-7);
    const card_drive_t drive = axis_rest(&axis, CYCLE_US);
    TEST_ASSERT_EQUAL_UINT32(0U, drive.mode | drive.direction | drive.duty);
    TEST_ASSERT_EQUAL_INT32(-7, axis.sealed.setpoint_ticks);
    TEST_ASSERT_EQUAL_INT32(0, axis.sealed.setpoint_speed_ticks_per_s_q8);
}

void test_SWR_MOTION_004_an_axis_is_at_a_target_within_its_deadband(void)
{
    const int32_t deadband = with_lower_switch->deadband_ticks;

    use(with_lower_switch);
    TEST_ASSERT_TRUE(deadband > 0);
    TEST_ASSERT_TRUE(axis_is_at(&axis, config, deadband));
    TEST_ASSERT_TRUE(axis_is_at(&axis, config, -deadband));
    TEST_ASSERT_FALSE(axis_is_at(&axis, config, deadband + 1));
    TEST_ASSERT_FALSE(axis_is_at(&axis, config, -deadband - 1));
    TEST_ASSERT_FALSE(axis_is_at(&axis, config, INT32_MIN));
}

void test_SWR_ENC_002_a_position_that_cannot_be_trusted_faults_the_axis(void)
{
    use(without_switch);
    home_in_place();
    TEST_ASSERT_EQUAL_HEX32(0U, observe_way(config->jump_ticks + 1));
    TEST_ASSERT_TRUE(axis_is_enabled(&axis));
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_ENCODER_FAULT, observe_way(0));
    TEST_ASSERT_TRUE(axis_is_faulty(&axis));
    TEST_ASSERT_FALSE(axis_is_homed(&axis));
}

void test_SWR_CORE_004_a_damaged_axis_chart_leads_to_a_fault_without_home(void)
{
    use(without_switch);
    home_in_place();
    axis.chart.power_inverse ^= 4U;
    TEST_ASSERT_TRUE(axis_check(&axis));
    TEST_ASSERT_FALSE(axis_check(&axis));
    TEST_ASSERT_TRUE(axis_is_faulty(&axis));
    TEST_ASSERT_FALSE(axis_is_homed(&axis));
    TEST_ASSERT_EQUAL_HEX32(0U, observe_way(0));
}
