/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: one procedure, with refusals, a stop and an e-stop, is the same conversation
 * every time, in each dialect its own. Messages of the client begin with ">"; acts of the robot
 * without a command stand in brackets.
 */
#include "charts/arming_chart.h"
#include "igtl/dialect/igtl_dialect.h"
#include "igtl/dialect/igtl_requests.h"
#include "igtl/workphase/workphase_commands.h"
#include "limits/requirement_limits.h"
#include "unit/support/workphase_world.h"
#include "unity.h"
#include "charts/estop_latch_chart.h"

#include <stdio.h>
#include <string.h>

#define LINES 120U

static char heard[LINES][160];
static uint32_t count;
static command_t order;

void setUp(void)
{
    count = 0U;
}

void tearDown(void)
{
}

static void note(const char *mark, const char *first, const char *second)
{
    TEST_ASSERT_TRUE(count < LINES);
    (void)snprintf(heard[count], sizeof heard[0], "%s%s%s", mark, first, second);
    count++;
}

/* Sentences may change; names, codes and numbers may not. */
static void listen(void)
{
    for (const char *line = igtl_peer_next(&outboxes[0]); line[0] != '\0';
         line = igtl_peer_next(&outboxes[0])) {
        TEST_ASSERT_TRUE(count < LINES);
        (void)snprintf(heard[count], sizeof heard[0], "%.*s", (int)strcspn(line, "|"), line);
        count++;
    }
}

static void wait(uint64_t time_us)
{
    pass_us(time_us);
    listen();
}

static void happens(const char *what)
{
    note("[", what, "]");
    wait(0U);
}

static void command_phase(const char *name, const char *phase)
{
    char line[64];

    (void)snprintf(line, sizeof line, "%s %s", name, phase);
    note("> ", line, "");
    say(0U, name, phase);
    listen();
}

static void ask(const char *name)
{
    note("> ", name, "");
    say(0U, name, "");
    listen();
}

static void show(const char *name)
{
    note("> ", name, "");
    place(0U, name, 1.0F);
    pass_us(0U);
    listen();
}

static void taken(uint32_t is_final)
{
    TEST_ASSERT_TRUE(igtl_requests_take(&dialect.requests, &command));
    if (command.kind == (uint32_t)COMMAND_WORKPHASE) {
        snapshot.workphase = command.as.workphase.workphase;
    }
    if (is_final == 0U) {
        order = command;
        snapshot.order = (uint32_t)ARMING_STATE_WAITING;
    }
    answer_to(&command, ANSWER_ACCEPTED, STATUS_OK, is_final);
    listen();
}

static void refused(status_t why)
{
    TEST_ASSERT_TRUE(igtl_requests_take(&dialect.requests, &command));
    answer_to(&command, ANSWER_REFUSED, why, 1U);
    listen();
}

static void ended(answer_kind_t how, status_t why)
{
    snapshot.order = (uint32_t)ARMING_STATE_NONE;
    answer_to(&order, how, why, 1U);
    wait(0U);
}

static void home_and_register(void)
{
    command_phase("CMD_1", "START_UP");
    taken(0U);
    ended(ANSWER_DONE, STATUS_OK);
    command_phase("CMD_2", "TARGETING");
    refused(STATUS_NOT_REGISTERED);
    ask("CURRENT_STATUS");
    command_phase("CMD_3", "PLANNING");
    taken(1U);
    wait(LIMIT_IGTL_EXTRA_DELAY_US);
    command_phase("CMD_4", "CALIBRATION");
    taken(1U);
    show("CLB_5");
    taken(1U);
    wait(LIMIT_IGTL_EXTRA_DELAY_US);
}

static void aim(void)
{
    command_phase("CMD_6", "TARGETING");
    taken(1U);
    show("ENTRY_7");
    taken(1U);
    show("TGT_8");
    refused(STATUS_AXIS_LIMIT);
    show("TGT_9");
    snapshot.has_target = 1U;
    taken(1U);
    wait(LIMIT_IGTL_EXTRA_DELAY_US);
}

