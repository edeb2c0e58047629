/* SPDX-License-Identifier: Apache-2.0 */
#include "site/served/served_stream.h"

#include "http/call/http_reply.h"
#include "http/call/http_stream.h"
#include "site/served/connection.h"

#include <string.h>

static struct mg_connection connection;
static http_stream_client_t client;
static char sent[SERVED_STREAM_BYTES];

static void open_stream(void *user_data, uint32_t next_event)
{
    (void)memset(&connection, 0, sizeof connection);
    (void)memset(&client, 0, sizeof client);
    connection.user_data = user_data;
    connection.reported = sent;
    connection.room = sizeof sent;
    client.connection = &connection;
    client.next_event = next_event;
}

int http_stream_serve(http_stream_t *self, struct mg_connection *asks, const char *hello,
                      uint32_t next_event)
{
    const http_reply_t head = {.status = 200,
                               .type = "text/event-stream",
                               .cache = HTTP_REPLY_NO_STORE,
                               .is_stream = true};
    http_server_t *const server = mg_get_user_data(mg_get_context(asks));

    (void)http_reply_send(asks, &head);
    open_stream(server, next_event);
    self->clients = http_stream_greet(&client, server, hello) ? 1U : 0U;
    return head.status;
}

void served_stream_go_on(http_server_t *server)
{
    http_stream_t *const stream = &server->stream;

    if (stream->clients > 0U) {
        const bool is_reported = http_stream_send_news(&client, server);
        const bool is_slow = connection.size > (SERVED_STREAM_BYTES / 2U);
        const size_t size = is_slow ? 0U : http_stream_take_frame(stream, &client);
        const bool is_shown = (size == 0U) || http_stream_send_frame(&client, size);
        stream->clients = (is_reported && is_shown) ? 1U : 0U;
    }
}

size_t served_stream_take(char *bytes)
{
    const size_t size = connection.size;

    (void)memcpy(bytes, sent, size);
    connection.size = 0U;
    return size;
}
