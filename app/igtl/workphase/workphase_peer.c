/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/workphase/workphase_peer.h"

#include "interface/app/names.h"
#include "interface/mode_list.h"
#include "limits/requirement_limits.h"
#include "igtl/wire/igtl_crc64.h"
#include "procedure/command_kinds.h"

#include <stdio.h>
#include <string.h>

#define COMMAND_PREFIX_LENGTH 4U /* "CMD_" */

static void acknowledgement_name(const igtl_message_t *message, uint32_t prefix_length,
                                 char name[IGTL_NAME_SIZE])
{
    (void)snprintf(name, IGTL_NAME_SIZE, "ACK_%.16s", &message->name[prefix_length]);
}

bool workphase_peer_is_motion(uint32_t kind)
{
    const uint32_t arming = (kind == (uint32_t)COMMAND_JOG_BY) ? (uint32_t)COMMAND_JOG : kind;

    for (uint32_t i = (uint32_t)MODE_NONE + 1U; i < MODE_KIND_COUNT; i++) {
        if ((mode_rows[i].command == arming) && (kind != (uint32_t)COMMAND_WORKPHASE)) {
            return true;
        }
    }
    return false;
}

static bool is_long(const igtl_request_t *request)
{
    const workphase_t asked = command_kinds_workphase(&request->command);

    return workphase_peer_is_motion(request->command.kind) || (asked == WORKPHASE_START_UP) ||
           (asked == WORKPHASE_MOVE_TO_TARGET);
}

bool workphase_peer_has_order(const workphase_dialect_t *self, uint32_t peer)
{
    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        const igtl_request_t *request = &self->requests.requests[i];

        if ((request->id != 0U) && (request->peer == peer) && request->is_accepted &&
            is_long(request)) {
            return true;
        }
    }
    return false;
}

void workphase_peer_acknowledge_string(workphase_peer_t *self, const igtl_message_t *message,
                                       const igtl_moment_t *moment)
{
    igtl_packet_t packet;
    char name[IGTL_NAME_SIZE];
    char text[IGTL_TEXT_MAX + 1U];
    const uint32_t length =
        (message->text_bytes < IGTL_TEXT_MAX) ? message->text_bytes : IGTL_TEXT_MAX;

    acknowledgement_name(message, COMMAND_PREFIX_LENGTH, name);
    (void)memcpy(text, message->text, length);
    text[length] = '\0';
    igtl_encode_string(&packet, name, text, moment->timestamp);
    igtl_outbox_add(self->outbox, &packet);
}

void workphase_peer_acknowledge_transform(workphase_peer_t *self, const igtl_message_t *message,
                                          uint32_t prefix_length, const igtl_moment_t *moment)
{
    igtl_packet_t packet;
    char name[IGTL_NAME_SIZE];

    acknowledgement_name(message, prefix_length, name);
    igtl_encode_transform(&packet, name, message->numbers, moment->timestamp);
    igtl_outbox_add(self->outbox, &packet);
}

bool workphase_peer_is_repeated(const workphase_peer_t *self, const igtl_message_t *message)
{
    const uint64_t crc = igtl_crc64(0U, (const uint8_t *)message->text, message->text_bytes);

    for (uint32_t i = 0U; i < WORKPHASE_IDS; i++) {
        if ((strcmp(self->ids[i].name, message->name) == 0) &&
            (self->ids[i].text_bytes == message->text_bytes) && (self->ids[i].text_crc == crc)) {
            return true;
        }
    }
    return false;
}

workphase_id_t *workphase_peer_remember(workphase_peer_t *self, const igtl_message_t *message)
{
    workphase_id_t *id = &self->ids[self->next_id];

    (void)memcpy(id->name, message->name, IGTL_NAME_SIZE);
    id->text_crc = igtl_crc64(0U, (const uint8_t *)message->text, message->text_bytes);
    id->text_bytes = message->text_bytes;
    id->request = 0U;
    self->next_id = (self->next_id + 1U) % WORKPHASE_IDS;
    return id;
}

void workphase_peer_forget(workphase_peer_t *self, uint32_t request)
{
    for (uint32_t i = 0U; i < WORKPHASE_IDS; i++) {
        if (self->ids[i].request == request) {
            self->ids[i] = (workphase_id_t){.name = ""};
        }
    }
}

void workphase_peer_defer(workphase_peer_t *self, const igtl_packet_t *packet, uint64_t now_us)
{
    if (self->extra_count == WORKPHASE_EXTRAS) {
        workphase_peer_send_deferred(self, now_us, true);
    }
    self->extras[self->extra_count].due_us = now_us + LIMIT_IGTL_EXTRA_DELAY_US;
    self->extras[self->extra_count].packet = *packet;
    self->extra_count++;
}

void workphase_peer_defer_pose(workphase_peer_t *self, const char *name, const rigid_t *pose,
                               const igtl_moment_t *moment)
{
    igtl_packet_t packet;

    igtl_pack_pose(&packet, name, pose, moment);
    workphase_peer_defer(self, &packet, moment->now_us);
}

void workphase_peer_send_deferred(workphase_peer_t *self, uint64_t now_us, bool all)
{
    uint32_t sent = 0U;

    while ((sent < self->extra_count) && (all || (self->extras[sent].due_us <= now_us))) {
        igtl_outbox_add(self->outbox, &self->extras[sent].packet);
        sent++;
    }
    self->extra_count -= sent;
    (void)memmove(&self->extras[0], &self->extras[sent],
                  self->extra_count * sizeof self->extras[0]);
}

void workphase_peer_cancel_deferred(workphase_peer_t *self)
{
    self->extra_count = 0U;
}

void workphase_peer_send_position(workphase_peer_t *self, const igtl_moment_t *moment)
{
    const status_t status = igtl_pose_status(moment);

    if (status != STATUS_OK) {
        igtl_send_refusal(self->outbox, "CURRENT_POSITION", status, moment);
        return;
    }
    igtl_send_pose(self->outbox, "CURRENT_POSITION", &moment->snapshot->scanner_treatment, moment);
}

void workphase_peer_send_phase(workphase_peer_t *self, uint32_t code, uint32_t phase,
                               const char *text, const igtl_moment_t *moment)
{
    const igtl_status_t status = {code, workphase_name((int32_t)phase), text};

    igtl_send_status(self->outbox, "CURRENT_STATUS", &status, moment);
}

void workphase_peer_send_unit(workphase_peer_t *self, const char *word, const char *form,
                              const igtl_moment_t *moment)
{
    char text[IGTL_REASON_SIZE];
    const char *name = status_name((int32_t)STATUS_WRONG_UNIT);
    const igtl_status_t refusal = {igtl_reason_code(STATUS_WRONG_UNIT), name, text};

    (void)snprintf(text, sizeof text, "%s: Send each number with its unit: %s.", name, form);
    igtl_send_refused(self->outbox, word, &refusal, moment);
}

const char *workphase_peer_tip_subject(const workphase_peer_t *self)
{
    return (self->language == IGTL_LANGUAGE_BRP_2021) ? "MOVE_TO_TARGET" : "NPOS";
}

void workphase_peer_send_flag(workphase_peer_t *self, const char *name, bool value,
                              const igtl_moment_t *moment)
{
    igtl_packet_t packet;

    igtl_encode_string(&packet, name, value ? "1" : "0", moment->timestamp);
    igtl_outbox_add(self->outbox, &packet);
}
