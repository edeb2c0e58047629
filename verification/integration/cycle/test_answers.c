/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * An answer is one of those that the row of its command lists. The rig holds every answer of every
 * test against them; here each command is given in many states, with numbers that it has and
 * others.
 */
#include "integration/support/rig.h"
#include "unit/support/commands.h"

#include "unity.h"

#include "interface/app/answer_list.h"

#define SOURCES (COMMAND_SOURCE_COUNT + 1U) /* The last one is none. */
#define KINDS (COMMAND_KIND_COUNT + 2U)     /* The last two are none. */

static rig_t rig;
static rig_t begun;

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static answer_t answer_of(command_kind_t command, answer_kind_t kind, status_t status)
{
    return (answer_t){.command = (uint32_t)command,
                      .kind = (uint32_t)kind,
                      .status = (uint32_t)status,
                      .is_final = 1U};
}

static bool is_listed(const answer_t *answer)
{
    return answer_row_of(answer) < answer_row_count;
}

static command_t command_of(uint32_t kind, uint32_t number)
{
    return (kind < COMMAND_KIND_COUNT) ? commands_of_number((command_kind_t)kind, number)
                                       : (command_t){.kind = kind};
}

/* Each command from each source, all from the same state. Returns the number of refusals. */
static uint32_t give_each(uint32_t number)
{
    uint32_t refused = 0U;
    begun = rig;
    for (uint32_t i = 0U; i < (KINDS * SOURCES); i++) {
        command_t command = command_of(i / SOURCES, number);
        command.source = i % SOURCES;
        command.peer =
            (command.source == (uint32_t)COMMAND_SOURCE_HTTP) ? RIG_PAGE : RIG_CONNECTION;
        rig = begun;
        const answer_t answer = rig_command(&rig, command);
        TEST_ASSERT_TRUE(is_listed(&answer));
        refused += (answer.kind == (uint32_t)ANSWER_REFUSED) ? 1U : 0U;
    }
    rig = begun;
    return refused;
}

static uint32_t give_each_of_each_number(void)
{
    static const uint32_t numbers[] = {0U, 1U, 3U, 6U, 99U, UINT32_MAX};
    uint32_t refused = 0U;
    for (uint32_t i = 0U; i < (sizeof numbers / sizeof numbers[0]); i++) {
        refused += give_each(numbers[i]);
    }
    return refused;
}

void test_SWR_CMD_340_before_start_up_each_command_is_answered_as_its_row_says(void)
{
    rig_start(&rig);
    TEST_ASSERT_GREATER_THAN_UINT32(KINDS, give_each_of_each_number());
}

void test_SWR_CMD_340_in_each_workphase_each_command_is_answered_as_its_row_says(void)
{
    static const workphase_t phases[] = {WORKPHASE_PLANNING,  WORKPHASE_CALIBRATION,
                                         WORKPHASE_TARGETING, WORKPHASE_MANUAL,
                                         WORKPHASE_STOP,      WORKPHASE_EMERGENCY};
    for (uint32_t i = 0U; i < (sizeof phases / sizeof phases[0]); i++) {
        rig_start_targeted(&rig);
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, phases[i]).status);
        TEST_ASSERT_GREATER_THAN_UINT32(KINDS, give_each_of_each_number());
    }
}

void test_SWR_CMD_340_while_an_order_runs_each_command_is_answered_as_its_row_says(void)
{
    rig_start_moving(&rig);
    TEST_ASSERT_GREATER_THAN_UINT32(KINDS, give_each_of_each_number());
}

void test_SWR_CMD_340_after_a_fault_each_command_is_answered_as_its_row_says(void)
{
    rig_start_moving(&rig);
    rig_box(&rig, "estop pull");
    rig_cycles(&rig, 20U);
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_EMERGENCY, rig.outputs.snapshot.workphase);
    TEST_ASSERT_GREATER_THAN_UINT32(KINDS, give_each_of_each_number());
}

void test_SWR_CMD_340_with_a_damaged_table_each_command_is_answered_as_its_row_says(void)
{
    rig_start_homed(&rig);
    rig.robot.axes[0].maximum_ticks++;
    rig_cycle(&rig);
    TEST_ASSERT_NOT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_ROBOT_TABLE_DAMAGED));
    TEST_ASSERT_GREATER_THAN_UINT32(KINDS, give_each_of_each_number());
}

void test_SWR_CMD_340_what_no_row_lists_is_found(void)
{
    const answer_t listed = answer_of(COMMAND_POSE, ANSWER_REFUSED, STATUS_NO_POSE);
    const answer_t another_status = answer_of(COMMAND_ALIGN, ANSWER_REFUSED, STATUS_NO_POSE);
    const answer_t another_verdict = answer_of(COMMAND_POSE, ANSWER_ABORTED, STATUS_NO_POSE);
    const answer_t ended_without_an_order = answer_of(COMMAND_TARGET, ANSWER_DONE, STATUS_OK);
    const answer_t done_at_once = answer_of(COMMAND_POSE, ANSWER_ACCEPTED, STATUS_OK);
    answer_t begun_without_an_order = answer_of(COMMAND_TARGET, ANSWER_ACCEPTED, STATUS_OK);
    begun_without_an_order.is_final = 0U;
    TEST_ASSERT_TRUE(is_listed(&listed));
    TEST_ASSERT_FALSE(is_listed(&another_status));
    TEST_ASSERT_FALSE(is_listed(&another_verdict));
    TEST_ASSERT_FALSE(is_listed(&ended_without_an_order));
    TEST_ASSERT_FALSE(is_listed(&done_at_once));
    TEST_ASSERT_FALSE(is_listed(&begun_without_an_order));
}
