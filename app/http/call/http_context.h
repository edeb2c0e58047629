/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The state of the HTTP server, which the answers to its requests share. http_server.h owns it;
 * each part is used by the functions of its own header alone.
 */
#ifndef BORESIGHT_HTTP_CONTEXT_H
#define BORESIGHT_HTTP_CONTEXT_H

#include "exchange/exchange.h"
#include "exchange/exchange_files.h"
#include "http/gate/http_guard.h"
#include "http/pages/command_client.h"
#include "http/pages/http_notes.h"
#include "http/pages/http_peers_log.h"
#include "http/pages/http_record.h"
#include "http/view/telemetry.h"
#include "http/view/telemetry_json.h"
#include "saved/saved_store.h"
#include "http/login/session_store.h"

#include <civetweb.h>
#include <pthread.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define HTTP_STREAM_CLIENTS 8U /**< Each has a thread of the server's to itself. */
#define HTTP_STREAM_FRAME_SIZE 32768U
#define HTTP_STREAM_HISTORY 50U /**< Events sent to a new client. */

typedef struct {
    const exchange_t *exchange;
    pthread_mutex_t lock;
    pthread_cond_t changed;
    uint32_t clients;
    uint32_t number; /**< Number of the frame; 0: none yet. */
    size_t size;
    char frame[HTTP_STREAM_FRAME_SIZE];
} http_stream_t;

/** One client and what it has been sent. */
typedef struct {
    struct mg_connection *connection;
    uint32_t frame_number;
    uint32_t next_event;
    uint32_t next_act;
    char frame[HTTP_STREAM_FRAME_SIZE];
} http_stream_client_t;

typedef struct {
    exchange_t *exchange;
    http_guard_t guard;
    const tls_front_t *front; /**< How TLS leads here; NULL: it does not. */
    http_guard_t front_guard; /**< Guard of the listener that it feeds. */
    const char *instance;     /**< Its name. */
    session_store_t sessions;
    http_notes_t notes;
    http_record_t record;
    http_peers_log_t peers_log;
    command_client_t acts;
    saved_store_t positions;
    bool has_key;
    saved_key_t key;        /**< Key of the box. */
    pthread_mutex_t orders; /**< Held by the thread that orders something of igtl. */
    telemetry_identity_t identity;
    telemetry_t telemetry;
    http_stream_t stream;
    struct {
        const char *directory;      /**< Directory of the recorder. */
        uint32_t searches;          /**< How many go on. */
        uint32_t downloads;         /**< The same. */
        pthread_mutex_t lock;       /**< Held by the thread that sets the log's level. */
        exchange_log_level_t level; /**< By "": it was never set. */
    } archive;
} http_server_t;

#endif
