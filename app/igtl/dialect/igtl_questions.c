/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/dialect/igtl_questions.h"

#include "charts/arming_chart.h"
#include "igtl/dialect/igtl_forces.h"
#include "igtl/dialect/igtl_units.h"
#include "interface/app/names.h"
#include "limits/requirement_limits.h"

#include <stdio.h>
#include <string.h>

#define US_PER_MS UINT64_C(1000)
#define REPLY_SIZE (IGTL_TEXT_MAX + 1U)

#define BEFORE 1U /* Only of who commands. */
#define BEHIND 2U /* Only of who shows points and takes proposals. */

static const char *const understood[] = {
    "NDARRAY",    "TRANSFORM", "STRING",    "STATUS",  "GET_TRANS", "GET_STATUS", "GET_CAPABIL",
    "GET_SENSOR", "STT_TDATA", "STP_TDATA", "COMMAND", "GET_POINT", "TRAJ"};

static const char *const *understood_by(igtl_language_t language, uint32_t *count)
{
    const uint32_t all = (uint32_t)(sizeof understood / sizeof understood[0]);
    const bool is_crtk = language == IGTL_LANGUAGE_CRTK;

    *count = is_crtk ? (all - BEFORE) : (all - BEHIND);
    return is_crtk ? &understood[BEFORE] : understood;
}

static void send_capability(igtl_outbox_t *outbox, const char *name, igtl_language_t language,
                            const igtl_moment_t *moment)
{
    igtl_packet_t packet;
    uint32_t count;
    const char *const *types = understood_by(language, &count);

    igtl_encode_capability(&packet, name, types, count, moment->timestamp);
    igtl_outbox_add(outbox, &packet);
}

/* RTS_x for STT_x and STP_x. */
static void send_return(igtl_outbox_t *outbox, const igtl_message_t *message, bool is_refused,
                        const igtl_moment_t *moment)
{
    igtl_packet_t packet;
    char type[IGTL_TYPE_SIZE];

    (void)memcpy(type, message->type, IGTL_TYPE_SIZE);
    (void)memcpy(type, "RTS", 3U);
    igtl_encode_return(&packet, type, message->name, is_refused, moment->timestamp);
    igtl_outbox_add(outbox, &packet);
}

/* Clients ask for 0, as fast as possible; no client needs more than it can show. */
static uint64_t interval_of(int32_t resolution_ms)
{
    const uint64_t asked_us = (resolution_ms <= 0) ? 0U : ((uint64_t)resolution_ms * US_PER_MS);

    if (asked_us < LIMIT_IGTL_TRACKING_LEAST_US) {
        return LIMIT_IGTL_TRACKING_LEAST_US;
    }
    return (asked_us > LIMIT_IGTL_TRACKING_MOST_US) ? LIMIT_IGTL_TRACKING_MOST_US : asked_us;
}

static void begin_tracking(igtl_tracking_t *tracking, const igtl_message_t *message,
                           const igtl_moment_t *moment)
{
    *tracking = (igtl_tracking_t){.is_wanted = true,
                                  .interval_us = interval_of(message->resolution_ms),
                                  .next_us = moment->now_us,
                                  .reported_status = (uint32_t)STATUS_OK};
    (void)memcpy(tracking->name, message->name, IGTL_NAME_SIZE);
}

static bool is_named(const igtl_message_t *command, const char *name)
{
    return (command->subject_bytes == strlen(name)) &&
           (memcmp(command->subject, name, command->subject_bytes) == 0);
}

static void write_status(const robot_t *robot, char text[REPLY_SIZE], const igtl_moment_t *moment)
{
    const snapshot_t *snapshot = moment->snapshot;
    size_t used;

    if (snapshot == NULL) {
        (void)snprintf(text, REPLY_SIZE, "<Status Pose=\"%s\"/>", status_name(STATUS_NO_ANSWER));
        return;
    }
    used = (size_t)snprintf(
        text, REPLY_SIZE,
        "<Status Workphase=\"%s\" Pose=\"%s\" Homed=\"%u\" Registered=\"%u\" Target=\"%u\" "
        "Moving=\"%u\"",
        workphase_name((int32_t)snapshot->workphase), status_name((int32_t)snapshot->pose_status),
        (unsigned)snapshot->is_homed, (unsigned)snapshot->is_registered,
        (unsigned)snapshot->has_target,
        (snapshot->order == (uint32_t)ARMING_STATE_MOVING) ? 1U : 0U);
    used += igtl_forces_write(robot, snapshot, &text[used], REPLY_SIZE - used);
    (void)snprintf(&text[used], REPLY_SIZE - used, "/>");
}

