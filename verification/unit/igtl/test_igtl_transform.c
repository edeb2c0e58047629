/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: bare transforms become proposals and nothing else; they can be withdrawn, and
 * each that is refused has its answer.
 */
#include "base/rigid.h"
#include "igtl/dialect/igtl_requests.h"
#include "igtl/dialect/transform_dialect.h"
#include "limits/requirement_limits.h"
#include "igtl/wire/igtl_codec.h"
#include "unit/support/transform_world.h"
#include "unity.h"

#include <math.h>
#include <string.h>

void setUp(void)
{
    world_start();
}

void tearDown(void)
{
}

void test_SWR_IGTL_009_transforms_become_proposals(void)
{
    static const struct {
        const char *name;
        command_kind_t kind;
    } cases[] = {{"REGISTRATION", COMMAND_PROPOSE_REGISTRATION},
                 {"ENTRY_POINT", COMMAND_PROPOSE_ENTRY},
                 {"TARGET_POINT", COMMAND_PROPOSE_TARGET}};

    for (uint32_t i = 0U; i < 3U; i++) {
        place(cases[i].name, 1.0F);
        TEST_ASSERT_TRUE(igtl_requests_take(&dialect.requests, &command));
        TEST_ASSERT_EQUAL_UINT32(cases[i].kind, command.kind);
        TEST_ASSERT_EQUAL_INT32(1000000, command.as.seen_pose.pose.translation.x_nm);
    }
    EXPECT(0U, "");
}

void test_SWR_EVENT_005_a_proposal_carries_the_number_of_its_connection(void)
{
    place("ENTRY_POINT", 1.0F);
    TEST_ASSERT_TRUE(igtl_requests_take(&dialect.requests, &command));
    TEST_ASSERT_EQUAL_UINT32(NUMBER, command.peer);
}

void test_SWR_IGTL_009_no_message_becomes_any_other_command(void)
{
    static const char *const names[] = {"CMD_1",         "TGT_1",  "CLB_1",        "CURRENT_POSE",
                                        "target_point",  "TARGET", "ENTRY_POINTS", "",
                                        "MOVE_TO_TARGET"};

    for (uint32_t i = 0U; i < (sizeof names / sizeof names[0]); i++) {
        const igtl_message_t text = igtl_peer_string(names[i], "MOVE_TO_TARGET");

        place(names[i], 1.0F);
        TEST_ASSERT_NOT_NULL(strstr(igtl_peer_next(&outboxes[0]), " 12 UNKNOWN_COMMAND|"));
        moment.now_us += LIMIT_IGTL_UNKNOWN_US;
        transform_dialect_receive(&dialect, 0U, &text, &moment);
        TEST_ASSERT_NOT_NULL(strstr(igtl_peer_next(&outboxes[0]), " 12 UNKNOWN_COMMAND|"));
    }
    TEST_ASSERT_FALSE(igtl_requests_take(&dialect.requests, &command));
}

static void plan(uint32_t type, float x, float z)
{
    const igtl_message_t message = igtl_peer_trajectory(type, x, 2.0F, z);

    transform_dialect_receive(&dialect, 0U, &message, &moment);
}

static void expect_proposal(command_kind_t kind, int32_t z_nm)
{
    TEST_ASSERT_TRUE(igtl_requests_take(&dialect.requests, &command));
    TEST_ASSERT_EQUAL_UINT32(kind, command.kind);
    TEST_ASSERT_EQUAL_UINT32(NUMBER, command.peer);
    TEST_ASSERT_EQUAL_INT32(1000000, command.as.seen_pose.pose.translation.x_nm);
    TEST_ASSERT_EQUAL_INT32(z_nm, command.as.seen_pose.pose.translation.z_nm);
    TEST_ASSERT_EQUAL_INT(STATUS_OK, rigid_check(&command.as.seen_pose.pose));
}

