/* SPDX-License-Identifier: Apache-2.0 */
/** @file One TCP connection: non-blocking, messages in and out, a dead peer is noticed. */
#ifndef BORESIGHT_IGTL_CONNECTION_H
#define BORESIGHT_IGTL_CONNECTION_H

#include "exchange/exchange_peers.h"
#include "igtl/wire/igtl_codec.h"
#include "igtl/wire/igtl_inbox.h"
#include "igtl/wire/igtl_outbox.h"

#include <stdbool.h>
#include <stdint.h>

#define IGTL_NO_PLACE UINT32_MAX

typedef struct {
    int descriptor;             /**< -1: free. */
    uint32_t number;            /**< Given by the server, never used again. */
    uint32_t place;             /**< Place in the server, IGTL_NO_PLACE while it waits for one. */
    uint32_t address;           /**< Address of the peer, IPv4, in the byte order of the host... */
    uint16_t port;              /**< ... and its port. Both are the server's to set. */
    bool is_kept_alive;         /**< The peer's machine is asked whether it is still there. */
    uint64_t since_us;          /**< When it connected. */
    uint64_t heard_us;          /**< When it connected or last sent a valid message. */
    bool was_heard;             /**< It has sent a valid message. */
    char heard[IGTL_NAME_SIZE]; /**< Name of the last one. */
    char status[EXCHANGE_PEER_STATUS_SIZE]; /**< Its last STATUS in words; "": none. */
    uint32_t statuses;                      /**< Number of changes of `status`. */
    char refusal[IGTL_OUTBOX_REFUSAL];      /**< Text of its last refusal; "": none. */
    uint32_t refusals;                      /**< Number of changes of `refusal`. */
    uint64_t messages_in;                   /**< Valid ones. */
    uint64_t messages_out;
    uint64_t received;     /**< Bytes that were read. */
    uint32_t errors;       /**< Messages that were refused before their content was looked at. */
    uint64_t sent;         /**< Bytes that were written. */
    uint64_t acknowledged; /**< Those of them that the peer's machine has taken. */
    uint64_t moved_us;     /**< When that last became more; 0: it is not watched. */
    igtl_inbox_t inbox;
    uint8_t large[LIMIT_IGTL_ARRAY_MAX]; /**< Lent to it; memory of the machine only once used. */
    igtl_outbox_t outbox;
} igtl_connection_t;

typedef enum {
    IGTL_RECEIVED_NOTHING = 0, /**< No more for now. */
    IGTL_RECEIVED_EVENT = 1,   /**< `event` says what. */
    IGTL_RECEIVED_END = 2      /**< The peer has closed, or is gone. */
} igtl_received_t;

/** Not connected. */
void igtl_connection_init(igtl_connection_t *self);

/** Takes over a connected socket: non-blocking, without delay, with keepalive. */
void igtl_connection_open(igtl_connection_t *self, int descriptor, uint64_t now_us);

void igtl_connection_close(igtl_connection_t *self);

/**
 * Whether the peer's machine is asked, while nothing comes, if it is still there; so it is from the
 * start.
 *
 * @satisfies SWR-IGTL-057
 */
void igtl_connection_keep_alive(igtl_connection_t *self, bool is_on);

/**
 * Reads until something can be said of a message, but no more than `*bytes_left`, which becomes
 * less by what was read.
 *
 * @satisfies SWR-IGTL-011
 */
igtl_received_t igtl_connection_receive(igtl_connection_t *self, uint64_t now_us,
                                        uint32_t *bytes_left, igtl_inbox_event_t *event);

/**
 * Sends what the outbox holds, each message in one write, as far as the peer takes it.
 *
 * @return false when the peer is gone or so slow that a message found no room
 *
 * @satisfies SWR-IGTL-005
 */
bool igtl_connection_flush(igtl_connection_t *self);

/**
 * Time for which sent bytes have stayed without any acknowledgement by the peer's machine, us; 0 at
 * the first call, and while nothing waits. A program that has stopped is seen once its machine
 * takes no more for it.
 *
 * @satisfies SWR-IGTL-027
 */
uint64_t igtl_connection_unread_us(igtl_connection_t *self, uint64_t now_us);

/**
 * Keeps what the STATUS `message` says: device name, code, error name and text, with `?` for what
 * is not printable.
 *
 * @satisfies SWR-IGTL-092
 */
void igtl_connection_keep_status(igtl_connection_t *self, const igtl_message_t *message);

/**
 * Keeps what the outbox has noted as refused of the message that was just received, if anything.
 *
 * @satisfies SWR-IGTL-093
 */
void igtl_connection_keep_refusal(igtl_connection_t *self);

/** Ends the watch over the bytes that it acknowledges. */
void igtl_connection_unwatch(igtl_connection_t *self);

#endif
