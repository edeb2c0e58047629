/* SPDX-License-Identifier: Apache-2.0 */
#include "http/call/http_download.h"

#include "http/call/http_reply.h"
#include "http/view/telemetry.h"
#include "limits/requirement_limits.h"
#include "request/request_headers.h"

#include <inttypes.h>
#include <stdio.h>
#include <unistd.h>

#define PIECE_BYTES 32768U
#define ETAG_SIZE 48U
#define PART_BYTES 4096U /* Size of one write, which continues as long as any of it is taken. */
/* The library gives up a write after so long without progress, also when it is given less time. */
#define WRITE_US 2000000U
#define WRITES (LIMIT_DOWNLOAD_PIECE_US / WRITE_US)
#define LAST_WRITE_MS ((LIMIT_DOWNLOAD_PIECE_US - WRITE_US) / 1000U)

/* An error is a write without progress: then all of them are soon over. */
static bool write_piece(struct mg_connection *connection, const char *bytes, size_t size)
{
    const uint64_t begun_ms = telemetry_now_ms();
    size_t sent = 0U;
    uint32_t in_vain = 0U;
    while ((sent < size) && (in_vain < WRITES) &&
           ((telemetry_now_ms() - begun_ms) <= LAST_WRITE_MS)) {
        const size_t left = size - sent;
        const int count =
            mg_write(connection, &bytes[sent], (left < PART_BYTES) ? left : PART_BYTES);
        sent += (count > 0) ? (size_t)count : 0U;
        in_vain += (count > 0) ? 0U : 1U;
    }
    return sent == size;
}

static bool send_bytes(struct mg_connection *connection, const archive_file_t *file)
{
    char piece[PIECE_BYTES];
    bool is_taken = true;
    for (uint64_t sent = 0U; is_taken && (sent < file->bytes); sent += sizeof piece) {
        const uint64_t left = file->bytes - sent;
        const size_t size = (left < sizeof piece) ? (size_t)left : sizeof piece;
        is_taken = (pread(file->file, piece, size, (off_t)sent) == (ssize_t)size) &&
                   write_piece(connection, piece, size);
    }
    return is_taken;
}

/* Tag of a file that only grows, or is another one. */
static void write_etag(const archive_file_t *file, char etag[ETAG_SIZE])
{
    (void)snprintf(etag, ETAG_SIZE, "\"%" PRIx64 "-%" PRIx64 "\"", file->modified_ns, file->bytes);
}

int http_download_send(struct mg_connection *connection, archive_file_t *file, const char *type)
{
    char etag[ETAG_SIZE];
    write_etag(file, etag);
    const bool is_known = request_headers_know(mg_get_header(connection, "If-None-Match"), etag);
    const http_reply_t reply = {.status = is_known ? 304 : 200,
                                .type = is_known ? NULL : type,
                                .cache = HTTP_REPLY_REVALIDATE,
                                .etag = etag,
                                .file_name = file->name,
                                .is_apart = true,
                                .size = (size_t)file->bytes};
    int status = http_reply_send(connection, &reply);
    const bool is_wanted = (status == 200) && !http_reply_is_head_asked(connection);
    if (is_wanted && !send_bytes(connection, file)) {
        status = 0;
    }
    archive_close(file);
    return status;
}
