/* SPDX-License-Identifier: Apache-2.0 */
#ifndef BORESIGHT_EVA_STATE_H
#define BORESIGHT_EVA_STATE_H

#include "controller/controller.h"

/** Gives the members of a state that has begun the values that they may have after any number of
 * cycles. */
void age_state(controller_t *state);

#endif
