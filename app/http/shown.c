/* SPDX-License-Identifier: Apache-2.0 */
#include "http/shown.h"

#include "charts/axis_chart.h"
#include "charts/card_link_chart.h"
#include "charts/estop_latch_chart.h"
#include "charts/loop_guard_chart.h"
#include "charts/pedal_gate_chart.h"

#include <stdbool.h>
#include <string.h>

void shown_axes(const snapshot_t *snapshot, axis_t axes[ROBOT_AXIS_MAX])
{
    (void)memset(axes, 0, sizeof(axis_t) * ROBOT_AXIS_MAX);
    for (uint32_t i = 0U; i < ROBOT_AXIS_MAX; i++) {
        axes[i].chart.reference = snapshot->axes[i].reference;
        axes[i].encoder.position_ticks = snapshot->axes[i].position_ticks;
    }
}

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

workphase_inputs_t shown_guards(const robot_t *robot, const snapshot_t *snapshot, mode_kind_t kind,
                                uint32_t commanded)
{
    const mode_row_t *const row = &mode_rows[kind];
    const bool is_pedal_well = (uint32_t)snapshot->pedal != (uint32_t)PEDAL_GATE_STATE_FAULT;
    const bool is_estop_clear = (uint32_t)snapshot->estop == (uint32_t)ESTOP_LATCH_STATE_CLEAR;
    const uint32_t able = able_axes(robot, snapshot);
    const uint32_t needed = mode_axes(kind, commanded, robot) & (bit(robot->axis_count) - 1U);
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

procedure_t shown_procedure(const snapshot_t *snapshot)
{
    procedure_t procedure;
    procedure_init(&procedure);
    take_to(&procedure, (workphase_t)snapshot->workphase);
    return procedure;
}
