/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: an axis drives only while enabled and without fault; it finds its home position
 * at the edge of its switch; it gives up when it stands still, falls behind or homes for too long,
 * and says so once.
 */
#include "unity.h"

#include "axis/axis.h"
#include "axis/count_account.h"
#include "axis/drift_audit.h"
#include "axis/edge_pace.h"
#include "axis/encoder.h"
#include "axis/homing.h"
#include "axis/supervision.h"
#include "base/crc.h"
#include "base/fixed.h"
#include "card/card_frame.h"
#include "charts/axis_chart.h"
#include "charts/stall_watchdog_chart.h"
#include "limits/requirement_limits.h"
#include "motion/motor_heat.h"
#include "motion/motor_model.h"
#include "motion/servo.h"
#include "robot/robot_neuro.h"

#include <stddef.h>
#include <string.h>

#define CYCLE_US 1000U
#define STALL_CYCLES (LIMIT_STALL_TIME_US / CYCLE_US)
#define PROGRESS ((int32_t)LIMIT_STALL_PROGRESS_TICKS)
#define WRONG_WAY ((int32_t)LIMIT_WRONG_WAY_TICKS)
#define ABOVE 100
#define BELOW (-100)

static const axis_config_t *const with_upper_switch = &robot_neuro.axes[AXIS_PITCH];
static const axis_config_t *const inverted = &robot_neuro.axes[AXIS_HEAD];
static const axis_config_t *const with_lower_switch = &robot_neuro.axes[AXIS_INSERTION];
static const axis_config_t *const without_switch = &robot_neuro.axes[AXIS_ROTATION];

static axis_t axis;
static const axis_config_t *config;
static card_report_t report;
static int32_t setpoint_ticks;

/* The card says that the axis has moved by `ticks`. */
static uint32_t observe_way(int32_t ticks)
{
    report.time_us += CYCLE_US;
    if (ticks != 0) {
        report.last_edge_us = report.time_us;
    }
    report.encoder_count += (config->is_encoder_inverted != 0U) ? -ticks : ticks;
    return axis_observe(&axis, config, &report, CYCLE_US);
}

static uint32_t observe_switch(bool is_active)
{
    const uint32_t bit =
        (config->limit_switch == LIMIT_SWITCH_LOWER) ? CARD_LIMIT_LOWER : CARD_LIMIT_UPPER;

    report.limits = is_active ? bit : 0U;
    return observe_way(0);
}

static void move_to(int32_t position_ticks)
{
    while (axis.encoder.position_ticks != position_ticks) {
        const int32_t way = position_ticks - axis.encoder.position_ticks;
        const int32_t most = config->jump_ticks;
        TEST_ASSERT_EQUAL_HEX32(0U,
                                observe_way((way > most) ? most : ((way < -most) ? -most : way)));
    }
}

/* An axis that is enabled and stands at 0. */
static void use(const axis_config_t *which)
{
    config = which;
    (void)memset(&report, 0, sizeof report);
    axis_init(&axis);
    TEST_ASSERT_EQUAL_HEX32(0U, axis_observe(&axis, config, &report, CYCLE_US));
    axis_enable(&axis, false);
    TEST_ASSERT_TRUE(axis_is_enabled(&axis));
    setpoint_ticks = 0;
}

/* While driven, the motor gets pulses that are too short to move it. */
static uint32_t supervise(bool is_driven, uint32_t elapsed_us)
{
    static uint32_t cycle = 0U;
    cycle++;
    const bool is_pulse = is_driven && (elapsed_us == CYCLE_US) && ((cycle % 8U) == 0U);
    const card_drive_t sent = {.mode = is_pulse ? CARD_DRIVE_NON_PWM : CARD_DRIVE_OFF,
                               .direction = (cycle / 8U) % 2U};
    return axis_supervise(&axis, config, is_driven, &sent, elapsed_us);
}

/* One cycle in which the motor was driven towards the set-point and moved by `ticks`. */
static uint32_t driven_cycle(int32_t ticks)
{
    (void)axis_follow(&axis, config, setpoint_ticks, 0, CYCLE_US);
    return observe_way(ticks) | supervise(true, CYCLE_US);
}

