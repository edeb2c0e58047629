/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/workphase/workphase_dialect.h"

#include "charts/authority_chart.h"
#include "igtl/workphase/workphase_answer.h"
#include "igtl/workphase/workphase_peer.h"
#include "igtl/workphase/workphase_queries.h"
#include "igtl/workphase/workphase_progress.h"
#include "igtl/workphase/workphase_receive.h"
#include "igtl/workphase/workphase_notifications.h"
#include "procedure/command_kinds.h"

#include <stddef.h>
#include <string.h>

void workphase_dialect_init(workphase_dialect_t *self, const robot_t *robot, uint32_t first_id)
{
    (void)memset(self, 0, offsetof(workphase_dialect_t, array.items));
    self->robot = robot;
    self->controller = IGTL_NOBODY;
    self->is_new = true;
    igtl_requests_init(&self->requests, first_id, IGTL_REQUESTS_COMMON);
}

void workphase_dialect_connected(void *dialect, uint32_t peer,
                                 const igtl_introduction_t *introduction)
{
    workphase_dialect_t *self = dialect;

    (void)memset(&self->peers[peer], 0, sizeof self->peers[peer]);
    self->peers[peer].outbox = introduction->outbox;
    self->peers[peer].number = introduction->number;
    self->peers[peer].language = introduction->language;
    self->peers[peer].entry_prefix = introduction->entry_prefix;
}

void workphase_dialect_disconnected(void *dialect, uint32_t peer)
{
    workphase_dialect_t *self = dialect;

    self->peers[peer].outbox = NULL;
    if (self->controller == peer) {
        self->controller = IGTL_NOBODY;
    }
    workphase_array_end(&self->array, peer);
    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        igtl_request_t *request = &self->requests.requests[i];

        if ((request->id != 0U) && (request->peer == peer)) {
            request->peer = IGTL_NOBODY;
        }
    }
}

bool workphase_dialect_is_controlled_by(const void *dialect, uint32_t peer)
{
    const workphase_dialect_t *self = dialect;

    return self->controller == peer;
}

bool workphase_dialect_has_order(const void *dialect, uint32_t peer)
{
    return workphase_peer_has_order(dialect, peer);
}

static bool is_held_here(const snapshot_t *shown)
{
    return (shown != NULL) && (shown->authority == (uint32_t)AUTHORITY_STATE_HELD) &&
           (shown->holder == (uint32_t)COMMAND_SOURCE_IGTL);
}

/* The controller decides it; what it shows is a moment old. */
static void look_who_commands(workphase_dialect_t *self, const igtl_moment_t *moment)
{
    if (moment->snapshot == NULL) {
        return;
    }
    self->controller = IGTL_NOBODY;
    for (uint32_t i = 0U; (i < IGTL_SLOTS) && is_held_here(moment->snapshot); i++) {
        if ((self->peers[i].outbox != NULL) &&
            (self->peers[i].number == moment->snapshot->holder_peer)) {
            self->controller = i;
        }
    }
}

static void answer_question(const workphase_dialect_t *self, workphase_peer_t *peer,
                            const igtl_message_t *message, const igtl_moment_t *moment)
{
    const igtl_asker_t asker = {peer->outbox, peer->language, self->robot};

    (void)igtl_questions_receive(&peer->tracking, &asker, message, moment);
}

void workphase_dialect_receive(void *dialect, uint32_t peer, const igtl_message_t *message,
                               const igtl_moment_t *moment)
{
    workphase_dialect_t *self = dialect;

    look_who_commands(self, moment);
    workphase_peer_t *asker = &self->peers[peer];

    switch ((int)message->kind) {
    case IGTL_KIND_STRING:
        workphase_receive_string(self, peer, message, moment);
        break;
    case IGTL_KIND_TRANSFORM:
        workphase_receive_transform(self, peer, message, moment);
        break;
    case IGTL_KIND_ARRAY:
        workphase_receive_array(self, peer, message, moment);
        break;
    case IGTL_KIND_GET_TRANSFORM:
        workphase_peer_send_deferred(asker, moment->now_us, true);
        workphase_queries_transform(asker, message, moment);
        break;
    case IGTL_KIND_GET_STATUS:
        workphase_peer_send_deferred(asker, moment->now_us, true);
        workphase_queries_status(asker, message, moment);
        break;
    case IGTL_KIND_POINT:
    case IGTL_KIND_TRAJECTORY: /* A commanding peer proposes nothing. */
        igtl_send_refusal(asker->outbox, message->name, STATUS_UNKNOWN_COMMAND, moment);
        break;
    default: /* A STATUS is how peers announce themselves. */
        answer_question(self, asker, message, moment);
        break;
    }
}

