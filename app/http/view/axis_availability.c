/* SPDX-License-Identifier: Apache-2.0 */
#include "http/view/axis_availability.h"

#include "http/view/shown.h"

/* How much a refusal says of the mode, the most first. */
typedef enum {
    RANK_ARMED = 0,
    RANK_CHART = 1,
    RANK_JUDGED = 2,
    RANK_NEVER = 3, /* For this axis in any state. */
    RANK_COUNT = 4
} rank_t;

typedef struct {
    status_t status;
    rank_t rank;
} outlook_t;

/* The nearest place that way where a target may lie; the next one while the axis is not homed. */
static int32_t next_ticks(const axis_config_t *config, const axis_t *axis, bool is_upwards)
{
    const int32_t next = axis->sealed.encoder.position_ticks + (is_upwards ? 1 : -1);
    int32_t found = next;
    if (!axis_is_homed(axis)) {
        /* Its limits mean nothing yet. */
    } else if (is_upwards && (next < config->target_minimum_ticks)) {
        found = config->target_minimum_ticks;
    } else if (!is_upwards && (next > config->target_maximum_ticks)) {
        found = config->target_maximum_ticks;
    } else {
        /* It is near. */
    }
    return found;
}

command_t axis_availability_command(const robot_t *robot, const snapshot_t *snapshot,
                                    mode_kind_t kind, uint32_t axis, bool is_upwards)
{
    command_t command = {.kind = mode_rows[kind].command};
    axis_t axes[ROBOT_AXIS_MAX];
    shown_axes(snapshot, axes);
    if (kind == MODE_JOG) {
        command.as.jog.axis = axis;
        command.as.jog.to_ticks = next_ticks(&robot->axes[axis], &axes[axis], is_upwards);
    } else if (kind == MODE_VELOCITY) {
        command.as.velocity.axes = (uint32_t)1U << axis;
        command.as.velocity.time_ms = 1U;
        command.as.velocity.speeds_ticks_per_s[axis] = is_upwards ? 1 : -1;
    } else if (kind == MODE_SWEEP) {
        command.as.sweep = (command_sweep_t){.axis = axis, .is_free = 1U};
    } else {
        command.as.axis.axis = axis;
    }
    return command;
}

static bool is_for_never(status_t status)
{
    return (status == STATUS_NO_SWEEP) || (status == STATUS_HOMES_WITH_OTHERS) ||
           (status == STATUS_HOMES_OTHERWISE);
}

static outlook_t look(const robot_t *robot, const snapshot_t *snapshot, mode_kind_t kind,
                      uint32_t axis, bool is_upwards)
{
    const command_t command = axis_availability_command(robot, snapshot, kind, axis, is_upwards);
    axis_t axes[ROBOT_AXIS_MAX];
    shown_axes(snapshot, axes);
    const mode_asked_t asked = {.command = &command, .robot = robot, .axes = axes};
    const mode_request_t request = mode_ask(kind, &asked);
    const status_t barred =
        guards_bar(snapshot->guards, command.kind, (uint32_t)WORKPHASE_UNDEFINED);
    outlook_t view = {.status = mode_judge(kind, &request, robot, axes).status,
                      .rank = RANK_JUDGED};
    if (barred != STATUS_OK) {
        view = (outlook_t){.status = barred, .rank = RANK_CHART};
    } else if (view.status == STATUS_OK) {
        const workphase_inputs_t guards = shown_guards(robot, snapshot, kind, request.sealed.axes);
        procedure_t procedure = shown_procedure(snapshot);
        procedure_actions_t actions;
        view.status = procedure_request_motion(&procedure, &guards, &actions);
        view.rank = (view.status == STATUS_OK) ? RANK_ARMED : RANK_CHART;
    } else if (is_for_never(view.status)) {
        view.rank = RANK_NEVER;
    } else {
        /* The judge speaks of how it stands now. */
    }
    return view;
}

status_t axis_availability(const robot_t *robot, const snapshot_t *snapshot, mode_kind_t kind,
                           uint32_t axis, bool is_upwards)
{
    return look(robot, snapshot, kind, axis, is_upwards).status;
}

status_t axis_availability_of_any(const robot_t *robot, const snapshot_t *snapshot,
                                  mode_kind_t kind)
{
    outlook_t best = {.status = STATUS_UNKNOWN_COMMAND, .rank = RANK_COUNT};
    for (uint32_t i = 0U; i < (2U * robot->axis_count); i++) {
        const outlook_t view = look(robot, snapshot, kind, i / 2U, (i % 2U) != 0U);
        best = (view.rank < best.rank) ? view : best;
    }
    return best.status;
}
