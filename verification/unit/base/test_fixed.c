/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: fixed-point functions are as exact as they say, for every argument, and never
 * wrap. */
#include "base/fixed.h"
#include "unit/support/contract_trap.h"
#include "unity.h"

#include <math.h>

#define PI 3.14159265358979323846
#define RAD_PER_BAM (PI / 2147483648.0)
#define ALLOWED_UNITS 4.0

static uint64_t seed;

static uint64_t next_random(void)
{
    seed = (seed * UINT64_C(6364136223846793005)) + UINT64_C(1442695040888963407);
    return seed ^ (seed >> 29U);
}

static int32_t random_i32(void)
{
    return fixed_wrap_bam((int64_t)(next_random() >> 20U));
}

static void expect_direction(int32_t angle_bam)
{
    const fixed_direction_t direction = fixed_direction(angle_bam);
    const double angle = angle_bam * RAD_PER_BAM;
    TEST_ASSERT_TRUE(fabs(direction.cosine_q30 - cos(angle) * FIXED_ONE_Q30) <= ALLOWED_UNITS);
    TEST_ASSERT_TRUE(fabs(direction.sine_q30 - sin(angle) * FIXED_ONE_Q30) <= ALLOWED_UNITS);
}

static void expect_angle(int64_t y, int64_t x)
{
    const double expected = atan2((double)y, (double)x) / RAD_PER_BAM;
    const double error = fmod(fabs(fixed_atan2_bam(y, x) - expected), 4294967296.0);
    TEST_ASSERT_TRUE(fmin(error, 4294967296.0 - error) <= ALLOWED_UNITS);
}

void setUp(void)
{
    seed = 1U;
}

void tearDown(void)
{
}

void test_SWR_FIX_001_sine_and_cosine_are_within_4_units_on_a_dense_grid(void)
{
    for (int64_t angle = INT32_MIN; angle <= INT32_MAX; angle += 20011) {
        expect_direction((int32_t)angle);
    }
}

void test_SWR_FIX_001_sine_and_cosine_are_within_4_units_around_every_eighth_of_a_turn(void)
{
    for (int64_t eighth = -4; eighth <= 4; eighth++) {
        for (int64_t offset = -50; offset <= 50; offset++) {
            expect_direction(fixed_wrap_bam((eighth * 0x20000000) + offset));
        }
    }
}

void test_SWR_FIX_001_quarter_turns_are_exact(void)
{
    static const int32_t cosine[4] = {FIXED_ONE_Q30, 0, -FIXED_ONE_Q30, 0};
    for (uint32_t i = 0U; i < 4U; i++) {
        const fixed_direction_t direction =
            fixed_direction(fixed_wrap_bam((int64_t)i * 0x40000000));
        TEST_ASSERT_EQUAL_INT32(cosine[i], direction.cosine_q30);
        TEST_ASSERT_EQUAL_INT32(cosine[(i + 3U) % 4U], direction.sine_q30);
    }
}

void test_SWR_FIX_001_arctangent_is_within_4_bam_all_around(void)
{
    for (int64_t angle = INT32_MIN; angle <= INT32_MAX; angle += 40009) {
        const double radians = (double)angle * RAD_PER_BAM;
        expect_angle((int64_t)(sin(radians) * 1.0e18), (int64_t)(cos(radians) * 1.0e18));
        expect_angle((int64_t)(sin(radians) * 5.4e8), (int64_t)(cos(radians) * 5.4e8));
    }
}

void test_SWR_FIX_001_arctangent_is_within_4_bam_for_small_and_huge_vectors(void)
{
    for (int64_t y = -20; y <= 20; y++) {
        for (int64_t x = -20; x <= 20; x++) {
            expect_angle(y, x);
        }
    }
    expect_angle(INT64_MIN, INT64_MIN);
    expect_angle(INT64_MAX, INT64_MIN);
    expect_angle(INT64_MIN, INT64_MAX);
    expect_angle(1, INT64_MIN);
    for (int i = 0; i < 20000; i++) {
        expect_angle((int64_t)(next_random() >> (i % 60)) - 1000, -(int64_t)(next_random() >> 30U));
    }
}