/* Notes of `cycles` driven cycles without any movement. */
static uint32_t push(uint32_t cycles)
{
    uint32_t notes = 0U;

    for (uint32_t i = 0U; i < cycles; i++) {
        notes |= driven_cycle(0);
    }
    return notes;
}

static void begin_homing(void)
{
    TEST_ASSERT_EQUAL_HEX32(0U, axis_begin_homing(&axis, config));
    TEST_ASSERT_TRUE(axis_is_homing(&axis));
}

/* No edge for so long. */
static void stand_still(uint32_t us)
{
    report.time_us += us - CYCLE_US;
    TEST_ASSERT_EQUAL_HEX32(0U, observe_way(0));
}

static void home_in_place(void)
{
    stand_still(LIMIT_SPEED_TIMEOUT_US);
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_HOMED, axis_begin_homing(&axis, config));
    TEST_ASSERT_TRUE(axis_is_homed(&axis));
}

static axis_reference_t reference(void)
{
    return axis.chart.reference;
}

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
    TEST_ASSERT_EQUAL_INT32(config->home_ticks, axis.encoder.position_ticks);
    TEST_ASSERT_EQUAL_INT32(config->home_ticks, axis.setpoint_ticks);
    TEST_ASSERT_EQUAL_INT32(config->home_ticks - 198, axis.home_correction_ticks);
    (void)observe_way(-3);
    TEST_ASSERT_EQUAL_INT32(config->home_ticks - 3, axis.encoder.position_ticks);
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
    TEST_ASSERT_EQUAL_INT32(config->home_ticks - 20, axis.encoder.position_ticks);
    TEST_ASSERT_EQUAL_HEX32(0U, axis_begin_homing(&axis, config));
    TEST_ASSERT_TRUE(axis_is_homed(&axis));
}

void test_SWR_AXIS_002_an_axis_without_switch_is_at_home_where_it_stands(void)
{
    use(without_switch);
    move_to(-77);
    home_in_place();
    TEST_ASSERT_EQUAL_INT32(config->home_ticks, axis.encoder.position_ticks);
    TEST_ASSERT_EQUAL_INT32(77, axis.home_correction_ticks);
}

void test_SWR_AXIS_002_the_home_of_an_axis_without_switch_is_not_taken_twice(void)
{
    use(without_switch);
    home_in_place();
    move_to(5);
    TEST_ASSERT_EQUAL_HEX32(0U, axis_begin_homing(&axis, config));
    TEST_ASSERT_EQUAL_INT32(5, axis.encoder.position_ticks);
}

void test_SWR_AXIS_002_homing_in_progress_is_not_begun_again(void)
{
    begin_homing();
    axis.homing.leg_us = 5U;
    (void)observe_switch(true);
    TEST_ASSERT_EQUAL_HEX32(0U, axis_begin_homing(&axis, config));
    TEST_ASSERT_EQUAL_UINT32(5U, axis.homing.leg_us);
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
    return axis.setpoint_speed_ticks_per_s_q8 / 256;
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
    TEST_ASSERT_EQUAL_INT32(-150, axis.setpoint_ticks);
    TEST_ASSERT_EQUAL_INT32(step_q8, axis.setpoint_speed_ticks_per_s_q8);
    (void)axis_home(&axis, config, CYCLE_US);
    TEST_ASSERT_EQUAL_INT32(2 * step_q8, axis.setpoint_speed_ticks_per_s_q8);
    (void)home_speed();
    move_to(10);
    (void)observe_switch(true);
    (void)axis_home(&axis, config, CYCLE_US);
    TEST_ASSERT_INT32_WITHIN(1, 10, axis.setpoint_ticks);
    TEST_ASSERT_EQUAL_INT32(-step_q8, axis.setpoint_speed_ticks_per_s_q8);
}

