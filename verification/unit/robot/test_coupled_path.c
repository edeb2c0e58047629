/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: between two legal poses axes that go in step leave no limit that they share. The
 * robot of this test has a linear limit and a saddle of four axes, whose value has its worst places
 * on the way; each way is walked in small steps beside.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "robot/coupled_limit.h"
#include "robot/coupled_path.h"
#include "robot/joints.h"
#include "robot/robot_neuro.h"
#include "unit/support/scenes.h"

#define AXES 4U
#define TICK_NM 1000
#define SADDLE_NM INT64_C(50000000)
#define MARGIN_NM ((int64_t)LIMIT_COUPLED_MARGIN_NM)
#define SMALL_STEPS 1000
#define LOOKS 17U

enum { PAIR, SADDLE, LIMITS };

static robot_t robot;
static uint32_t looks;
static uint32_t seed;

int64_t kinematics_coupled(const robot_t *of, uint32_t index, const joints_t *joints);

/* In the place of what a robot's folder would have. */
int64_t kinematics_coupled(const robot_t *of, uint32_t index, const joints_t *joints)
{
    const int32_t *const q = joints->value;
    TEST_ASSERT_EQUAL_PTR(&robot, of);
    looks++;
    if (index == (uint32_t)PAIR) {
        return (int64_t)q[0] - q[1];
    }
    const int64_t up = (((int64_t)q[0] * q[0]) / 4) + (((int64_t)q[1] * q[2]) / 4);
    return (up - (((int64_t)q[3] * q[3]) / 4)) / (SADDLE_NM / 4);
}

void setUp(void)
{
    robot = robot_neuro;
    robot.axis_count = AXES;
    robot.coupled_limit_count = LIMITS;
    for (uint32_t i = 0U; i < LIMITS; i++) {
        robot.coupled_limits[i] = (coupled_limit_t){.unit = (uint8_t)AXIS_UNIT_MM,
                                                    .refusal = (uint8_t)(40U + i),
                                                    .is_curved = (uint8_t)i,
                                                    .axes = (i == (uint32_t)PAIR) ? 0x3U : 0xFU,
                                                    .minimum = -3000000,
                                                    .maximum = 3000000};
    }
    for (uint32_t i = 0U; i < AXES; i++) {
        robot.axes[i].unit_per_tick_q16 = (int64_t)TICK_NM * 65536;
    }
    seed = 1U;
    looks = 0U;
}

void tearDown(void)
{
}

static uint32_t draw(uint32_t below)
{
    seed = (seed * 1664525U) + 1013904223U;
    return (uint32_t)(((uint64_t)(seed >> 8U) * below) >> 24U);
}

static int64_t saddle_nm(const int32_t ticks[ROBOT_AXIS_MAX])
{
    joints_t joints;
    joints_from_ticks(&robot, ticks, &joints);
    return kinematics_coupled(&robot, SADDLE, &joints);
}

/* The least and the greatest value on the way. */
static void walk(const int32_t from[ROBOT_AXIS_MAX], const int32_t to[ROBOT_AXIS_MAX],
                 int64_t *lowest, int64_t *highest)
{
    int32_t ticks[ROBOT_AXIS_MAX] = {0};
    *lowest = INT64_MAX;
    *highest = INT64_MIN;
    for (int32_t step = 0; step <= SMALL_STEPS; step++) {
        for (uint32_t i = 0U; i < AXES; i++) {
            ticks[i] = (int32_t)(from[i] + (((int64_t)(to[i] - from[i]) * step) / SMALL_STEPS));
        }
        const int64_t value = saddle_nm(ticks);
        *lowest = (value < *lowest) ? value : *lowest;
        *highest = (value > *highest) ? value : *highest;
    }
}

/* A place at which a motion may end. */
static void draw_end(int32_t ticks[ROBOT_AXIS_MAX], uint32_t span_ticks)
{
    int64_t value = 0;
    do {
        for (uint32_t i = 0U; i < AXES; i++) {
            ticks[i] = (int32_t)draw(span_ticks) - (int32_t)(span_ticks / 2U);
        }
        value = saddle_nm(ticks);
    } while (coupled_limit_side(&robot.coupled_limits[SADDLE], value) != COUPLED_LIMIT_INSIDE);
}

