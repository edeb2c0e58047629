/* SPDX-License-Identifier: Apache-2.0 */
/** @file The thread of one client of the stream: http_stream_serve(). */
#include "http/call/http_login_gate.h"
#include "http/call/http_reply.h"
#include "http/call/http_context.h"
#include "http/call/http_stream.h"

#include <pthread.h>
#include <stdlib.h>
#include <time.h>

#define SILENCE_S 1

/* Waits, with a bound, for a frame new to the client. Returns its size; 0: none exists. */
static size_t wait_for_frame(http_stream_t *self, http_stream_client_t *client)
{
    struct timespec until;
    (void)clock_gettime(CLOCK_MONOTONIC, &until);
    until.tv_sec += SILENCE_S;
    int result = 0;
    (void)pthread_mutex_lock(&self->lock);
    while ((client->frame_number == self->number) && (result == 0)) {
        result = pthread_cond_timedwait(&self->changed, &self->lock, &until);
    }
    const size_t size = http_stream_take_frame(self, client);
    (void)pthread_mutex_unlock(&self->lock);
    return size;
}

static void send_and_wait(http_stream_t *self, http_stream_client_t *client, const char *hello)
{
    http_server_t *server = mg_get_user_data(mg_get_context(client->connection));
    bool is_there = http_stream_greet(client, server, hello);
    while (is_there && http_login_gate_is_open(server, client->connection)) {
        is_there = http_stream_send_news(client, server) &&
                   http_stream_send_frame(client, wait_for_frame(self, client));
    }
}

static bool enter(http_stream_t *self)
{
    (void)pthread_mutex_lock(&self->lock);
    bool is_room = self->clients < HTTP_STREAM_CLIENTS;
    self->clients += is_room ? 1U : 0U;
    (void)pthread_mutex_unlock(&self->lock);
    return is_room;
}

static void leave(http_stream_t *self)
{
    (void)pthread_mutex_lock(&self->lock);
    self->clients--;
    (void)pthread_mutex_unlock(&self->lock);
}

int http_stream_serve(http_stream_t *self, struct mg_connection *connection, const char *hello,
                      uint32_t next_event)
{
    if (!enter(self)) {
        return http_reply_refuse(connection, PROBLEM_STREAMS_FULL);
    }
    http_reply_t head = {.status = 200,
                         .type = "text/event-stream",
                         .cache = HTTP_REPLY_NO_STORE,
                         .is_stream = true};
    http_stream_client_t *client = calloc(1U, sizeof *client);
    if ((client != NULL) && (http_reply_send(connection, &head) != 0) &&
        !http_reply_is_head_asked(connection)) {
        client->connection = connection;
        client->next_event = next_event;
        send_and_wait(self, client, hello);
    }
    free(client);
    leave(self);
    return head.status;
}