bool workphase_dialect_answer(workphase_dialect_t *self, const answer_t *answer,
                              const igtl_moment_t *moment)
{
    igtl_request_t *request = igtl_requests_find(&self->requests, answer->id);

    if (request == NULL) {
        return false;
    }
    if (request->peer != IGTL_NOBODY) {
        if (answer->status == (uint32_t)STATUS_BUSY) {
            workphase_peer_forget(&self->peers[request->peer], request->id);
        }
        workphase_answer_send(self, request, answer, moment);
    } else if (request->command.kind == (uint32_t)COMMAND_RELEASE) {
        self->is_new = self->is_new && (answer->status != (uint32_t)STATUS_OK);
    } else {
        /* No peer waits for it. */
    }
    request->is_accepted = true;
    if (answer->is_final != 0U) {
        igtl_requests_end(request);
    }
    return true;
}

static bool is_releasing(const workphase_dialect_t *self)
{
    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        const igtl_request_t *request = &self->requests.requests[i];

        if ((request->id != 0U) && (request->command.kind == (uint32_t)COMMAND_RELEASE)) {
            return true;
        }
    }
    return false;
}

/* Numbers begin anew with each run of this process: of an earlier one everything is given up. */
static void release_lost(workphase_dialect_t *self, const igtl_moment_t *moment)
{
    const bool is_lost = is_held_here(moment->snapshot) && (self->controller == IGTL_NOBODY);
    command_t release = {.kind = (uint32_t)COMMAND_RELEASE};

    if ((self->is_new || is_lost) && !is_releasing(self)) {
        release.peer = self->is_new ? 0U : moment->snapshot->holder_peer;
        (void)igtl_requests_add(&self->requests, IGTL_NOBODY, &release, moment->answer_clock_us);
    }
}

/* Between a command and its answer nothing else is sent; clients of 2021 ask. */
static bool is_streamed(const workphase_dialect_t *self, const igtl_request_t *request)
{
    return (request->id != 0U) && request->is_accepted && (request->peer != IGTL_NOBODY) &&
           (command_kinds_workphase(&request->command) == WORKPHASE_MOVE_TO_TARGET) &&
           (self->peers[request->peer].pending == 0U) &&
           (self->peers[request->peer].language != IGTL_LANGUAGE_BRP_2021);
}

static void stream_position(workphase_dialect_t *self, const igtl_moment_t *moment)
{
    if ((moment->now_us < self->next_position_us) || !igtl_is_moving(moment)) {
        return;
    }
    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        const igtl_request_t *request = &self->requests.requests[i];

        if (is_streamed(self, request)) {
            self->next_position_us = moment->now_us + IGTL_STREAM_US;
            workphase_peer_send_position(&self->peers[request->peer], moment);
        }
    }
}

static void follow_program(workphase_dialect_t *self, const igtl_moment_t *moment)
{
    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        const igtl_request_t *request = &self->requests.requests[i];

        if ((request->id != 0U) && request->is_accepted && (request->peer != IGTL_NOBODY) &&
            (request->command.kind == (uint32_t)COMMAND_RUN_PROGRAM) &&
            (self->peers[request->peer].pending == 0U)) {
            workphase_progress_follow(&self->peers[request->peer], moment);
        }
    }
}

static void send_no_answer(workphase_dialect_t *self, const igtl_request_t *request,
                           const igtl_moment_t *moment)
{
    if (request->peer != IGTL_NOBODY) {
        workphase_answer_send_none(self, request, moment);
    }
}

void workphase_dialect_step(workphase_dialect_t *self, const igtl_moment_t *moment)
{
    const igtl_request_t *overdue = igtl_requests_overdue(&self->requests, moment->answer_clock_us);

    look_who_commands(self, moment);
    release_lost(self, moment);
    while (overdue != NULL) {
        send_no_answer(self, overdue, moment);
        overdue = igtl_requests_overdue(&self->requests, moment->answer_clock_us);
    }
    workphase_receive_go_on(self, moment);
    for (uint32_t i = 0U; i < IGTL_SLOTS; i++) {
        if (self->peers[i].outbox != NULL) {
            workphase_peer_send_deferred(&self->peers[i], moment->now_us, false);
            workphase_receive_step(self, i, moment);
        }
        if ((self->peers[i].outbox != NULL) && (self->peers[i].pending == 0U)) {
            igtl_questions_step(&self->peers[i].tracking, self->peers[i].outbox, moment);
        }
    }
    workphase_notifications_step(self, moment);
    stream_position(self, moment);
    follow_program(self, moment);
}

void workphase_dialect_control_lost(workphase_dialect_t *self, const igtl_moment_t *moment)
{
    bool is_reported = false;

    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        igtl_request_t *request = &self->requests.requests[i];

        is_reported = is_reported || ((request->id != 0U) && (request->peer == self->controller) &&
                                      (request->is_accepted || request->is_overdue));
        if ((request->id != 0U) && request->is_accepted) {
            send_no_answer(self, request, moment);
            igtl_requests_end(request);
        }
    }
    workphase_notifications_control_lost(self, is_reported, moment);
}
