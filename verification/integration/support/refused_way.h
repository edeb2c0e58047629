/* SPDX-License-Identifier: Apache-2.0 */
/** @file A robot that stands, as after jogs, where the way to its target would leave a limit that
 * axes share. */
#ifndef BORESIGHT_REFUSED_WAY_H
#define BORESIGHT_REFUSED_WAY_H

#include "integration/support/rig.h"
#include "unit/support/refused_pair.h"

/** The rig is homed there, in TARGETING, and has the target, accepted from the pose DRAPING.
 * `standing` is the robot as it is switched on there and must outlive the rig. */
void refused_way_start(const refused_pair_t *pair, const robot_t *robot, robot_t *standing,
                       rig_t *rig);

#endif
