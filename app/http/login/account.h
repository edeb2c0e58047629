/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The accounts that may log in: a file with a line for each, NAME:ROLE:HASH, that only its owner
 * may read. A name has 1 to 31 of a-z, 0-9, - and _; a line that begins with # is a comment.
 */
#ifndef BORESIGHT_ACCOUNT_H
#define BORESIGHT_ACCOUNT_H

#include "interface/role.h"
#include "limits/requirement_limits.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define ACCOUNT_NAME_SIZE 32U    /**< 31 characters and a NUL. */
#define ACCOUNT_HASH_SIZE 128U   /**< 127 characters and a NUL. */
#define ACCOUNTS_FILE_SIZE 8192U /**< Longest file, in bytes. */

typedef struct {
    char name[ACCOUNT_NAME_SIZE];
    role_t role;
    char hash[ACCOUNT_HASH_SIZE];
} account_t;

typedef struct {
    uint32_t count;
    account_t accounts[LIMIT_ACCOUNTS];
} accounts_t;

/** Whether `text` can be the name of an account. */
bool account_is_name(const char *text);

/** The role that is called `text`, in lower case. False: none is. */
bool account_read_role(const char *text, role_t *role);

/** A role's name in lower case. Lives as long as the process. */
const char *account_role_word(role_t role);

/**
 * Reads `length` bytes of `text`; `file` is what errors call it.
 *
 * @return false with "FILE, line N: sentence" in `error`
 *
 * @satisfies SWR-SESS-001
 */
bool accounts_parse(accounts_t *self, const char *file, const char *text, size_t length,
                    char *error, size_t error_size);

/**
 * Reads the file. False with a sentence in `error`.
 *
 * @satisfies SWR-SESS-002
 */
bool accounts_read(accounts_t *self, const char *file, char *error, size_t error_size);

/**
 * Puts the accounts in the file's place, all or nothing. Comments are lost.
 *
 * @return false with a sentence in `error`; the old file then is what it was
 *
 * @satisfies SWR-SESS-004
 */
bool accounts_write(const accounts_t *self, const char *file, char *error, size_t error_size);

/** The account of this name; NULL: none exists. */
account_t *accounts_find(accounts_t *self, const char *name);

/** Adds an account or replaces the one of its name. False when there are too many. */
bool accounts_put(accounts_t *self, const account_t *account);

/** False when no account has this name. */
bool accounts_remove(accounts_t *self, const char *name);

#endif
