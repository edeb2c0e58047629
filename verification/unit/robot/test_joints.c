/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a way is beyond a limit exactly when its product with the scale is, in whole
 * numbers without an end, for every count, every limit and every scale that a table may have.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "robot/joints.h"
#include "robot/robot_neuro.h"

#define RANDOM_ROUNDS 200000U
#define COUNT_OF(list) (sizeof(list) / sizeof((list)[0]))

/* Finest and coarsest scale of a table: 100000 and 1 tick in each mm or radian. */
#define LINEAR_FINEST_Q16 INT64_C(655360)
#define LINEAR_COARSEST_Q16 INT64_C(65536000000)
#define TURNING_FINEST_Q16 INT64_C(447981339)
#define TURNING_COARSEST_Q16 INT64_C(44798133900177)
#define SCALE_MOST_Q16 ((INT64_C(1) << 46) - 1)

static const int64_t scales_q16[] = {1,
                                     2,
                                     65535,
                                     65536,
                                     65537,
                                     LINEAR_FINEST_Q16,
                                     19660761,
                                     LINEAR_COARSEST_Q16,
                                     TURNING_FINEST_Q16,
                                     56293206710,
                                     (INT64_C(1) << 37) - 1,
                                     INT64_C(1) << 37,
                                     TURNING_COARSEST_Q16,
                                     SCALE_MOST_Q16};
static const uint32_t limits[] = {0U,
                                  1U,
                                  2U,
                                  LIMIT_REST_WAY_NM,
                                  LIMIT_REST_WAY_BAM,
                                  LIMIT_TRAJECTORY_LEAD_NM,
                                  LIMIT_TRAJECTORY_LEAD_BAM,
                                  INT32_MAX,
                                  UINT32_MAX - 1U,
                                  UINT32_MAX};

static uint64_t seed;

void setUp(void)
{
    seed = 1U;
}

void tearDown(void)
{
}

static uint64_t next_random(void)
{
    seed = (seed * UINT64_C(6364136223846793005)) + UINT64_C(1442695040888963407);
    return seed ^ (seed >> 29U);
}

/* `a * b` of 128 bits, by digits of 32, is above `limit`. */
static bool is_product_above(uint64_t a, uint64_t b, uint64_t limit)
{
    const uint64_t low = (a & UINT32_MAX) * (b & UINT32_MAX);
    const uint64_t cross = ((a >> 32U) * (b & UINT32_MAX)) + (low >> 32U);
    const uint64_t middle = ((a & UINT32_MAX) * (b >> 32U)) + (cross & UINT32_MAX);
    const uint64_t upper = ((a >> 32U) * (b >> 32U)) + (cross >> 32U) + (middle >> 32U);
    const uint64_t lower = (middle << 32U) | (low & UINT32_MAX);
    return (upper != 0U) || (lower > limit);
}

static bool is_expected(int64_t ticks, int64_t scale_q16, uint32_t limit)
{
    return (ticks > 0) &&
           is_product_above((uint64_t)ticks, (uint64_t)scale_q16, (uint64_t)limit * 65536U);
}

/* The limit of the other unit, taken by mistake, would decide otherwise wherever one can. */
static void expect_exact(int64_t ticks, int64_t scale_q16, uint32_t limit)
{
    const bool is_beyond = is_expected(ticks, scale_q16, limit);
    const uint32_t other = is_beyond ? UINT32_MAX : 0U;
    const axis_config_t linear = {.unit_per_tick_q16 = scale_q16, .unit = (uint8_t)AXIS_UNIT_MM};
    const axis_config_t turning = {.unit_per_tick_q16 = scale_q16, .unit = (uint8_t)AXIS_UNIT_RAD};
    TEST_ASSERT_EQUAL(is_beyond, joints_is_beyond(&linear, ticks, limit, other));
    TEST_ASSERT_EQUAL(is_beyond, joints_is_beyond(&turning, ticks, other, limit));
}

static void expect_exact_around(int64_t ticks, int64_t scale_q16, uint32_t limit)
{
    for (int64_t more = -2; more <= 2; more++) {
        if ((more <= 0) || (ticks <= (INT64_MAX - more))) {
            expect_exact(ticks + more, scale_q16, limit);
            expect_exact(-(ticks + more), scale_q16, limit);
        }
    }
}