static void move_and_retract(void)
{
    command_phase("CMD_A", "MOVE_TO_TARGET");
    taken(0U);
    snapshot.order = (uint32_t)ARMING_STATE_MOVING;
    happens("it moves");
    show("NPOS_B");
    taken(1U);
    wait(IGTL_STREAM_US);
    ask("CURRENT_POSITION");
    snapshot.scanner_treatment = snapshot.scanner_target;
    ended(ANSWER_DONE, STATUS_OK);
    ask("HAS_REACHED_TARGET");
    ask("RETRACT_NEEDLE");
    taken(0U);
    ended(ANSWER_DONE, STATUS_OK);
}

/* STOP, then a move that the e-stop ends. */
static void stop(void)
{
    command_phase("CMD_C", "MOVE_TO_TARGET");
    taken(0U);
    command_phase("CMD_D", "STOP");
    answer_to(&order, ANSWER_ABORTED, STATUS_DISCARDED, 1U);
    snapshot.order = (uint32_t)ARMING_STATE_NONE;
    taken(1U);
    wait(1000000U);
    command_phase("CMD_E", "MOVE_TO_TARGET");
    refused(STATUS_WRONG_WORKPHASE);
    command_phase("CMD_F", "TARGETING");
    taken(1U);
    command_phase("CMD_G", "MOVE_TO_TARGET");
    taken(0U);
    snapshot.workphase = (uint32_t)WORKPHASE_EMERGENCY;
    snapshot.estop = (uint32_t)ESTOP_LATCH_STATE_PULLED;
    note("[", "the e-stop is pulled", "]");
    ended(ANSWER_ABORTED, STATUS_DISCARDED);
    wait(1000000U);
}

static void navigate(igtl_language_t spoken)
{
    world_start(spoken);
    wait(0U);
    home_and_register();
    aim();
    move_and_retract();
    stop();
}

static void expect_conversation(const char *const *expected, uint32_t lines)
{
    for (uint32_t i = 0U; (i < lines) && (i < count); i++) {
        TEST_ASSERT_EQUAL_STRING_MESSAGE(expected[i], heard[i], (i > 0U) ? heard[i - 1U] : "");
    }
    TEST_ASSERT_EQUAL_UINT32(lines, count);
}

