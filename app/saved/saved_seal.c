/* SPDX-License-Identifier: Apache-2.0 */
#include "saved/saved_seal.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <openssl/crypto.h>
#include <openssl/hmac.h>
#include <stdio.h>
#include <string.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#define KEY_MODE 0600
#define OTHERS 0077

/* It gets its name when it is whole. */
static bool make_key(const char *path)
{
    char draft[PATH_MAX];
    uint8_t bytes[SAVED_KEY_SIZE];
    if ((size_t)snprintf(draft, sizeof draft, "%s.new", path) >= sizeof draft) {
        errno = ENAMETOOLONG;
        return false;
    }
    (void)unlink(draft);
    const int file = open(draft, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, KEY_MODE);
    if (file < 0) {
        return false;
    }
    bool is_made = (getrandom(bytes, sizeof bytes, 0U) == (ssize_t)sizeof bytes) &&
                   (write(file, bytes, sizeof bytes) == (ssize_t)sizeof bytes) &&
                   (fsync(file) == 0);
    is_made = (close(file) == 0) && is_made && (rename(draft, path) == 0);
    OPENSSL_cleanse(bytes, sizeof bytes);
    return is_made;
}

/* A file of another kind may not hold up the server. */
static int open_key(const char *path)
{
    return open(path, O_RDONLY | O_NONBLOCK | O_NOFOLLOW | O_CLOEXEC);
}

static const char *read_key(saved_key_t *self, int file)
{
    struct stat found;
    uint8_t bytes[SAVED_KEY_SIZE + 1U];
    if ((fstat(file, &found) != 0) || !S_ISREG(found.st_mode)) {
        return "is no file";
    }
    if (((found.st_mode & OTHERS) != 0U) || (found.st_uid != geteuid())) {
        return "can be read by others than its owner; chmod 600 it";
    }
    const bool is_whole = read(file, bytes, sizeof bytes) == (ssize_t)SAVED_KEY_SIZE;
    (void)memcpy(self->bytes, bytes, sizeof self->bytes);
    OPENSSL_cleanse(bytes, sizeof bytes);
    return is_whole ? NULL : "is damaged; remove it for a new one";
}

bool saved_key_open(saved_key_t *self, const char *path, char *error, size_t error_size)
{
    int file = open_key(path);
    if ((file < 0) && (errno == ENOENT) && make_key(path)) {
        file = open_key(path);
    }
    if (file < 0) {
        (void)snprintf(error, error_size, "the key of the box %s: %s.", path, strerror(errno));
        return false;
    }
    const char *trouble = read_key(self, file);
    (void)close(file);
    if (trouble != NULL) {
        (void)snprintf(error, error_size, "the key of the box %s %s.", path, trouble);
    }
    return trouble == NULL;
}

bool saved_seal_make(const saved_key_t *key, const position_record_t *record, uint8_t *seal)
{
    uint8_t bytes[POSITION_RECORD_SIZE];
    position_record_encode(record, bytes);
    return HMAC(EVP_sha256(), key->bytes, (int)sizeof key->bytes, bytes, sizeof bytes, seal,
                NULL) != NULL;
}

bool saved_seal_fits(const saved_key_t *key, const position_record_t *record, const uint8_t *seal)
{
    uint8_t wanted[SAVED_SEAL_SIZE];
    return saved_seal_make(key, record, wanted) &&
           (CRYPTO_memcmp(wanted, seal, sizeof wanted) == 0);
}
