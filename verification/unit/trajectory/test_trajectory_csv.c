/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: columns are taken by their names and units, whatever their order; what cannot be
 * read is refused with its line.
 */
#include "unity.h"

#include "robot/robot_neuro.h"
#include "trajectory/trajectory_csv.h"

#include <stdio.h>
#include <string.h>

static trajectory_csv_t table;
static int32_t stands[ROBOT_AXIS_MAX];

void setUp(void)
{
    memset(&table, 0, sizeof table);
    for (uint32_t i = 0U; i < ROBOT_AXIS_MAX; i++) {
        stands[i] = 100 + (int32_t)i;
    }
}

void tearDown(void)
{
}

static void expect(uint32_t line, const char *text)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(line, trajectory_csv_read(&table, text, &robot_neuro, stands),
                                     text);
}

void test_SWR_TRAJ_015_columns_are_taken_by_name_in_any_order(void)
{
    expect(0U, "feet ticks,time s,head ticks,head ticks/s\n1,0,2,0\n3,1.5,4,-5\n");
    TEST_ASSERT_EQUAL_UINT32(2U, table.count);
    TEST_ASSERT_EQUAL_UINT32(1500U, table.rows[1].time_ms);
    TEST_ASSERT_EQUAL_INT32(3, table.rows[1].ticks[NEURO_AXIS_FEET]);
    TEST_ASSERT_EQUAL_INT32(4, table.rows[1].ticks[NEURO_AXIS_HEAD]);
    TEST_ASSERT_EQUAL_INT32(-5, table.rows[1].speeds_ticks_per_s[NEURO_AXIS_HEAD]);
}

void test_SWR_TRAJ_015_an_axis_without_a_column_stays(void)
{
    expect(0U, "time ms,yaw ticks\n10,0\n20,1");
    TEST_ASSERT_EQUAL_UINT32(20U, table.rows[1].time_ms);
    TEST_ASSERT_EQUAL_INT32(100 + (int32_t)NEURO_AXIS_PITCH, table.rows[1].ticks[NEURO_AXIS_PITCH]);
    TEST_ASSERT_EQUAL_INT32(0, table.rows[1].speeds_ticks_per_s[NEURO_AXIS_PITCH]);
}

void test_SWR_TRAJ_015_units_become_ticks(void)
{
    expect(0U, "time s,head mm,yaw deg,head mm/s,yaw deg/s\r\n0,-10,-36,2,9\r\n\r\n");
    TEST_ASSERT_INT32_WITHIN(1, -787, table.rows[0].ticks[NEURO_AXIS_HEAD]); /* 78.74 a mm */
    TEST_ASSERT_INT32_WITHIN(1, -500, table.rows[0].ticks[NEURO_AXIS_YAW]);  /* 795.8 a rad */
    TEST_ASSERT_INT32_WITHIN(1, 157, table.rows[0].speeds_ticks_per_s[NEURO_AXIS_HEAD]);
    TEST_ASSERT_INT32_WITHIN(1, 125, table.rows[0].speeds_ticks_per_s[NEURO_AXIS_YAW]);
}

void test_SWR_TRAJ_015_speeds_that_are_not_reported_overshoot_no_row(void)
{
    expect(0U, "time s,yaw ticks\n0,0\n1,100\n2,400\n3,300\n4,300\n");
    TEST_ASSERT_EQUAL_INT32(0, table.rows[0].speeds_ticks_per_s[NEURO_AXIS_YAW]);
    TEST_ASSERT_EQUAL_INT32(150, table.rows[1].speeds_ticks_per_s[NEURO_AXIS_YAW]);
    TEST_ASSERT_EQUAL_INT32(0, table.rows[2].speeds_ticks_per_s[NEURO_AXIS_YAW]);
    TEST_ASSERT_EQUAL_INT32(0, table.rows[3].speeds_ticks_per_s[NEURO_AXIS_YAW]);
    TEST_ASSERT_EQUAL_INT32(0, table.rows[4].speeds_ticks_per_s[NEURO_AXIS_YAW]);
}

