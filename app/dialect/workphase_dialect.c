/* SPDX-License-Identifier: Apache-2.0 */
#include "dialect/workphase_dialect.h"

#include "dialect/igtl_border.h"
#include "dialect/workphase_answer.h"
#include "dialect/workphase_peer.h"
#include "dialect/workphase_poll.h"
#include "interface/app/names.h"

#include <stddef.h>
#include <string.h>

void workphase_dialect_init(workphase_dialect_t *self, const robot_t *robot, uint32_t first_id)
{
    (void)memset(self, 0, sizeof *self);
    self->robot = robot;
    self->controller = IGTL_NOBODY;
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

static bool is_long(const igtl_request_t *request)
{
    return (request->kind == (uint32_t)COMMAND_WORKPHASE) &&
           ((request->argument == (uint32_t)WORKPHASE_START_UP) ||
            (request->argument == (uint32_t)WORKPHASE_MOVE_TO_TARGET));
}

void workphase_dialect_disconnected(void *dialect, uint32_t peer)
{
    workphase_dialect_t *self = dialect;

    self->peers[peer].outbox = NULL;
    if (self->controller == peer) {
        self->controller = IGTL_NOBODY;
    }
    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        igtl_request_t *request = &self->requests.requests[i];

        if ((request->id != 0U) && (request->peer == peer)) {
            request->peer = IGTL_NOBODY;
            self->must_stop = self->must_stop || is_long(request);
        }
    }
}

bool workphase_dialect_is_controlled_by(const void *dialect, uint32_t peer)
{
    const workphase_dialect_t *self = dialect;

    return self->controller == peer;
}

static bool may_command(workphase_dialect_t *self, uint32_t peer)
{
    if (self->controller == IGTL_NOBODY) {
        self->controller = peer;
    }
    return self->controller == peer;
}

static void deny(workphase_peer_t *peer, const char *name, const igtl_moment_t *moment)
{
    const igtl_status_t denial = {IGTL_STATUS_ACCESS_DENIED, "ACCESS_DENIED",
                                  "ACCESS_DENIED: Another connection controls the robot."};

    igtl_tell_status(peer->outbox, name, &denial, moment);
}

/* The workphase named by a text, WORKPHASE_UNDEFINED for none that can be commanded. */
static workphase_t phase_of(const igtl_message_t *message)
{
    for (uint32_t i = (uint32_t)WORKPHASE_START_UP; i < WORKPHASE_COUNT; i++) {
        const char *name = workphase_name((int32_t)i);

        if ((strlen(name) == message->text_bytes) &&
            (memcmp(name, message->text, message->text_bytes) == 0)) {
            return (workphase_t)i;
        }
    }
    return WORKPHASE_UNDEFINED;
}

static void refuse_text(workphase_peer_t *peer, const igtl_message_t *message,
                        const igtl_moment_t *moment)
{
    char name[IGTL_NAME_SIZE] = "";
    const uint32_t length =
        (message->text_bytes < (IGTL_NAME_SIZE - 1U)) ? message->text_bytes : (IGTL_NAME_SIZE - 1U);

    (void)memcpy(name, message->text, length);
    igtl_tell_refusal(peer->outbox, (length > 0U) ? name : message->name, STATUS_UNKNOWN_COMMAND,
                      moment);
}

/* `id` is what was remembered of it, NULL for nothing. */
static void request_phase(workphase_dialect_t *self, uint32_t peer, workphase_t phase,
                          workphase_id_t *id, const igtl_moment_t *moment)
{
    command_t command = {.peer = self->peers[peer].number,
                         .kind = (uint32_t)COMMAND_WORKPHASE,
                         .argument = (uint32_t)phase};
    const igtl_request_t *request =
        igtl_requests_add(&self->requests, peer, &command, moment->patience_us);

    if (id != NULL) {
        id->request = (request == NULL) ? 0U : request->id;
        id->name[0] = (request == NULL) ? '\0' : id->name[0];
    }
    if (request == NULL) {
        igtl_tell_refusal(self->peers[peer].outbox, workphase_name((int32_t)phase), STATUS_BUSY,
                          moment);
    } else {
        self->peers[peer].last_request = request->id;
    }
}