void test_SWR_AXIS_002_the_set_point_of_homing_goes_at_home_speed(void)
{
    begin_homing();
    (void)home_speed();
    const int32_t before = axis.setpoint_ticks;
    (void)home_speed();
    TEST_ASSERT_INT32_WITHIN(4, config->home_speed_ticks_per_s, axis.setpoint_ticks - before);
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
    TEST_ASSERT_EQUAL_INT32(40, axis.setpoint_ticks);
    TEST_ASSERT_EQUAL_INT32(config->acceleration_ticks_per_s2 * 256 / 1000,
                            axis.setpoint_speed_ticks_per_s_q8);
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
    const axis_config_t *const needle = &robot_neuro.axes[AXIS_INSERTION];
    const int32_t speed_q8 = needle->speed_ticks_per_s * 256;
    const int32_t most = needle->following_error_ticks +
                         ((needle->speed_ticks_per_s * needle->following_time_ms) / 1000);
    const card_drive_t off = {0};
    axis_enable(&axis, false);
    (void)axis_follow(&axis, needle, most, -speed_q8, CYCLE_US);
    TEST_ASSERT_EQUAL_HEX32(0U, axis_supervise(&axis, needle, true, &off, CYCLE_US));
    (void)axis_follow(&axis, needle, most, speed_q8 / 2, CYCLE_US);
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_FOLLOWING_ERROR,
                            axis_supervise(&axis, needle, true, &off, CYCLE_US));
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
    TEST_ASSERT_EQUAL_INT32(-7, axis.setpoint_ticks);
    TEST_ASSERT_EQUAL_INT32(0, axis.setpoint_speed_ticks_per_s_q8);
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

/* The first of these cycles begins the watch. */
static void expect_stall_after(uint32_t cycles)
{
    TEST_ASSERT_EQUAL_HEX32(0U, push(cycles));
    TEST_ASSERT_TRUE(axis_is_enabled(&axis));
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_STALLED, push(1U));
    TEST_ASSERT_TRUE(axis_is_faulty(&axis));
    TEST_ASSERT_FALSE(axis_is_enabled(&axis));
}

void test_SWR_STALL_001_a_driven_axis_that_does_not_move_up_stalls_at_the_limit(void)
{
    setpoint_ticks = ABOVE;
    expect_stall_after(STALL_CYCLES);
}

void test_SWR_STALL_001_a_driven_axis_that_does_not_move_down_stalls_at_the_limit(void)
{
    setpoint_ticks = BELOW;
    expect_stall_after(STALL_CYCLES);
}

void test_SWR_STALL_001_an_inverted_axis_stalls_in_both_directions(void)
{
    use(inverted);
    setpoint_ticks = ABOVE;
    expect_stall_after(STALL_CYCLES);
    use(inverted);
    setpoint_ticks = BELOW;
    expect_stall_after(STALL_CYCLES);
}

void test_SWR_STALL_001_too_little_progress_does_not_count(void)
{
    setpoint_ticks = ABOVE;
    (void)push(STALL_CYCLES - 9U);
    TEST_ASSERT_EQUAL_HEX32(0U, driven_cycle(PROGRESS - 1));
    expect_stall_after(8U);
}

void test_SWR_STALL_001_enough_progress_begins_the_time_anew(void)
{
    setpoint_ticks = ABOVE;
    (void)push(STALL_CYCLES - 9U);
    (void)driven_cycle(PROGRESS - 1);
    TEST_ASSERT_EQUAL_HEX32(0U, driven_cycle(1));
    expect_stall_after(STALL_CYCLES - 1U);
}

void test_SWR_STALL_001_progress_downwards_begins_the_time_anew(void)
{
    setpoint_ticks = BELOW;
    (void)push(STALL_CYCLES - 1U);
    TEST_ASSERT_EQUAL_HEX32(0U, driven_cycle(-PROGRESS));
    expect_stall_after(STALL_CYCLES - 1U);
}

void test_SWR_STALL_001_moving_the_wrong_way_is_no_progress(void)
{
    setpoint_ticks = ABOVE;
    (void)push(1U);
    TEST_ASSERT_EQUAL_HEX32(0U, driven_cycle(1 - WRONG_WAY));
    expect_stall_after(STALL_CYCLES - 2U);
}

void test_SWR_STALL_001_trembling_is_no_net_progress(void)
{
    setpoint_ticks = ABOVE;
    (void)push(1U);
    for (uint32_t i = 1U; i < STALL_CYCLES; i++) {
        TEST_ASSERT_EQUAL_HEX32(0U, driven_cycle((i % 2U == 0U) ? WRONG_WAY - 1 : 1 - WRONG_WAY));
    }
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_STALLED, driven_cycle(0));
}

