/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/orders/controller_program.h"

#include "controller/controller_facts.h"
#include "controller/controller_order.h"

/* Whether the list may be changed. */
static status_t judge_list(const controller_t *self, const command_t *command)
{
    status_t status = STATUS_OK;
    if (!controller_is_of_workphase(self, command)) {
        status = STATUS_WRONG_WORKPHASE;
    } else if (procedure_is_armed(&self->procedure)) {
        status = STATUS_MOTION_ARMED;
    } else if (self->plan.has_target == 0U) {
        status = STATUS_NO_TARGET;
    } else {
        status = STATUS_OK;
    }
    return status;
}

status_t controller_obey_program_begin(controller_t *self, const cycle_t *cycle,
                                       const command_t *command, answer_t *answer)
{
    (void)cycle;
    (void)answer;
    const status_t judged = judge_list(self, command);
    return (judged == STATUS_OK)
               ? program_list_begin(&self->program, command_as_list_begin(command)->count,
                                    command->source, self->plan.target_ticks)
               : judged;
}

status_t controller_obey_program_step(controller_t *self, const cycle_t *cycle,
                                      const command_t *command, answer_t *answer)
{
    const status_t status = judge_list(self, command);
    if (status != STATUS_OK) {
        return status;
    }
    const robot_t *const robot = cycle->robot;
    const command_step_t *const sent = command_as_step(command);
    program_step_t step = {.dwell_ms = sent->dwell_ms, .is_gated = sent->is_gated};
    program_step_place(robot, sent->ticks, &step);
    const solution_t judged =
        program_list_add(&self->program, robot, self->plan.target_ticks, sent->index, &step);
    controller_blame(answer, &judged);
    return judged.status;
}

status_t controller_obey_program_end(controller_t *self, const cycle_t *cycle,
                                     const command_t *command, answer_t *answer)
{
    const uint32_t checksum = command_as_list(command)->checksum;
    status_t status = judge_list(self, command);
    if (status == STATUS_OK) {
        status = program_list_end(&self->program, checksum);
    }
    if (status == STATUS_OK) {
        answer->as.checksum.checksum = checksum;
        controller_note(self, cycle, EVENT_PROGRAM_HELD, 0U, (int32_t)self->program.count);
    }
    return status;
}

solution_t controller_judge_program(const controller_t *self, const cycle_t *cycle, uint32_t crc,
                                    const move_mode_t *target)
{
    return program_mode_judge(&self->program, crc, target, cycle->robot, self->axes,
                              cycle->inputs->treatment_stopped != 0U);
}
