/* SPDX-License-Identifier: Apache-2.0 */
/** @file Messages to a peer of the workphase protocol, now or a little later. */
#ifndef BORESIGHT_WORKPHASE_PEER_H
#define BORESIGHT_WORKPHASE_PEER_H

#include "igtl/dialect/igtl_dialect.h"
#include "igtl/workphase/workphase_state.h"

#include <stdbool.h>
#include <stdint.h>

/** `kind`, a command_kind_t, arms a mode, and is no workphase. */
bool workphase_peer_is_motion(uint32_t kind);

/** An order of `peer` waits for the pedal or moves: START_UP, MOVE_TO_TARGET or a motion by its
 * word. */
bool workphase_peer_has_order(const workphase_dialect_t *self, uint32_t peer);

/** Acknowledges a STRING: STRING(ACK_x, text as received, cut to what is sent). `message` is named
 * ???_x. */
void workphase_peer_acknowledge_string(workphase_peer_t *self, const igtl_message_t *message,
                                       const igtl_moment_t *moment);

/** Acknowledges a TRANSFORM: TRANSFORM(ACK_x, the numbers bit by bit), where x is its name from
 * `prefix_length` on. */
void workphase_peer_acknowledge_transform(workphase_peer_t *self, const igtl_message_t *message,
                                          uint32_t prefix_length, const igtl_moment_t *moment);

/** A command of this name and text is among the last WORKPHASE_IDS. */
bool workphase_peer_is_repeated(const workphase_peer_t *self, const igtl_message_t *message);

/** Remembers a command in place of the oldest. */
workphase_id_t *workphase_peer_remember(workphase_peer_t *self, const igtl_message_t *message);

/** Forgets the command that became this request: it was not taken, and may be sent again. */
void workphase_peer_forget(workphase_peer_t *self, uint32_t request);

/** Keeps `packet` for LIMIT_IGTL_EXTRA_DELAY_US. */
void workphase_peer_defer(workphase_peer_t *self, const igtl_packet_t *packet, uint64_t now_us);

/** Keeps TRANSFORM(`name`, `pose`) for as long. */
void workphase_peer_defer_pose(workphase_peer_t *self, const char *name, const rigid_t *pose,
                               const igtl_moment_t *moment);

/** Sends what was deferred and is due; everything when `all`. */
void workphase_peer_send_deferred(workphase_peer_t *self, uint64_t now_us, bool all);

/** Forgets what was deferred. */
void workphase_peer_cancel_deferred(workphase_peer_t *self);

/**
 * Sends the needle's pose as TRANSFORM(CURRENT_POSITION), or why it is not known as a STATUS of
 * that name.
 *
 * @satisfies SWR-IGTL-014
 */
void workphase_peer_send_position(workphase_peer_t *self, const igtl_moment_t *moment);

/** Sends STATUS(CURRENT_STATUS, `code`, error name = present workphase). */
void workphase_peer_send_phase(workphase_peer_t *self, uint32_t code, uint32_t phase,
                               const char *text, const igtl_moment_t *moment);

/** Sends STATUS(`word`, WRONG_UNIT) with the form that is taken. */
void workphase_peer_send_unit(workphase_peer_t *self, const char *word, const char *form,
                              const igtl_moment_t *moment);

/** The name under which a needle's tip is reported to the peer: in 2013 STATUS(MOVE_TO_TARGET, 1)
 * states that the needle has arrived. Lives as long as the process. */
const char *workphase_peer_tip_subject(const workphase_peer_t *self);

/** Sends STRING(`name`, "1" or "0"). */
void workphase_peer_send_flag(workphase_peer_t *self, const char *name, bool value,
                              const igtl_moment_t *moment);

#endif
