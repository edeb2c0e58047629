/* SPDX-License-Identifier: Apache-2.0 */
/** @file What a page does not have: a recorder with its files, a key of the box, accounts, a port
 * for stops, and the files of the console. */
#include "http/server/asset.h"
#include "http/handlers/http_positions.h"
#include "http/call/http_reply.h"
#include "interface/app/handlers.h"
#include "http/login/device_mark.h"
#include "http/login/password.h"
#include "http/login/tls_front.h"

#include <stddef.h>
#include <string.h>

#define ABSENT(handler)                                                                            \
    int handler(http_server_t *server, const http_call_t *call)                                    \
    {                                                                                              \
        (void)server;                                                                              \
        return http_reply_refuse(call->connection, PROBLEM_NOT_FOUND);                             \
    }

ABSENT(http_archive_log)
ABSENT(http_archive_log_csv)
ABSENT(http_archive_logs)
ABSENT(http_archive_log_file)
ABSENT(http_archive_recordings)
ABSENT(http_archive_recording)
ABSENT(http_archive_log_level)
ABSENT(http_archive_set_log_level)
ABSENT(http_positions_save)
ABSENT(http_positions_preview)
ABSENT(http_positions_restore)

void http_positions_begin(http_server_t *server, const char *path)
{
    (void)path;
    server->has_key = false;
}

const asset_t *asset_find(const char *path)
{
    (void)path;
    return NULL;
}

void asset_write_etag(const asset_t *asset, bool is_packed, char etag[ASSET_ETAG_SIZE])
{
    (void)asset;
    (void)is_packed;
    etag[0] = '\0';
}

bool password_matches(const char *password, const char *hash)
{
    (void)password;
    (void)hash;
    return false;
}

/* Its duration is not secret here: no other client measures it. */
bool password_is_equal(const char *given, const char *expected)
{
    return strcmp(given, expected) == 0;
}

/* One logs in by the code. */
void device_key_make(device_key_t *self)
{
    self->is_made = false;
}

bool device_mark_make(const device_key_t *key, const char *name, char mark[DEVICE_MARK_SIZE])
{
    (void)key;
    (void)name;
    (void)mark;
    return false;
}

bool device_mark_fits(const device_key_t *key, const char *name, const char *mark)
{
    (void)key;
    (void)name;
    (void)mark;
    return false;
}

bool tls_front_serves(const tls_front_t *self, uint32_t port, const char *host)
{
    (void)self;
    (void)port;
    (void)host;
    return false;
}
