/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a trajectory is held whole or not at all, and each row was judged with the way
 * to it.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "mode/lists/trajectory_list.h"
#include "mode/lists/trajectory_row.h"
#include "robot/joints.h"
#include "robot/robot_neuro.h"
#include "safety/needle.h"

#include <string.h>

static robot_t robot;
static trajectory_list_t list;
static trajectory_row_t rows[LIMIT_TRAJECTORY_ROWS];
static trajectory_row_t row;
static uint32_t sum;

void setUp(void)
{
    robot = robot_neuro;
    memset(&list, 0, sizeof list);
    memset(rows, 0, sizeof rows);
    memset(&row, 0, sizeof row);
    sum = 0U;
}

void tearDown(void)
{
}

static void begin(uint32_t total)
{
    TEST_ASSERT_EQUAL(STATUS_OK, trajectory_list_begin(&list, total));
}

static solution_t add(uint32_t index, uint32_t time_ms)
{
    row.time_ms = time_ms;
    sum = trajectory_list_crc(sum, &row);
    return trajectory_list_add(&list, rows, &robot, index, &row);
}

static void expect(status_t status, uint32_t index, uint32_t time_ms)
{
    const solution_t judged = add(index, time_ms);
    TEST_ASSERT_EQUAL(status, judged.status);
    if (status != STATUS_OK) {
        TEST_ASSERT_EACH_EQUAL_UINT32(0U, &list, sizeof list / sizeof(uint32_t));
    }
}

void test_SWR_TRAJ_001_a_list_is_whole_once_all_rows_and_their_checksum_have_come(void)
{
    begin(3U);
    expect(STATUS_OK, 0U, 0U);
    row.ticks[NEURO_AXIS_HEAD] = -200;
    expect(STATUS_OK, 1U, 2000U);
    row.ticks[NEURO_AXIS_HEAD] = -100;
    expect(STATUS_OK, 2U, 4000U);
    TEST_ASSERT_EQUAL_UINT32(0U, list.is_whole);
    TEST_ASSERT_EQUAL(STATUS_OK, trajectory_list_end(&list, sum));
    TEST_ASSERT_EQUAL_UINT32(1U, list.is_whole);
    TEST_ASSERT_EQUAL_UINT32(3U, list.count);
    TEST_ASSERT_EQUAL_INT32(-200, rows[1].ticks[NEURO_AXIS_HEAD]);
    TEST_ASSERT_TRUE(trajectory_row_is_whole(&rows[1]));
}

void test_SWR_TRAJ_001_another_checksum_leaves_nothing(void)
{
    begin(1U);
    expect(STATUS_OK, 0U, 0U);
    TEST_ASSERT_EQUAL(STATUS_TRAJECTORY_SUM, trajectory_list_end(&list, sum ^ 1U));
    TEST_ASSERT_EQUAL_UINT32(0U, list.total);
}

void test_SWR_TRAJ_001_the_order_of_rows_changes_the_checksum(void)
{
    trajectory_row_t other = row;
    other.time_ms = 1U;
    TEST_ASSERT_NOT_EQUAL(trajectory_list_crc(trajectory_list_crc(0U, &row), &other),
                          trajectory_list_crc(trajectory_list_crc(0U, &other), &row));
}

void test_SWR_TRAJ_001_a_missing_row_leaves_nothing(void)
{
    begin(2U);
    expect(STATUS_OK, 0U, 0U);
    TEST_ASSERT_EQUAL(STATUS_TRAJECTORY_ORDER, trajectory_list_end(&list, sum));
    TEST_ASSERT_EQUAL_UINT32(0U, list.total);
    TEST_ASSERT_EQUAL(STATUS_TRAJECTORY_ORDER, trajectory_list_end(&list, 0U));
}

void test_SWR_TRAJ_001_a_row_out_of_turn_is_refused(void)
{
    begin(3U);
    expect(STATUS_OK, 0U, 0U);
    expect(STATUS_TRAJECTORY_ORDER, 2U, 1000U);
    begin(3U);
    expect(STATUS_OK, 0U, 0U);
    expect(STATUS_TRAJECTORY_ORDER, 0U, 1000U);
    expect(STATUS_TRAJECTORY_ORDER, 0U, 0U); /* No list was begun. */
    begin(1U);
    expect(STATUS_OK, 0U, 0U);
    expect(STATUS_TRAJECTORY_ORDER, 1U, 1000U);
}

