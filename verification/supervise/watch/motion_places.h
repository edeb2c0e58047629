/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The part of the motion oracle that compares where the axes truly stand with what is believed,
 * shown and allowed.
 */
#ifndef BORESIGHT_MOTION_PLACES_H
#define BORESIGHT_MOTION_PLACES_H

#include "supervise/watch/motion_oracle.h"

#include <stdbool.h>

/** Judges the cycle that `rig` has just run, before the orders of that cycle are noted; arguments
 * as of motion_oracle_look(). */
void motion_places_look(motion_oracle_t *self, const rig_t *rig, const double truth[ROBOT_AXIS_MAX],
                        bool is_disturbed);

#endif