/* How far the way is beyond the range at most; below 0 inside. */
static int64_t beyond_nm(const int32_t from[ROBOT_AXIS_MAX], const int32_t to[ROBOT_AXIS_MAX])
{
    int64_t lowest = 0;
    int64_t highest = 0;
    walk(from, to, &lowest, &highest);
    const int64_t above = highest - robot.coupled_limits[SADDLE].maximum;
    const int64_t below = robot.coupled_limits[SADDLE].minimum - lowest;
    return (above > below) ? above : below;
}

/* Ways of up to `span_ticks`; what is refused comes so near to an end as `near_nm`. */
static void judge_many(uint32_t span_ticks, int64_t near_nm)
{
    uint32_t refused = 0U;
    uint32_t taken = 0U;
    for (uint32_t i = 0U; i < SCENES(2000U); i++) {
        int32_t from[ROBOT_AXIS_MAX] = {0};
        int32_t to[ROBOT_AXIS_MAX] = {0};
        draw_end(from, span_ticks);
        draw_end(to, span_ticks);
        const solution_t judged = coupled_path_judge(&robot, from, to);
        const int64_t beyond = beyond_nm(from, to);
        if (judged.status == STATUS_OK) {
            taken++;
            TEST_ASSERT_LESS_OR_EQUAL_INT64(0, beyond);
        } else {
            refused++;
            TEST_ASSERT_EQUAL_UINT8(40U + SADDLE, judged.status);
            TEST_ASSERT_GREATER_THAN_INT64(-near_nm, beyond);
        }
    }
    TEST_ASSERT_GREATER_THAN_UINT32(SCENES(50U), refused);
    TEST_ASSERT_GREATER_THAN_UINT32(SCENES(50U), taken);
}

void test_SWR_COUPLE_006_no_way_that_is_taken_leaves_the_range(void)
{
    judge_many(30000U, MARGIN_NM + 1000);
    judge_many(60000U, MARGIN_NM + 1000);
}

/* So long a way bends by more than the margin between two looks: it is kept farther inside. */
void test_SWR_COUPLE_006_a_long_way_keeps_so_much_more_room(void)
{
    judge_many(300000U, INT64_C(3000000));
}

/* -q3 * q3 has its top, 0, just between two looks, which both show -0.78 mm. */
void test_SWR_COUPLE_006_what_lies_between_two_looks_is_not_missed(void)
{
    const int32_t from[ROBOT_AXIS_MAX] = {0, 0, 0, -106250};
    const int32_t to[ROBOT_AXIS_MAX] = {0, 0, 0, 93750};
    robot.coupled_limits[SADDLE].minimum = -1000000000;
    robot.coupled_limits[SADDLE].maximum = -500000;
    TEST_ASSERT_GREATER_THAN_INT64(499000, beyond_nm(from, to));
    TEST_ASSERT_EQUAL_UINT8(40U + SADDLE, coupled_path_judge(&robot, from, to).status);
    robot.coupled_limits[SADDLE].maximum = 1000000;
    TEST_ASSERT_EQUAL_UINT8(STATUS_OK, coupled_path_judge(&robot, from, to).status);
}

void test_SWR_COUPLE_006_between_two_legal_places_the_way_may_not_be(void)
{
    const int32_t from[ROBOT_AXIS_MAX] = {0, 13000, 1000};
    const int32_t to[ROBOT_AXIS_MAX] = {0, 1000, 13000};
    const solution_t above = coupled_path_judge(&robot, from, to);
    TEST_ASSERT_EQUAL_INT64(260000, saddle_nm(from));
    TEST_ASSERT_EQUAL_UINT8(STATUS_OK, above.status);
    robot.coupled_limits[SADDLE].maximum = 1150000;
    TEST_ASSERT_EQUAL_UINT8(40U + SADDLE, coupled_path_judge(&robot, from, to).status);
    TEST_ASSERT_EQUAL_UINT8(1U, coupled_path_judge(&robot, from, to).is_maximum);
    /* 7 mm by 7 mm in the middle are 0.98 mm: 0.2 mm of margin. */
    robot.coupled_limits[SADDLE].maximum = 1180000;
    TEST_ASSERT_EQUAL_UINT8(STATUS_OK, coupled_path_judge(&robot, from, to).status);
    robot.coupled_limits[SADDLE].maximum = 1179999;
    TEST_ASSERT_EQUAL_UINT8(40U + SADDLE, coupled_path_judge(&robot, from, to).status);
}

