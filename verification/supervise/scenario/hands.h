/* SPDX-License-Identifier: Apache-2.0 */
/** @file A hand at the needle's handle, the tissue before it and the load cells, by chance: it
 * pushes, pulls, jerks, lets go, holds on like a spring and swings; cells break and are mended. */
#ifndef BORESIGHT_HANDS_H
#define BORESIGHT_HANDS_H

#include "integration/support/rig.h"

#include <stdbool.h>
#include <stdint.h>

/** At first as hands_begin() has it. */
typedef struct {
    uint32_t random;
    uint32_t wait_cycles;  /**< Until the hand does something else. */
    uint32_t swing_cycles; /**< Half of a swing; 0: it does not swing. */
    uint32_t swung_cycles; /**< Of that half. */
    int32_t um_per_s;      /**< Speed of the swing. */
    uint32_t mend_cycles;  /**< Until the cells work again; 0: they do. */
    bool is_brittle;       /**< Cells break in this scene. */
    bool is_careful;       /**< Nobody touches the handle while the sensor is zeroed. */
} hands_t;

/** The hand of the scene `seed`. */
void hands_begin(hands_t *self, uint32_t seed);

/** Sets the rig of the scene `seed`: aligned at a target, the needle out, nothing
 * zeroed, tissue in front of it. */
void hands_start(hands_t *self, rig_t *rig, const robot_t *robot, uint32_t seed);

/** One cycle. */
void hands_play(hands_t *self, rig_t *rig);

/** Lets go, and stays away for long enough to zero the sensor. */
void hands_leave(hands_t *self, rig_t *rig);

/** Nobody touches the handle, nor will while the sensor is zeroed. */
bool hands_are_away(const hands_t *self, const rig_t *rig);

#endif
