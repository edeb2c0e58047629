/* SPDX-License-Identifier: Apache-2.0 */
#include "http/stop/stop_client.h"

#include "common/clock.h"
#include "http/gate/http_handover.h"
#include "http/gate/http_head.h"

#include <errno.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#define ANSWER_CLOCK_US                                                                            \
    2000000U /* A client may take so long for its request, and for its answer. */

static void dismiss(stop_client_t *self)
{
    (void)close(self->socket);
    self->socket = -1;
}

/* The kernel takes so few bytes at once, or the client is gone. */
static void send_reply(stop_client_t *self, const http_reply_t *reply)
{
    char text[HTTP_REPLY_HEAD_SIZE + HTTP_PROBLEM_SIZE];
    const bool is_elsewhere = !self->gate->is_console && (self->request.origin[0] != '\0');
    http_reply_t sent = *reply;
    sent.cache = HTTP_REPLY_NO_STORE;
    sent.origin = is_elsewhere ? self->request.origin : NULL;
    const size_t size = http_head_write(&sent, text);
    (void)memcpy(&text[size], reply->body, reply->size);
    (void)send(self->socket, text, size + reply->size, MSG_NOSIGNAL | MSG_DONTWAIT);
    (void)shutdown(self->socket, SHUT_WR);
    self->state = STOP_CLIENT_LEAVES;
    self->since_us = clock_monotonic_us();
}

static void answer(stop_client_t *self, const char *json)
{
    const http_reply_t reply = {
        .status = 200, .type = HTTP_REPLY_JSON, .body = json, .size = strlen(json)};
    send_reply(self, &reply);
}

static void refuse(stop_client_t *self, const http_problem_t *problem)
{
    char json[HTTP_PROBLEM_SIZE];
    const http_reply_t reply = {.status = problem->http,
                                .type = HTTP_REPLY_PROBLEM,
                                .allow = (problem->http == 405) ? "POST" : NULL,
                                .body = json,
                                .size = http_problem_write(problem, json)};
    send_reply(self, &reply);
}

static void refuse_as(stop_client_t *self, problem_t problem)
{
    const http_problem_t reported = http_problem_of(problem);
    refuse(self, &reported);
}

/* The body decides between STOP and EMERGENCY, so a stop is not obeyed without it. */
static void report_to_go_on(stop_client_t *self)
{
    if (self->request.is_held && !self->is_reported) {
        (void)send(self->socket, HTTP_REPLY_GO_ON, sizeof HTTP_REPLY_GO_ON - 1U,
                   MSG_NOSIGNAL | MSG_DONTWAIT);
        self->is_reported = true;
    }
}

static void ask(stop_client_t *self, exchange_t *exchange)
{
    self->question = stop_command_ask(exchange, self->request.workphase);
    self->state = STOP_CLIENT_WAITS;
}

static void take_request(stop_client_t *self, exchange_t *exchange)
{
    self->request = stop_request_read(&self->gate->guard, self->bytes, self->size);
    const stop_request_t *request = &self->request;
    if (!request->is_whole) {
        report_to_go_on(self);
        return;
    }
    if (!request->is_refused) {
        ask(self, exchange);
    } else if (request->body.fault != REQUEST_OK) {
        const http_problem_t problem = http_problem_of_body(&request->body);
        refuse(self, &problem);
    } else {
        refuse_as(self, request->problem);
    }
}

/* Returns the number of bytes that have come, 0: none. */
static size_t receive(stop_client_t *self, char *place, size_t room, int flags)
{
    const ssize_t count = recv(self->socket, place, room, MSG_DONTWAIT | flags);
    if ((count == 0) || ((count < 0) && (errno != EAGAIN))) {
        dismiss(self);
    }
    return (count > 0) ? (size_t)count : 0U;
}

static void throw_away(stop_client_t *self)
{
    char waste[STOP_REQUEST_SIZE];
    (void)receive(self, waste, sizeof waste, 0);
}

/* It is heard when so many bytes are there, or no more will come. */
static void await(const stop_client_t *self, size_t bytes)
{
    const int least = (int)bytes;
    (void)setsockopt(self->socket, SOL_SOCKET, SO_RCVLOWAT, &least, sizeof least);
}

static void give_to_library(stop_client_t *self)
{
    await(self, 1U);
    http_handover_give(self->socket);
    self->socket = -1;
}

static bool may_be_stop(const stop_client_t *self)
{
    static const char line[] = "POST /api/v1/stop HTTP/1.";
    const size_t most = sizeof line - 1U;
    return memcmp(self->bytes, line, (self->size < most) ? self->size : most) == 0;
}

static void look_at_request(stop_client_t *self, exchange_t *exchange)
{
    const size_t before = self->size;
    const size_t size = receive(self, self->bytes, STOP_REQUEST_SIZE, MSG_PEEK);
    if (size == 0U) {
        return;
    }
    self->size = size;
    if ((size == before) || !may_be_stop(self)) {
        give_to_library(self);
        return;
    }
    self->request = stop_request_read(&self->gate->guard, self->bytes, size);
    if (!self->request.is_whole) {
        report_to_go_on(self);
        await(self, size + 1U);
    } else if (self->request.is_refused) {
        give_to_library(self);
    } else {
        throw_away(self);
        ask(self, exchange);
    }
}

void stop_client_hear(stop_client_t *self, exchange_t *exchange)
{
    if (self->state != STOP_CLIENT_READS) {
        throw_away(self);
    } else if (self->gate->is_console) {
        look_at_request(self, exchange);
    } else {
        const size_t room = STOP_REQUEST_SIZE - self->size;
        const size_t count = receive(self, &self->bytes[self->size], room, 0);
        self->size += count;
        if (count > 0U) {
            take_request(self, exchange);
        }
    }
}

void stop_client_enter(stop_client_t *self, exchange_t *exchange, const gate_t *gate, int socket)
{
    self->socket = socket;
    self->gate = gate;
    self->state = STOP_CLIENT_READS;
    self->since_us = clock_monotonic_us();
    self->size = 0U;
    self->is_reported = false;
    self->request.origin[0] = '\0';
    stop_client_hear(self, exchange);
}

void stop_client_look(stop_client_t *self, exchange_t *exchange)
{
    char json[STOP_COMMAND_JSON_SIZE];
    answer_t found;
    const status_t status = stop_command_look(exchange, &self->question, &found);
    if (status != STATUS_BUSY) {
        const stop_report_t report = stop_command_report(status, &found, json);
        if (report.is_good) {
            answer(self, json);
        } else {
            refuse(self, &report.problem);
        }
    }
}

/* A console's client gets the refusal that the library would send. */
void stop_client_judge_timeout(stop_client_t *self)
{
    if ((clock_monotonic_us() - self->since_us) <= ANSWER_CLOCK_US) {
        return;
    }
    if (self->gate->is_console && (self->state == STOP_CLIENT_READS) && (self->size > 0U)) {
        refuse_as(self, PROBLEM_BAD_REQUEST);
    } else {
        dismiss(self);
    }
}

/* Bytes that are not taken before would reset the connection, and the refusal with it. */
void stop_client_give_way(stop_client_t *self)
{
    if ((self->state == STOP_CLIENT_READS) && (self->size > 0U)) {
        throw_away(self);
    }
    if ((self->socket >= 0) && (self->state == STOP_CLIENT_READS) && (self->size > 0U)) {
        refuse_as(self, PROBLEM_GAVE_WAY);
    }
    if (self->socket >= 0) {
        dismiss(self);
    }
}
