/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Makes guessing slow: counts failed logins of each name at each address, and of names without an
 * account in all. Those have rows of their own, so that invented names delay no user who has an
 * account; a name for itself waits alike, whether there is one or not. Browsers that have logged
 * in before are counted apart, by name alone: a user with many marks delays no other one. Times
 * are in ms, of a clock that never goes back.
 */
#ifndef BORESIGHT_LOGIN_DELAY_H
#define BORESIGHT_LOGIN_DELAY_H

#include <stdbool.h>
#include <stdint.h>

#define LOGIN_DELAY_ROWS 64U /**< Those that fall into one row share it. */

typedef struct {
    uint32_t failures;
    uint64_t failed_ms; /**< The last of them. */
} login_failures_t;

typedef enum {
    LOGIN_KNOWN = 0,    /**< There is such an account. */
    LOGIN_INVENTED = 1, /**< There is none. */
    LOGIN_MARKED = 2    /**< The browser has logged in by this name before. */
} login_kind_t;

#define LOGIN_KINDS 3U

/** All zero at first. */
typedef struct {
    login_failures_t invented_in_all;
    login_failures_t rows[LOGIN_KINDS][LOGIN_DELAY_ROWS]; /**< By login_kind_t. */
} login_delay_t;

/** A client that wants to log in. */
typedef struct {
    const char *name;
    const char *address; /**< NULL: not known. */
    bool is_known;       /**< There is such an account. */
    bool is_marked;      /**< The browser has logged in as `name` before. */
} login_name_t;

/**
 * Seconds until a login of `who` is judged again; 0: now.
 *
 * @satisfies SWR-SESS-014
 * @satisfies SWR-SESS-028
 * @satisfies SWR-SESS-031
 * @satisfies SWR-SESS-032
 */
uint32_t login_delay_left_s(const login_delay_t *self, login_name_t who, uint64_t now_ms);

/** A login of `who` was judged. */
void login_delay_note(login_delay_t *self, login_name_t who, bool is_good, uint64_t now_ms);

#endif
