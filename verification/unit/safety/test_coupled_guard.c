/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a drive away from the range of a coupled limit is blocked when the two axes
 * might leave it before off frames act. The ways are exact: nm of whole ticks, against ends that a
 * test sets.
 */
#include "unity.h"

#include "axis/axis.h"
#include "limits/requirement_limits.h"
#include "robot/coupled_limit.h"
#include "robot/joints.h"
#include "robot/robot_neuro.h"
#include "safety/coupled_guard.h"

/* 984 ticks/s for 4.5 ms, rounded up, and the tick of a count. */
#define DRIVEN_TICKS 6
#define RESTING_TICKS 1

static robot_t robot;
static axis_t axes[ROBOT_AXIS_MAX];
static card_drive_t sent[ROBOT_AXIS_MAX];
static card_drive_t requests[ROBOT_AXIS_MAX];
static const coupled_view_t view = {axes, sent, requests};

void setUp(void)
{
    robot = robot_neuro;
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        axis_init(&axes[i]);
        axes[i].chart.reference = AXIS_REFERENCE_VERIFIED;
        sent[i] = (card_drive_t){0U, 0U, 0U, 0U};
        requests[i] = sent[i];
    }
}

void tearDown(void)
{
}

static card_drive_t drive(uint32_t axis, bool is_upwards)
{
    const bool is_inverted = robot.axes[axis].is_motor_inverted != 0U;
    return (card_drive_t){CARD_DRIVE_NON_PWM, (is_upwards != is_inverted) ? 1U : 0U, 0U, 0U};
}

static bool is_blocked(uint32_t axis)
{
    return ((coupled_guard_blocks(&robot, &view) >> axis) & 1U) != 0U;
}

/* The separation at home. */
static int32_t home_nm(void)
{
    return robot.geometry_nm[NEURO_HOME_SEPARATION];
}

static int32_t nm(int32_t ticks)
{
    return (int32_t)joints_value(&robot.axes[NEURO_AXIS_HEAD], ticks);
}

/* Blocked when the range ends one nm nearer than `ticks` and free when it ends there. */
static void expect_way(uint32_t axis, bool is_growing, int32_t first_ticks, int32_t second_ticks)
{
    const int32_t way = nm(first_ticks) + nm(second_ticks);
    robot.coupled_limits[0].minimum = home_nm() + (is_growing ? -1000000000 : -way);
    robot.coupled_limits[0].maximum = home_nm() + (is_growing ? way : 1000000000);
    TEST_ASSERT_FALSE(is_blocked(axis));
    robot.coupled_limits[0].minimum += is_growing ? 0 : 1;
    robot.coupled_limits[0].maximum -= is_growing ? 1 : 0;
    TEST_ASSERT_TRUE(is_blocked(axis));
}

void test_SWR_COUPLE_001_one_axis_is_stopped_its_way_before_the_end(void)
{
    requests[NEURO_AXIS_HEAD] = drive(NEURO_AXIS_HEAD, true);
    expect_way(NEURO_AXIS_HEAD, true, DRIVEN_TICKS, RESTING_TICKS);
    requests[NEURO_AXIS_HEAD] = drive(NEURO_AXIS_HEAD, false);
    expect_way(NEURO_AXIS_HEAD, false, DRIVEN_TICKS, RESTING_TICKS);
    requests[NEURO_AXIS_HEAD] = (card_drive_t){0U, 0U, 0U, 0U};
    requests[NEURO_AXIS_FEET] = drive(NEURO_AXIS_FEET, true);
    expect_way(NEURO_AXIS_FEET, false, RESTING_TICKS, DRIVEN_TICKS);
    requests[NEURO_AXIS_FEET] = drive(NEURO_AXIS_FEET, false);
    expect_way(NEURO_AXIS_FEET, true, RESTING_TICKS, DRIVEN_TICKS);
}

