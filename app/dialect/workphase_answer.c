/* SPDX-License-Identifier: Apache-2.0 */
#include "dialect/workphase_answer.h"

#include "dialect/workphase_peer.h"
#include "interface/app/names.h"

#include <stddef.h>

/* Entering these has a STATUS since 2021 only. */
static bool is_entered_silently(uint32_t phase)
{
    return (phase == (uint32_t)WORKPHASE_PLANNING) || (phase == (uint32_t)WORKPHASE_CALIBRATION);
}

static void tell_entered(workphase_peer_t *peer, const answer_t *answer,
                         const igtl_moment_t *moment)
{
    const char *phase = workphase_name((int32_t)answer->argument);
    const igtl_status_t entered = {IGTL_STATUS_OK, phase, ""};
    igtl_packet_t packet;

    workphase_peer_tell_phase(peer, IGTL_STATUS_OK, answer->argument, "", moment);
    if (answer->is_final == 0U) {
        return;
    }
    igtl_encode_status(&packet, phase, &entered, moment->timestamp);
    if (is_entered_silently(answer->argument)) {
        workphase_peer_defer(peer, &packet, moment->now_us);
    } else {
        igtl_outbox_add(peer->outbox, &packet);
    }
}

static void tell_refused(const workphase_dialect_t *self, workphase_peer_t *peer,
                         const answer_t *answer, const igtl_moment_t *moment)
{
    char text[IGTL_REASON_SIZE];
    const igtl_status_t refused = {igtl_reason_code((status_t)answer->status),
                                   workphase_name((int32_t)answer->workphase), text};

    igtl_reason_text(self->robot, answer, text);
    workphase_peer_tell_phase(peer, IGTL_STATUS_NOT_READY, answer->workphase, text, moment);
    igtl_tell_status(peer->outbox, workphase_name((int32_t)answer->argument), &refused, moment);
}

/* A newer command of the same peer has ended this request, or is about to: its own sequence goes
 * first. */
static bool is_superseded(workphase_dialect_t *self, const igtl_request_t *request,
                          const answer_t *answer)
{
    const uint32_t last = self->peers[request->peer].last_request;
    const igtl_request_t *newer = igtl_requests_find(&self->requests, last);

    return (last != request->id) && (((newer != NULL) && !newer->is_accepted) ||
                                     (answer->status == (uint32_t)STATUS_DISCARDED));
}

static void tell_ended(workphase_dialect_t *self, const igtl_request_t *request,
                       const answer_t *answer, const igtl_moment_t *moment)
{
    workphase_peer_t *peer = &self->peers[request->peer];
    const char *phase = workphase_name((int32_t)request->argument);
    const bool is_done = (answer->kind == (uint32_t)ANSWER_DONE);
    char text[IGTL_REASON_SIZE] = "";
    const igtl_status_t ended = {is_done ? (uint32_t)IGTL_STATUS_OK
                                         : igtl_reason_code((status_t)answer->status),
                                 workphase_name((int32_t)answer->workphase), text};
    igtl_packet_t packet;

    if (!is_done) {
        igtl_reason_text(self->robot, answer, text);
    }
    igtl_encode_status(&packet, phase, &ended, moment->timestamp);
    if (is_superseded(self, request, answer)) {
        workphase_peer_defer(peer, &packet, moment->now_us);
        return;
    }
    igtl_outbox_add(peer->outbox, &packet);
    if (is_done && (request->argument == (uint32_t)WORKPHASE_MOVE_TO_TARGET)) {
        workphase_peer_tell_position(peer, moment);
    }
}

static void answer_phase(workphase_dialect_t *self, const igtl_request_t *request,
                         const answer_t *answer, const igtl_moment_t *moment)
{
    switch (answer->kind) {
    case ANSWER_ACCEPTED:
        tell_entered(&self->peers[request->peer], answer, moment);
        break;
    case ANSWER_REFUSED:
        tell_refused(self, &self->peers[request->peer], answer, moment);
        break;
    case ANSWER_DONE:
    case ANSWER_ABORTED:
    default:
        tell_ended(self, request, answer, moment);
        break;
    }
}

static void answer_pose(workphase_dialect_t *self, const igtl_request_t *request,
                        const answer_t *answer, const igtl_moment_t *moment)
{
    workphase_peer_t *peer = &self->peers[request->peer];
    const bool is_target = (request->kind == (uint32_t)COMMAND_TARGET);
    char text[IGTL_REASON_SIZE] = "";
    const igtl_status_t status = {igtl_reason_code((status_t)answer->status),
                                  workphase_name((int32_t)answer->workphase), text};

    if (answer->kind == (uint32_t)ANSWER_REFUSED) {
        igtl_reason_text(self->robot, answer, text);
    }
    igtl_tell_status(peer->outbox, is_target ? "TARGET" : "CALIBRATION", &status, moment);
    if (is_target && (answer->kind == (uint32_t)ANSWER_ACCEPTED)) {
        igtl_tell_pose(peer->outbox, "TARGET", &answer->pose, moment);
        workphase_peer_defer_pose(peer, "REACHABLE_TARGET", &answer->pose, moment);
    }
}

void workphase_answer_tell(workphase_dialect_t *self, const igtl_request_t *request,
                           const answer_t *answer, const igtl_moment_t *moment)
{
    if (request->kind == (uint32_t)COMMAND_WORKPHASE) {
        answer_phase(self, request, answer, moment);
    } else {
        answer_pose(self, request, answer, moment);
    }
}
