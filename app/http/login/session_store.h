/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Where clients log in and show who they are. Any number of threads may ask at once; one password
 * at a time is looked at, and no other thread waits for that. Times are in ms, of a clock that
 * never goes back.
 */
#ifndef BORESIGHT_SESSION_STORE_H
#define BORESIGHT_SESSION_STORE_H

#include "interface/note_kind.h"
#include "http/login/account.h"
#include "http/login/device_mark.h"
#include "http/login/login_delay.h"
#include "http/login/session_table.h"

#include <pthread.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define SESSION_CODE_SIZE                                                                          \
    15U /**< Size of the code of the first login: three groups of four, and a NUL. */
#define SESSION_FROM_SIZE 72U  /**< Size of " from ", a listener and an address. */
#define SESSION_TEXT_SIZE 161U /**< 160 bytes and a NUL. */

/** Is informed of an act on the account `who`, "?": unknown; `text` continues the name. */
typedef void (*session_witness_t)(void *owner, note_kind_t kind, const char *who, const char *text);

/** A refused login, for the log. */
typedef struct {
    char who[ACCOUNT_NAME_SIZE];  /**< Its name; "?": no account can have it. */
    char from[SESSION_FROM_SIZE]; /**< " from " and its address; "": not known. */
} refused_login_t;

typedef struct {
    pthread_mutex_t lock;
    const char *accounts_file;    /**< NULL: none, the code alone. */
    session_witness_t witness;    /**< Called without the lock. */
    void *witness_owner;          /**< Handed to it. */
    char code[SESSION_CODE_SIZE]; /**< "": none, or used. */
    bool is_looking;              /**< At a password. */
    uint32_t unreported;          /**< Refusals that were not reported. */
    refused_login_t last;         /**< The last login that was refused. */
    uint64_t reported_ms;         /**< Time of the last report. */
    uint64_t compared_ms;         /**< Time of the last comparison of sessions with accounts. */
    login_delay_t delay;
    device_key_t key; /**< Key of the marks; it ends with the process. */
    session_table_t table;
} session_store_t;

/** The statements of a client about itself. */
typedef struct {
    const char *name;     /**< NULL with a code. */
    const char *password; /**< NULL with a code. */
    const char *code;     /**< NULL with a name. */
    const char *id;       /**< Id of the session that it has, which ends; NULL: none. */
    const char *address;  /**< Where it comes from, and by which listener; NULL: not known. */
    const char *mark;     /**< Text that its browser shows as the mark of `name`; NULL: none. */
} login_t;

typedef enum {
    LOGIN_OPENED = 0,
    LOGIN_REFUSED = 1, /**< No such name, password or code. */
    LOGIN_LATER = 2,   /**< It was not looked at: too many failed before it. */
    LOGIN_FULL = 3,    /**< There are too many sessions. */
    LOGIN_BUSY = 4     /**< It was not looked at: another is. */
} login_verdict_t;

typedef enum {
    SESSION_PASS = 0,
    SESSION_NONE = 1, /**< None is open. */
    SESSION_CSRF = 2, /**< The token is missing or another. */
    SESSION_ROLE = 3  /**< The role is not enough. */
} session_verdict_t;

/** The kind of a request. */
typedef enum {
    SESSION_READS = 0,
    SESSION_ACTS = 1, /**< It needs the token, and keeps the session from falling asleep. */
    SESSION_RUNS = 2  /**< It needs the token; a page does it by itself. */
} session_use_t;

/** Starts without sessions and without a code. `accounts_file` and `owner` outlive `self`. */
void session_store_init(session_store_t *self, const char *accounts_file, session_witness_t witness,
                        void *owner);

/**
 * Makes the code of the first login; it is in `self`.
 *
 * @return false without random numbers
 *
 * @satisfies SWR-SESS-005
 */
bool session_store_make_code(session_store_t *self);

/** Whether the code can still be used. */
bool session_store_has_code(session_store_t *self);

/**
 * Judges a login.
 *
 * @param opened  set with LOGIN_OPENED
 * @param wait_s  seconds to wait, set with LOGIN_LATER and LOGIN_BUSY
 *
 * @satisfies SWR-SESS-003
 * @satisfies SWR-SESS-020
 * @satisfies SWR-SESS-300
 * @satisfies SWR-SESS-030
 * @satisfies SWR-SESS-034
 */
login_verdict_t session_store_log_in(session_store_t *self, const login_t *login, uint64_t now_ms,
                                     session_t *opened, uint32_t *wait_s);

/**
 * Notes a login that was refused without being judged, `why` in a sentence. At most one line in
 * LIMIT_REFUSALS_LINE_S; the others are counted.
 *
 * @satisfies SWR-SESS-020
 * @satisfies SWR-SESS-021
 * @satisfies SWR-SESS-300
 */
void session_store_note_refusal(session_store_t *self, const login_t *login, const char *why,
                                uint64_t now_ms);

/** Writes the mark for a browser in which `name` has logged in. False: none exists. */
bool session_store_write_mark(const session_store_t *self, const char *name,
                              char mark[DEVICE_MARK_SIZE]);

/** Copies the open session with this id to `session`. False: none exists. `id` may be NULL. */
bool session_store_find(session_store_t *self, const char *id, uint64_t now_ms, session_t *session);

/**
 * Judges a request by its session, in the order of session_verdict_t.
 *
 * @satisfies SWR-SESS-011
 * @satisfies SWR-SESS-013
 * @satisfies SWR-HTTP-035
 */
session_verdict_t session_store_judge(session_store_t *self, const char *id, const char *csrf,
                                      session_use_t use, role_t role, uint64_t now_ms);

/** Ends the session with this id, if there is one. */
void session_store_log_out(session_store_t *self, const char *id, uint64_t now_ms);

/**
 * Ends each session whose time is over or whose account has changed, and reports the count of
 * refusals; to be called at least each second.
 *
 * @satisfies SWR-SESS-021
 * @satisfies SWR-SESS-022
 * @satisfies SWR-SESS-322
 */
void session_store_tick(session_store_t *self, uint64_t now_ms);

#endif
