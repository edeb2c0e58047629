/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: only finite numbers within their range cross the border, to the nearest integer.
 */
#include "base/fixed.h"
#include "base/rigid.h"
#include "igtl/dialect/igtl_units.h"
#include "igtl/wire/igtl_codec.h"
#include "robot/robot.h"
#include "unity.h"

#include <math.h>
#include <string.h>

static uint32_t numbers[IGTL_TRANSFORM_NUMBERS];
static rigid_t pose;

static uint32_t bits_of(double number)
{
    const float narrow = (float)number;
    uint32_t bits;

    (void)memcpy(&bits, &narrow, sizeof bits);
    return bits;
}

void setUp(void)
{
    (void)memset(numbers, 0, sizeof numbers);
    numbers[0] = bits_of(1.0);
    numbers[4] = bits_of(1.0);
    numbers[8] = bits_of(1.0);
}

void tearDown(void)
{
}

static void expect_nm(double millimetres, int32_t expected_nm)
{
    int32_t length_nm = 0;

    TEST_ASSERT_EQUAL_INT(STATUS_OK, igtl_units_read_mm(bits_of(millimetres), &length_nm));
    TEST_ASSERT_EQUAL_INT32(expected_nm, length_nm);
}

void test_SWR_IGTL_010_millimetres_become_nanometres(void)
{
    expect_nm(0.0, 0);
    expect_nm(-0.0, 0);
    expect_nm(1.0, 1000000);
    expect_nm(-12.5, -12500000);
    expect_nm(0.000001, 1);
    expect_nm(-0.0000006, -1);
    expect_nm(0.0000004, 0);
    expect_nm(1e-30, 0);
    expect_nm(1e-44, 0);
    expect_nm(2000.0, 2000000000);
    expect_nm(-2000.0, -2000000000);
}

void test_SWR_IGTL_010_each_length_is_the_nearest_nanometre(void)
{
    uint32_t seed = 7U;

    for (uint32_t i = 0U; i < 100000U; i++) {
        int32_t length_nm = 0;
        uint32_t bits;
        float number;

        seed = (seed * 1664525U) + 1013904223U;
        bits = bits_of((((double)seed / 4294967296.0) - 0.5) * 3999.0);
        (void)memcpy(&number, &bits, sizeof number);
        TEST_ASSERT_EQUAL_INT(STATUS_OK, igtl_units_read_mm(bits, &length_nm));
        TEST_ASSERT_EQUAL_INT32((int32_t)lround((double)number * 1e6), length_nm);
    }
}

void test_SWR_IGTL_010_two_metres_is_the_farthest(void)
{
    int32_t length_nm;

    TEST_ASSERT_EQUAL_INT(STATUS_OUT_OF_RANGE,
                          igtl_units_read_mm(bits_of(2000.0) + 1U, &length_nm));
    TEST_ASSERT_EQUAL_INT(STATUS_OUT_OF_RANGE, igtl_units_read_mm(bits_of(-2047.9), &length_nm));
    TEST_ASSERT_EQUAL_INT(STATUS_OUT_OF_RANGE, igtl_units_read_mm(bits_of(2048.0), &length_nm));
    TEST_ASSERT_EQUAL_INT(STATUS_OUT_OF_RANGE, igtl_units_read_mm(0x7F7FFFFFU, &length_nm));
}

void test_SWR_IGTL_010_what_is_not_finite_is_refused_everywhere(void)
{
    static const uint32_t odd[] = {0x7F800000U, 0xFF800000U, 0x7FC00000U, 0x7F800001U, 0xFFFFFFFFU};

    for (uint32_t i = 0U; i < 12U; i++) {
        for (uint32_t k = 0U; k < 5U; k++) {
            setUp();
            numbers[i] = odd[k];
            TEST_ASSERT_EQUAL_INT(STATUS_NOT_FINITE, igtl_units_read_pose(numbers, &pose));
        }
    }
}

void test_SWR_IGTL_010_rotation_entries_are_bounded(void)
{
    int32_t entry_q30;

    TEST_ASSERT_EQUAL_INT(STATUS_OK, igtl_units_read_entry(bits_of(1.0009), &entry_q30));
    TEST_ASSERT_EQUAL_INT(STATUS_NOT_RIGID, igtl_units_read_entry(bits_of(1.0011), &entry_q30));
    TEST_ASSERT_EQUAL_INT(STATUS_NOT_RIGID, igtl_units_read_entry(bits_of(-1.0011), &entry_q30));
    TEST_ASSERT_EQUAL_INT(STATUS_NOT_RIGID, igtl_units_read_entry(bits_of(2.0), &entry_q30));
    TEST_ASSERT_EQUAL_INT(STATUS_NOT_RIGID, igtl_units_read_entry(bits_of(1e30), &entry_q30));
    TEST_ASSERT_EQUAL_INT(STATUS_OK, igtl_units_read_entry(bits_of(-0.5), &entry_q30));
    TEST_ASSERT_EQUAL_INT32(-(FIXED_ONE_Q30 / 2), entry_q30);
}

