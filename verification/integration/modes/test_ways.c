/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: MOVE_TO_TARGET is refused if the way from where the axes stand would leave a
 * limit that they share, and the events name the refusal. The table of the robot is changed under
 * the controller, as the NeuroRobot has no limit that a way between two legal places can leave.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "base/seal.h"
#include "controller/controller.h"

#include <stddef.h>

static rig_t rig;

void setUp(void)
{
    rig_start_targeted(&rig);
}

void tearDown(void)
{
}

/* Looked at on the way, and with this lower end. */
static void set_limit(int32_t minimum_nm)
{
    robot_t *const robot = &rig.robot;
    robot->coupled_limits[0].is_curved = 1U;
    robot->coupled_limits[0].minimum = minimum_nm;
    robot->seal = seal_of(SEAL_START, (const uint8_t *)robot, offsetof(robot_t, seal));
}

static bool has_refusal(status_t status)
{
    bool has_one = false;
    for (uint32_t i = 0U; i < rig.event_count; i++) {
        const event_t *const event = &rig.events[i];
        has_one = has_one || ((event->id == (uint32_t)EVENT_COMMAND_REFUSED) &&
                              (event->value == (int32_t)status));
    }
    return has_one;
}

void test_SWR_PLAN_016_a_move_is_refused_by_the_limit_that_its_way_would_leave(void)
{
    const int32_t minimum_nm = rig.robot.coupled_limits[0].minimum;
    set_limit(rig.robot.coupled_limits[0].maximum - 1000000);
    const answer_t refused = rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_REFUSED, refused.kind);
    TEST_ASSERT_EQUAL_UINT32(STATUS_SEPARATION_LIMIT, refused.status);
    TEST_ASSERT_EQUAL_UINT32(1U, refused.is_final);
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_TARGETING, rig.outputs.snapshot.workphase);
    TEST_ASSERT_TRUE(has_refusal(STATUS_SEPARATION_LIMIT));
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_target);
    set_limit(minimum_nm);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ACCEPTED, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).kind);
}
