/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The view of the peers of bare transforms, taken from one snapshot. An unknown value is not in it:
 * its numbers are zero, and a status gives the reason.
 */
#ifndef BORESIGHT_TRANSFORM_VIEW_H
#define BORESIGHT_TRANSFORM_VIEW_H

#include "base/rigid.h"
#include "interface/snapshot.h"
#include "robot/robot.h"

#include <stdint.h>

/** Only words, no padding: these are compared as bytes. */
typedef struct {
    uint32_t pose_status;              /**< status_t: why there is no measured_cp. */
    uint32_t joint_status;             /**< status_t: why there are no joints. */
    rigid_t pose;                      /**< measured_cp */
    int32_t ticks[ROBOT_AXIS_MAX];     /**< measured_jp */
    int32_t speeds_q8[ROBOT_AXIS_MAX]; /**< measured_jv */
} transform_measured_t;

typedef struct {
    uint32_t is_valid;             /**< Something that can be reached is proposed. */
    uint32_t pose_status;          /**< status_t: why it is not sent all the same. */
    rigid_t pose;                  /**< desired_cp */
    int32_t ticks[ROBOT_AXIS_MAX]; /**< desired_jp */
} transform_desired_t;

typedef struct {
    uint32_t is_valid;
    rigid_t pose;
    uint32_t is_rotation_ignored; /**< Its rotation is none; the one that was sent is ignored. */
} transform_registration_t;

typedef struct {
    uint32_t is_valid; /**< Its lengths are known. */
    int32_t length_nm[ROBOT_PROBE_LENGTHS];
} transform_probe_t;

typedef struct {
    uint32_t is_valid;
    point_t point;
} transform_point_t;

typedef struct {
    transform_probe_t probe;
    transform_measured_t measured;
    transform_desired_t desired;
    transform_registration_t registration; /**< In force; before there is one, the proposed one. */
    transform_point_t entry;               /**< The proposed one; else that decides depths. */
    transform_point_t target;              /**< Proposed. */
} transform_view_t;

/**
 * Fills all of `view`. Joints need homed axes; a pose a registration as well.
 *
 * @satisfies SWR-IGTL-014
 * @satisfies SWR-IGTL-037
 * @satisfies SWR-IGTL-120
 */
void transform_view_take(transform_view_t *view, const snapshot_t *snapshot);

#endif
