/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The border between the floats of the network and the integers of the robot. Inwards the bits of
 * an IEEE-754 number are taken apart as integers, so that nothing that is not finite is ever
 * computed with.
 */
#ifndef BORESIGHT_IGTL_UNITS_H
#define BORESIGHT_IGTL_UNITS_H

#include "base/rigid.h"
#include "igtl/wire/igtl_codec.h"
#include "igtl/wire/igtl_packet.h"
#include "interface/status.h"
#include "robot/robot.h"

#include <stdint.h>

#define IGTL_UNITS_MAX_NM INT32_C(2000000000) /**< Farthest coordinate, +-2.0 m. */
#define IGTL_LIST_SIZE (IGTL_TEXT_MAX + 1U)   /**< Room for the numbers of all axes as text. */

/**
 * Millimetres as float bits to nm, rounded half away from zero.
 *
 * @return STATUS_OK, STATUS_NOT_FINITE, STATUS_OUT_OF_RANGE beyond +-IGTL_UNITS_MAX_NM
 */
status_t igtl_units_read_mm(uint32_t bits, int32_t *length_nm);

/**
 * An entry of a rotation matrix as float bits to q30, rounded half away from zero.
 *
 * @return STATUS_OK, STATUS_NOT_FINITE, STATUS_NOT_RIGID beyond +-(1 + 1e-3)
 */
status_t igtl_units_read_entry(uint32_t bits, int32_t *entry_q30);

/**
 * A point as float bits in mm; unspecified when refused.
 *
 * @return STATUS_OK, STATUS_NOT_FINITE, STATUS_OUT_OF_RANGE
 */
status_t igtl_units_read_point(const uint32_t numbers[3], point_t *point);

/**
 * The matrix of a TRANSFORM, each number by itself: whether it is rigid, the controller finds
 * (rigid_check()). `pose` is complete, or unspecified when refused.
 *
 * @return STATUS_OK, STATUS_NOT_FINITE, STATUS_OUT_OF_RANGE of the translation, STATUS_NOT_RIGID
 * for an entry that no rotation has
 *
 * @satisfies SWR-IGTL-010
 */
status_t igtl_units_read_pose(const uint32_t numbers[IGTL_TRANSFORM_NUMBERS], rigid_t *pose);

/**
 * Number `index` of an NDARRAY, which must be whole.
 *
 * @return STATUS_OK, STATUS_NOT_FINITE, STATUS_OUT_OF_RANGE beyond +-INT32_MAX or with a fraction
 *
 * @satisfies SWR-TRAJ-023
 */
status_t igtl_units_read_whole(const igtl_message_t *message, uint32_t index, int32_t *value);

/**
 * Number `index` of an NDARRAY.
 *
 * @return STATUS_OK, or STATUS_NOT_FINITE
 *
 * @satisfies SWR-PROG-014
 */
status_t igtl_units_read_double(const igtl_message_t *message, uint32_t index, double *value);

/** mN as newtons, for a text. */
double igtl_units_newtons(int32_t force_mn);

/** mN as bits of a double in newton, the nearest one. */
uint64_t igtl_units_write_newtons(int32_t force_mn);

/** nm as mm, for a text. */
double igtl_units_mm(int32_t length_nm);

/** nm as float bits in mm, the nearest float. */
uint32_t igtl_units_write_mm(int32_t length_nm);

/** `pose` as the numbers of a TRANSFORM. */
void igtl_units_write_pose(const rigid_t *pose, uint32_t numbers[IGTL_TRANSFORM_NUMBERS]);

/** `point` as float bits in mm. */
void igtl_units_write_point(const point_t *point, uint32_t numbers[3]);

/**
 * Joint values of positions in ticks as text: "%f," for each axis in the order of
 * robot->reported_joints, mm and radians.
 *
 * @satisfies SWR-IGTL-038
 */
void igtl_units_write_positions(const robot_t *robot, const int32_t ticks[ROBOT_AXIS_MAX],
                                char text[IGTL_LIST_SIZE]);

/**
 * Joint speeds as text: "%f," for each axis in the order of robot->reported_joints, mm/s and rad/s.
 *
 * @satisfies SWR-IGTL-038
 */
void igtl_units_write_speeds(const robot_t *robot,
                             const int32_t speeds_ticks_per_s_q8[ROBOT_AXIS_MAX],
                             char text[IGTL_LIST_SIZE]);

#endif