static void receive_command(workphase_dialect_t *self, uint32_t index,
                            const igtl_message_t *message, const igtl_moment_t *moment)
{
    workphase_peer_t *peer = &self->peers[index];
    const workphase_t phase = phase_of(message);
    const bool is_urgent = (phase == WORKPHASE_STOP) || (phase == WORKPHASE_EMERGENCY);
    workphase_id_t *id = NULL;

    workphase_peer_acknowledge_string(peer, message, moment);
    if (!is_urgent) {
        if (workphase_peer_is_repeated(peer, message)) {
            return;
        }
        id = workphase_peer_remember(peer, message);
    }
    if (workphase_poll_string(peer, message, moment)) {
        return;
    }
    workphase_peer_cancel_deferred(peer);
    if (phase == WORKPHASE_UNDEFINED) {
        refuse_text(peer, message, moment);
    } else if (!is_urgent && !may_command(self, index)) {
        deny(peer, workphase_name((int32_t)phase), moment);
    } else {
        request_phase(self, index, phase, id, moment);
    }
}

static void receive_pose(workphase_dialect_t *self, uint32_t index, const igtl_message_t *message,
                         const igtl_moment_t *moment)
{
    workphase_peer_t *peer = &self->peers[index];
    const bool is_registration = (strncmp(message->name, "CLB_", 4U) == 0);
    const char *name = is_registration ? "CALIBRATION" : "TARGET";
    command_t command = {.peer = peer->number,
                         .kind =
                             (uint32_t)(is_registration ? COMMAND_REGISTRATION : COMMAND_TARGET)};
    status_t status;

    workphase_peer_cancel_deferred(peer);
    workphase_peer_acknowledge_transform(peer, message, moment);
    if (!may_command(self, index)) {
        deny(peer, name, moment);
        return;
    }
    status = igtl_border_read_pose(message->numbers, &command.pose);
    if ((status == STATUS_OK) &&
        (igtl_requests_add(&self->requests, index, &command, moment->patience_us) == NULL)) {
        status = STATUS_BUSY;
    }
    if (status != STATUS_OK) {
        igtl_tell_refusal(peer->outbox, name, status, moment);
    }
}

static void receive_string(workphase_dialect_t *self, uint32_t index, const igtl_message_t *message,
                           const igtl_moment_t *moment)
{
    workphase_peer_t *peer = &self->peers[index];

    if (strncmp(message->name, "CMD_", 4U) == 0) {
        receive_command(self, index, message, moment);
        return;
    }
    workphase_peer_send_deferred(peer, moment->now_us, true);
    if (!workphase_poll_string(peer, message, moment)) {
        igtl_tell_refusal(peer->outbox, message->name, STATUS_UNKNOWN_COMMAND, moment);
    }
}

void workphase_dialect_receive(void *dialect, uint32_t peer, const igtl_message_t *message,
                               const igtl_moment_t *moment)
{
    workphase_dialect_t *self = dialect;

    workphase_peer_t *asker = &self->peers[peer];

    switch (message->kind) {
    case IGTL_KIND_STRING:
        receive_string(self, peer, message, moment);
        break;
    case IGTL_KIND_TRANSFORM:
        if ((strncmp(message->name, "CLB_", 4U) == 0) ||
            (strncmp(message->name, "TGT_", 4U) == 0)) {
            receive_pose(self, peer, message, moment);
        } else {
            igtl_tell_refusal(asker->outbox, message->name, STATUS_UNKNOWN_COMMAND, moment);
        }
        break;
    case IGTL_KIND_GET_TRANSFORM:
        workphase_peer_send_deferred(asker, moment->now_us, true);
        workphase_poll_transform(asker, message, moment);
        break;
    case IGTL_KIND_GET_STATUS:
        workphase_peer_send_deferred(asker, moment->now_us, true);
        workphase_poll_status(asker, message, moment);
        break;
    case IGTL_KIND_POINT:
        igtl_tell_refusal(asker->outbox, message->name, STATUS_UNKNOWN_COMMAND, moment);
        break;
    case IGTL_KIND_STATUS: /* Peers announce themselves with one. */
    case IGTL_KIND_GET_POINT:
    case IGTL_KIND_GET_CAPABILITY:
    case IGTL_KIND_GET_OTHER:
    case IGTL_KIND_STT_TDATA:
    case IGTL_KIND_STP_TDATA:
    case IGTL_KIND_STT_OTHER:
    case IGTL_KIND_STP_OTHER:
    case IGTL_KIND_COMMAND:
    case IGTL_KIND_OTHER:
    default:
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
        workphase_answer_tell(self, request, answer, moment);
    } else if ((answer->status == (uint32_t)STATUS_BUSY) &&
               (request->argument == (uint32_t)WORKPHASE_STOP)) {
        self->must_stop = true;
    }
    request->is_accepted = true;
    if (answer->is_final != 0U) {
        igtl_requests_end(request);
    }
    return true;
}

