/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/dialect/igtl_dialect.h"

#include "charts/arming_chart.h"
#include "igtl/dialect/igtl_units.h"
#include "interface/app/names.h"
#include "limits/requirement_limits.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>

#define CYCLES_PER_S (1000000U / LIMIT_CYCLE_US)

/* "NAME: sentence"; the client with authority, by name. */
static void write_reason(status_t status, const igtl_moment_t *moment, char text[IGTL_REASON_SIZE])
{
    const char *name = status_name((int32_t)status);

    if ((status == STATUS_NO_AUTHORITY) && (moment->snapshot != NULL) && (moment->holder != NULL)) {
        const uint32_t cycles = moment->snapshot->cycle - moment->snapshot->held_since_cycle;

        (void)snprintf(text, IGTL_REASON_SIZE, "%s: %s has commanded the robot for %u s.", name,
                       moment->holder, (unsigned)(cycles / CYCLES_PER_S));
    } else {
        (void)snprintf(text, IGTL_REASON_SIZE, "%s: %s", name, status_text((int32_t)status));
    }
}

/* NULL: it names none. */
static const char *axis_name(const robot_t *robot, const answer_t *answer)
{
    const uint32_t axis = answer_axis(answer);
    return (axis < robot->axis_count) ? robot->axes[axis].name : NULL;
}

static const char *end_name(uint32_t is_maximum)
{
    return (is_maximum != 0U) ? "upper" : "lower";
}

/* The reason is the place of an axis. */
static bool is_of_place(const answer_t *answer)
{
    return (answer->status == (uint32_t)STATUS_AXIS_LIMIT) ||
           (answer->status == (uint32_t)STATUS_SWITCH_ZONE);
}

void igtl_reason_text(const robot_t *robot, const answer_t *answer, const igtl_moment_t *moment,
                      char text[IGTL_REASON_SIZE])
{
    const char *name = status_name((int32_t)answer->status);
    const char *says = status_text((int32_t)answer->status);
    const answer_form_t form = answer_form(answer);
    const char *axis = axis_name(robot, answer);

    if ((form == ANSWER_FORM_LIMIT) && (axis != NULL)) {
        (void)snprintf(text, IGTL_REASON_SIZE, "%s: %s (%s, %s limit)", name, says, axis,
                       end_name(answer_as_limit(answer)->is_maximum));
    } else if (is_of_place(answer) && (axis != NULL)) {
        (void)snprintf(text, IGTL_REASON_SIZE, "%s: %s (%s)", name, says, axis);
    } else if (form == ANSWER_FORM_SHARED_LIMIT) {
        (void)snprintf(text, IGTL_REASON_SIZE, "%s: %s (%s limit)", name, says,
                       end_name(answer_as_shared_limit(answer)->is_maximum));
    } else {
        write_reason((status_t)answer->status, moment, text);
    }
}

void igtl_send_status(igtl_outbox_t *outbox, const char *name, const igtl_status_t *status,
                      const igtl_moment_t *moment)
{
    igtl_packet_t packet;

    igtl_encode_status(&packet, name, status, moment->timestamp);
    igtl_outbox_add(outbox, &packet);
}

void igtl_send_refused(igtl_outbox_t *outbox, const char *name, const igtl_status_t *status,
                       const igtl_moment_t *moment)
{
    igtl_send_status(outbox, name, status, moment);
    igtl_outbox_note_refusal(outbox, name, status->text);
}

void igtl_send_refusal(igtl_outbox_t *outbox, const char *name, status_t status,
                       const igtl_moment_t *moment)
{
    char text[IGTL_REASON_SIZE];
    const igtl_status_t refusal = {igtl_reason_code(status), status_name((int32_t)status), text};

    write_reason(status, moment, text);
    igtl_send_refused(outbox, name, &refusal, moment);
}

void igtl_send_not_found(igtl_outbox_t *outbox, const char *name, const igtl_moment_t *moment)
{
    static const igtl_status_t status = {IGTL_STATUS_NOT_FOUND, "NOT_FOUND",
                                         "NOT_FOUND: There is nothing of this name."};

    igtl_send_refused(outbox, name, &status, moment);
}

bool igtl_is_text(const igtl_message_t *message, const char *text)
{
    return (strlen(text) == message->text_bytes) &&
           (memcmp(text, message->text, message->text_bytes) == 0);
}

void igtl_pack_pose(igtl_packet_t *packet, const char *name, const rigid_t *pose,
                    const igtl_moment_t *moment)
{
    uint32_t numbers[IGTL_TRANSFORM_NUMBERS];

    igtl_units_write_pose(pose, numbers);
    igtl_encode_transform(packet, name, numbers, moment->timestamp);
}

void igtl_send_pose(igtl_outbox_t *outbox, const char *name, const rigid_t *pose,
                    const igtl_moment_t *moment)
{
    igtl_packet_t packet;

    igtl_pack_pose(&packet, name, pose, moment);
    igtl_outbox_add(outbox, &packet);
}

status_t igtl_pose_status(const igtl_moment_t *moment)
{
    return (moment->snapshot == NULL) ? STATUS_NO_ANSWER : (status_t)moment->snapshot->pose_status;
}

bool igtl_is_moving(const igtl_moment_t *moment)
{
    const snapshot_t *snapshot = moment->snapshot;

    if (snapshot == NULL) {
        return false;
    }
    for (uint32_t i = 0U; i < snapshot->axis_count; i++) {
        if ((snapshot->axes[i].setpoint_speed_ticks_per_s_q8 != 0) ||
            (snapshot->axes[i].speed_ticks_per_s_q8 != 0)) {
            return true;
        }
    }
    return snapshot->order == (uint32_t)ARMING_STATE_MOVING;
}
