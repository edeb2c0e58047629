/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: each reason of a refusal has its code of the protocol, and names its axis.
 */
#include "igtl/dialect/igtl_dialect.h"
#include "robot/robot_neuro.h"
#include "unity.h"

#include <string.h>

void setUp(void)
{
}

void tearDown(void)
{
}

void test_SWR_IGTL_008_a_target_at_a_switch_names_its_axis(void)
{
    char text[IGTL_REASON_SIZE];
    const igtl_moment_t moment = {.snapshot = NULL};
    const answer_t at_switch = {.kind = (uint32_t)ANSWER_REFUSED,
                                .status = (uint32_t)STATUS_SWITCH_ZONE,
                                .as.axis = {.axis = NEURO_AXIS_LATERAL}};

    igtl_reason_text(&robot_neuro, &at_switch, &moment, text);
    TEST_ASSERT_NOT_NULL(strstr(text, "SWITCH_ZONE"));
    TEST_ASSERT_NOT_NULL(strstr(text, "(lateral)"));
}

void test_SWR_IGTL_008_each_reason_has_its_code(void)
{
    TEST_ASSERT_EQUAL_UINT32(1U, igtl_reason_code(STATUS_OK));
    TEST_ASSERT_EQUAL_UINT32(12U, igtl_reason_code(STATUS_UNKNOWN_COMMAND));
    TEST_ASSERT_EQUAL_UINT32(6U, igtl_reason_code(STATUS_BUSY));
    TEST_ASSERT_EQUAL_UINT32(13U, igtl_reason_code(STATUS_WRONG_WORKPHASE));
    TEST_ASSERT_EQUAL_UINT32(13U, igtl_reason_code(STATUS_HARDWARE_NOT_READY));
    TEST_ASSERT_EQUAL_UINT32(13U, igtl_reason_code(STATUS_CONFIRM_POSITIONS));
    TEST_ASSERT_EQUAL_UINT32(10U, igtl_reason_code(STATUS_NOT_RIGID));
    TEST_ASSERT_EQUAL_UINT32(10U, igtl_reason_code(STATUS_SEPARATION_LIMIT));
    TEST_ASSERT_EQUAL_UINT32(10U, igtl_reason_code(STATUS_SWITCH_ZONE));
    TEST_ASSERT_EQUAL_UINT32(7U, igtl_reason_code(STATUS_EXPIRED));
    TEST_ASSERT_EQUAL_UINT32(7U, igtl_reason_code(STATUS_NO_ANSWER));
    TEST_ASSERT_EQUAL_UINT32(10U, igtl_reason_code(STATUS_ENTRY_POINT));
    TEST_ASSERT_EQUAL_UINT32(10U, igtl_reason_code(STATUS_NO_POSE));
    TEST_ASSERT_EQUAL_UINT32(10U, igtl_reason_code(STATUS_PROGRAM_ORDER));
    TEST_ASSERT_EQUAL_UINT32(10U, igtl_reason_code(STATUS_PROGRAM_DWELL));
    TEST_ASSERT_EQUAL_UINT32(10U, igtl_reason_code(STATUS_PROGRAM_DEPTH));
    TEST_ASSERT_EQUAL_UINT32(10U, igtl_reason_code(STATUS_PROGRAM_OTHER));
    TEST_ASSERT_EQUAL_UINT32(13U, igtl_reason_code(STATUS_PROGRAM_STOPPED));
    TEST_ASSERT_EQUAL_UINT32(13U, igtl_reason_code(STATUS_NOT_PROPOSED));
    TEST_ASSERT_EQUAL_UINT32(13U, igtl_reason_code(STATUS_NOT_ALIGNED));
    TEST_ASSERT_EQUAL_UINT32(13U, igtl_reason_code(STATUS_MOTION_ARMED));
    TEST_ASSERT_EQUAL_UINT32(5U, igtl_reason_code(STATUS_NO_AUTHORITY));
}
