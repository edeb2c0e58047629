/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/dialect/igtl_requests.h"

#include "procedure/command_kinds.h"

#include <stddef.h>
#include <string.h>

#define FORGET_US UINT64_C(10000000) /* A request that was never answered. */

void igtl_requests_init(igtl_requests_t *self, uint32_t first_id, uint32_t most)
{
    (void)memset(self, 0, sizeof *self);
    self->most = most;
    self->next_id = first_id;
}

static igtl_request_t *entry_with(igtl_requests_t *self, uint32_t id)
{
    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        if (self->requests[i].id == id) {
            return &self->requests[i];
        }
    }
    return NULL;
}

/* STOP or EMERGENCY: never refused for want of a place. */
static bool is_urgent(const igtl_request_t *request)
{
    return command_kinds_is_stop(&request->command);
}

static bool is_queued(const igtl_requests_t *self, uint32_t id)
{
    for (uint32_t i = 0U; i < self->queued; i++) {
        if (self->queue[i].id == id) {
            return true;
        }
    }
    return false;
}

static void remove_queued(igtl_requests_t *self, uint32_t id)
{
    uint32_t kept = 0U;

    for (uint32_t i = 0U; i < self->queued; i++) {
        if (self->queue[i].id != id) {
            self->queue[kept] = self->queue[i];
            kept++;
        }
    }
    self->queued = kept;
}

/* A place for a command that may be refused. */
static igtl_request_t *common_place(igtl_requests_t *self, uint32_t peer)
{
    uint32_t all = 0U;
    uint32_t own = 0U;

    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        const igtl_request_t *request = &self->requests[i];

        if ((request->id != 0U) && !is_urgent(request)) {
            all++;
            own += ((request->peer == peer) && !request->is_accepted) ? 1U : 0U;
        }
    }
    return ((all < self->most) && (own < IGTL_REQUESTS_PER_PEER)) ? entry_with(self, 0U) : NULL;
}

/* The newest request of this peer and kind, NULL for none. */
static igtl_request_t *newest_of(igtl_requests_t *self, uint32_t peer, workphase_t asked)
{
    igtl_request_t *newest = NULL;

    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        igtl_request_t *request = &self->requests[i];

        if ((request->id != 0U) && is_urgent(request) &&
            (command_kinds_workphase(&request->command) == asked) && (request->peer == peer) &&
            ((newest == NULL) || (request->sent_us >= newest->sent_us))) {
            newest = request;
        }
    }
    return newest;
}

/* A place for STOP or EMERGENCY. When all of its kind are taken and this peer has its share not yet
 * used up, some are of peers that have gone: no peer waits for their answers. */
static igtl_request_t *urgent_place(igtl_requests_t *self, uint32_t peer, workphase_t asked)
{
    uint32_t all = 0U;
    uint32_t own = 0U;
    igtl_request_t *place;

    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        const igtl_request_t *request = &self->requests[i];

        if ((request->id != 0U) && is_urgent(request) &&
            (command_kinds_workphase(&request->command) == asked)) {
            all++;
            own += (request->peer == peer) ? 1U : 0U;
        }
    }
    if (own >= IGTL_REQUESTS_PER_PEER) {
        place = newest_of(self, peer, asked);
    } else if (all >= IGTL_REQUESTS_URGENT) {
        place = newest_of(self, IGTL_NOBODY, asked);
    } else {
        return entry_with(self, 0U);
    }
    if (place != NULL) {
        remove_queued(self, place->id);
    }
    return place;
}

static igtl_request_t *place_for(igtl_requests_t *self, uint32_t peer, const command_t *command)
{
    if (command_kinds_is_stop(command)) {
        return urgent_place(self, peer, command_kinds_workphase(command));
    }
    return (command->kind == (uint32_t)COMMAND_RELEASE) ? entry_with(self, 0U)
                                                        : common_place(self, peer);
}

const igtl_request_t *igtl_requests_add(igtl_requests_t *self, uint32_t peer, command_t *command,
                                        uint64_t now_us)
{
    igtl_request_t *request = place_for(self, peer, command);

    if (request == NULL) {
        return NULL;
    }
    command->id = self->next_id;
    command->source = (uint32_t)COMMAND_SOURCE_IGTL;
    self->next_id += IGTL_REQUEST_ID_STEP;
    if (self->next_id < IGTL_REQUEST_ID_STEP) {
        self->next_id += IGTL_REQUEST_ID_STEP;
    }
    self->queue[self->queued] = *command;
    self->queued++;
    *request =
        (igtl_request_t){.id = command->id, .peer = peer, .command = *command, .sent_us = now_us};
    return request;
}

igtl_request_t *igtl_requests_find(igtl_requests_t *self, uint32_t id)
{
    return (id == 0U) ? NULL : entry_with(self, id);
}

void igtl_requests_end(igtl_request_t *request)
{
    request->id = 0U;
}

igtl_request_t *igtl_requests_overdue(igtl_requests_t *self, uint64_t now_us)
{
    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        igtl_request_t *request = &self->requests[i];
        const uint64_t age_us = now_us - request->sent_us;

        if ((request->id != 0U) && !request->is_accepted) {
            if (!request->is_overdue && (age_us >= IGTL_ANSWER_TIMEOUT_US)) {
                request->is_overdue = true;
                return request;
            }
            if ((age_us >= FORGET_US) && !is_queued(self, request->id)) {
                igtl_requests_end(request);
            }
        }
    }
    return NULL;
}

void igtl_requests_keep(igtl_requests_t *self, const command_t *command)
{
    self->queue[self->queued] = *command;
    self->queued++;
}

bool igtl_requests_take(igtl_requests_t *self, command_t *command)
{
    if (self->queued == 0U) {
        return false;
    }
    *command = self->queue[0];
    self->queued--;
    (void)memmove(&self->queue[0], &self->queue[1], self->queued * sizeof self->queue[0]);
    return true;
}
