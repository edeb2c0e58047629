/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Asks control for STOP or EMERGENCY and finds its answer. Any number may ask at once: none waits
 * for another, and none can be refused before control has judged it.
 */
#ifndef BORESIGHT_STOP_COMMAND_H
#define BORESIGHT_STOP_COMMAND_H

#include "exchange/exchange.h"
#include "http/gate/http_problem.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define STOP_COMMAND_JSON_SIZE 384 /**< Room for what stop_command_report() writes. */

/** One stop that was asked for. */
typedef struct {
    uint32_t number;
    uint32_t looks; /**< Left before control counts as silent. */
} stop_question_t;

/** Asks for STOP, or EMERGENCY: it is on its way when this returns. */
stop_question_t stop_command_ask(exchange_t *exchange, workphase_t workphase);

/**
 * Looks once for the answer.
 *
 * @return STATUS_OK with `answer` filled; STATUS_BUSY: look again after ANSWER_POLL_MS;
 *         STATUS_NO_ANSWER after answer_timeout_looks()
 */
status_t stop_command_look(const exchange_t *exchange, stop_question_t *question, answer_t *answer);

/** Asks and looks until STATUS_OK or STATUS_NO_ANSWER, as stop_command_look(). */
status_t stop_command_send_and_wait(exchange_t *exchange, workphase_t workphase, answer_t *answer);

/** The report to the client. */
typedef struct {
    bool is_good;           /**< 200 with what was written. */
    http_problem_t problem; /**< Otherwise. */
} stop_report_t;

/** Writes the report on `status` and, with STATUS_OK, `answer`, if that is good. */
stop_report_t stop_command_report(status_t status, const answer_t *answer,
                                  char json[STOP_COMMAND_JSON_SIZE]);

#endif
