/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/dialect/transform_show.h"

#include "igtl/dialect/igtl_units.h"
#include "robot/probe.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>

#define ROOM_FOR_LENGTH 24U

void transform_show_all(transform_shown_t *self)
{
    (void)memset(self, 0, sizeof *self);
    self->must_send_measured = true;
}

static void send_pose(igtl_outbox_t *outbox, const char *name, const rigid_t *pose,
                      const igtl_moment_t *moment)
{
    igtl_packet_t packet;

    igtl_pack_pose(&packet, name, pose, moment);
    igtl_outbox_add_state(outbox, &packet);
}

static void send_text(igtl_outbox_t *outbox, const char *name, const char *text,
                      const igtl_moment_t *moment)
{
    igtl_packet_t packet;

    igtl_encode_string(&packet, name, text, moment->timestamp);
    igtl_outbox_add_state(outbox, &packet);
}

static void encode_point(igtl_packet_t *packet, const char *name, const transform_point_t *point,
                         const igtl_moment_t *moment)
{
    uint32_t numbers[3];

    if (point->is_valid != 0U) {
        igtl_units_write_point(&point->point, numbers);
        igtl_encode_point(packet, name, numbers, moment->timestamp);
    } else {
        igtl_encode_empty(packet, "POINT", name, moment->timestamp);
    }
}

static void send_joints(const robot_t *robot, igtl_outbox_t *outbox,
                        const transform_measured_t *measured, const igtl_moment_t *moment)
{
    char text[IGTL_LIST_SIZE];

    igtl_units_write_positions(robot, measured->ticks, text);
    send_text(outbox, "measured_jp", text, moment);
    igtl_units_write_speeds(robot, measured->speeds_q8, text);
    send_text(outbox, "measured_jv", text, moment);
}

/* A reason is sent once, and to a peer that asks. */
static void send_measured(transform_shown_t *self, const robot_t *robot, igtl_outbox_t *outbox,
                          const transform_view_t *view, const igtl_moment_t *moment)
{
    const transform_measured_t *now = &view->measured;
    const transform_measured_t *before = &self->seen.measured;

    if (now->pose_status == (uint32_t)STATUS_OK) {
        send_pose(outbox, "measured_cp", &now->pose, moment);
    } else if (self->must_send_measured || (now->pose_status != before->pose_status)) {
        igtl_send_refusal(outbox, "measured_cp", (status_t)now->pose_status, moment);
    } else {
        /* It was sent before. */
    }
    if (now->joint_status == (uint32_t)STATUS_OK) {
        send_joints(robot, outbox, now, moment);
    } else if (self->must_send_measured || (now->joint_status != before->joint_status)) {
        igtl_send_refusal(outbox, "measured_jp", (status_t)now->joint_status, moment);
        igtl_send_refusal(outbox, "measured_jv", (status_t)now->joint_status, moment);
    } else {
        /* It was sent before. */
    }
    self->seen.measured = *now;
    self->must_send_measured = false;
    self->next_measured_us = moment->now_us + IGTL_STREAM_US;
}

static void send_desired(transform_shown_t *self, const robot_t *robot, igtl_outbox_t *outbox,
                         const transform_desired_t *desired, const igtl_moment_t *moment)
{
    char text[IGTL_LIST_SIZE];

    if (memcmp(desired, &self->seen.desired, sizeof *desired) == 0) {
        return;
    }
    if (desired->is_valid == 0U) {
        igtl_send_not_found(outbox, "desired_cp", moment);
        igtl_send_not_found(outbox, "desired_jp", moment);
    } else if (desired->pose_status != (uint32_t)STATUS_OK) {
        igtl_send_refusal(outbox, "desired_cp", (status_t)desired->pose_status, moment);
        igtl_send_refusal(outbox, "desired_jp", (status_t)desired->pose_status, moment);
    } else {
        send_pose(outbox, "desired_cp", &desired->pose, moment);
        igtl_units_write_positions(robot, desired->ticks, text);
        send_text(outbox, "desired_jp", text, moment);
    }
    self->seen.desired = *desired;
}

static void send_point(igtl_outbox_t *outbox, const char *name, const transform_point_t *point,
                       transform_point_t *seen, const igtl_moment_t *moment)
{
    igtl_packet_t packet;

    if (memcmp(point, seen, sizeof *point) == 0) {
        return;
    }
    encode_point(&packet, name, point, moment);
    igtl_outbox_add_state(outbox, &packet);
    *seen = *point;
}

static void send_registration(transform_shown_t *self, igtl_outbox_t *outbox,
                              const transform_registration_t *registration,
                              const igtl_moment_t *moment)
{
    if (memcmp(registration, &self->seen.registration, sizeof *registration) == 0) {
        return;
    }
    if (registration->is_valid != 0U) {
        send_pose(outbox, "scanner_to_robot_reg", &registration->pose, moment);
    } else {
        igtl_send_not_found(outbox, "scanner_to_robot_reg", moment);
    }
    if (registration->is_rotation_ignored != self->seen.registration.is_rotation_ignored) {
        send_text(outbox, "ignore_rotation", (registration->is_rotation_ignored != 0U) ? "1" : "0",
                  moment);
    }
    self->seen.registration = *registration;
}

