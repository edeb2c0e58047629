/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Makes guessing slow: counts failed logins of each name and in all. Names that do not exist are
 * counted like those that do, so that the delay tells nobody which there are. Times are in ms, of a
 * clock that never goes back.
 */
#ifndef BORESIGHT_LOGIN_DELAY_H
#define BORESIGHT_LOGIN_DELAY_H

#include <stdbool.h>
#include <stdint.h>

#define LOGIN_DELAY_ROWS 64U /**< Names that fall into one row share it. */

typedef struct {
    uint32_t failures;
    uint64_t failed_ms; /**< The last of them. */
} login_failures_t;

/** All zero at first. */
typedef struct {
    login_failures_t in_all;
    login_failures_t rows[LOGIN_DELAY_ROWS];
} login_delay_t;

/**
 * Seconds until a login of `name` is judged again; 0: now.
 *
 * @satisfies SWR-SESS-014
 */
uint32_t login_delay_left_s(const login_delay_t *self, const char *name, uint64_t now_ms);

/** A login of `name` was judged. */
void login_delay_note(login_delay_t *self, const char *name, bool is_good, uint64_t now_ms);

#endif
