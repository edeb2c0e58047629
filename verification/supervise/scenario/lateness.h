/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * An enemy who owns time and the wires: cycles come late and the next ones at once, exchanges come
 * apart from them, the box stands, commands and reports are damaged. Nothing of an axis is broken
 * by it. The scenario owns one.
 */
#ifndef BORESIGHT_LATENESS_H
#define BORESIGHT_LATENESS_H

#include "integration/support/rig.h"
#include "sim/model/sim_random.h"

#include <stdint.h>

/** State of the enemy. Each `parts` is one in so many cycles; 0: never. */
typedef struct {
    sim_random_t random;
    uint32_t late_parts;
    uint32_t late_us;    /**< A cycle is late by so much at most. */
    uint32_t late_burst; /**< So many in a row at most. */
    uint32_t late_left;  /**< Left of this burst. */
    uint32_t hold_parts;
    uint32_t hold_cycles; /**< The box stands for so many at most. */
    uint32_t refuse_parts;
} lateness_t;

/** Makes a plan for the scene `seed`. */
void lateness_begin(lateness_t *self, rig_t *rig, uint32_t seed);

/** Before each cycle. */
void lateness_play(lateness_t *self, rig_t *rig);

#endif