static void expect_exact_at_corners(int64_t scale_q16, uint32_t limit)
{
    expect_exact_around(JOINTS_PRODUCT_TICKS, scale_q16, limit);
    expect_exact_around(((int64_t)limit * 65536) / scale_q16, scale_q16, limit);
    expect_exact_around(INT64_MAX, scale_q16, limit);
    expect_exact_around(INT64_MAX / scale_q16, scale_q16, limit);
    expect_exact(INT64_MIN, scale_q16, limit);
    for (uint32_t bit = 0U; bit < 63U; bit++) {
        expect_exact_around(INT64_C(1) << bit, scale_q16, limit);
    }
}

void test_SWR_FIX_004_the_reference_has_all_bits_of_a_product(void)
{
    const uint64_t most = UINT64_MAX;
    TEST_ASSERT_FALSE(is_product_above(UINT32_MAX, UINT32_MAX, UINT64_C(0xFFFFFFFE00000001)));
    TEST_ASSERT_TRUE(is_product_above(UINT32_MAX, UINT32_MAX, UINT64_C(0xFFFFFFFE00000000)));
    TEST_ASSERT_FALSE(is_product_above(most, 1U, most));
    TEST_ASSERT_FALSE(is_product_above(1U, most, most));
    TEST_ASSERT_FALSE(is_product_above(most / 5U, 5U, most));
    TEST_ASSERT_FALSE(is_product_above(5U, most / 5U, most));
    TEST_ASSERT_TRUE(is_product_above((most / 5U) + 1U, 5U, most));
    TEST_ASSERT_TRUE(is_product_above(5U, (most / 5U) + 1U, most));
    TEST_ASSERT_TRUE(is_product_above(UINT64_C(1) << 32U, UINT64_C(1) << 32U, most));
    TEST_ASSERT_TRUE(is_product_above(most, most, most));
}

void test_SWR_FIX_004_a_way_is_beyond_exactly_at_every_corner(void)
{
    for (uint32_t scale = 0U; scale < COUNT_OF(scales_q16); scale++) {
        for (uint32_t limit = 0U; limit < COUNT_OF(limits); limit++) {
            expect_exact_at_corners(scales_q16[scale], limits[limit]);
        }
    }
}

void test_SWR_FIX_004_a_way_is_beyond_exactly_for_random_counts_scales_and_limits(void)
{
    for (uint32_t i = 0U; i < RANDOM_ROUNDS; i++) {
        const int64_t ticks = (int64_t)(next_random() >> (1U + (next_random() % 62U)));
        const int64_t scale_q16 = 1 + (int64_t)(next_random() >> (18U + (next_random() % 46U)));
        const uint32_t limit = (uint32_t)(next_random() >> (32U + (next_random() % 32U)));
        expect_exact(ticks, (scale_q16 > SCALE_MOST_Q16) ? SCALE_MOST_Q16 : scale_q16, limit);
        expect_exact(-ticks, (scale_q16 > SCALE_MOST_Q16) ? SCALE_MOST_Q16 : scale_q16, limit);
    }
}

void test_SWR_FIX_004_each_axis_of_a_robot_is_beyond_its_limit_one_tick_later(void)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const axis_config_t *const axis = &robot_neuro.axes[i];
        const int64_t most = joints_ticks_within(axis, LIMIT_REST_WAY_NM, LIMIT_REST_WAY_BAM);
        TEST_ASSERT_GREATER_THAN_INT64(0, most);
        TEST_ASSERT_FALSE(joints_is_beyond(axis, most, LIMIT_REST_WAY_NM, LIMIT_REST_WAY_BAM));
        TEST_ASSERT_TRUE(joints_is_beyond(axis, most + 1, LIMIT_REST_WAY_NM, LIMIT_REST_WAY_BAM));
        TEST_ASSERT_TRUE(joints_is_beyond(axis, INT64_MAX, LIMIT_REST_WAY_NM, LIMIT_REST_WAY_BAM));
        TEST_ASSERT_FALSE(joints_is_beyond(axis, INT64_MIN, LIMIT_REST_WAY_NM, LIMIT_REST_WAY_BAM));
    }
}
