/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/workphase/workphase_answer.h"

#include "igtl/dialect/igtl_units.h"
#include "igtl/workphase/workphase_draping.h"
#include "igtl/lists/workphase_lists.h"
#include "igtl/workphase/workphase_peer.h"
#include "igtl/workphase/workphase_notifications.h"
#include "interface/app/names.h"
#include "procedure/command_kinds.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>

/* The name under which an answer to a request is sent. */
static const char *subject_of(const workphase_peer_t *peer, const igtl_request_t *request)
{
    const workphase_list_t *list = workphase_lists_of(request->command.kind);

    if (workphase_peer_is_motion(request->command.kind)) {
        return peer->motion;
    }
    if (peer->draping == request->id) {
        return WORKPHASE_COMMAND_DRAPING;
    }
    if (list != NULL) {
        return list->word;
    }
    switch (request->command.kind) {
    case COMMAND_REGISTRATION:
        return "CALIBRATION";
    case COMMAND_TARGET:
        return "TARGET";
    case COMMAND_NEEDLE:
        return workphase_peer_tip_subject(peer);
    case COMMAND_ENTRY:
        return "ENTRY";
    case COMMAND_ACCEPT_ENTRY:
        return "ACCEPT_ENTRY";
    case COMMAND_WITHDRAW:
        return "WITHDRAW_ENTRY";
    case COMMAND_ZERO_FORCE:
        return "ZERO_FORCE";
    case COMMAND_MEMBRANES:
        return "MEMBRANES";
    case COMMAND_STEER:
        return "STEER";
    case COMMAND_PROBE:
        return "PROBE";
    default:
        return workphase_name((int32_t)command_kinds_workphase(&request->command));
    }
}

/* Entering these has a STATUS since 2021 only. */
static bool is_entered_silently(uint32_t phase)
{
    return (phase == (uint32_t)WORKPHASE_PLANNING) || (phase == (uint32_t)WORKPHASE_CALIBRATION);
}

/* Notice for a workphase with an order, since 2021: it waits for the pedal. */
static void send_armed(workphase_peer_t *peer, const igtl_packet_t *entered, uint32_t phase,
                       const igtl_moment_t *moment)
{
    if ((peer->language == IGTL_LANGUAGE_BRP_2021) &&
        (phase == (uint32_t)WORKPHASE_MOVE_TO_TARGET)) {
        igtl_outbox_add(peer->outbox, entered);
        workphase_peer_send_position(peer, moment);
    }
}

static void send_entered(workphase_peer_t *peer, const answer_t *answer,
                         const igtl_moment_t *moment)
{
    const char *phase = workphase_name((int32_t)answer->asked);
    const igtl_status_t entered = {IGTL_STATUS_OK, phase, ""};
    const bool is_late =
        (peer->language != IGTL_LANGUAGE_BRP_2021) && is_entered_silently(answer->asked);
    igtl_packet_t packet;

    workphase_peer_send_phase(peer, IGTL_STATUS_OK, answer->asked, "", moment);
    igtl_encode_status(&packet, phase, &entered, moment->timestamp);
    if (answer->is_final == 0U) {
        send_armed(peer, &packet, answer->asked, moment);
    } else if (!is_late) {
        igtl_outbox_add(peer->outbox, &packet);
    } else if (peer->pending == 0U) {
        workphase_peer_defer(peer, &packet, moment->now_us);
    } else {
        /* Withheld: the next command has come. */
    }
}

static void send_outcome(const workphase_dialect_t *self, workphase_peer_t *peer, const char *name,
                         const answer_t *answer, const igtl_moment_t *moment)
{
    const bool is_good = answer->status == (uint32_t)STATUS_OK;
    char text[IGTL_REASON_SIZE] = "";
    const igtl_status_t status = {igtl_reason_code((status_t)answer->status),
                                  workphase_name((int32_t)answer->workphase), text};

    if (!is_good) {
        igtl_reason_text(self->robot, answer, moment, text);
    }
    igtl_send_status(peer->outbox, name, &status, moment);
}

/* As deployed servers do: the workphase that was asked for, then that it was not entered. */
static void send_refused(const workphase_dialect_t *self, workphase_peer_t *peer,
                         const answer_t *answer, const igtl_moment_t *moment)
{
    workphase_peer_send_phase(peer, IGTL_STATUS_OK, answer->asked, "", moment);
    send_outcome(self, peer, workphase_name((int32_t)answer->asked), answer, moment);
}

