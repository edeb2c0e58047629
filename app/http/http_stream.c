/* SPDX-License-Identifier: Apache-2.0 */
#include "http/http_stream.h"

#include "http/http_act.h"
#include "http/http_door.h"
#include "http/http_reply.h"
#include "http/telemetry_json.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define EVENTS_AT_ONCE 16U
#define SILENCE_S 1
#define WRITES 4U /* For one message, each as long as the server's timeout: then it is gone. */

/* One client and what it has been sent. */
typedef struct {
    struct mg_connection *connection;
    uint32_t frame_number;
    uint32_t next_event;
    uint32_t next_act;
    char frame[HTTP_STREAM_FRAME_SIZE];
} client_t;

void http_stream_init(http_stream_t *self, const exchange_t *exchange)
{
    (void)memset(self, 0, sizeof *self);
    self->exchange = exchange;
    (void)pthread_mutex_init(&self->lock, NULL);
    pthread_condattr_t attributes;
    (void)pthread_condattr_init(&attributes);
    (void)pthread_condattr_setclock(&attributes, CLOCK_MONOTONIC);
    (void)pthread_cond_init(&self->changed, &attributes);
}

bool http_stream_is_watched(http_stream_t *self)
{
    (void)pthread_mutex_lock(&self->lock);
    bool is_watched = self->clients > 0U;
    (void)pthread_mutex_unlock(&self->lock);
    return is_watched;
}

bool http_stream_publish(http_stream_t *self, const char *state)
{
    (void)pthread_mutex_lock(&self->lock);
    int size = snprintf(self->frame, sizeof self->frame, "event: state\ndata: %s\n\n", state);
    bool is_whole = (size > 0) && ((size_t)size < sizeof self->frame);
    if (is_whole) {
        self->size = (size_t)size;
        self->number++;
        (void)pthread_cond_broadcast(&self->changed);
    }
    (void)pthread_mutex_unlock(&self->lock);
    return is_whole;
}

static bool write_text(const client_t *client, const char *text, size_t size)
{
    size_t sent = 0U;
    for (uint32_t i = 0U; (i < WRITES) && (sent < size); i++) {
        int count = mg_write(client->connection, &text[sent], size - sent);
        sent += (count > 0) ? (size_t)count : 0U;
    }
    return sent == size;
}

/* Waits, not for ever, for a frame new to the client. Returns its size; 0: there is none. */
static size_t wait_for_frame(http_stream_t *self, client_t *client)
{
    struct timespec until;
    (void)clock_gettime(CLOCK_MONOTONIC, &until);
    until.tv_sec += SILENCE_S;
    size_t size = 0U;
    int result = 0;
    (void)pthread_mutex_lock(&self->lock);
    while ((client->frame_number == self->number) && (result == 0)) {
        result = pthread_cond_timedwait(&self->changed, &self->lock, &until);
    }
    if (client->frame_number != self->number) {
        client->frame_number = self->number;
        size = self->size;
        (void)memcpy(client->frame, self->frame, size);
    }
    (void)pthread_mutex_unlock(&self->lock);
    return size;
}

static bool send_frame(const client_t *client, size_t size)
{
    static const char nothing_new[] = ": nothing new\n\n";
    return (size > 0U) ? write_text(client, client->frame, size)
                       : write_text(client, nothing_new, sizeof nothing_new - 1U);
}

static bool send_event(const client_t *client, const exchange_t *exchange,
                       const exchange_event_t *event)
{
    log_entry_t told;
    char json[1024];
    char message[1100];
    log_entry_make(&told, exchange, event);
    cJSON *entry = telemetry_json_event(exchange_robot(exchange), &told);
    bool is_whole = cJSON_PrintPreallocated(entry, json, (int)sizeof json, 0) != 0;
    cJSON_Delete(entry);
    int size = snprintf(message, sizeof message, "event: log\nid: %u\ndata: %s\n\n",
                        (unsigned)event->event.number, is_whole ? json : "{}");
    return is_whole && write_text(client, message, (size_t)size);
}

static bool send_events(const http_stream_t *self, client_t *client)
{
    exchange_event_t events[EVENTS_AT_ONCE];
    uint32_t lost = 0U;
    uint32_t count;
    do {
        count = exchange_read_events(self->exchange, &client->next_event, events, EVENTS_AT_ONCE,
                                     &lost);
        for (uint32_t i = 0U; i < count; i++) {
            if (!send_event(client, self->exchange, &events[i])) {
                return false;
            }
        }
    } while (count == EVENTS_AT_ONCE);
    return true;
}

static bool send_act(http_server_t *server, const client_t *client, const act_news_t *news)
{
    char json[512];
    char message[600];
    cJSON *act =
        http_act_tell(exchange_robot(server->exchange), news->page, news->id, &news->answer);
    const bool is_whole = cJSON_PrintPreallocated(act, json, (int)sizeof json, 0) != 0;
    cJSON_Delete(act);
    const int size = snprintf(message, sizeof message, "event: act\ndata: %s\n\n", json);
    return is_whole && write_text(client, message, (size_t)size);
}

static bool send_acts(http_server_t *server, client_t *client)
{
    act_news_t news;
    bool is_there = true;
    while (is_there && act_desk_read_news(&server->acts, &client->next_act, &news)) {
        is_there = send_act(server, client, &news);
    }
    return is_there;
}

static bool send_hello(client_t *client, const char *hello)
{
    int size = snprintf(client->frame, sizeof client->frame, "event: hello\ndata: %s\n\n", hello);
    return write_text(client, client->frame, (size_t)size);
}

static void converse(http_stream_t *self, client_t *client, const char *hello)
{
    http_server_t *server = mg_get_user_data(mg_get_context(client->connection));
    client->next_act = act_desk_news(&server->acts);
    bool is_there = send_hello(client, hello);
    while (is_there && http_door_is_open(server, client->connection)) {
        is_there = send_events(self, client) && send_acts(server, client) &&
                   send_frame(client, wait_for_frame(self, client));
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
    client_t *client = calloc(1U, sizeof *client);
    if ((client != NULL) && (http_reply_send(connection, &head) != 0) &&
        !http_reply_is_head_asked(connection)) {
        client->connection = connection;
        client->next_event = next_event;
        converse(self, client, hello);
    }
    free(client);
    leave(self);
    return head.status;
}
