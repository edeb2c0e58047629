/* SPDX-License-Identifier: Apache-2.0 */
/** @file The open sessions. Times are in ms, of a clock that never goes back. The caller sees to it
 * that one thread at a time is here. */
#ifndef BORESIGHT_SESSION_TABLE_H
#define BORESIGHT_SESSION_TABLE_H

#include "limits/requirement_limits.h"
#include "http/login/account.h"

#include <stdbool.h>
#include <stdint.h>

/** In hexadecimal, with a NUL. */
#define SESSION_TOKEN_SIZE ((2U * LIMIT_SESSION_ID_BYTES) + 1U)

typedef struct {
    bool is_open;
    char id[SESSION_TOKEN_SIZE];   /**< Value of the cookie. */
    char csrf[SESSION_TOKEN_SIZE]; /**< Token that a writing request sends beside it. */
    account_t account;             /**< As it was when the session was opened. */
    uint64_t opened_ms;
    uint64_t used_ms;
    uint64_t seen_ms; /**< As used_ms, and kept by a page that renews its authority. */
} session_t;

/** All zero at first. */
typedef struct {
    session_t sessions[LIMIT_SESSIONS];
} session_table_t;

/** Seconds until a session ends. */
typedef struct {
    uint32_t idle_s; /**< If nothing is written in it. */
    uint32_t most_s; /**< With or without requests. */
} session_left_t;

/**
 * Opens a session.
 *
 * @return NULL when there are LIMIT_SESSIONS already, LIMIT_ACCOUNT_SESSIONS of them of this
 * account, or no random numbers
 *
 * @satisfies SWR-SESS-007
 * @satisfies SWR-SESS-027
 * @satisfies SWR-SESS-008
 */
const session_t *session_table_open(session_table_t *self, const account_t *account,
                                    uint64_t now_ms);

/** The open session with this id; NULL: none exists. */
session_t *session_table_find(session_table_t *self, const char *id, uint64_t now_ms);

/**
 * The session of this account from which nothing has been heard for the longest, and for
 * LIMIT_SESSION_LEFT_S; NULL: none exists.
 *
 * @satisfies SWR-SESS-029
 */
session_t *session_table_find_left(session_table_t *self, const account_t *account,
                                   uint64_t now_ms);

/** Ends a session. */
void session_table_close(session_t *session);

/**
 * Takes out a session that has come to its end by itself, and copies it to `ended`. False: there is
 * none left.
 *
 * @satisfies SWR-SESS-009
 */
bool session_table_take_ended(session_table_t *self, uint64_t now_ms, session_t *ended);

session_left_t session_left(const session_t *session, uint64_t now_ms);

#endif
