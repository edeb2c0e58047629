/* SPDX-License-Identifier: Apache-2.0 */
/** @file The word by which a client commands speeds: `VELOCITY <axis> <speed> ... <seconds>`, in
 * mm/s or degrees/s. */
#ifndef BORESIGHT_WORKPHASE_VELOCITY_H
#define BORESIGHT_WORKPHASE_VELOCITY_H

#include "interface/command.h"
#include "message/igtl_codec.h"
#include "robot/robot.h"

#include <stdbool.h>

#define WORKPHASE_VELOCITY "VELOCITY"

/** The text begins with this word. */
bool workphase_velocity_is(const igtl_message_t *message);

/**
 * The command that the text means; what may be so fast, the controller judges.
 *
 * @return STATUS_OK; STATUS_UNKNOWN_COMMAND for a text that is none, or an axis that the robot does
 * not have; STATUS_OUT_OF_RANGE for a number that is none or is too large, or an axis that comes
 * twice
 *
 * @satisfies SWR-VEL-014
 */
status_t workphase_velocity_read(const robot_t *robot, const igtl_message_t *message,
                                 command_t *command);

#endif
