/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The pages of the console, and programs, that act: each belongs to a session, and what it last did
 * is kept, so that a repeated request does nothing again. The caller sees to it that one thread at
 * a time is here.
 */
#ifndef BORESIGHT_PAGE_TABLE_H
#define BORESIGHT_PAGE_TABLE_H

#include "interface/answer.h"
#include "interface/command.h"
#include "limits/requirement_limits.h"
#include "http/login/session_table.h"

#include <stdbool.h>
#include <stdint.h>

#define PAGE_TABLE_PAGES (LIMIT_SESSIONS * LIMIT_SESSION_PAGES)

/** An act of a page. */
typedef struct {
    uint32_t id;       /**< The page's; 0: none. */
    command_t command; /**< As it was sent, with a number of ours. */
    bool is_answered;
    answer_t answer; /**< The last one, once it is answered. */
} page_act_t;

typedef struct {
    uint32_t number; /**< The page's own; 0: a free place. */
    char session[SESSION_TOKEN_SIZE];
    char name[ACCOUNT_NAME_SIZE]; /**< Name of the account. */
    uint32_t newest;              /**< The highest id of its acts. */
    uint32_t turn;                /**< When it asked last. */
    uint64_t since_us;            /**< When it came; monotonic. */
    page_act_t acts[LIMIT_PAGE_ACTS];
} page_t;

/** All zero at first. */
typedef struct {
    page_t pages[PAGE_TABLE_PAGES];
    uint32_t turn;
} page_table_t;

/** NULL: no page has this number. */
page_t *page_table_find(page_table_t *self, uint32_t number);

/**
 * Where a new page of `session` goes: a free place, or that of a page that is forgotten for it.
 *
 * @return NULL when none exists
 */
page_t *page_table_place(page_table_t *self, const session_t *session, uint32_t kept);

/**
 * Finds the page `number`, not 0, of `session`, or gives it a place. A session that has
 * LIMIT_SESSION_PAGES loses the one that has asked for nothing for the longest time; never `kept`.
 *
 * @return NULL when it belongs to another session, or there is no place
 *
 * @satisfies SWR-HTTP-022
 */
page_t *page_table_greet(page_table_t *self, uint32_t number, const session_t *session,
                         uint32_t kept);

/** The act `id` of `page`; NULL: it is not kept, or never was. */
page_act_t *page_table_act(page_t *page, uint32_t id);

/** Room for the next act of `page`, all zero; the oldest one that has ended gives its own. */
page_act_t *page_table_add(page_t *page);

/** The act that was sent as `command`, not 0, and its page; NULL: none. */
page_act_t *page_table_find_sent(page_table_t *self, uint32_t command, const page_t **page);

#endif
