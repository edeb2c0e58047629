/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: an axis finds its home position at the edge of its switch, or where it stands if
 * it has none, and gives up when that takes too long or leads too far.
 */
#include "unity.h"

#include "axis/axis.h"
#include "axis/homing.h"
#include "axis/supervision.h"
#include "card/card_frame.h"
#include "charts/axis_chart.h"
#include "limits/requirement_limits.h"
#include "motion/motor_model.h"
#include "robot/robot_neuro.h"

#include "unit/support/axis_world.h"

void setUp(void)
{
    use(with_upper_switch);
}

void tearDown(void)
{
}

void test_SWR_AXIS_001_disabling_ends_the_homing(void)
{
    begin_homing();
    axis_disable(&axis);
    TEST_ASSERT_FALSE(axis_is_enabled(&axis));
    TEST_ASSERT_FALSE(axis_is_faulty(&axis));
    TEST_ASSERT_FALSE(axis_is_homing(&axis));
}

void test_SWR_AXIS_002_a_disabled_axis_does_not_home(void)
{
    axis_disable(&axis);
    TEST_ASSERT_EQUAL_HEX32(0U, axis_begin_homing(&axis, config));
    TEST_ASSERT_FALSE(axis_is_homing(&axis));
    config = without_switch;
    TEST_ASSERT_EQUAL_HEX32(0U, axis_begin_homing(&axis, config));
    TEST_ASSERT_FALSE(axis_is_homed(&axis));
}

void test_SWR_AXIS_002_homing_goes_to_the_switch_back_off_it_and_to_its_edge(void)
{
    begin_homing();
    TEST_ASSERT_EQUAL(AXIS_REFERENCE_APPROACH, reference());
    move_to(200);
    TEST_ASSERT_EQUAL(AXIS_REFERENCE_APPROACH, reference());
    TEST_ASSERT_EQUAL_HEX32(0U, observe_switch(true));
    TEST_ASSERT_EQUAL(AXIS_REFERENCE_BACK_OFF, reference());
    move_to(195);
    TEST_ASSERT_EQUAL_HEX32(0U, observe_switch(false));
    TEST_ASSERT_EQUAL(AXIS_REFERENCE_BACK_OFF, reference());
    move_to(170);
    TEST_ASSERT_EQUAL(AXIS_REFERENCE_LATCH, reference());
    move_to(198);
    TEST_ASSERT_FALSE(axis_is_homed(&axis));
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_HOMED, observe_switch(true));
    TEST_ASSERT_TRUE(axis_is_homed(&axis));
    TEST_ASSERT_FALSE(axis_is_homing(&axis));
}

void test_SWR_AXIS_002_the_position_at_the_second_edge_is_the_home_position(void)
{
    begin_homing();
    move_to(200);
    (void)observe_switch(true);
    move_to(195);
    (void)observe_switch(false);
    move_to(170);
    move_to(198);
    (void)observe_switch(true);
    TEST_ASSERT_EQUAL_INT32(config->home_ticks, axis.sealed.encoder.position_ticks);
    TEST_ASSERT_EQUAL_INT32(config->home_ticks, axis.sealed.setpoint_ticks);
    TEST_ASSERT_EQUAL_INT32(config->home_ticks - 198, axis.sealed.home_correction_ticks);
    (void)observe_way(-3);
    TEST_ASSERT_EQUAL_INT32(config->home_ticks - 3, axis.sealed.encoder.position_ticks);
}

/* The place so many ticks away from the switch. */
static int32_t away(int32_t ticks)
{
    return (config->limit_switch == (uint8_t)LIMIT_SWITCH_UPPER) ? -ticks : ticks;
}

/* Free for so far, the axis turns. */
#define CLEAR 3

/* Approaches the switch at 0 and backs off until the axis turns. */
static void home_until_latch(void)
{
    begin_homing();
    (void)observe_switch(true);
    (void)observe_switch(false);
    move_to(away(config->switch_hysteresis_ticks + CLEAR));
    TEST_ASSERT_EQUAL(AXIS_REFERENCE_LATCH, reference());
}

