/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/workphase/workphase_progress.h"

#include "interface/mode_list.h"

#include <stddef.h>
#include <stdio.h>

#define PROGRESS_SIZE 64U
#define US_PER_S 1e6

void workphase_progress_send(workphase_peer_t *peer, const igtl_moment_t *moment)
{
    const snapshot_t *shown = moment->snapshot;
    char text[PROGRESS_SIZE] = "0";
    igtl_packet_t packet;

    if (shown == NULL) {
        igtl_send_refusal(peer->outbox, WORKPHASE_PROGRESS, STATUS_NO_ANSWER, moment);
        return;
    }
    if (shown->program_steps != 0U) {
        (void)snprintf(text, sizeof text, "%u %u %u %.1f s", (unsigned)shown->program_steps,
                       (unsigned)shown->program_crc, (unsigned)shown->program_step,
                       (double)shown->program_dwelt_us / US_PER_S);
    }
    igtl_encode_string(&packet, WORKPHASE_PROGRESS, text, moment->timestamp);
    igtl_outbox_add(peer->outbox, &packet);
}

void workphase_progress_follow(workphase_peer_t *peer, const igtl_moment_t *moment)
{
    const snapshot_t *shown = moment->snapshot;

    if ((shown != NULL) && (shown->mode == (uint32_t)MODE_PROGRAM) &&
        (shown->program_step != peer->steps_reported)) {
        peer->steps_reported = shown->program_step;
        workphase_progress_send(peer, moment);
    }
}
