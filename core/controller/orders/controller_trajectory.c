/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/orders/controller_trajectory.h"

#include "base/contract.h"
#include "controller/controller_facts.h"
#include "controller/controller_order.h"

#include <string.h>

static const char contract_module[] = "controller";

/* Whether the list may be changed. */
static status_t judge_list(const controller_t *self, const command_t *command)
{
    status_t status = STATUS_OK;
    if (!controller_is_of_workphase(self, command)) {
        status = STATUS_WRONG_WORKPHASE;
    } else if (procedure_is_armed(&self->procedure)) {
        status = STATUS_NOT_AT_REST;
    } else {
        status = STATUS_OK;
    }
    return status;
}

status_t controller_obey_list_begin(controller_t *self, const cycle_t *cycle,
                                    const command_t *command, answer_t *answer)
{
    (void)cycle;
    (void)answer;
    trajectory_list_t *const list = &self->mode.sealed.list;
    status_t status = judge_list(self, command);
    if (status == STATUS_OK) {
        status = trajectory_list_begin(list, command_as_list_begin(command)->count);
    }
    if (status == STATUS_OK) {
        list->source = (command->source == (uint32_t)COMMAND_SOURCE_HTTP)
                           ? (uint32_t)TRAJECTORY_SOURCE_HTTP
                           : (uint32_t)TRAJECTORY_SOURCE_IGTL;
        list->peer = command->peer;
    }
    return status;
}

status_t controller_obey_list_row(controller_t *self, const cycle_t *cycle,
                                  const command_t *command, answer_t *answer)
{
    const status_t status = judge_list(self, command);
    if (status != STATUS_OK) {
        return status;
    }
    const command_row_t *const sent = command_as_row(command);
    trajectory_row_t row = {.time_ms = sent->time_ms};
    (void)memcpy(row.ticks, sent->ticks, sizeof row.ticks);
    (void)memcpy(row.speeds_ticks_per_s, sent->speeds_ticks_per_s, sizeof row.speeds_ticks_per_s);
    const solution_t judged =
        trajectory_list_add(&self->mode.sealed.list, self->rows, cycle->robot, sent->index, &row);
    controller_blame(answer, &judged);
    return judged.status;
}

status_t controller_obey_list_end(controller_t *self, const cycle_t *cycle,
                                  const command_t *command, answer_t *answer)
{
    trajectory_list_t *const list = &self->mode.sealed.list;
    const uint32_t checksum = command_as_list(command)->checksum;
    status_t status = judge_list(self, command);
    if (status == STATUS_OK) {
        status = trajectory_list_end(list, checksum);
    }
    if (status == STATUS_OK) {
        answer->as.checksum.checksum = checksum;
        controller_note(self, cycle, EVENT_TRAJECTORY_HELD, 0U, (int32_t)list->count);
    }
    return status;
}

solution_t controller_hold(controller_t *self, const robot_t *robot, const trajectory_row_t *rows,
                           uint32_t count, uint32_t *row)
{
    REQUIRE(102U, self->sealed.has_started == 0U);
    trajectory_list_t *const list = &self->mode.sealed.list;
    uint32_t crc = 0U;
    solution_t result = {.status = trajectory_list_begin(list, count)};
    *row = 0U;
    for (uint32_t i = 0U; (i < count) && (result.status == STATUS_OK); i++) {
        crc = trajectory_list_crc(crc, &rows[i]);
        *row = i;
        result = trajectory_list_add(list, self->rows, robot, i, &rows[i]);
    }
    if (result.status == STATUS_OK) {
        result.status = trajectory_list_end(list, crc);
        list->source = (uint32_t)TRAJECTORY_SOURCE_FILE;
    }
    controller_seal(self);
    return result;
}

solution_t controller_judge_trajectory(const controller_t *self, const cycle_t *cycle, uint32_t crc)
{
    const trajectory_t trajectory = {.list = &self->mode.sealed.list, .rows = self->rows};
    return trajectory_mode_judge(&trajectory, crc, cycle->robot, self->axes);
}
