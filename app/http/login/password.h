/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Hashes of passwords: yescrypt, by the system's libcrypt. A hash takes tens of milliseconds and
 * some megabytes; the caller sees to it that no two are made at once, and holds no lock meanwhile.
 */
#ifndef BORESIGHT_PASSWORD_H
#define BORESIGHT_PASSWORD_H

#include <stdbool.h>
#include <stddef.h>

#define PASSWORD_SIZE 129U /**< 128 bytes and a NUL. */

/**
 * Makes the hash of a password with a salt of its own. Not to be called twice at once.
 *
 * @return false when the system cannot
 *
 * @satisfies SWR-SESS-003
 */
bool password_hash(const char *password, char *hash, size_t hash_size);

/** Whether `hash` is that of `password`. NULL is the hash of nothing, and takes as long. Not to be
 * called twice at once. */
bool password_matches(const char *password, const char *hash);

/** Whether two texts are equal, in a time that depends on the length of `given` alone. */
bool password_is_equal(const char *given, const char *expected);

#endif
