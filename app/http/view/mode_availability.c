/* SPDX-License-Identifier: Apache-2.0 */
#include "http/view/mode_availability.h"

#include "http/view/axis_availability.h"
#include "http/view/shown.h"
#include "interface/command.h"
#include "mode/cooperate/cooperate_mode.h"
#include "mode/insert/insert_mode.h"
#include "mode/lists/program_step.h"
#include "mode/pose/pose_mode.h"

#include <stdbool.h>
#include <stddef.h>

/* Whether the axes may go to the target in step. */
static status_t way_outlook(const robot_t *robot, const snapshot_t *snapshot)
{
    const plan_t plan = shown_plan(snapshot);
    int32_t ticks[ROBOT_AXIS_MAX];
    for (uint32_t i = 0U; i < ROBOT_AXIS_MAX; i++) {
        ticks[i] = snapshot->axes[i].position_ticks;
    }
    return plan_judge_way(&plan, robot, ticks).status;
}

/* A target by way of an entry point, and the way there. */
static status_t aim_outlook(const robot_t *robot, const snapshot_t *snapshot)
{
    const plan_t plan = shown_plan(snapshot);
    const status_t status = plan_judge_entry(&plan);
    return (status == STATUS_OK) ? way_outlook(robot, snapshot) : status;
}

/* The move to the target as the axes are shown; `turning`: how this axis stands does not matter. */
static move_mode_t shown_move(const snapshot_t *snapshot, uint32_t turning,
                              axis_t axes[ROBOT_AXIS_MAX])
{
    move_mode_t move;
    shown_axes(snapshot, axes);
    for (uint32_t i = 0U; i < ROBOT_AXIS_MAX; i++) {
        move.target_ticks[i] =
            (i == turning) ? axes[i].sealed.encoder.position_ticks : snapshot->target_ticks[i];
    }
    return move;
}

static status_t aligned_outlook(const robot_t *robot, const snapshot_t *snapshot, uint32_t turning)
{
    axis_t axes[ROBOT_AXIS_MAX];
    const move_mode_t move = shown_move(snapshot, turning, axes);
    return insert_mode_judge(&move, robot, axes).status;
}

static status_t insert_outlook(const robot_t *robot, const snapshot_t *snapshot)
{
    const status_t status = aim_outlook(robot, snapshot);
    return (status == STATUS_OK) ? aligned_outlook(robot, snapshot, ROBOT_AXIS_MAX) : status;
}

/* By a hand, whose force must be trusted. */
static status_t cooperate_outlook(const robot_t *robot, const snapshot_t *snapshot)
{
    status_t status = aim_outlook(robot, snapshot);
    if (status == STATUS_OK) {
        axis_t axes[ROBOT_AXIS_MAX];
        const move_mode_t move = shown_move(snapshot, ROBOT_AXIS_MAX, axes);
        status = cooperate_mode_judge(&move, robot, axes).status;
    }
    if ((status == STATUS_OK) && (snapshot->forces[FORCE_CHANNEL_HAND].doubts != 0U)) {
        status = STATUS_FORCE_DOUBTFUL;
    }
    return status;
}

/* There is one, for this target. */
static bool has_program(const snapshot_t *snapshot)
{
    return (snapshot->program_steps != 0U) &&
           (snapshot->program_target_crc == program_list_target_crc(snapshot->target_ticks));
}

static status_t program_outlook(const robot_t *robot, const snapshot_t *snapshot)
{
    status_t status = aim_outlook(robot, snapshot);
    if (status != STATUS_OK) {
        /* There is nothing to go along. */
    } else if (!has_program(snapshot)) {
        status = STATUS_PROGRAM_OTHER;
    } else {
        status = aligned_outlook(robot, snapshot, program_step_turning_axis(robot));
        if ((status == STATUS_OK) && (snapshot->is_treatment_stopped != 0U)) {
            status = STATUS_PROGRAM_STOPPED;
        }
    }
    return status;
}

/* The outlook of all poses: whether any can be gone to. */
static status_t pose_outlook(const robot_t *robot, const snapshot_t *snapshot)
{
    status_t status = STATUS_NO_POSE;
    axis_t axes[ROBOT_AXIS_MAX];
    shown_axes(snapshot, axes);
    for (uint32_t pose = 0U; (pose < POSE_NAME_COUNT) && (status != STATUS_OK); pose++) {
        move_mode_t move = {0};
        const status_t found = pose_mode_find(pose, robot, axes, &move);
        if (found == STATUS_OK) {
            status = pose_mode_judge(&move, robot, axes).status;
        } else if (status == STATUS_NO_POSE) {
            status = found;
        } else {
            /* One that there is says more. */
        }
    }
    return status;
}

