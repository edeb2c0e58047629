/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Makes guessing slow: counts failed logins of each name, and of names without an account in all.
 * Those have rows of their own, so that whoever invents names delays nobody who has an account; a
 * name for itself waits alike, whether there is one or not. Times are in ms, of a clock that never
 * goes back.
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
    login_failures_t invented_in_all;
    login_failures_t rows[LOGIN_DELAY_ROWS];
    login_failures_t invented[LOGIN_DELAY_ROWS];
} login_delay_t;

/** Who wants to log in. */
typedef struct {
    const char *name;
    bool is_known; /**< There is such an account, or it is the code. */
} login_name_t;

/**
 * Seconds until a login of `who` is judged again; 0: now.
 *
 * @satisfies SWR-SESS-014
 * @satisfies SWR-SESS-028
 */
uint32_t login_delay_left_s(const login_delay_t *self, login_name_t who, uint64_t now_ms);

/** A login of `who` was judged. */
void login_delay_note(login_delay_t *self, login_name_t who, bool is_good, uint64_t now_ms);

#endif
