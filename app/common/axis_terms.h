/* SPDX-License-Identifier: Apache-2.0 */
/** @file Axes in the terms of people: by their names, in mm and degrees. */
#ifndef BORESIGHT_AXIS_TERMS_H
#define BORESIGHT_AXIS_TERMS_H

#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** The axis of this name; the robot's axis_count when it has none. */
uint32_t axis_terms_find(const robot_t *robot, const char *name);

/** Size of a tick of `axis`, in mm or degrees. */
double axis_terms_unit(const axis_config_t *axis);

/** "mm" or "deg". */
const char *axis_terms_unit_name(const axis_config_t *axis);

/** The whole number of ticks that is nearest to `way`, in mm or degrees; of a speed the same for
 * each second. False when no int32_t is so far away. */
bool axis_terms_ticks(const axis_config_t *axis, double way, int32_t *ticks);

#endif