void test_SWR_COUPLE_001_what_the_other_axis_is_driven_adds_up(void)
{
    requests[NEURO_AXIS_HEAD] = drive(NEURO_AXIS_HEAD, true);
    requests[NEURO_AXIS_FEET] = drive(NEURO_AXIS_FEET, false);
    expect_way(NEURO_AXIS_HEAD, true, DRIVEN_TICKS, DRIVEN_TICKS);
    expect_way(NEURO_AXIS_FEET, true, DRIVEN_TICKS, DRIVEN_TICKS);
    requests[NEURO_AXIS_FEET] = (card_drive_t){0U, 0U, 0U, 0U};
    sent[NEURO_AXIS_FEET] = drive(NEURO_AXIS_FEET, false);
    expect_way(NEURO_AXIS_HEAD, true, DRIVEN_TICKS, DRIVEN_TICKS);
}

void test_SWR_COUPLE_001_that_the_other_axis_comes_back_counts_for_nothing(void)
{
    requests[NEURO_AXIS_HEAD] = drive(NEURO_AXIS_HEAD, true);
    requests[NEURO_AXIS_FEET] = drive(NEURO_AXIS_FEET, true);
    sent[NEURO_AXIS_FEET] = drive(NEURO_AXIS_FEET, true);
    axes[NEURO_AXIS_FEET].sealed.encoder.speed_ticks_per_s_q8 = 900 * 256;
    expect_way(NEURO_AXIS_HEAD, true, DRIVEN_TICKS, RESTING_TICKS);
}

/* 3000 ticks/s for 4.5 ms are 13.5. */
void test_SWR_COUPLE_001_an_axis_that_is_faster_than_its_motor_is_believed(void)
{
    requests[NEURO_AXIS_HEAD] = drive(NEURO_AXIS_HEAD, false);
    axes[NEURO_AXIS_HEAD].sealed.encoder.speed_ticks_per_s_q8 = -3000 * 256;
    axes[NEURO_AXIS_FEET].sealed.encoder.speed_ticks_per_s_q8 = 3000 * 256;
    expect_way(NEURO_AXIS_HEAD, false, 15, 15);
}

void test_SWR_COUPLE_001_outside_of_the_range_the_way_back_is_free(void)
{
    axes[NEURO_AXIS_HEAD].sealed.encoder.position_ticks = -8000;
    requests[NEURO_AXIS_HEAD] = drive(NEURO_AXIS_HEAD, true);
    requests[NEURO_AXIS_FEET] = drive(NEURO_AXIS_FEET, false);
    TEST_ASSERT_FALSE(is_blocked(NEURO_AXIS_HEAD));
    TEST_ASSERT_FALSE(is_blocked(NEURO_AXIS_FEET));
    requests[NEURO_AXIS_HEAD] = drive(NEURO_AXIS_HEAD, false);
    requests[NEURO_AXIS_FEET] = drive(NEURO_AXIS_FEET, true);
    TEST_ASSERT_TRUE(is_blocked(NEURO_AXIS_HEAD));
    TEST_ASSERT_TRUE(is_blocked(NEURO_AXIS_FEET));
}

static void expect_end(uint32_t axis, int32_t ticks, coupled_side_t side)
{
    const solution_t judged = coupled_guard_judge(&robot, axes, axis, ticks);
    const bool is_inside = side == COUPLED_LIMIT_INSIDE;
    TEST_ASSERT_EQUAL(is_inside ? STATUS_OK : STATUS_SEPARATION_LIMIT, judged.status);
    TEST_ASSERT_EQUAL_UINT8(is_inside ? 0U : axis, judged.axis);
    TEST_ASSERT_EQUAL_UINT8((side == COUPLED_LIMIT_ABOVE) ? 1U : 0U, judged.is_maximum);
}

