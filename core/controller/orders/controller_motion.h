/* SPDX-License-Identifier: Apache-2.0 */
/** @file Commands that arm a motion of their own: a row of core/interface/modes.yml for each. */
#ifndef BORESIGHT_CONTROLLER_MOTION_H
#define BORESIGHT_CONTROLLER_MOTION_H

#include "controller/controller_events.h"

/**
 * A command that arms a mode (mode_of_command()): whatever is armed gives way to it. `answer` is
 * not final if it is accepted, and has axis and limit if a limit refuses it.
 *
 * @return STATUS_OK; as controller_aim() and mode_judge(); STATUS_FORCE_DOUBTFUL;
 * STATUS_WRONG_WORKPHASE, STATUS_FAULT_PRESENT, STATUS_NOT_HOMED in this order, and then nothing
 * has changed, but that the refusal of a mode in which a hand moves the needle discards in
 * MOVE_TO_TARGET what is armed
 *
 * @satisfies SWR-COOP-014
 * @satisfies SWR-AXIS-035
 * @satisfies SWR-ALIGN-001
 * @satisfies SWR-FLOW-006
 * @satisfies SWR-MODE-001
 * @satisfies SWR-MODE-002
 * @satisfies SWR-MODE-007
 */
status_t controller_obey_motion(controller_t *self, const cycle_t *cycle, const command_t *command,
                                answer_t *answer);

#endif
