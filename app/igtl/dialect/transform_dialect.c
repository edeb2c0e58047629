/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/dialect/transform_dialect.h"

#include "igtl/dialect/igtl_units.h"
#include "igtl/dialect/transform_view.h"
#include "interface/app/names.h"

#include <stddef.h>
#include <string.h>

#define TRAJECTORY_POINTS 2U   /* Its entry and its target. */
#define PROPOSALS_AT_A_TIME 4U /* A flood of them leaves room for commands in the exchange. */

void transform_dialect_init(transform_dialect_t *self, const robot_t *robot, uint32_t first_id)
{
    (void)memset(self, 0, sizeof *self);
    self->robot = robot;
    igtl_requests_init(&self->requests, first_id, PROPOSALS_AT_A_TIME);
}

void transform_dialect_connected(void *dialect, uint32_t peer,
                                 const igtl_introduction_t *introduction)
{
    transform_dialect_t *self = dialect;

    (void)memset(&self->peers[peer], 0, sizeof self->peers[peer]);
    self->peers[peer].outbox = introduction->outbox;
    self->peers[peer].number = introduction->number;
    transform_show_all(&self->peers[peer].shown);
}

void transform_dialect_disconnected(void *dialect, uint32_t peer)
{
    transform_dialect_t *self = dialect;

    self->peers[peer].outbox = NULL;
    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        if (self->requests.requests[i].peer == peer) {
            self->requests.requests[i].peer = IGTL_NOBODY;
        }
    }
}

/* The newest of its subject; on its way at once if its peer was not too fast. */
static void put(transform_dialect_t *self, uint32_t peer, const command_t *command,
                const igtl_moment_t *moment)
{
    transform_proposals_put(&self->peers[peer].proposals, command, moment);
    transform_proposals_pass(&self->peers[peer].proposals, &self->requests, peer, moment);
}

/* Where `name` is remembered, else the place of the oldest. */
static transform_refused_t *refused_of(transform_peer_t *peer, const char *name)
{
    transform_refused_t *oldest = &peer->refused[0];

    for (uint32_t i = 0U; i < LIMIT_IGTL_UNKNOWN_NAMES; i++) {
        if (strcmp(peer->refused[i].name, name) == 0) {
            return &peer->refused[i];
        }
        if (peer->refused[i].next_us < oldest->next_us) {
            oldest = &peer->refused[i];
        }
    }
    (void)memset(oldest, 0, sizeof *oldest);
    (void)memcpy(oldest->name, name, strlen(name));
    return oldest;
}

/* Slicer streams every node under its connector: unknown ones are refused, but not each time. */
static void refuse_unknown(transform_peer_t *peer, const igtl_message_t *message,
                           const igtl_moment_t *moment)
{
    transform_refused_t *refused = refused_of(peer, message->name);

    if (moment->now_us >= refused->next_us) {
        refused->next_us = moment->now_us + LIMIT_IGTL_UNKNOWN_US;
        igtl_send_refusal(peer->outbox, message->name, STATUS_UNKNOWN_COMMAND, moment);
    }
}

/* A proposal that is refused immediately leaves the waiting one of its subject alone. */
static void propose(transform_dialect_t *self, uint32_t index, const igtl_message_t *message,
                    const igtl_moment_t *moment)
{
    transform_peer_t *peer = &self->peers[index];
    command_t command = {.peer = peer->number,
                         .kind = (uint32_t)transform_proposals_kind(message->name)};
    status_t status;

    if (command.kind == (uint32_t)COMMAND_NONE) {
        refuse_unknown(peer, message, moment);
        return;
    }
    status = igtl_units_read_pose(message->numbers, &command.as.seen_pose.pose);
    if (status == STATUS_OK) {
        put(self, index, &command, moment);
    } else {
        igtl_send_refusal(peer->outbox, message->name, status, moment);
        peer->shown.must_send_measured = true;
    }
}

/* Meaning of a TRAJ as proposals. The numbers of a point that is not meant are not read. */
static status_t read_trajectory(const igtl_message_t *message, uint32_t peer,
                                command_t proposals[TRAJECTORY_POINTS], uint32_t *count)
{
    static const command_kind_t kinds[TRAJECTORY_POINTS] = {COMMAND_PROPOSE_ENTRY,
                                                            COMMAND_PROPOSE_TARGET};
    const bool is_known = (message->code >= (uint32_t)IGTL_TRAJECTORY_ENTRY) &&
                          (message->code <= (uint32_t)IGTL_TRAJECTORY_BOTH);
    status_t status = is_known ? STATUS_OK : STATUS_OUT_OF_RANGE;

    *count = 0U;
    for (uint32_t i = 0U; (i < TRAJECTORY_POINTS) && (status == STATUS_OK); i++) {
        if ((message->code & ((uint32_t)IGTL_TRAJECTORY_ENTRY << i)) != 0U) {
            command_t *proposal = &proposals[*count];

            *proposal = (command_t){.peer = peer, .kind = (uint32_t)kinds[i]};
            rigid_set_identity(&proposal->as.seen_pose.pose);
            status = igtl_units_read_point(&message->numbers[3U * i],
                                           &proposal->as.seen_pose.pose.translation);
            (*count)++;
        }
    }
    return status;
}

/* All of its points or none. */
static void propose_trajectory(transform_dialect_t *self, uint32_t index,
                               const igtl_message_t *message, const igtl_moment_t *moment)
{
    transform_peer_t *peer = &self->peers[index];
    command_t proposals[TRAJECTORY_POINTS];
    uint32_t count;
    const status_t status = read_trajectory(message, peer->number, proposals, &count);

    if (status != STATUS_OK) {
        igtl_send_refusal(peer->outbox, message->name, status, moment);
        peer->shown.must_send_measured = true;
        return;
    }
    for (uint32_t i = 0U; i < count; i++) {
        put(self, index, &proposals[i], moment);
    }
}

