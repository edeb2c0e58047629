/* SPDX-License-Identifier: Apache-2.0 */
#include "http/view/command_availability.h"

#include "charts/arming_chart.h"
#include "charts/estop_latch_chart.h"
#include "http/view/shown.h"
#include "safety/needle.h"

#include <stdbool.h>

static bool is_here(const snapshot_t *snapshot, command_kind_t kind)
{
    return ((command_traits[kind].workphases >> (uint32_t)snapshot->workphase) & 1U) != 0U;
}

static bool is_armed(const snapshot_t *snapshot)
{
    return (uint32_t)snapshot->order != (uint32_t)ARMING_STATE_NONE;
}

static bool is_pedal_released(const snapshot_t *snapshot)
{
    return guards_have(snapshot->guards, GUARD_PEDAL_RELEASED);
}

static bool is_needle_out(const robot_t *robot, const snapshot_t *snapshot)
{
    axis_t axes[ROBOT_AXIS_MAX];
    shown_axes(snapshot, axes);
    return needle_is_out(robot, axes);
}

/* Where nothing may be armed. */
static status_t rest_outlook(const snapshot_t *snapshot, bool is_resting)
{
    return (is_armed(snapshot) || !is_resting) ? STATUS_NOT_AT_REST : STATUS_OK;
}

/* Where the needle must be out as well. */
static status_t bare_outlook(const robot_t *robot, const snapshot_t *snapshot, bool is_resting)
{
    const status_t status = rest_outlook(snapshot, is_resting);
    const bool is_in = (status == STATUS_OK) && !is_needle_out(robot, snapshot);
    return is_in ? STATUS_NEEDLE_IN : status;
}

/* The reports of the card, and axes that count at rest, are judged when it comes. */
static status_t force_outlook(const robot_t *robot, const snapshot_t *snapshot)
{
    return (robot->force.is_there == 0U)
               ? STATUS_NO_FORCE_SENSOR
               : bare_outlook(robot, snapshot, is_pedal_released(snapshot));
}

static status_t program_outlook(const snapshot_t *snapshot)
{
    const status_t status = (snapshot->has_target == 0U) ? STATUS_NO_TARGET : STATUS_OK;
    return is_armed(snapshot) ? STATUS_MOTION_ARMED : status;
}

/* Whether depths fit is judged when they come. */
static status_t membranes_outlook(const robot_t *robot, const snapshot_t *snapshot)
{
    status_t status = (snapshot->is_entry_of_target != 0U) ? STATUS_OK : STATUS_NO_ENTRY_POINT;
    if (robot->force.is_there == 0U) {
        status = STATUS_NO_FORCE_SENSOR;
    } else if (is_armed(snapshot)) {
        status = STATUS_MOTION_ARMED;
    } else if (snapshot->has_target == 0U) {
        status = STATUS_NO_TARGET;
    } else {
        /* The entry point decides. */
    }
    return status;
}

/* Whether the curvature can be had is judged when it comes. */
static status_t steering_outlook(const robot_t *robot, const snapshot_t *snapshot)
{
    status_t status = (snapshot->has_target != 0U) ? STATUS_OK : STATUS_NO_TARGET;
    if (robot->steering.points == 0U) {
        status = STATUS_NO_STEERING;
    } else if (is_armed(snapshot)) {
        status = STATUS_MOTION_ARMED;
    } else {
        /* The target decides. */
    }
    return status;
}

/* In a workphase where it is obeyed. */
static status_t outlook_here(const robot_t *robot, const snapshot_t *snapshot, command_kind_t kind)
{
    const bool is_clear = (uint32_t)snapshot->estop == (uint32_t)ESTOP_LATCH_STATE_CLEAR;
    status_t status = STATUS_OK;
    switch ((uint32_t)kind) {
    case (uint32_t)COMMAND_ENABLE_AXIS:
        status = is_clear ? rest_outlook(snapshot, true) : STATUS_FAULT_PRESENT;
        break;
    case (uint32_t)COMMAND_CLEAR_AXIS:
    case (uint32_t)COMMAND_DISABLE_AXIS:
    case (uint32_t)COMMAND_LIST_BEGIN:
        status = rest_outlook(snapshot, true);
        break;
    case (uint32_t)COMMAND_ACCEPT_NO_BLACK_BOX:
        status = guards_have(snapshot->guards, GUARD_NO_BOX) ? STATUS_OK : STATUS_BLACK_BOX_THERE;
        break;
    case (uint32_t)COMMAND_RESTORE:
        status = rest_outlook(snapshot, is_pedal_released(snapshot));
        break;
    case (uint32_t)COMMAND_SET_HOME:
        status = bare_outlook(robot, snapshot, is_pedal_released(snapshot));
        break;
    case (uint32_t)COMMAND_PROBE:
        status = bare_outlook(robot, snapshot, true);
        break;
    case (uint32_t)COMMAND_ZERO_FORCE:
        status = force_outlook(robot, snapshot);
        break;
    case (uint32_t)COMMAND_PROGRAM_BEGIN:
        status = program_outlook(snapshot);
        break;
    case (uint32_t)COMMAND_MEMBRANES:
        status = membranes_outlook(robot, snapshot);
        break;
    case (uint32_t)COMMAND_STEER:
        status = steering_outlook(robot, snapshot);
        break;
    default: /* The workphase alone. */
        break;
    }
    return status;
}

status_t command_availability(const robot_t *robot, const snapshot_t *snapshot, command_kind_t kind)
{
    const bool is_plan = (kind == COMMAND_ENTRY) || (kind == COMMAND_TARGET);
    const status_t barred = guards_bar(snapshot->guards, (uint32_t)kind, 0U);
    status_t status = STATUS_WRONG_WORKPHASE;
    if (barred != STATUS_OK) {
        status = barred;
    } else if (is_plan && is_armed(snapshot)) {
        status = STATUS_MOTION_ARMED; /* In any workphase. */
    } else if (is_here(snapshot, kind)) {
        status = outlook_here(robot, snapshot, kind);
    } else {
        /* Elsewhere. */
    }
    return status;
}
