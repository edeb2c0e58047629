/* SPDX-License-Identifier: Apache-2.0 */
#include "base/rigid.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"

static void column_of(const rigid_t *self, uint32_t column, int32_t vector_q30[3])
{
    for (uint32_t row = 0U; row < 3U; row++) {
        vector_q30[row] = self->rotation_q30[row][column];
    }
}

static void set_column(rigid_t *self, uint32_t column, const int32_t vector_q30[3])
{
    for (uint32_t row = 0U; row < 3U; row++) {
        self->rotation_q30[row][column] = vector_q30[row];
    }
}

static void coordinates_of(const point_t *point, int32_t vector_nm[3])
{
    vector_nm[0] = point->x_nm;
    vector_nm[1] = point->y_nm;
    vector_nm[2] = point->z_nm;
}

static bool is_within(int64_t value, int64_t expected, int64_t tolerance)
{
    return (value >= (expected - tolerance)) && (value <= (expected + tolerance));
}

static bool is_orthonormal(const rigid_t *self)
{
    bool result = true;
    for (uint32_t i = 0U; i < 3U; i++) {
        int32_t a_q30[3];
        column_of(self, i, a_q30);
        for (uint32_t j = i; j < 3U; j++) {
            int32_t b_q30[3];
            column_of(self, j, b_q30);
            const int64_t expected = (i == j) ? FIXED_ONE_Q30 : 0;
            if (!is_within(fixed_dot_q30(a_q30, b_q30), expected,
                           (int64_t)LIMIT_RIGID_TOLERANCE_Q30)) {
                result = false;
            }
        }
    }
    return result;
}

static bool is_right_handed(const rigid_t *self)
{
    int32_t x_q30[3];
    int32_t y_q30[3];
    int32_t z_q30[3];
    int32_t cross_q30[3];
    column_of(self, 0U, x_q30);
    column_of(self, 1U, y_q30);
    column_of(self, 2U, z_q30);
    rigid_cross(x_q30, y_q30, cross_q30);
    return fixed_dot_q30(cross_q30, z_q30) > 0;
}

static bool is_in_range(int32_t value_nm)
{
    return is_within(value_nm, 0, (int64_t)LIMIT_REGISTRATION_MAX_NM);
}

void rigid_set_identity(rigid_t *self)
{
    for (uint32_t row = 0U; row < 3U; row++) {
        for (uint32_t column = 0U; column < 3U; column++) {
            self->rotation_q30[row][column] = (row == column) ? FIXED_ONE_Q30 : 0;
        }
    }
    self->translation = (point_t){0, 0, 0};
}

status_t rigid_check(const rigid_t *self)
{
    const point_t *const translation = &self->translation;
    if (!is_orthonormal(self) || !is_right_handed(self)) {
        return STATUS_NOT_RIGID;
    }
    if (!is_in_range(translation->x_nm) || !is_in_range(translation->y_nm) ||
        !is_in_range(translation->z_nm)) {
        return STATUS_OUT_OF_RANGE;
    }
    return STATUS_OK;
}

void rigid_orthonormalise(rigid_t *self)
{
    int32_t column_q30[3];
    int32_t x_q30[3];
    int32_t y_q30[3];
    int32_t z_q30[3];
    int64_t vector[3];
    column_of(self, 2U, column_q30);
    for (uint32_t i = 0U; i < 3U; i++) {
        vector[i] = column_q30[i];
    }
    (void)fixed_normalise(vector, z_q30);
    column_of(self, 0U, column_q30);
    const int32_t along_q30 = fixed_saturate(fixed_dot_q30(column_q30, z_q30));
    for (uint32_t i = 0U; i < 3U; i++) {
        vector[i] = (int64_t)column_q30[i] - fixed_multiply_q30(z_q30[i], along_q30);
    }
    (void)fixed_normalise(vector, x_q30);
    rigid_cross(z_q30, x_q30, y_q30);
    set_column(self, 0U, x_q30);
    set_column(self, 1U, y_q30);
    set_column(self, 2U, z_q30);
}

