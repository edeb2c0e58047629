/* SPDX-License-Identifier: Apache-2.0 */
#include "http/stop_port.h"

#include "http/http_reply.h"
#include "http/patience.h"
#include "http/stop_desk.h"
#include "http/stop_request.h"
#include "http/telemetry.h"

#include <arpa/inet.h>
#include <errno.h>
#include <netinet/in.h>
#include <poll.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#define PATIENCE_MS 2000U /* A client may take so long for its request, and for its answer. */
#define TURN_MS 100
#define LISTENERS 2U /* The second one is fed by TLS. */

typedef enum {
    CLIENT_READS = 0,
    CLIENT_WAITS = 1, /* For control's answer. */
    CLIENT_LEAVES = 2 /* It was answered; what else it sends is thrown away until it closes. */
} client_state_t;

typedef struct {
    int socket; /* -1: this place is free. */
    client_state_t state;
    uint64_t number; /* In the order of coming. */
    uint64_t since_ms;
    size_t size;
    char bytes[STOP_REQUEST_SIZE + 1U];
    stop_request_t request;
    stop_question_t question;
} client_t;

typedef struct {
    exchange_t *exchange;
    http_guard_t guard;
    int sockets[LISTENERS]; /* -1: none. */
    uint64_t welcomed;
    uint64_t looked_ms;
    client_t clients[STOP_PORT_CLIENTS];
} stop_port_t;

static stop_port_t stop_port;

static void dismiss(client_t *client)
{
    (void)close(client->socket);
    client->socket = -1;
}

/* The kernel takes so few bytes at once, or the client is gone. */
static void send_reply(client_t *client, const http_reply_t *reply)
{
    char text[HTTP_REPLY_HEAD_SIZE + HTTP_PROBLEM_SIZE];
    http_reply_t sent = *reply;
    sent.cache = HTTP_REPLY_NO_STORE;
    sent.origin = (client->request.origin[0] != '\0') ? client->request.origin : NULL;
    const size_t size = http_reply_head(&sent, text);
    (void)memcpy(&text[size], reply->body, reply->size);
    (void)send(client->socket, text, size + reply->size, MSG_NOSIGNAL | MSG_DONTWAIT);
    (void)shutdown(client->socket, SHUT_WR);
    client->state = CLIENT_LEAVES;
    client->since_ms = telemetry_now_ms();
}

static void answer(client_t *client, const char *json)
{
    const http_reply_t reply = {
        .status = 200, .type = HTTP_REPLY_JSON, .body = json, .size = strlen(json)};
    send_reply(client, &reply);
}

static void refuse(client_t *client, const http_problem_t *problem)
{
    char json[HTTP_PROBLEM_SIZE];
    const http_reply_t reply = {.status = problem->http,
                                .type = HTTP_REPLY_PROBLEM,
                                .allow = (problem->http == 405) ? "POST" : NULL,
                                .body = json,
                                .size = http_problem_write(problem, json)};
    send_reply(client, &reply);
}

static void take_request(client_t *client)
{
    client->request = stop_request_read(&stop_port.guard, client->bytes, client->size);
    const stop_request_t *request = &client->request;
    if (!request->is_whole) {
        return;
    }
    if (!request->is_refused) {
        client->question = stop_desk_ask(stop_port.exchange, request->workphase);
        client->state = CLIENT_WAITS;
    } else if (request->body.fault != REQUEST_OK) {
        const http_problem_t problem = http_problem_of_body(&request->body);
        refuse(client, &problem);
    } else {
        const http_problem_t problem = http_problem_of(request->problem);
        refuse(client, &problem);
    }
}

static void listen_to(client_t *client)
{
    char waste[STOP_REQUEST_SIZE];
    const bool is_reading = client->state == CLIENT_READS;
    char *place = is_reading ? &client->bytes[client->size] : waste;
    const size_t room = is_reading ? (STOP_REQUEST_SIZE - client->size) : sizeof waste;
    const ssize_t count = recv(client->socket, place, room, MSG_DONTWAIT);
    if ((count == 0) || ((count < 0) && (errno != EAGAIN))) {
        dismiss(client);
    } else if ((count > 0) && is_reading) {
        client->size += (size_t)count;
        take_request(client);
    } else {
        /* Nothing has come, or nothing that counts. */
    }
}

static void look_for_answer(client_t *client)
{
    char json[STOP_DESK_JSON_SIZE];
    answer_t found;
    const status_t status = stop_desk_look(stop_port.exchange, &client->question, &found);
    if (status != STATUS_BUSY) {
        const stop_report_t report = stop_desk_tell(status, &found, json);
        if (report.is_good) {
            answer(client, json);
        } else {
            refuse(client, &report.problem);
        }
    }
}

/* Who waits for an answer goes last: its stop is on its way, but it would not hear of it. */
static bool is_dearer(const client_t *client, const client_t *other)
{
    const bool is_waiting = client->state == CLIENT_WAITS;
    return (is_waiting != (other->state == CLIENT_WAITS)) ? is_waiting
                                                          : (client->number > other->number);
}

/* A free place, or else the oldest client's. */
static client_t *find_place(void)
{
    client_t *place = &stop_port.clients[0];
    for (size_t i = 0U; i < STOP_PORT_CLIENTS; i++) {
        client_t *client = &stop_port.clients[i];
        if (client->socket < 0) {
            return client;
        }
        place = is_dearer(place, client) ? client : place;
    }
    dismiss(place);
    return place;
}