void test_SWR_IGTL_067_a_trajectory_proposes_what_it_has_and_nothing_else(void)
{
    plan(IGTL_TRAJECTORY_BOTH, 1.0F, 3.0F);
    expect_proposal(COMMAND_PROPOSE_ENTRY, 3000000);
    expect_proposal(COMMAND_PROPOSE_TARGET, 13000000);
    moment.now_us += LIMIT_IGTL_PROPOSAL_BURST * LIMIT_IGTL_PROPOSAL_INTERVAL_US;
    plan(IGTL_TRAJECTORY_ENTRY, 1.0F, 4.0F);
    expect_proposal(COMMAND_PROPOSE_ENTRY, 4000000);
    plan(IGTL_TRAJECTORY_TARGET, 1.0F, 5.0F);
    expect_proposal(COMMAND_PROPOSE_TARGET, 15000000);
    TEST_ASSERT_FALSE(igtl_requests_take(&dialect.requests, &command));
    EXPECT(0U, "");
}

void test_SWR_IGTL_067_what_a_point_would_be_that_is_not_meant_does_not_count(void)
{
    igtl_message_t message = igtl_peer_trajectory(IGTL_TRAJECTORY_ENTRY, 1.0F, 2.0F, 3.0F);

    message.numbers[4] = igtl_peer_bits_of(NAN);
    transform_dialect_receive(&dialect, 0U, &message, &moment);
    expect_proposal(COMMAND_PROPOSE_ENTRY, 3000000);
}

void test_SWR_IGTL_067_plans_that_follow_each_other_are_the_newest_two_proposals(void)
{
    pass_us(0U);
    expect_measured(0U);
    for (uint32_t i = 0U; i < 10U; i++) {
        plan(IGTL_TRAJECTORY_BOTH, 1.0F, (float)i);
    }
    for (uint32_t i = 0U; i < LIMIT_IGTL_PROPOSAL_BURST; i++) {
        TEST_ASSERT_TRUE(igtl_requests_take(&dialect.requests, &command));
        answer(ANSWER_ACCEPTED, STATUS_OK);
    }
    TEST_ASSERT_FALSE(igtl_requests_take(&dialect.requests, &command));
    moment.now_us += 2U * LIMIT_IGTL_PROPOSAL_INTERVAL_US;
    transform_dialect_step(&dialect, &moment);
    expect_proposal(COMMAND_PROPOSE_TARGET, 19000000);
    expect_proposal(COMMAND_PROPOSE_ENTRY, 9000000);
    TEST_ASSERT_FALSE(igtl_requests_take(&dialect.requests, &command));
}

/* By its name, and neither of its points goes on. */
static void expect_refused(const igtl_message_t *message, const char *why)
{
    transform_dialect_receive(&dialect, 0U, message, &moment);
    EXPECT_BEGIN(0U, why);
    EXPECT(0U, "");
    TEST_ASSERT_FALSE(igtl_requests_take(&dialect.requests, &command));
}

void test_SWR_IGTL_068_a_trajectory_is_refused_whole(void)
{
    igtl_message_t message = igtl_peer_trajectory(IGTL_TRAJECTORY_BOTH, 1.0F, 2.0F, 3.0F);

    message.numbers[5] = igtl_peer_bits_of(NAN);
    expect_refused(&message, "STATUS Path 10 NOT_FINITE|");
    message.numbers[5] = igtl_peer_bits_of(2001.0F);
    expect_refused(&message, "STATUS Path 10 OUT_OF_RANGE|");
    message = igtl_peer_trajectory(IGTL_TRAJECTORY_BOTH, -INFINITY, 2.0F, 3.0F);
    expect_refused(&message, "STATUS Path 10 NOT_FINITE|");
    message = igtl_peer_trajectory(0U, 1.0F, 2.0F, 3.0F);
    expect_refused(&message, "STATUS Path 10 OUT_OF_RANGE|");
    message.code = 4U;
    expect_refused(&message, "STATUS Path 10 OUT_OF_RANGE|");
    message.code = 255U;
    expect_refused(&message, "STATUS Path 10 OUT_OF_RANGE|");
}

