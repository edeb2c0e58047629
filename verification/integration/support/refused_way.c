/* SPDX-License-Identifier: Apache-2.0 */
#include "integration/support/refused_way.h"

#include "limits/requirement_limits.h"
#include "unity.h"

#include <string.h>

#define REST_CYCLES 500U
#define LOOK_CYCLES 3U /* A way in each. */

static void restore(const refused_pair_t *pair, const robot_t *robot, rig_t *rig)
{
    command_t command = {.kind = (uint32_t)COMMAND_RESTORE,
                         .as.positions = {.axes = ((uint32_t)1U << robot->axis_count) - 1U}};
    (void)memcpy(command.as.positions.ticks, pair->from_ticks, sizeof command.as.positions.ticks);
    rig_cycles(rig, REST_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(rig, command).status);
    rig_box(rig, "button press");
    rig_cycles(rig, (LIMIT_CONFIRM_HOLD_US / LIMIT_CYCLE_US) + 10U);
    rig_box(rig, "button release");
    rig_cycles(rig, 10U);
}

void refused_way_start(const refused_pair_t *pair, const robot_t *robot, robot_t *standing,
                       rig_t *rig)
{
    rigid_t identity;
    rigid_t pose;
    joints_t joints;
    *standing = *robot;
    (void)memcpy(standing->start_ticks, pair->from_ticks, sizeof standing->start_ticks);
    rig_start_robot(rig, standing);
    restore(pair, robot, rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(rig, WORKPHASE_START_UP).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(rig, WORKPHASE_PLANNING).status);
    rigid_set_identity(&identity);
    rig_register(rig, &identity);
    joints_from_ticks(robot, pair->to_ticks, &joints);
    kinematics_forward(robot, &robot->probe, &joints, &pose);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, plan_set_target(&rig->controller.plan, robot,
                                                        robot->poses[POSE_DRAPING].ticks, &pose)
                                            .status);
    controller_seal(&rig->controller);
    rig_cycles(rig, LOOK_CYCLES);
}
