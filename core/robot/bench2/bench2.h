/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Kinematics of the bench: the slide carries the needle along x, the needle points along -y of the
 * z-frame and turns about nothing. Joint values are nm, in the order of the axes in robot.yml.
 */
#ifndef BORESIGHT_BENCH2_H
#define BORESIGHT_BENCH2_H

#include "base/rigid.h"
#include "robot/joints.h"
#include "robot/robot.h"

#include <stdint.h>

/**
 * Pose of the treatment frame in the z-frame: x = home + slide, y = home - needle, z = home. It
 * has no probe.
 *
 * @satisfies SWR-KIN-003
 */
void bench2_forward(const robot_t *robot, const probe_t *probe, const joints_t *joints,
                    rigid_t *zframe_treatment);

/**
 * Joints for `line`.
 *
 * @return status STATUS_OK; STATUS_DEGENERATE_LINE when the two are the same; STATUS_CLOSURE when
 * the line is not the needle's within LIMIT_CLOSURE_NM, or its roll is beyond LIMIT_CLOSURE_BAM;
 * STATUS_AXIS_LIMIT. Not STATUS_OK: `joints` is unspecified.
 *
 * @satisfies SWR-KIN-002
 * @satisfies SWR-KIN-004
 */
solution_t bench2_inverse(const robot_t *robot, const probe_t *probe, const needle_line_t *line,
                          joints_t *joints);

/**
 * Joints that put the treatment point at that of `pose`; the plan refuses a pose that they do not
 * reach. The depth is not free, so `entry` decides nothing.
 *
 * @return status STATUS_OK, STATUS_AXIS_LIMIT
 *
 * @satisfies SWR-KIN-002
 * @satisfies SWR-KIN-004
 */
solution_t bench2_solve(const robot_t *robot, const probe_t *probe, const rigid_t *pose,
                        const point_t *entry, joints_t *joints);

#endif