/* Nobody is told: the peer that would be has gone. */
static void stop_for_lost_peer(workphase_dialect_t *self, uint64_t patience_us)
{
    command_t stop = {.kind = (uint32_t)COMMAND_WORKPHASE, .argument = (uint32_t)WORKPHASE_STOP};

    if (self->must_stop &&
        (igtl_requests_add(&self->requests, IGTL_NOBODY, &stop, patience_us) != NULL)) {
        self->must_stop = false;
    }
}

static bool has_unanswered_phase(const workphase_dialect_t *self, uint32_t peer)
{
    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        const igtl_request_t *request = &self->requests.requests[i];

        if ((request->id != 0U) && (request->peer == peer) && !request->is_accepted &&
            (request->kind == (uint32_t)COMMAND_WORKPHASE)) {
            return true;
        }
    }
    return false;
}

/* Between a command and its answer nothing else is sent. */
static void stream_position(workphase_dialect_t *self, const igtl_moment_t *moment)
{
    if ((moment->now_us < self->next_position_us) || !igtl_is_moving(moment)) {
        return;
    }
    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        const igtl_request_t *request = &self->requests.requests[i];

        if ((request->id != 0U) && request->is_accepted && (request->peer != IGTL_NOBODY) &&
            (request->argument == (uint32_t)WORKPHASE_MOVE_TO_TARGET) &&
            !has_unanswered_phase(self, request->peer)) {
            self->next_position_us = moment->now_us + IGTL_STREAM_US;
            workphase_peer_tell_position(&self->peers[request->peer], moment);
        }
    }
}

static const char *subject_of(const igtl_request_t *request)
{
    switch (request->kind) {
    case COMMAND_REGISTRATION:
        return "CALIBRATION";
    case COMMAND_TARGET:
        return "TARGET";
    default:
        return workphase_name((int32_t)request->argument);
    }
}

static void tell_no_answer(workphase_dialect_t *self, const igtl_request_t *request,
                           const igtl_moment_t *moment)
{
    if (request->peer != IGTL_NOBODY) {
        igtl_tell_refusal(self->peers[request->peer].outbox, subject_of(request), STATUS_NO_ANSWER,
                          moment);
    }
}

void workphase_dialect_step(workphase_dialect_t *self, const igtl_moment_t *moment)
{
    const igtl_request_t *overdue = igtl_requests_overdue(&self->requests, moment->patience_us);

    stop_for_lost_peer(self, moment->patience_us);
    while (overdue != NULL) {
        tell_no_answer(self, overdue, moment);
        overdue = igtl_requests_overdue(&self->requests, moment->patience_us);
    }
    for (uint32_t i = 0U; i < IGTL_PLACES; i++) {
        if (self->peers[i].outbox != NULL) {
            workphase_peer_send_deferred(&self->peers[i], moment->now_us, false);
        }
    }
    stream_position(self, moment);
}

void workphase_dialect_control_lost(workphase_dialect_t *self, const igtl_moment_t *moment)
{
    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        igtl_request_t *request = &self->requests.requests[i];

        if ((request->id != 0U) && request->is_accepted) {
            tell_no_answer(self, request, moment);
            igtl_requests_end(request);
        }
    }
}