void test_SWR_COUPLE_001_a_limit_is_in_force_for_its_own_axes_once_both_are_homed(void)
{
    axes[NEURO_AXIS_HEAD].sealed.encoder.position_ticks = -8000;
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const bool is_of_limit =
            (i == (uint32_t)NEURO_AXIS_HEAD) || (i == (uint32_t)NEURO_AXIS_FEET);
        TEST_ASSERT_FALSE(is_blocked(i));
        requests[i] = drive(i, i != (uint32_t)NEURO_AXIS_HEAD);
        TEST_ASSERT_EQUAL(is_of_limit, is_blocked(i));
    }
    axes[NEURO_AXIS_HEAD].chart.reference = AXIS_REFERENCE_LOST;
    TEST_ASSERT_FALSE(is_blocked(NEURO_AXIS_FEET));
    expect_end(NEURO_AXIS_FEET, 0, COUPLED_LIMIT_INSIDE);
    axes[NEURO_AXIS_HEAD].chart.reference = AXIS_REFERENCE_VERIFIED;
    axes[NEURO_AXIS_FEET].chart.reference = AXIS_REFERENCE_LOST;
    TEST_ASSERT_FALSE(is_blocked(NEURO_AXIS_HEAD));
    expect_end(NEURO_AXIS_HEAD, -8000, COUPLED_LIMIT_INSIDE);
}

/* The feet stand so far out that the head, were it at its switch, would leave the limit. */
static void put_feet_out(int32_t beyond_ticks)
{
    axes[NEURO_AXIS_HEAD].chart.reference = AXIS_REFERENCE_LOST;
    axes[NEURO_AXIS_FEET].sealed.encoder.position_ticks = -100 - beyond_ticks;
    robot.coupled_limits[0].maximum = home_nm() + nm(100);
}

static void expect_barred(bool is_barred)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const bool is_head = i == (uint32_t)NEURO_AXIS_HEAD;
        TEST_ASSERT_EQUAL(is_head && is_barred, coupled_guard_bars_homing(&robot, axes, i));
        requests[i] = drive(i, true);
        TEST_ASSERT_EQUAL(is_head && is_barred, is_blocked(i));
        requests[i] = drive(i, false);
        TEST_ASSERT_FALSE(is_blocked(i));
        requests[i] = (card_drive_t){0U, 0U, 0U, 0U};
        TEST_ASSERT_FALSE(is_blocked(i));
    }
}

void test_SWR_COUPLE_003_an_axis_does_not_go_to_a_switch_that_is_beyond_the_limit(void)
{
    put_feet_out(0);
    expect_barred(false);
    put_feet_out(1);
    expect_barred(true);
    /* It may be beyond below as well. */
    robot.coupled_limits[0].maximum = home_nm() + nm(1000);
    robot.coupled_limits[0].minimum = home_nm() + nm(101);
    expect_barred(false);
    robot.coupled_limits[0].minimum = home_nm() + nm(101) + 1;
    expect_barred(true);
}

void test_SWR_COUPLE_003_the_second_axis_of_a_limit_is_barred_as_the_first(void)
{
    robot.axes[NEURO_AXIS_FEET].limit_switch = (uint8_t)LIMIT_SWITCH_LOWER;
    robot.axes[NEURO_AXIS_FEET].home_ticks = -50;
    axes[NEURO_AXIS_FEET].chart.reference = AXIS_REFERENCE_LOST;
    axes[NEURO_AXIS_FEET].sealed.encoder.position_ticks = -9999;
    axes[NEURO_AXIS_HEAD].sealed.encoder.position_ticks = 50;
    robot.coupled_limits[0].maximum = home_nm() + nm(100);
    requests[NEURO_AXIS_FEET] = drive(NEURO_AXIS_FEET, false);
    TEST_ASSERT_FALSE(coupled_guard_bars_homing(&robot, axes, NEURO_AXIS_FEET));
    TEST_ASSERT_FALSE(is_blocked(NEURO_AXIS_FEET));
    axes[NEURO_AXIS_HEAD].sealed.encoder.position_ticks = 51;
    TEST_ASSERT_TRUE(coupled_guard_bars_homing(&robot, axes, NEURO_AXIS_FEET));
    TEST_ASSERT_FALSE(coupled_guard_bars_homing(&robot, axes, NEURO_AXIS_HEAD));
    TEST_ASSERT_TRUE(is_blocked(NEURO_AXIS_FEET));
    requests[NEURO_AXIS_FEET] = drive(NEURO_AXIS_FEET, true);
    TEST_ASSERT_FALSE(is_blocked(NEURO_AXIS_FEET));
}

