/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: over many moves between random places, every axis stays within its speed and
 * acceleration, all axes go the same share of their way in each cycle, and each ends exactly at its
 * target.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "motion/profile.h"
#include "robot/robot_neuro.h"
#include "unit/support/contract_trap.h"
#include "unit/support/scenes.h"

#include <math.h>
#include <string.h>

#define MOVES SCENES(80U)
#define SLOW_MOVES SCENES(3U)
/* Set-points are whole ticks; over this many cycles their rounding is small beside speed and
 * acceleration. */
#define WINDOW_CYCLES 100U
#define HISTORY (2U * WINDOW_CYCLES + 1U)
#define WINDOW_S 0.1
#define CYCLE_S 0.001

static profile_t profile;
static int32_t start[ROBOT_AXIS_MAX];
static int32_t end[ROBOT_AXIS_MAX];
static uint32_t percent;
static uint32_t random_state;

static uint32_t random_below(uint32_t limit)
{
    random_state = random_state * 1664525U + 1013904223U;
    return (uint32_t)(((uint64_t)random_state * limit) >> 32U);
}

static int32_t random_place(const axis_config_t *axis)
{
    return axis->minimum_ticks +
           (int32_t)random_below((uint32_t)(axis->maximum_ticks - axis->minimum_ticks) + 1U);
}

/* Near or far, and some axes not at all. */
static int32_t random_end(const axis_config_t *axis, int32_t from)
{
    switch (random_below(4U)) {
    case 0U:
        return from;
    case 1U:
        return from + (int32_t)random_below(21U) - 10;
    default:
        return random_place(axis);
    }
}

static void random_move(uint32_t slowest_percent, uint32_t fastest_percent)
{
    percent = slowest_percent + random_below(fastest_percent - slowest_percent + 1U);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        start[i] = random_place(&robot_neuro.axes[i]);
        end[i] = random_end(&robot_neuro.axes[i], start[i]);
    }
    profile_plan(&profile, &robot_neuro, start, end, percent);
}

static void simple_move(int32_t insertion_ticks)
{
    (void)memset(start, 0, sizeof start);
    (void)memset(end, 0, sizeof end);
    end[NEURO_AXIS_INSERTION] = insertion_ticks;
    percent = 100U;
    profile_plan(&profile, &robot_neuro, start, end, percent);
}

static double way_of(uint32_t axis)
{
    return (double)end[axis] - (double)start[axis];
}

static double speed_limit(uint32_t axis)
{
    return robot_neuro.axes[axis].speed_ticks_per_s * (percent / 100.0) *
           (LIMIT_PROFILE_SPEED_PERCENT / 100.0);
}

static double acceleration_limit(uint32_t axis)
{
    return robot_neuro.axes[axis].acceleration_ticks_per_s2;
}

static double speed_of(uint32_t axis)
{
    return profile_speed_ticks_per_s_q8(&profile, axis) / 256.0;
}

static void for_many_moves(void (*check)(void))
{
    random_state = 20240229U;
    for (uint32_t i = 0U; i < MOVES; i++) {
        random_move(20U, 100U);
        check();
    }
    for (uint32_t i = 0U; i < SLOW_MOVES; i++) {
        random_move(1U, 5U);
        check();
    }
}

void setUp(void)
{
    (void)memset(&profile, 0, sizeof profile);
}

void tearDown(void)
{
}

/* Set-points of the last cycles, before the start at rest there. */
static int32_t history[ROBOT_AXIS_MAX][HISTORY];

static void check_window(uint32_t axis, uint32_t now)
{
    const int32_t newest = history[axis][now % HISTORY];
    const int32_t middle = history[axis][(now + HISTORY - WINDOW_CYCLES) % HISTORY];
    const int32_t oldest = history[axis][(now + HISTORY - 2U * WINDOW_CYCLES) % HISTORY];
    const double way = newest - middle;
    const double change = way - (middle - oldest);

    TEST_ASSERT_TRUE(fabs(way) <= speed_limit(axis) * WINDOW_S + 1.0);
    TEST_ASSERT_TRUE(fabs(change) <= acceleration_limit(axis) * WINDOW_S * WINDOW_S + 2.0);
}

