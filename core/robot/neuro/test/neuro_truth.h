/* SPDX-License-Identifier: Apache-2.0 */
/** @file What the coupled limit of the NeuroRobot measures, in double precision. */
#ifndef BORESIGHT_NEURO_TRUTH_H
#define BORESIGHT_NEURO_TRUTH_H

#include "robot/robot.h"

#include <stdint.h>

/** The separation of the axial carriages (mm) with the axes at `places` (mm, degrees). */
double neuro_truth_coupled(const robot_t *robot, uint32_t index,
                           const double places[ROBOT_AXIS_MAX]);

#endif
