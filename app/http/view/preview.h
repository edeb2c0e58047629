/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Preview of a target: judged by the functions of the core with the present state of the robot, and
 * nothing is changed. Control judges each target anew.
 */
#ifndef BORESIGHT_PREVIEW_H
#define BORESIGHT_PREVIEW_H

#include "interface/snapshot.h"
#include "procedure/plan.h"
#include "robot/robot.h"

#include <stdint.h>

/** The result of a target. */
typedef struct {
    solution_t solution;           /**< As plan_set_target(). */
    rigid_t reached;               /**< The pose, scanner coordinates; with STATUS_OK. */
    int32_t ticks[ROBOT_AXIS_MAX]; /**< Its positions; with STATUS_OK. */
    uint32_t tightest; /**< With STATUS_OK the axis with the least room, beside its range. */
} preview_t;

/** Distance of `ticks` from the nearer soft limit of `axis`, in ticks. */
int32_t preview_room_ticks(const axis_config_t *axis, int32_t ticks);

/**
 * Says whether `scanner_treatment` is a target now.
 *
 * @satisfies SWR-HTTP-033
 */
preview_t preview_target(const robot_t *robot, const snapshot_t *snapshot,
                         const rigid_t *scanner_treatment);

/**
 * The pose in which a needle through the entry point of `snapshot` has its tip at `target`, scanner
 * coordinates, if the robot has joint values for it; without an entry point that of a needle in the
 * robot's bare_direction.
 *
 * @return STATUS_OK; STATUS_NO_PROBE; STATUS_NOT_REGISTERED; STATUS_NOT_PROPOSED without an entry
 * point if the robot has no such direction; or as kinematics_inverse()
 *
 * @satisfies SWR-HTTP-084
 */
solution_t preview_aim(const robot_t *robot, const snapshot_t *snapshot, const point_t *target,
                       rigid_t *scanner_treatment);

#endif