void test_SWR_COUPLE_003_nothing_is_barred_unless_just_the_other_axis_is_homed(void)
{
    put_feet_out(1);
    axes[NEURO_AXIS_FEET].chart.reference = AXIS_REFERENCE_UNVERIFIED;
    expect_barred(false);
    put_feet_out(1);
    axes[NEURO_AXIS_FEET].chart.reference = AXIS_REFERENCE_TAKEN;
    expect_barred(true);
    axes[NEURO_AXIS_HEAD].chart.reference = AXIS_REFERENCE_VERIFIED;
    TEST_ASSERT_FALSE(coupled_guard_bars_homing(&robot, axes, NEURO_AXIS_HEAD));
}

void test_SWR_COUPLE_003_an_axis_without_a_switch_or_without_a_limit_is_not_barred(void)
{
    axes[NEURO_AXIS_FEET].chart.reference = AXIS_REFERENCE_LOST;
    axes[NEURO_AXIS_LATERAL].chart.reference = AXIS_REFERENCE_LOST;
    axes[NEURO_AXIS_HEAD].sealed.encoder.position_ticks = -9999;
    expect_barred(false);
}

/* The distance between two that travel as one stays; a jog of the one takes no other along. */
void test_SWR_COUPLE_003_an_axis_that_homes_with_the_other_behind_it_is_not_barred(void)
{
    put_feet_out(1);
    robot.axes[NEURO_AXIS_FEET].leaders[1] = 1U + NEURO_AXIS_HEAD;
    requests[NEURO_AXIS_HEAD] = drive(NEURO_AXIS_HEAD, true);
    TEST_ASSERT_FALSE(coupled_guard_bars_homing(&robot, axes, NEURO_AXIS_HEAD));
    TEST_ASSERT_TRUE(is_blocked(NEURO_AXIS_HEAD));
    axes[NEURO_AXIS_HEAD].chart.reference = AXIS_REFERENCE_APPROACH;
    TEST_ASSERT_FALSE(is_blocked(NEURO_AXIS_HEAD));
    robot.axes[NEURO_AXIS_FEET].leaders[1] = 1U + NEURO_AXIS_LATERAL;
    TEST_ASSERT_TRUE(coupled_guard_bars_homing(&robot, axes, NEURO_AXIS_HEAD));
    TEST_ASSERT_TRUE(is_blocked(NEURO_AXIS_HEAD));
}

void test_SWR_COUPLE_003_two_that_follow_a_third_are_not_barred(void)
{
    put_feet_out(1);
    robot.axes[NEURO_AXIS_HEAD].leaders[1] = 1U + NEURO_AXIS_LATERAL;
    robot.axes[NEURO_AXIS_FEET].leaders[1] = 1U + NEURO_AXIS_LATERAL;
    requests[NEURO_AXIS_HEAD] = drive(NEURO_AXIS_HEAD, true);
    TEST_ASSERT_TRUE(is_blocked(NEURO_AXIS_HEAD));
    axes[NEURO_AXIS_LATERAL].chart.reference = AXIS_REFERENCE_LATCH;
    TEST_ASSERT_FALSE(is_blocked(NEURO_AXIS_HEAD));
}