static void write_end(const workphase_dialect_t *self, const igtl_request_t *request,
                      const answer_t *answer, const igtl_moment_t *moment, igtl_packet_t *packet)
{
    const bool is_fault = (answer->kind == (uint32_t)ANSWER_ABORTED) &&
                          (answer->status == (uint32_t)STATUS_FAULT_PRESENT);
    char text[IGTL_REASON_SIZE] = "";
    const igtl_status_t ended = {is_fault ? (uint32_t)IGTL_STATUS_HARDWARE_FAILURE
                                          : igtl_reason_code((status_t)answer->status),
                                 workphase_name((int32_t)answer->workphase), text};

    if (is_fault) {
        workphase_notifications_fault_text(self, answer_as_ended(answer)->axis, moment, text);
    } else if (answer->status != (uint32_t)STATUS_OK) {
        igtl_reason_text(self->robot, answer, moment, text);
    } else {
        /* It has ended as asked. */
    }
    igtl_encode_status(packet, subject_of(&self->peers[request->peer], request), &ended,
                       moment->timestamp);
}

static bool is_move(const igtl_request_t *request)
{
    return command_kinds_workphase(&request->command) == WORKPHASE_MOVE_TO_TARGET;
}

/* Since 2021 STATUS(MOVE_TO_TARGET, 1) means entered; that it has arrived is asked for. */
static bool is_arrival_asked_for(const workphase_peer_t *peer, const igtl_request_t *request,
                                 const answer_t *answer)
{
    return (peer->language == IGTL_LANGUAGE_BRP_2021) && (answer->kind == (uint32_t)ANSWER_DONE) &&
           is_move(request);
}

static void send_ended(workphase_dialect_t *self, const igtl_request_t *request,
                       const answer_t *answer, const igtl_moment_t *moment)
{
    workphase_peer_t *peer = &self->peers[request->peer];
    igtl_packet_t packet;

    if (is_arrival_asked_for(peer, request, answer)) {
        return;
    }
    write_end(self, request, answer, moment, &packet);
    if (peer->pending != 0U) {
        peer->end = (workphase_end_t){.is_waiting = true,
                                      .is_discarded = answer->status == (uint32_t)STATUS_DISCARDED,
                                      .packet = packet};
    } else {
        igtl_outbox_add(peer->outbox, &packet);
        if ((answer->kind == (uint32_t)ANSWER_DONE) && is_move(request)) {
            workphase_peer_send_position(peer, moment);
        }
    }
}

static void answer_phase(workphase_dialect_t *self, const igtl_request_t *request,
                         const answer_t *answer, const igtl_moment_t *moment)
{
    workphase_peer_t *peer = &self->peers[request->peer];

    if (peer->draping == request->id) {
        peer->draping = 0U;
        if (answer->kind == (uint32_t)ANSWER_ACCEPTED) {
            workphase_draping_go_on(self, request->peer, moment);
        } else {
            send_outcome(self, peer, WORKPHASE_COMMAND_DRAPING, answer, moment);
        }
        return;
    }
    switch (answer->kind) {
    case ANSWER_ACCEPTED:
        send_entered(&self->peers[request->peer], answer, moment);
        break;
    case ANSWER_REFUSED:
        send_refused(self, &self->peers[request->peer], answer, moment);
        break;
    case ANSWER_DONE:
    case ANSWER_ABORTED:
    default:
        send_ended(self, request, answer, moment);
        break;
    }
}

static void answer_target(const workphase_dialect_t *self, workphase_peer_t *peer,
                          const answer_t *answer, const igtl_moment_t *moment)
{
    send_outcome(self, peer, "TARGET", answer, moment);
    if (answer_form(answer) != ANSWER_FORM_POSE) {
        return;
    }
    const rigid_t *reachable = &answer_as_pose(answer)->pose;
    if (peer->language == IGTL_LANGUAGE_BRP_2021) {
        igtl_send_pose(peer->outbox, "REACHABLE_TARGET", reachable, moment);
    } else {
        igtl_send_pose(peer->outbox, "TARGET", reachable, moment);
        workphase_peer_defer_pose(peer, "REACHABLE_TARGET", reachable, moment);
    }
}