void test_SWR_IGTL_012_what_nothing_has_the_name_of_does_not_draw_the_poses(void)
{
    const igtl_message_t text = igtl_peer_string("NeedleToTracker", "here");
    igtl_message_t point = igtl_peer_query(IGTL_KIND_POINT, "F-1");

    pass_us(0U);
    expect_measured(0U);
    place("LinearTransform_3", 1.0F);
    transform_dialect_receive(&dialect, 0U, &text, &moment);
    transform_dialect_receive(&dialect, 0U, &point, &moment);
    pass_us(0U);
    EXPECT_BEGIN(0U, "STATUS LinearTransform_3 12 UNKNOWN_COMMAND|");
    EXPECT_BEGIN(0U, "STATUS NeedleToTracker 12 UNKNOWN_COMMAND|");
    EXPECT_BEGIN(0U, "STATUS F-1 12 UNKNOWN_COMMAND|");
    EXPECT(0U, "");
    place("TARGET_POINT", NAN);
    pass_us(0U);
    EXPECT_BEGIN(0U, "STATUS TARGET_POINT 10 NOT_FINITE|");
    expect_measured(0U);
}

/* How many of `count` names are refused, when all come now. */
static uint32_t refused_of(uint32_t count)
{
    uint32_t refused = 0U;

    for (char i = 0; i < (char)count; i++) {
        const char name[] = {'T', (char)('a' + i), '\0'};

        place(name, 1.0F);
    }
    while (igtl_peer_next(&outboxes[0])[0] != '\0') {
        refused++;
    }
    return refused;
}

void test_SWR_IGTL_008_a_name_that_nothing_has_is_refused_once_in_its_time(void)
{
    const igtl_message_t text = igtl_peer_string("Ta", "here");

    TEST_ASSERT_EQUAL_UINT32(LIMIT_IGTL_UNKNOWN_NAMES, refused_of(LIMIT_IGTL_UNKNOWN_NAMES));
    moment.now_us += LIMIT_IGTL_UNKNOWN_US - 1U;
    TEST_ASSERT_EQUAL_UINT32(0U, refused_of(LIMIT_IGTL_UNKNOWN_NAMES));
    transform_dialect_receive(&dialect, 0U, &text, &moment);
    EXPECT(0U, "");
    moment.now_us += 1U;
    TEST_ASSERT_EQUAL_UINT32(LIMIT_IGTL_UNKNOWN_NAMES, refused_of(LIMIT_IGTL_UNKNOWN_NAMES));
}

void test_SWR_IGTL_008_a_name_too_many_is_refused_in_place_of_the_oldest(void)
{
    place("Tz", 1.0F);
    EXPECT_BEGIN(0U, "STATUS Tz 12 UNKNOWN_COMMAND|");
    moment.now_us += 1U;
    TEST_ASSERT_EQUAL_UINT32(LIMIT_IGTL_UNKNOWN_NAMES, refused_of(LIMIT_IGTL_UNKNOWN_NAMES));
    place("Tz", 1.0F);
    EXPECT_BEGIN(0U, "STATUS Tz 12 UNKNOWN_COMMAND|");
    EXPECT(0U, "");
}

void test_SWR_IGTL_010_bad_numbers_never_become_a_proposal(void)
{
    place("TARGET_POINT", NAN);
    EXPECT_BEGIN(0U, "STATUS TARGET_POINT 10 NOT_FINITE|");
    place("TARGET_POINT", 1e9F);
    EXPECT_BEGIN(0U, "STATUS TARGET_POINT 10 OUT_OF_RANGE|");
    TEST_ASSERT_FALSE(igtl_requests_take(&dialect.requests, &command));
}

void test_SWR_IGTL_008_refused_proposal_is_answered(void)
{
    place("ENTRY_POINT", 1.0F);
    TEST_ASSERT_TRUE(igtl_requests_take(&dialect.requests, &command));
    answer(ANSWER_REFUSED, STATUS_SEPARATION_LIMIT);
    EXPECT_BEGIN(0U, "STATUS ENTRY_POINT 10 SEPARATION_LIMIT|");
}

void test_SWR_IGTL_008_silence_of_the_controller_is_answered(void)
{
    pass_us(0U);
    expect_measured(0U);
    place("REGISTRATION", 1.0F);
    pass_us(IGTL_ANSWER_TIMEOUT_US);
    EXPECT_BEGIN(0U, "STATUS REGISTRATION 7 NO_ANSWER|");
    EXPECT(0U, "");
}

/* The newest command that is passed on; how many there were. */
static uint32_t pass_on(void)
{
    uint32_t count = 0U;

    while (igtl_requests_take(&dialect.requests, &command)) {
        count++;
    }
    return count;
}