void test_SWR_AXIS_014_an_axis_that_stands_on_its_switch_leaves_it_and_approaches_it(void)
{
    (void)observe_switch(true);
    begin_homing();
    TEST_ASSERT_EQUAL(AXIS_REFERENCE_LEAVE, reference());
    (void)observe_switch(false);
    move_to(away(CLEAR - 1));
    TEST_ASSERT_EQUAL(AXIS_REFERENCE_LEAVE, reference());
    move_to(away(CLEAR));
    TEST_ASSERT_EQUAL(AXIS_REFERENCE_APPROACH, reference());
    (void)observe_switch(true);
    TEST_ASSERT_EQUAL(AXIS_REFERENCE_BACK_OFF, reference());
}

static void expect_turn_beyond_the_hysteresis(void)
{
    begin_homing();
    (void)observe_switch(true);
    TEST_ASSERT_EQUAL(AXIS_REFERENCE_BACK_OFF, reference());
    (void)observe_switch(false);
    move_to(away(config->switch_hysteresis_ticks + CLEAR - 1));
    TEST_ASSERT_EQUAL(AXIS_REFERENCE_BACK_OFF, reference());
    move_to(away(config->switch_hysteresis_ticks + CLEAR));
    TEST_ASSERT_EQUAL(AXIS_REFERENCE_LATCH, reference());
}

void test_SWR_AXIS_002_the_axis_backs_off_until_it_is_well_clear_of_the_switch(void)
{
    expect_turn_beyond_the_hysteresis();
    use(with_lower_switch);
    expect_turn_beyond_the_hysteresis();
}

void test_SWR_AXIS_002_an_axis_that_stays_on_its_switch_does_not_turn(void)
{
    (void)observe_switch(true);
    begin_homing();
    move_to(away(60));
    TEST_ASSERT_EQUAL(AXIS_REFERENCE_LEAVE, reference());
}

void test_SWR_AXIS_014_an_edge_elsewhere_than_the_first_one_is_a_fault(void)
{
    const int32_t spread = config->home_speed_ticks_per_s / 100 + 2;

    home_until_latch();
    move_to(away(spread));
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_HOMED, observe_switch(true));
    use(with_upper_switch);
    home_until_latch();
    move_to(away(spread + 1));
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_SWITCH_FAULT, observe_switch(true));
    TEST_ASSERT_TRUE(axis_is_faulty(&axis));
    TEST_ASSERT_FALSE(axis_is_homed(&axis));
}

/* Notes of a cycle of homing that nothing else can end. */
static uint32_t homing_cycle(bool is_driven, uint32_t elapsed_us)
{
    (void)axis_rest(&axis, CYCLE_US);
    return supervise(is_driven, elapsed_us);
}

static void expect_end_at(int32_t last_ticks, int32_t beyond_ticks)
{
    move_to(last_ticks);
    TEST_ASSERT_EQUAL_HEX32(0U, homing_cycle(false, CYCLE_US));
    move_to(beyond_ticks);
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_SWITCH_FAULT, homing_cycle(false, CYCLE_US));
    TEST_ASSERT_TRUE(axis_is_faulty(&axis));
    TEST_ASSERT_FALSE(axis_is_homing(&axis));
}

void test_SWR_AXIS_014_a_second_edge_that_does_not_come_is_a_fault(void)
{
    const int32_t spread = config->home_speed_ticks_per_s / 100 + 2;

    home_until_latch();
    expect_end_at(away(-spread), away(-spread - 1));
}

static void expect_bounded_leaving(void)
{
    (void)observe_switch(true);
    begin_homing();
    expect_end_at(away(config->home_way_ticks), away(config->home_way_ticks + 1));
}

