/* SPDX-License-Identifier: Apache-2.0 */
#include "session/login_delay.h"

#include "limits/requirement_limits.h"
#include "session/passed.h"

#define MS_PER_S 1000U
#define DOUBLINGS_MOST 31U
/* FNV-1a */
#define HASH_START 2166136261U
#define HASH_FACTOR 16777619U

static uint32_t row_of(const char *name)
{
    uint32_t hash = HASH_START;

    for (const char *byte = name; *byte != '\0'; byte++) {
        hash = (hash ^ (uint32_t)(unsigned char)*byte) * HASH_FACTOR;
    }
    return (hash ^ (hash >> 16U)) % LOGIN_DELAY_ROWS;
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
    const login_failures_t *rows = who.is_known ? self->rows : self->invented;
    const uint64_t own_ms = left_ms(&rows[row_of(who.name)], LIMIT_LOGIN_FREE_FAILURES, now_ms);
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
    login_failures_t *row =
        who.is_known ? &self->rows[row_of(who.name)] : &self->invented[row_of(who.name)];

    if (is_good) {
        row->failures = 0U;
    } else {
        count(row, now_ms);
    }
    if (!who.is_known) {
        count(&self->invented_in_all, now_ms);
    }
}
