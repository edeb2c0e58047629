/* SPDX-License-Identifier: Apache-2.0 */
/** @file What a sweep would measure of a motor that is as the robot's file says. */
#ifndef BORESIGHT_SWEEP_EXPECTED_H
#define BORESIGHT_SWEEP_EXPECTED_H

#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/**
 * The speed of `axis`, one that turns, at a frequency, as the robot's file gives it.
 *
 * @return false: nothing, this frequency is not the axis' own
 */
bool sweep_expected(const axis_config_t *axis, int32_t hertz, double *turns_per_min);

#endif
