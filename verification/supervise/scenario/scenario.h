/* SPDX-License-Identifier: Apache-2.0 */
/** @file An operator, a world and their faults, by chance: the same seed plays the same scene. */
#ifndef BORESIGHT_SCENARIO_H
#define BORESIGHT_SCENARIO_H

#include "integration/support/rig.h"
#include "supervise/scenario/adversary.h"
#include "supervise/scenario/hands.h"
#include "supervise/scenario/lateness.h"
#include "supervise/scenario/orders.h"
#include "supervise/scenario/play.h"
#include "supervise/scenario/competing_peers.h"
#include "supervise/scenario/watcher.h"

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
    uint32_t whim; /**< Whim of the operator: a chance of its own. */
    watcher_t watcher;
    orders_t orders;
    uint32_t wish;            /**< workphase_t of PLAY_MODES' next order. */
    uint32_t gate_cycles;     /**< In PLAY_PROGRAMS: until the gate changes. */
    uint32_t is_brittle;      /**< 0 or 1: of a play with a theme; in motion something may break. */
    adversary_t adversary;    /**< Enemy of PLAY_TAPS. */
    competing_peers_t rivals; /**< Peers of PLAY_RIVALS. */
    lateness_t lateness;      /**< Enemy of PLAY_LATE. */
    hands_t hands;            /**< Hand of PLAY_HANDS. */
    const robot_t *robot;
    robot_t magnitude_robot; /**< Robot of PLAY_MAGNITUDE. */
} scenario_t;

/** Sets the scene `seed` of `robot`, which must outlive the rig: the rig fresh, homed or targeted,
 * an operator and what may break. */
void scenario_begin(scenario_t *self, rig_t *rig, const robot_t *robot, play_t play, uint32_t seed);

/** A fault was or is in the scene, or time is. */
bool scenario_is_disturbed(const scenario_t *self);

/** Nothing of an axis was broken. */
bool scenario_is_sound(const scenario_t *self);

/** Acts of the players before the next cycle. */
void scenario_play(scenario_t *self, rig_t *rig);

#endif
