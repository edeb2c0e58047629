/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The NeuroRobot in double precision, written from the mechanism and not from neuro.c: the judge
 * of the integer kinematics. mm and rad.
 */
#ifndef BORESIGHT_NEURO_REFERENCE_H
#define BORESIGHT_NEURO_REFERENCE_H

#include "base/rigid.h"
#include "robot/neuro/neuro.h"
#include "robot/robot.h"

#include <stdbool.h>

typedef struct {
    double rotation[3][3];
    double translation_mm[3];
} neuro_reference_pose_t;

/** The same joints in mm and rad. */
void neuro_reference_joints(const robot_t *robot, const joints_t *joints,
                            double joint[ROBOT_AXIS_MAX]);

/** Limits of an axis in mm or rad. */
double neuro_reference_limit(const axis_config_t *axis, int32_t ticks);

/** Pose of the treatment frame, by multiplying the elementary rotations. */
void neuro_reference_forward(const robot_t *robot, const double joint[ROBOT_AXIS_MAX],
                             neuro_reference_pose_t *pose);

/** The point on the needle's axis that the entry point of the probe takes at `joint`. */
void neuro_reference_entry(const robot_t *robot, const double joint[ROBOT_AXIS_MAX],
                           double entry_mm[3]);

/** Joints at `pose` and depth; false out of the linkage's reach. */
bool neuro_reference_inverse(const robot_t *robot, const neuro_reference_pose_t *pose,
                             double depth_mm, double joint[ROBOT_AXIS_MAX]);

/** Smallest joint margin at `joint`, separation included. */
double neuro_reference_margin(const robot_t *robot, const double joint[ROBOT_AXIS_MAX]);

/** The same of what a depth moves: insertion, carriages, lateral axis and separation. */
double neuro_reference_depth_margin(const robot_t *robot, const double joint[ROBOT_AXIS_MAX]);

/** Distance (mm) between the origins, and largest angle (rad) between the axes, of two poses. */
void neuro_reference_difference(const neuro_reference_pose_t *reference, const rigid_t *pose,
                                double *distance_mm, double *angle_rad);

/** `pose` in double precision. */
void neuro_reference_of(const rigid_t *pose, neuro_reference_pose_t *reference);

#endif
