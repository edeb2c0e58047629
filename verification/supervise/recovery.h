/* SPDX-License-Identifier: Apache-2.0 */
/** @file Scenes of other plays into which an operator comes who follows the next step alone. */
#ifndef BORESIGHT_RECOVERY_H
#define BORESIGHT_RECOVERY_H

#include "supervise/scene.h"

#include <stdbool.h>
#include <stdint.h>

/** Plays `count` scenes from `seed` on and prints how they ended, each dead end with its seed.
 * @return none was a dead end, and every command that was asked for was accepted */
bool recovery_play(scene_t *scene, const robot_t *robot, uint32_t count, uint32_t seed);

#endif
