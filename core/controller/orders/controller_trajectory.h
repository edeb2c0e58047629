/* SPDX-License-Identifier: Apache-2.0 */
/** @file What commands do with the trajectory that is held. */
#ifndef BORESIGHT_CONTROLLER_TRAJECTORY_H
#define BORESIGHT_CONTROLLER_TRAJECTORY_H

#include "controller/controller_events.h"

/**
 * Begins the list, or empties it.
 *
 * @return STATUS_OK; STATUS_WRONG_WORKPHASE out of MANUAL; STATUS_NOT_AT_REST while something is
 * armed; otherwise as mode/lists/trajectory_list.h says
 *
 * @satisfies SWR-TRAJ-013
 */
status_t controller_obey_list_begin(controller_t *self, const cycle_t *cycle,
                                    const command_t *command, answer_t *answer);

/**
 * Adds a row to the list.
 *
 * @return as controller_obey_list_begin(), with axis and end of the limit in `answer`
 *
 * @satisfies SWR-TRAJ-013
 */
status_t controller_obey_list_row(controller_t *self, const cycle_t *cycle,
                                  const command_t *command, answer_t *answer);

/**
 * Ends the list.
 *
 * @return as controller_obey_list_begin(), with the checksum in `answer`
 *
 * @satisfies SWR-TRAJ-013
 */
status_t controller_obey_list_end(controller_t *self, const cycle_t *cycle,
                                  const command_t *command, answer_t *answer);

/**
 * May the list with checksum `crc` be armed? @return as trajectory_mode_judge()
 *
 * @satisfies SWR-TRAJ-014
 */
solution_t controller_judge_trajectory(const controller_t *self, const cycle_t *cycle,
                                       uint32_t crc);

#endif
