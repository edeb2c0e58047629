/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The ProstateRobot in double precision, from points and lines and without its angles: the judge of
 * the integer kinematics. mm and rad, in the base.
 */
#ifndef BORESIGHT_PROSTATE_REFERENCE_H
#define BORESIGHT_PROSTATE_REFERENCE_H

#include "base/rigid.h"
#include "robot/joints.h"
#include "robot/robot.h"
#include "robot/robot_prostate.h"

#include <math.h>

#define REFERENCE_PI 3.14159265358979323846
#define REFERENCE_NM_PER_MM 1.0e6

typedef struct {
    double axis[3][3]; /* x, y and z of the treatment frame. */
    double tip_mm[3];
} prostate_reference_t;

static inline double reference_probe(const robot_t *robot, unsigned place)
{
    return robot->probe.length_nm[place] / REFERENCE_NM_PER_MM;
}

static inline double reference_length(const robot_t *robot, unsigned place)
{
    return robot->geometry_nm[place] / REFERENCE_NM_PER_MM;
}

static inline double reference_dot(const double a[3], const double b[3])
{
    return (a[0] * b[0]) + (a[1] * b[1]) + (a[2] * b[2]);
}

static inline void reference_cross(const double a[3], const double b[3], double result[3])
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        result[i] = (a[j] * b[k]) - (a[k] * b[j]);
    }
}

static inline void reference_normalise(double vector[3])
{
    const double length = sqrt(reference_dot(vector, vector));
    for (int i = 0; i < 3; i++) {
        vector[i] /= length;
    }
}

/* x is level and y upwards, as long as the needle has not turned. */
static inline void reference_frame(const double direction[3], double axis[3][3])
{
    const double up[3] = {0.0, 1.0, 0.0};
    for (int i = 0; i < 3; i++) {
        axis[2][i] = direction[i];
    }
    reference_normalise(axis[2]);
    reference_cross(up, axis[2], axis[0]);
    reference_normalise(axis[0]);
    reference_cross(axis[2], axis[0], axis[1]);
}

static inline void reference_pivot(const robot_t *robot, double left, double right, double behind,
                                   double pivot[3])
{
    const double link = reference_length(robot, PROSTATE_SIDE_LINK);
    const double side = (left - right - reference_length(robot, PROSTATE_TOP_WIDTH)) / 2.0;
    pivot[0] = (left + right) / 2.0;
    pivot[1] = reference_length(robot, PROSTATE_LOWER_HEIGHT) +
               reference_length(robot, PROSTATE_UPPER_HEIGHT) + sqrt((link * link) - (side * side));
    pivot[2] = -reference_length(robot, PROSTATE_PIVOT_DEPTH) - behind;
}

/* Joint values as mm and rad. */
static inline void reference_joints(const joints_t *joints, double joint[ROBOT_AXIS_MAX])
{
    for (unsigned i = 0; i < PROSTATE_AXIS_ROTATION; i++) {
        joint[i] = joints->value[i] / REFERENCE_NM_PER_MM;
    }
    joint[PROSTATE_AXIS_ROTATION] =
        joints->value[PROSTATE_AXIS_ROTATION] * (REFERENCE_PI / 2147483648.0);
}

static inline void reference_line(const robot_t *robot, const double joint[ROBOT_AXIS_MAX],
                                  double front[3], double direction[3])
{
    double rear[3];
    reference_pivot(robot, joint[PROSTATE_AXIS_FRONT_LEFT], joint[PROSTATE_AXIS_FRONT_RIGHT], 0.0,
                    front);
    reference_pivot(robot, joint[PROSTATE_AXIS_REAR_LEFT], joint[PROSTATE_AXIS_REAR_RIGHT],
                    reference_length(robot, PROSTATE_STAGE_DISTANCE), rear);
    for (int i = 0; i < 3; i++) {
        direction[i] = front[i] - rear[i];
    }
    reference_normalise(direction);
}

static inline void reference_angles(const double direction[3], double *alpha, double *beta)
{
    *alpha = asin(direction[0] / hypot(direction[0], direction[2]));
    *beta = -asin(direction[1]);
}

static inline void reference_forward(const robot_t *robot, const double joint[ROBOT_AXIS_MAX],
                                     prostate_reference_t *pose)
{
    double level[3][3];
    double front[3];
    double direction[3];
    const double roll = joint[PROSTATE_AXIS_ROTATION];
    const double lever =
        reference_probe(robot, PROSTATE_PROBE_NEEDLE_TIP) + joint[PROSTATE_AXIS_INSERTION];
    reference_line(robot, joint, front, direction);
    reference_frame(direction, level);
    for (int i = 0; i < 3; i++) {
        pose->axis[0][i] = (level[0][i] * cos(roll)) + (level[1][i] * sin(roll));
        pose->axis[1][i] = (level[1][i] * cos(roll)) - (level[0][i] * sin(roll));
        pose->axis[2][i] = level[2][i];
        pose->tip_mm[i] = front[i] +
                          (reference_probe(robot, PROSTATE_PROBE_NEEDLE_HEIGHT) * level[1][i]) +
                          (lever * level[2][i]);
    }
}

/* The same in the z-frame. */
static inline void reference_to_zframe(const robot_t *robot, prostate_reference_t *pose)
{
    for (unsigned i = 0; i < 3; i++) {
        pose->tip_mm[i] -= reference_length(robot, PROSTATE_ZFRAME_X + i);
    }
}

/* Distance (mm) of the tips and largest angle (rad) between axes of the same name. */
static inline void reference_difference(const prostate_reference_t *reference, const rigid_t *pose,
                                        double *distance_mm, double *angle_rad)
{
    const double tip_mm[3] = {pose->translation.x_nm / REFERENCE_NM_PER_MM,
                              pose->translation.y_nm / REFERENCE_NM_PER_MM,
                              pose->translation.z_nm / REFERENCE_NM_PER_MM};
    double square = 0.0;
    *angle_rad = 0.0;
    for (int j = 0; j < 3; j++) {
        double chord = 0.0;
        for (int i = 0; i < 3; i++) {
            const double entry = pose->rotation_q30[i][j] / 1073741824.0;
            chord += (reference->axis[j][i] - entry) * (reference->axis[j][i] - entry);
        }
        *angle_rad = fmax(*angle_rad, 2.0 * asin(fmin(1.0, sqrt(chord) / 2.0)));
        square += (reference->tip_mm[j] - tip_mm[j]) * (reference->tip_mm[j] - tip_mm[j]);
    }
    *distance_mm = sqrt(square);
}

#endif
