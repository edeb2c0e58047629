/* SPDX-License-Identifier: Apache-2.0 */
/** @file The commands that the operator of a scene sends, each with what it is about. */
#ifndef BORESIGHT_SCENARIO_SENDS_H
#define BORESIGHT_SCENARIO_SENDS_H

#include "supervise/scenario/prng.h"
#include "supervise/scenario/scenario.h"

/** A chance of the scene, below `bound`. */
static inline uint32_t scenario_random_below(scenario_t *self, uint32_t bound)
{
    return prng_below(&self->random, bound);
}

/** A whim of the operator, in one of so many cases. */
static inline bool scenario_has_whim(scenario_t *self, uint32_t bound)
{
    return prng_below(&self->whim, bound) == 0U;
}

/** Sends `command` in this cycle, signed by the holder of authority. */
void scenario_send(scenario_t *self, rig_t *rig, command_t command);

/** Sends the workphase `phase`. */
void scenario_send_phase(scenario_t *self, rig_t *rig, workphase_t phase);

/** A target of the play. */
rigid_t scenario_some_target(scenario_t *self);

/** Sends a target of the play. */
void scenario_send_target(scenario_t *self, rig_t *rig);

/** Sends a jog of any axis. */
void scenario_send_jog(scenario_t *self, rig_t *rig);

/** Sends an act for one axis; its sender gives a requested press. */
void scenario_send_act(scenario_t *self, rig_t *rig);

/** Sends the lengths of another probe. */
void scenario_send_probe(scenario_t *self, rig_t *rig);

/** Sends an order of a mode; WORKPHASE_COUNT: wherever he is. */
void scenario_send_order(scenario_t *self, rig_t *rig, workphase_t phase);

/** @return true: he wants the needle out */
bool scenario_wants_out(scenario_t *self, const snapshot_t *shown);

/** Sends positions that an operator has saved. */
void scenario_send_saved(scenario_t *self, rig_t *rig);

#endif