void test_SWR_IGTL_010_each_entry_of_a_matrix_is_bounded(void)
{
    for (uint32_t i = 0U; i < 9U; i++) {
        setUp();
        numbers[i] = bits_of(-1.1);
        TEST_ASSERT_EQUAL_INT(STATUS_NOT_RIGID, igtl_units_read_pose(numbers, &pose));
    }
}

void test_SWR_IGTL_010_far_translation_is_refused(void)
{
    numbers[11] = bits_of(2500.0);
    TEST_ASSERT_EQUAL_INT(STATUS_OUT_OF_RANGE, igtl_units_read_pose(numbers, &pose));
    numbers[11] = bits_of(-2500.0);
    TEST_ASSERT_EQUAL_INT(STATUS_OUT_OF_RANGE, igtl_units_read_pose(numbers, &pose));
}

void test_SWR_IGTL_010_columns_of_the_message_are_columns_of_the_matrix(void)
{
    numbers[0] = bits_of(0.0);
    numbers[1] = bits_of(1.0); /* First column (0 1 0). */
    numbers[3] = bits_of(-1.0);
    numbers[4] = bits_of(0.0); /* Second column (-1 0 0). */
    numbers[9] = bits_of(10.0);
    numbers[10] = bits_of(-20.0);
    numbers[11] = bits_of(30.0);
    TEST_ASSERT_EQUAL_INT(STATUS_OK, igtl_units_read_pose(numbers, &pose));
    TEST_ASSERT_EQUAL_INT32(FIXED_ONE_Q30, pose.rotation_q30[1][0]);
    TEST_ASSERT_EQUAL_INT32(-FIXED_ONE_Q30, pose.rotation_q30[0][1]);
    TEST_ASSERT_EQUAL_INT32(10000000, pose.translation.x_nm);
    TEST_ASSERT_EQUAL_INT32(-20000000, pose.translation.y_nm);
    TEST_ASSERT_EQUAL_INT32(30000000, pose.translation.z_nm);
}

void test_SWR_IGTL_012_pose_goes_out_as_it_came_in(void)
{
    uint32_t out[IGTL_TRANSFORM_NUMBERS];

    numbers[9] = bits_of(123.456);
    numbers[10] = bits_of(-0.001);
    TEST_ASSERT_EQUAL_INT(STATUS_OK, igtl_units_read_pose(numbers, &pose));
    igtl_units_write_pose(&pose, out);
    TEST_ASSERT_EQUAL_HEX32_ARRAY(numbers, out, 10U);
    TEST_ASSERT_EQUAL_HEX32(bits_of(-0.001), out[10]);
}

static const robot_t robot = {
    .axis_count = 2U,
    .axes = {{.unit = (uint8_t)AXIS_UNIT_MM, .unit_per_tick_q16 = INT64_C(10000) * 65536},
             {.unit = (uint8_t)AXIS_UNIT_RAD, .unit_per_tick_q16 = (INT64_C(1) << 20) * 65536}},
    .reported_joints = {0U, 1U}};

void test_SWR_IGTL_012_joints_go_out_in_millimetres_and_radians(void)
{
    static const int32_t ticks[ROBOT_AXIS_MAX] = {-250, 1024};
    char text[IGTL_LIST_SIZE];

    igtl_units_write_positions(&robot, ticks, text);
    TEST_ASSERT_EQUAL_STRING("-2.500000,1.570796,", text);
}

void test_SWR_IGTL_012_speeds_go_out_per_second(void)
{
    static const int32_t speeds_q8[ROBOT_AXIS_MAX] = {25600, -262144};
    char text[IGTL_LIST_SIZE];

    igtl_units_write_speeds(&robot, speeds_q8, text);
    TEST_ASSERT_EQUAL_STRING("1.000000,-1.570796,", text);
}

void test_SWR_IGTL_038_lists_have_the_order_that_the_robot_names(void)
{
    static const int32_t counts[ROBOT_AXIS_MAX] = {-25600, 1024};
    char text[IGTL_LIST_SIZE];
    robot_t other = robot;

    other.reported_joints[0] = 1U;
    other.reported_joints[1] = 0U;
    igtl_units_write_positions(&other, counts, text);
    TEST_ASSERT_EQUAL_STRING("1.570796,-256.000000,", text);
    igtl_units_write_speeds(&other, counts, text);
    TEST_ASSERT_EQUAL_STRING("0.006136,-1.000000,", text);
}

/* The only number of an array. */
static const igtl_message_t *array_of(uint64_t bits, uint32_t bytes)
{
    static uint8_t content[14];
    static igtl_message_t message;

    message = (igtl_message_t){.content = content, .number_bytes = bytes};
    for (uint32_t i = 0U; i < bytes; i++) {
        content[6U + i] = (uint8_t)(bits >> (8U * (bytes - 1U - i)));
    }
    return &message;
}

static status_t read_whole(uint64_t bits, uint32_t bytes, int32_t *value)
{
    return igtl_units_read_whole(array_of(bits, bytes), 0U, value);
}

