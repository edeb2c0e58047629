/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * START_UP on the simulated box: homing finds every reference, or ends in a named fault.
 * In every test the rig counts cycles that drive without the pedal; there must be none.
 */
#include "rig.h"

#include "unity.h"

#include "controller.h"

static rig_t rig;

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

void test_SWR_PHASE_003_start_up_homes_every_axis_while_the_pedal_is_down(void)
{
    rig_start(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ACCEPTED, rig_workphase(&rig, WORKPHASE_START_UP).kind);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.answers[0].is_final);
    rig_cycles(&rig, 500U);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.is_homed);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 40000U).kind);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_homed);
    TEST_ASSERT_EQUAL_UINT32(ROBOT_AXIS_COUNT - 2U, rig_count(&rig, EVENT_AXIS_HOMED));
    TEST_ASSERT_EQUAL_UINT32(2U, rig_count(&rig, EVENT_AXIS_TAKEN));
    double true_ticks[ROBOT_AXIS_COUNT];
    box_true_positions(&rig.box, true_ticks);
    TEST_ASSERT_DOUBLE_WITHIN(2.0, 0.0, true_ticks[AXIS_HEAD]);
    TEST_ASSERT_DOUBLE_WITHIN(2.0, 0.0, true_ticks[AXIS_LATERAL]);
    TEST_ASSERT_DOUBLE_WITHIN(2.0, 516.0, true_ticks[AXIS_PITCH]);
    TEST_ASSERT_DOUBLE_WITHIN(2.0, 8.0, true_ticks[AXIS_YAW]);
    TEST_ASSERT_DOUBLE_WITHIN(30.0, 0.0, true_ticks[AXIS_INSERTION]);
}

void test_SWR_AXIS_002_the_needle_homes_before_the_other_axes_move(void)
{
    rig_start(&rig);
    (void)rig_workphase(&rig, WORKPHASE_START_UP);
    rig_press(&rig);
    while (rig.outputs.snapshot.axes[AXIS_INSERTION].reference !=
           (uint32_t)AXIS_REFERENCE_VERIFIED) {
        TEST_ASSERT_EQUAL_INT32(0, rig_position(&rig, AXIS_HEAD));
        rig_cycle(&rig);
        TEST_ASSERT_LESS_THAN_UINT32(40000U, rig.controller.cycle);
    }
}

void test_SWR_PHASE_003_start_up_again_when_homed_ends_at_once(void)
{
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_START_UP);
    TEST_ASSERT_EQUAL_UINT32(2U, rig.outputs.answer_count);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig.outputs.answers[1].kind);
}

void test_SWR_AXIS_003_homing_that_finds_no_switch_gives_up(void)
{
    rig_start(&rig);
    rig_box(&rig, "motor insertion stuck");
    (void)rig_workphase(&rig, WORKPHASE_START_UP);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 31000U).kind);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_LOST,
                             rig.outputs.snapshot.axes[AXIS_INSERTION].reference);
}

/* START_UP with the pedal held, until it ends. @return the farthest forward way of the needle */
static double needle_way_in_start_up(answer_kind_t expected)
{
    const double *const needle = &rig.box.axes[AXIS_INSERTION].motor.position_ticks;
    const double start = *needle;
    double most = 0.0;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_box(&rig, "pedal press");
    const uint32_t before = rig.answer_count;
    while (rig.answer_count == before) {
        rig_cycle(&rig);
        most = ((*needle - start) > most) ? (*needle - start) : most;
        TEST_ASSERT_LESS_THAN_UINT32(200000U, rig.controller.cycle);
    }
    TEST_ASSERT_EQUAL_UINT32(expected, rig.answers[before % RIG_ANSWERS].kind);
    rig_release(&rig);
    return most;
}

#define NEEDLE_WAY_TICKS 667.0 /* 0.2 mm */

