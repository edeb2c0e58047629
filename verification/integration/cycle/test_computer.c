/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: while the computer of a real robot cannot be punctual nothing is enabled, by
 * whatever command; what is enabled already goes on.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "interface/computer_check.h"
#include "robot/robot_neuro.h"

static rig_t rig;

void setUp(void)
{
    rig_start(&rig);
}

void tearDown(void)
{
}

static void expect_nothing_enabled(void)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_DISABLED, rig.outputs.snapshot.axes[i].power);
    }
}

void test_SWR_LOOP_006_start_up_is_refused_by_name_for_each_thing_that_the_computer_lacks(void)
{
    for (uint32_t check = 0U; check < COMPUTER_CHECK_COUNT; check++) {
        rig.unfit = 1UL << check;
        TEST_ASSERT_EQUAL_UINT32(STATUS_COMPUTER_UNFIT,
                                 rig_workphase(&rig, WORKPHASE_START_UP).status);
        TEST_ASSERT_EQUAL_UINT32(WORKPHASE_UNDEFINED, rig.outputs.snapshot.workphase);
        TEST_ASSERT_EQUAL_HEX32(rig.unfit, rig.outputs.snapshot.unfit);
        expect_nothing_enabled();
    }
    rig.unfit = 0U;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
}

void test_SWR_LOOP_006_no_axis_is_enabled_by_another_way(void)
{
    const command_t enable = {.kind = (uint32_t)COMMAND_ENABLE_AXIS,
                              .as.axis = {.axis = NEURO_AXIS_YAW}};
    const command_t disable = {.kind = (uint32_t)COMMAND_DISABLE_AXIS,
                               .as.axis = {.axis = NEURO_AXIS_YAW}};
    rig_start_homed(&rig);
    rig.unfit = 1UL << COMPUTER_CHECK_KERNEL;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, disable).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_COMPUTER_UNFIT, rig_command(&rig, enable).status);
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_DISABLED, rig.outputs.snapshot.axes[NEURO_AXIS_YAW].power);
    rig.unfit = 0U;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, enable).status);
}

void test_SWR_LOOP_006_the_next_step_is_the_computer_before_it_is_start_up(void)
{
    rig.unfit = 1UL << COMPUTER_CHECK_RIGHTS;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_COMPUTER, rig.outputs.snapshot.next_step);
    rig.unfit = 0U;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_START_UP, rig.outputs.snapshot.next_step);
}

void test_SWR_LOOP_006_a_motion_that_runs_goes_on(void)
{
    rig_start_moving(&rig);
    rig.unfit = 1UL << COMPUTER_CHECK_PAGE_FAULTS;
    rig_cycles(&rig, 100U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_STOP).status);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
}
