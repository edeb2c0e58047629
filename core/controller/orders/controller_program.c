/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/orders/controller_program.h"

#include "controller/controller_facts.h"
#include "controller/controller_order.h"

static status_t add_step(controller_t *self, const cycle_t *cycle, const command_t *command,
                         answer_t *answer)
{
    const robot_t *const robot = cycle->robot;
    const command_step_t *const sent = command_as_step(command);
    program_step_t step = {.dwell_ms = sent->dwell_ms, .is_gated = sent->is_gated};
    program_step_place(robot, sent->ticks, &step);
    const solution_t judged =
        program_list_add(&self->program, robot, self->plan.target_ticks, sent->index, &step);
    controller_blame(answer, &judged);
    return judged.status;
}

static status_t change(controller_t *self, const cycle_t *cycle, const command_t *command,
                       answer_t *answer)
{
    status_t status = STATUS_OK;
    if (command->kind == (uint32_t)COMMAND_PROGRAM_BEGIN) {
        status = program_list_begin(&self->program, command_as_list_begin(command)->count,
                                    command->source, self->plan.target_ticks);
    } else if (command->kind == (uint32_t)COMMAND_PROGRAM_STEP) {
        status = add_step(self, cycle, command, answer);
    } else {
        const uint32_t checksum = command_as_list(command)->checksum;
        status = program_list_end(&self->program, checksum);
        if (status == STATUS_OK) {
            answer->as.checksum.checksum = checksum;
            controller_note(self, cycle, EVENT_PROGRAM_HELD, 0U, (int32_t)self->program.count);
        }
    }
    return status;
}

status_t controller_obey_program(controller_t *self, const cycle_t *cycle, const command_t *command,
                                 answer_t *answer)
{
    status_t status = STATUS_OK;
    if (!controller_is_of_workphase(self, command)) {
        status = STATUS_WRONG_WORKPHASE;
    } else if (procedure_is_armed(&self->procedure)) {
        status = STATUS_MOTION_ARMED;
    } else if (self->plan.has_target == 0U) {
        status = STATUS_NO_TARGET;
    } else {
        status = change(self, cycle, command, answer);
    }
    return status;
}

solution_t controller_judge_program(const controller_t *self, const cycle_t *cycle, uint32_t crc,
                                    const move_mode_t *target)
{
    return program_mode_judge(&self->program, crc, target, cycle->robot, self->axes,
                              cycle->inputs->treatment_stopped != 0U);
}