void test_SWR_IGTL_007_a_procedure_in_the_language_of_2013(void)
{
    static const char *const expected[] = {
        "> CMD_1 START_UP",
        "STRING ACK_1 START_UP",
        "STATUS CURRENT_STATUS 1 START_UP",
        "STATUS START_UP 1 START_UP",
        "> CMD_2 TARGETING",
        "STRING ACK_2 TARGETING",
        "STATUS CURRENT_STATUS 1 TARGETING",
        "STATUS TARGETING 13 START_UP",
        "> CURRENT_STATUS",
        "STATUS CURRENT_STATUS 1 START_UP",
        "> CMD_3 PLANNING",
        "STRING ACK_3 PLANNING",
        "STATUS CURRENT_STATUS 1 PLANNING",
        "STATUS PLANNING 1 PLANNING",
        "> CMD_4 CALIBRATION",
        "STRING ACK_4 CALIBRATION",
        "STATUS CURRENT_STATUS 1 CALIBRATION",
        "> CLB_5",
        "TRANSFORM ACK_5 1.000 2.000 3.000",
        "STATUS CALIBRATION 1 CALIBRATION",
        "> CMD_6 TARGETING",
        "STRING ACK_6 TARGETING",
        "STATUS CURRENT_STATUS 1 TARGETING",
        "STATUS TARGETING 1 TARGETING",
        "> ENTRY_7",
        "TRANSFORM ACK_7 1.000 2.000 3.000",
        "STATUS ENTRY 1 TARGETING",
        "> TGT_8",
        "TRANSFORM ACK_8 1.000 2.000 3.000",
        "STATUS TARGET 10 TARGETING",
        "> TGT_9",
        "TRANSFORM ACK_9 1.000 2.000 3.000",
        "STATUS TARGET 1 TARGETING",
        "TRANSFORM TARGET 0.000 0.000 0.000",
        "TRANSFORM REACHABLE_TARGET 0.000 0.000 0.000",
        "> CMD_A MOVE_TO_TARGET",
        "STRING ACK_A MOVE_TO_TARGET",
        "STATUS CURRENT_STATUS 1 MOVE_TO_TARGET",
        "[it moves]",
        "TRANSFORM CURRENT_POSITION 5.000 0.000 0.000",
        "> NPOS_B",
        "TRANSFORM ACK_B 1.000 2.000 3.000",
        "STATUS NPOS 1 MOVE_TO_TARGET",
        "TRANSFORM CURRENT_POSITION 5.000 0.000 0.000",
        "> CURRENT_POSITION",
        "TRANSFORM CURRENT_POSITION 5.000 0.000 0.000",
        "STRING IS_IN_TARGETING_POS 0",
        "STRING HAS_REACHED_TARGET 0",
        "STATUS MOVE_TO_TARGET 1 MOVE_TO_TARGET",
        "TRANSFORM CURRENT_POSITION 0.000 0.000 0.000",
        "> HAS_REACHED_TARGET",
        "STRING HAS_REACHED_TARGET 1",
        "> RETRACT_NEEDLE",
        "STATUS ACK_RETRACT_NEEDLE 1 MOVE_TO_TARGET",
        "STATUS RETRACT_NEEDLE 1 MOVE_TO_TARGET",
        "> CMD_C MOVE_TO_TARGET",
        "STRING ACK_C MOVE_TO_TARGET",
        "STATUS CURRENT_STATUS 1 MOVE_TO_TARGET",
        "> CMD_D STOP",
        "STRING ACK_D STOP",
        "STATUS CURRENT_STATUS 1 STOP",
        "STATUS STOP 1 STOP",
        "> CMD_E MOVE_TO_TARGET",
        "STRING ACK_E MOVE_TO_TARGET",
        "STATUS CURRENT_STATUS 1 MOVE_TO_TARGET",
        "STATUS MOVE_TO_TARGET 13 STOP",
        "> CMD_F TARGETING",
        "STRING ACK_F TARGETING",
        "STATUS CURRENT_STATUS 1 TARGETING",
        "STATUS TARGETING 1 TARGETING",
        "> CMD_G MOVE_TO_TARGET",
        "STRING ACK_G MOVE_TO_TARGET",
        "STATUS CURRENT_STATUS 1 MOVE_TO_TARGET",
        "[the e-stop is pulled]",
        "STATUS MOVE_TO_TARGET 13 EMERGENCY",
        "STATUS EMERGENCY 3 PANIC_MODE",
    };

    navigate(IGTL_LANGUAGE_BRP_2013);
    expect_conversation(expected, sizeof expected / sizeof expected[0]);
}

