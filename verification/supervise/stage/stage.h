/* SPDX-License-Identifier: Apache-2.0 */
/** @file An operator, a world and their faults, by chance: the same seed plays the same scene. */
#ifndef BORESIGHT_STAGE_H
#define BORESIGHT_STAGE_H

#include "integration/support/rig.h"
#include "supervise/stage/foe.h"
#include "supervise/stage/lateness.h"
#include "supervise/stage/orders.h"
#include "supervise/stage/play.h"
#include "supervise/stage/rivals.h"
#include "supervise/stage/watcher.h"

#include <stdbool.h>
#include <stdint.h>

/** State of the players. */
typedef struct {
    play_t play;
    uint32_t random;
    uint32_t wait_cycles;  /**< Until the operator does the next thing. */
    uint32_t fault_cycle;  /**< When the fault comes; UINT32_MAX: never. */
    uint32_t has_fault;    /**< 0 or 1: something was broken. */
    uint32_t wants_target; /**< 0 or 1: the last target was reached, the next is to be sent. */
    uint32_t is_chaotic;   /**< 1: the operator does anything at any time. */
    uint32_t cycle;
    uint32_t whim; /**< Of the operator: a chance of its own. */
    watcher_t watcher;
    orders_t orders;
    uint32_t wish;        /**< workphase_t of PLAY_MODES' next order. */
    uint32_t gate_cycles; /**< Of PLAY_PROGRAMS: until the gate changes. */
    uint32_t is_brittle;  /**< 0 or 1: of a play with a theme; in motion something may break. */
    foe_t foe;            /**< Of PLAY_TAPS. */
    rivals_t rivals;      /**< Of PLAY_RIVALS. */
    lateness_t lateness;  /**< Of PLAY_LATE. */
    const robot_t *robot;
    robot_t magnitude_robot; /**< Of PLAY_MAGNITUDE. */
} stage_t;

/** Sets the scene `seed` of `robot`, which must outlive the rig: the rig fresh, homed or targeted,
 * an operator and what may break. */
void stage_begin(stage_t *self, rig_t *rig, const robot_t *robot, play_t play, uint32_t seed);

/** A fault was or is in the scene, or time is. */
bool stage_is_disturbed(const stage_t *self);

/** Nothing of an axis was broken. */
bool stage_is_sound(const stage_t *self);

/** What the players do before the next cycle. */
void stage_play(stage_t *self, rig_t *rig);

#endif
