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

static bool is_of_coupled_limit(const robot_t *robot, uint32_t status)
{
    bool is_one = false;
    for (uint32_t i = 0U; (i < robot->coupled_limit_count) && (i < ROBOT_COUPLED_LIMITS); i++) {
        is_one = is_one || (robot->coupled_limits[i].refusal == status);
    }
    return is_one;
}

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

void igtl_reason_text(const robot_t *robot, const answer_t *answer, const igtl_moment_t *moment,
                      char text[IGTL_REASON_SIZE])
{
    const int32_t status = (int32_t)answer->status;
    const char *limit = (answer->is_maximum != 0U) ? "upper" : "lower";

    if ((answer->status == (uint32_t)STATUS_AXIS_LIMIT) && (answer->axis < robot->axis_count)) {
        (void)snprintf(text, IGTL_REASON_SIZE, "%s: %s (%s, %s limit)", status_name(status),
                       status_text(status), robot->axes[answer->axis].name, limit);
    } else if ((answer->status == (uint32_t)STATUS_SWITCH_ZONE) &&
               (answer->axis < robot->axis_count)) {
        (void)snprintf(text, IGTL_REASON_SIZE, "%s: %s (%s)", status_name(status),
                       status_text(status), robot->axes[answer->axis].name);
    } else if (is_of_coupled_limit(robot, answer->status)) {
        (void)snprintf(text, IGTL_REASON_SIZE, "%s: %s (%s limit)", status_name(status),
                       status_text(status), limit);
    } else {
        write_reason((status_t)answer->status, moment, text);
    }
}

void igtl_tell_status(igtl_outbox_t *outbox, const char *name, const igtl_status_t *status,
                      const igtl_moment_t *moment)
{
    igtl_packet_t packet;

    igtl_encode_status(&packet, name, status, moment->timestamp);
    igtl_outbox_add(outbox, &packet);
}

void igtl_tell_refused(igtl_outbox_t *outbox, const char *name, const igtl_status_t *status,
                       const igtl_moment_t *moment)
{
    igtl_tell_status(outbox, name, status, moment);
    igtl_outbox_note_refusal(outbox, name, status->text);
}

void igtl_tell_refusal(igtl_outbox_t *outbox, const char *name, status_t status,
                       const igtl_moment_t *moment)
{
    char text[IGTL_REASON_SIZE];
    const igtl_status_t refusal = {igtl_reason_code(status), status_name((int32_t)status), text};

    write_reason(status, moment, text);
    igtl_tell_refused(outbox, name, &refusal, moment);
}

void igtl_tell_not_found(igtl_outbox_t *outbox, const char *name, const igtl_moment_t *moment)
{
    static const igtl_status_t status = {IGTL_STATUS_NOT_FOUND, "NOT_FOUND",
                                         "NOT_FOUND: There is nothing of this name."};

    igtl_tell_refused(outbox, name, &status, moment);
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

void igtl_tell_pose(igtl_outbox_t *outbox, const char *name, const rigid_t *pose,
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
