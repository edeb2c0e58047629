/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/lists/workphase_array.h"

#include "igtl/lists/workphase_lists.h"

#include <stddef.h>

status_t workphase_array_take(workphase_array_t *self, const workphase_list_t *list,
                              const robot_t *robot, uint32_t peer, const igtl_message_t *message)
{
    status_t status = STATUS_OK;

    if (self->is_busy) {
        return STATUS_BUSY;
    }
    if ((message->rows == 0U) || (message->rows > list->most) ||
        (message->columns != list->columns(robot))) {
        return STATUS_OUT_OF_RANGE;
    }
    self->list = list;
    self->robot = robot;
    self->has_failed = false;
    self->is_owed = false;
    self->peer = peer;
    self->next = 0U;
    self->count = message->rows;
    self->crc = 0U;
    for (uint32_t i = 0U; (i < self->count) && (status == STATUS_OK); i++) {
        status = list->read_row(robot, message, i, &self->items[i]);
        self->crc = (status == STATUS_OK) ? list->sum(self->crc, &self->items[i]) : 0U;
    }
    self->is_busy = status == STATUS_OK;
    return status;
}

bool workphase_array_is_awaited(const igtl_requests_t *requests, uint32_t peer)
{
    bool is_awaited = false;

    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        const igtl_request_t *request = &requests->requests[i];

        is_awaited = is_awaited || ((request->id != 0U) && (request->peer == peer) &&
                                    (workphase_lists_of(request->command.kind) != NULL));
    }
    return is_awaited;
}

bool workphase_array_has(const workphase_array_t *self, const igtl_request_t *request)
{
    return self->is_busy && (request->id != 0U) && (request->peer == self->peer) &&
           (workphase_lists_of(request->command.kind) != NULL);
}

static uint32_t on_their_way(const workphase_array_t *self, const igtl_requests_t *requests)
{
    uint32_t count = 0U;

    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        count += workphase_array_has(self, &requests->requests[i]) ? 1U : 0U;
    }
    return count;
}

static command_t command_of(const workphase_array_t *self, uint32_t number)
{
    const workphase_list_t *list = self->list;
    command_t command = {.kind = (uint32_t)list->end, .as.list = {.checksum = self->crc}};

    if (self->next == 0U) {
        command =
            (command_t){.kind = (uint32_t)list->begin, .as.list_begin = {.count = self->count}};
    } else if (self->next <= self->count) {
        command = list->command(self->robot, self->next - 1U, &self->items[self->next - 1U]);
    } else {
        /* It is the end. */
    }
    command.peer = number;
    return command;
}

void workphase_array_step(workphase_array_t *self, igtl_requests_t *requests, uint32_t number,
                          uint64_t now_us)
{
    uint32_t waiting = self->is_busy ? on_their_way(self, requests) : 0U;
    bool is_going_on = self->is_busy && !self->has_failed;

    while (is_going_on && (self->next <= (self->count + 1U)) &&
           (waiting < LIMIT_TRAJECTORY_ARRAY_AT_ONCE)) {
        command_t command = command_of(self, number);

        is_going_on = igtl_requests_add(requests, self->peer, &command, now_us) != NULL;
        self->next += is_going_on ? 1U : 0U;
        waiting++;
    }
    if (self->has_failed && (waiting == 0U)) {
        self->is_busy = false;
    }
}

bool workphase_array_fail(workphase_array_t *self)
{
    const bool is_first = !self->has_failed;

    self->has_failed = true;
    return is_first;
}

void workphase_array_end(workphase_array_t *self, uint32_t peer)
{
    if (self->peer == peer) {
        self->is_busy = false;
        self->is_owed = false;
    }
}