/* A tip that a newer command of the same peer has overtaken is not spoken of. */
static void answer_tip(const workphase_dialect_t *self, workphase_peer_t *peer,
                       const answer_t *answer, const igtl_moment_t *moment)
{
    if (peer->pending == 0U) {
        send_outcome(self, peer, workphase_peer_tip_subject(peer), answer, moment);
    }
}

/* The client that accepts a proposal is sent its value: it may just have changed. */
static void answer_entry(const workphase_dialect_t *self, workphase_peer_t *peer,
                         const igtl_request_t *request, const answer_t *answer,
                         const igtl_moment_t *moment)
{
    char text[IGTL_REASON_SIZE];
    const igtl_status_t taken = {IGTL_STATUS_OK, workphase_name((int32_t)answer->workphase), text};

    if (answer_form(answer) != ANSWER_FORM_POINT) {
        send_outcome(self, peer, subject_of(peer, request), answer, moment);
        return;
    }
    const point_t *entry = &answer_as_point(answer)->point;
    (void)snprintf(text, sizeof text, "%.3f, %.3f, %.3f mm", igtl_units_mm(entry->x_nm),
                   igtl_units_mm(entry->y_nm), igtl_units_mm(entry->z_nm));
    igtl_send_status(peer->outbox, subject_of(peer, request), &taken, moment);
}

static bool is_draping(const workphase_peer_t *peer)
{
    return strcmp(peer->motion, WORKPHASE_COMMAND_DRAPING) == 0;
}

/* As a later server does, DRAPING has one STATUS, when it is entered. */
static void send_begun(const workphase_dialect_t *self, workphase_peer_t *peer,
                       const answer_t *answer, const igtl_moment_t *moment)
{
    char name[IGTL_NAME_SIZE];

    if (is_draping(peer)) {
        send_outcome(self, peer, peer->motion, answer, moment);
        return;
    }
    (void)snprintf(name, sizeof name, "ACK_%.16s", peer->motion);
    send_outcome(self, peer, name, answer, moment);
    if (answer->is_final != 0U) { /* It was there already. */
        send_outcome(self, peer, peer->motion, answer, moment);
    }
}

static void answer_motion(workphase_dialect_t *self, const igtl_request_t *request,
                          const answer_t *answer, const igtl_moment_t *moment)
{
    workphase_peer_t *peer = &self->peers[request->peer];

    if (answer->kind == (uint32_t)ANSWER_ACCEPTED) {
        send_begun(self, peer, answer, moment);
    } else if (answer->kind == (uint32_t)ANSWER_REFUSED) {
        send_outcome(self, peer, peer->motion, answer, moment);
    } else if ((answer->kind == (uint32_t)ANSWER_DONE) && is_draping(peer)) {
        /* It was reported when it began. */
    } else {
        send_ended(self, request, answer, moment);
    }
}

/* The answer to the whole list has its checksum, by which it can be run. */
static void answer_list(const workphase_dialect_t *self, workphase_peer_t *peer,
                        const workphase_list_t *list, const answer_t *answer,
                        const igtl_moment_t *moment)
{
    char text[IGTL_REASON_SIZE];
    const igtl_status_t held = {IGTL_STATUS_OK, workphase_name((int32_t)answer->workphase), text};

    if (answer_form(answer) != ANSWER_FORM_CHECKSUM) {
        send_outcome(self, peer, list->word, answer, moment);
        return;
    }
    (void)snprintf(text, sizeof text, "Checksum %u.",
                   (unsigned)answer_as_checksum(answer)->checksum);
    igtl_send_status(peer->outbox, list->word, &held, moment);
}

/* A refused item has its place behind the reason; it is sent when another array may come. */
static void refuse_array(workphase_dialect_t *self, const igtl_request_t *request,
                         const answer_t *answer, const igtl_moment_t *moment)
{
    const workphase_list_t *list = self->array.list;
    char text[IGTL_REASON_SIZE] = "";
    const igtl_status_t status = {igtl_reason_code((status_t)answer->status),
                                  workphase_name((int32_t)answer->workphase), text};

    igtl_reason_text(self->robot, answer, moment, text);
    if (request->command.kind == (uint32_t)list->add) {
        const size_t used = strlen(text);

        (void)snprintf(&text[used], sizeof text - used, " %s %u.", list->title,
                       (unsigned)list->index(&request->command));
    }
    igtl_encode_status(&self->array.refusal, list->word, &status, moment->timestamp);
    self->array.is_owed = true;
}