void test_SWR_IGTL_031_a_procedure_in_the_language_of_2021(void)
{
    static const char *const expected[] = {
        "> CMD_1 START_UP",
        "STRING ACK_1 START_UP",
        "STATUS CURRENT_STATUS 1 START_UP",
        "STATUS START_UP 1 START_UP",
        "> CMD_2 TARGETING",
        "STRING ACK_2 TARGETING",
        "STATUS CURRENT_STATUS 1 TARGETING",
        "STATUS TARGETING 13 START_UP",
        "> CURRENT_STATUS",
        "STATUS CURRENT_STATUS 1 START_UP",
        "> CMD_3 PLANNING",
        "STRING ACK_3 PLANNING",
        "STATUS CURRENT_STATUS 1 PLANNING",
        "STATUS PLANNING 1 PLANNING",
        "> CMD_4 CALIBRATION",
        "STRING ACK_4 CALIBRATION",
        "STATUS CURRENT_STATUS 1 CALIBRATION",
        "STATUS CALIBRATION 1 CALIBRATION",
        "> CLB_5",
        "TRANSFORM ACK_5 1.000 2.000 3.000",
        "STATUS CALIBRATION 1 CALIBRATION",
        "> CMD_6 TARGETING",
        "STRING ACK_6 TARGETING",
        "STATUS CURRENT_STATUS 1 TARGETING",
        "STATUS TARGETING 1 TARGETING",
        "> ENTRY_7",
        "TRANSFORM ACK_7 1.000 2.000 3.000",
        "STATUS ENTRY 1 TARGETING",
        "> TGT_8",
        "TRANSFORM ACK_8 1.000 2.000 3.000",
        "STATUS TARGET 10 TARGETING",
        "> TGT_9",
        "TRANSFORM ACK_9 1.000 2.000 3.000",
        "STATUS TARGET 1 TARGETING",
        "TRANSFORM REACHABLE_TARGET 0.000 0.000 0.000",
        "> CMD_A MOVE_TO_TARGET",
        "STRING ACK_A MOVE_TO_TARGET",
        "STATUS CURRENT_STATUS 1 MOVE_TO_TARGET",
        "STATUS MOVE_TO_TARGET 1 MOVE_TO_TARGET",
        "TRANSFORM CURRENT_POSITION 5.000 0.000 0.000",
        "[it moves]",
        "> NPOS_B",
        "TRANSFORM ACK_B 1.000 2.000 3.000",
        "STATUS MOVE_TO_TARGET 1 MOVE_TO_TARGET",
        "> CURRENT_POSITION",
        "TRANSFORM CURRENT_POSITION 5.000 0.000 0.000",
        "STRING IS_IN_TARGETING_POS 0",
        "STRING HAS_REACHED_TARGET 0",
        "> HAS_REACHED_TARGET",
        "STRING HAS_REACHED_TARGET 1",
        "> RETRACT_NEEDLE",
        "STATUS ACK_RETRACT_NEEDLE 1 MOVE_TO_TARGET",
        "STATUS RETRACT_NEEDLE 1 MOVE_TO_TARGET",
        "> CMD_C MOVE_TO_TARGET",
        "STRING ACK_C MOVE_TO_TARGET",
        "STATUS CURRENT_STATUS 1 MOVE_TO_TARGET",
        "STATUS MOVE_TO_TARGET 1 MOVE_TO_TARGET",
        "TRANSFORM CURRENT_POSITION 0.000 0.000 0.000",
        "> CMD_D STOP",
        "STRING ACK_D STOP",
        "STATUS CURRENT_STATUS 1 STOP",
        "STATUS STOP 1 STOP",
        "> CMD_E MOVE_TO_TARGET",
        "STRING ACK_E MOVE_TO_TARGET",
        "STATUS CURRENT_STATUS 1 MOVE_TO_TARGET",
        "STATUS MOVE_TO_TARGET 13 STOP",
        "> CMD_F TARGETING",
        "STRING ACK_F TARGETING",
        "STATUS CURRENT_STATUS 1 TARGETING",
        "STATUS TARGETING 1 TARGETING",
        "> CMD_G MOVE_TO_TARGET",
        "STRING ACK_G MOVE_TO_TARGET",
        "STATUS CURRENT_STATUS 1 MOVE_TO_TARGET",
        "STATUS MOVE_TO_TARGET 1 MOVE_TO_TARGET",
        "TRANSFORM CURRENT_POSITION 0.000 0.000 0.000",
        "[the e-stop is pulled]",
        "STATUS MOVE_TO_TARGET 13 EMERGENCY",
        "STATUS EMERGENCY 3 PANIC_MODE",
    };

    navigate(IGTL_LANGUAGE_BRP_2021);
    expect_conversation(expected, sizeof expected / sizeof expected[0]);
}
