/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/workphase/workphase_needle.h"

#include "igtl/dialect/igtl_units.h"
#include "limits/requirement_limits.h"
#include "robot/probe.h"

#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define NM_PER_MM 1000000.0

/* The length that a peer sends as the robot's needle, NULL for none. */
static const reported_length_t *find_length(const robot_t *robot)
{
    for (uint32_t i = 0U; i < ROBOT_REPORTED_LENGTHS; i++) {
        if (strcmp(robot->reported_lengths[i].name, "needle_length") == 0) {
            return &robot->reported_lengths[i];
        }
    }
    return NULL;
}

/* A whole number text; a text that is no number is no length. */
static bool is_length(const char *text, int32_t length_nm)
{
    char *end;
    const double length_mm = strtod(text, &end);
    const double away_nm = (length_mm * NM_PER_MM) - (double)length_nm;

    return (end != text) && (*end == '\0') && (away_nm <= (double)LIMIT_NEEDLE_LENGTH_NM) &&
           (away_nm >= -(double)LIMIT_NEEDLE_LENGTH_NM);
}

static void send_verdict(const workphase_peer_t *peer, int32_t length_nm, const char *said,
                         const igtl_moment_t *moment)
{
    char text[IGTL_REASON_SIZE];
    const bool is_right = is_length(said, length_nm);
    const igtl_status_t status = {is_right ? (uint32_t)IGTL_STATUS_OK
                                           : (uint32_t)IGTL_STATUS_CONFIG_ERROR,
                                  is_right ? "NEEDLE_LENGTH" : "CONFIG_ERROR", text};

    (void)snprintf(text, sizeof text, "%sThe robot is set to a needle of %.3f mm.",
                   is_right ? "" : "CONFIG_ERROR: ", igtl_units_mm(length_nm));
    igtl_send_status(peer->outbox, "NEEDLE_LENGTH", &status, moment);
}

void workphase_needle_send_length(workphase_peer_t *peer, const robot_t *robot,
                                  const igtl_message_t *message, const igtl_moment_t *moment)
{
    const reported_length_t *reported = find_length(robot);
    igtl_packet_t packet;
    char said[IGTL_TEXT_MAX + 1U];
    const uint32_t length =
        (message->text_bytes < IGTL_TEXT_MAX) ? message->text_bytes : IGTL_TEXT_MAX;

    (void)memcpy(said, message->text, length);
    said[length] = '\0';
    igtl_encode_string(&packet, "ACK_NEEDLE_LENGTH", said, moment->timestamp);
    igtl_outbox_add(peer->outbox, &packet);
    if (reported == NULL) {
        igtl_send_refusal(peer->outbox, "NEEDLE_LENGTH", STATUS_UNKNOWN_COMMAND, moment);
    } else if (moment->snapshot == NULL) {
        igtl_send_refusal(peer->outbox, "NEEDLE_LENGTH", STATUS_NO_ANSWER, moment);
    } else if (moment->snapshot->has_probe == 0U) {
        igtl_send_refusal(peer->outbox, "NEEDLE_LENGTH", STATUS_NO_PROBE, moment);
    } else {
        send_verdict(peer, probe_reported_nm(reported, moment->snapshot->probe_nm), said, moment);
    }
}
