/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * History of a scene before the operator comes into it, by the seed of the scene.
 */
#ifndef BORESIGHT_OPERATOR_HISTORY_H
#define BORESIGHT_OPERATOR_HISTORY_H

#include "integration/support/rig.h"
#include "supervise/scenario/play.h"

#include <stdbool.h>
#include <stdint.h>

/** The play of the scene until then. */
play_t operator_history(uint32_t seed, const robot_t *robot);

/** How many cycles of it. */
uint32_t operator_history_cycles(uint32_t seed);

/** Something breaks in it; of every axis each part in turn. */
void operator_break(rig_t *rig, uint32_t seed);

/** State that others have left: something pressed, pulled, unplugged or not read, a scan
 * that goes on, with an axis that has drifted in it or without, a full disk. */
void operator_leave(rig_t *rig, uint32_t *chance);

/** The plug of the cards is out. */
bool operator_is_unplugged(const rig_t *rig);

#endif
