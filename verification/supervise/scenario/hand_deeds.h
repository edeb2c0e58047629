/* SPDX-License-Identifier: Apache-2.0 */
/** @file Deeds of an operator who inserts by hand, and of the next steps for it. */
#ifndef BORESIGHT_HAND_DEEDS_H
#define BORESIGHT_HAND_DEEDS_H

#include "supervise/scenario/scenario.h"

/** In PLAY_HANDS: zeroes, lines up, commands COOPERATE, works the pedal, and changes its mind. */
void hand_deeds_do_order(scenario_t *self, rig_t *rig);

/** One of the next steps PUSH, LET_GO and ZERO_FORCE. */
void hand_deeds_do_step(scenario_t *self, rig_t *rig);

#endif
