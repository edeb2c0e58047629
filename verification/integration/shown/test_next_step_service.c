/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: trouble that comes back in each START_UP or move is for service, by the name of
 * its part.
 */
#include "unity.h"

#include "integration/support/rig.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"

#include "integration/support/next_step_world.inc"

void setUp(void)
{
}

void tearDown(void)
{
}

/* START_UP, and the pedal until it has failed. */
static void start_up_in_vain(void)
{
    rig_release(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, follow(NEXT_STEP_START_UP));
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 60000U).kind);
    rig_release(&rig);
    rig_cycles(&rig, 500U);
}

void test_SWR_NEXT_004_an_encoder_that_stays_reversed_is_for_service_and_named(void)
{
    rig_start(&rig);
    rig_box(&rig, "encoder insertion reversed");
    for (uint32_t i = 0U; i < LIMIT_SERVICE_START_UPS; i++) {
        expect(NEXT_STEP_START_UP);
        start_up_in_vain();
    }
    expect_named(NEXT_STEP_SERVICE, NEURO_AXIS_INSERTION, CARD_SLOT_COUNT, EVENT_AXIS_WRONG_WAY);
    rig_box(&rig, "encoder insertion normal");
    rig_home(&rig);
    expect(NEXT_STEP_PLANNING);
    fail_axis(NEURO_AXIS_HEAD);
    expect(NEXT_STEP_START_UP);
}

static void go_targeting(void)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_PLANNING).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_TARGETING).status);
    rig_cycles(&rig, 4U);
}

/* All axes are homed: it is done before the pedal. */
static void start_up_at_once(void)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_cycles(&rig, 10U);
}

/* The step MOVE is due, and so many moves have failed. */
static void start_after_vain_moves(uint32_t count)
{
    rig_start_targeted(&rig);
    rig.controller.sealed.vain_moves = count;
    rig.controller.sealed.vain_axis = NEURO_AXIS_YAW;
    rig.controller.sealed.vain_card = CARD_SLOT_COUNT;
    rig.controller.sealed.vain_event = (uint32_t)EVENT_ORDER_OVERDUE;
    controller_seal(&rig.controller);
    go_targeting();
}

/* The motor gets hot under way, and has cooled when the pedal is released. */
static void move_in_vain(void)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    rig_press(&rig);
    rig.box.axes[NEURO_AXIS_YAW].card.motor_temperature_c = 200.0;
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 1000U).kind);
    rig.box.axes[NEURO_AXIS_YAW].card.motor_temperature_c = 20.0;
    rig_release(&rig);
    rig_cycles(&rig, 100U);
}

/* START_UP between two of them does not count them anew. */
void test_SWR_NEXT_036_an_axis_that_ends_each_move_is_for_service_and_named(void)
{
    start_after_vain_moves(0U);
    for (uint32_t i = 0U; i < LIMIT_SERVICE_MOVES; i++) {
        expect(NEXT_STEP_MOVE);
        move_in_vain();
        if (i < (LIMIT_SERVICE_MOVES - 1U)) {
            expect(NEXT_STEP_START_UP);
            start_up_at_once();
            go_targeting();
        }
    }
    expect_named(NEXT_STEP_SERVICE, NEURO_AXIS_YAW, CARD_SLOT_COUNT, EVENT_AXIS_HOT);
    start_up_at_once();
    expect(NEXT_STEP_PLANNING);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.controller.sealed.vain_moves);
}

void test_SWR_NEXT_036_service_is_shown_in_place_of_the_move(void)
{
    start_after_vain_moves(LIMIT_SERVICE_MOVES);
    expect_named(NEXT_STEP_SERVICE, NEURO_AXIS_YAW, CARD_SLOT_COUNT, EVENT_ORDER_OVERDUE);
}

void test_SWR_AXIS_080_moves_are_counted_anew_once_it_is_said_that_it_is_mended(void)
{
    start_after_vain_moves(LIMIT_SERVICE_MOVES);
    expect(NEXT_STEP_SERVICE);
    rig_box(&rig, "button press");
    rig_cycles(&rig, (LIMIT_CONFIRM_HOLD_US / LIMIT_CYCLE_US) + 2U);
    rig_box(&rig, "button release");
    TEST_ASSERT_EQUAL_UINT32(0U, rig.controller.sealed.vain_moves);
    expect(NEXT_STEP_MOVE);
}

void test_SWR_NEXT_036_a_move_that_is_done_begins_the_count_anew(void)
{
    start_after_vain_moves(LIMIT_SERVICE_MOVES - 1U);
    expect(NEXT_STEP_MOVE);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, follow(NEXT_STEP_MOVE));
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 60000U).kind);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.controller.sealed.vain_moves);
}

void test_SWR_NEXT_004_a_card_that_is_lost_in_each_START_UP_is_for_service_and_named(void)
{
    rig_start(&rig);
    for (uint32_t i = 0U; i < LIMIT_SERVICE_START_UPS; i++) {
        expect(NEXT_STEP_START_UP);
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, follow(NEXT_STEP_START_UP));
        rig_box(&rig, "card head silent");
        rig_cycles(&rig, 100U);
        rig_box(&rig, "card head normal");
        rig_cycles(&rig, 100U);
    }
    expect_named(NEXT_STEP_SERVICE, ROBOT_AXIS_MAX, slot_of(NEURO_AXIS_HEAD), EVENT_CARD_LOST);
}