/* The needle stands at 18 mm and its card was lost. */
static void lose_deep_needle(void)
{
    rig_start_homed(&rig);
    rig.box.axes[AXIS_INSERTION].motor.position_ticks = 60000.0;
    rig.box.axes[AXIS_INSERTION].encoder.state = 60000;
    rig_box(&rig, "card insertion silent");
    rig_cycles(&rig, 20U);
    rig_box(&rig, "card insertion normal");
    rig_cycles(&rig, 20U);
    rig_forget(&rig);
}

void test_SWR_AXIS_013_a_switch_that_stays_active_drives_no_needle_forwards(void)
{
    lose_deep_needle();
    rig_box(&rig, "switch insertion stuck");
    const double way = needle_way_in_start_up(ANSWER_ABORTED);
    TEST_ASSERT_TRUE(way <= NEEDLE_WAY_TICKS + 5.0);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_SWITCH_FAULT));
    rig_expect_nothing_known(&rig, AXIS_INSERTION);
    TEST_ASSERT_TRUE(needle_way_in_start_up(ANSWER_ABORTED) <= 5.0);
}

void test_SWR_AXIS_013_a_reversed_switch_drives_no_needle_forwards(void)
{
    lose_deep_needle();
    rig_box(&rig, "switch insertion reversed");
    TEST_ASSERT_TRUE(needle_way_in_start_up(ANSWER_ABORTED) <= NEEDLE_WAY_TICKS + 5.0);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_SWITCH_FAULT));
}

void test_SWR_AXIS_014_a_chattering_switch_homes_nowhere(void)
{
    for (uint32_t seed = 1U; seed <= 50U; seed++) {
        lose_deep_needle();
        rig.box.axes[AXIS_INSERTION].limit_switch.random.state = seed;
        rig_box(&rig, "switch insertion chatter");
        TEST_ASSERT_TRUE(needle_way_in_start_up(ANSWER_ABORTED) <= NEEDLE_WAY_TICKS + 5.0);
        TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_SWITCH_FAULT));
    }
}

void test_SWR_AXIS_003_a_switch_that_never_acts_ends_in_a_fault_at_the_stop(void)
{
    rig_start(&rig);
    rig_box(&rig, "switch insertion open");
    (void)needle_way_in_start_up(ANSWER_ABORTED);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_NO_COUNTS));
}

void test_SWR_AXIS_015_a_reversed_encoder_is_found_in_the_first_leg_of_homing(void)
{
    static const char *const reversed[] = {"encoder head reversed", "encoder lateral reversed",
                                           "encoder insertion reversed", "encoder pitch reversed",
                                           "encoder yaw reversed"};
    for (uint32_t i = 0U; i < (sizeof reversed / sizeof reversed[0]); i++) {
        rig_start(&rig);
        rig_box(&rig, reversed[i]);
        (void)rig_workphase(&rig, WORKPHASE_START_UP);
        rig_press(&rig);
        TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 40000U).kind);
        TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_WRONG_WAY));
    }
}

void test_SWR_AXIS_013_every_axis_homes_from_both_ends(void)
{
    double true_ticks[ROBOT_AXIS_COUNT];
    for (uint32_t end = 0U; end < 2U; end++) {
        rig_start(&rig);
        for (uint32_t i = 0U; i < ROBOT_AXIS_COUNT; i++) {
            sim_motor_t *const motor = &rig.box.axes[i].motor;
            if (robot_neuro.axes[i].limit_switch != (uint8_t)LIMIT_SWITCH_NONE) {
                motor->position_ticks = (end == 0U) ? motor->lowest_ticks : motor->highest_ticks;
                rig.box.axes[i].encoder.state = (int32_t)motor->position_ticks;
            }
        }
        rig_cycles(&rig, 20U);
        (void)rig_workphase(&rig, WORKPHASE_START_UP);
        rig_press(&rig);
        TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 200000U).kind);
        box_true_positions(&rig.box, true_ticks);
        for (uint32_t i = 0U; i < ROBOT_AXIS_COUNT; i++) {
            if (robot_neuro.axes[i].limit_switch != (uint8_t)LIMIT_SWITCH_NONE) {
                TEST_ASSERT_DOUBLE_WITHIN(20.0, (double)rig_position(&rig, i), true_ticks[i]);
            }
        }
        rig_release(&rig);
    }
}