/* A cycle in which the motor got a pulse upwards or none, and the axis moved by `ticks`. */
static uint32_t creeping_cycle(bool is_pulse, int32_t ticks)
{
    const card_drive_t sent = {.mode = is_pulse ? CARD_DRIVE_NON_PWM : CARD_DRIVE_OFF,
                               .direction = (config->is_motor_inverted != 0U) ? 0U : 1U};
    (void)axis_follow(&axis, config, setpoint_ticks, 0, CYCLE_US);
    return observe_way(ticks) | axis_supervise(&axis, config, true, &sent, CYCLE_US);
}

/* A pulse of a cycle makes the motor go 0.035 ticks: two in the time of a stall. */
void test_SWR_STALL_001_slow_but_steady_progress_never_stalls(void)
{
    setpoint_ticks = ABOVE;
    for (uint32_t i = 0U; i < 20U; i++) {
        for (uint32_t cycle = 1U; cycle < STALL_CYCLES; cycle++) {
            const bool is_last = (cycle + 1U) == STALL_CYCLES;
            TEST_ASSERT_EQUAL_HEX32(0U, creeping_cycle((cycle % 9U) == 0U, is_last ? PROGRESS : 0));
        }
    }
}

void test_SWR_STALL_001_a_reversal_begins_the_time_anew(void)
{
    setpoint_ticks = ABOVE;
    (void)push(STALL_CYCLES - 1U);
    setpoint_ticks = BELOW;
    /* The dwell before the new direction still counts for the old one. */
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_STALLED, push(2U));
    use(with_upper_switch);
    setpoint_ticks = ABOVE;
    (void)push(STALL_CYCLES - 100U);
    setpoint_ticks = BELOW;
    TEST_ASSERT_EQUAL_HEX32(0U, push(200U));
}

void test_SWR_STALL_001_one_tick_beside_the_set_point_cannot_stall(void)
{
    setpoint_ticks = PROGRESS - 1;
    TEST_ASSERT_EQUAL_HEX32(0U, push(2U * STALL_CYCLES));
    setpoint_ticks = PROGRESS;
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_STALLED, push(STALL_CYCLES + 1U));
}

void test_SWR_STALL_001_an_axis_within_its_deadband_cannot_stall(void)
{
    use(with_lower_switch);
    setpoint_ticks = config->deadband_ticks;
    TEST_ASSERT_EQUAL_HEX32(0U, push(2U * STALL_CYCLES));
    setpoint_ticks = -config->deadband_ticks - 1;
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_STALLED, push(STALL_CYCLES + 1U));
}

void test_SWR_STALL_001_a_stalled_axis_stays_disabled_until_it_is_enabled_anew(void)
{
    setpoint_ticks = ABOVE;
    expect_stall_after(STALL_CYCLES);
    for (uint32_t i = 0U; i < 100U; i++) {
        (void)axis_rest(&axis, CYCLE_US);
        TEST_ASSERT_EQUAL_HEX32(0U, supervise(false, CYCLE_US));
        TEST_ASSERT_FALSE(axis_is_enabled(&axis));
    }
    axis_enable(&axis, true);
    TEST_ASSERT_EQUAL(STALL_WATCHDOG_STATE_STALLED, axis.supervision.stall.state);
    axis_enable(&axis, false);
    TEST_ASSERT_EQUAL(STALL_WATCHDOG_STATE_IDLE, axis.supervision.stall.state);
    expect_stall_after(STALL_CYCLES);
}

void test_SWR_AXIS_015_an_axis_that_goes_against_its_drive_is_a_fault_at_the_limit(void)
{
    setpoint_ticks = ABOVE;
    (void)push(1U);
    TEST_ASSERT_EQUAL_HEX32(0U, driven_cycle(1 - WRONG_WAY));
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_WRONG_WAY, driven_cycle(-1));
    TEST_ASSERT_EQUAL_INT32(WRONG_WAY, axis.supervision.backwards_ticks);
    TEST_ASSERT_TRUE(axis_is_faulty(&axis));
    use(inverted);
    setpoint_ticks = BELOW;
    (void)push(1U);
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_WRONG_WAY, driven_cycle(WRONG_WAY));
}

