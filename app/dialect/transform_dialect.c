/* SPDX-License-Identifier: Apache-2.0 */
#include "dialect/transform_dialect.h"

#include "dialect/igtl_border.h"
#include "interface/app/names.h"

#include <stddef.h>
#include <string.h>

#define PROPOSALS_AT_A_TIME 4U /* A flood of them leaves room for commands in the exchange. */

void transform_dialect_init(transform_dialect_t *self, const robot_t *robot, uint32_t first_id)
{
    (void)memset(self, 0, sizeof *self);
    self->robot = robot;
    igtl_requests_init(&self->requests, first_id, PROPOSALS_AT_A_TIME);
}

/* Forgets what was shown: the next step sends everything. */
static void show_all(transform_peer_t *peer)
{
    (void)memset(&peer->shown, 0, sizeof peer->shown);
    peer->must_send_measured = true;
    peer->next_measured_us = 0U;
}

void transform_dialect_connected(void *dialect, uint32_t peer,
                                 const igtl_introduction_t *introduction)
{
    transform_dialect_t *self = dialect;

    self->peers[peer].outbox = introduction->outbox;
    self->peers[peer].number = introduction->number;
    show_all(&self->peers[peer]);
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

static const struct {
    char name[IGTL_NAME_SIZE];
    command_kind_t kind;
} proposals[] = {{"REGISTRATION", COMMAND_PROPOSE_REGISTRATION},
                 {"ENTRY_POINT", COMMAND_PROPOSE_ENTRY},
                 {"TARGET_POINT", COMMAND_PROPOSE_TARGET}};

#define PROPOSALS (sizeof proposals / sizeof proposals[0])

static const char *name_of(uint32_t kind)
{
    for (size_t i = 0U; i < PROPOSALS; i++) {
        if ((uint32_t)proposals[i].kind == kind) {
            return proposals[i].name;
        }
    }
    return "";
}

static command_kind_t kind_of(const char *name)
{
    for (size_t i = 0U; i < PROPOSALS; i++) {
        if (strcmp(proposals[i].name, name) == 0) {
            return proposals[i].kind;
        }
    }
    return COMMAND_NONE;
}

static void propose(transform_dialect_t *self, uint32_t peer, const igtl_message_t *message,
                    const igtl_moment_t *moment)
{
    command_t command = {.peer = self->peers[peer].number,
                         .kind = (uint32_t)kind_of(message->name)};
    status_t status = STATUS_UNKNOWN_COMMAND;

    if (command.kind != (uint32_t)COMMAND_NONE) {
        status = igtl_border_read_pose(message->numbers, &command.pose);
    }
    if ((status == STATUS_OK) &&
        (igtl_requests_add(&self->requests, peer, &command, moment->patience_us) == NULL)) {
        status = STATUS_BUSY;
    }
    if (status != STATUS_OK) {
        igtl_tell_refusal(self->peers[peer].outbox, message->name, status, moment);
        self->peers[peer].must_send_measured = true;
    }
}

static bool asks_for_all(const igtl_message_t *message)
{
    static const char text[] = "START_UP";

    return (strcmp(message->name, "start_up") == 0) ||
           ((message->text_bytes == (sizeof text - 1U)) &&
            (memcmp(message->text, text, sizeof text - 1U) == 0));
}

void transform_dialect_receive(void *dialect, uint32_t peer, const igtl_message_t *message,
                               const igtl_moment_t *moment)
{
    transform_dialect_t *self = dialect;

    switch (message->kind) {
    case IGTL_KIND_TRANSFORM:
        propose(self, peer, message, moment);
        break;
    case IGTL_KIND_STRING:
        if (asks_for_all(message)) {
            show_all(&self->peers[peer]);
        } else {
            igtl_tell_refusal(self->peers[peer].outbox, message->name, STATUS_UNKNOWN_COMMAND,
                              moment);
        }
        break;
    case IGTL_KIND_GET_TRANSFORM:
    case IGTL_KIND_GET_STATUS:
        show_all(&self->peers[peer]);
        break;
    case IGTL_KIND_POINT:
        igtl_tell_refusal(self->peers[peer].outbox, message->name, STATUS_UNKNOWN_COMMAND, moment);
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

static void tell_refused(transform_dialect_t *self, const igtl_request_t *request,
                         const answer_t *answer, const igtl_moment_t *moment)
{
    char text[IGTL_REASON_SIZE];
    const igtl_status_t refused = {igtl_reason_code((status_t)answer->status),
                                   status_name((int32_t)answer->status), text};

    igtl_reason_text(self->robot, answer, text);
    igtl_tell_status(self->peers[request->peer].outbox, name_of(request->kind), &refused, moment);
}

bool transform_dialect_answer(transform_dialect_t *self, const answer_t *answer,
                              const igtl_moment_t *moment)
{
    igtl_request_t *request = igtl_requests_find(&self->requests, answer->id);

    if (request == NULL) {
        return false;
    }
    if (request->peer != IGTL_NOBODY) {
        self->peers[request->peer].must_send_measured = true;
        if (answer->kind == (uint32_t)ANSWER_REFUSED) {
            tell_refused(self, request, answer, moment);
        }
    }
    igtl_requests_end(request);
    return true;
}

static void take_view(const snapshot_t *snapshot, transform_view_t *view)
{
    (void)memset(view, 0, sizeof *view);
    view->measured.pose_status = snapshot->pose_status;
    view->measured.pose = snapshot->scanner_treatment;
    for (uint32_t i = 0U; i < snapshot->axis_count; i++) {
        view->measured.ticks[i] = snapshot->axes[i].position_ticks;
        view->measured.speeds_q8[i] = snapshot->axes[i].speed_ticks_per_s_q8;
    }
    if (snapshot->is_proposal_reachable != 0U) {
        view->desired.is_valid = 1U;
        view->desired.pose_status = snapshot->pose_status;
        view->desired.pose = snapshot->scanner_desired;
        (void)memcpy(view->desired.ticks, snapshot->desired_ticks, sizeof view->desired.ticks);
    }
    if (snapshot->is_registered != 0U) {
        view->registration = (transform_registration_t){1U, snapshot->scanner_zframe};
    } else if (snapshot->has_proposed_registration != 0U) {
        view->registration = (transform_registration_t){1U, snapshot->proposed_registration};
    } else {
        view->registration.is_valid = 0U;
    }
    if (snapshot->has_proposed_entry != 0U) {
        view->entry = (transform_point_t){1U, snapshot->proposed_entry};
    }
    if (snapshot->has_proposed_target != 0U) {
        view->target = (transform_point_t){1U, snapshot->proposed_target};
    }
}

static void send_pose(transform_peer_t *peer, const char *name, const rigid_t *pose,
                      const igtl_moment_t *moment)
{
    igtl_packet_t packet;
    uint32_t numbers[IGTL_TRANSFORM_NUMBERS];

    igtl_border_write_pose(pose, numbers);
    igtl_encode_transform(&packet, name, numbers, moment->timestamp);
    igtl_outbox_add_state(peer->outbox, &packet);
}

static void send_text(transform_peer_t *peer, const char *name, const char *text,
                      const igtl_moment_t *moment)
{
    igtl_packet_t packet;

    igtl_encode_string(&packet, name, text, moment->timestamp);
    igtl_outbox_add_state(peer->outbox, &packet);
}

static void send_measured(const robot_t *robot, transform_peer_t *peer,
                          const transform_view_t *view, const igtl_moment_t *moment)
{
    char text[IGTL_LIST_SIZE];

    if (view->measured.pose_status == (uint32_t)STATUS_OK) {
        send_pose(peer, "measured_cp", &view->measured.pose, moment);
    } else if (peer->must_send_measured ||
               (view->measured.pose_status != peer->shown.measured.pose_status)) {
        igtl_tell_refusal(peer->outbox, "measured_cp", (status_t)view->measured.pose_status,
                          moment);
    } else {
        /* It was told before. */
    }
    igtl_border_write_positions(robot, view->measured.ticks, text);
    send_text(peer, "measured_jp", text, moment);
    igtl_border_write_speeds(robot, view->measured.speeds_q8, text);
    send_text(peer, "measured_jv", text, moment);
    peer->shown.measured = view->measured;
    peer->must_send_measured = false;
    peer->next_measured_us = moment->now_us + IGTL_STREAM_US;
}

static void send_desired(const robot_t *robot, transform_peer_t *peer, const transform_view_t *view,
                         const igtl_moment_t *moment)
{
    char text[IGTL_LIST_SIZE];

    if (memcmp(&view->desired, &peer->shown.desired, sizeof view->desired) == 0) {
        return;
    }
    if ((view->desired.is_valid != 0U) && (view->desired.pose_status != (uint32_t)STATUS_OK)) {
        igtl_tell_refusal(peer->outbox, "desired_cp", (status_t)view->desired.pose_status, moment);
    } else if (view->desired.is_valid != 0U) {
        send_pose(peer, "desired_cp", &view->desired.pose, moment);
        igtl_border_write_positions(robot, view->desired.ticks, text);
        send_text(peer, "desired_jp", text, moment);
    } else {
        /* Nothing is proposed any more. */
    }
    peer->shown.desired = view->desired;
}

static void send_point(transform_peer_t *peer, const char *name, const transform_point_t *point,
                       transform_point_t *shown, const igtl_moment_t *moment)
{
    igtl_packet_t packet;
    uint32_t numbers[3];

    if (memcmp(point, shown, sizeof *point) == 0) {
        return;
    }
    if (point->is_valid != 0U) {
        igtl_border_write_point(&point->point, numbers);
        igtl_encode_point(&packet, name, numbers, moment->timestamp);
        igtl_outbox_add_state(peer->outbox, &packet);
    }
    *shown = *point;
}

static void send_registration(transform_peer_t *peer, const transform_view_t *view,
                              const igtl_moment_t *moment)
{
    if (memcmp(&view->registration, &peer->shown.registration, sizeof view->registration) == 0) {
        return;
    }
    if (view->registration.is_valid != 0U) {
        send_pose(peer, "scanner_to_robot_reg", &view->registration.pose, moment);
    }
    peer->shown.registration = view->registration;
}

static void show(const robot_t *robot, transform_peer_t *peer, const transform_view_t *view,
                 const igtl_moment_t *moment)
{
    const bool has_changed =
        memcmp(&view->measured, &peer->shown.measured, sizeof view->measured) != 0;
    const bool is_due = moment->now_us >= peer->next_measured_us;

    send_registration(peer, view, moment);
    send_point(peer, "entry_point", &view->entry, &peer->shown.entry, moment);
    send_point(peer, "target_point", &view->target, &peer->shown.target, moment);
    send_desired(robot, peer, view, moment);
    if (peer->must_send_measured || (is_due && (has_changed || igtl_is_moving(moment)))) {
        send_measured(robot, peer, view, moment);
    }
}

void transform_dialect_step(transform_dialect_t *self, const igtl_moment_t *moment)
{
    igtl_request_t *overdue = igtl_requests_overdue(&self->requests, moment->patience_us);
    transform_view_t view;

    while (overdue != NULL) {
        if (overdue->peer != IGTL_NOBODY) {
            igtl_tell_refusal(self->peers[overdue->peer].outbox, name_of(overdue->kind),
                              STATUS_NO_ANSWER, moment);
        }
        overdue = igtl_requests_overdue(&self->requests, moment->patience_us);
    }
    if (moment->snapshot == NULL) {
        return;
    }
    take_view(moment->snapshot, &view);
    for (uint32_t i = 0U; i < IGTL_PLACES; i++) {
        if (self->peers[i].outbox != NULL) {
            show(self->robot, &self->peers[i], &view, moment);
        }
    }
}