void test_SWR_AXIS_013_an_axis_whose_switch_stays_active_leaves_it_no_farther_than_it_can_be(void)
{
    expect_bounded_leaving();
    use(with_lower_switch);
    expect_bounded_leaving();
    TEST_ASSERT_LESS_OR_EQUAL_INT32(667, config->home_way_ticks);
}

void test_SWR_AXIS_013_a_new_attempt_does_not_give_the_way_anew(void)
{
    use(with_lower_switch);
    expect_bounded_leaving();
    axis_enable(&axis, false);
    begin_homing();
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_SWITCH_FAULT, homing_cycle(false, CYCLE_US));
}

void test_SWR_AXIS_013_once_homed_the_way_is_whole_again(void)
{
    home_until_latch();
    move_to(0);
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_HOMED, observe_switch(true));
    axis_lose_reference(&axis);
    move_to(config->minimum_ticks);
    begin_homing();
    TEST_ASSERT_EQUAL_HEX32(0U, homing_cycle(false, CYCLE_US));
}

void test_SWR_AXIS_013_the_approach_goes_no_farther_than_the_travel(void)
{
    const int32_t travel = config->maximum_ticks - config->minimum_ticks;
    const int32_t most = travel + travel / 32 + config->home_way_ticks;

    begin_homing();
    expect_end_at(away(-most), away(-most - 1));
}

void test_SWR_AXIS_002_the_switch_of_a_homed_axis_does_not_set_its_position(void)
{
    home_until_latch();
    move_to(0);
    (void)observe_switch(true);
    TEST_ASSERT_TRUE(axis_is_homed(&axis));
    (void)observe_switch(false);
    move_to(config->home_ticks - 20);
    TEST_ASSERT_EQUAL_HEX32(0U, observe_switch(true));
    TEST_ASSERT_EQUAL_INT32(config->home_ticks - 20, axis.sealed.encoder.position_ticks);
    TEST_ASSERT_EQUAL_HEX32(0U, axis_begin_homing(&axis, config));
    TEST_ASSERT_TRUE(axis_is_homed(&axis));
}

void test_SWR_AXIS_002_an_axis_without_switch_is_at_home_where_it_stands(void)
{
    use(without_switch);
    move_to(-77);
    home_in_place();
    TEST_ASSERT_EQUAL_INT32(config->home_ticks, axis.sealed.encoder.position_ticks);
    TEST_ASSERT_EQUAL_INT32(77, axis.sealed.home_correction_ticks);
}

void test_SWR_AXIS_002_the_home_of_an_axis_without_switch_is_not_taken_twice(void)
{
    use(without_switch);
    home_in_place();
    move_to(5);
    TEST_ASSERT_EQUAL_HEX32(0U, axis_begin_homing(&axis, config));
    TEST_ASSERT_EQUAL_INT32(5, axis.sealed.encoder.position_ticks);
}

void test_SWR_AXIS_002_homing_in_progress_is_not_begun_again(void)
{
    begin_homing();
    axis.sealed.homing.leg_us = 5U;
    (void)observe_switch(true);
    TEST_ASSERT_EQUAL_HEX32(0U, axis_begin_homing(&axis, config));
    TEST_ASSERT_EQUAL_UINT32(5U, axis.sealed.homing.leg_us);
    TEST_ASSERT_EQUAL(AXIS_REFERENCE_BACK_OFF, reference());
}

void test_SWR_AXIS_002_homing_that_was_stopped_begins_anew(void)
{
    begin_homing();
    (void)observe_switch(true);
    axis_stop_homing(&axis);
    TEST_ASSERT_FALSE(axis_is_homing(&axis));
    TEST_ASSERT_TRUE(axis_is_enabled(&axis));
    (void)observe_switch(false);
    begin_homing();
    TEST_ASSERT_EQUAL(AXIS_REFERENCE_APPROACH, reference());
}