void test_SWR_FIX_001_arctangent_of_the_axes_is_exact(void)
{
    TEST_ASSERT_EQUAL_INT32(0, fixed_atan2_bam(0, 0));
    TEST_ASSERT_EQUAL_INT32(0, fixed_atan2_bam(0, 7));
    TEST_ASSERT_EQUAL_INT32(0x40000000, fixed_atan2_bam(7, 0));
    TEST_ASSERT_EQUAL_INT32(INT32_MIN, fixed_atan2_bam(0, -7));
    TEST_ASSERT_EQUAL_INT32(-0x40000000, fixed_atan2_bam(-7, 0));
    TEST_ASSERT_EQUAL_INT32(0x20000000, fixed_atan2_bam(7, 7));
}

void test_SWR_FIX_001_a_unit_vector_has_the_direction_and_length_of_its_vector(void)
{
    for (int i = 0; i < 20000; i++) {
        const unsigned shift = (unsigned)i % 44U;
        const int64_t vector[3] = {((int64_t)random_i32() * 268435456) >> shift,
                                   ((int64_t)random_i32() * 268435456) >> shift,
                                   ((int64_t)random_i32() * 268435456) >> shift};
        const double length =
            sqrt((double)vector[0] * (double)vector[0] + (double)vector[1] * (double)vector[1] +
                 (double)vector[2] * (double)vector[2]);
        int32_t unit[3];
        const int64_t measured = fixed_normalise(vector, unit);
        TEST_ASSERT_TRUE(fabs((double)measured - length) <= 0.501 + length * 2.0e-9);
        for (int j = 0; j < 3; j++) {
            TEST_ASSERT_TRUE(fabs(unit[j] - (double)vector[j] / length * FIXED_ONE_Q30) <=
                             ALLOWED_UNITS);
        }
    }
}

void test_SWR_FIX_001_the_zero_vector_has_no_length_and_no_direction(void)
{
    const int64_t vector[3] = {0, 0, 0};
    int32_t unit[3] = {1, 1, 1};
    TEST_ASSERT_EQUAL_INT64(0, fixed_normalise(vector, unit));
    TEST_ASSERT_EACH_EQUAL_INT32(0, unit, 3);
}

void test_SWR_FIX_002_square_root_is_exact_at_and_around_squares(void)
{
    for (uint64_t root = 1U; root <= UINT32_MAX; root += 65521U) {
        TEST_ASSERT_EQUAL_UINT32(root, fixed_square_root(root * root));
        TEST_ASSERT_EQUAL_UINT32(root - 1U, fixed_square_root((root * root) - 1U));
        TEST_ASSERT_EQUAL_UINT32(root, fixed_square_root((root * root) + (2U * root)));
    }
    TEST_ASSERT_EQUAL_UINT32(0U, fixed_square_root(0U));
    TEST_ASSERT_EQUAL_UINT32(UINT32_MAX, fixed_square_root(UINT64_MAX));
}

void test_SWR_FIX_002_square_root_is_the_largest_integer_not_above(void)
{
    for (int i = 0; i < 50000; i++) {
        const uint64_t value = next_random() >> (unsigned)(i % 64);
        const uint64_t root = fixed_square_root(value);
        TEST_ASSERT_TRUE(root * root <= value);
        TEST_ASSERT_TRUE(root == UINT32_MAX || (root + 1U) * (root + 1U) > value);
    }
}

void test_SWR_FIX_003_division_by_a_small_number_is_that_of_c(void)
{
    static const int64_t ends[] = {0, 1, -1, 65535, INT64_C(-4294967296), INT64_MAX, INT64_MIN};
    for (uint32_t divisor = 2U; divisor <= 65536U; divisor += 97U) {
        for (size_t i = 0U; i < sizeof ends / sizeof ends[0]; i++) {
            TEST_ASSERT_EQUAL_INT64(ends[i] / (int64_t)divisor, fixed_divide_by(ends[i], divisor));
        }
        for (int i = 0; i < 64; i++) {
            const int64_t value = (int64_t)next_random() >> i;
            TEST_ASSERT_EQUAL_INT64(value / (int64_t)divisor, fixed_divide_by(value, divisor));
        }
    }
    TEST_ASSERT_EQUAL_INT64(INT64_MIN / 65536, fixed_divide_by(INT64_MIN, 65536U));
}

