/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: only a rotation and a translation passes for a rigid transform, and products do
 * not wrap. */
#include "base/fixed.h"
#include "base/rigid.h"
#include "limits/requirement_limits.h"
#include "unity.h"

#include <string.h>

#define TOLERANCE ((int32_t)LIMIT_RIGID_TOLERANCE_Q30)
#define FARTHEST_NM ((int32_t)LIMIT_REGISTRATION_MAX_NM)

static uint64_t seed;
static rigid_t transform;

static int32_t random_i32(void)
{
    seed = (seed * UINT64_C(6364136223846793005)) + UINT64_C(1442695040888963407);
    return fixed_wrap_bam((int64_t)(seed >> 20U));
}

/* A rotation about all three axes, by multiplication. */
static void set_random(rigid_t *result)
{
    rigid_t sum;
    rigid_set_identity(&sum);
    for (uint32_t i = 0U; i < 3U; i++) {
        const uint32_t j = (i + 1U) % 3U;
        const fixed_direction_t direction = fixed_direction(random_i32());
        rigid_t turn;
        rigid_t before = sum;
        rigid_set_identity(&turn);
        turn.rotation_q30[i][i] = direction.cosine_q30;
        turn.rotation_q30[i][j] = -direction.sine_q30;
        turn.rotation_q30[j][i] = direction.sine_q30;
        turn.rotation_q30[j][j] = direction.cosine_q30;
        rigid_multiply(&before, &turn, &sum);
    }
    sum.translation = (point_t){random_i32() / 4, random_i32() / 4, random_i32() / 4};
    *result = sum;
}

static int64_t dot_of_columns(const rigid_t *self, uint32_t a, uint32_t b)
{
    int64_t sum = 0;
    for (uint32_t i = 0U; i < 3U; i++) {
        sum += (int64_t)self->rotation_q30[i][a] * self->rotation_q30[i][b];
    }
    return sum / FIXED_ONE_Q30;
}

void setUp(void)
{
    seed = 7U;
    rigid_set_identity(&transform);
}

void tearDown(void)
{
}

void test_SWR_REG_001_the_identity_is_rigid(void)
{
    TEST_ASSERT_EQUAL(STATUS_OK, rigid_check(&transform));
}

void test_SWR_REG_001_every_rotation_is_rigid(void)
{
    for (int i = 0; i < 2000; i++) {
        set_random(&transform);
        TEST_ASSERT_EQUAL(STATUS_OK, rigid_check(&transform));
    }
}

void test_SWR_REG_001_a_scaled_axis_is_not_rigid(void)
{
    for (uint32_t i = 0U; i < 3U; i++) {
        rigid_set_identity(&transform);
        transform.rotation_q30[i][i] = FIXED_ONE_Q30 + (TOLERANCE / 2) - 20;
        TEST_ASSERT_EQUAL(STATUS_OK, rigid_check(&transform));
        transform.rotation_q30[i][i] = FIXED_ONE_Q30 + (TOLERANCE / 2) + 20;
        TEST_ASSERT_EQUAL(STATUS_NOT_RIGID, rigid_check(&transform));
        transform.rotation_q30[i][i] = FIXED_ONE_Q30 - (TOLERANCE / 2) - 20;
        TEST_ASSERT_EQUAL(STATUS_NOT_RIGID, rigid_check(&transform));
    }
}

void test_SWR_REG_001_a_sheared_axis_is_not_rigid(void)
{
    for (uint32_t i = 0U; i < 3U; i++) {
        const uint32_t j = (i + 1U) % 3U;
        rigid_set_identity(&transform);
        transform.rotation_q30[i][j] = TOLERANCE;
        TEST_ASSERT_EQUAL(STATUS_OK, rigid_check(&transform));
        transform.rotation_q30[i][j] = TOLERANCE + 1;
        TEST_ASSERT_EQUAL(STATUS_NOT_RIGID, rigid_check(&transform));
        transform.rotation_q30[i][j] = -TOLERANCE - 1;
        TEST_ASSERT_EQUAL(STATUS_NOT_RIGID, rigid_check(&transform));
    }
}