static status_t read_double(double number, int32_t *value)
{
    uint64_t bits;

    (void)memcpy(&bits, &number, sizeof bits);
    return read_whole(bits, 8U, value);
}

void test_SWR_TRAJ_023_whole_numbers_of_an_array_are_read_to_the_last(void)
{
    static const int32_t numbers_of[] = {0,        1,        -1,        2,         3,
                                         16777215, 16777216, -16777217, INT32_MAX, -INT32_MAX};
    int32_t value;

    for (uint32_t i = 0U; i < (sizeof numbers_of / sizeof numbers_of[0]); i++) {
        value = 77;
        TEST_ASSERT_EQUAL_INT(STATUS_OK, read_double((double)numbers_of[i], &value));
        TEST_ASSERT_EQUAL_INT32(numbers_of[i], value);
    }
    TEST_ASSERT_EQUAL_INT(STATUS_OK, read_double(-0.0, &value));
    TEST_ASSERT_EQUAL_INT32(0, value);
    TEST_ASSERT_EQUAL_INT(STATUS_OK, read_whole(bits_of(-30000.0), 4U, &value));
    TEST_ASSERT_EQUAL_INT32(-30000, value);
    TEST_ASSERT_EQUAL_INT(STATUS_OK, read_whole(bits_of(1073741824.0), 4U, &value));
    TEST_ASSERT_EQUAL_INT32(1073741824, value);
}

void test_SWR_TRAJ_023_other_numbers_of_an_array_are_refused(void)
{
    static const double others[] = {0.5,      -1.5,         0.999999999,   1e-300,
                                    4.9e-324, 2147483648.0, -2147483648.0, 4503599627370497.0,
                                    1e16,     1e308};
    int32_t value;

    for (uint32_t i = 0U; i < (sizeof others / sizeof others[0]); i++) {
        TEST_ASSERT_EQUAL_INT(STATUS_OUT_OF_RANGE, read_double(others[i], &value));
    }
    TEST_ASSERT_EQUAL_INT(STATUS_NOT_FINITE, read_double(NAN, &value));
    TEST_ASSERT_EQUAL_INT(STATUS_NOT_FINITE, read_double(-INFINITY, &value));
    TEST_ASSERT_EQUAL_INT(STATUS_OUT_OF_RANGE, read_whole(bits_of(0.25), 4U, &value));
    TEST_ASSERT_EQUAL_INT(STATUS_OUT_OF_RANGE, read_whole(bits_of(2147483648.0), 4U, &value));
    TEST_ASSERT_EQUAL_INT(STATUS_OUT_OF_RANGE, read_whole(bits_of(3e38), 4U, &value));
    TEST_ASSERT_EQUAL_INT(STATUS_OUT_OF_RANGE, read_whole(1U, 4U, &value));
    TEST_ASSERT_EQUAL_INT(STATUS_NOT_FINITE, read_whole(bits_of(INFINITY), 4U, &value));
}

void test_SWR_PROG_014_every_finite_number_of_an_array_is_read_as_it_is(void)
{
    static const double numbers_of[] = {0.0, 0.1, -90.25, 4.9e-324, -1.7976931348623157e308};
    double value = 77.0;

    for (uint32_t i = 0U; i < (sizeof numbers_of / sizeof numbers_of[0]); i++) {
        uint64_t bits;

        (void)memcpy(&bits, &numbers_of[i], sizeof bits);
        TEST_ASSERT_EQUAL_INT(STATUS_OK, igtl_units_read_double(array_of(bits, 8U), 0U, &value));
        TEST_ASSERT_EQUAL_MEMORY(&numbers_of[i], &value, sizeof value);
    }
    TEST_ASSERT_EQUAL_INT(STATUS_OK,
                          igtl_units_read_double(array_of(bits_of(-2.75), 4U), 0U, &value));
    TEST_ASSERT_EQUAL_DOUBLE(-2.75, value);
    TEST_ASSERT_EQUAL_INT(STATUS_NOT_FINITE,
                          igtl_units_read_double(array_of(bits_of(NAN), 4U), 0U, &value));
    TEST_ASSERT_EQUAL_INT(
        STATUS_NOT_FINITE,
        igtl_units_read_double(array_of(UINT64_C(0xFFF0000000000000), 8U), 0U, &value));
}

void test_SWR_IGTL_012_a_list_of_all_axes_that_a_robot_may_have_is_whole(void)
{
    robot_t longest = {.axis_count = ROBOT_AXIS_MAX};
    int32_t ticks[ROBOT_AXIS_MAX];
    char text[IGTL_LIST_SIZE];

    for (uint32_t i = 0U; i < ROBOT_AXIS_MAX; i++) {
        longest.axes[i] = robot.axes[0];
        longest.reported_joints[i] = (uint8_t)i;
        ticks[i] = -214748364;
    }
    igtl_units_write_positions(&longest, ticks, text);
    TEST_ASSERT_EQUAL_UINT(ROBOT_AXIS_MAX * strlen("-2147483.640000,"), strlen(text));
}
