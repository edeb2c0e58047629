/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/operator/operator_command.h"

#include "safety/needle.h"

#include "procedure/command_kinds.h"

authority_party_t operator_commander(const rig_t *rig)
{
    const snapshot_t *const shown = &rig->outputs.snapshot;
    authority_party_t party = {.source = (uint32_t)COMMAND_SOURCE_HTTP, .peer = RIG_PAGE};
    if (authority_is_held(&rig->controller.authority)) {
        party = (authority_party_t){.source = (uint32_t)shown->holder, .peer = shown->holder_peer};
    }
    return party;
}

bool operator_command_of(const rig_t *rig, uint32_t step, command_t *command)
{
    static const workphase_t phases[] = {[NEXT_STEP_START_UP] = WORKPHASE_START_UP,
                                         [NEXT_STEP_MOVE] = WORKPHASE_MOVE_TO_TARGET,
                                         [NEXT_STEP_TARGETING] = WORKPHASE_TARGETING,
                                         [NEXT_STEP_CALIBRATION] = WORKPHASE_CALIBRATION,
                                         [NEXT_STEP_PLANNING] = WORKPHASE_PLANNING,
                                         [NEXT_STEP_STOP] = WORKPHASE_STOP,
                                         [NEXT_STEP_COMPARE] = WORKPHASE_START_UP,
                                         [NEXT_STEP_MANUAL] = WORKPHASE_MANUAL};
    const authority_party_t party = operator_commander(rig);
    *command = (command_t){.id = OPERATOR_COMMAND_ID, .source = party.source, .peer = party.peer};
    if (step == (uint32_t)NEXT_STEP_AUTHORITY) {
        command->kind = (uint32_t)COMMAND_TAKE;
        return true;
    }
    if (step == (uint32_t)NEXT_STEP_REGISTER) {
        command->kind = (uint32_t)COMMAND_REGISTRATION;
        rigid_set_identity(&command->as.registration.pose);
        return true;
    }
    if (step == (uint32_t)NEXT_STEP_RETRACT) {
        command->kind = (uint32_t)COMMAND_RETRACT;
        return true;
    }
    if (step == (uint32_t)NEXT_STEP_ZERO_FORCE) {
        const bool is_page = party.source == (uint32_t)COMMAND_SOURCE_HTTP;
        const bool is_out = needle_is_out(rig->box.robot, rig->controller.axes);
        const command_kind_t in_kind = is_page ? COMMAND_ZERO_FORCE : COMMAND_RETRACT;
        command->kind = (uint32_t)(is_out ? in_kind : COMMAND_RETRACT);
        return true;
    }
    if (step == (uint32_t)NEXT_STEP_DRAPING) {
        command->kind = (uint32_t)COMMAND_POSE;
        command->as.pose_name.pose = (uint32_t)POSE_DRAPING;
        return true;
    }
    command->kind = (uint32_t)COMMAND_WORKPHASE;
    command->as.workphase.workphase =
        (step < (sizeof phases / sizeof phases[0])) ? (uint32_t)phases[step] : 0U;
    return command_kinds_workphase(command) != WORKPHASE_UNDEFINED;
}
