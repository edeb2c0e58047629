/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Forward and inverse kinematics of the ProstateRobot, with angulation. Two stages stand across the
 * bore, `stage_distance` apart; each carries a pivot on a trapezoid, which two carriages move along
 * x and, as far as they stand apart, up and down. The needle lies on the line from the rear pivot
 * to the front one, `needle_height` above it. Mechanism of Eslami et al. 2016, closed form.
 *
 * Joint values are nm (carriages, insertion) or bam (rotation), in the order of the axes in
 * robot.yml. The base has x across, y up and z towards the patient; every pose is given in the
 * z-frame, which stands in the base by the shift `zframe`, without a turn. The treatment frame is
 * the needle's tip, z along the needle: Ry(alpha) Rx(beta) Rz(rotation).
 *
 * Thesis Listing 3 is not followed where it errs: it takes the link of the trapezoid for the length
 * of the needle in x and y, turns beta the other way, leaves out in one direction the depth of the
 * front pivot and the height of the needle that it puts into the other, measures the rear pivot
 * from another zero than the front one, and takes roots of what may be negative.
 */
#ifndef BORESIGHT_PROSTATE_H
#define BORESIGHT_PROSTATE_H

#include "base/rigid.h"
#include "interface/status.h"
#include "robot/joints.h"
#include "robot/margin.h"
#include "robot/robot.h"

#include <stdint.h>

/** The coupled limits, in the order of kinematics.yml: how far the left carriage of a stage is from
 * the right one (nm), and the angles of the needle (bam): alpha is positive to the left, beta
 * down. */
#define PROSTATE_FRONT_GAP 0U
#define PROSTATE_REAR_GAP 1U
#define PROSTATE_ALPHA 2U
#define PROSTATE_BETA 3U

/** They count as joints, and so do the heights of the trapezoids. */
#define PROSTATE_LIMIT_COUPLED JOINT_LIMIT_FURTHER
#define PROSTATE_LIMIT_FRONT_HEIGHT (JOINT_LIMIT_FURTHER + 4U)
#define PROSTATE_LIMIT_REAR_HEIGHT (JOINT_LIMIT_FURTHER + 5U)

/**
 * Pose of the needle's tip in the z-frame. Joint values may be any: beyond the reach of a trapezoid
 * its height is taken at the end of reach, and coordinates saturate.
 *
 * @satisfies SWR-KIN-001
 * @satisfies SWR-KIN-003
 * @satisfies SWR-KIN-005
 * @satisfies SWR-KIN-010
 * @satisfies SWR-KIN-012
 */
void prostate_forward(const robot_t *robot, const probe_t *probe, const joints_t *joints,
                      rigid_t *zframe_treatment);

/**
 * Joints for a needle on `line`, its tip at the target. Angles and heights are judged as asked for,
 * all else where the axes will stand: at the nearest ticks, inclusive.
 *
 * @return status STATUS_OK; STATUS_DEGENERATE_LINE when entry and target are the same;
 * STATUS_NEEDLE_BACKWARDS when the needle would not point towards the patient; STATUS_ALPHA_LIMIT
 * or STATUS_BETA_LIMIT; STATUS_FRONT_HEIGHT or STATUS_REAR_HEIGHT when a stage cannot rise or sink
 * that far; STATUS_AXIS_LIMIT, STATUS_FRONT_SEPARATION or STATUS_REAR_SEPARATION. In this order,
 * and of those named together the one that is missed by the largest part of its range. Not
 * STATUS_OK: `joints` is unspecified.
 *
 * @satisfies SWR-KIN-002
 * @satisfies SWR-KIN-004
 * @satisfies SWR-KIN-010
 * @satisfies SWR-KIN-011
 * @satisfies SWR-KIN-012
 */
solution_t prostate_inverse(const robot_t *robot, const probe_t *probe, const needle_line_t *line,
                            joints_t *joints);

/**
 * Joints that put the needle's tip at `pose`, which passed rigid_check(); one that did not is
 * refused, or its joints are those of another pose, which the plan finds. The pose fixes all six
 * joints: two points are the line that it has already, so `entry` decides nothing, as for the
 * NeuroRobot an entry off the needle's axis. The rotation is the turn of the pose about z relative
 * to Ry(alpha) Rx(beta), in [-half a turn, half a turn): of its turns the one nearest to the axis'
 * zero, from where no other is ever asked for.
 *
 * @return as prostate_inverse(), except STATUS_DEGENERATE_LINE
 *
 * @satisfies SWR-KIN-002
 * @satisfies SWR-KIN-004
 * @satisfies SWR-KIN-010
 * @satisfies SWR-KIN-011
 * @satisfies SWR-KIN-012
 * @satisfies SWR-KIN-013
 */
solution_t prostate_solve(const robot_t *robot, const probe_t *probe, const rigid_t *pose,
                          const point_t *entry, joints_t *joints);

/**
 * Value of coupled limit `index` at `joints`; each index that is none of them is beta.
 *
 * @satisfies SWR-COUPLE-004
 * @satisfies SWR-KIN-010
 * @satisfies SWR-KIN-012
 */
int64_t prostate_coupled(const robot_t *robot, uint32_t index, const joints_t *joints);

#endif