static void check_positions(void)
{
    uint32_t now = 0U;
    uint32_t cycles_at_end = 0U;

    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        for (uint32_t k = 0U; k < HISTORY; k++) {
            history[i][k] = start[i];
        }
    }
    while (cycles_at_end < HISTORY) {
        for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
            history[i][now % HISTORY] = profile_position_ticks(&profile, i);
            check_window(i, now);
        }
        cycles_at_end += profile_is_finished(&profile) ? 1U : 0U;
        profile_step(&profile);
        now++;
    }
}

static void check_speeds(void)
{
    double before[ROBOT_AXIS_MAX] = {0.0};
    bool is_end = false;

    while (!is_end) {
        is_end = profile_is_finished(&profile);
        for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
            const double now = speed_of(i);
            TEST_ASSERT_TRUE(fabs(now) <= speed_limit(i) + 1.0 / 256.0);
            TEST_ASSERT_TRUE(fabs(now - before[i]) <=
                             acceleration_limit(i) * CYCLE_S + 1.0 / 256.0);
            before[i] = now;
        }
        profile_step(&profile);
    }
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        TEST_ASSERT_TRUE(before[i] == 0.0);
    }
}

void test_SWR_MOTION_001_set_points_keep_speed_and_acceleration_of_each_axis(void)
{
    for_many_moves(check_positions);
}

void test_SWR_MOTION_001_set_point_speeds_keep_speed_and_acceleration_of_each_axis(void)
{
    for_many_moves(check_speeds);
}

/* The area under the speed is the way, up to the rounding of both. */
static void check_area(void)
{
    double area[ROBOT_AXIS_MAX] = {0.0};

    while (!profile_is_finished(&profile)) {
        const double slack = 0.5 + (profile.cycle + 1.0) * CYCLE_S / 512.0;
        for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
            const double half = speed_of(i) * CYCLE_S / 2.0;
            const double done = profile_position_ticks(&profile, i) - start[i];
            area[i] += half;
            TEST_ASSERT_TRUE(fabs(area[i] - done) <= slack + 1e-6);
            area[i] += half;
        }
        profile_step(&profile);
    }
}

void test_SWR_MOTION_001_the_set_point_speed_is_the_slope_of_the_set_point(void)
{
    for_many_moves(check_area);
}

void test_SWR_MOTION_001_a_percentage_of_the_speed_is_kept(void)
{
    simple_move(100000);
    const uint32_t fast = 2U * profile.ramp_cycles + profile.cruise_cycles;
    profile_plan(&profile, &robot_neuro, start, end, 25U);
    const uint32_t slow = 2U * profile.ramp_cycles + profile.cruise_cycles;
    TEST_ASSERT_TRUE(slow > 3U * fast);
    for (uint32_t k = 0U; k < slow / 2U; k++) {
        profile_step(&profile);
    }
    TEST_ASSERT_INT32_WITHIN(256 * 2, 256 * 16667 / 4 * (int32_t)LIMIT_PROFILE_SPEED_PERCENT / 100,
                             profile_speed_ticks_per_s_q8(&profile, NEURO_AXIS_INSERTION));
}

void test_SWR_CORE_003_a_percentage_out_of_range_breaks_the_contract(void)
{
    EXPECT_CONTRACT("profile", 100U, profile_plan(&profile, &robot_neuro, start, end, 0U));
    EXPECT_CONTRACT("profile", 100U, profile_plan(&profile, &robot_neuro, start, end, 101U));
    profile_plan(&profile, &robot_neuro, start, end, 1U);
    profile_plan(&profile, &robot_neuro, start, end, 100U);
}