static void write_capabilities(igtl_language_t language, char text[REPLY_SIZE])
{
    size_t used = (size_t)snprintf(text, REPLY_SIZE, "<Capabilities Types=\"");
    uint32_t count;
    const char *const *types = understood_by(language, &count);

    for (uint32_t i = 0U; i < count; i++) {
        used += (size_t)snprintf(&text[used], REPLY_SIZE - used, "%s%s", (i == 0U) ? "" : " ",
                                 types[i]);
    }
    (void)snprintf(&text[used], REPLY_SIZE - used, "\"/>");
}

static void answer_command(const igtl_asker_t *asker, const igtl_message_t *command,
                           const igtl_moment_t *moment)
{
    igtl_packet_t packet;
    char text[REPLY_SIZE] = "<Unsupported Known=\"Status Capabilities\"/>";
    bool is_refused = false;

    if (is_named(command, "Status")) {
        write_status(asker->robot, text, moment);
    } else if (is_named(command, "Capabilities")) {
        write_capabilities(asker->language, text);
    } else {
        is_refused = true;
    }
    igtl_encode_command_reply(&packet, command, is_refused, text, moment->timestamp);
    igtl_outbox_add(asker->outbox, &packet);
}

bool igtl_questions_receive(igtl_tracking_t *tracking, const igtl_asker_t *asker,
                            const igtl_message_t *message, const igtl_moment_t *moment)
{
    igtl_outbox_t *outbox = asker->outbox;

    switch ((int)message->kind) {
    case IGTL_KIND_GET_CAPABILITY:
        send_capability(outbox, message->name, asker->language, moment);
        return true;
    case IGTL_KIND_GET_SENSOR:
        igtl_forces_report(outbox, asker->robot, message->name, moment);
        return true;
    case IGTL_KIND_GET_POINT:
    case IGTL_KIND_GET_OTHER:
        igtl_send_not_found(outbox, message->name, moment);
        return true;
    case IGTL_KIND_STT_TDATA:
        send_return(outbox, message, false, moment);
        begin_tracking(tracking, message, moment);
        return true;
    case IGTL_KIND_STP_TDATA:
        tracking->is_wanted = false;
        send_return(outbox, message, false, moment);
        return true;
    case IGTL_KIND_STT_OTHER:
    case IGTL_KIND_STP_OTHER:
        send_return(outbox, message, true, moment);
        return true;
    case IGTL_KIND_COMMAND:
        answer_command(asker, message, moment);
        return true;
    default:
        return false;
    }
}

static void send_needle(const igtl_tracking_t *tracking, igtl_outbox_t *outbox,
                        const igtl_moment_t *moment)
{
    igtl_packet_t packet;
    igtl_tracked_t needle = {.name = "needle"};

    igtl_units_write_pose(&moment->snapshot->scanner_treatment, needle.numbers);
    igtl_encode_tracking(&packet, tracking->name, &needle, 1U, moment->timestamp);
    igtl_outbox_add_state(outbox, &packet);
}

void igtl_questions_step(igtl_tracking_t *tracking, igtl_outbox_t *outbox,
                         const igtl_moment_t *moment)
{
    const status_t status = igtl_pose_status(moment);

    if (!tracking->is_wanted) {
        return;
    }
    if (status != STATUS_OK) {
        if (tracking->reported_status != (uint32_t)status) {
            igtl_send_refusal(outbox, tracking->name, status, moment);
        }
    } else if (moment->now_us >= tracking->next_us) {
        send_needle(tracking, outbox, moment);
        tracking->next_us = moment->now_us + tracking->interval_us;
    } else {
        /* Not yet. */
    }
    tracking->reported_status = (uint32_t)status;
}
