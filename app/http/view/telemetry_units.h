/* SPDX-License-Identifier: Apache-2.0 */
/** @file The border between the core's integers and the mm and degrees that people read and write.
 */
#ifndef BORESIGHT_TELEMETRY_UNITS_H
#define BORESIGHT_TELEMETRY_UNITS_H

#include "base/rigid.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** "mm" or "deg". */
const char *telemetry_units_name(const axis_config_t *axis);

/** A position of `axis` in its unit. */
double telemetry_units_position(const axis_config_t *axis, int32_t ticks);

/** A speed of `axis` in its unit per second. */
double telemetry_units_speed(const axis_config_t *axis, int32_t speed_ticks_per_s_q8);

/** `length_nm` in mm. */
double telemetry_units_length(int32_t length_nm);

/** `pose` as a homogeneous matrix by rows, translation in mm. */
void telemetry_units_matrix(const rigid_t *pose, double matrix[16]);

/** `point` in mm. */
void telemetry_units_point(const point_t *point, double coordinates[3]);

/** The same the other way round. Returns the place of the first number that no pose has: an entry
 * of a rotation beyond 1, of the last row another than 0 0 0 1, a coordinate beyond 2 m; 16: there
 * is none. Whether it is rigid, control finds. */
uint32_t telemetry_units_pose(const double matrix[16], rigid_t *pose);

/** The range of the number at `place`, 0..15 by rows, of such a matrix, in words. */
const char *telemetry_units_pose_range(uint32_t place);

/** The pose of `point` in mm and a quaternion of w, x, y and z. False: its length is not 1, within
 * 0.001.
 *
 * @satisfies SWR-HTTP-083
 */
bool telemetry_units_quaternion(const double point[3], const double quaternion[4], rigid_t *pose);

/** Coordinates of at most 2 m. */
void telemetry_units_read_point(const double coordinates[3], point_t *point);

/** Distance between the origins of `a` and `b` in mm. */
double telemetry_units_distance(const rigid_t *a, const rigid_t *b);

#endif
