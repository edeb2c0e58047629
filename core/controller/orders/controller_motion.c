/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/orders/controller_motion.h"

#include "controller/orders/controller_aim.h"
#include "controller/orders/controller_axis.h"
#include "controller/controller_facts.h"
#include "controller/controller_force.h"
#include "controller/controller_order.h"

/* Request to the mode, by the command and the positions of the robot. */
static mode_request_t request_of(const controller_t *self, const cycle_t *cycle,
                                 const command_t *command, mode_kind_t kind)
{
    const mode_asked_t asked = {.command = command,
                                .robot = cycle->robot,
                                .axes = self->axes,
                                .list = &self->mode.sealed.list,
                                .rows = self->rows};
    return mode_ask(kind, &asked);
}

/* Armed. A homed axis homes anew: nothing that is known of it shall be relied on until then. */
static void begin(controller_t *self, const cycle_t *cycle, const command_t *command,
                  mode_kind_t kind, const mode_request_t *request)
{
    controller_arm(self, cycle, command, kind, request);
    if ((kind == MODE_HOME_AXIS) && axis_is_homed(&self->axes[request->sealed.way.axis])) {
        controller_forget_reference(self, cycle, request->sealed.way.axis);
    }
}

/* What may be done with the request, by what is known before the chart is asked. */
static solution_t judge(controller_t *self, const cycle_t *cycle, const command_t *command,
                        mode_kind_t kind, mode_request_t *request)
{
    solution_t judged = controller_aim(self, cycle, command, kind, request);
    if (judged.status == STATUS_OK) {
        judged = mode_judge(kind, request, cycle->robot, self->axes);
    }
    if ((judged.status == STATUS_OK) && mode_is_by_hand(kind) &&
        !controller_hand(self, cycle).is_trusted) {
        judged.status = STATUS_FORCE_DOUBTFUL;
    }
    return judged;
}

/* By the chart. */
static status_t ask_chart(controller_t *self, const cycle_t *cycle, const command_t *command,
                          mode_kind_t kind, mode_request_t *request)
{
    procedure_actions_t actions;
    request->sealed.axes = mode_axes(kind, request->sealed.axes, cycle->robot);
    const workphase_inputs_t guards = controller_guards(self, cycle, kind, request->sealed.axes);
    const status_t status = procedure_request_motion(&self->procedure, &guards, &actions);
    controller_report_order(self, cycle, actions.arming, STATUS_DISCARDED);
    if (status == STATUS_OK) {
        begin(self, cycle, command, kind, request);
    }
    return status;
}

status_t controller_obey_motion(controller_t *self, const cycle_t *cycle, const command_t *command,
                                answer_t *answer)
{
    const mode_kind_t kind = mode_of_command(command->kind);
    mode_request_t request = request_of(self, cycle, command, kind);
    const solution_t judged = judge(self, cycle, command, kind, &request);
    status_t status = judged.status;
    controller_blame(answer, &judged);
    if (status == STATUS_OK) {
        status = ask_chart(self, cycle, command, kind, &request);
        answer->is_final = (status == STATUS_OK) ? 0U : answer->is_final;
    }
    /* The operator is about to press the pedal for a hand, and not for what was armed before. */
    if ((status != STATUS_OK) && mode_is_by_hand(kind) &&
        (procedure_workphase(&self->procedure) == WORKPHASE_MOVE_TO_TARGET)) {
        controller_notify_order(self, cycle, ARMING_EVENT_DISCARD, STATUS_DISCARDED);
    }
    return status;
}
