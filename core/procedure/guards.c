/* SPDX-License-Identifier: Apache-2.0 */
#include "procedure/guards.h"

#include "interface/command.h"

#if ROBOT_AXIS_MAX > 16
#error "The axes have the lower half of the word."
#endif

static bool is_start_up(uint32_t kind, uint32_t asked)
{
    return (kind == (uint32_t)COMMAND_WORKPHASE) && (asked == (uint32_t)WORKPHASE_START_UP);
}

/* Changes of the workphase that drive nothing do without the robot's table, and so do commands of
 * authority. */
static bool needs_table(uint32_t kind, uint32_t asked)
{
    const bool is_tableless =
        (kind < COMMAND_KIND_COUNT) && (((COMMAND_KINDS_TABLELESS >> kind) & 1U) != 0U);
    return (kind == (uint32_t)COMMAND_WORKPHASE) ? is_start_up(kind, asked) : !is_tableless;
}

/* Commands that let drives be driven: the loop must be able to stop them in time. */
static bool enables(uint32_t kind, uint32_t asked)
{
    return is_start_up(kind, asked) || (kind == (uint32_t)COMMAND_ENABLE_AXIS);
}

static bool homes(uint32_t kind, uint32_t asked)
{
    return is_start_up(kind, asked) || (kind == (uint32_t)COMMAND_HOME_AXIS);
}

status_t guards_bar(uint32_t facts, uint32_t kind, uint32_t asked)
{
    status_t status = STATUS_OK;
    if (guards_have(facts, GUARD_BLIND) && needs_table(kind, asked)) {
        status = STATUS_MEMORY_DAMAGED;
    } else if (guards_have(facts, GUARD_UNFIT) && enables(kind, asked)) {
        status = STATUS_COMPUTER_UNFIT;
    } else if (guards_have(facts, GUARD_NO_BOX) && is_start_up(kind, asked)) {
        status = STATUS_NO_BLACK_BOX;
    } else if (guards_have(facts, GUARD_SPENT) && homes(kind, asked)) {
        status = STATUS_MOVED_IN_VAIN;
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
        .is_hardware_ready = guards_have(facts, GUARD_HARDWARE_READY),
        .is_confirmation_due = guards_have(facts, GUARD_CONFIRMATION_DUE),
        .is_motion_allowed_here = guards_have(row->workphases >> (uint32_t)workphase, 1U),
        .is_able = guards_have(facts, GUARD_CLEAR) && guards_have(facts, GUARD_LINKED) &&
                   !guards_have(facts, axes & GUARD_DISABLED_AXES),
        .is_homed = row->may_be_unhomed || guards_have(facts, GUARD_HOMED),
        .is_registered = guards_have(facts, GUARD_REGISTERED),
        .has_target = guards_have(facts, GUARD_TARGET),
    };
    return inputs;
}
