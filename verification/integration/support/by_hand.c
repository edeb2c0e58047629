/* SPDX-License-Identifier: Apache-2.0 */
#include "integration/support/by_hand.h"

#include "unity.h"

#include "limits/requirement_limits.h"

#include <stdio.h>

void by_hand_push(rig_t *rig, int32_t force_mn)
{
    char order[32];
    (void)snprintf(order, sizeof order, "grip %d", (int)force_mn);
    rig_box(rig, order);
    rig_box(rig, "hand press");
}

void by_hand_zero(rig_t *rig)
{
    const command_t zero = {.kind = (uint32_t)COMMAND_ZERO_FORCE,
                            .source = (uint32_t)COMMAND_SOURCE_HTTP,
                            .peer = RIG_PAGE};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(rig, zero).status);
    rig_cycles(rig, LIMIT_FORCE_ZERO_CYCLES + 1U);
}

void by_hand_align(rig_t *rig, int32_t entry_z_nm, int32_t target_z_nm)
{
    rigid_t pose;
    rigid_set_identity(&pose);
    pose.translation = (point_t){5000000, -10000000, target_z_nm};
    command_t entry = {.kind = (uint32_t)COMMAND_ENTRY, .as.pose = {.pose = pose}};
    entry.as.pose.pose.translation.z_nm = entry_z_nm;
    rig_start_robot_targeted(rig, rig_short_prostate(), &pose);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(rig, entry).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(rig, &pose).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK,
                             rig_command(rig, (command_t){.kind = (uint32_t)COMMAND_ALIGN}).status);
    rig_press(rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(rig, 120000U).kind);
    rig_release(rig);
    rig_cycles(rig, 500U);
}

void by_hand_start(rig_t *rig, int32_t entry_z_nm, int32_t target_z_nm)
{
    static rig_t ready;
    if (ready.box.robot == NULL) {
        by_hand_align(&ready, entry_z_nm, target_z_nm);
        by_hand_zero(&ready);
    }
    *rig = ready;
    rig_forget(rig);
}

void by_hand_enter(rig_t *rig)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(rig, WORKPHASE_MOVE_TO_TARGET).status);
    rig_cycles(rig, BY_HAND_OFF_CYCLES);
}
