/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * One listening port and its connections. Reads and writes without waiting, hands whole messages to
 * its dialect, drops who breaks the protocol and leaves everyone else alone.
 */
#ifndef BORESIGHT_IGTL_SERVER_H
#define BORESIGHT_IGTL_SERVER_H

#include "igtl/igtl_connection.h"
#include "dialect/igtl_dialect.h"

#include <poll.h>
#include <stdbool.h>
#include <stdint.h>

#define IGTL_SERVER_POLLS (IGTL_PEERS + 1U)
#define IGTL_NUMBER_STEP 2U               /**< Numbers of the two ports' connections interleave. */
#define IGTL_BYTES_PER_TURN 65536U        /**< Read of one connection per turn. */
#define IGTL_SILENT_US UINT64_C(10000000) /**< Who is silent for longer may lose its place. */

/** What a dialect does for a server; `dialect` is its own state, `peer` a place. */
typedef struct {
    void (*connected)(void *dialect, uint32_t peer, const igtl_introduction_t *introduction);
    void (*disconnected)(void *dialect, uint32_t peer);
    void (*receive)(void *dialect, uint32_t peer, const igtl_message_t *message,
                    const igtl_moment_t *moment);
    bool (*is_controlled_by)(const void *dialect, uint32_t peer); /**< NULL: by nobody. */
} igtl_dialect_calls_t;

/** Why peers were not served, counted. */
typedef enum {
    IGTL_TROUBLE_FULL = 0,    /**< Refused: all connections are taken. */
    IGTL_TROUBLE_BROKEN = 1,  /**< Dropped: it does not speak the protocol. */
    IGTL_TROUBLE_LATE = 2,    /**< Dropped: a message stayed incomplete. */
    IGTL_TROUBLE_SLOW = 3,    /**< Dropped: it does not read what it is sent. */
    IGTL_TROUBLE_MESSAGE = 4, /**< A message was refused. */
    IGTL_TROUBLE_SILENT = 5   /**< Dropped: it was silent, and another wanted its place. */
} igtl_trouble_t;

#define IGTL_TROUBLES 6U

typedef struct {
    uint64_t count;
    uint64_t said;        /**< Of these, in the log. */
    uint64_t next_log_us; /**< Not before this time again. */
} igtl_trouble_count_t;

typedef struct {
    const igtl_dialect_calls_t *calls;
    void *dialect;
    uint32_t first_place; /**< Of the dialect: its connections are peers from here on. */
    igtl_language_t language;
    uint16_t port;
    int listener;
    uint32_t next_number;      /**< Of the next connection. */
    uint64_t next_greeting_us; /**< Not before this time its number is in the log. */
    igtl_connection_t connections[IGTL_PEERS];
    igtl_trouble_count_t troubles[IGTL_TROUBLES];
} igtl_server_t;

/**
 * Listens on `address`:`port`. Connections are numbered from `next_number` (set before, not 0); a
 * new one is a line on stderr with its address, at most one in a second.
 *
 * @return false with one sentence in `error` and the cause in errno
 */
bool igtl_server_open(igtl_server_t *self, const char *address, uint16_t port, char *error,
                      size_t error_size);

/** Closes the port and all connections. */
void igtl_server_close(igtl_server_t *self);

/** What to wait for. `polls` has room for IGTL_SERVER_POLLS; returns how many were filled. */
uint32_t igtl_server_polls(const igtl_server_t *self, struct pollfd *polls);

/** Anyone connected. */
bool igtl_server_has_peers(const igtl_server_t *self);

/**
 * Accepts, reads, and drops whoever stays in the middle of a message. At most a few messages per
 * connection and at most IGTL_BYTES_PER_TURN, so that nobody is kept waiting by another. When all
 * places are taken, a new connection gets the place of the one that has sent no valid message for
 * longest, if for longer than IGTL_SILENT_US and it does not control.
 *
 * @satisfies SWR-IGTL-011
 */
void igtl_server_receive(igtl_server_t *self, const igtl_moment_t *moment);

/** Sends what the dialect has put into the outboxes. */
void igtl_server_send(igtl_server_t *self, const igtl_moment_t *moment);

#endif
