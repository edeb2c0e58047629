/* SPDX-License-Identifier: Apache-2.0 */
/** @file The length of the needle, which clients say and the robot's description holds. */
#ifndef BORESIGHT_WORKPHASE_NEEDLE_H
#define BORESIGHT_WORKPHASE_NEEDLE_H

#include "igtl/dialect/igtl_dialect.h"
#include "igtl/workphase/workphase_state.h"
#include "robot/robot.h"

/**
 * Answers STRING(NEEDLE_LENGTH, mm as text): STRING(ACK_NEEDLE_LENGTH, the text), then
 * STATUS(NEEDLE_LENGTH): OK when it is that of the robot's needle within LIMIT_NEEDLE_LENGTH_NM,
 * CONFIG_ERROR with the length that the robot is set to, UNKNOWN_INSTRUCTION of a robot whose
 * description has none. Nothing is changed by it.
 *
 * @satisfies SWR-IGTL-036
 */
void workphase_needle_send_length(workphase_peer_t *peer, const robot_t *robot,
                                  const igtl_message_t *message, const igtl_moment_t *moment);

#endif
