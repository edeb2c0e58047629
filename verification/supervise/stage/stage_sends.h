/* SPDX-License-Identifier: Apache-2.0 */
/** @file The commands that the operator of a scene sends, each with what it is about. */
#ifndef BORESIGHT_STAGE_SENDS_H
#define BORESIGHT_STAGE_SENDS_H

#include "supervise/stage/chance.h"
#include "supervise/stage/stage.h"

/** A chance of the scene, below `bound`. */
static inline uint32_t stage_random_below(stage_t *self, uint32_t bound)
{
    return chance_below(&self->random, bound);
}

/** A whim of the operator, in one of so many cases. */
static inline bool stage_has_whim(stage_t *self, uint32_t bound)
{
    return chance_below(&self->whim, bound) == 0U;
}

/** Sends `command` in this cycle, signed by who commands. */
void stage_send(stage_t *self, rig_t *rig, command_t command);

/** Sends the workphase `phase`. */
void stage_send_phase(stage_t *self, rig_t *rig, workphase_t phase);

/** A target of the play. */
rigid_t stage_some_target(stage_t *self);

/** Sends a target of the play. */
void stage_send_target(stage_t *self, rig_t *rig);

/** Sends a jog of any axis. */
void stage_send_jog(stage_t *self, rig_t *rig);

/** Sends an act for one axis; who has asked for a press gives it. */
void stage_send_act(stage_t *self, rig_t *rig);

/** Sends the lengths of another probe. */
void stage_send_probe(stage_t *self, rig_t *rig);

/** Sends an order of a mode; WORKPHASE_COUNT: wherever he is. */
void stage_send_order(stage_t *self, rig_t *rig, workphase_t phase);

/** @return true: he wants the needle out */
bool stage_wants_out(stage_t *self, const snapshot_t *shown);

/** Sends positions that somebody has saved. */
void stage_send_saved(stage_t *self, rig_t *rig);

#endif
