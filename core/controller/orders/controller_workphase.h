/* SPDX-License-Identifier: Apache-2.0 */
/** @file The command that changes the workphase, and the faults that START_UP clears. */
#ifndef BORESIGHT_CONTROLLER_WORKPHASE_H
#define BORESIGHT_CONTROLLER_WORKPHASE_H

#include "controller/controller_events.h"

/** Clears what was latched: START_UP is the operator's act for it. */
void controller_begin_start_up(controller_t *self, const cycle_t *cycle);

/**
 * START_UP is not refused for want of a recording any more.
 *
 * @return STATUS_OK; STATUS_BLACK_BOX_THERE while it is not refused for that
 *
 * @satisfies SWR-CMD-006
 */
status_t controller_obey_no_box(controller_t *self, const cycle_t *cycle, const command_t *command,
                                answer_t *answer);

/** The workphase changes, and arms the mode of its own. @return STATUS_OK, or why it does not. */
status_t controller_obey_workphase(controller_t *self, const cycle_t *cycle,
                                   const command_t *command, answer_t *answer);

#endif
