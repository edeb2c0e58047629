/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The workphase protocol between navigation and an MRI-guided robot (Tokuda et al.), by the port's
 * language: that of 2013, with the messages added in 2021 sent LIMIT_IGTL_EXTRA_DELAY_US later and
 * withheld when the next command arrives first, or that of 2021. One peer controls, as the
 * controller says: the first that commands what is free, until it disconnects. STOP, EMERGENCY,
 * questions and proposals are everyone's and take nothing.
 */
#ifndef BORESIGHT_WORKPHASE_DIALECT_H
#define BORESIGHT_WORKPHASE_DIALECT_H

#include "igtl/dialect/igtl_dialect.h"
#include "igtl/workphase/workphase_state.h"
#include "interface/answer.h"
#include "igtl/wire/igtl_codec.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** `first_id` numbers the commands, even. */
void workphase_dialect_init(workphase_dialect_t *self, const robot_t *robot, uint32_t first_id);

void workphase_dialect_connected(void *dialect, uint32_t peer,
                                 const igtl_introduction_t *introduction);

void workphase_dialect_disconnected(void *dialect, uint32_t peer);

/** It is the one peer that commands. */
bool workphase_dialect_is_controlled_by(const void *dialect, uint32_t peer);

/** As workphase_peer_has_order(). */
bool workphase_dialect_has_order(const void *dialect, uint32_t peer);

/**
 * A message of `peer`. Its acknowledgement is in the outbox on return.
 *
 * @satisfies SWR-IGTL-006
 * @satisfies SWR-IGTL-008
 * @satisfies SWR-IGTL-013
 * @satisfies SWR-IGTL-047
 */
void workphase_dialect_receive(void *dialect, uint32_t peer, const igtl_message_t *message,
                               const igtl_moment_t *moment);

/** An answer of the controller; false when it belongs to another. */
bool workphase_dialect_answer(workphase_dialect_t *self, const answer_t *answer,
                              const igtl_moment_t *moment);

/**
 * Time passes: deferred messages, the position stream, missing answers, what happens by itself, and
 * authority of a connection that has ended, which is released until the controller shows it.
 *
 * @satisfies SWR-AUTH-011
 * @satisfies SWR-IGTL-052
 */
void workphase_dialect_step(workphase_dialect_t *self, const igtl_moment_t *moment);

/** The controller has ended, or does not answer any more: a client that waits for the end of a
 * request is informed that there will be no answer, and the controlling peer in any case, once. */
void workphase_dialect_control_lost(workphase_dialect_t *self, const igtl_moment_t *moment);

#endif