/* Set-point speed of homing after a second in the present state, in ticks/s. */
static int32_t home_speed(void)
{
    for (uint32_t i = 0U; i < 1000U; i++) {
        (void)axis_home(&axis, config, CYCLE_US);
    }
    return axis.sealed.setpoint_speed_ticks_per_s_q8 / 256;
}

/* So many percent of the axis' home speed. */
static int32_t part_of_home_speed(int32_t percent)
{
    return config->home_speed_ticks_per_s * percent / 100;
}

void test_SWR_AXIS_002_homing_is_fast_then_back_more_slowly_then_there_most_slowly(void)
{
    begin_homing();
    TEST_ASSERT_EQUAL_INT32(config->home_speed_ticks_per_s, home_speed());
    (void)observe_switch(true);
    TEST_ASSERT_EQUAL_INT32(-part_of_home_speed(LIMIT_HOME_LEAVE_PERCENT), home_speed());
    (void)observe_switch(false);
    move_to(away(config->switch_hysteresis_ticks + CLEAR));
    TEST_ASSERT_EQUAL_INT32(part_of_home_speed(LIMIT_HOME_LATCH_PERCENT), home_speed());
}

void test_SWR_AXIS_002_homing_to_a_lower_switch_goes_down_up_and_down(void)
{
    use(with_lower_switch);
    begin_homing();
    TEST_ASSERT_EQUAL_INT32(-config->home_speed_ticks_per_s, home_speed());
    (void)observe_switch(true);
    TEST_ASSERT_EQUAL_INT32(part_of_home_speed(LIMIT_HOME_LEAVE_PERCENT), home_speed());
    (void)observe_switch(false);
    move_to(away(config->switch_hysteresis_ticks + CLEAR));
    TEST_ASSERT_EQUAL_INT32(-part_of_home_speed(LIMIT_HOME_LATCH_PERCENT), home_speed());
}

void test_SWR_AXIS_002_the_set_point_of_homing_starts_at_the_position_with_zero_speed(void)
{
    const int32_t step_q8 = config->acceleration_ticks_per_s2 * 256 / 1000;

    move_to(-150);
    begin_homing();
    (void)axis_home(&axis, config, CYCLE_US);
    TEST_ASSERT_EQUAL_INT32(-150, axis.sealed.setpoint_ticks);
    TEST_ASSERT_EQUAL_INT32(step_q8, axis.sealed.setpoint_speed_ticks_per_s_q8);
    (void)axis_home(&axis, config, CYCLE_US);
    TEST_ASSERT_EQUAL_INT32(2 * step_q8, axis.sealed.setpoint_speed_ticks_per_s_q8);
    (void)home_speed();
    move_to(10);
    (void)observe_switch(true);
    (void)axis_home(&axis, config, CYCLE_US);
    TEST_ASSERT_INT32_WITHIN(1, 10, axis.sealed.setpoint_ticks);
    TEST_ASSERT_EQUAL_INT32(-step_q8, axis.sealed.setpoint_speed_ticks_per_s_q8);
}

void test_SWR_AXIS_002_homing_gains_speed_at_the_most_acceleration_that_a_robot_may_have(void)
{
    axis_config_t fast = *config;
    fast.acceleration_ticks_per_s2 = (int32_t)LIMIT_ACCELERATION_MOST_TICKS_PER_S2;
    fast.home_speed_ticks_per_s = (int32_t)LIMIT_AXIS_SPEED_MOST_TICKS_PER_S;
    begin_homing();
    (void)axis_home(&axis, &fast, CYCLE_US);
    const int64_t gained_q8 = (int64_t)LIMIT_ACCELERATION_MOST_TICKS_PER_S2 * 256 / 1000;
    TEST_ASSERT_EQUAL_INT32((int32_t)gained_q8, axis.sealed.setpoint_speed_ticks_per_s_q8);
}

