/* SPDX-License-Identifier: Apache-2.0 */
#include "http/view/shown.h"

#include <string.h>

void shown_axes(const snapshot_t *snapshot, axis_t axes[ROBOT_AXIS_MAX])
{
    (void)memset(axes, 0, sizeof(axis_t) * ROBOT_AXIS_MAX);
    for (uint32_t i = 0U; i < ROBOT_AXIS_MAX; i++) {
        axes[i].chart.reference = snapshot->axes[i].reference;
        axes[i].sealed.encoder.position_ticks = snapshot->axes[i].position_ticks;
    }
}

plan_t shown_plan(const snapshot_t *snapshot)
{
    plan_t plan = {.has_probe = snapshot->has_probe,
                   .has_target = snapshot->has_target,
                   .is_entry_of_target = snapshot->is_entry_of_target};
    (void)memcpy(plan.target_ticks, snapshot->target_ticks, sizeof plan.target_ticks);
    return plan;
}

workphase_inputs_t shown_guards(const robot_t *robot, const snapshot_t *snapshot, mode_kind_t kind,
                                uint32_t commanded)
{
    return guards_inputs(snapshot->guards, kind, mode_axes(kind, commanded, robot),
                         (workphase_t)snapshot->workphase);
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
