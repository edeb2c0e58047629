/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: the end of the control loop, at any cause, sends "off" to every card, with a
 * sequence that the cards have not received. Each case runs main in a child.
 */
#include "unity.h"
#include "control/drives_off.h"
#include "mock_bsp.h"
#include "mock_computer.h"
#include "mock_controller.h"
#include "mock_list_file.h"
#include "mock_realtime.h"
#include "unit/support/control_world.inc"

void setUp(void)
{
    begin_control();
}

void tearDown(void)
{
    end_control();
}

void test_SWR_CTRL_010_a_contract_broken_inside_a_cycle_sends_off_to_every_card(void)
{
    const int status = control_ends(BY_CONTRACT, 0);
    TEST_ASSERT_TRUE(WIFEXITED(status));
    TEST_ASSERT_EQUAL_INT(EXIT_CONTRACT, WEXITSTATUS(status));
    expect_off(2U); /* The second one confirms. */
    TEST_ASSERT_EQUAL_STRING("control: contract controller/100 is broken, report this; all 7 cards "
                             "confirm that their drive is off.\n",
                             said);
}

void test_SWR_CTRL_010_every_signal_that_ends_the_loop_sends_off_to_every_card(void)
{
    const int signals[] = {SIGUSR1, SIGUSR2, SIGHUP,    SIGINT,   SIGTERM,
                           SIGPIPE, SIGALRM, SIGXFSZ,   SIGPWR,   SIGTSTP,
                           SIGTTIN, SIGTTOU, SIGSTKFLT, SIGRTMIN, SIGRTMAX};
    for (size_t i = 0U; i < (sizeof signals / sizeof signals[0]); i++) {
        (void)memset(record, 0, sizeof *record);
        const int status = control_ends(BY_SIGNAL, signals[i]);
        TEST_ASSERT_TRUE(WIFEXITED(status));
        TEST_ASSERT_EQUAL_INT(0, WEXITSTATUS(status));
        expect_off(2U);
        TEST_ASSERT_NOT_NULL(strstr(said, "all 7 cards confirm"));
    }
}

void test_SWR_CTRL_010_a_crash_sends_off_to_every_card_and_stays_a_crash(void)
{
    static const int signals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
    for (size_t i = 0U; i < (sizeof signals / sizeof signals[0]); i++) {
        (void)memset(record, 0, sizeof *record);
        const int status = control_ends(BY_SIGNAL, signals[i]);
        TEST_ASSERT_TRUE(WIFSIGNALED(status));
        TEST_ASSERT_EQUAL_INT(signals[i], WTERMSIG(status));
        expect_off(2U);
        TEST_ASSERT_NOT_NULL(strstr(said, "crashed by signal"));
    }
}

void test_SWR_CTRL_011_the_line_is_set_before_any_card_is_informed_whatever_ends_control(void)
{
    (void)control_ends(BY_CONTRACT, 0);
    TEST_ASSERT_EQUAL_UINT32(1U, record->lines);
    TEST_ASSERT_EQUAL_UINT32(record->count - 2U, record->before_line);
    static const int signals[] = {SIGTERM, SIGUSR1, SIGSEGV, SIGABRT};
    for (size_t i = 0U; i < (sizeof signals / sizeof signals[0]); i++) {
        (void)memset(record, 0, sizeof *record);
        (void)control_ends(BY_SIGNAL, signals[i]);
        TEST_ASSERT_EQUAL_UINT32(1U, record->lines);
        TEST_ASSERT_EQUAL_UINT32(record->count - 2U, record->before_line);
    }
}

void test_SWR_PACK_014_it_ends_in_the_cycle_in_which_it_is_at_rest_and_goes_on_otherwise(void)
{
    for (uint32_t i = 0U; i < (uint32_t)BUSY_KINDS; i++) {
        busy = (busy_t)i;
        (void)memset(record, 0, sizeof *record);
        const int status = control_ends(BY_REQUEST, 0);
        TEST_ASSERT_TRUE(WIFEXITED(status));
        TEST_ASSERT_EQUAL_INT(REST_EXIT, WEXITSTATUS(status));
        TEST_ASSERT_EQUAL_UINT32(LAST_CYCLE + (2U * BUSY_CYCLES), record->last_cycle);
        expect_off(2U);
        TEST_ASSERT_NOT_NULL_MESSAGE(strstr(said, "control: asked to end at rest; "), said);
    }
}

void test_SWR_ROBOT_019_the_box_of_this_robot_is_taken(void)
{
    board_robot_crc = robot_neuro.crc;
    const int status = control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_EQUAL_INT(0, WEXITSTATUS(status));
    expect_off(2U);
}

void test_SWR_ROBOT_019_the_box_of_another_robot_hears_nothing(void)
{
    board_robot_crc = robot_neuro.crc ^ 1U;
    const int status = control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_TRUE(WIFEXITED(status));
    TEST_ASSERT_EQUAL_INT(EXIT_CANNOT_START, WEXITSTATUS(status));
    TEST_ASSERT_EQUAL_UINT32(0U, record->count);
    TEST_ASSERT_NOT_NULL(strstr(said, "the box \"y\" is not that of this robot neuro"));
}

void test_SWR_CTRL_010_a_box_that_answers_nothing_is_switched_off_and_nothing_is_claimed(void)
{
    static const bsp_slot_result_t fates[] = {BSP_SLOT_NOT_SENT, BSP_SLOT_NO_ANSWER, BSP_SLOT_LATE,
                                              BSP_SLOT_NOT_IDLE, BSP_SLOT_BUS_ERROR};
    for (size_t i = 0U; i < (sizeof fates / sizeof fates[0]); i++) {
        (void)memset(record, 0, sizeof *record);
        fate = fates[i];
        const int status = control_ends(BY_SIGNAL, SIGTERM);
        TEST_ASSERT_TRUE(WIFEXITED(status));
        TEST_ASSERT_EQUAL_UINT32(0U, record->frames_received); /* The controller knows of it. */
        expect_off(LIMIT_OFF_EXCHANGES);
        TEST_ASSERT_NOT_NULL(strstr(said, "\"off\" was sent to all 7 cards, 0 confirm it"));
    }
}

void test_SWR_BSP_003_a_failed_self_test_is_reported_and_ends_in_off_before_any_cycle(void)
{
    is_wire_good = false;
    const int status = control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_TRUE(WIFEXITED(status));
    TEST_ASSERT_EQUAL_INT(EXIT_CANNOT_START, WEXITSTATUS(status));
    TEST_ASSERT_NOT_NULL_MESSAGE(
        strstr(said, "control: the wire of slot 3 is shifted by a bit; slow it down.\n"), said);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(said, "the self test of the board has failed; all 7"),
                                 said);
    expect_off_frames(2U);
    TEST_ASSERT_EQUAL_UINT32(2U, record->count);
    TEST_ASSERT_EQUAL_UINT32(0U, record->kicks);
}

void test_SWR_BSP_003_a_board_that_does_not_open_is_reported_and_nothing_is_sent(void)
{
    is_board_there = false;
    const int status = control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_TRUE(WIFEXITED(status));
    TEST_ASSERT_EQUAL_INT(EXIT_CANNOT_START, WEXITSTATUS(status));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(said, "control: switch the box on\n"), said);
    TEST_ASSERT_EQUAL_UINT32(0U, record->count);
}
