/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The kinematics of any robot: one switch on robot->kind, made by tools/compile/robots.rb from the
 * folders of core/robot. There is no function pointer, so the call graph stays as it is written.
 * Each function does what that of the robot's own folder with the same end of its name says.
 */
#ifndef BORESIGHT_KINEMATICS_H
#define BORESIGHT_KINEMATICS_H

#include "base/rigid.h"
#include "robot/joints.h"
#include "robot/robot.h"

#include <stdint.h>

/** Pose of the treatment frame of `probe` in the z-frame; the identity for an unknown kind.
 *
 * @satisfies SWR-PROBE-003
 */
void kinematics_forward(const robot_t *robot, const probe_t *probe, const joints_t *joints,
                        rigid_t *zframe_treatment);

/**
 * Joints for an entry point, a treatment point and a roll about the needle, in the z-frame.
 *
 * @return as the robot's kinematics; STATUS_MEMORY_DAMAGED for an unknown kind
 */
solution_t kinematics_inverse(const robot_t *robot, const probe_t *probe, const needle_line_t *line,
                              joints_t *joints);

/**
 * Joints for `pose`, with `entry` (in the z-frame) or without (NULL).
 *
 * @return as the robot's kinematics; STATUS_MEMORY_DAMAGED for an unknown kind
 */
solution_t kinematics_solve(const robot_t *robot, const probe_t *probe, const rigid_t *pose,
                            const point_t *entry, joints_t *joints);

/**
 * Value of coupled limit `index` (below robot->coupled_limit_count) at `joints`, in nm or bam as
 * the limit says. Any joints have a value, within 2^48; axes that are not the limit's do not count.
 *
 * @return 0 for an unknown kind
 *
 * @satisfies SWR-COUPLE-004
 */
int64_t kinematics_coupled(const robot_t *robot, uint32_t index, const joints_t *joints);

#endif
