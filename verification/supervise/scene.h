/* SPDX-License-Identifier: Apache-2.0 */
/** @file One scene: the rig, the players on its scenario, and the oracle. */
#ifndef BORESIGHT_SCENE_H
#define BORESIGHT_SCENE_H

#include "supervise/scenario/scenario.h"
#include "supervise/watch/motion_oracle.h"

/** Owned by the program. */
typedef struct {
    rig_t rig;
    scenario_t scenario;
    motion_oracle_t oracle;
} scene_t;

/** Sets the scene `seed` of `robot`, which must outlive it; what the oracle has seen before stays.
 */
void scene_begin(scene_t *self, const robot_t *robot, play_t play, uint32_t seed);

/** One cycle under the eyes of the oracle. */
void scene_cycle(scene_t *self);

#endif
