/* SPDX-License-Identifier: Apache-2.0 */
#include "fuzz/dialect_requests.h"

#include "igtl/workphase/workphase_commands.h"
#include "procedure/command_kinds.h"

#include <string.h>

bool request_is_queued(const world_t *world, workphase_t phase)
{
    const igtl_requests_t *requests = &world->workphase.requests;

    for (uint32_t i = 0U; i < requests->queued; i++) {
        if (command_kinds_workphase(&requests->queue[i]) == phase) {
            return true;
        }
    }
    return false;
}

bool request_waits(const world_t *world, uint32_t place)
{
    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        const igtl_request_t *request = &world->workphase.requests.requests[i];

        if ((request->id != 0U) && (request->peer == place) && !request->is_accepted &&
            !request->is_overdue) {
            return true;
        }
    }
    return false;
}

const igtl_request_t *request_find(const igtl_requests_t *requests, uint32_t id)
{
    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        if (requests->requests[i].id == id) {
            return &requests->requests[i];
        }
    }
    return NULL;
}

bool request_is_urgent(const igtl_request_t *request)
{
    return command_kinds_is_stop(&request->command);
}

bool request_has_newer(const world_t *world, const igtl_request_t *request)
{
    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        const igtl_request_t *other = &world->workphase.requests.requests[i];

        if ((other->id != 0U) && (other->id != request->id) && (other->peer == request->peer) &&
            (memcmp(&other->command.as, &request->command.as, sizeof other->command.as) == 0) &&
            (other->command.kind == request->command.kind)) {
            return true;
        }
    }
    return false;
}

bool request_is_draping(const world_t *world, const igtl_request_t *pose)
{
    const char *motion = (pose == NULL) ? NULL : world->workphase.peers[pose->peer].motion;

    return (motion != NULL) && (strcmp(motion, WORKPHASE_COMMAND_DRAPING) == 0) &&
           (pose->command.kind == (uint32_t)COMMAND_POSE) &&
           (pose->command.as.pose_name.pose == (uint32_t)POSE_DRAPING);
}

bool request_goes_on_draping(const world_t *world, const igtl_request_t *was)
{
    const workphase_peer_t *peer = &world->workphase.peers[was->peer];

    return (command_kinds_workphase(&was->command) == WORKPHASE_MANUAL) &&
           request_is_draping(world, request_find(&world->workphase.requests, peer->pending));
}

bool request_is_of_array(const world_t *world, uint32_t place, const command_t *command)
{
    const igtl_request_t request = {.id = command->id, .peer = place, .command = *command};

    return workphase_array_has(&world->workphase.array, &request);
}

bool authority_is_held_by_lost(const world_t *world)
{
    const snapshot_t *shown = world->moment.snapshot;
    bool is_there = (shown == NULL) || (shown->holder_peer == 0U) ||
                    (shown->holder != (uint32_t)COMMAND_SOURCE_IGTL);

    for (uint32_t i = 0U; i < WORLD_PEERS; i++) {
        is_there = is_there ||
                   (world->peers[i].is_connected && (world->peers[i].number == shown->holder_peer));
    }
    return !is_there;
}

bool request_is_releasing(const world_t *world)
{
    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        const igtl_request_t *request = &world->workphase.requests.requests[i];

        if ((request->id != 0U) && (request->command.kind == (uint32_t)COMMAND_RELEASE)) {
            return true;
        }
    }
    return false;
}
