/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Random bit flips: a scene is played, and every now and then it goes on in a process of its own in
 * which 1 to 3 random bits of one random word of the controller's state or of its table of the
 * robot have changed.
 */
#ifndef BORESIGHT_FLIPS_H
#define BORESIGHT_FLIPS_H

#include "supervise/scene.h"

#include <stdbool.h>
#include <stdint.h>

/**
 * Makes `count` flips in scenes of `robot` from `seed` on and prints how many were noticed,
 * harmless, wrong.
 *
 * @return true when none was wrong
 */
bool flips_play(scene_t *scene, const robot_t *robot, uint32_t count, uint32_t seed);

#endif