void test_SWR_TRAJ_001_a_whole_list_takes_no_row_more(void)
{
    begin(1U);
    expect(STATUS_OK, 0U, 0U);
    TEST_ASSERT_EQUAL(STATUS_OK, trajectory_list_end(&list, sum));
    list.total = 2U;
    expect(STATUS_TRAJECTORY_ORDER, 1U, 1000U);
}

void test_SWR_TRAJ_001_more_rows_than_there_is_room_for_are_refused(void)
{
    begin(2U);
    TEST_ASSERT_EQUAL(STATUS_OUT_OF_RANGE,
                      trajectory_list_begin(&list, LIMIT_TRAJECTORY_ROWS + 1U));
    TEST_ASSERT_EQUAL_UINT32(2U, list.total);
    begin(LIMIT_TRAJECTORY_ROWS);
    list.total = UINT32_MAX; /* However it came to that. */
    list.count = LIMIT_TRAJECTORY_ROWS;
    expect(STATUS_TRAJECTORY_ORDER, LIMIT_TRAJECTORY_ROWS, 1000U);
}

void test_SWR_TRAJ_002_the_time_of_each_row_is_after_that_of_the_row_before(void)
{
    static const uint32_t wrong[] = {1000U, 999U, 1000U + LIMIT_TRAJECTORY_STEP_LEAST_MS - 1U,
                                     1000U + LIMIT_TRAJECTORY_STEP_MOST_MS + 1U};
    for (uint32_t i = 0U; i < (sizeof wrong / sizeof wrong[0]); i++) {
        begin(3U);
        expect(STATUS_OK, 0U, 1000U);
        expect(STATUS_TRAJECTORY_ORDER, 1U, wrong[i]);
    }
    begin(3U);
    expect(STATUS_OK, 0U, 1000U);
    expect(STATUS_OK, 1U, 1000U + LIMIT_TRAJECTORY_STEP_LEAST_MS);
    begin(3U);
    expect(STATUS_OK, 0U, 1000U);
    expect(STATUS_OK, 1U, 1000U + LIMIT_TRAJECTORY_STEP_MOST_MS);
    begin(2U);
    expect(STATUS_OK, 0U, LIMIT_TRAJECTORY_TIME_MS);
    begin(2U);
    expect(STATUS_TRAJECTORY_ORDER, 0U, LIMIT_TRAJECTORY_TIME_MS + 1U);
}

void test_SWR_TRAJ_003_a_way_that_is_too_fast_is_refused_with_its_axis(void)
{
    const int64_t most = ((int64_t)robot.axes[NEURO_AXIS_YAW].speed_ticks_per_s *
                          (int64_t)LIMIT_PROFILE_SPEED_PERCENT) /
                         100;
    const int32_t way = (int32_t)((most * 2) / 3); /* From rest to rest in a second. */
    begin(2U);
    expect(STATUS_OK, 0U, 0U);
    row.ticks[NEURO_AXIS_YAW] = -way - 2;
    const solution_t judged = add(1U, 1000U);
    TEST_ASSERT_EQUAL(STATUS_TRAJECTORY_SPEED, judged.status);
    TEST_ASSERT_EQUAL_UINT8(NEURO_AXIS_YAW, judged.axis);
}

void test_SWR_TRAJ_003_a_way_that_begins_too_suddenly_is_refused(void)
{
    const int32_t most = robot.axes[NEURO_AXIS_YAW].acceleration_ticks_per_s2;
    begin(3U);
    expect(STATUS_OK, 0U, 0U);
    row.ticks[NEURO_AXIS_YAW] = -most / (6 * 16);
    expect(STATUS_OK, 1U, 250U);
    row.ticks[NEURO_AXIS_YAW] -= (most / (6 * 16)) + 2;
    expect(STATUS_TRAJECTORY_SPEED, 2U, 500U);
}

void test_SWR_TRAJ_003_a_row_is_no_faster_than_its_axis(void)
{
    const int32_t most =
        (robot.axes[NEURO_AXIS_YAW].speed_ticks_per_s * (int32_t)LIMIT_PROFILE_SPEED_PERCENT) / 100;
    for (int32_t sign = -1; sign <= 1; sign += 2) {
        row.speeds_ticks_per_s[NEURO_AXIS_YAW] = 0;
        begin(3U);
        expect(STATUS_OK, 0U, 0U);
        row.speeds_ticks_per_s[NEURO_AXIS_YAW] = sign * (most + 1);
        const solution_t judged = add(1U, 1000U);
        TEST_ASSERT_EQUAL(STATUS_TRAJECTORY_SPEED, judged.status);
        TEST_ASSERT_EQUAL_UINT8(NEURO_AXIS_YAW, judged.axis);
        TEST_ASSERT_EQUAL_UINT8((sign > 0) ? 1U : 0U, judged.is_maximum);
    }
}

