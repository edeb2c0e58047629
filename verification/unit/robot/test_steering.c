/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a curvature becomes the strength of the needle's table, and one that no drive is
 * slow enough for is refused.
 */
#include "unity.h"

#include "robot/robot_neuro.h"
#include "robot/robot_prostate.h"
#include "robot/steering.h"

#include <string.h>

static const steering_law_t law = {.axis = 5U,
                                   .points = 3U,
                                   .most_per_km = 1500U,
                                   .needle_percent = 50U,
                                   .curvature_per_km = {0U, 1000U, 2000U},
                                   .alpha_q16 = {0U, 32768U, 65536U}};
static steering_t steering;

void setUp(void)
{
    (void)memset(&steering, 0xFF, sizeof steering);
}

void tearDown(void)
{
}

/* Whatever the slowest drive. */
static uint32_t alpha_of(const steering_law_t *given, uint32_t curvature_per_km)
{
    steering_law_t any = *given;
    any.most_per_km = UINT32_MAX;
    TEST_ASSERT_EQUAL(STATUS_OK, steering_set(&steering, &any, (uint32_t)STEERING_BIDIRECTIONAL,
                                              curvature_per_km, 0));
    return steering.alpha_q16;
}

static void expect_none(void)
{
    static const steering_t none = {.method = (uint32_t)STEERING_NONE};
    TEST_ASSERT_EQUAL_MEMORY(&none, &steering, sizeof none);
    TEST_ASSERT_FALSE(steering_is_on(&steering));
}

void test_SWR_STEER_004_the_strength_is_that_of_the_points_and_straight_between_them(void)
{
    static const uint32_t rows[][2] = {{0U, 0U},        {1U, 32U},       {500U, 16384U},
                                       {1000U, 32768U}, {1250U, 40960U}, {2000U, 65536U},
                                       {9999U, 65536U}};
    for (uint32_t i = 0U; i < (sizeof rows / sizeof rows[0]); i++) {
        TEST_ASSERT_EQUAL_UINT32(rows[i][1], alpha_of(&law, rows[i][0]));
    }
}

/* The table is full; a number of points beyond it is a damage. */
void test_SWR_STEER_004_no_point_is_read_beyond_the_table(void)
{
    steering_law_t full = {.points = ROBOT_STEERING_POINTS + 1U};
    for (uint32_t i = 0U; i < ROBOT_STEERING_POINTS; i++) {
        full.curvature_per_km[i] = i * 100U;
        full.alpha_q16[i] = i * 1000U;
    }
    TEST_ASSERT_EQUAL_UINT32(7000U, alpha_of(&full, 5000U));
}

void test_SWR_STEER_004_the_published_points_are_those_of_the_robot(void)
{
    TEST_ASSERT_EQUAL_UINT32(52429U, alpha_of(&robot_prostate.steering, 1000U)); /* 0.8 */
    TEST_ASSERT_EQUAL_UINT32(62259U, alpha_of(&robot_prostate.steering, 2200U)); /* 0.95 */
}

void test_SWR_STEER_002_what_is_wanted_is_taken(void)
{
    TEST_ASSERT_EQUAL(STATUS_OK,
                      steering_set(&steering, &law, (uint32_t)STEERING_UNIDIRECTIONAL, 1500U, -90));
    TEST_ASSERT_TRUE(steering_is_on(&steering));
    TEST_ASSERT_EQUAL_UINT32(STEERING_UNIDIRECTIONAL, steering.method);
    TEST_ASSERT_EQUAL_UINT32(1500U, steering.curvature_per_km);
    TEST_ASSERT_EQUAL_UINT32(49152U, steering.alpha_q16);
    TEST_ASSERT_EQUAL_INT32(-90, steering.direction_deg);
    TEST_ASSERT_EQUAL_INT32(-1073741824, steering.direction_bam);
}

void test_SWR_STEER_002_a_direction_counts_as_the_angle_that_it_looks_like(void)
{
    static const int32_t turns_deg[] = {450, 90, -270};
    for (uint32_t i = 0U; i < (sizeof turns_deg / sizeof turns_deg[0]); i++) {
        TEST_ASSERT_EQUAL(STATUS_OK, steering_set(&steering, &law, (uint32_t)STEERING_BIDIRECTIONAL,
                                                  0U, turns_deg[i]));
        TEST_ASSERT_EQUAL_INT32(1073741824, steering.direction_bam);
    }
}

void test_SWR_STEER_002_none_is_taken_whatever_stands_beside_it(void)
{
    TEST_ASSERT_EQUAL(STATUS_OK, steering_set(&steering, &law, (uint32_t)STEERING_NONE, 7U, 8));
    expect_none();
}

void test_SWR_STEER_002_what_cannot_be_is_refused(void)
{
    TEST_ASSERT_EQUAL(STATUS_STEERING_CURVATURE,
                      steering_set(&steering, &law, (uint32_t)STEERING_BIDIRECTIONAL, 1501U, 0));
    expect_none();
    TEST_ASSERT_EQUAL(STATUS_UNKNOWN_COMMAND,
                      steering_set(&steering, &law, STEERING_METHOD_COUNT, 1U, 0));
    expect_none();
    TEST_ASSERT_EQUAL(STATUS_NO_STEERING, steering_set(&steering, &robot_neuro.steering,
                                                       (uint32_t)STEERING_BIDIRECTIONAL, 1U, 0));
    expect_none();
}
