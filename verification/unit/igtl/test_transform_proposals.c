/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: what one connection proposes goes on evenly, the newest of each subject, and
 * little of it to the log; nothing is lost that is still wanted.
 */
#include "igtl/dialect/igtl_requests.h"
#include "igtl/dialect/transform_proposals.h"
#include "limits/requirement_limits.h"
#include "unit/support/commands.h"
#include "unity.h"

#include <string.h>

#define PEER 3U
#define SECOND_US 1000000U

static transform_proposals_t proposals;
static igtl_requests_t requests;
static igtl_moment_t moment;
static command_t passed;

void setUp(void)
{
    (void)memset(&proposals, 0, sizeof proposals);
    igtl_requests_init(&requests, 1U, IGTL_REQUESTS_COMMON);
    moment = (igtl_moment_t){.now_us = 5U, .answer_clock_us = 5U};
}

void tearDown(void)
{
}

static void pass_us(uint64_t time_us)
{
    moment.now_us += time_us;
    moment.answer_clock_us += time_us;
}

static void put(command_kind_t kind, uint32_t argument, int32_t x_nm)
{
    const rigid_t pose = {.translation = {.x_nm = x_nm}};
    const command_t command = (kind == COMMAND_WITHDRAW) ? commands_of_number(kind, argument)
                                                         : commands_of_pose(kind, pose);

    transform_proposals_put(&proposals, &command, &moment);
}

static void propose(int32_t x_nm)
{
    put(COMMAND_PROPOSE_ENTRY, 0U, x_nm);
}

static void withdraw(command_kind_t kind)
{
    put(COMMAND_WITHDRAW, (uint32_t)kind, 0);
}

/* Passes on; the next that goes, answered at once. False for none. */
static bool goes(void)
{
    transform_proposals_pass(&proposals, &requests, PEER, &moment);
    if (!igtl_requests_take(&requests, &passed)) {
        return false;
    }
    igtl_requests_end(igtl_requests_find(&requests, passed.id));
    return true;
}

static void expect(command_kind_t kind, uint32_t argument)
{
    TEST_ASSERT_TRUE(goes());
    TEST_ASSERT_EQUAL_UINT32(kind, passed.kind);
    TEST_ASSERT_EQUAL_UINT32(argument, commands_number(&passed));
}

/* Uses up what may go at once. */
static void use_up(void)
{
    for (uint32_t i = 0U; i < LIMIT_IGTL_PROPOSAL_BURST; i++) {
        propose((int32_t)i);
        TEST_ASSERT_TRUE(goes());
    }
}

void test_SWR_IGTL_044_one_goes_in_each_interval_and_few_at_once(void)
{
    uint64_t times_us[200];
    uint32_t count = 0U;

    for (uint32_t i = 0U; i < 2500U; i++) {
        propose((int32_t)i);
        while (goes()) {
            times_us[count] = moment.now_us;
            count++;
        }
        pass_us(2000U);
    }
    TEST_ASSERT_EQUAL_UINT32((5U * SECOND_US / LIMIT_IGTL_PROPOSAL_INTERVAL_US) +
                                 (LIMIT_IGTL_PROPOSAL_BURST - 1U),
                             count);
    for (uint32_t i = LIMIT_IGTL_PROPOSAL_BURST + 1U; i < count; i++) {
        TEST_ASSERT_EQUAL_UINT64(LIMIT_IGTL_PROPOSAL_INTERVAL_US, times_us[i] - times_us[i - 1U]);
    }
}

void test_SWR_IGTL_044_no_more_go_at_once_however_long_it_paused(void)
{
    use_up();
    pass_us(100U * SECOND_US);
    use_up();
    propose(7);
    TEST_ASSERT_FALSE(goes());
}

void test_SWR_IGTL_044_the_newest_of_a_subject_goes_on_last_and_surely(void)
{
    for (uint32_t i = 0U; i < 1000U; i++) {
        propose((int32_t)i);
        (void)goes();
    }
    TEST_ASSERT_FALSE(goes());
    pass_us(LIMIT_IGTL_PROPOSAL_INTERVAL_US - 1U);
    TEST_ASSERT_FALSE(goes());
    pass_us(1U);
    TEST_ASSERT_TRUE(goes());
    TEST_ASSERT_EQUAL_INT32(999, passed.as.seen_pose.pose.translation.x_nm);
    TEST_ASSERT_FALSE(goes());
}