void test_SWR_TRAJ_003_the_first_and_the_last_row_rest(void)
{
    row.speeds_ticks_per_s[NEURO_AXIS_HEAD] = 1;
    begin(2U);
    expect(STATUS_TRAJECTORY_SPEED, 0U, 0U);
    row.speeds_ticks_per_s[NEURO_AXIS_HEAD] = 0;
    begin(2U);
    expect(STATUS_OK, 0U, 0U);
    row.speeds_ticks_per_s[NEURO_AXIS_YAW] = -1;
    expect(STATUS_TRAJECTORY_SPEED, 1U, 1000U);
}

/* An axis that homing has left a little beyond may stay there. */
void test_SWR_TRAJ_004_no_axis_begins_beyond_where_homing_may_have_left_it(void)
{
    const axis_config_t *const head = &robot.axes[NEURO_AXIS_HEAD];
    row.ticks[NEURO_AXIS_HEAD] = head->minimum_ticks - head->home_way_ticks - 1;
    begin(1U);
    solution_t judged = add(0U, 0U);
    TEST_ASSERT_EQUAL(STATUS_AXIS_LIMIT, judged.status);
    TEST_ASSERT_EQUAL_UINT8(NEURO_AXIS_HEAD, judged.axis);
    TEST_ASSERT_EQUAL_UINT8(0U, judged.is_maximum);
    row.ticks[NEURO_AXIS_HEAD] = head->maximum_ticks + head->home_way_ticks + 1;
    begin(1U);
    judged = add(0U, 0U);
    TEST_ASSERT_EQUAL(STATUS_AXIS_LIMIT, judged.status);
    TEST_ASSERT_EQUAL_UINT8(1U, judged.is_maximum);
    row.ticks[NEURO_AXIS_HEAD]--;
    begin(1U);
    expect(STATUS_OK, 0U, 0U);
}

/* At the ends that have no switch. */
void test_SWR_TRAJ_004_no_axis_is_driven_beyond_its_limits(void)
{
    static const uint32_t which[] = {NEURO_AXIS_YAW, NEURO_AXIS_INSERTION};
    for (uint32_t i = 0U; i < 2U; i++) {
        const axis_config_t *const axis = &robot.axes[which[i]];
        const int32_t sign = (i == 0U) ? -1 : 1;
        const int32_t end = (sign < 0) ? axis->minimum_ticks : axis->maximum_ticks;
        row.ticks[NEURO_AXIS_YAW] = 0;
        row.ticks[which[i]] = end - sign;
        begin(3U);
        expect(STATUS_OK, 0U, 0U);
        row.ticks[which[i]] = end;
        expect(STATUS_OK, 1U, 1000U);
        row.ticks[which[i]] = end + sign;
        const solution_t judged = add(2U, 2000U);
        TEST_ASSERT_EQUAL(STATUS_AXIS_LIMIT, judged.status);
        TEST_ASSERT_EQUAL_UINT8(which[i], judged.axis);
        TEST_ASSERT_EQUAL_UINT8((sign > 0) ? 1U : 0U, judged.is_maximum);
    }
}

void test_SWR_TRAJ_004_no_axis_is_driven_to_where_its_switch_may_be_active(void)
{
    const int32_t zone = robot.axes[NEURO_AXIS_INSERTION].target_minimum_ticks - 1;
    row.ticks[NEURO_AXIS_INSERTION] = zone + 1;
    begin(2U);
    expect(STATUS_OK, 0U, 0U);
    row.ticks[NEURO_AXIS_INSERTION] = zone;
    expect(STATUS_SWITCH_ZONE, 1U, 1000U);
    row.ticks[NEURO_AXIS_HEAD] = robot.axes[NEURO_AXIS_HEAD].target_maximum_ticks;
    row.ticks[NEURO_AXIS_INSERTION] = zone + 1;
    begin(2U);
    expect(STATUS_OK, 0U, 0U);
    row.ticks[NEURO_AXIS_HEAD]++;
    const solution_t judged = add(1U, 1000U);
    TEST_ASSERT_EQUAL(STATUS_SWITCH_ZONE, judged.status);
    TEST_ASSERT_EQUAL_UINT8(1U, judged.is_maximum);
}

