/* SPDX-License-Identifier: Apache-2.0 */
#include "http/call/http_stream.h"

#include "http/call/http_act.h"
#include "http/view/telemetry_json.h"

#include <stdio.h>
#include <string.h>

#define EVENTS_AT_ONCE 16U
#define WRITES 4U /* For one message, each as long as the server's timeout: then it is gone. */

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

static bool write_text(const http_stream_client_t *client, const char *text, size_t size)
{
    size_t sent = 0U;
    for (uint32_t i = 0U; (i < WRITES) && (sent < size); i++) {
        int count = mg_write(client->connection, &text[sent], size - sent);
        sent += (count > 0) ? (size_t)count : 0U;
    }
    return sent == size;
}

bool http_stream_send_frame(const http_stream_client_t *client, size_t size)
{
    static const char nothing_new[] = ": nothing new\n\n";
    return (size > 0U) ? write_text(client, client->frame, size)
                       : write_text(client, nothing_new, sizeof nothing_new - 1U);
}

static bool send_event(const http_stream_client_t *client, const exchange_t *exchange,
                       const exchange_event_t *event)
{
    log_entry_t reported;
    char json[2048]; /* A quote in a text is two bytes. */
    char message[2124];
    log_entry_make(&reported, exchange, event);
    cJSON *entry = telemetry_json_event(exchange_robot(exchange), &reported);
    bool is_whole = cJSON_PrintPreallocated(entry, json, (int)sizeof json, 0) != 0;
    cJSON_Delete(entry);
    int size = snprintf(message, sizeof message, "event: log\nid: %u\ndata: %s\n\n",
                        (unsigned)event->event.number, is_whole ? json : "{}");
    return is_whole && write_text(client, message, (size_t)size);
}

static bool send_events(const http_stream_t *self, http_stream_client_t *client)
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

static bool send_act(http_server_t *server, const http_stream_client_t *client,
                     const act_result_t *news)
{
    char json[512];
    char message[600];
    cJSON *act =
        http_act_report(exchange_robot(server->exchange), news->page, news->id, &news->answer);
    const bool is_whole = cJSON_PrintPreallocated(act, json, (int)sizeof json, 0) != 0;
    cJSON_Delete(act);
    const int size = snprintf(message, sizeof message, "event: act\ndata: %s\n\n", json);
    return is_whole && write_text(client, message, (size_t)size);
}

static bool send_acts(http_server_t *server, http_stream_client_t *client)
{
    act_result_t news;
    bool is_there = true;
    while (is_there && command_client_read_results(&server->acts, &client->next_act, &news)) {
        is_there = send_act(server, client, &news);
    }
    return is_there;
}

bool http_stream_greet(http_stream_client_t *client, http_server_t *server, const char *hello)
{
    client->next_act = command_client_result_count(&server->acts);
    const int size =
        snprintf(client->frame, sizeof client->frame, "event: hello\ndata: %s\n\n", hello);
    return write_text(client, client->frame, (size_t)size);
}

bool http_stream_send_news(http_stream_client_t *client, http_server_t *server)
{
    return send_events(&server->stream, client) && send_acts(server, client);
}

size_t http_stream_take_frame(http_stream_t *self, http_stream_client_t *client)
{
    size_t size = 0U;
    if (client->frame_number != self->number) {
        client->frame_number = self->number;
        size = self->size;
        (void)memcpy(client->frame, self->frame, size);
    }
    return size;
}
