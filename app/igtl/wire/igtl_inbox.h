/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Puts the bytes of one connection together to messages. Nothing of a message is ever thrown away
 * because it is slow; only where it is not known where the next message begins, the connection
 * ends. A body that is of no use passes in pieces of the buffer's size. No I/O, no clock, no
 * allocation.
 */
#ifndef BORESIGHT_IGTL_INBOX_H
#define BORESIGHT_IGTL_INBOX_H

#include "igtl/wire/igtl_codec.h"
#include "limits/requirement_limits.h"

#include <stdbool.h>
#include <stdint.h>

typedef enum {
    IGTL_INBOX_WAITING = 0, /**< More bytes are needed. */
    /** `message` is complete and valid until the next igtl_inbox_room(). */
    IGTL_INBOX_MESSAGE = 1,
    IGTL_INBOX_SKIPPED = 2, /**< A message of an unknown type has passed. */
    IGTL_INBOX_REFUSED = 3, /**< A whole message was wrong (`reason`); the next one can be read. */
    IGTL_INBOX_BROKEN = 4   /**< No later message can be read (`reason`): drop the connection. */
} igtl_inbox_event_t;

typedef struct {
    uint8_t buffer[IGTL_HEADER_BYTES + LIMIT_IGTL_BODY_MAX];
    uint32_t filled;  /**< Bytes of the present message in `buffer`. */
    bool is_skipping; /**< The body is of no use: an unknown type, or refused by its header. */
    uint64_t passed;  /**< Bytes of it that were skipped. */
    uint64_t passed_crc;
    uint64_t begun_us;    /**< When the first byte of the present message came. */
    uint64_t heard_us;    /**< When the latest byte came. */
    bool is_begun;        /**< Some but not all bytes of a message are here. */
    igtl_header_t header; /**< Valid once its bytes are here. */
    igtl_message_t message;
    igtl_result_t reason;
    uint8_t *large; /**< LIMIT_IGTL_ARRAY_MAX bytes for an NDARRAY, or NULL. */
} igtl_inbox_t;

void igtl_inbox_init(igtl_inbox_t *self);

/**
 * Lends room for an NDARRAY of LIMIT_IGTL_ARRAY_MAX bytes, for as long as the inbox is used.
 * Without it one longer than LIMIT_IGTL_BODY_MAX is refused.
 *
 * @satisfies SWR-IGTL-069
 */
void igtl_inbox_lend(igtl_inbox_t *self, uint8_t large[LIMIT_IGTL_ARRAY_MAX]);

/** Where the next bytes go and how many are wanted, at least 1: never beyond the end of the present
 * message. */
uint32_t igtl_inbox_room(igtl_inbox_t *self, uint8_t **where);

/**
 * `count` bytes (at most the room) have been put there.
 *
 * @satisfies SWR-IGTL-004
 * @satisfies SWR-IGTL-020
 * @satisfies SWR-IGTL-046
 */
igtl_inbox_event_t igtl_inbox_advance(igtl_inbox_t *self, uint32_t count, uint64_t now_us);

/**
 * A message is incomplete for LIMIT_IGTL_PARTIAL_TIMEOUT_US. One that is skipped may take
 * LIMIT_IGTL_SKIP_TIMEOUT_US, with something of it in each LIMIT_IGTL_PARTIAL_TIMEOUT_US.
 *
 * @satisfies SWR-IGTL-011
 * @satisfies SWR-IGTL-021
 */
bool igtl_inbox_is_late(const igtl_inbox_t *self, uint64_t now_us);

#endif
