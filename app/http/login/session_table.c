/* SPDX-License-Identifier: Apache-2.0 */
#include "http/login/session_table.h"

#include "http/login/passed.h"
#include "http/login/password.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <sys/random.h>

#define MS_PER_S 1000U

static bool make_token(char token[SESSION_TOKEN_SIZE])
{
    unsigned char bytes[LIMIT_SESSION_ID_BYTES];

    if (getrandom(bytes, sizeof bytes, 0U) != (ssize_t)sizeof bytes) {
        return false;
    }
    for (size_t i = 0U; i < sizeof bytes; i++) {
        (void)snprintf(&token[2U * i], 3U, "%02x", (unsigned)bytes[i]);
    }
    return true;
}

static uint32_t left_s(uint64_t since_ms, uint32_t most_s, uint64_t now_ms)
{
    const uint64_t gone_ms = passed_ms(since_ms, now_ms);
    const uint64_t most_ms = (uint64_t)most_s * MS_PER_S;

    return (gone_ms < most_ms) ? (uint32_t)((most_ms - gone_ms + MS_PER_S - 1U) / MS_PER_S) : 0U;
}

session_left_t session_left(const session_t *session, uint64_t now_ms)
{
    const session_left_t left = {.idle_s = left_s(session->used_ms, LIMIT_SESSION_IDLE_S, now_ms),
                                 .most_s =
                                     left_s(session->opened_ms, LIMIT_SESSION_MOST_S, now_ms)};
    return left;
}

static bool is_over(const session_t *session, uint64_t now_ms)
{
    const session_left_t left = session_left(session, now_ms);

    return (left.idle_s == 0U) || (left.most_s == 0U);
}

static bool is_of(const session_t *session, const account_t *account)
{
    return session->is_open && (strcmp(session->account.name, account->name) == 0);
}

static uint32_t count_of(const session_table_t *self, const account_t *account)
{
    uint32_t count = 0U;

    for (size_t i = 0U; i < LIMIT_SESSIONS; i++) {
        count += is_of(&self->sessions[i], account) ? 1U : 0U;
    }
    return count;
}

const session_t *session_table_open(session_table_t *self, const account_t *account,
                                    uint64_t now_ms)
{
    if (count_of(self, account) >= LIMIT_ACCOUNT_SESSIONS) {
        return NULL;
    }
    for (size_t i = 0U; i < LIMIT_SESSIONS; i++) {
        session_t *session = &self->sessions[i];
        if (!session->is_open) {
            session->is_open = make_token(session->id) && make_token(session->csrf);
            session->account = *account;
            session->opened_ms = now_ms;
            session->used_ms = now_ms;
            session->seen_ms = now_ms;
            return session->is_open ? session : NULL;
        }
    }
    return NULL;
}

session_t *session_table_find(session_table_t *self, const char *id, uint64_t now_ms)
{
    session_t *found = NULL;

    for (size_t i = 0U; i < LIMIT_SESSIONS; i++) {
        session_t *session = &self->sessions[i];
        const bool is_it = password_is_equal(id, session->id);
        found = (is_it && session->is_open && !is_over(session, now_ms)) ? session : found;
    }
    return found;
}

session_t *session_table_find_left(session_table_t *self, const account_t *account, uint64_t now_ms)
{
    uint64_t most_ms = (uint64_t)LIMIT_SESSION_LEFT_S * MS_PER_S;
    session_t *found = NULL;

    for (size_t i = 0U; i < LIMIT_SESSIONS; i++) {
        session_t *session = &self->sessions[i];
        const uint64_t silent_ms = passed_ms(session->seen_ms, now_ms);
        if (is_of(session, account) && (silent_ms >= most_ms)) {
            most_ms = silent_ms;
            found = session;
        }
    }
    return found;
}

void session_table_close(session_t *session)
{
    explicit_bzero(session, sizeof *session);
}

bool session_table_take_ended(session_table_t *self, uint64_t now_ms, session_t *ended)
{
    for (size_t i = 0U; i < LIMIT_SESSIONS; i++) {
        session_t *session = &self->sessions[i];
        if (session->is_open && is_over(session, now_ms)) {
            *ended = *session;
            session_table_close(session);
            return true;
        }
    }
    return false;
}