/* The lateral axis homes with an escort of which the head is; its counts say where that is. */
void test_SWR_COUPLE_003_one_of_an_escort_goes_where_its_counts_allow(void)
{
    put_feet_out(1);
    robot.axes[NEURO_AXIS_HEAD].leaders[0] = 1U + NEURO_AXIS_YAW;
    robot.axes[NEURO_AXIS_LATERAL].leaders[0] = 1U + NEURO_AXIS_YAW;
    requests[NEURO_AXIS_HEAD] = drive(NEURO_AXIS_HEAD, true);
    axes[NEURO_AXIS_HEAD].sealed.place = AXIS_PLACE_COUNTED;
    TEST_ASSERT_TRUE(is_blocked(NEURO_AXIS_HEAD));
    axes[NEURO_AXIS_LATERAL].chart.reference = AXIS_REFERENCE_APPROACH;
    TEST_ASSERT_FALSE(is_blocked(NEURO_AXIS_HEAD));
    axes[NEURO_AXIS_HEAD].sealed.place |= AXIS_PLACE_BROKEN;
    TEST_ASSERT_TRUE(is_blocked(NEURO_AXIS_HEAD));
    axes[NEURO_AXIS_HEAD].sealed.place = AXIS_PLACE_COUNTED;
    axes[NEURO_AXIS_HEAD].chart.reference = AXIS_REFERENCE_APPROACH;
    TEST_ASSERT_TRUE(is_blocked(NEURO_AXIS_HEAD));
    axes[NEURO_AXIS_HEAD].chart.reference = AXIS_REFERENCE_LOST;
    robot.axes[NEURO_AXIS_HEAD].leaders[0] = 0U;
    TEST_ASSERT_TRUE(is_blocked(NEURO_AXIS_HEAD));
}

/* The limit of the head and the feet, which stand at `head_ticks` and 0, ends 100 ticks to each
 * side of home. */
static bool is_missed(uint32_t axis, int32_t head_ticks)
{
    robot.coupled_limits[0].minimum = home_nm() - nm(100);
    robot.coupled_limits[0].maximum = home_nm() + nm(100);
    axes[NEURO_AXIS_HEAD].sealed.encoder.position_ticks = head_ticks;
    axes[NEURO_AXIS_FEET].sealed.encoder.position_ticks = 0;
    return coupled_guard_is_missed(&robot, axes, axis);
}

void test_SWR_AXIS_033_a_limit_is_missed_by_more_than_its_margin_to_either_side(void)
{
    /* 0.2 mm are 15 ticks and three quarters. */
    TEST_ASSERT_FALSE(is_missed(NEURO_AXIS_HEAD, 115));
    TEST_ASSERT_TRUE(is_missed(NEURO_AXIS_HEAD, 116));
    TEST_ASSERT_TRUE(is_missed(NEURO_AXIS_FEET, 116));
    TEST_ASSERT_FALSE(is_missed(NEURO_AXIS_HEAD, -115));
    TEST_ASSERT_TRUE(is_missed(NEURO_AXIS_HEAD, -116));
    TEST_ASSERT_FALSE(is_missed(NEURO_AXIS_LATERAL, -116));
    axes[NEURO_AXIS_FEET].chart.reference = AXIS_REFERENCE_LOST;
    TEST_ASSERT_FALSE(is_missed(NEURO_AXIS_HEAD, -116));
}

void test_SWR_AXIS_033_each_limit_of_an_axis_may_be_missed(void)
{
    (void)is_missed(NEURO_AXIS_HEAD, 0);
    robot.coupled_limits[1] = robot.coupled_limits[0];
    robot.coupled_limit_count = 2U;
    TEST_ASSERT_FALSE(is_missed(NEURO_AXIS_HEAD, 115));
    TEST_ASSERT_TRUE(is_missed(NEURO_AXIS_HEAD, 116));
}

void test_SWR_JOG_002_an_axis_is_known_when_it_and_its_partners_are_homed(void)
{
    TEST_ASSERT_TRUE(coupled_guard_is_known(&robot, axes, NEURO_AXIS_HEAD));
    axes[NEURO_AXIS_FEET].chart.reference = AXIS_REFERENCE_LOST;
    TEST_ASSERT_FALSE(coupled_guard_is_known(&robot, axes, NEURO_AXIS_HEAD));
    TEST_ASSERT_FALSE(coupled_guard_is_known(&robot, axes, NEURO_AXIS_FEET));
    TEST_ASSERT_TRUE(coupled_guard_is_known(&robot, axes, NEURO_AXIS_LATERAL));
    axes[NEURO_AXIS_LATERAL].chart.reference = AXIS_REFERENCE_LOST;
    TEST_ASSERT_FALSE(coupled_guard_is_known(&robot, axes, NEURO_AXIS_LATERAL));
}

