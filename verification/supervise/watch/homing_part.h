/* SPDX-License-Identifier: Apache-2.0 */
/** @file Axes that have a part in homing, by the robot's table and by what is shown of its axes. */
#ifndef BORESIGHT_HOMING_PART_H
#define BORESIGHT_HOMING_PART_H

#include "integration/support/rig.h"

#include <stdbool.h>
#include <stdint.h>

/** `axis` is shown as homed, whether verified or taken where it stood. */
bool homing_part_is_homed(const rig_t *rig, uint32_t axis);

/** `axis` is shown on its way to its switch. */
bool homing_part_is_homing(const rig_t *rig, uint32_t axis);

/** How many axes that share a limit with another have lost their positions. */
uint32_t homing_part_lost_carriages(const rig_t *rig);

/** START_UP may drive `axis` now: it homes in its scenario, goes with one that does; it is the
 * needle and leaves; or all are homed and go to the pose home. */
bool homing_part_has(const rig_t *rig, uint32_t axis);

#endif