void test_SWR_AXIS_002_the_set_point_of_homing_goes_at_home_speed(void)
{
    begin_homing();
    (void)home_speed();
    const int32_t before = axis.sealed.setpoint_ticks;
    (void)home_speed();
    TEST_ASSERT_INT32_WITHIN(4, config->home_speed_ticks_per_s,
                             axis.sealed.setpoint_ticks - before);
}

void test_SWR_AXIS_002_homing_drives_towards_the_switch(void)
{
    use(inverted);
    begin_homing();
    card_drive_t drive = {.mode = CARD_DRIVE_OFF};
    for (uint32_t i = 0U; (i < 1000U) && (drive.mode == CARD_DRIVE_OFF); i++) {
        drive = axis_home(&axis, config, CYCLE_US);
    }
    TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_NON_PWM, drive.mode);
    TEST_ASSERT_TRUE(motor_model_is_upwards(config, &drive));
}

void test_SWR_AXIS_002_homing_taken_up_after_a_rest_starts_where_the_axis_is(void)
{
    begin_homing();
    (void)home_speed();
    (void)axis_rest(&axis, CYCLE_US);
    move_to(40);
    (void)axis_home(&axis, config, CYCLE_US);
    TEST_ASSERT_EQUAL_INT32(40, axis.sealed.setpoint_ticks);
    TEST_ASSERT_EQUAL_INT32(config->acceleration_ticks_per_s2 * 256 / 1000,
                            axis.sealed.setpoint_speed_ticks_per_s_q8);
}

void test_SWR_AXIS_003_homing_below_the_time_limit_goes_on(void)
{
    begin_homing();
    TEST_ASSERT_EQUAL_HEX32(0U, homing_cycle(true, config->home_time_us - 1U));
    TEST_ASSERT_TRUE(axis_is_homing(&axis));
}

void test_SWR_AXIS_003_homing_at_the_time_limit_is_a_fault(void)
{
    begin_homing();
    (void)homing_cycle(true, config->home_time_us - 1U);
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_HOME_TIMEOUT, homing_cycle(true, 1U));
    TEST_ASSERT_TRUE(axis_is_faulty(&axis));
    TEST_ASSERT_FALSE(axis_is_homing(&axis));
    TEST_ASSERT_FALSE(axis_is_homed(&axis));
}

void test_SWR_AXIS_003_only_driven_time_counts(void)
{
    begin_homing();
    (void)homing_cycle(true, config->home_time_us - 1U);
    TEST_ASSERT_EQUAL_HEX32(0U, homing_cycle(false, config->home_time_us));
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_HOME_TIMEOUT, homing_cycle(true, 1U));
}

void test_SWR_AXIS_003_the_time_of_another_motion_does_not_count(void)
{
    TEST_ASSERT_EQUAL_HEX32(0U, homing_cycle(true, config->home_time_us));
    begin_homing();
    TEST_ASSERT_EQUAL_HEX32(0U, homing_cycle(true, config->home_time_us - 1U));
}

void test_SWR_AXIS_003_a_new_homing_has_its_full_time(void)
{
    begin_homing();
    (void)homing_cycle(true, config->home_time_us - 1U);
    axis_stop_homing(&axis);
    begin_homing();
    TEST_ASSERT_EQUAL_HEX32(0U, homing_cycle(true, config->home_time_us - 1U));
}

/* The debouncing takes 10 ms at most, and the counts are true to two. */
void test_SWR_AXIS_048_an_edge_that_was_seen_late_is_where_the_switch_was_free_before(void)
{
    const axis_config_t *const needle = &robot_neuro.axes[NEURO_AXIS_INSERTION];
    const int32_t most = (needle->home_speed_ticks_per_s / 100) + 2;
    homing_t homing = {.edge_ticks = -30};
    homing_meet(&homing, needle, most - 30);
    TEST_ASSERT_EQUAL_INT32(most - 30, homing.edge_ticks);
    homing.edge_ticks = -30;
    homing_meet(&homing, needle, most - 29);
    TEST_ASSERT_EQUAL_INT32(-30, homing.edge_ticks);
}