void test_SWR_COUPLE_006_a_way_that_is_too_low_is_refused_as_such(void)
{
    const int32_t from[ROBOT_AXIS_MAX] = {0, -13000, 1000};
    const int32_t to[ROBOT_AXIS_MAX] = {0, -1000, 13000};
    robot.coupled_limits[SADDLE].minimum = -1180000;
    TEST_ASSERT_EQUAL_UINT8(STATUS_OK, coupled_path_judge(&robot, from, to).status);
    robot.coupled_limits[SADDLE].minimum = -1179999;
    const solution_t judged = coupled_path_judge(&robot, from, to);
    TEST_ASSERT_EQUAL_UINT8(40U + SADDLE, judged.status);
    TEST_ASSERT_EQUAL_UINT8(0U, judged.is_maximum);
}

void test_SWR_COUPLE_006_who_begins_outside_may_come_back_but_go_no_farther_out(void)
{
    const int32_t out[ROBOT_AXIS_MAX] = {13000};
    const int32_t in[ROBOT_AXIS_MAX] = {5000};
    const int32_t farther[ROBOT_AXIS_MAX] = {13001};
    const int32_t low[ROBOT_AXIS_MAX] = {0, 0, 0, 13000};
    const int32_t lower[ROBOT_AXIS_MAX] = {0, 0, 0, 13001};
    TEST_ASSERT_GREATER_THAN_INT64(3000000, saddle_nm(out));
    TEST_ASSERT_EQUAL_UINT8(STATUS_OK, coupled_path_judge(&robot, out, in).status);
    TEST_ASSERT_EQUAL_UINT8(40U + SADDLE, coupled_path_judge(&robot, in, out).status);
    TEST_ASSERT_EQUAL_UINT8(40U + SADDLE, coupled_path_judge(&robot, out, farther).status);
    TEST_ASSERT_EQUAL_UINT8(STATUS_OK, coupled_path_judge(&robot, low, in).status);
    TEST_ASSERT_EQUAL_UINT8(40U + SADDLE, coupled_path_judge(&robot, low, lower).status);
}

void test_SWR_COUPLE_006_the_first_limit_that_is_left_is_named(void)
{
    const int32_t from[ROBOT_AXIS_MAX] = {0};
    const int32_t to[ROBOT_AXIS_MAX] = {13000};
    robot.coupled_limit_count = LIMITS + 1U;
    robot.coupled_limits[LIMITS] = robot.coupled_limits[SADDLE];
    robot.coupled_limits[LIMITS].refusal = 50U;
    TEST_ASSERT_EQUAL_UINT8(40U + SADDLE, coupled_path_judge(&robot, from, to).status);
    robot.coupled_limits[SADDLE].maximum = 9000000;
    TEST_ASSERT_EQUAL_UINT8(50U, coupled_path_judge(&robot, from, to).status);
}

/* Ends decide about a limit that is not curved, and they are judged elsewhere. */
void test_SWR_COUPLE_006_only_curved_limits_are_looked_at_and_so_often(void)
{
    const int32_t from[ROBOT_AXIS_MAX] = {0};
    const int32_t to[ROBOT_AXIS_MAX] = {1000, -9000, 1};
    looks = 0U;
    TEST_ASSERT_EQUAL_UINT8(STATUS_OK, coupled_path_judge(&robot, from, to).status);
    TEST_ASSERT_EQUAL_UINT32(LOOKS, looks);
    robot.coupled_limits[SADDLE].is_curved = 0U;
    looks = 0U;
    TEST_ASSERT_EQUAL_UINT8(STATUS_OK, coupled_path_judge(&robot, from, to).status);
    TEST_ASSERT_EQUAL_UINT32(0U, looks);
}

void test_SWR_COUPLE_006_the_farthest_ways_have_an_answer(void)
{
    const int32_t from[ROBOT_AXIS_MAX] = {INT32_MIN, INT32_MAX, INT32_MIN, 0};
    const int32_t to[ROBOT_AXIS_MAX] = {INT32_MAX, INT32_MIN, INT32_MAX, INT32_MAX};
    TEST_ASSERT_EQUAL_UINT8(40U + SADDLE, coupled_path_judge(&robot, from, to).status);
    TEST_ASSERT_EQUAL_UINT8(40U + SADDLE, coupled_path_judge(&robot, to, from).status);
}
