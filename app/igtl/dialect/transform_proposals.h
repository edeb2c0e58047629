/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Proposals and withdrawals of one peer of bare transforms, on their way to the controller. Only
 * the newest of each subject waits; one is passed on each LIMIT_IGTL_PROPOSAL_INTERVAL_US, after a
 * pause up to LIMIT_IGTL_PROPOSAL_BURST together, and at most one in LIMIT_IGTL_PROPOSAL_NOTE_US
 * for the log. None is refused for being fast.
 */
#ifndef BORESIGHT_TRANSFORM_PROPOSALS_H
#define BORESIGHT_TRANSFORM_PROPOSALS_H

#include "igtl/dialect/igtl_dialect.h"
#include "igtl/dialect/igtl_requests.h"
#include "interface/command.h"
#include "limits/requirement_limits.h"

#include <stdbool.h>
#include <stdint.h>

#define TRANSFORM_SUBJECTS 3U /**< Registration, entry point, target point. */

/** The waiting proposal of one subject. */
typedef struct {
    bool is_waiting;
    uint32_t turn;           /**< Smaller ones came first. */
    uint64_t waits_since_us; /**< In the time of its timeout. */
    command_t command;       /**< A proposal, or its withdrawal. */
} transform_waiting_t;

/** All zero: nothing waits. */
typedef struct {
    transform_waiting_t waiting[TRANSFORM_SUBJECTS];
    uint32_t next_turn;
    uint64_t even_us;      /**< When what was passed on is as much as the interval allows. */
    uint64_t next_note_us; /**< Not before this time is one for the log again. */
} transform_proposals_t;

/** The command that proposes the subject of a message `name`, COMMAND_NONE for another name. */
command_kind_t transform_proposals_kind(const char *name);

/** The name of the subject of the command, "" for another command. Lives as long as the process. */
const char *transform_proposals_name(const command_t *command);

/**
 * Takes a proposal, or COMMAND_WITHDRAW of one, in place of what still waits of the same subject.
 *
 * @satisfies SWR-IGTL-044
 */
void transform_proposals_put(transform_proposals_t *self, const command_t *command,
                             const igtl_moment_t *moment);

/**
 * Passes on what may be, oldest first. One that is not for the log says so: a proposal by its
 * argument, a withdrawal by its value.
 *
 * @satisfies SWR-IGTL-044
 */
void transform_proposals_pass(transform_proposals_t *self, igtl_requests_t *requests, uint32_t peer,
                              const igtl_moment_t *moment);

/** The name of one that the controller did not take for LIMIT_IGTL_PROPOSAL_WAIT_US; it waits no
 * longer. NULL when there is none (any more). */
const char *transform_proposals_overdue(transform_proposals_t *self, const igtl_moment_t *moment);

#endif
