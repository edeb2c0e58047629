/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a motor that has shown how fast it is, and then grows warm, is no faulty one.
 */
#include "integration/support/rig.h"

#include "robot/robot_neuro.h"
#include "unity.h"

static rig_t rig;

void setUp(void)
{
    rig_start_homed(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static void jog(int32_t ticks)
{
    const command_t command = {
        .kind = (uint32_t)COMMAND_JOG, .argument = AXIS_ROTATION, .value = ticks};
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ACCEPTED, rig_command(&rig, command).kind);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 60000U).kind);
    rig_release(&rig);
}

static void jog_to_and_fro(uint32_t times)
{
    for (uint32_t i = 0U; i < times; i++) {
        jog(7000);
        jog(-7000);
    }
}

/* As after minutes of drive; it does not cool down much in a test. */
static void warm_up(double temperature_c)
{
    rig.box.axes[AXIS_ROTATION].card.motor_temperature_c = temperature_c;
    rig_cycles(&rig, 20U);
}

void test_SWR_DRIVE_016_a_motor_that_has_grown_warm_is_not_taken_for_a_faulty_one(void)
{
    jog_to_and_fro(2U);
    warm_up(54.9);
    jog_to_and_fro(2U);
    TEST_ASSERT_TRUE(axis_is_homed(&rig.controller.axes[AXIS_ROTATION]));
}

void test_SWR_DRIVE_016_nor_one_that_has_cooled_down(void)
{
    warm_up(54.9);
    jog_to_and_fro(2U);
    warm_up(22.0);
    jog_to_and_fro(2U);
    TEST_ASSERT_TRUE(axis_is_homed(&rig.controller.axes[AXIS_ROTATION]));
}

/* Half of its counts are missing, and no report of heat excuses that. */
void test_SWR_DRIVE_016_a_warm_motor_that_counts_half_is_found(void)
{
    warm_up(54.9);
    rig_box(&rig, "encoder rotation half");
    const command_t command = {
        .kind = (uint32_t)COMMAND_JOG, .argument = AXIS_ROTATION, .value = 7000};
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ACCEPTED, rig_command(&rig, command).kind);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 60000U).kind);
    TEST_ASSERT_FALSE(axis_is_homed(&rig.controller.axes[AXIS_ROTATION]));
    rig_release(&rig);
}
