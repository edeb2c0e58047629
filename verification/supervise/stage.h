/* SPDX-License-Identifier: Apache-2.0 */
/** @file An operator, a world and their faults, by chance: the same seed plays the same scene. */
#ifndef BORESIGHT_STAGE_H
#define BORESIGHT_STAGE_H

#include "rig.h"

#include <stdint.h>

/** State of the players. */
typedef struct {
    uint32_t random;
    uint32_t wait_cycles; /**< Until the operator does the next thing. */
    uint32_t fault_cycle; /**< When the fault comes; UINT32_MAX: never. */
    uint32_t is_chaotic;  /**< 1: the operator does anything at any time. */
    uint32_t cycle;
} stage_t;

/** Sets the scene `seed`: the rig fresh, homed or targeted, an operator and at most one fault. */
void stage_begin(stage_t *self, rig_t *rig, uint32_t seed);

/** What the players do before the next cycle. */
void stage_play(stage_t *self, rig_t *rig);

#endif