void test_SWR_FIX_003_a_signed_division_is_that_of_c(void)
{
    for (uint32_t i = 0U; i < 100000U; i++) {
        const int64_t value = (int64_t)(next_random() >> (1U + (i % 40U)));
        const int64_t divisor = 1 + (int64_t)(next_random() >> (24U + (i % 40U)));
        TEST_ASSERT_EQUAL_INT64(value / divisor, fixed_divide_signed(value, divisor));
        TEST_ASSERT_EQUAL_INT64(-value / divisor, fixed_divide_signed(-value, divisor));
    }
    TEST_ASSERT_EQUAL_INT64(0, fixed_divide_signed(-6, 7));
}

void test_SWR_FIX_003_division_is_that_of_c_at_and_around_multiples(void)
{
    for (int i = 0; i < 50000; i++) {
        const uint64_t numerator = next_random() >> (unsigned)(i % 64);
        const uint64_t divisor = (next_random() >> (unsigned)(30 + ((i / 64) % 34))) | 1U;
        const uint64_t multiple = (numerator / divisor) * divisor;
        TEST_ASSERT_EQUAL_UINT64(numerator / divisor, fixed_divide(numerator, divisor));
        TEST_ASSERT_EQUAL_UINT64(multiple / divisor, fixed_divide(multiple, divisor));
        TEST_ASSERT_EQUAL_UINT64((multiple - 1U) / divisor, fixed_divide(multiple - 1U, divisor));
    }
    TEST_ASSERT_EQUAL_UINT64(UINT64_MAX, fixed_divide(UINT64_MAX, 1U));
    TEST_ASSERT_EQUAL_UINT64(UINT64_C(4294967297), fixed_divide(UINT64_MAX, UINT32_MAX));
    TEST_ASSERT_EQUAL_UINT64(UINT32_MAX, fixed_divide(UINT64_MAX, UINT64_C(4294967296)));
}

void test_SWR_FIX_003_a_length_is_that_of_the_normalised_vector(void)
{
    for (int i = 0; i < 5000; i++) {
        const int64_t vector[3] = {(int64_t)next_random() >> (i % 60 + 4),
                                   (int64_t)next_random() >> (i % 57 + 4),
                                   (int64_t)next_random() >> (i % 53 + 4)};
        int32_t unit[3];
        TEST_ASSERT_EQUAL_INT64(fixed_normalise(vector, unit), fixed_length(vector));
    }
}

void test_SWR_FIX_003_saturation_stops_at_the_ends_of_int32(void)
{
    TEST_ASSERT_EQUAL_INT32(INT32_MAX, fixed_saturate(INT64_MAX));
    TEST_ASSERT_EQUAL_INT32(INT32_MAX, fixed_saturate(INT64_C(2147483648)));
    TEST_ASSERT_EQUAL_INT32(INT32_MAX, fixed_saturate(INT32_MAX));
    TEST_ASSERT_EQUAL_INT32(-5, fixed_saturate(-5));
    TEST_ASSERT_EQUAL_INT32(INT32_MIN, fixed_saturate(INT32_MIN));
    TEST_ASSERT_EQUAL_INT32(INT32_MIN, fixed_saturate(INT64_C(-2147483649)));
    TEST_ASSERT_EQUAL_INT32(INT32_MIN, fixed_saturate(INT64_MIN));
}

void test_SWR_FIX_003_a_magnitude_and_the_larger_of_two_keep_64_bits(void)
{
    TEST_ASSERT_EQUAL_INT64(0, fixed_magnitude(0));
    TEST_ASSERT_EQUAL_INT64(5, fixed_magnitude(-5));
    TEST_ASSERT_EQUAL_INT64(INT64_MAX, fixed_magnitude(INT64_MIN + 1));
    TEST_ASSERT_EQUAL_INT64(INT64_MAX, fixed_magnitude(INT64_MAX));
    TEST_ASSERT_EQUAL_INT64(-4, fixed_larger(-4, -5));
    TEST_ASSERT_EQUAL_INT64(7, fixed_larger(7, 7));
    TEST_ASSERT_EQUAL_INT64(INT64_MAX, fixed_larger(INT64_MIN, INT64_MAX));
}