void test_SWR_TRAJ_015_times_that_do_not_grow_are_left_to_control(void)
{
    expect(0U, "time s,yaw ticks\n1,0\n1,100\n0,200\n");
    TEST_ASSERT_EQUAL_UINT32(3U, table.count);
}

void test_SWR_TRAJ_015_a_head_that_says_too_little_or_too_much_is_refused(void)
{
    static const char *const wrong[] = {
        "",
        "\n",
        "yaw ticks\n1\n",
        "time s,time ms\n1,1\n",
        "time s,yaw\n0,0\n",
        "time s,yaw mm\n0,0\n",
        "time s,head deg\n0,0\n",
        "time s,yaw ticks/min\n0,0\n",
        "time s,yaw ticks,yaw ticks\n0,0,0\n",
        "time s,yaw ticks,yaw deg\n0,0,0\n",
        "time s,yaw ticks/s\n0,0\n",
        "time h,yaw ticks\n0,0\n",
        "time s,nose ticks\n0,0\n",
        "time s, yaw ticks\n0,0\n",
        "time s,yaw ticks,\n0,0,0\n",
        "time s,yawyawyawyawyawyawyawyawyawyaw ticks\n0,0\n",
        "time s,yaw ticks\rx\n0,0\n",
    };
    for (uint32_t i = 0U; i < (sizeof wrong / sizeof wrong[0]); i++) {
        expect(1U, wrong[i]);
    }
}

void test_SWR_TRAJ_015_a_row_that_cannot_be_read_is_refused_with_its_line(void)
{
    static const char *const wrong[] = {"1\n",     "1,\n",    "1,x\n",   "1,nan\n", "1,inf\n",
                                        "1,2,3\n", "1 ,2\n",  "1, 2\n",  "-1,2\n",  "1,3e9\n",
                                        "1,2;\n",  "1,0x1\n", "9e9,1\n", "\n1,2\n", "1,1e999\n",
                                        "1,+\n",   "1,2\r3\n"};
    for (uint32_t i = 0U; i < (sizeof wrong / sizeof wrong[0]); i++) {
        char text[80];
        (void)snprintf(text, sizeof text, "time s,yaw ticks\n0,0\n%s", wrong[i]);
        expect(3U, text);
    }
    expect(2U, "time s,yaw ticks\n");
}

void test_SWR_TRAJ_015_rows_that_have_no_room_are_refused_with_the_first(void)
{
    static char text[16U * (LIMIT_TRAJECTORY_ROWS + 4U)];
    size_t size = (size_t)snprintf(text, sizeof text, "time ms,yaw ticks\n");
    for (uint32_t i = 0U; i < LIMIT_TRAJECTORY_ROWS; i++) {
        size += (size_t)snprintf(&text[size], sizeof text - size, "%u,0\n", (unsigned)i);
    }
    expect(0U, text);
    TEST_ASSERT_EQUAL_UINT32(LIMIT_TRAJECTORY_ROWS, table.count);
    (void)snprintf(&text[size], sizeof text - size, "99999,0\n");
    expect(LIMIT_TRAJECTORY_ROWS + 2U, text);
}

void test_SWR_TRAJ_020_where_no_axis_is_known_to_stand_each_has_a_column(void)
{
    static const char head[] = "time s,feet ticks,head ticks,rotation ticks,pitch ticks,yaw ticks";
    char text[200];
    (void)snprintf(text, sizeof text, "%s\n0,1,2,3,4,5\n", head);
    TEST_ASSERT_EQUAL_UINT32(1U, trajectory_csv_read(&table, text, &robot_neuro, NULL));
    size_t size = (size_t)snprintf(text, sizeof text, "time s");
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        size += (size_t)snprintf(&text[size], sizeof text - size, ",%s ticks",
                                 robot_neuro.axes[i].name);
    }
    (void)snprintf(&text[size], sizeof text - size, "\n0,1,2,3,4,5,6,7\n");
    TEST_ASSERT_EQUAL_UINT32(0U, trajectory_csv_read(&table, text, &robot_neuro, NULL));
    TEST_ASSERT_EQUAL_INT32(7, table.rows[0].ticks[6]);
}
