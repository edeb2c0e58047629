/* SPDX-License-Identifier: Apache-2.0 */
#include "http/login/device_mark.h"

#include "http/login/password.h"

#include <openssl/hmac.h>
#include <stdio.h>
#include <string.h>
#include <sys/random.h>

#define SEAL_SIZE 32U

void device_key_make(device_key_t *self)
{
    self->is_made = getrandom(self->bytes, sizeof self->bytes, 0U) == (ssize_t)sizeof self->bytes;
}

bool device_mark_make(const device_key_t *key, const char *name, char mark[DEVICE_MARK_SIZE])
{
    uint8_t seal[SEAL_SIZE];

    if (!key->is_made || (HMAC(EVP_sha256(), key->bytes, (int)sizeof key->bytes,
                               (const unsigned char *)name, strlen(name), seal, NULL) == NULL)) {
        return false;
    }
    for (size_t i = 0U; i < SEAL_SIZE; i++) {
        (void)snprintf(&mark[2U * i], 3U, "%02x", (unsigned)seal[i]);
    }
    return true;
}

bool device_mark_fits(const device_key_t *key, const char *name, const char *mark)
{
    char wanted[DEVICE_MARK_SIZE];

    return (mark != NULL) && device_mark_make(key, name, wanted) && password_is_equal(mark, wanted);
}