/* In each cycle all axes have gone the same share of their ways, up to the rounding to ticks. */
static void check_shares(void)
{
    while (!profile_is_finished(&profile)) {
        uint32_t longest = 0U;
        for (uint32_t i = 1U; i < robot_neuro.axis_count; i++) {
            longest = (fabs(way_of(i)) > fabs(way_of(longest))) ? i : longest;
        }
        const double share =
            (profile_position_ticks(&profile, longest) - start[longest]) / way_of(longest);
        for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
            const double done = profile_position_ticks(&profile, i) - start[i];
            TEST_ASSERT_TRUE(fabs(done - share * way_of(i)) <= 1.0 + 1e-9);
        }
        profile_step(&profile);
    }
}

void test_SWR_MOTION_002_all_axes_go_the_same_share_of_their_way_in_each_cycle(void)
{
    for_many_moves(check_shares);
}

/* Speed of the first and of the last cycle of a ramp: too small to be seen for the shortest ways.
 */
static bool is_measurable(uint32_t axis)
{
    const double ramp = profile.ramp_cycles;

    return fabs(way_of(axis)) * 256.0 / CYCLE_S / (ramp * (ramp + profile.cruise_cycles)) >= 1.0;
}

/* Every axis that has a way moves from the first cycle to the last one. */
static void check_common_time(void)
{
    while (!profile_is_finished(&profile)) {
        for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
            if ((profile.cycle == 0U) || (way_of(i) == 0.0)) {
                TEST_ASSERT_TRUE(speed_of(i) == 0.0);
            } else if (is_measurable(i)) {
                TEST_ASSERT_TRUE(speed_of(i) * way_of(i) > 0.0);
            }
        }
        profile_step(&profile);
    }
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        TEST_ASSERT_TRUE(speed_of(i) == 0.0);
    }
}

void test_SWR_MOTION_002_all_axes_start_and_end_in_one_cycle(void)
{
    for_many_moves(check_common_time);
}

/* The shortest time of one trapezoid for all axes, in real numbers. */
static void check_duration(void)
{
    double plateau = 0.0;
    double product = 0.0;

    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        plateau = fmax(plateau, fabs(way_of(i)) / speed_limit(i));
        product = fmax(product, fabs(way_of(i)) / acceleration_limit(i));
    }
    plateau = fmax(plateau, sqrt(product));
    const double shortest = (plateau > 0.0) ? (plateau + product / plateau) / CYCLE_S : 0.0;
    const double planned = 2.0 * profile.ramp_cycles + profile.cruise_cycles;
    TEST_ASSERT_TRUE(planned >= shortest - 1e-6);
    TEST_ASSERT_TRUE(planned <= shortest + 3.0);
}

void test_SWR_MOTION_002_the_move_takes_as_long_as_the_slowest_axis_needs(void)
{
    for_many_moves(check_duration);
}

void test_SWR_MOTION_002_ramp_and_cruise_are_whole_cycles_rounded_up(void)
{
    static robot_t robot;

    robot.axis_count = 1U;
    robot.axes[0].speed_ticks_per_s = 1000000;
    robot.axes[0].acceleration_ticks_per_s2 = 1000000;
    (void)memset(start, 0, sizeof start);
    (void)memset(end, 0, sizeof end);
    /* Ramp times (ramp + cruise) is the way here: 2 * 2 = 4, 2 * 3 > 5. */
    end[0] = 4;
    profile_plan(&profile, &robot, start, end, 100U);
    TEST_ASSERT_EQUAL_UINT32(2U, profile.ramp_cycles);
    TEST_ASSERT_EQUAL_UINT32(0U, profile.cruise_cycles);
    end[0] = 5;
    profile_plan(&profile, &robot, start, end, 100U);
    TEST_ASSERT_EQUAL_UINT32(2U, profile.ramp_cycles);
    TEST_ASSERT_EQUAL_UINT32(1U, profile.cruise_cycles);
}

static void check_end(void)
{
    const uint32_t cycles = 2U * profile.ramp_cycles + profile.cruise_cycles;

    for (uint32_t k = 0U; k < cycles; k++) {
        TEST_ASSERT_FALSE(profile_is_finished(&profile));
        profile_step(&profile);
    }
    for (uint32_t k = 0U; k < 5U; k++) {
        TEST_ASSERT_TRUE(profile_is_finished(&profile));
        for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
            TEST_ASSERT_EQUAL_INT32(end[i], profile_position_ticks(&profile, i));
        }
        profile_step(&profile);
    }
}

