/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Forward and inverse kinematics of the NeuroRobot, in the z-frame. Yaw is the outer, pitch the
 * inner rotation: R = R0 Rx(yaw) Ry(pitch) Rz(rotation). Equations: mechanism of Nycz et al. 2017,
 * closed form. Joint values are nm (head, feet, lateral, insertion) or bam (rotation, pitch, yaw),
 * in the order of the axes in robot.yml.
 */
#ifndef BORESIGHT_NEURO_H
#define BORESIGHT_NEURO_H

#include "base/rigid.h"
#include "interface/status.h"
#include "robot/joints.h"
#include "robot/margin.h"
#include "robot/robot.h"

#include <stdint.h>

/** The separation of the axial carriages and the height of the linkage count as joints. */
#define NEURO_LIMIT_SEPARATION JOINT_LIMIT_FURTHER
#define NEURO_LIMIT_HEIGHT (JOINT_LIMIT_FURTHER + 1U)

/** The limits of all joints of `robot`. */
void neuro_limits(const robot_t *robot, joint_limits_t *limits);

/**
 * Pose of the treatment frame in the z-frame: origin the treatment point, z axis the needle's
 * direction. Joints within their limits (beyond the linkage's reach the height is taken at the end
 * of reach).
 *
 * @satisfies SWR-KIN-001
 * @satisfies SWR-KIN-003
 * @satisfies SWR-KIN-005
 */
void neuro_forward(const robot_t *robot, const probe_t *probe, const joints_t *joints,
                   rigid_t *zframe_treatment);

/**
 * Joints for an entry point, a treatment point and a roll about the needle, all in the z-frame.
 * Limits are judged where the axes will stand: at the nearest ticks, inclusive.
 *
 * @return status STATUS_OK; STATUS_DEGENERATE_LINE when entry and target are the same;
 * STATUS_SINGULAR_PITCH when the needle is within 1e-6 rad of the lateral axis;
 * STATUS_UNREACHABLE_HEIGHT; STATUS_AXIS_LIMIT or STATUS_SEPARATION_LIMIT, whichever is missed by
 * the larger part of its range. Not STATUS_OK: `joints` is unspecified.
 *
 * @satisfies SWR-KIN-002
 * @satisfies SWR-KIN-004
 */
solution_t neuro_inverse(const robot_t *robot, const probe_t *probe, const needle_line_t *line,
                         joints_t *joints);

/**
 * Joints that put the treatment frame at `pose`, which passed rigid_check(), with the given
 * insertion depth (0 = fully retracted). The rotation is the turn of the pose about z relative to
 * R0 Rx(yaw) Ry(pitch), in [-half a turn, half a turn). Same returns as neuro_inverse() except
 * STATUS_DEGENERATE_LINE.
 *
 * @satisfies SWR-KIN-002
 * @satisfies SWR-KIN-004
 */
solution_t neuro_inverse_at_depth(const robot_t *robot, const probe_t *probe, const rigid_t *pose,
                                  int32_t depth_nm, joints_t *joints);

/**
 * Joints for `pose`. With `entry` (not NULL, in the z-frame) within LIMIT_ENTRY_ON_AXIS_NM of the
 * needle's axis the depth is the one that puts the entry point there. Otherwise the depth is free:
 * of the whole millimetres inside the insertion limits the largest one with a margin (distance to
 * the nearer limit as a fraction of the range, the smallest of insertion, carriages, lateral axis
 * and separation) of LIMIT_DEPTH_MARGIN_PERCENT; without one the depth whose margin is largest.
 *
 * @return as neuro_inverse_at_depth(); without a legal free depth the limit that is missed by the
 * least. is_by_entry: the entry point decided the depth, and no angle is what is refused
 *
 * @satisfies SWR-PLAN-001
 * @satisfies SWR-PLAN-002
 * @satisfies SWR-PLAN-003
 * @satisfies SWR-PLAN-014
 */
solution_t neuro_solve(const robot_t *robot, const probe_t *probe, const rigid_t *pose,
                       const point_t *entry, joints_t *joints);

/**
 * The separation of the axial carriages, nm: the one coupled limit.
 *
 * @satisfies SWR-COUPLE-004
 */
int64_t neuro_coupled(const robot_t *robot, uint32_t index, const joints_t *joints);

#endif