void test_SWR_IGTL_044_subjects_wait_apart_and_go_in_their_order(void)
{
    use_up();
    put(COMMAND_PROPOSE_TARGET, 0U, 1);
    put(COMMAND_PROPOSE_REGISTRATION, 0U, 2);
    propose(3);
    put(COMMAND_PROPOSE_TARGET, 0U, 4); /* Keeps its place. */
    TEST_ASSERT_FALSE(goes());
    pass_us(SECOND_US);
    expect(COMMAND_PROPOSE_TARGET, 0U);
    TEST_ASSERT_EQUAL_INT32(4, passed.as.seen_pose.pose.translation.x_nm);
    expect(COMMAND_PROPOSE_REGISTRATION, 1U);
    expect(COMMAND_PROPOSE_ENTRY, 1U);
    TEST_ASSERT_FALSE(goes());
}

void test_SWR_IGTL_044_one_in_its_time_is_for_the_log_whatever_its_kind(void)
{
    propose(1);
    expect(COMMAND_PROPOSE_ENTRY, 0U);
    put(COMMAND_PROPOSE_TARGET, 0U, 2);
    expect(COMMAND_PROPOSE_TARGET, 1U);
    pass_us(LIMIT_IGTL_PROPOSAL_NOTE_US - 1U);
    put(COMMAND_PROPOSE_REGISTRATION, 0U, 3);
    expect(COMMAND_PROPOSE_REGISTRATION, 1U);
    pass_us(1U);
    propose(4);
    expect(COMMAND_PROPOSE_ENTRY, 0U);
}

void test_SWR_IGTL_044_a_withdrawal_counts_as_a_proposal(void)
{
    withdraw(COMMAND_PROPOSE_ENTRY);
    expect(COMMAND_WITHDRAW, COMMAND_PROPOSE_ENTRY);
    TEST_ASSERT_EQUAL_UINT32(0U, passed.as.withdrawal.is_one_of_many);
    for (uint32_t i = 1U; i < LIMIT_IGTL_PROPOSAL_BURST; i++) {
        withdraw(COMMAND_PROPOSE_TARGET);
        expect(COMMAND_WITHDRAW, COMMAND_PROPOSE_TARGET);
        TEST_ASSERT_EQUAL_UINT32(1U, passed.as.withdrawal.is_one_of_many);
    }
    withdraw(COMMAND_PROPOSE_TARGET);
    TEST_ASSERT_FALSE(goes());
    pass_us(LIMIT_IGTL_PROPOSAL_NOTE_US);
    expect(COMMAND_WITHDRAW, COMMAND_PROPOSE_TARGET);
    TEST_ASSERT_EQUAL_UINT32(0U, passed.as.withdrawal.is_one_of_many);
}

void test_SWR_IGTL_045_the_newest_wins_between_proposal_and_withdrawal(void)
{
    propose(1);
    withdraw(COMMAND_PROPOSE_ENTRY);
    expect(COMMAND_WITHDRAW, COMMAND_PROPOSE_ENTRY);
    TEST_ASSERT_FALSE(goes());
    withdraw(COMMAND_PROPOSE_ENTRY);
    propose(2);
    expect(COMMAND_PROPOSE_ENTRY, 1U);
    TEST_ASSERT_FALSE(goes());
}

void test_SWR_IGTL_044_one_that_finds_no_way_is_held_and_then_given_up(void)
{
    igtl_requests_init(&requests, 1U, 1U);
    propose(1);
    transform_proposals_pass(&proposals, &requests, PEER, &moment);
    propose(2);
    transform_proposals_pass(&proposals, &requests, PEER, &moment);
    pass_us(LIMIT_IGTL_PROPOSAL_WAIT_US - 1U);
    TEST_ASSERT_NULL(transform_proposals_overdue(&proposals, &moment));
    pass_us(1U);
    TEST_ASSERT_EQUAL_STRING("ENTRY_POINT", transform_proposals_overdue(&proposals, &moment));
    TEST_ASSERT_NULL(transform_proposals_overdue(&proposals, &moment));
    TEST_ASSERT_TRUE(goes());
    TEST_ASSERT_EQUAL_INT32(1, passed.as.seen_pose.pose.translation.x_nm);
    TEST_ASSERT_FALSE(goes());
}

void test_SWR_IGTL_009_nothing_else_is_taken(void)
{
    put(COMMAND_TARGET, 0U, 1);
    put(COMMAND_WORKPHASE, (uint32_t)WORKPHASE_MOVE_TO_TARGET, 1);
    withdraw(COMMAND_ENTRY);
    pass_us(SECOND_US);
    TEST_ASSERT_FALSE(goes());
    const command_t target = {.kind = (uint32_t)COMMAND_TARGET};
    const command_t withdrawal = commands_of_number(COMMAND_WITHDRAW, COMMAND_ENTRY);
    TEST_ASSERT_EQUAL_STRING("", transform_proposals_name(&target));
    TEST_ASSERT_EQUAL_STRING("", transform_proposals_name(&withdrawal));
    TEST_ASSERT_EQUAL_UINT32(COMMAND_NONE, transform_proposals_kind("TARGET"));
}
