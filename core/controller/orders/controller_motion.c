/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/orders/controller_motion.h"

#include "base/fixed.h"
#include "controller/orders/controller_aim.h"
#include "controller/orders/controller_axis.h"
#include "controller/controller_facts.h"
#include "controller/controller_order.h"

#include <string.h>

/* An axis and where it shall go, which is 0 for a mode that does not ask. */
static mode_way_t way_of(const controller_t *self, const command_t *command, mode_kind_t kind)
{
    mode_way_t way = {.axis = 0U, .end_ticks = 0};
    if (kind == MODE_SWEEP) {
        way.axis = command_as_sweep(command)->axis;
    } else if (kind == MODE_HOME_AXIS) {
        way.axis = command_as_axis(command)->axis;
    } else if (command->kind == (uint32_t)COMMAND_JOG) {
        way.axis = command_as_jog(command)->axis;
        way.end_ticks = command_as_jog(command)->to_ticks;
    } else {
        const command_jog_by_t *const sent = command_as_jog_by(command);
        way.axis = sent->axis;
        if (sent->axis < self->axis_count) {
            const int32_t from_ticks = self->axes[sent->axis].encoder.position_ticks;
            way.end_ticks = fixed_saturate((int64_t)from_ticks + (int64_t)sent->by_ticks);
        }
    }
    return way;
}

static void ask_velocity(const command_velocity_t *sent, mode_request_t *request)
{
    request->axes = sent->axes;
    request->velocity.axes = sent->axes;
    request->velocity.time_ms = sent->time_ms;
    request->velocity.way_ticks = sent->way_ticks;
    (void)memcpy(request->velocity.speeds_ticks_per_s, sent->speeds_ticks_per_s,
                 sizeof sent->speeds_ticks_per_s);
}

static void ask_way(const controller_t *self, const command_t *command, mode_kind_t kind,
                    mode_request_t *request)
{
    request->way = way_of(self, command, kind);
    request->axes = (request->way.axis < ROBOT_AXIS_MAX) ? LEG_AXIS(request->way.axis) : 0U;
    request->sweep.is_free = (kind == MODE_SWEEP) ? command_as_sweep(command)->is_free : 0U;
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
        ask_way(self, command, kind, &request);
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
        ask_velocity(command_as_velocity(command), &request);
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