void rigid_multiply(const rigid_t *a, const rigid_t *b, rigid_t *result)
{
    for (uint32_t column = 0U; column < 3U; column++) {
        int32_t b_q30[3];
        column_of(b, column, b_q30);
        for (uint32_t row = 0U; row < 3U; row++) {
            result->rotation_q30[row][column] =
                fixed_saturate(fixed_dot_q30(b_q30, a->rotation_q30[row]));
        }
    }
    result->translation = rigid_apply(a, &b->translation);
}

void rigid_invert(const rigid_t *self, rigid_t *result)
{
    int32_t translation_nm[3];
    int32_t inverse_nm[3];
    coordinates_of(&self->translation, translation_nm);
    for (uint32_t i = 0U; i < 3U; i++) {
        column_of(self, i, result->rotation_q30[i]);
        inverse_nm[i] = fixed_saturate(-fixed_dot_q30(translation_nm, result->rotation_q30[i]));
    }
    result->translation = (point_t){inverse_nm[0], inverse_nm[1], inverse_nm[2]};
}

point_t rigid_apply(const rigid_t *self, const point_t *point)
{
    int32_t point_nm[3];
    coordinates_of(point, point_nm);
    const int64_t x_nm = fixed_dot_q30(point_nm, self->rotation_q30[0]) + self->translation.x_nm;
    const int64_t y_nm = fixed_dot_q30(point_nm, self->rotation_q30[1]) + self->translation.y_nm;
    const int64_t z_nm = fixed_dot_q30(point_nm, self->rotation_q30[2]) + self->translation.z_nm;
    return (point_t){fixed_saturate(x_nm), fixed_saturate(y_nm), fixed_saturate(z_nm)};
}

bool rigid_is_same_point(const point_t *a, const point_t *b)
{
    const uint32_t x = (uint32_t)a->x_nm ^ (uint32_t)b->x_nm;
    const uint32_t y = (uint32_t)a->y_nm ^ (uint32_t)b->y_nm;
    const uint32_t z = (uint32_t)a->z_nm ^ (uint32_t)b->z_nm;
    return (x | y | z) == 0U;
}

void rigid_cross(const int32_t a[3], const int32_t b_q30[3], int32_t result[3])
{
    static const uint32_t following[3] = {1U, 2U, 0U};
    for (uint32_t i = 0U; i < 3U; i++) {
        const uint32_t j = following[i];
        const uint32_t k = following[j];
        const int64_t halved = (((int64_t)a[j] * b_q30[k]) / 2) - (((int64_t)a[k] * b_q30[j]) / 2);
        result[i] = fixed_saturate(fixed_shift_rounded(halved, 29U));
    }
}

static int32_t angle_between_bam(const int32_t a_q30[3], const int32_t b_q30[3])
{
    int32_t cross_q30[3];
    int64_t wide_q30[3];
    rigid_cross(a_q30, b_q30, cross_q30);
    for (uint32_t i = 0U; i < 3U; i++) {
        wide_q30[i] = cross_q30[i];
    }
    const int64_t sine_q30 = fixed_length(wide_q30);
    const int32_t angle_bam = fixed_atan2_bam(sine_q30, fixed_dot_q30(a_q30, b_q30));
    /* Half a turn has no positive bam. */
    return (angle_bam < 0) ? INT32_MAX : angle_bam;
}

void rigid_difference(const rigid_t *a, const rigid_t *b, int32_t *distance_nm, int32_t *angle_bam)
{
    const int64_t way_nm[3] = {(int64_t)a->translation.x_nm - b->translation.x_nm,
                               (int64_t)a->translation.y_nm - b->translation.y_nm,
                               (int64_t)a->translation.z_nm - b->translation.z_nm};
    int32_t largest_bam = 0;
    for (uint32_t column = 0U; column < 3U; column++) {
        int32_t a_q30[3];
        int32_t b_q30[3];
        for (uint32_t row = 0U; row < 3U; row++) {
            a_q30[row] = a->rotation_q30[row][column];
            b_q30[row] = b->rotation_q30[row][column];
        }
        const int32_t between_bam = angle_between_bam(a_q30, b_q30);
        largest_bam = (between_bam > largest_bam) ? between_bam : largest_bam;
    }
    *distance_nm = fixed_saturate(fixed_length(way_nm));
    *angle_bam = largest_bam;
}