void test_SWR_TRAJ_004_an_axis_may_stand_where_its_switch_may_be_active_and_leave(void)
{
    const int32_t zone = robot.axes[NEURO_AXIS_INSERTION].target_minimum_ticks;
    row.ticks[NEURO_AXIS_INSERTION] = zone - 2;
    begin(4U);
    expect(STATUS_OK, 0U, 0U);
    expect(STATUS_OK, 1U, 1000U);
    row.ticks[NEURO_AXIS_INSERTION] = zone - 1; /* It would stop there. */
    expect(STATUS_SWITCH_ZONE, 2U, 2000U);
    row.ticks[NEURO_AXIS_INSERTION] = zone - 2;
    begin(2U);
    expect(STATUS_OK, 0U, 0U);
    row.ticks[NEURO_AXIS_INSERTION] = zone + 100;
    expect(STATUS_OK, 1U, 1000U);
    row.ticks[NEURO_AXIS_HEAD] = robot.axes[NEURO_AXIS_HEAD].target_maximum_ticks + 2;
    begin(2U);
    expect(STATUS_OK, 0U, 0U);
    row.ticks[NEURO_AXIS_HEAD]--;
    expect(STATUS_SWITCH_ZONE, 1U, 1000U);
}

/* Both rows are inside, and what their speeds make of the way between is not. */
void test_SWR_TRAJ_004_a_way_that_swings_out_between_two_rows_is_refused(void)
{
    const axis_config_t *const lateral = &robot.axes[NEURO_AXIS_LATERAL];
    const int32_t fast = lateral->speed_ticks_per_s / 2;
    row.ticks[NEURO_AXIS_LATERAL] = lateral->target_maximum_ticks - fast;
    begin(4U);
    expect(STATUS_OK, 0U, 0U);
    row.ticks[NEURO_AXIS_LATERAL] = lateral->target_maximum_ticks - (fast / 8);
    row.speeds_ticks_per_s[NEURO_AXIS_LATERAL] = fast;
    expect(STATUS_OK, 1U, 2000U);
    row.speeds_ticks_per_s[NEURO_AXIS_LATERAL] = -fast;
    const solution_t judged = add(2U, 4000U);
    TEST_ASSERT_EQUAL(STATUS_AXIS_LIMIT, judged.status);
    TEST_ASSERT_EQUAL_UINT8(NEURO_AXIS_LATERAL, judged.axis);
}

void test_SWR_TRAJ_004_limits_that_axes_share_are_kept(void)
{
    row.ticks[NEURO_AXIS_FEET] = robot.axes[NEURO_AXIS_FEET].minimum_ticks;
    begin(1U);
    expect(STATUS_SEPARATION_LIMIT, 0U, 0U);
}

void test_SWR_TRAJ_005_no_axis_goes_sideways_while_the_needle_is_in(void)
{
    row.ticks[NEURO_AXIS_INSERTION] = needle_out_ticks(&robot) + 1;
    begin(4U);
    expect(STATUS_OK, 0U, 0U);
    row.ticks[NEURO_AXIS_ROTATION] = 10;
    expect(STATUS_OK, 1U, 2000U);
    row.ticks[NEURO_AXIS_INSERTION] += 10;
    expect(STATUS_OK, 2U, 4000U);
    row.ticks[NEURO_AXIS_LATERAL] = -200;
    const solution_t judged = add(3U, 6000U);
    TEST_ASSERT_EQUAL(STATUS_NEEDLE_IN, judged.status);
    TEST_ASSERT_EQUAL_UINT8(NEURO_AXIS_LATERAL, judged.axis);
}

void test_SWR_TRAJ_005_with_the_needle_out_they_may(void)
{
    row.ticks[NEURO_AXIS_INSERTION] = needle_out_ticks(&robot);
    begin(2U);
    expect(STATUS_OK, 0U, 0U);
    row.ticks[NEURO_AXIS_LATERAL] = -200;
    expect(STATUS_OK, 1U, 2000U);
}

void test_SWR_TRAJ_012_a_row_that_changed_is_no_ground_for_the_next(void)
{
    begin(2U);
    expect(STATUS_OK, 0U, 0U);
    rows[0].ticks[NEURO_AXIS_YAW] ^= 1;
    expect(STATUS_MEMORY_DAMAGED, 1U, 1000U);
}
