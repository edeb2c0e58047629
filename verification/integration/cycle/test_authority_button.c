/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: authority is taken from its holder with the button of the box alone, by the one
 * that asked for it first. On the simulated box.
 */
#include "unit/support/commands.h"
#include "integration/support/rig.h"

#include "unity.h"

#include "limits/requirement_limits.h"

#include "integration/support/authority_world.inc"

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static void press_button(void)
{
    rig_box(&rig, "button press");
    rig_cycles(&rig, CYCLES(LIMIT_CONFIRM_HOLD_US) + 20U);
    rig_box(&rig, "button release");
    rig_cycles(&rig, 20U);
}

void test_SWR_AUTH_008_it_is_taken_from_a_holder_with_the_button_and_the_pedal_released(void)
{
    start_moving();
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(OTHER_PAGE, COMMAND_REQUEST, AUTHORITY_REQUEST_TAKE));
    TEST_ASSERT_EQUAL_UINT32(OTHER_PAGE, rig.outputs.snapshot.requester_peer);
    press_button();
    expect_holder(COMMAND_SOURCE_HTTP, RIG_PAGE);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
    rig_release(&rig);
    rig_forget(&rig);
    press_button();
    expect_holder(COMMAND_SOURCE_HTTP, OTHER_PAGE);
    expect_lost(AUTHORITY_LOSS_TAKEN);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AUTHORITY_TAKEN));
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.requester_peer);
}

void test_SWR_AUTH_008_the_button_gives_what_is_free_as_well(void)
{
    start_free();
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(OTHER_PAGE, COMMAND_REQUEST, AUTHORITY_REQUEST_TAKE));
    press_button();
    expect_holder(COMMAND_SOURCE_HTTP, OTHER_PAGE);
}

void test_SWR_AUTH_008_who_has_it_by_now_is_not_waited_for(void)
{
    start_free();
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(OTHER_PAGE, COMMAND_REQUEST, AUTHORITY_REQUEST_TAKE));
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(OTHER_PAGE, COMMAND_TAKE, 0U));
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.requester_peer);
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(OTHER_PAGE, COMMAND_REQUEST, AUTHORITY_REQUEST_TAKE));
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.requester_peer);
    rig_forget(&rig);
    press_button();
    expect_holder(COMMAND_SOURCE_HTTP, OTHER_PAGE);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_AUTHORITY_LOST));
}

void test_SWR_AUTH_008_what_another_one_asks_for_stays_when_a_third_one_takes(void)
{
    start_free();
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(OTHER_PAGE, COMMAND_REQUEST, AUTHORITY_REQUEST_TAKE));
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(RIG_PAGE, COMMAND_TAKE, 0U));
    TEST_ASSERT_EQUAL_UINT32(OTHER_PAGE, rig.outputs.snapshot.requester_peer);
}

void test_SWR_AUTH_008_who_withdraws_after_the_press_has_nothing(void)
{
    start_moving();
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(OTHER_PAGE, COMMAND_REQUEST, AUTHORITY_REQUEST_TAKE));
    rig_release(&rig);
    rig_forget(&rig);
    rig_box(&rig, "button press");
    rig_cycles(&rig, CYCLES(LIMIT_CONFIRM_HOLD_US) - 50U);
    rig_box(&rig, "motor rotation runs");
    while (rig.outputs.snapshot.authority != (uint32_t)AUTHORITY_STATE_ENDING) {
        rig_cycle(&rig);
    }
    TEST_ASSERT_EQUAL_UINT32(AUTHORITY_REQUEST_GRANTED, rig.outputs.snapshot.request);
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(OTHER_PAGE, COMMAND_RELEASE, 0U));
    TEST_ASSERT_EQUAL_UINT32(AUTHORITY_STATE_ENDING, rig.outputs.snapshot.authority);
    rig_cycles(&rig, CYCLES(LIMIT_AUTHORITY_END_US));
    expect_nobody();
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_AUTHORITY_TAKEN));
}

void test_SWR_AUTH_009_a_press_that_began_before_means_nothing(void)
{
    start_free();
    rig_box(&rig, "button press");
    rig_cycles(&rig, CYCLES(LIMIT_CONFIRM_HOLD_US) / 2U);
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(OTHER_PAGE, COMMAND_REQUEST, AUTHORITY_REQUEST_TAKE));
    rig_cycles(&rig, 2U * CYCLES(LIMIT_CONFIRM_HOLD_US));
    expect_nobody();
    rig_box(&rig, "button release");
    rig_cycles(&rig, CYCLES(LIMIT_AUTHORITY_ASK_US) - (4U * CYCLES(LIMIT_CONFIRM_HOLD_US)));
    rig_box(&rig, "button press");
    rig_cycles(&rig, 2U * CYCLES(LIMIT_CONFIRM_HOLD_US));
    expect_holder(COMMAND_SOURCE_HTTP, OTHER_PAGE);
}

