/* SPDX-License-Identifier: Apache-2.0 */
/** @file What commands do with the treatment program that is held. */
#ifndef BORESIGHT_CONTROLLER_PROGRAM_H
#define BORESIGHT_CONTROLLER_PROGRAM_H

#include "controller/controller_events.h"

/**
 * Begins the list, or empties it.
 *
 * @return STATUS_OK; STATUS_WRONG_WORKPHASE out of TARGETING and MOVE_TO_TARGET;
 * STATUS_MOTION_ARMED while something is armed; STATUS_NO_TARGET; otherwise as
 * mode/lists/program_list.h says
 *
 * @satisfies SWR-PROG-010
 */
status_t controller_obey_program_begin(controller_t *self, const cycle_t *cycle,
                                       const command_t *command, answer_t *answer);

/**
 * Adds a step to the list.
 *
 * @return as controller_obey_program_begin(), with axis and end of the limit in `answer`
 *
 * @satisfies SWR-PROG-010
 */
status_t controller_obey_program_step(controller_t *self, const cycle_t *cycle,
                                      const command_t *command, answer_t *answer);

/**
 * Ends the list.
 *
 * @return as controller_obey_program_begin(), with the checksum in `answer`
 *
 * @satisfies SWR-PROG-010
 */
status_t controller_obey_program_end(controller_t *self, const cycle_t *cycle,
                                     const command_t *command, answer_t *answer);

/**
 * May the list with checksum `crc` be armed for `target`? @return as program_mode_judge()
 *
 * @satisfies SWR-PROG-011
 */
solution_t controller_judge_program(const controller_t *self, const cycle_t *cycle, uint32_t crc,
                                    const move_mode_t *target);

#endif
