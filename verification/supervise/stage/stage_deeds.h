/* SPDX-License-Identifier: Apache-2.0 */
/** @file What the operator of a scene does: a next step, a wish, an order of the play, or anything.
 */
#ifndef BORESIGHT_STAGE_DEEDS_H
#define BORESIGHT_STAGE_DEEDS_H

#include "supervise/stage/stage.h"

/** Any command, or an act at the box. */
void stage_do_anything(stage_t *self, rig_t *rig);

/** A jog, an act for one axis, or what lets him jog. */
void stage_do_jog(stage_t *self, rig_t *rig);

/** As the next step says. */
void stage_do_next_step(stage_t *self, rig_t *rig);

/** What leads to the workphase that he wishes for. */
void stage_do_wish(stage_t *self, rig_t *rig);

/** The next order of a play of orders, or what leads to it. */
void stage_do_mode(stage_t *self, rig_t *rig);

/** @return true: he follows the next step, and not his own mind */
bool stage_does_next_step(stage_t *self, const snapshot_t *shown);

#endif
