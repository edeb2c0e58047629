/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: START_UP takes the ProstateRobot from where its simulated axes stand to the pose
 * home, in time, and on the whole way neither stage is opened or closed farther nor the needle
 * turned farther than it may be, by where the axes truly are. In every test the rig counts cycles
 * that drive without the pedal; there must be none.
 */
#include "integration/support/rig.h"
#include "robot/app/robots.h"

#include "unity.h"

#include "limits/requirement_limits.h"
#include "robot/joints.h"
#include "robot/kinematics.h"
#include "unit/support/scenes.h"

#define SETTLED_TICKS 4

#define MOST_CYCLES SCENES(200000U)

static const robot_t *robot;
static robot_t simulated;
static rig_t rig;

void setUp(void)
{
    robot = robots_find("prostate");
    TEST_ASSERT_NOT_NULL(robot);
    simulated = *robot;
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static void find_true_ticks(int32_t ticks[ROBOT_AXIS_MAX])
{
    double truth[ROBOT_AXIS_MAX];
    box_true_positions(&rig.box, truth);
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        ticks[i] = (int32_t)truth[i];
    }
}

static void expect_inside_limits(void)
{
    int32_t ticks[ROBOT_AXIS_MAX] = {0};
    joints_t joints;
    find_true_ticks(ticks);
    joints_from_ticks(robot, ticks, &joints);
    for (uint32_t i = 0U; i < robot->coupled_limit_count; i++) {
        const coupled_limit_t *const limit = &robot->coupled_limits[i];
        const int64_t value = kinematics_coupled(robot, i, &joints);
        TEST_ASSERT_TRUE_MESSAGE((value >= limit->minimum) && (value <= limit->maximum),
                                 limit->name);
    }
}

/* START_UP with the pedal held, to its end or for MOST_CYCLES; returns how long it took. */
static uint32_t home(void)
{
    rig_start_robot(&rig, &simulated);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_press(&rig);
    const uint32_t first = rig.controller.sealed.cycle;
    while ((rig.answers[rig.answer_count - 1U].is_final == 0U) &&
           (rig.controller.sealed.cycle < MOST_CYCLES)) {
        rig_cycle(&rig);
        expect_inside_limits();
    }
    return rig.controller.sealed.cycle - first;
}

static void expect_home(void)
{
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig.answers[rig.answer_count - 1U].kind);
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const uint32_t expected = (robot->axes[i].home_method == (uint8_t)HOME_IN_PLACE)
                                      ? AXIS_REFERENCE_TAKEN
                                      : AXIS_REFERENCE_VERIFIED;
        TEST_ASSERT_EQUAL_UINT32(expected, rig.controller.axes[i].chart.reference);
        TEST_ASSERT_INT32_WITHIN(SETTLED_TICKS, robot->poses[POSE_HOME].ticks[i],
                                 rig_position(&rig, i));
    }
}

void test_SWR_ROBOT_032_start_up_ends_at_home_in_time_and_nothing_is_torn(void)
{
    TEST_ASSERT_LESS_THAN_UINT32(LIMIT_DEMO_START_S * (1000000U / LIMIT_CYCLE_US), home());
    if (ARE_SCENES_WHOLE) {
        expect_home();
    }
    rig_release(&rig);
}

void test_SWR_ROBOT_033_where_start_up_has_ended_it_can_begin_again(void)
{
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        simulated.start_ticks[i] = robot->poses[POSE_HOME].ticks[i];
    }
    (void)home();
    if (ARE_SCENES_WHOLE) {
        expect_home();
    }
    rig_release(&rig);
}