/* All of them again whenever the probe is another one; while none is known nothing is sent. */
static void send_lengths(transform_shown_t *self, const robot_t *robot, igtl_outbox_t *outbox,
                         const transform_probe_t *probe, const igtl_moment_t *moment)
{
    char text[ROOM_FOR_LENGTH];

    if (self->has_seen_lengths && (memcmp(probe, &self->seen.probe, sizeof *probe) == 0)) {
        return;
    }
    for (uint32_t i = 0U; i < ROBOT_REPORTED_LENGTHS; i++) {
        const reported_length_t *length = &robot->reported_lengths[i];
        const bool is_known = (length->probe == 0U) || (probe->is_valid != 0U);

        if ((length->name[0] != '\0') && is_known) {
            (void)snprintf(text, sizeof text, "%f",
                           igtl_units_mm(probe_reported_nm(length, probe->length_nm)));
            send_text(outbox, length->name, text, moment);
        }
    }
    self->has_seen_lengths = true;
    self->seen.probe = *probe;
}

static bool is_measured_due(const transform_shown_t *self, const transform_measured_t *measured,
                            const igtl_moment_t *moment)
{
    const transform_measured_t *seen = &self->seen.measured;
    const bool has_changed = memcmp(measured, seen, sizeof *measured) != 0;
    /* The status of the joints follows from it. */
    const bool has_turned = measured->pose_status != seen->pose_status;

    return self->must_send_measured || has_turned ||
           ((moment->now_us >= self->next_measured_us) && (has_changed || igtl_is_moving(moment)));
}

void transform_show_step(transform_shown_t *self, const robot_t *robot, igtl_outbox_t *outbox,
                         const transform_view_t *view, const igtl_moment_t *moment)
{
    send_lengths(self, robot, outbox, &view->probe, moment);
    send_registration(self, outbox, &view->registration, moment);
    send_point(outbox, "entry_point", &view->entry, &self->seen.entry, moment);
    send_point(outbox, "target_point", &view->target, &self->seen.target, moment);
    send_desired(self, robot, outbox, &view->desired, moment);
    if (is_measured_due(self, &view->measured, moment)) {
        send_measured(self, robot, outbox, view, moment);
    }
}

void transform_show_silence(transform_shown_t *self, igtl_outbox_t *outbox,
                            const igtl_moment_t *moment)
{
    transform_view_t view;

    (void)memset(&view, 0, sizeof view);
    view.measured.pose_status = (uint32_t)STATUS_NO_ANSWER;
    view.measured.joint_status = (uint32_t)STATUS_NO_ANSWER;
    if (is_measured_due(self, &view.measured, moment)) {
        send_measured(self, NULL, outbox, &view, moment);
    }
}

/* One that is known, or why it is not. */
static void answer_known(igtl_outbox_t *outbox, const char *name, uint32_t status,
                         const rigid_t *pose, const igtl_moment_t *moment)
{
    if (status == (uint32_t)STATUS_OK) {
        igtl_send_pose(outbox, name, pose, moment);
    } else {
        igtl_send_refusal(outbox, name, (status_t)status, moment);
    }
}

static void answer_transform(igtl_outbox_t *outbox, const char *name, const transform_view_t *view,
                             const igtl_moment_t *moment)
{
    if ((name[0] == '\0') || (strcmp(name, "measured_cp") == 0)) {
        answer_known(outbox, "measured_cp", view->measured.pose_status, &view->measured.pose,
                     moment);
    } else if ((strcmp(name, "desired_cp") == 0) && (view->desired.is_valid != 0U)) {
        answer_known(outbox, name, view->desired.pose_status, &view->desired.pose, moment);
    } else if ((strcmp(name, "scanner_to_robot_reg") == 0) && (view->registration.is_valid != 0U)) {
        igtl_send_pose(outbox, name, &view->registration.pose, moment);
    } else {
        igtl_send_not_found(outbox, name, moment);
    }
}

static void answer_point(igtl_outbox_t *outbox, const char *name, const transform_view_t *view,
                         const igtl_moment_t *moment)
{
    static const char *const names[] = {"entry_point", "target_point"};
    const transform_point_t *const points[] = {&view->entry, &view->target};
    bool is_found = false;
    igtl_packet_t packet;

    for (uint32_t i = 0U; i < 2U; i++) {
        if ((name[0] == '\0') || (strcmp(name, names[i]) == 0)) {
            encode_point(&packet, names[i], points[i], moment);
            igtl_outbox_add(outbox, &packet);
            is_found = true;
        }
    }
    if (!is_found) {
        igtl_send_not_found(outbox, name, moment);
    }
}

void transform_show_answer(igtl_outbox_t *outbox, const igtl_message_t *question,
                           const igtl_moment_t *moment)
{
    static const igtl_status_t alive = {IGTL_STATUS_OK, "", ""};
    transform_view_t view;

    if (question->kind == IGTL_KIND_GET_STATUS) {
        igtl_send_status(outbox, question->name, &alive, moment);
    } else if (moment->snapshot == NULL) {
        igtl_send_refusal(outbox, question->name, STATUS_NO_ANSWER, moment);
    } else {
        transform_view_take(&view, moment->snapshot);
        if (question->kind == IGTL_KIND_GET_TRANSFORM) {
            answer_transform(outbox, question->name, &view, moment);
        } else {
            answer_point(outbox, question->name, &view, moment);
        }
    }
}
