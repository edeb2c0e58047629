/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Truth about a robot where its simulated axes stand, in double precision and mm or degrees. A
 * robot says what its coupled limits measure without the functions of the core that judge the same:
 * core/robot/<name>/test/<name>_truth.h. For a robot without them, the core's are believed.
 */
#ifndef BORESIGHT_TRUTH_H
#define BORESIGHT_TRUTH_H

#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** nm as mm, or bam as degrees; `unit` is an axis_unit_t. */
double truth_in_words(uint8_t unit, double units);

/** `ticks` counts of `axis`. */
double truth_measure(const axis_config_t *axis, double ticks);

/** Measure of the coupled limit `index`, below robot->coupled_limit_count. */
double truth_coupled(const robot_t *robot, uint32_t index, const double ticks[ROBOT_AXIS_MAX]);

/** How far beyond its range that is; inside below 0: how far from the nearer end. */
double truth_coupled_beyond(const robot_t *robot, uint32_t index,
                            const double ticks[ROBOT_AXIS_MAX]);

/** From one end to the other. */
double truth_coupled_range(const robot_t *robot, uint32_t index);

/** Bit n: the axis n has part in it. */
uint32_t truth_coupled_axes(const robot_t *robot, uint32_t index);

#endif