void test_SWR_COUPLE_002_an_end_is_judged_with_the_other_axis_where_it_stands(void)
{
    axes[NEURO_AXIS_HEAD].sealed.encoder.position_ticks = -5000;
    expect_end(NEURO_AXIS_FEET, 0, COUPLED_LIMIT_INSIDE);
    expect_end(NEURO_AXIS_FEET, 500, COUPLED_LIMIT_BELOW);
    expect_end(NEURO_AXIS_FEET, -5300, COUPLED_LIMIT_ABOVE);
    expect_end(NEURO_AXIS_LATERAL, -90000, COUPLED_LIMIT_INSIDE);
    axes[NEURO_AXIS_FEET].sealed.encoder.position_ticks = 500;
    expect_end(NEURO_AXIS_HEAD, -5000, COUPLED_LIMIT_BELOW);
    expect_end(NEURO_AXIS_HEAD, -4000, COUPLED_LIMIT_INSIDE);
    expect_end(NEURO_AXIS_HEAD, 800, COUPLED_LIMIT_ABOVE);
}

/* Otherwise the permit would block the last of the way to a legal end. */
void test_SWR_COUPLE_002_the_margin_of_ends_holds_what_both_axes_may_run_on(void)
{
    TEST_ASSERT_GREATER_THAN_INT32(2 * nm(DRIVEN_TICKS), (int32_t)LIMIT_COUPLED_MARGIN_NM);
}

static status_t judged_homing(uint32_t axis)
{
    return coupled_guard_judge_homing(&robot, axes, axis).status;
}

/* The head's home is 0, that of the feet as well. */
void test_SWR_AXIS_036_whoever_homes_alone_ends_within_the_limit_or_is_refused(void)
{
    axes[NEURO_AXIS_HEAD].sealed.encoder.position_ticks = -3000;
    axes[NEURO_AXIS_FEET].sealed.encoder.position_ticks = -100;
    robot.coupled_limits[0].minimum = home_nm() + nm(100);
    robot.coupled_limits[0].maximum = home_nm() + nm(100);
    TEST_ASSERT_EQUAL(STATUS_OK, judged_homing(NEURO_AXIS_HEAD));
    axes[NEURO_AXIS_HEAD].chart.reference = AXIS_REFERENCE_LOST;
    TEST_ASSERT_EQUAL(STATUS_OK, judged_homing(NEURO_AXIS_HEAD));
    robot.coupled_limits[0].minimum++;
    robot.coupled_limits[0].maximum++;
    TEST_ASSERT_EQUAL(STATUS_SEPARATION_LIMIT, judged_homing(NEURO_AXIS_HEAD));
    TEST_ASSERT_EQUAL_UINT8(0U,
                            coupled_guard_judge_homing(&robot, axes, NEURO_AXIS_HEAD).is_maximum);
    robot.coupled_limits[0].minimum -= 2;
    robot.coupled_limits[0].maximum -= 2;
    TEST_ASSERT_EQUAL(STATUS_SEPARATION_LIMIT, judged_homing(NEURO_AXIS_HEAD));
    TEST_ASSERT_EQUAL_UINT8(1U,
                            coupled_guard_judge_homing(&robot, axes, NEURO_AXIS_HEAD).is_maximum);
    TEST_ASSERT_EQUAL(STATUS_OK, judged_homing(NEURO_AXIS_LATERAL));
}

void test_SWR_AXIS_036_nobody_homes_alone_whose_partner_is_unknown(void)
{
    axes[NEURO_AXIS_FEET].chart.reference = AXIS_REFERENCE_UNVERIFIED;
    TEST_ASSERT_EQUAL(STATUS_NOT_HOMED, judged_homing(NEURO_AXIS_HEAD));
    TEST_ASSERT_EQUAL(STATUS_OK, judged_homing(NEURO_AXIS_YAW));
}