static void receive_string(transform_dialect_t *self, uint32_t index, const igtl_message_t *message,
                           const igtl_moment_t *moment)
{
    transform_peer_t *peer = &self->peers[index];
    const command_t withdrawal = {
        .peer = peer->number,
        .kind = (uint32_t)COMMAND_WITHDRAW,
        .as.withdrawal = {.of = (uint32_t)transform_proposals_kind(message->name)}};

    if ((strcmp(message->name, "start_up") == 0) || igtl_is_text(message, "START_UP")) {
        transform_show_all(&peer->shown);
    } else if (withdrawal.as.withdrawal.of == (uint32_t)COMMAND_NONE) {
        refuse_unknown(peer, message, moment);
    } else if (igtl_is_text(message, "WITHDRAW")) {
        put(self, index, &withdrawal, moment);
    } else {
        igtl_send_refusal(peer->outbox, message->name, STATUS_UNKNOWN_COMMAND, moment);
    }
}

static void answer_question(transform_dialect_t *self, transform_peer_t *sender,
                            const igtl_message_t *message, const igtl_moment_t *moment)
{
    const igtl_asker_t asker = {sender->outbox, IGTL_LANGUAGE_CRTK, self->robot};

    (void)igtl_questions_receive(&sender->tracking, &asker, message, moment);
}

void transform_dialect_receive(void *dialect, uint32_t peer, const igtl_message_t *message,
                               const igtl_moment_t *moment)
{
    transform_dialect_t *self = dialect;
    transform_peer_t *sender = &self->peers[peer];

    switch ((int)message->kind) {
    case IGTL_KIND_TRANSFORM:
        propose(self, peer, message, moment);
        break;
    case IGTL_KIND_TRAJECTORY:
        propose_trajectory(self, peer, message, moment);
        break;
    case IGTL_KIND_STRING:
        receive_string(self, peer, message, moment);
        break;
    case IGTL_KIND_GET_TRANSFORM:
    case IGTL_KIND_GET_STATUS:
    case IGTL_KIND_GET_POINT:
        transform_show_answer(sender->outbox, message, moment);
        break;
    case IGTL_KIND_POINT:
    case IGTL_KIND_ARRAY:
        refuse_unknown(sender, message, moment);
        break;
    default: /* A STATUS is how peers announce themselves. */
        answer_question(self, sender, message, moment);
        break;
    }
}

static void send_refused(transform_dialect_t *self, const igtl_request_t *request,
                         const answer_t *answer, const igtl_moment_t *moment)
{
    char text[IGTL_REASON_SIZE];
    const igtl_status_t refused = {igtl_reason_code((status_t)answer->status),
                                   status_name((int32_t)answer->status), text};

    igtl_reason_text(self->robot, answer, moment, text);
    igtl_send_status(self->peers[request->peer].outbox, transform_proposals_name(&request->command),
                     &refused, moment);
}

bool transform_dialect_answer(transform_dialect_t *self, const answer_t *answer,
                              const igtl_moment_t *moment)
{
    igtl_request_t *request = igtl_requests_find(&self->requests, answer->id);

    if (request == NULL) {
        return false;
    }
    if (request->peer != IGTL_NOBODY) {
        self->peers[request->peer].shown.must_send_measured = true;
        if (answer->kind == (uint32_t)ANSWER_REFUSED) {
            send_refused(self, request, answer, moment);
        }
    }
    igtl_requests_end(request);
    return true;
}

/* Those that control did not answer. */
static void send_overdue(transform_dialect_t *self, const igtl_moment_t *moment)
{
    const igtl_request_t *overdue = igtl_requests_overdue(&self->requests, moment->answer_clock_us);

    while (overdue != NULL) {
        if (overdue->peer != IGTL_NOBODY) {
            igtl_send_refusal(self->peers[overdue->peer].outbox,
                              transform_proposals_name(&overdue->command), STATUS_NO_ANSWER,
                              moment);
        }
        overdue = igtl_requests_overdue(&self->requests, moment->answer_clock_us);
    }
}

static void pass_proposals(transform_dialect_t *self, uint32_t peer, const igtl_moment_t *moment)
{
    transform_proposals_t *proposals = &self->peers[peer].proposals;
    const char *overdue;

    transform_proposals_pass(proposals, &self->requests, peer, moment);
    overdue = transform_proposals_overdue(proposals, moment);
    while (overdue != NULL) {
        igtl_send_refusal(self->peers[peer].outbox, overdue, STATUS_NO_ANSWER, moment);
        overdue = transform_proposals_overdue(proposals, moment);
    }
}

void transform_dialect_step(transform_dialect_t *self, const igtl_moment_t *moment)
{
    transform_view_t view;

    send_overdue(self, moment);
    if (moment->snapshot != NULL) {
        transform_view_take(&view, moment->snapshot);
    }
    for (uint32_t i = 0U; i < IGTL_SLOTS; i++) {
        transform_peer_t *peer = &self->peers[i];

        if (peer->outbox != NULL) {
            pass_proposals(self, i, moment);
            igtl_questions_step(&peer->tracking, peer->outbox, moment);
        }
        if ((peer->outbox != NULL) && (moment->snapshot != NULL)) {
            transform_show_step(&peer->shown, self->robot, peer->outbox, &view, moment);
        } else if (peer->outbox != NULL) {
            transform_show_silence(&peer->shown, peer->outbox, moment);
        } else {
            /* Not connected. */
        }
    }
}
