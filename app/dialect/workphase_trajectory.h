/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The words by which a client sends a trajectory, each row as the thesis has it, and has it run:
 * `TRAJECTORY BEGIN <rows>`, `TRAJECTORY ROW <index> <ms> <ticks of each axis> <ticks/s of each
 * axis>` with the index from 0 on, `TRAJECTORY END`, `TRAJECTORY RUN`.
 */
#ifndef BORESIGHT_WORKPHASE_TRAJECTORY_H
#define BORESIGHT_WORKPHASE_TRAJECTORY_H

#include "interface/command.h"
#include "message/igtl_codec.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

#define WORKPHASE_TRAJECTORY "TRAJECTORY"

/** The text begins with this word. */
bool workphase_trajectory_is(const igtl_message_t *message);

/**
 * The command that the text means; what may be driven, the controller judges. `sum`: checksum of
 * the rows that this client has sent, by which END and RUN name its list.
 *
 * @return STATUS_OK; STATUS_UNKNOWN_COMMAND for a text that is none; STATUS_OUT_OF_RANGE for a
 * number that is none or too large, or one too few or too many
 *
 * @satisfies SWR-TRAJ-019
 */
status_t workphase_trajectory_read(const robot_t *robot, const igtl_message_t *message,
                                   uint32_t sum, command_t *command);

/** Checksum of what the client has sent once `command` is on its way. */
uint32_t workphase_trajectory_sum(uint32_t sum, const command_t *command);

#endif