void test_SWR_MOTION_003_the_last_set_point_is_the_target(void)
{
    for_many_moves(check_end);
}

static void check_monotone(void)
{
    int32_t before[ROBOT_AXIS_MAX];

    (void)memcpy(before, start, sizeof before);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        TEST_ASSERT_EQUAL_INT32(start[i], profile_position_ticks(&profile, i));
    }
    while (!profile_is_finished(&profile)) {
        profile_step(&profile);
        for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
            const int32_t now = profile_position_ticks(&profile, i);
            TEST_ASSERT_TRUE((end[i] >= start[i]) ? (now >= before[i]) : (now <= before[i]));
            before[i] = now;
        }
    }
}

void test_SWR_MOTION_003_the_set_point_goes_from_start_to_target_without_turning(void)
{
    for_many_moves(check_monotone);
}

void test_SWR_MOTION_003_a_move_without_way_is_finished_at_once(void)
{
    start[NEURO_AXIS_HEAD] = -4711;
    (void)memcpy(end, start, sizeof end);
    profile_plan(&profile, &robot_neuro, start, end, 100U);
    TEST_ASSERT_TRUE(profile_is_finished(&profile));
    profile_step(&profile);
    TEST_ASSERT_EQUAL_UINT32(0U, profile.cycle);
    TEST_ASSERT_EQUAL_INT32(-4711, profile_position_ticks(&profile, NEURO_AXIS_HEAD));
    TEST_ASSERT_EQUAL_INT32(0, profile_speed_ticks_per_s_q8(&profile, NEURO_AXIS_HEAD));
}

void test_SWR_MOTION_003_a_move_of_one_tick_arrives(void)
{
    simple_move(1);
    TEST_ASSERT_FALSE(profile_is_finished(&profile));
    check_end();
    simple_move(-1);
    check_end();
}

void test_SWR_MOTION_003_a_new_plan_replaces_the_old_one(void)
{
    simple_move(100000);
    for (uint32_t k = 0U; k < 500U; k++) {
        profile_step(&profile);
    }
    simple_move(-2);
    TEST_ASSERT_EQUAL_UINT32(0U, profile.cycle);
    check_end();
    simple_move(0);
    TEST_ASSERT_TRUE(profile_is_finished(&profile));
}

void test_SWR_LOOP_003_a_step_advances_one_nominal_cycle(void)
{
    simple_move(100000);
    for (uint32_t k = 0U; k < 1000U; k++) {
        TEST_ASSERT_EQUAL_UINT32(k, profile.cycle);
        const double before = profile_position_ticks(&profile, NEURO_AXIS_INSERTION);
        profile_step(&profile);
        const double way = profile_position_ticks(&profile, NEURO_AXIS_INSERTION) - before;
        TEST_ASSERT_TRUE(way <= speed_limit(NEURO_AXIS_INSERTION) * CYCLE_S + 1.0);
    }
}

void test_SWR_PEDAL_005_a_move_taken_up_again_starts_where_the_axes_are_with_zero_speed(void)
{
    random_state = 4U;
    for (uint32_t n = 0U; n < MOVES; n++) {
        random_move(50U, 100U);
        const uint32_t stop = random_below(2U * profile.ramp_cycles + profile.cruise_cycles + 1U);
        for (uint32_t k = 0U; k < stop; k++) {
            profile_step(&profile);
        }
        for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
            start[i] = profile_position_ticks(&profile, i) + (int32_t)random_below(5U) - 2;
        }
        profile_plan(&profile, &robot_neuro, start, end, percent);
        for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
            TEST_ASSERT_EQUAL_INT32(start[i], profile_position_ticks(&profile, i));
            TEST_ASSERT_TRUE(speed_of(i) == 0.0);
        }
        check_speeds();
    }
}