/* A list that came as a whole has one answer: it is held, or why not. */
static void answer_array(workphase_dialect_t *self, const igtl_request_t *request,
                         const answer_t *answer, const igtl_moment_t *moment)
{
    workphase_peer_t *peer = &self->peers[request->peer];
    const workphase_list_t *list = self->array.list;

    if (answer->kind == (uint32_t)ANSWER_REFUSED) {
        if (workphase_array_fail(&self->array)) {
            refuse_array(self, request, answer, moment);
        }
    } else if (request->command.kind == (uint32_t)list->end) {
        peer->sums[list->number] = self->array.crc;
        workphase_array_end(&self->array, request->peer);
        answer_list(self, peer, list, answer, moment);
    } else {
        /* The next ones follow. */
    }
}

static void answer_by_kind(workphase_dialect_t *self, const igtl_request_t *request,
                           const answer_t *answer, const igtl_moment_t *moment)
{
    workphase_peer_t *peer = &self->peers[request->peer];
    const workphase_list_t *list = workphase_lists_of(request->command.kind);

    if (workphase_peer_is_motion(request->command.kind)) {
        answer_motion(self, request, answer, moment);
        return;
    }
    if (workphase_array_has(&self->array, request)) {
        answer_array(self, request, answer, moment);
        return;
    }
    if (list != NULL) {
        answer_list(self, peer, list, answer, moment);
        return;
    }
    switch (request->command.kind) {
    case COMMAND_WORKPHASE:
        answer_phase(self, request, answer, moment);
        break;
    case COMMAND_TARGET:
        answer_target(self, peer, answer, moment);
        break;
    case COMMAND_NEEDLE:
        answer_tip(self, peer, answer, moment);
        break;
    case COMMAND_ENTRY:
    case COMMAND_ACCEPT_ENTRY:
        answer_entry(self, peer, request, answer, moment);
        break;
    default:
        send_outcome(self, peer, subject_of(peer, request), answer, moment);
        break;
    }
}

/* The controller answers in this order: a command that discards an order is accepted after the
 * order's end. */
static bool has_ended_it(const workphase_peer_t *peer, const igtl_request_t *request,
                         const answer_t *answer)
{
    return peer->end.is_discarded && (answer->kind == (uint32_t)ANSWER_ACCEPTED) &&
           ((request->command.kind == (uint32_t)COMMAND_WORKPHASE) ||
            workphase_peer_is_motion(request->command.kind));
}

/* The command for which an order's end waited has been answered, and has not ended it. */
static void release_end(workphase_peer_t *peer)
{
    if (peer->end.is_waiting) {
        igtl_outbox_add(peer->outbox, &peer->end.packet);
    }
    peer->end.is_waiting = false;
}

void workphase_answer_send(workphase_dialect_t *self, const igtl_request_t *request,
                           const answer_t *answer, const igtl_moment_t *moment)
{
    workphase_peer_t *peer = &self->peers[request->peer];
    const bool is_awaited = peer->pending == request->id;

    if (is_awaited) {
        peer->pending = 0U;
    }
    answer_by_kind(self, request, answer, moment);
    if (has_ended_it(peer, request, answer)) {
        peer->end.is_waiting = false;
    }
    if (is_awaited) {
        release_end(peer);
    }
    workphase_notifications_note(self, request, answer, moment);
}

void workphase_answer_send_none(workphase_dialect_t *self, const igtl_request_t *request,
                                const igtl_moment_t *moment)
{
    workphase_peer_t *peer = &self->peers[request->peer];

    if (workphase_array_has(&self->array, request) && !workphase_array_fail(&self->array)) {
        return; /* It was said of another row. */
    }
    igtl_send_refusal(peer->outbox, subject_of(peer, request), STATUS_NO_ANSWER, moment);
    if (peer->pending == request->id) {
        peer->pending = 0U;
        release_end(peer);
    }
}
