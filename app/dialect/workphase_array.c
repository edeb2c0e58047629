/* SPDX-License-Identifier: Apache-2.0 */
#include "dialect/workphase_array.h"

#include "dialect/igtl_border.h"

#include <string.h>

static bool is_of_list(uint32_t kind)
{
    return (kind == (uint32_t)COMMAND_LIST_BEGIN) || (kind == (uint32_t)COMMAND_LIST_ROW) ||
           (kind == (uint32_t)COMMAND_LIST_END);
}

static status_t read_row(const igtl_message_t *message, uint32_t index, uint32_t axes,
                         trajectory_row_t *row)
{
    const uint32_t first = index * message->columns;
    int32_t time_ms = 0;
    status_t status = igtl_border_read_whole(message, first, &time_ms);

    if ((status == STATUS_OK) && (time_ms < 0)) {
        status = STATUS_OUT_OF_RANGE;
    }
    *row = (trajectory_row_t){.time_ms = (uint32_t)time_ms};
    for (uint32_t i = 0U; (i < axes) && (status == STATUS_OK); i++) {
        status = igtl_border_read_whole(message, first + 1U + i, &row->ticks[i]);
        if (status == STATUS_OK) {
            status =
                igtl_border_read_whole(message, first + 1U + axes + i, &row->speeds_ticks_per_s[i]);
        }
    }
    return status;
}

status_t workphase_array_take(workphase_array_t *self, const robot_t *robot, uint32_t peer,
                              const igtl_message_t *message)
{
    status_t status = STATUS_OK;

    if (self->is_busy) {
        return STATUS_BUSY;
    }
    if ((message->rows == 0U) || (message->rows > LIMIT_TRAJECTORY_ROWS) ||
        (message->columns != (1U + (2U * robot->axis_count)))) {
        return STATUS_OUT_OF_RANGE;
    }
    self->has_failed = false;
    self->is_owed = false;
    self->peer = peer;
    self->next = 0U;
    self->count = message->rows;
    self->crc = 0U;
    for (uint32_t i = 0U; (i < self->count) && (status == STATUS_OK); i++) {
        status = read_row(message, i, robot->axis_count, &self->rows[i]);
        self->crc = trajectory_list_crc(self->crc, &self->rows[i]);
    }
    self->is_busy = status == STATUS_OK;
    return status;
}

bool workphase_array_is_awaited(const igtl_requests_t *requests, uint32_t peer)
{
    bool is_awaited = false;

    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        const igtl_request_t *request = &requests->requests[i];

        is_awaited = is_awaited ||
                     ((request->id != 0U) && (request->peer == peer) && is_of_list(request->kind));
    }
    return is_awaited;
}

bool workphase_array_has(const workphase_array_t *self, const igtl_request_t *request)
{
    return self->is_busy && (request->id != 0U) && (request->peer == self->peer) &&
           is_of_list(request->kind);
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
    command_t command = {.peer = number};

    if (self->next == 0U) {
        command.kind = (uint32_t)COMMAND_LIST_BEGIN;
        command.argument = self->count;
    } else if (self->next <= self->count) {
        const trajectory_row_t *row = &self->rows[self->next - 1U];

        command.kind = (uint32_t)COMMAND_LIST_ROW;
        command.argument = self->next - 1U;
        command.value = (int32_t)row->time_ms;
        (void)memcpy(command.ticks, row->ticks, sizeof command.ticks);
        (void)memcpy(command.speeds, row->speeds_ticks_per_s, sizeof command.speeds);
    } else {
        command.kind = (uint32_t)COMMAND_LIST_END;
        command.argument = self->crc;
    }
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