void test_SWR_REG_001_a_mirror_is_not_rigid(void)
{
    transform.rotation_q30[2][2] = -FIXED_ONE_Q30;
    TEST_ASSERT_EQUAL(STATUS_NOT_RIGID, rigid_check(&transform));
}

void test_SWR_REG_001_zeros_and_the_largest_numbers_are_not_rigid(void)
{
    memset(transform.rotation_q30, 0, sizeof transform.rotation_q30);
    TEST_ASSERT_EQUAL(STATUS_NOT_RIGID, rigid_check(&transform));
    for (uint32_t i = 0U; i < 9U; i++) {
        transform.rotation_q30[i / 3U][i % 3U] = INT32_MIN;
    }
    TEST_ASSERT_EQUAL(STATUS_NOT_RIGID, rigid_check(&transform));
}

void test_SWR_REG_001_a_translation_is_in_range_up_to_the_limit_on_each_axis(void)
{
    int32_t *const coordinates[3] = {&transform.translation.x_nm, &transform.translation.y_nm,
                                     &transform.translation.z_nm};
    for (uint32_t i = 0U; i < 3U; i++) {
        *coordinates[i] = FARTHEST_NM;
        TEST_ASSERT_EQUAL(STATUS_OK, rigid_check(&transform));
        *coordinates[i] = FARTHEST_NM + 1;
        TEST_ASSERT_EQUAL(STATUS_OUT_OF_RANGE, rigid_check(&transform));
        *coordinates[i] = -FARTHEST_NM - 1;
        TEST_ASSERT_EQUAL(STATUS_OUT_OF_RANGE, rigid_check(&transform));
        *coordinates[i] = -FARTHEST_NM;
        TEST_ASSERT_EQUAL(STATUS_OK, rigid_check(&transform));
        *coordinates[i] = 0;
    }
}

void test_SWR_REG_001_orthonormal_again_after_small_errors(void)
{
    for (int i = 0; i < 500; i++) {
        rigid_t before;
        set_random(&transform);
        for (uint32_t j = 0U; j < 9U; j++) {
            transform.rotation_q30[j / 3U][j % 3U] += random_i32() / 100000;
        }
        before = transform;
        rigid_orthonormalise(&transform);
        for (uint32_t a = 0U; a < 3U; a++) {
            TEST_ASSERT_INT64_WITHIN(8, FIXED_ONE_Q30, dot_of_columns(&transform, a, a));
            TEST_ASSERT_INT64_WITHIN(8, 0, dot_of_columns(&transform, a, (a + 1U) % 3U));
            for (uint32_t b = 0U; b < 3U; b++) {
                TEST_ASSERT_INT32_WITHIN(150000, before.rotation_q30[a][b],
                                         transform.rotation_q30[a][b]);
            }
        }
        TEST_ASSERT_EQUAL(STATUS_OK, rigid_check(&transform));
        TEST_ASSERT_EQUAL_MEMORY(&before.translation, &transform.translation, sizeof(point_t));
    }
}

void test_SWR_REG_001_orthonormalising_keeps_the_direction_of_z(void)
{
    transform.rotation_q30[0][2] = 50000;
    rigid_orthonormalise(&transform);
    TEST_ASSERT_INT32_WITHIN(2, 50000, transform.rotation_q30[0][2]);
    TEST_ASSERT_INT32_WITHIN(2, -50000, transform.rotation_q30[2][0]);
}

