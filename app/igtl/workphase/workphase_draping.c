/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/workphase/workphase_draping.h"

#include <string.h>

bool workphase_draping_is_ahead(const workphase_command_t *word, const igtl_moment_t *moment)
{
    return (strcmp(word->word, WORKPHASE_COMMAND_DRAPING) == 0) && (moment->snapshot != NULL) &&
           (moment->snapshot->workphase != (uint32_t)WORKPHASE_MANUAL);
}

/* Its id, 0 when too many are on their way. */
static uint32_t ask(workphase_dialect_t *self, uint32_t index, command_t command,
                    const igtl_moment_t *moment)
{
    workphase_peer_t *peer = &self->peers[index];
    command.peer = peer->number;
    const igtl_request_t *entry =
        igtl_requests_add(&self->requests, index, &command, moment->answer_clock_us);

    peer->tip.is_waiting = false;
    peer->pending = (entry == NULL) ? peer->pending : entry->id;
    return (entry == NULL) ? 0U : entry->id;
}

status_t workphase_draping_begin(workphase_dialect_t *self, uint32_t peer,
                                 const igtl_moment_t *moment)
{
    const command_t command = {.kind = (uint32_t)COMMAND_WORKPHASE,
                               .as.workphase = {.workphase = (uint32_t)WORKPHASE_MANUAL}};
    const uint32_t id = ask(self, peer, command, moment);

    self->peers[peer].draping = id;
    return (id == 0U) ? STATUS_BUSY : STATUS_OK;
}

void workphase_draping_go_on(workphase_dialect_t *self, uint32_t peer, const igtl_moment_t *moment)
{
    const command_t command = {.kind = (uint32_t)COMMAND_POSE,
                               .as.pose_name = {.pose = (uint32_t)POSE_DRAPING}};

    self->peers[peer].motion = WORKPHASE_COMMAND_DRAPING;
    if (ask(self, peer, command, moment) == 0U) {
        igtl_send_refusal(self->peers[peer].outbox, WORKPHASE_COMMAND_DRAPING, STATUS_BUSY, moment);
    }
}
