/* SPDX-License-Identifier: Apache-2.0 */
#include "robot/neuro/test/neuro_reference.h"

#include "robot/robot_neuro.h"

#include <math.h>
#include <string.h>

#define PI 3.14159265358979323846
#define NM_PER_MM 1.0e6
#define Q30 1073741824.0

static void multiply(const double a[3][3], const double b[3][3], double result[3][3])
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            result[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
        }
    }
}

static void frame(double pitch, double yaw, double result[3][3])
{
    const double home[3][3] = {{-1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, {0.0, -1.0, 0.0}};
    const double about_x[3][3] = {
        {1.0, 0.0, 0.0}, {0.0, cos(yaw), -sin(yaw)}, {0.0, sin(yaw), cos(yaw)}};
    const double about_y[3][3] = {
        {cos(pitch), 0.0, sin(pitch)}, {0.0, 1.0, 0.0}, {-sin(pitch), 0.0, cos(pitch)}};
    double outer[3][3];
    multiply(home, about_x, outer);
    multiply((const double(*)[3])outer, about_y, result);
}

static double height(const robot_t *robot, double separation_mm)
{
    const double link = robot->geometry_nm[NEURO_SIDE_LINK] / NM_PER_MM;
    const double half = (separation_mm - robot->geometry_nm[NEURO_TOP_WIDTH] / NM_PER_MM) / 2.0;
    return sqrt(link * link - half * half);
}

static void rcm(const robot_t *robot, const double joint[ROBOT_AXIS_MAX], double point_mm[3])
{
    const double home = robot->geometry_nm[NEURO_HOME_SEPARATION] / NM_PER_MM;
    const double separation = home + joint[NEURO_AXIS_HEAD] - joint[NEURO_AXIS_FEET];
    point_mm[0] = robot->geometry_nm[NEURO_RCM_HOME_X] / NM_PER_MM + joint[NEURO_AXIS_LATERAL];
    point_mm[1] = robot->geometry_nm[NEURO_RCM_HOME_Y] / NM_PER_MM + height(robot, separation) -
                  height(robot, home);
    point_mm[2] = robot->geometry_nm[NEURO_RCM_HOME_Z] / NM_PER_MM +
                  (joint[NEURO_AXIS_HEAD] + joint[NEURO_AXIS_FEET]) / 2.0;
}

void neuro_reference_joints(const robot_t *robot, const joints_t *joints,
                            double joint[ROBOT_AXIS_MAX])
{
    for (unsigned i = 0; i < robot->axis_count; i++) {
        const bool is_angle = robot->axes[i].unit == AXIS_UNIT_RAD;
        joint[i] = is_angle ? joints->value[i] * (PI / 2147483648.0) : joints->value[i] / NM_PER_MM;
    }
}

double neuro_reference_limit(const axis_config_t *axis, int32_t ticks)
{
    const double units = ticks * (axis->unit_per_tick_q16 / 65536.0);
    return (axis->unit == AXIS_UNIT_RAD) ? units * (PI / 2147483648.0) : units / NM_PER_MM;
}

void neuro_reference_forward(const robot_t *robot, const double joint[ROBOT_AXIS_MAX],
                             neuro_reference_pose_t *pose)
{
    const double roll = joint[NEURO_AXIS_ROTATION];
    const double about_z[3][3] = {
        {cos(roll), -sin(roll), 0.0}, {sin(roll), cos(roll), 0.0}, {0.0, 0.0, 1.0}};
    const double lever =
        joint[NEURO_AXIS_INSERTION] + (robot->probe.length_nm[NEURO_PROBE_ROBOT_TO_TREATMENT] -
                                       robot->geometry_nm[NEURO_ROBOT_TO_RCM]) /
                                          NM_PER_MM;
    double needle[3][3];
    frame(joint[NEURO_AXIS_PITCH], joint[NEURO_AXIS_YAW], needle);
    multiply((const double(*)[3])needle, about_z, pose->rotation);
    rcm(robot, joint, pose->translation_mm);
    for (int i = 0; i < 3; i++) {
        pose->translation_mm[i] += lever * needle[i][2];
    }
}

void neuro_reference_entry(const robot_t *robot, const double joint[ROBOT_AXIS_MAX],
                           double entry_mm[3])
{
    const double lever = (robot->probe.length_nm[NEURO_PROBE_ROBOT_TO_ENTRY] -
                          robot->geometry_nm[NEURO_ROBOT_TO_RCM]) /
                         NM_PER_MM;
    double needle[3][3];
    frame(joint[NEURO_AXIS_PITCH], joint[NEURO_AXIS_YAW], needle);
    rcm(robot, joint, entry_mm);
    for (int i = 0; i < 3; i++) {
        entry_mm[i] += lever * needle[i][2];
    }
}

bool neuro_reference_inverse(const robot_t *robot, const neuro_reference_pose_t *pose,
                             double depth_mm, double joint[ROBOT_AXIS_MAX])
{
    const double lever = depth_mm + (robot->probe.length_nm[NEURO_PROBE_ROBOT_TO_TREATMENT] -
                                     robot->geometry_nm[NEURO_ROBOT_TO_RCM]) /
                                        NM_PER_MM;
    const double link = robot->geometry_nm[NEURO_SIDE_LINK] / NM_PER_MM;
    const double home = robot->geometry_nm[NEURO_HOME_SEPARATION] / NM_PER_MM;
    double needle[3][3];
    double point[3];
    double cosine = 0.0;
    double sine = 0.0;
    for (int i = 0; i < 3; i++) {
        point[i] = pose->translation_mm[i] - lever * pose->rotation[i][2];
    }
    joint[NEURO_AXIS_PITCH] = asin(-pose->rotation[0][2]);
    joint[NEURO_AXIS_YAW] = atan2(pose->rotation[2][2], -pose->rotation[1][2]);
    frame(joint[NEURO_AXIS_PITCH], joint[NEURO_AXIS_YAW], needle);
    for (int i = 0; i < 3; i++) {
        cosine += needle[i][0] * pose->rotation[i][0];
        sine += needle[i][1] * pose->rotation[i][0];
    }
    joint[NEURO_AXIS_ROTATION] = atan2(sine, cosine);
    joint[NEURO_AXIS_INSERTION] = depth_mm;
    joint[NEURO_AXIS_LATERAL] = point[0] - robot->geometry_nm[NEURO_RCM_HOME_X] / NM_PER_MM;
    const double risen =
        height(robot, home) + point[1] - robot->geometry_nm[NEURO_RCM_HOME_Y] / NM_PER_MM;
    if (risen <= 0.0 || risen >= link) {
        return false;
    }
    const double opened = 2.0 * sqrt(link * link - risen * risen) +
                          robot->geometry_nm[NEURO_TOP_WIDTH] / NM_PER_MM - home;
    const double moved = point[2] - robot->geometry_nm[NEURO_RCM_HOME_Z] / NM_PER_MM;
    joint[NEURO_AXIS_HEAD] = moved + opened / 2.0;
    joint[NEURO_AXIS_FEET] = moved - opened / 2.0;
    return true;
}

static double margin_of(double value, double minimum, double maximum)
{
    return fmin(value - minimum, maximum - value) / (maximum - minimum);
}

double neuro_reference_margin(const robot_t *robot, const double joint[ROBOT_AXIS_MAX])
{
    const double separation = robot->geometry_nm[NEURO_HOME_SEPARATION] / NM_PER_MM +
                              joint[NEURO_AXIS_HEAD] - joint[NEURO_AXIS_FEET];
    double smallest =
        margin_of(separation, robot->geometry_nm[NEURO_MINIMUM_SEPARATION] / NM_PER_MM,
                  robot->geometry_nm[NEURO_MAXIMUM_SEPARATION] / NM_PER_MM);
    for (unsigned i = 0; i < robot->axis_count; i++) {
        const axis_config_t *axis = &robot->axes[i];
        smallest =
            fmin(smallest, margin_of(joint[i], neuro_reference_limit(axis, axis->minimum_ticks),
                                     neuro_reference_limit(axis, axis->maximum_ticks)));
    }
    return smallest;
}

double neuro_reference_depth_margin(const robot_t *robot, const double joint[ROBOT_AXIS_MAX])
{
    double others[ROBOT_AXIS_MAX];
    memcpy(others, joint, sizeof others);
    for (unsigned i = NEURO_AXIS_ROTATION; i <= NEURO_AXIS_YAW; i++) {
        const axis_config_t *axis = &robot->axes[i];
        others[i] = (neuro_reference_limit(axis, axis->minimum_ticks) +
                     neuro_reference_limit(axis, axis->maximum_ticks)) /
                    2.0;
    }
    return neuro_reference_margin(robot, others);
}

void neuro_reference_difference(const neuro_reference_pose_t *reference, const rigid_t *pose,
                                double *distance_mm, double *angle_rad)
{
    neuro_reference_pose_t other;
    double square = 0.0;
    neuro_reference_of(pose, &other);
    *angle_rad = 0.0;
    for (int j = 0; j < 3; j++) {
        double chord = 0.0;
        for (int i = 0; i < 3; i++) {
            const double difference = reference->rotation[i][j] - other.rotation[i][j];
            chord += difference * difference;
        }
        *angle_rad = fmax(*angle_rad, 2.0 * asin(fmin(1.0, sqrt(chord) / 2.0)));
        const double way = reference->translation_mm[j] - other.translation_mm[j];
        square += way * way;
    }
    *distance_mm = sqrt(square);
}

void neuro_reference_of(const rigid_t *pose, neuro_reference_pose_t *reference)
{
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            reference->rotation[i][j] = pose->rotation_q30[i][j] / Q30;
        }
    }
    reference->translation_mm[0] = pose->translation.x_nm / NM_PER_MM;
    reference->translation_mm[1] = pose->translation.y_nm / NM_PER_MM;
    reference->translation_mm[2] = pose->translation.z_nm / NM_PER_MM;
}