void test_SWR_KIN_001_a_transform_times_its_inverse_is_the_identity(void)
{
    for (int i = 0; i < 2000; i++) {
        rigid_t inverse;
        rigid_t product;
        set_random(&transform);
        rigid_invert(&transform, &inverse);
        rigid_multiply(&transform, &inverse, &product);
        for (uint32_t j = 0U; j < 9U; j++) {
            const int32_t expected = ((j % 4U) == 0U) ? FIXED_ONE_Q30 : 0;
            TEST_ASSERT_INT32_WITHIN(12, expected, product.rotation_q30[j / 3U][j % 3U]);
        }
        TEST_ASSERT_INT32_WITHIN(12, 0, product.translation.x_nm);
        TEST_ASSERT_INT32_WITHIN(12, 0, product.translation.y_nm);
        TEST_ASSERT_INT32_WITHIN(12, 0, product.translation.z_nm);
    }
}

void test_SWR_KIN_001_a_point_is_turned_then_moved(void)
{
    const point_t point = {1000, 2000, 3000};
    const int32_t quarter_about_z[3][3] = {
        {0, -FIXED_ONE_Q30, 0}, {FIXED_ONE_Q30, 0, 0}, {0, 0, FIXED_ONE_Q30}};
    memcpy(transform.rotation_q30, quarter_about_z, sizeof quarter_about_z);
    transform.translation = (point_t){10, 20, 30};
    const point_t moved = rigid_apply(&transform, &point);
    TEST_ASSERT_EQUAL_INT32(-1990, moved.x_nm);
    TEST_ASSERT_EQUAL_INT32(1020, moved.y_nm);
    TEST_ASSERT_EQUAL_INT32(3030, moved.z_nm);
}

void test_SWR_KIN_001_a_product_applies_the_right_factor_first(void)
{
    const point_t point = {100000000, -20000000, 3000000};
    rigid_t other;
    rigid_t product;
    set_random(&transform);
    set_random(&other);
    rigid_multiply(&transform, &other, &product);
    const point_t inner = rigid_apply(&other, &point);
    const point_t expected = rigid_apply(&transform, &inner);
    const point_t actual = rigid_apply(&product, &point);
    TEST_ASSERT_INT32_WITHIN(4, expected.x_nm, actual.x_nm);
    TEST_ASSERT_INT32_WITHIN(4, expected.y_nm, actual.y_nm);
    TEST_ASSERT_INT32_WITHIN(4, expected.z_nm, actual.z_nm);
}

void test_SWR_KIN_001_a_cross_product_follows_the_right_hand(void)
{
    static const int32_t x[3] = {FIXED_ONE_Q30, 0, 0};
    static const int32_t y[3] = {0, FIXED_ONE_Q30, 0};
    static const int32_t z[3] = {0, 0, FIXED_ONE_Q30};
    int32_t result[3];
    rigid_cross(x, y, result);
    TEST_ASSERT_EQUAL_INT32_ARRAY(z, result, 3);
    rigid_cross(y, z, result);
    TEST_ASSERT_EQUAL_INT32_ARRAY(x, result, 3);
    rigid_cross(z, x, result);
    TEST_ASSERT_EQUAL_INT32_ARRAY(y, result, 3);
}

void test_SWR_FIX_003_coordinates_saturate_instead_of_wrapping(void)
{
    const point_t farthest = {INT32_MAX, INT32_MIN, INT32_MAX};
    rigid_t inverse;
    transform.translation = (point_t){INT32_MAX, INT32_MIN, INT32_MIN};
    const point_t moved = rigid_apply(&transform, &farthest);
    TEST_ASSERT_EQUAL_INT32(INT32_MAX, moved.x_nm);
    TEST_ASSERT_EQUAL_INT32(INT32_MIN, moved.y_nm);
    TEST_ASSERT_EQUAL_INT32(-1, moved.z_nm);
    rigid_invert(&transform, &inverse);
    TEST_ASSERT_EQUAL_INT32(-INT32_MAX, inverse.translation.x_nm);
    TEST_ASSERT_EQUAL_INT32(INT32_MAX, inverse.translation.y_nm);
}
