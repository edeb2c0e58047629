/* SPDX-License-Identifier: Apache-2.0 */
/** @file Whether a table of the robot is still as it was compiled. */
#ifndef BORESIGHT_ROBOT_DAMAGE_H
#define BORESIGHT_ROBOT_DAMAGE_H

#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** Part that stands in robot_damage() for all that is no axis. */
#define ROBOT_PART_GEOMETRY ROBOT_AXIS_MAX

/**
 * Compares the seals that were compiled into the table with it; cheap enough for every cycle.
 *
 * @return bit n: the row of axis n is damaged; bit ROBOT_PART_GEOMETRY: the home pose, or
 * what stands before the rows, whose number is then not known, so none is looked at. The other
 * poses are looked at when one is commanded.
 *
 * @satisfies SWR-MEMORY-004
 */
uint32_t robot_damage(const robot_t *robot);

/** The robot's file names `pose` (pose_name_t; any other number is none). */
static inline bool robot_has_pose(const robot_t *robot, uint32_t pose)
{
    return (pose < POSE_NAME_COUNT) && (((robot->pose_mask >> pose) & 1U) != 0U);
}

/** `pose`, one that the robot has, is not as it was compiled. */
bool robot_is_pose_damaged(const robot_t *robot, uint32_t pose);

/**
 * The force sensor is not as it was compiled; or there seems to be one, in a robot that has none.
 * It is no part of robot_damage(): only a mode in which a hand moves the needle rests on it, asks,
 * and ends by it.
 *
 * @satisfies SWR-FORCE-576
 */
bool robot_is_force_damaged(const robot_t *robot);

#endif