void test_SWR_AXIS_015_an_axis_that_is_not_driven_goes_no_wrong_way(void)
{
    setpoint_ticks = ABOVE;
    (void)push(1U);
    (void)observe_way(-WRONG_WAY);
    TEST_ASSERT_EQUAL_HEX32(0U, supervise(false, CYCLE_US));
}

/* A cycle with the drive off in which the axis moved by `ticks`. */
static uint32_t off_cycle(int32_t ticks)
{
    (void)axis_rest(&axis, CYCLE_US);
    return observe_way(ticks) | supervise(false, CYCLE_US);
}

static uint32_t off_cycles(uint32_t cycles)
{
    uint32_t notes = 0U;
    for (uint32_t i = 0U; i < cycles; i++) {
        notes |= off_cycle(0);
    }
    return notes;
}

void test_SWR_AXIS_016_an_axis_that_moves_while_off_is_a_fault_in_the_cycle_beyond_the_limit(void)
{
    const int32_t limits[ROBOT_AXIS_MAX] = {7, 7, 4, 333, 11, 6, 6};
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        use(&robot_neuro.axes[i]);
        TEST_ASSERT_EQUAL_HEX32(0U, off_cycles(20U));
        TEST_ASSERT_EQUAL_HEX32(0U, off_cycle(limits[i]));
        TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_MOVED_OFF, off_cycle(1));
        TEST_ASSERT_EQUAL_INT32(limits[i] + 1, axis.supervision.off_ticks);
        TEST_ASSERT_TRUE(axis_is_faulty(&axis));
        TEST_ASSERT_EQUAL_HEX32(0U, off_cycle(5));
    }
}

void test_SWR_AXIS_016_the_way_of_one_second_counts_in_both_directions(void)
{
    use(with_lower_switch);
    (void)off_cycles(20U);
    uint32_t notes = 0U;
    for (uint32_t i = 0U; (i < 1000U) && (notes == 0U); i++) {
        notes = off_cycle(((i % 3U) == 2U) ? -1 : 0);
    }
    TEST_ASSERT_EQUAL_HEX32(0U, notes);
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_MOVED_OFF, off_cycle(-1) | off_cycle(-1));
}

void test_SWR_AXIS_016_what_drifts_more_slowly_is_no_motion(void)
{
    use(with_upper_switch);
    (void)off_cycles(20U);
    for (uint32_t i = 0U; i < 100U; i++) {
        TEST_ASSERT_EQUAL_HEX32(0U, off_cycles(250U));
        TEST_ASSERT_EQUAL_HEX32(0U, off_cycle(1));
    }
}

void test_SWR_AXIS_016_the_last_of_a_driven_motion_does_not_count(void)
{
    use(with_lower_switch);
    setpoint_ticks = ABOVE;
    (void)push(20U);
    TEST_ASSERT_EQUAL_HEX32(0U, off_cycle(400));
    TEST_ASSERT_EQUAL_HEX32(0U, off_cycles(2000U));
}

void test_SWR_AXIS_016_homing_in_place_is_no_motion(void)
{
    use(without_switch);
    move_to(-77);
    (void)off_cycles(2000U);
    home_in_place();
    TEST_ASSERT_EQUAL_HEX32(0U, off_cycles(2000U));
    TEST_ASSERT_TRUE(axis_is_homed(&axis));
}

void test_SWR_AXIS_016_hands_may_move_an_axis_that_nobody_relies_on(void)
{
    axis_disable(&axis);
    (void)off_cycles(20U);
    TEST_ASSERT_EQUAL_HEX32(0U, off_cycle(40));
    use(without_switch);
    home_in_place();
    axis_disable(&axis);
    (void)off_cycles(20U);
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_MOVED_OFF, off_cycle(40));
    TEST_ASSERT_FALSE(axis_is_homed(&axis));
}

static void expect_guard(bool is_driven, int32_t below, int32_t above)
{
    int32_t lowest = 0;
    int32_t highest = 0;
    (void)supervise(false, 0U);
    axis_guard(&axis, config, is_driven, &lowest, &highest);
    TEST_ASSERT_EQUAL_UINT32((uint32_t)axis.encoder.reading - (uint32_t)below, (uint32_t)lowest);
    TEST_ASSERT_EQUAL_UINT32((uint32_t)axis.encoder.reading + (uint32_t)above, (uint32_t)highest);
}