void test_SWR_FIX_003_multiplication_rounds_half_away_from_zero_and_saturates(void)
{
    TEST_ASSERT_EQUAL_INT32(2, fixed_multiply_q30(3, FIXED_ONE_Q30 / 2));
    TEST_ASSERT_EQUAL_INT32(-2, fixed_multiply_q30(-3, FIXED_ONE_Q30 / 2));
    TEST_ASSERT_EQUAL_INT32(1, fixed_multiply_q30(5, FIXED_ONE_Q30 / 4));
    TEST_ASSERT_EQUAL_INT32(-12345, fixed_multiply_q30(12345, -FIXED_ONE_Q30));
    TEST_ASSERT_EQUAL_INT32(INT32_MAX, fixed_multiply_q30(INT32_MIN, INT32_MIN));
    TEST_ASSERT_EQUAL_INT32(INT32_MIN, fixed_multiply_q30(INT32_MAX, INT32_MIN));
}

void test_SWR_FIX_003_scalar_product_of_the_largest_numbers_does_not_wrap(void)
{
    static const int32_t lowest[3] = {INT32_MIN, INT32_MIN, INT32_MIN};
    static const int32_t ones[3] = {FIXED_ONE_Q30, -FIXED_ONE_Q30, FIXED_ONE_Q30};
    static const int32_t numbers[3] = {3, 20, 100};
    TEST_ASSERT_EQUAL_INT64(INT64_C(12884901888), fixed_dot_q30(lowest, lowest));
    TEST_ASSERT_EQUAL_INT64(83, fixed_dot_q30(numbers, ones));
}

void test_SWR_FIX_003_division_rounds_half_away_from_zero_and_never_wraps(void)
{
    TEST_ASSERT_EQUAL_INT64(2, fixed_divide_rounded(3, 2));
    TEST_ASSERT_EQUAL_INT64(-2, fixed_divide_rounded(-3, 2));
    TEST_ASSERT_EQUAL_INT64(1, fixed_divide_rounded(4, 3));
    TEST_ASSERT_EQUAL_INT64(-2, fixed_divide_rounded(-5, 3));
    TEST_ASSERT_EQUAL_INT64(0, fixed_divide_rounded(0, 3));
    TEST_ASSERT_EQUAL_INT64(INT64_MAX, fixed_divide_rounded(INT64_MAX, 1));
    TEST_ASSERT_EQUAL_INT64(INT64_MIN, fixed_divide_rounded(INT64_MIN, 1));
    TEST_ASSERT_EQUAL_INT64(1, fixed_divide_rounded(INT64_MAX, INT64_MAX));
}

void test_SWR_FIX_003_shift_rounds_half_away_from_zero_and_never_wraps(void)
{
    TEST_ASSERT_EQUAL_INT64(2, fixed_shift_rounded(3, 1U));
    TEST_ASSERT_EQUAL_INT64(-2, fixed_shift_rounded(-3, 1U));
    TEST_ASSERT_EQUAL_INT64(1, fixed_shift_rounded(5, 2U));
    TEST_ASSERT_EQUAL_INT64(INT64_C(4611686018427387904), fixed_shift_rounded(INT64_MAX, 1U));
    TEST_ASSERT_EQUAL_INT64(INT64_C(-4611686018427387904), fixed_shift_rounded(INT64_MIN, 1U));
    TEST_ASSERT_EQUAL_INT64(-2, fixed_shift_rounded(INT64_MIN, 62U));
}

void test_SWR_FIX_003_an_angle_of_many_turns_is_the_angle_it_stands_for(void)
{
    TEST_ASSERT_EQUAL_INT32(INT32_MIN, fixed_wrap_bam(INT64_C(2147483648)));
    TEST_ASSERT_EQUAL_INT32(-1, fixed_wrap_bam(INT64_C(4294967295)));
    TEST_ASSERT_EQUAL_INT32(5, fixed_wrap_bam(INT64_C(4294967296) * 3 + 5));
    TEST_ASSERT_EQUAL_INT32(INT32_MAX, fixed_wrap_bam(INT64_C(-2147483649)));
    TEST_ASSERT_EQUAL_INT32(0, fixed_wrap_bam(INT64_MIN));
}

void test_SWR_CORE_003_dividing_by_nothing_breaks_contract_100(void)
{
    EXPECT_CONTRACT("fixed", 100U, (void)fixed_divide_rounded(1, 0));
    EXPECT_CONTRACT("fixed", 100U, (void)fixed_divide_rounded(1, -1));
}
