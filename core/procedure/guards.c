/* SPDX-License-Identifier: Apache-2.0 */
#include "procedure/guards.h"

#include "interface/command.h"

#include <stdbool.h>

#if ROBOT_AXIS_MAX > 16
#error "The axes have the lower half of the word."
#endif

static bool has(uint32_t facts, uint32_t fact)
{
    return (facts & fact) != 0U;
}

static bool is_start_up(uint32_t kind, uint32_t argument)
{
    return (kind == (uint32_t)COMMAND_WORKPHASE) && (argument == (uint32_t)WORKPHASE_START_UP);
}

/* Changes of the workphase that drive nothing do without the robot's table, and what is of
 * authority. */
static bool needs_table(uint32_t kind, uint32_t argument)
{
    const bool is_of_authority =
        (kind >= (uint32_t)COMMAND_TAKE) && (kind <= (uint32_t)COMMAND_REQUEST);
    return (kind == (uint32_t)COMMAND_WORKPHASE) ? is_start_up(kind, argument) : !is_of_authority;
}

/* What lets drives be driven: the loop must be able to stop them in time. */
static bool enables(uint32_t kind, uint32_t argument)
{
    return is_start_up(kind, argument) || (kind == (uint32_t)COMMAND_ENABLE_AXIS);
}

status_t guards_bar(uint32_t facts, uint32_t kind, uint32_t argument)
{
    status_t status = STATUS_OK;
    if (has(facts, GUARD_BLIND) && needs_table(kind, argument)) {
        status = STATUS_MEMORY_DAMAGED;
    } else if (has(facts, GUARD_UNFIT) && enables(kind, argument)) {
        status = STATUS_COMPUTER_UNFIT;
    } else {
        /* The mode and the workphase decide. */
    }
    return status;
}

workphase_inputs_t guards_inputs(uint32_t facts, mode_kind_t kind, uint32_t axes,
                                 workphase_t workphase)
{
    const mode_row_t *const row = &mode_rows[kind];
    const workphase_inputs_t inputs = {
        .is_hardware_ready = has(facts, GUARD_HARDWARE_READY),
        .is_confirmation_due = has(facts, GUARD_CONFIRMATION_DUE),
        .is_motion_allowed_here = has(row->workphases >> (uint32_t)workphase, 1U),
        .is_able = has(facts, GUARD_CLEAR) && !has(facts, axes & GUARD_DISABLED_AXES),
        .is_homed = row->may_be_unhomed || has(facts, GUARD_HOMED),
        .is_registered = has(facts, GUARD_REGISTERED),
        .has_target = has(facts, GUARD_TARGET),
    };
    return inputs;
}
