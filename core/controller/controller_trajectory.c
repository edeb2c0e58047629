/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/controller_trajectory.h"

#include <string.h>

static status_t begin_list(controller_t *self, const command_t *command)
{
    trajectory_list_t *const list = &self->mode.list;
    const status_t status = trajectory_list_begin(list, command->argument);
    if (status == STATUS_OK) {
        list->source = command->source;
        list->peer = command->peer;
    }
    return status;
}

static status_t add_row(controller_t *self, const cycle_t *cycle, const command_t *command,
                        answer_t *answer)
{
    trajectory_row_t row = {.time_ms = (uint32_t)command->value};
    (void)memcpy(row.ticks, command->ticks, sizeof row.ticks);
    (void)memcpy(row.speeds_ticks_per_s, command->speeds, sizeof row.speeds_ticks_per_s);
    const solution_t judged =
        trajectory_list_add(&self->mode.list, self->rows, cycle->robot, command->argument, &row);
    answer->axis = (uint32_t)judged.axis;
    answer->is_maximum = (uint32_t)judged.is_maximum;
    return judged.status;
}

status_t controller_obey_trajectory(controller_t *self, const cycle_t *cycle,
                                    const command_t *command, answer_t *answer)
{
    status_t status = STATUS_OK;
    if (procedure_workphase(&self->procedure) != WORKPHASE_MANUAL) {
        status = STATUS_WRONG_WORKPHASE;
    } else if (procedure_is_armed(&self->procedure)) {
        status = STATUS_NOT_AT_REST;
    } else if (command->kind == (uint32_t)COMMAND_LIST_BEGIN) {
        status = begin_list(self, command);
    } else if (command->kind == (uint32_t)COMMAND_LIST_ROW) {
        status = add_row(self, cycle, command, answer);
    } else {
        status = trajectory_list_end(&self->mode.list, command->argument);
        if (status == STATUS_OK) {
            controller_note(self, cycle, EVENT_TRAJECTORY_HELD, 0U, (int32_t)self->mode.list.count);
        }
    }
    return status;
}

solution_t controller_judge_trajectory(const controller_t *self, const cycle_t *cycle, uint32_t crc)
{
    const trajectory_t trajectory = {.list = &self->mode.list, .rows = self->rows};
    return trajectory_mode_judge(&trajectory, crc, cycle->robot, self->axes);
}