void test_SWR_AUTH_009_a_request_lapses_and_a_press_does_not_change_its_meaning(void)
{
    start_free();
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(OTHER_PAGE, COMMAND_REQUEST, AUTHORITY_REQUEST_TAKE));
    TEST_ASSERT_EQUAL_UINT32(LIMIT_AUTHORITY_ASK_US, rig.outputs.snapshot.request_left_us);
    rig_cycles(&rig, CYCLES(LIMIT_AUTHORITY_ASK_US) - (CYCLES(LIMIT_CONFIRM_HOLD_US) / 2U));
    press_button();
    expect_nobody();
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.requester_peer);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_AXIS_CONFIRMED));
}

void test_SWR_AUTH_009_a_confirmation_is_asked_for_by_who_has_authority(void)
{
    rig_start(&rig);
    rig_cycles(&rig, 100U);
    TEST_ASSERT_EQUAL(STATUS_NO_AUTHORITY,
                      by_page(OTHER_PAGE, COMMAND_REQUEST, AUTHORITY_REQUEST_CONFIRM));
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(RIG_PAGE, COMMAND_REQUEST, AUTHORITY_REQUEST_CONFIRM));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AUTHORITY_ASKED));
    press_button();
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.requester_peer);
    expect_holder(COMMAND_SOURCE_HTTP, RIG_PAGE);
}

void test_SWR_AUTH_012_another_ones_request_is_not_replaced(void)
{
    start_free();
    TEST_ASSERT_EQUAL(STATUS_NO_AUTHORITY, by_page(0U, COMMAND_REQUEST, AUTHORITY_REQUEST_TAKE));
    TEST_ASSERT_EQUAL(STATUS_UNKNOWN_COMMAND,
                      by_page(RIG_PAGE, COMMAND_REQUEST, AUTHORITY_REQUEST_GRANTED));
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(RIG_PAGE, COMMAND_REQUEST, AUTHORITY_REQUEST_TAKE));
    TEST_ASSERT_EQUAL(STATUS_BUSY, by_page(OTHER_PAGE, COMMAND_REQUEST, AUTHORITY_REQUEST_TAKE));
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(RIG_PAGE, COMMAND_REQUEST, AUTHORITY_REQUEST_TAKE));
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(RIG_PAGE, COMMAND_RELEASE, 0U));
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(OTHER_PAGE, COMMAND_REQUEST, AUTHORITY_REQUEST_TAKE));
}

void test_SWR_AUTH_012_who_asks_again_keeps_nobody_else_waiting_and_voids_no_press(void)
{
    start_free();
    for (uint32_t i = 0U; i < 10U; i++) {
        TEST_ASSERT_EQUAL(STATUS_OK, by_page(OTHER_PAGE, COMMAND_REQUEST, AUTHORITY_REQUEST_TAKE));
        rig_cycles(&rig, CYCLES(LIMIT_AUTHORITY_ASK_US) / 10U);
    }
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.requester_peer);
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(RIG_PAGE, COMMAND_REQUEST, AUTHORITY_REQUEST_TAKE));
    rig_box(&rig, "button press");
    rig_cycles(&rig, CYCLES(LIMIT_CONFIRM_HOLD_US) / 2U);
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(RIG_PAGE, COMMAND_REQUEST, AUTHORITY_REQUEST_TAKE));
    rig_cycles(&rig, CYCLES(LIMIT_CONFIRM_HOLD_US) / 2U + 20U);
    expect_holder(COMMAND_SOURCE_HTTP, RIG_PAGE);
}

void test_SWR_AUTH_013_without_a_button_nothing_is_asked_of_it(void)
{
    start_moving();
    rig.has_no_button = true;
    TEST_ASSERT_EQUAL(STATUS_NO_BUTTON,
                      by_page(OTHER_PAGE, COMMAND_REQUEST, AUTHORITY_REQUEST_TAKE));
    TEST_ASSERT_EQUAL(STATUS_NO_BUTTON,
                      by_page(RIG_PAGE, COMMAND_REQUEST, AUTHORITY_REQUEST_CONFIRM));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_AUTHORITY_ASKED));
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.requester_peer);
    expect_holder(COMMAND_SOURCE_HTTP, RIG_PAGE);
}
