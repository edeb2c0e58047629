/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Where the operator of a play wants the needle. The NeuroRobot is asked for straight needles as in
 * its clinic; any other robot for what it reaches somewhere on the ways of its axes.
 */
#ifndef BORESIGHT_TARGETS_H
#define BORESIGHT_TARGETS_H

#include "base/rigid.h"
#include "robot/joints.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** One that is surely in reach. */
rigid_t targets_first(const robot_t *robot);

/** Any, mostly in reach. */
rigid_t targets_any(const robot_t *robot, uint32_t *random);

/** One of many that are near each other. */
rigid_t targets_near(const robot_t *robot, uint32_t *random);

/** The entry point by which `joints` are chosen for their pose `target`. @return false: the robot
 * asks for none, the pose decides its depth */
bool targets_entry(const robot_t *robot, const joints_t *joints, const rigid_t *target,
                   point_t *entry);

#endif
