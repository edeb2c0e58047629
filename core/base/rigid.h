/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Points in nm and rigid transforms: a rotation with q30 entries and a translation in nm.
 * `rigid_t a_b` maps coordinates of frame b into frame a.
 */
#ifndef BORESIGHT_RIGID_H
#define BORESIGHT_RIGID_H

#include "interface/status.h"

#include <stdbool.h>
#include <stdint.h>

/** A point or a difference of points. Each coordinate within +-2.1 m. */
typedef struct {
    int32_t x_nm;
    int32_t y_nm;
    int32_t z_nm;
} point_t;

/** A rotation and a translation. The functions do not overflow whatever the entries are. */
typedef struct {
    int32_t rotation_q30[3][3]; /**< Row, column. */
    point_t translation;
} rigid_t;

/** The identity. */
void rigid_set_identity(rigid_t *self);

/**
 * Says whether `self` is a rotation and a translation: every entry of RtR - I within
 * LIMIT_RIGID_TOLERANCE_Q30, determinant positive, each coordinate within
 * LIMIT_REGISTRATION_MAX_NM.
 *
 * @return STATUS_OK, STATUS_NOT_RIGID, or STATUS_OUT_OF_RANGE for the translation
 *
 * @satisfies SWR-REG-001
 */
status_t rigid_check(const rigid_t *self);

/** Makes the columns of a transform that passed rigid_check() orthonormal again (z kept, then x,
 * then y). */
void rigid_orthonormalise(rigid_t *self);

/** `result = a * b`. `result` may be neither. Coordinates saturate. */
void rigid_multiply(const rigid_t *a, const rigid_t *b, rigid_t *result);

/** `result = self^-1`. `result` may not be `self`. Coordinates saturate. */
void rigid_invert(const rigid_t *self, rigid_t *result);

/** The point `self * point`. Coordinates saturate. */
point_t rigid_apply(const rigid_t *self, const point_t *point);

/** Both are the same to the last bit. */
bool rigid_is_same_point(const point_t *a, const point_t *b);

/** Vector product of `a` and `b_q30`, in the unit of `a`, saturated. `result` may be neither. */
void rigid_cross(const int32_t a[3], const int32_t b_q30[3], int32_t result[3]);

/**
 * Distance (nm) between the origins, and largest angle (bam) between the axes of the same name, of
 * two poses. Both saturate at INT32_MAX.
 */
void rigid_difference(const rigid_t *a, const rigid_t *b, int32_t *distance_nm, int32_t *angle_bam);

#endif
