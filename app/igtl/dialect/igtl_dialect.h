/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The common part of the two dialects: peers by their places, one moment at a time. A dialect is
 * called by the server with each message and with the time; it puts answers into the peers'
 * outboxes and commands into its requests.
 */
#ifndef BORESIGHT_IGTL_DIALECT_H
#define BORESIGHT_IGTL_DIALECT_H

#include "igtl/wire/igtl_codec.h"
#include "igtl/dialect/igtl_requests.h"
#include "igtl/wire/igtl_outbox.h"
#include "interface/answer.h"
#include "interface/app/igtl_codes.h"
#include "interface/command.h"
#include "interface/snapshot.h"

#include <stdbool.h>
#include <stdint.h>

#define IGTL_PORTS 4U                        /**< Ports, those that call included. */
#define IGTL_PEERS 8U                        /**< Connections per port. */
#define IGTL_SLOTS (IGTL_PORTS * IGTL_PEERS) /**< Total; a dialect may serve several ports. */
#define IGTL_STREAM_US UINT64_C(100000)      /**< Between two poses of a stream. */

#if IGTL_REQUESTS_URGENT != (IGTL_SLOTS * IGTL_REQUESTS_PER_PEER)
#error "STOP finds a slot before every other message."
#endif

/** The language of a port. */
typedef enum {
    IGTL_LANGUAGE_BRP_2013 = 0, /**< Workphases; what 2021 added comes a little later. */
    IGTL_LANGUAGE_BRP_2021 = 1, /**< Workphases as of 2021. */
    IGTL_LANGUAGE_CRTK = 2      /**< Bare transforms, names of CRTK. */
} igtl_language_t;

/** A peer that connects. */
typedef struct {
    uint32_t number; /**< Number of the connection, never used again. */
    igtl_language_t language;
    const char *entry_prefix; /**< Names of entry points begin so. Lives as long as the process. */
    igtl_outbox_t *outbox;
} igtl_introduction_t;

/** The moment in which something happens. */
typedef struct {
    uint64_t now_us;            /**< Monotonic. */
    uint64_t answer_clock_us;   /**< By which timeouts of answers run; see igtl_timeout_clock.h. */
    uint64_t timestamp;         /**< For outgoing messages, units of 2^-32 s since 1970. */
    const snapshot_t *snapshot; /**< The newest; NULL: none yet, or control is silent. */
    const char *holder;         /**< Title of the client that has authority by that; NULL: none. */
} igtl_moment_t;

#define IGTL_REASON_SIZE (IGTL_TEXT_MAX + 1U)

/**
 * "NAME: sentence" with the axis and limit, of an answer that is not a plain success; its code is
 * igtl_reason_code(). Without authority the sentence names its holder and the duration.
 *
 * @satisfies SWR-IGTL-055
 */
void igtl_reason_text(const robot_t *robot, const answer_t *answer, const igtl_moment_t *moment,
                      char text[IGTL_REASON_SIZE]);

/** Sends STATUS(`name`, ...) to a peer. */
void igtl_send_status(igtl_outbox_t *outbox, const char *name, const igtl_status_t *status,
                      const igtl_moment_t *moment);

/** The same of a message that is refused, which is kept for the log. */
void igtl_send_refused(igtl_outbox_t *outbox, const char *name, const igtl_status_t *status,
                       const igtl_moment_t *moment);

/** Sends STATUS(`name`, code and sentence of `status`), as of a refused message. */
void igtl_send_refusal(igtl_outbox_t *outbox, const char *name, status_t status,
                       const igtl_moment_t *moment);

/** Sends STATUS(`name`, NOT_FOUND): there is nothing of this name. */
void igtl_send_not_found(igtl_outbox_t *outbox, const char *name, const igtl_moment_t *moment);

/** The STRING `message` is `text`, no more and no less. */
bool igtl_is_text(const igtl_message_t *message, const char *text);

/** Makes TRANSFORM(`name`, `pose`). */
void igtl_pack_pose(igtl_packet_t *packet, const char *name, const rigid_t *pose,
                    const igtl_moment_t *moment);

/** Sends TRANSFORM(`name`, `pose`). */
void igtl_send_pose(igtl_outbox_t *outbox, const char *name, const rigid_t *pose,
                    const igtl_moment_t *moment);

/** STATUS_OK while the needle's measured pose is known in scanner coordinates; otherwise why not.
 */
status_t igtl_pose_status(const igtl_moment_t *moment);

/** An axis moves, or what is armed runs under the pedal. */
bool igtl_is_moving(const igtl_moment_t *moment);

#endif
