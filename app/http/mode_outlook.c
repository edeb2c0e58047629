/* SPDX-License-Identifier: Apache-2.0 */
#include "http/mode_outlook.h"

#include "charts/axis_chart.h"
#include "charts/card_link_chart.h"
#include "charts/estop_latch_chart.h"
#include "charts/loop_guard_chart.h"
#include "charts/pedal_gate_chart.h"
#include "interface/command.h"
#include "mode/mode.h"
#include "mode/program_step.h"
#include "procedure/procedure.h"

#include <stdbool.h>
#include <string.h>

static uint32_t bit(uint32_t index)
{
    return (uint32_t)1U << index;
}

static bool is_usable(const robot_t *robot, const snapshot_t *snapshot, uint32_t axis)
{
    const uint32_t link = (uint32_t)snapshot->cards[robot->axes[axis].slot].link;
    return (link == (uint32_t)CARD_LINK_STATE_LIVE) || (link == (uint32_t)CARD_LINK_STATE_LATE);
}

static bool needs_confirmation(const robot_t *robot, const snapshot_t *snapshot, uint32_t axis)
{
    const uint32_t reference = (uint32_t)snapshot->axes[axis].reference;
    return (robot->axes[axis].home_method != (uint8_t)HOME_BY_SWITCH) &&
           ((reference == (uint32_t)AXIS_REFERENCE_UNVERIFIED) ||
            (reference == (uint32_t)AXIS_REFERENCE_LOST));
}

static uint32_t able_axes(const robot_t *robot, const snapshot_t *snapshot)
{
    uint32_t able = 0U;
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const bool is_enabled = (uint32_t)snapshot->axes[i].power == (uint32_t)AXIS_POWER_ENABLED;
        able |= is_enabled ? bit(i) : 0U;
    }
    return able;
}

/* Those that the mode needs. */
static uint32_t needed_axes(const robot_t *robot, uint32_t able, const mode_row_t *row)
{
    uint32_t needed = bit(robot->axis_count) - 1U;
    if (row->axes == (uint32_t)MODE_AXES_NEEDLE) {
        needed = bit(robot->needle_axis);
    } else if ((row->axes == (uint32_t)MODE_AXES_COMMANDED) && (able != 0U)) {
        needed = able;
    } else {
        /* All of them. */
    }
    return needed;
}

static workphase_inputs_t inputs_of(const robot_t *robot, const snapshot_t *snapshot,
                                    const mode_row_t *row)
{
    const bool is_pedal_well = (uint32_t)snapshot->pedal != (uint32_t)PEDAL_GATE_STATE_FAULT;
    const bool is_estop_clear = (uint32_t)snapshot->estop == (uint32_t)ESTOP_LATCH_STATE_CLEAR;
    const uint32_t able = able_axes(robot, snapshot);
    const uint32_t needed = needed_axes(robot, able, row);
    workphase_inputs_t inputs = {
        .is_hardware_ready = (uint32_t)snapshot->estop != (uint32_t)ESTOP_LATCH_STATE_PULLED,
        .is_motion_allowed_here = ((row->workphases >> (uint32_t)snapshot->workphase) & 1U) != 0U,
        .is_able = is_estop_clear && is_pedal_well && ((needed & ~able) == 0U) &&
                   ((uint32_t)snapshot->loop != (uint32_t)LOOP_GUARD_STATE_STOPPED),
        .is_homed = row->may_be_unhomed || (snapshot->is_homed != 0U),
        .is_registered = snapshot->is_registered != 0U,
        .has_target = snapshot->has_target != 0U};
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const bool has_card = is_usable(robot, snapshot, i);
        inputs.is_hardware_ready = inputs.is_hardware_ready && has_card;
        inputs.is_confirmation_due =
            inputs.is_confirmation_due || needs_confirmation(robot, snapshot, i);
        inputs.is_able = inputs.is_able && has_card;
    }
    return inputs;
}

/* Takes it to `workphase` by the ways there are; UNDEFINED it is in. */
static void take_to(procedure_t *procedure, workphase_t workphase)
{
    static const workphase_t ways[] = {WORKPHASE_START_UP, WORKPHASE_PLANNING, WORKPHASE_TARGETING};
    const workphase_inputs_t all_well = {.is_hardware_ready = true,
                                         .is_able = true,
                                         .is_homed = true,
                                         .is_registered = true,
                                         .has_target = true};
    procedure_actions_t actions;
    if (workphase == WORKPHASE_UNDEFINED) {
        return;
    }
    for (uint32_t i = 0U; i < (sizeof ways / sizeof ways[0]); i++) {
        (void)procedure_request(procedure, &all_well, (uint32_t)ways[i], &actions);
    }
    (void)procedure_request(procedure, &all_well, (uint32_t)workphase, &actions);
}

/* A target, by way of an entry point. */
static status_t aim_outlook(const snapshot_t *snapshot)
{
    if (snapshot->has_target == 0U) {
        return STATUS_NO_TARGET;
    }
    return (snapshot->has_entry == 0U) ? STATUS_NO_ENTRY_POINT : STATUS_OK;
}

/* As far as the judges of modes look at them. */
static void show_axes(const snapshot_t *snapshot, axis_t axes[ROBOT_AXIS_MAX])
{
    (void)memset(axes, 0, sizeof(axis_t) * ROBOT_AXIS_MAX);
    for (uint32_t i = 0U; i < ROBOT_AXIS_MAX; i++) {
        axes[i].chart.reference = snapshot->axes[i].reference;
        axes[i].encoder.position_ticks = snapshot->axes[i].position_ticks;
    }
}

