/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: the data of an answer are read by its form alone, which command, kind and status
 * decide. */
#include "unit/support/contract_trap.h"
#include "unity.h"

#include "interface/answer.h"
#include "robot/robot.h"

#include <string.h>

#define FORMS ((uint32_t)ANSWER_FORM_ENDED)
#define NUMBERS 100U

void setUp(void)
{
}

void tearDown(void)
{
}

/* The data of an answer begin at the same place in every form. */
static const void *read_as(answer_form_t form, const answer_t *answer)
{
    switch (form) {
    case ANSWER_FORM_POSE:
        return answer_as_pose(answer);
    case ANSWER_FORM_POINT:
        return answer_as_point(answer);
    case ANSWER_FORM_CHECKSUM:
        return answer_as_checksum(answer);
    case ANSWER_FORM_AXIS:
        return answer_as_axis(answer);
    case ANSWER_FORM_LIMIT:
        return answer_as_limit(answer);
    case ANSWER_FORM_SHARED_LIMIT:
        return answer_as_shared_limit(answer);
    case ANSWER_FORM_ENDED:
        return answer_as_ended(answer);
    case ANSWER_FORM_NONE:
    default:
        return NULL;
    }
}

static void expect_read_as_own_form_only(const answer_t *answer)
{
    const uint32_t own = (uint32_t)answer_form(answer);
    for (uint32_t form = 1U; form <= FORMS; form++) {
        if (form == own) {
            TEST_ASSERT_EQUAL_PTR(&answer->as, read_as((answer_form_t)form, answer));
        } else {
            EXPECT_CONTRACT("answer", form, (void)read_as((answer_form_t)form, answer));
        }
    }
}

void test_SWR_CMD_480_each_answer_is_read_as_its_own_form_and_as_no_other(void)
{
    for (uint32_t kind = 0U; kind <= ((uint32_t)ANSWER_ABORTED + 1U); kind++) {
        for (uint32_t number = 0U; number < NUMBERS; number++) {
            const answer_t listed = {.command = number, .kind = kind};
            const answer_t refused = {
                .command = (uint32_t)COMMAND_LIST_ROW, .kind = kind, .status = number};
            expect_read_as_own_form_only(&listed);
            expect_read_as_own_form_only(&refused);
        }
    }
}

static answer_form_t form_of(command_kind_t command, answer_kind_t kind, status_t status)
{
    const answer_t answer = {
        .command = (uint32_t)command, .kind = (uint32_t)kind, .status = (uint32_t)status};
    return answer_form(&answer);
}

static void expect_refusal_form(answer_form_t form, command_kind_t command, status_t status)
{
    TEST_ASSERT_EQUAL(form, form_of(command, ANSWER_REFUSED, status));
}

void test_SWR_CMD_480_the_form_is_that_of_the_rows_of_command_and_status(void)
{
    TEST_ASSERT_EQUAL(ANSWER_FORM_POSE, form_of(COMMAND_TARGET, ANSWER_ACCEPTED, STATUS_OK));
    TEST_ASSERT_EQUAL(ANSWER_FORM_NONE, form_of(COMMAND_JOG, ANSWER_ACCEPTED, STATUS_OK));
    TEST_ASSERT_EQUAL(ANSWER_FORM_NONE, form_of(COMMAND_JOG, ANSWER_DONE, STATUS_OK));
    TEST_ASSERT_EQUAL(ANSWER_FORM_ENDED, form_of(COMMAND_JOG, ANSWER_ABORTED, STATUS_EXPIRED));
    expect_refusal_form(ANSWER_FORM_LIMIT, COMMAND_TARGET, STATUS_AXIS_LIMIT);
    expect_refusal_form(ANSWER_FORM_SHARED_LIMIT, COMMAND_JOG, STATUS_SEPARATION_LIMIT);
    expect_refusal_form(ANSWER_FORM_AXIS, COMMAND_RESTORE, STATUS_OUT_OF_RANGE);
    expect_refusal_form(ANSWER_FORM_NONE, COMMAND_TARGET, STATUS_OUT_OF_RANGE);
    expect_refusal_form(ANSWER_FORM_NONE, COMMAND_LIST_END, STATUS_NOT_AT_REST);
}

/* Words of the data that a refusal with `status` has, with axis 5 and the upper end. */
static void expect_refusal(status_t status, uint32_t first, uint32_t second, uint32_t axis)
{
    uint32_t words[sizeof(answer_data_t) / sizeof(uint32_t)];
    answer_t answer = {.command = (uint32_t)COMMAND_JOG};
    answer_refuse(&answer, (uint32_t)status, 5U, 1U);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_REFUSED, answer.kind);
    TEST_ASSERT_EQUAL_UINT32(status, answer.status);
    TEST_ASSERT_EQUAL_UINT32(axis, answer_axis(&answer));
    (void)memcpy(words, &answer.as, sizeof words);
    TEST_ASSERT_EQUAL_UINT32(first, words[0]);
    TEST_ASSERT_EQUAL_UINT32(second, words[1]);
    TEST_ASSERT_EACH_EQUAL_UINT32(0U, &words[2], (sizeof words / sizeof words[0]) - 2U);
}

void test_SWR_CMD_481_a_refusal_names_axis_and_end_as_far_as_its_form_has_them(void)
{
    expect_refusal(STATUS_AXIS_LIMIT, 5U, 1U, 5U);
    expect_refusal(STATUS_SWITCH_ZONE, 5U, 0U, 5U);
    expect_refusal(STATUS_SEPARATION_LIMIT, 1U, 0U, ROBOT_AXIS_MAX);
    expect_refusal(STATUS_NOT_HOMED, 0U, 0U, ROBOT_AXIS_MAX);
}

void test_SWR_CMD_481_an_order_that_an_axis_ended_names_it(void)
{
    const answer_t answer = {.kind = (uint32_t)ANSWER_ABORTED, .as.ended = {.axis = 3U}};
    TEST_ASSERT_EQUAL_UINT32(3U, answer_axis(&answer));
}
