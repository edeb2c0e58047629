/* SPDX-License-Identifier: Apache-2.0 */
/** @file What the operator of a scene does: a next step, a wish, an order of the play, or anything.
 */
#ifndef BORESIGHT_SCENARIO_DEEDS_H
#define BORESIGHT_SCENARIO_DEEDS_H

#include "supervise/scenario/scenario.h"

/** Any command, or an act at the box. */
void scenario_do_anything(scenario_t *self, rig_t *rig);

/** A jog, an act for one axis, or what lets him jog. */
void scenario_do_jog(scenario_t *self, rig_t *rig);

/** As the next step says. */
void scenario_do_next_step(scenario_t *self, rig_t *rig);

/** The command that leads to the workphase that he wishes for. */
void scenario_do_wish(scenario_t *self, rig_t *rig);

/** The next order of a play of orders, or what leads to it. */
void scenario_do_mode(scenario_t *self, rig_t *rig);

/** @return true: he follows the next step, and not his own mind */
bool scenario_does_next_step(scenario_t *self, const snapshot_t *shown);

#endif
