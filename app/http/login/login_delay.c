/* SPDX-License-Identifier: Apache-2.0 */
#include "http/login/login_delay.h"

#include "limits/requirement_limits.h"
#include "http/login/passed.h"

#include <stddef.h>

#define MS_PER_S 1000U
#define DOUBLINGS_MOST 31U
/* FNV-1a */
#define HASH_START 2166136261U
#define HASH_FACTOR 16777619U

static uint32_t hash_on(uint32_t hash, const char *text)
{
    uint32_t more = hash;

    for (const char *byte = text; *byte != '\0'; byte++) {
        more = (more ^ (uint32_t)(unsigned char)*byte) * HASH_FACTOR;
    }
    return more * HASH_FACTOR; /* The end of the text counts as well. */
}

static uint32_t row_of(login_name_t who)
{
    uint32_t hash = hash_on(HASH_START, who.name);

    if (!who.is_marked && (who.address != NULL)) {
        hash = hash_on(hash, who.address);
    }
    return (hash ^ (hash >> 16U)) % LOGIN_DELAY_ROWS;
}

static uint32_t kind_of(login_name_t who)
{
    const login_kind_t unmarked = who.is_known ? LOGIN_KNOWN : LOGIN_INVENTED;

    return (uint32_t)(who.is_marked ? LOGIN_MARKED : unmarked);
}

static bool is_forgotten(const login_failures_t *failures, uint64_t now_ms)
{
    return passed_ms(failures->failed_ms, now_ms) >= ((uint64_t)LIMIT_LOGIN_FORGET_S * MS_PER_S);
}

/* From the last failure on. */
static uint64_t delay_ms(uint32_t failures, uint32_t free_failures)
{
    if (failures <= free_failures) {
        return 0U;
    }
    const uint32_t doublings = failures - free_failures - 1U;
    const uint64_t seconds = UINT64_C(1)
                             << ((doublings < DOUBLINGS_MOST) ? doublings : DOUBLINGS_MOST);
    return ((seconds < LIMIT_LOGIN_DELAY_MOST_S) ? seconds : LIMIT_LOGIN_DELAY_MOST_S) * MS_PER_S;
}

static uint64_t left_ms(const login_failures_t *failures, uint32_t free_failures, uint64_t now_ms)
{
    const uint64_t gone_ms = passed_ms(failures->failed_ms, now_ms);
    const uint64_t whole_ms = delay_ms(failures->failures, free_failures);

    return (whole_ms > gone_ms) ? (whole_ms - gone_ms) : 0U;
}

uint32_t login_delay_left_s(const login_delay_t *self, login_name_t who, uint64_t now_ms)
{
    const login_failures_t *row = &self->rows[kind_of(who)][row_of(who)];
    const uint64_t own_ms = left_ms(row, LIMIT_LOGIN_FREE_FAILURES, now_ms);
    const uint64_t all_ms =
        who.is_known ? 0U
                     : left_ms(&self->invented_in_all, LIMIT_LOGIN_FREE_FAILURES_IN_ALL, now_ms);
    const uint64_t longer_ms = (own_ms > all_ms) ? own_ms : all_ms;

    return (uint32_t)((longer_ms + MS_PER_S - 1U) / MS_PER_S);
}

static void count(login_failures_t *failures, uint64_t now_ms)
{
    failures->failures = is_forgotten(failures, now_ms) ? 1U : (failures->failures + 1U);
    failures->failed_ms = now_ms;
}

void login_delay_note(login_delay_t *self, login_name_t who, bool is_good, uint64_t now_ms)
{
    login_failures_t *row = &self->rows[kind_of(who)][row_of(who)];

    if (is_good) {
        row->failures = 0U;
    } else {
        count(row, now_ms);
    }
    if (!who.is_known) {
        count(&self->invented_in_all, now_ms);
    }
}