static status_t trajectory_outlook(const robot_t *robot, const snapshot_t *snapshot,
                                   const int32_t *start_ticks)
{
    axis_t axes[ROBOT_AXIS_MAX];
    status_t status = STATUS_OK;
    shown_axes(snapshot, axes);
    if (snapshot->trajectory_rows == 0U) {
        status = STATUS_TRAJECTORY_EMPTY;
    } else if (start_ticks != NULL) {
        status = trajectory_mode_judge_start(robot, axes, start_ticks).status;
    } else {
        /* It is judged when it is commanded. */
    }
    return status;
}

/* The mode's own conditions, as far as they are known here; they come before the chart's. */
static status_t own_outlook(const robot_t *robot, const snapshot_t *snapshot,
                            const int32_t *start_ticks, mode_kind_t kind)
{
    status_t status = STATUS_OK;
    switch ((uint32_t)kind) {
    case (uint32_t)MODE_ALIGN:
        status = aim_outlook(robot, snapshot);
        break;
    case (uint32_t)MODE_INSERT:
        status = insert_outlook(robot, snapshot);
        break;
    case (uint32_t)MODE_COOPERATE:
        status = cooperate_outlook(robot, snapshot);
        break;
    case (uint32_t)MODE_PROGRAM:
        status = program_outlook(robot, snapshot);
        break;
    case (uint32_t)MODE_TRAJECTORY:
        status = trajectory_outlook(robot, snapshot, start_ticks);
        break;
    case (uint32_t)MODE_POSE:
        status = pose_outlook(robot, snapshot);
        break;
    default: /* The workphase chart decides. */
        break;
    }
    return status;
}

static workphase_t only_workphase(const mode_row_t *row)
{
    uint32_t workphase = 0U;
    while (((row->workphases >> workphase) & 1U) == 0U) {
        workphase++;
    }
    return (workphase_t)workphase;
}

status_t workphase_availability(const robot_t *robot, const snapshot_t *snapshot,
                                workphase_t workphase)
{
    const uint32_t kind = (uint32_t)COMMAND_WORKPHASE;
    const workphase_inputs_t inputs = shown_guards(robot, snapshot, mode_of(workphase), 0U);
    procedure_t procedure = shown_procedure(snapshot);
    procedure_actions_t actions;
    status_t status = guards_bar(snapshot->guards, kind, (uint32_t)workphase);
    if ((status == STATUS_OK) && (workphase == WORKPHASE_MOVE_TO_TARGET)) {
        status = way_outlook(robot, snapshot);
    }
    return (status == STATUS_OK)
               ? procedure_request(&procedure, &inputs, (uint32_t)workphase, &actions)
               : status;
}

/* After what the mode itself asks. */
static status_t chart_outlook(const robot_t *robot, const snapshot_t *snapshot, mode_kind_t kind)
{
    const workphase_inputs_t inputs = shown_guards(robot, snapshot, kind, 0U);
    procedure_t procedure = shown_procedure(snapshot);
    procedure_actions_t actions;
    return procedure_request_motion(&procedure, &inputs, &actions);
}

status_t mode_availability(const robot_t *robot, const snapshot_t *snapshot,
                           const int32_t start_ticks[ROBOT_AXIS_MAX], mode_kind_t kind)
{
    const mode_row_t *const row = &mode_rows[kind];
    status_t status = STATUS_UNKNOWN_COMMAND;
    if (row->command == (uint32_t)COMMAND_WORKPHASE) {
        status = workphase_availability(robot, snapshot, only_workphase(row));
    } else if (row->axes == (uint32_t)MODE_AXES_COMMANDED) {
        status = axis_availability_of_any(robot, snapshot, kind);
    } else if (row->command != (uint32_t)COMMAND_NONE) {
        status = guards_bar(snapshot->guards, row->command, 0U);
        status = (status == STATUS_OK) ? own_outlook(robot, snapshot, start_ticks, kind) : status;
        status = (status == STATUS_OK) ? chart_outlook(robot, snapshot, kind) : status;
    } else {
        /* Nothing arms it. */
    }
    return status;
}
