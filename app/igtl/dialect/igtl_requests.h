/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The commands of one dialect on their way to the controller and back: numbers them, remembers who
 * asked, and notices when no answer comes. The process passes them on (igtl_requests_take()) and
 * hands the answers in.
 */
#ifndef BORESIGHT_IGTL_REQUESTS_H
#define BORESIGHT_IGTL_REQUESTS_H

#include "interface/answer.h"
#include "interface/command.h"

#include <stdbool.h>
#include <stdint.h>

#define IGTL_REQUESTS_PER_PEER 4U /**< Unanswered ones; of STOP and of EMERGENCY as many again. */
#define IGTL_REQUESTS_COMMON 16U  /**< Places for everything but STOP and EMERGENCY. */
/** Places for STOP, and as many for EMERGENCY: the shares of all peers of all ports. */
#define IGTL_REQUESTS_URGENT 128U
/** And one for RELEASE, of which one is on its way at a time. */
#define IGTL_REQUESTS (IGTL_REQUESTS_COMMON + (2U * IGTL_REQUESTS_URGENT) + 1U)
#define IGTL_REQUEST_ID_STEP 2U /**< Ids of the two dialects interleave. */
/** Then the peer is informed that there is no answer. */
#define IGTL_ANSWER_TIMEOUT_US UINT64_C(80000)
#define IGTL_NOBODY UINT32_MAX /**< The peer has gone. */

typedef struct {
    uint32_t id;       /**< 0: the entry is free. */
    uint32_t peer;     /**< Place of the peer that asked, or IGTL_NOBODY. */
    command_t command; /**< As it was sent. */
    uint64_t sent_us;
    bool is_accepted; /**< Begun; a final answer follows. */
    bool is_overdue;  /**< The peer was informed that there is no answer. */
} igtl_request_t;

typedef struct {
    uint32_t next_id;
    uint32_t most; /**< Orders at a time, beside STOP and EMERGENCY. */
    igtl_request_t requests[IGTL_REQUESTS];
    command_t queue[IGTL_REQUESTS]; /**< Not yet passed on, oldest first. */
    uint32_t queued;
} igtl_requests_t;

/** Starts with `first_id`, not 0; at most `most` (1..IGTL_REQUESTS_COMMON) at a time, and STOP and
 * EMERGENCY beside them. */
void igtl_requests_init(igtl_requests_t *self, uint32_t first_id, uint32_t most);

/**
 * Gives `command` an id and queues it for `peer`. NULL when too many are on their way: in all, or
 * IGTL_REQUESTS_PER_PEER unanswered ones of this peer. RELEASE, STOP and EMERGENCY always find a
 * place: of the last two beyond the peer's share the newest one of the same kind gives its place
 * up, and one answer serves both.
 *
 * @satisfies SWR-IGTL-006
 * @satisfies SWR-IGTL-049
 */
const igtl_request_t *igtl_requests_add(igtl_requests_t *self, uint32_t peer, command_t *command,
                                        uint64_t now_us);

/** The request an answer belongs to, NULL when it is not one of these. */
igtl_request_t *igtl_requests_find(igtl_requests_t *self, uint32_t id);

/** Frees the entry. */
void igtl_requests_end(igtl_request_t *request);

/** A request without any answer for IGTL_ANSWER_TIMEOUT_US, once each; NULL when there is none (any
 * more). */
igtl_request_t *igtl_requests_overdue(igtl_requests_t *self, uint64_t now_us);

/** Takes back a command that could not be passed on; it is the last again. */
void igtl_requests_keep(igtl_requests_t *self, const command_t *command);

/** The next command to pass on; false when none exists. */
bool igtl_requests_take(igtl_requests_t *self, command_t *command);

#endif