void test_SWR_IGTL_044_a_flood_is_not_refused_but_the_newest_goes_on_in_its_time(void)
{
    pass_us(0U);
    expect_measured(0U);
    for (uint32_t i = 0U; i < 100U; i++) {
        place("TARGET_POINT", (float)i);
    }
    TEST_ASSERT_EQUAL_UINT32(LIMIT_IGTL_PROPOSAL_BURST, pass_on());
    answer(ANSWER_ACCEPTED, STATUS_OK);
    pass_us(LIMIT_IGTL_PROPOSAL_INTERVAL_US);
    for (uint32_t i = 1U; i < LIMIT_IGTL_PROPOSAL_BURST; i++) {
        EXPECT_BEGIN(0U, "STATUS TARGET_POINT 7 NO_ANSWER|");
    }
    expect_measured(0U);
    TEST_ASSERT_EQUAL_UINT32(1U, pass_on());
    TEST_ASSERT_EQUAL_INT32(99000000, command.as.seen_pose.pose.translation.x_nm);
    pass_us(1000U);
    EXPECT(0U, "");
}

void test_SWR_IGTL_044_a_proposal_that_control_never_takes_is_answered(void)
{
    pass_us(0U);
    expect_measured(0U);
    for (uint32_t i = 0U; i < 4U; i++) {
        place("ENTRY_POINT", 1.0F);
    }
    pass_us(LIMIT_IGTL_PROPOSAL_INTERVAL_US);
    place("ENTRY_POINT", 1.0F);
    TEST_ASSERT_EQUAL_UINT32(4U, pass_on());
    pass_us(LIMIT_IGTL_PROPOSAL_WAIT_US);
    for (uint32_t i = 0U; i < 5U; i++) {
        EXPECT_BEGIN(0U, "STATUS ENTRY_POINT 7 NO_ANSWER|");
    }
    EXPECT(0U, "");
}

void test_SWR_IGTL_045_each_proposal_can_be_withdrawn(void)
{
    static const struct {
        const char *name;
        command_kind_t kind;
    } cases[] = {{"REGISTRATION", COMMAND_PROPOSE_REGISTRATION},
                 {"ENTRY_POINT", COMMAND_PROPOSE_ENTRY},
                 {"TARGET_POINT", COMMAND_PROPOSE_TARGET}};

    for (uint32_t i = 0U; i < 3U; i++) {
        const igtl_message_t text = igtl_peer_string(cases[i].name, "WITHDRAW");

        transform_dialect_receive(&dialect, 0U, &text, &moment);
        TEST_ASSERT_TRUE(igtl_requests_take(&dialect.requests, &command));
        TEST_ASSERT_EQUAL_UINT32(COMMAND_WITHDRAW, command.kind);
        TEST_ASSERT_EQUAL_UINT32(cases[i].kind, command.as.withdrawal.of);
        TEST_ASSERT_EQUAL_UINT32(NUMBER, command.peer);
        answer(ANSWER_REFUSED, STATUS_NOT_PROPOSED);
        TEST_ASSERT_NOT_NULL(strstr(igtl_peer_next(&outboxes[0]), " 13 NOT_PROPOSED|"));
        pass_us(LIMIT_IGTL_PROPOSAL_NOTE_US);
        expect_measured(0U);
    }
}

void test_SWR_IGTL_045_other_texts_withdraw_nothing(void)
{
    static const char *const texts[] = {"", "withdraw", "WITHDRAWN", "WITHDRAW "};

    for (uint32_t i = 0U; i < 4U; i++) {
        const igtl_message_t text = igtl_peer_string("ENTRY_POINT", texts[i]);

        transform_dialect_receive(&dialect, 0U, &text, &moment);
        TEST_ASSERT_NOT_NULL(strstr(igtl_peer_next(&outboxes[0]), " 12 UNKNOWN_COMMAND|"));
    }
    TEST_ASSERT_FALSE(igtl_requests_take(&dialect.requests, &command));
}

void test_SWR_IGTL_011_answer_for_a_peer_that_has_gone_is_dropped(void)
{
    place("TARGET_POINT", 1.0F);
    TEST_ASSERT_TRUE(igtl_requests_take(&dialect.requests, &command));
    transform_dialect_disconnected(&dialect, 0U);
    answer(ANSWER_REFUSED, STATUS_BUSY);
    pass_us(0U);
    EXPECT(0U, "");
}
