/* SPDX-License-Identifier: Apache-2.0 */
/** @file The armed order in a cycle. */
#ifndef BORESIGHT_CONTROLLER_MOVE_H
#define BORESIGHT_CONTROLLER_MOVE_H

#include "controller/controller_events.h"

/**
 * The armed order in a cycle: pedal edges, its mode, its end. A hand that is not trusted ends what
 * it was to move. `result` receives what the mode asks for.
 *
 * @satisfies SWR-COOP-006
 */
void controller_move(controller_t *self, const cycle_t *cycle, mode_result_t *result);

#endif
