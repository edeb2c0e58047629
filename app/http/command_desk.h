/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Sends commands to control and finds the answer to each. Several threads may ask at once: whoever
 * looks into the answer lane also keeps what belongs to the others.
 */
#ifndef BORESIGHT_COMMAND_DESK_H
#define BORESIGHT_COMMAND_DESK_H

#include "exchange.h"

#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>

#define COMMAND_DESK_QUESTIONS 16U /**< As many as the server has threads. */

/** A command that waits for its answer. */
typedef struct {
    uint32_t id; /**< 0: free. */
    bool is_answered;
    answer_t answer;
} command_question_t;

typedef struct {
    exchange_t *exchange;
    pthread_mutex_t lock;
    uint32_t next_id;
    command_question_t questions[COMMAND_DESK_QUESTIONS];
} command_desk_t;

/**
 * Starts with nothing asked. `exchange` outlives `self`; nobody else takes answers of
 * COMMAND_SOURCE_HTTP.
 */
void command_desk_init(command_desk_t *self, exchange_t *exchange);

/**
 * Sends `command` (its id and source are filled in) and waits at most `timeout_ms` of the board's
 * time for the first answer to it.
 *
 * @return STATUS_OK with `answer` filled; STATUS_BUSY when the lane stayed full, nothing was sent;
 *         STATUS_NO_ANSWER when control stayed silent
 */
status_t command_desk_ask(command_desk_t *self, const command_t *command, uint32_t timeout_ms,
                          answer_t *answer);

#endif