/* Where the axes stand at the target is shown in MOVE_TO_TARGET alone. `turning`: how this axis
 * stands does not matter. */
static status_t aligned_outlook(const robot_t *robot, const snapshot_t *snapshot, uint32_t turning)
{
    move_mode_t move;
    axis_t axes[ROBOT_AXIS_MAX];
    show_axes(snapshot, axes);
    for (uint32_t i = 0U; i < ROBOT_AXIS_MAX; i++) {
        const bool is_shown = (snapshot->workphase == (uint32_t)WORKPHASE_MOVE_TO_TARGET);
        move.target_ticks[i] = (is_shown && (i != turning)) ? snapshot->axes[i].target_ticks
                                                            : axes[i].encoder.position_ticks;
    }
    return insert_mode_judge(&move, robot, axes);
}

static status_t insert_outlook(const robot_t *robot, const snapshot_t *snapshot)
{
    const status_t status = aim_outlook(snapshot);
    return (status == STATUS_OK) ? aligned_outlook(robot, snapshot, ROBOT_AXIS_MAX) : status;
}

static status_t program_outlook(const robot_t *robot, const snapshot_t *snapshot)
{
    status_t status = aim_outlook(snapshot);
    if (status != STATUS_OK) {
        /* There is nothing to go along. */
    } else if (snapshot->program_steps == 0U) {
        status = STATUS_PROGRAM_OTHER;
    } else {
        status = aligned_outlook(robot, snapshot, program_step_turning_axis(robot));
        if ((status == STATUS_OK) && (snapshot->is_treatment_stopped != 0U)) {
            status = STATUS_PROGRAM_STOPPED;
        }
    }
    return status;
}

/* Of all poses: can any be gone to? */
static status_t pose_outlook(const robot_t *robot, const snapshot_t *snapshot)
{
    status_t status = STATUS_NO_POSE;
    axis_t axes[ROBOT_AXIS_MAX];
    show_axes(snapshot, axes);
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

/* Of all axes, once confirmed to be free: can any be swept? */
static status_t sweep_outlook(const robot_t *robot, const snapshot_t *snapshot)
{
    status_t status = STATUS_NO_SWEEP;
    axis_t axes[ROBOT_AXIS_MAX];
    show_axes(snapshot, axes);
    for (uint32_t i = 0U; (i < robot->axis_count) && (status != STATUS_OK); i++) {
        const status_t judged = sweep_mode_judge(i, true, robot, axes).status;
        status = (judged != STATUS_NO_SWEEP) ? judged : status;
    }
    return status;
}

/* Of what the mode itself asks, which comes first, that which is shown. */
static status_t own_outlook(const robot_t *robot, const snapshot_t *snapshot, mode_kind_t kind)
{
    status_t status = STATUS_OK;
    switch ((uint32_t)kind) {
    case (uint32_t)MODE_ALIGN:
        status = aim_outlook(snapshot);
        break;
    case (uint32_t)MODE_INSERT:
        status = insert_outlook(robot, snapshot);
        break;
    case (uint32_t)MODE_PROGRAM:
        status = program_outlook(robot, snapshot);
        break;
    case (uint32_t)MODE_TRAJECTORY:
        status = (snapshot->trajectory_rows == 0U) ? STATUS_TRAJECTORY_EMPTY : STATUS_OK;
        break;
    case (uint32_t)MODE_POSE:
        status = pose_outlook(robot, snapshot);
        break;
    case (uint32_t)MODE_SWEEP:
        status = sweep_outlook(robot, snapshot);
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

/* Where control is, before it is asked. */
static procedure_t present(const snapshot_t *snapshot)
{
    procedure_t procedure;
    procedure_init(&procedure);
    take_to(&procedure, (workphase_t)snapshot->workphase);
    return procedure;
}

status_t workphase_outlook(const robot_t *robot, const snapshot_t *snapshot, workphase_t workphase)
{
    const workphase_inputs_t inputs = inputs_of(robot, snapshot, &mode_rows[mode_of(workphase)]);
    procedure_t procedure = present(snapshot);
    procedure_actions_t actions;
    if ((workphase == WORKPHASE_START_UP) && (snapshot->unfit != 0U)) {
        return STATUS_COMPUTER_UNFIT;
    }
    return procedure_request(&procedure, &inputs, (uint32_t)workphase, &actions);
}

status_t mode_outlook(const robot_t *robot, const snapshot_t *snapshot, mode_kind_t kind)
{
    const mode_row_t *const row = &mode_rows[kind];
    const workphase_inputs_t inputs = inputs_of(robot, snapshot, row);
    const status_t of_mode = own_outlook(robot, snapshot, kind);
    procedure_t procedure = present(snapshot);
    procedure_actions_t actions;
    status_t status = STATUS_UNKNOWN_COMMAND;
    if (row->command == (uint32_t)COMMAND_WORKPHASE) {
        status = workphase_outlook(robot, snapshot, only_workphase(row));
    } else if (row->command != (uint32_t)COMMAND_NONE) {
        status = procedure_request_motion(&procedure, &inputs, &actions);
    } else {
        /* Nothing arms it. */
    }
    return (of_mode != STATUS_OK) ? of_mode : status;
}
