/* SPDX-License-Identifier: Apache-2.0 */
/** @file What the coupled limits of the ProstateRobot measure, in double precision. */
#ifndef BORESIGHT_PROSTATE_TRUTH_H
#define BORESIGHT_PROSTATE_TRUTH_H

#include "robot/robot.h"

#include <stdint.h>

/** The gap of the front or rear carriages (mm), alpha or beta (degrees): the limit `index` of
 * kinematics.yml, with the axes at `places` (mm, degrees). */
double prostate_truth_coupled(const robot_t *robot, uint32_t index,
                              const double places[ROBOT_AXIS_MAX]);

#endif
