/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * What the two dialects share: up to eight peers, one moment at a time. A dialect is called by the
 * server with what arrived and with the time; it puts answers into the peers' outboxes and commands
 * into its requests.
 */
#ifndef BORESIGHT_IGTL_DIALECT_H
#define BORESIGHT_IGTL_DIALECT_H

#include "igtl/igtl_codec.h"
#include "igtl/igtl_requests.h"
#include "igtl/igtl_outbox.h"
#include "interface/answer.h"
#include "interface/command.h"
#include "interface/snapshot.h"

#include <stdbool.h>
#include <stdint.h>

#define IGTL_PEERS 8U                   /**< Connections per port. */
#define IGTL_STREAM_US UINT64_C(100000) /**< Between two poses of a stream. */

/** The moment in which something happens. */
typedef struct {
    uint64_t now_us;            /**< Monotonic. */
    uint64_t patience_us;       /**< Of those who wait for control; see igtl_main.c. */
    uint64_t timestamp;         /**< For outgoing messages, units of 2^-32 s since 1970. */
    const snapshot_t *snapshot; /**< The newest; NULL before the first. */
} igtl_moment_t;

/** Code, and "NAME: sentence" with the axis and limit, of an answer that is not a plain success. */
#define IGTL_REASON_SIZE (IGTL_TEXT_MAX + 1U)
uint32_t igtl_reason_code(status_t status);
void igtl_reason_text(const robot_t *robot, const answer_t *answer, char text[IGTL_REASON_SIZE]);

/** Sends STATUS(`name`, ...) to a peer. */
void igtl_tell_status(igtl_outbox_t *outbox, const char *name, const igtl_status_t *status,
                      const igtl_moment_t *moment);

/** Sends STATUS(`name`, code and sentence of `status`). */
void igtl_tell_refusal(igtl_outbox_t *outbox, const char *name, status_t status,
                       const igtl_moment_t *moment);

/** Sends TRANSFORM(`name`, `pose`). */
void igtl_tell_pose(igtl_outbox_t *outbox, const char *name, const rigid_t *pose,
                    const igtl_moment_t *moment);

/** STATUS_OK while the needle's measured pose is known in scanner coordinates; otherwise why not.
 */
status_t igtl_pose_status(const igtl_moment_t *moment);

/** An axis moves, or what is armed runs under the pedal. */
bool igtl_is_moving(const igtl_moment_t *moment);

#endif
