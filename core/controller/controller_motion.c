/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/controller_motion.h"

#include "base/fixed.h"
#include "controller/controller_aim.h"
#include "controller/controller_axis.h"
#include "controller/controller_facts.h"
#include "controller/controller_order.h"

#include <string.h>

/* Where a jog shall end: the value, or so far from where the axis stands. */
static int32_t jog_end_ticks(const controller_t *self, const command_t *command)
{
    int32_t end_ticks = command->value;
    if ((command->kind == (uint32_t)COMMAND_JOG_BY) && (command->argument < self->axis_count)) {
        const axis_t *const axis = &self->axes[command->argument];
        end_ticks = fixed_saturate((int64_t)axis->encoder.position_ticks + (int64_t)command->value);
    }
    return end_ticks;
}

/* What the command, and where the robot stands, say to its mode. */
static mode_request_t request_of(const controller_t *self, const cycle_t *cycle,
                                 const command_t *command, mode_kind_t kind)
{
    mode_request_t request = {.axes = 0U};
    switch (kind) {
    case MODE_JOG:
    case MODE_HOME_AXIS:
    case MODE_SWEEP:
        request.way.axis = command->argument;
        request.way.end_ticks = jog_end_ticks(self, command);
        request.axes =
            (command->argument < ROBOT_AXIS_MAX) ? ((uint32_t)1U << command->argument) : 0U;
        break;
    case MODE_TRAJECTORY:
        request.start_ms = self->rows[0].time_ms;
        request.end_ms = trajectory_list_end_ms(&self->mode.list, self->rows);
        break;
    case MODE_RETRACT:
        request.way.axis = cycle->robot->needle_axis;
        request.way.end_ticks = retract_mode_end_ticks(cycle->robot, self->axes);
        break;
    case MODE_VELOCITY:
        request.axes = command->argument;
        request.velocity.axes = command->argument;
        request.velocity.bound = command->value;
        (void)memcpy(request.velocity.speeds_ticks_per_s, command->ticks, sizeof command->ticks);
        break;
    case MODE_NONE:
    case MODE_HOMING:
    case MODE_MOVE:
    case MODE_ALIGN:
    case MODE_INSERT:
    case MODE_POSE:
    case MODE_PROGRAM:
    default:
        /* Its command alone, or controller_aim(). */
        break;
    }
    return request;
}

/* Armed. What is homed homes anew: nothing that is known of it shall be relied on until then. */
static void begin(controller_t *self, const cycle_t *cycle, const command_t *command,
                  mode_kind_t kind, const mode_request_t *request)
{
    controller_arm(self, cycle, command, kind, request);
    if ((kind == MODE_HOME_AXIS) && axis_is_homed(&self->axes[request->way.axis])) {
        controller_forget_reference(self, cycle, request->way.axis);
    }
}

status_t controller_obey_motion(controller_t *self, const cycle_t *cycle, const command_t *command,
                                answer_t *answer)
{
    const mode_kind_t kind = mode_of_command(command->kind);
    mode_request_t request = request_of(self, cycle, command, kind);
    solution_t judged = controller_aim(self, cycle, command, kind, &request);
    procedure_actions_t actions;
    if (judged.status == STATUS_OK) {
        judged = mode_judge(kind, &request, cycle->robot, self->axes);
    }
    answer->axis = (uint32_t)judged.axis;
    answer->is_maximum = (uint32_t)judged.is_maximum;
    if (judged.status != STATUS_OK) {
        return judged.status;
    }
    request.axes = mode_axes(kind, request.axes, cycle->robot);
    const workphase_inputs_t guards = controller_guards(self, cycle, kind, request.axes);
    const status_t status = procedure_request_motion(&self->procedure, &guards, &actions);
    controller_report_order(self, cycle, actions.arming, STATUS_DISCARDED);
    if (status == STATUS_OK) {
        begin(self, cycle, command, kind, &request);
        answer->is_final = 0U;
    }
    return status;
}
