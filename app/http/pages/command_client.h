/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The client of control for pages: it sends typed commands through the lane of HTTP, one sender at
 * a time, and returns their answers to the pages that asked. Any waiting thread takes all answers
 * that have arrived. Safe for any number of threads.
 */
#ifndef BORESIGHT_COMMAND_CLIENT_H
#define BORESIGHT_COMMAND_CLIENT_H

#include "exchange/exchange.h"
#include "http/pages/page_table.h"
#include "limits/requirement_limits.h"
#include "http/login/session_store.h"

#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>

/** Commands that are sent at once; half of what a lane takes. */
#define COMMAND_CLIENT_BATCH LIMIT_TRAJECTORY_ROWS_AT_ONCE
#define COMMAND_CLIENT_RESULT_COUNT 32U /**< Ends of acts that are kept for the streams. */

/** How an act ended that had been begun. */
typedef struct {
    uint32_t page;
    uint32_t id;
    answer_t answer;
} act_result_t;

/** A command that is waited for. */
typedef struct {
    uint32_t id;
    bool is_answered;
    answer_t answer;
} batch_command_t;

typedef struct {
    pthread_mutex_t lock;
    exchange_t *exchange;
    page_table_t table;
    uint32_t commands;                           /**< Number of the last one. */
    batch_command_t batch[COMMAND_CLIENT_BATCH]; /**< Commands of command_client_do_all(). */
    uint32_t batch_count;
    bool has_to_begin;  /**< The authority of an earlier server must be released first. */
    uint32_t news_next; /**< Number of the next news. */
    act_result_t news[COMMAND_CLIENT_RESULT_COUNT];
} command_client_t;

typedef enum {
    PAGE_GREETED = 0,
    PAGE_ANOTHERS = 1, /**< The number is that of a page of another session. */
    PAGE_LATER = 2     /**< There is no place now. */
} page_verdict_t;

typedef enum {
    ACT_ANSWERED = 0,
    ACT_ID_USED = 1,  /**< The id stands for another act, or is lower than one that was used. */
    ACT_LATER = 2,    /**< Too many commands wait; nothing was sent. */
    ACT_NO_ANSWER = 3 /**< None yet; the act may be done all the same. */
} act_verdict_t;

/**
 * Starts without pages. Forgets the answers to an earlier server, and has released what its pages
 * had before anything else is sent. `exchange` outlives `self`.
 *
 * @satisfies SWR-HTTP-024
 */
void command_client_init(command_client_t *self, exchange_t *exchange);

/**
 * Knows the page `number`, not 0, as one of `session` from now on, and publishes all there are.
 * `holder`: the page that has authority, 0: none.
 *
 * @satisfies SWR-HTTP-034
 */
page_verdict_t command_client_register_page(command_client_t *self, uint32_t number,
                                            const session_t *session, uint32_t holder);

/**
 * Has `command` done as the act `id`, not 0, of a page that was greeted. Source, peer and the
 * command's own id are filled in here. An act that is repeated is looked at, and not done again.
 *
 * @param answer  with ACT_ANSWERED the last one so far
 * @return ACT_NO_ANSWER: look for it
 *
 * @satisfies SWR-HTTP-021
 * @satisfies SWR-HTTP-023
 */
act_verdict_t command_client_ask(command_client_t *self, uint32_t page, uint32_t id,
                                 const command_t *command, answer_t *answer);

/** Looks once for the answer to an act that was asked for. Never ACT_LATER. */
act_verdict_t command_client_look(command_client_t *self, uint32_t page, uint32_t id,
                                  const command_t *command, answer_t *answer);

/** Asks, and looks for the answer as often as answer_timeout_looks() says. */
act_verdict_t command_client_send_and_wait(command_client_t *self, uint32_t page, uint32_t id,
                                           const command_t *command, answer_t *answer);

/**
 * Has `command` of `page` done, which is no act and may be repeated without harm, and waits for its
 * first answer. One at a time.
 *
 * @return ACT_ANSWERED; ACT_LATER when too many wait, another one of these among them;
 * ACT_NO_ANSWER
 */
act_verdict_t command_client_do(command_client_t *self, uint32_t page, const command_t *command,
                                answer_t *answer);

/**
 * The same with `count` commands, at most COMMAND_CLIENT_BATCH, which are sent one behind the
 * other.
 *
 * @param answers  with ACT_ANSWERED one of each
 */
act_verdict_t command_client_do_all(command_client_t *self, uint32_t page,
                                    const command_t *commands, uint32_t count, answer_t *answers);

/** Copies to `command` what was sent as the act `id` of `page`. False: that is not known. */
bool command_client_recall(command_client_t *self, uint32_t page, uint32_t id, command_t *command);

/** Sends what may be repeated without harm, and does not wait; of `page` 0 what is no page's.
 * False: too many commands wait. */
bool command_client_send(command_client_t *self, uint32_t page, const command_t *command);

/**
 * Takes answers, releases what pages have whose session has ended, and publishes the pages again;
 * to be called several times a second.
 *
 * @satisfies SWR-HTTP-025
 */
void command_client_tick(command_client_t *self, session_store_t *sessions, uint64_t now_ms);

/** Number of the next news. */
uint32_t command_client_result_count(command_client_t *self);

/** Copies the news `*next`, or the oldest one after it that is kept, and advances `*next`. False:
 * there is none yet. */
bool command_client_read_results(command_client_t *self, uint32_t *next, act_result_t *news);

#endif
