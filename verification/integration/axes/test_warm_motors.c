/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a motor that has shown how fast it is, and then grows warm, is no faulty one.
 */
#include "integration/support/rig.h"

#include "robot/robot_neuro.h"
#include "unit/support/scenes.h"
#include "unity.h"

#define WAY_TICKS ((int32_t)SCENES(7000U))

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
    const command_t command = {.kind = (uint32_t)COMMAND_JOG,
                               .as.jog = {.axis = NEURO_AXIS_ROTATION, .to_ticks = ticks}};
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ACCEPTED, rig_command(&rig, command).kind);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 60000U).kind);
    rig_release(&rig);
}

static void jog_to_and_fro(uint32_t times)
{
    for (uint32_t i = 0U; i < times; i++) {
        jog(WAY_TICKS);
        jog(-WAY_TICKS);
    }
}

/* As after minutes of drive; it does not cool down much in a test. */
static void warm_up(double temperature_c)
{
    rig.box.axes[NEURO_AXIS_ROTATION].card.motor_temperature_c = temperature_c;
    rig_cycles(&rig, 20U);
}

void test_SWR_DRIVE_016_a_motor_that_has_grown_warm_is_not_taken_for_a_faulty_one(void)
{
    jog_to_and_fro(2U);
    warm_up(54.9);
    jog_to_and_fro(2U);
    TEST_ASSERT_TRUE(axis_is_homed(&rig.controller.axes[NEURO_AXIS_ROTATION]));
}

void test_SWR_DRIVE_016_nor_one_that_has_cooled_down(void)
{
    warm_up(54.9);
    jog_to_and_fro(2U);
    warm_up(22.0);
    jog_to_and_fro(2U);
    TEST_ASSERT_TRUE(axis_is_homed(&rig.controller.axes[NEURO_AXIS_ROTATION]));
}

/* Half of its counts are missing, and no report of heat excuses that. */
void test_SWR_DRIVE_016_a_warm_motor_that_counts_half_is_found(void)
{
    warm_up(54.9);
    rig_box(&rig, "encoder rotation half");
    const command_t command = {.kind = (uint32_t)COMMAND_JOG,
                               .as.jog = {.axis = NEURO_AXIS_ROTATION, .to_ticks = 7000}};
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ACCEPTED, rig_command(&rig, command).kind);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 60000U).kind);
    TEST_ASSERT_FALSE(axis_is_homed(&rig.controller.axes[NEURO_AXIS_ROTATION]));
    rig_release(&rig);
}

/* Time by which a jog is done later than was reported at its beginning, ms. */
static uint32_t lateness_ms(uint32_t axis, int32_t ticks)
{
    const command_t command = {.kind = (uint32_t)COMMAND_JOG_BY,
                               .as.jog_by = {.axis = axis, .by_ticks = ticks}};
    uint32_t reported_ms = 0U;
    uint32_t cycles = 0U;
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, command).status);
    rig_press(&rig);
    while (rig.outputs.snapshot.left_ms == 0U) {
        rig_cycle(&rig);
    }
    reported_ms = rig.outputs.snapshot.left_ms;
    while (rig_count(&rig, EVENT_ORDER_DONE) == 0U) {
        rig_cycle(&rig);
        cycles++;
        TEST_ASSERT_LESS_THAN_UINT32(60000U, cycles);
    }
    rig_release(&rig);
    TEST_ASSERT_GREATER_THAN_UINT32(2000U, reported_ms);
    return (cycles > reported_ms) ? (cycles - reported_ms) : 0U;
}

/* As warm as it may be: the first has a fifth of its speed to spare by its table, the least of all,
 * the second a third. */
void test_SWR_MOTION_006_a_warm_motor_is_done_in_the_time_that_was_reported(void)
{
    static const uint32_t axes[] = {NEURO_AXIS_LATERAL, NEURO_AXIS_ROTATION};
    static const int32_t ways[] = {-1000, -3500};
    for (uint32_t i = 0U; i < 2U; i++) {
        const uint32_t axis = axes[i];
        TEST_ASSERT_LESS_OR_EQUAL_UINT32(LIMIT_DONE_TIME_US / 1000U, lateness_ms(axis, ways[i]));
        rig.box.axes[axis].card.motor_temperature_c = 54.9;
        rig_cycles(&rig, 20U);
        TEST_ASSERT_LESS_OR_EQUAL_UINT32(LIMIT_DONE_TIME_US / 1000U, lateness_ms(axis, ways[i]));
    }
}
