/* SPDX-License-Identifier: Apache-2.0 */
#include "http/login/password.h"

#include <crypt.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#define YESCRYPT "$y$"
#define COST 5U /* 19 ms where a desktop is; several times as long on a small board. */

/* Hash of no account's password. */
static const char nobody[] =
    "$y$j9T$B1.z5.qHqWc8YQm4RBf9A.$gDTnJIvGjIPx4i0DsYZrVdgHZeD7mQUwXv9x2pGxuYB";

/* 32 kB are too much for a thread's stack, and there is one hash at a time. */
static struct crypt_data room;

bool password_is_equal(const char *given, const char *expected)
{
    const size_t length = strlen(expected);
    uint32_t difference = (strlen(given) == length) ? 0U : 1U;

    for (size_t i = 0U; given[i] != '\0'; i++) {
        const char byte = (length > 0U) ? expected[i % length] : '\0';
        difference |= (uint32_t)((unsigned char)given[i] ^ (unsigned char)byte);
    }
    return difference == 0U;
}

bool password_hash(const char *password, char *hash, size_t hash_size)
{
    char setting[CRYPT_GENSALT_OUTPUT_SIZE];

    if (crypt_gensalt_rn(YESCRYPT, COST, NULL, 0, setting, (int)sizeof setting) == NULL) {
        return false;
    }
    const char *made = crypt_rn(password, setting, &room, (int)sizeof room);
    const bool is_good =
        (made != NULL) && ((size_t)snprintf(hash, hash_size, "%s", made) < hash_size);
    explicit_bzero(&room, sizeof room);
    return is_good;
}

bool password_matches(const char *password, const char *hash)
{
    const char *expected = (hash != NULL) ? hash : nobody;
    const char *made = crypt_rn(password, expected, &room, (int)sizeof room);
    const bool is_equal = (made != NULL) && password_is_equal(made, expected);

    explicit_bzero(&room, sizeof room);
    return is_equal && (hash != NULL);
}