/* At most half a table at a time: who has just come is heard before its place can be taken. */
static void welcome(int listener)
{
    for (size_t i = 0U; i < (STOP_PORT_CLIENTS / 2U); i++) {
        const int socket = accept4(listener, NULL, NULL, SOCK_NONBLOCK | SOCK_CLOEXEC);
        if (socket < 0) {
            return;
        }
        client_t *client = find_place();
        client->socket = socket;
        client->state = CLIENT_READS;
        client->number = stop_port.welcomed;
        stop_port.welcomed++;
        client->since_ms = telemetry_now_ms();
        client->size = 0U;
        listen_to(client);
    }
}

static void attend(client_t *client, bool is_heard, bool is_look_due)
{
    if (is_heard && (client->state != CLIENT_WAITS)) {
        listen_to(client);
    }
    if ((client->socket >= 0) && (client->state == CLIENT_WAITS) && is_look_due) {
        look_for_answer(client);
    }
    if ((client->socket >= 0) && (client->state != CLIENT_WAITS) &&
        ((telemetry_now_ms() - client->since_ms) > PATIENCE_MS)) {
        dismiss(client);
    }
}

static bool is_anybody_waiting(void)
{
    bool is_waiting = false;
    for (size_t i = 0U; i < STOP_PORT_CLIENTS; i++) {
        is_waiting = is_waiting || ((stop_port.clients[i].socket >= 0) &&
                                    (stop_port.clients[i].state == CLIENT_WAITS));
    }
    return is_waiting;
}

/* poll() passes over negative descriptors. Who waits is not heard: nothing more is due from it. */
static void take_turn(void)
{
    struct pollfd events[STOP_PORT_CLIENTS + LISTENERS];
    for (size_t i = 0U; i < STOP_PORT_CLIENTS; i++) {
        const client_t *client = &stop_port.clients[i];
        events[i].fd = (client->state == CLIENT_WAITS) ? -1 : client->socket;
        events[i].events = POLLIN;
        events[i].revents = 0;
    }
    for (size_t i = 0U; i < LISTENERS; i++) {
        events[STOP_PORT_CLIENTS + i].fd = stop_port.sockets[i];
        events[STOP_PORT_CLIENTS + i].events = POLLIN;
        events[STOP_PORT_CLIENTS + i].revents = 0;
    }
    (void)poll(events, STOP_PORT_CLIENTS + LISTENERS,
               is_anybody_waiting() ? (int)PATIENCE_LOOK_MS : TURN_MS);
    const uint64_t now_ms = telemetry_now_ms();
    const bool is_look_due = (now_ms - stop_port.looked_ms) >= PATIENCE_LOOK_MS;
    stop_port.looked_ms = is_look_due ? now_ms : stop_port.looked_ms;
    for (size_t i = 0U; i < STOP_PORT_CLIENTS; i++) {
        if (stop_port.clients[i].socket >= 0) {
            attend(&stop_port.clients[i], events[i].revents != 0, is_look_due);
        }
    }
    for (size_t i = 0U; i < LISTENERS; i++) {
        if (events[STOP_PORT_CLIENTS + i].revents != 0) {
            welcome(stop_port.sockets[i]);
        }
    }
}

static void *serve(void *unused)
{
    (void)unused;
    for (;;) {
        exchange_note_stop_port(stop_port.exchange, stop_port.guard.port); /* It may be damaged. */
        take_turn();
    }
    return NULL;
}

/* A listening socket on `port`, 0 meaning any; -1 when there is none. */
static int listen_on(const char *address, uint32_t port)
{
    const int yes = 1;
    struct sockaddr_in place = {.sin_family = AF_INET, .sin_port = htons((uint16_t)port)};
    const int end = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    (void)inet_pton(AF_INET, address, &place.sin_addr);
    (void)setsockopt(end, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    if ((end >= 0) && ((bind(end, (const struct sockaddr *)&place, sizeof place) != 0) ||
                       (listen(end, SOMAXCONN) != 0))) {
        (void)close(end);
        return -1;
    }
    return end;
}

static uint32_t port_of(int socket)
{
    struct sockaddr_in place = {.sin_port = 0U};
    socklen_t size = sizeof place;
    (void)getsockname(socket, (struct sockaddr *)&place, &size);
    return ntohs(place.sin_port);
}

uint32_t stop_port_start(exchange_t *exchange, const http_guard_t *console,
                         const tls_front_t *front)
{
    pthread_t thread;
    stop_port.exchange = exchange;
    stop_port.sockets[0] = listen_on(console->address, exchange_stop_port(exchange));
    if (stop_port.sockets[0] < 0) {
        stop_port.sockets[0] = listen_on(console->address, 0U);
    }
    for (size_t i = 0U; i < STOP_PORT_CLIENTS; i++) {
        stop_port.clients[i].socket = -1;
    }
    stop_port.sockets[1] = (front != NULL) ? listen_on("127.0.0.1", front->stop_from) : -1;
    stop_port.guard = *console;
    stop_port.guard.front = front;
    stop_port.guard.front_port = (front != NULL) ? front->stop : 0U;
    stop_port.guard.port = (stop_port.sockets[0] >= 0) ? port_of(stop_port.sockets[0]) : 0U;
    if ((stop_port.sockets[0] >= 0) && (pthread_create(&thread, NULL, serve, NULL) != 0)) {
        (void)close(stop_port.sockets[0]);
        stop_port.guard.port = 0U;
    }
    return stop_port.guard.port;
}