void test_SWR_AXIS_017_the_guard_holds_position_and_set_point(void)
{
    use(with_lower_switch);
    const int32_t rest = 2 * 333;
    const int32_t driven = rest + config->following_error_ticks;

    move_to(500);
    expect_guard(false, rest, rest);
    setpoint_ticks = 540;
    (void)driven_cycle(0);
    expect_guard(true, driven, driven + 40);
    setpoint_ticks = 430;
    (void)driven_cycle(0);
    expect_guard(true, driven + 70, driven);
}

void test_SWR_AXIS_017_the_guard_of_an_inverted_encoder_is_that_of_its_readings(void)
{
    use(inverted);
    const int32_t driven = 2 * 7 + config->following_error_ticks;
    setpoint_ticks = 40;
    (void)driven_cycle(0);
    expect_guard(true, driven + 40, driven);
}

void test_SWR_AXIS_017_the_guard_stays_right_across_the_wrap_of_the_reading(void)
{
    use(with_lower_switch);
    axis.encoder.reading = INT32_MAX;
    expect_guard(false, 2 * 333, 2 * 333);
}

void test_SWR_STALL_001_a_stall_ends_the_homing(void)
{
    begin_homing();
    setpoint_ticks = ABOVE;
    expect_stall_after(STALL_CYCLES);
    TEST_ASSERT_FALSE(axis_is_homing(&axis));
}

void test_SWR_STALL_002_one_cycle_without_drive_begins_the_time_anew(void)
{
    setpoint_ticks = ABOVE;
    (void)push(STALL_CYCLES);
    TEST_ASSERT_EQUAL_UINT32((STALL_CYCLES - 1U) * CYCLE_US, axis.supervision.stall.no_progress_us);
    (void)axis_rest(&axis, CYCLE_US);
    (void)supervise(false, 0U);
    TEST_ASSERT_EQUAL_UINT32(0U, axis.supervision.stall.no_progress_us);
    expect_stall_after(STALL_CYCLES);
}

void test_SWR_STALL_002_time_without_drive_never_stalls(void)
{
    (void)axis_follow(&axis, config, ABOVE, 0, CYCLE_US);
    for (uint32_t i = 0U; i < 10U; i++) {
        TEST_ASSERT_EQUAL_HEX32(0U, supervise(false, LIMIT_STALL_TIME_US));
        TEST_ASSERT_EQUAL_UINT32(0U, axis.supervision.stall.no_progress_us);
    }
}

void test_SWR_STALL_002_what_moved_while_not_driven_is_no_progress(void)
{
    setpoint_ticks = ABOVE;
    (void)push(10U);
    (void)axis_rest(&axis, CYCLE_US);
    (void)observe_way(-20);
    (void)supervise(false, CYCLE_US);
    (void)push(STALL_CYCLES - 1U);
    TEST_ASSERT_EQUAL_HEX32(0U, driven_cycle(PROGRESS));
    TEST_ASSERT_EQUAL_HEX32(0U, push(STALL_CYCLES - 1U));
}

void test_SWR_STALL_003_a_stall_is_told_exactly_once(void)
{
    uint32_t told = 0U;

    setpoint_ticks = ABOVE;
    for (uint32_t i = 0U; i < 10U * STALL_CYCLES; i++) {
        const uint32_t notes = driven_cycle(0);
        told += ((notes & AXIS_NOTE_STALLED) != 0U) ? 1U : 0U;
    }
    TEST_ASSERT_EQUAL_UINT32(1U, told);
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

void test_SWR_CORE_004_an_axis_with_a_damaged_stall_watchdog_is_not_driven_on(void)
{
    axis.supervision.stall.state_inverse ^= 4U;
    TEST_ASSERT_TRUE(axis_check(&axis));
    TEST_ASSERT_FALSE(axis_check(&axis));
    TEST_ASSERT_TRUE(axis_is_faulty(&axis));
    TEST_ASSERT_EQUAL_HEX32(0U, observe_way(0));
    axis_enable(&axis, false);
    setpoint_ticks = ABOVE;
    expect_stall_after(STALL_CYCLES);
}
