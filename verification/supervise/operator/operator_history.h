/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * What was before the operator comes into a scene, by the seed of the scene.
 */
#ifndef BORESIGHT_OPERATOR_HISTORY_H
#define BORESIGHT_OPERATOR_HISTORY_H

#include "integration/support/rig.h"
#include "supervise/stage/play.h"

#include <stdint.h>

/** The play of the scene until then. */
play_t operator_history(uint32_t seed, const robot_t *robot);

/** How many cycles of it. */
uint32_t operator_history_cycles(uint32_t seed);

/** Something breaks in it; of every axis each part in turn. */
void operator_break(rig_t *rig, uint32_t seed);

#endif
