/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: what failed tries have moved an axis is added up in both directions, from its
 * reference on, and held against a length or an angle.
 */
#include "controller/homing_account.h"

#include "robot/robot_neuro.h"
#include "unity.h"

#define HEAD ((uint32_t)NEURO_AXIS_HEAD)   /* 78.74 ticks per mm */
#define PITCH ((uint32_t)NEURO_AXIS_PITCH) /* 13.9 ticks per degree */

static homing_account_t account;
static axis_t axes[ROBOT_AXIS_MAX];

void setUp(void)
{
    homing_account_init(&account);
    for (uint32_t i = 0U; i < ROBOT_AXIS_MAX; i++) {
        axis_init(&axes[i]);
    }
}

void tearDown(void)
{
}

static void fail_after(uint32_t index, int32_t counts)
{
    homing_account_begin(&account, &robot_neuro, axes);
    axes[index].sealed.encoder.reading += counts;
    homing_account_charge(&account, &robot_neuro, axes, ROBOT_AXIS_MAX);
}

static bool is_beyond(void)
{
    return homing_account_is_beyond(&account, &robot_neuro);
}

static void home(uint32_t index)
{
    axes[index].chart.reference = AXIS_REFERENCE_VERIFIED;
}

void test_SWR_NEXT_024_ways_forth_and_back_add_up_to_half_a_millimetre(void)
{
    fail_after(HEAD, 20);
    fail_after(HEAD, -19);
    TEST_ASSERT_EQUAL_INT32(39, account.ways_ticks[HEAD]);
    TEST_ASSERT_FALSE(is_beyond());
    fail_after(HEAD, 1);
    TEST_ASSERT_TRUE(is_beyond());
}

void test_SWR_NEXT_024_or_to_half_a_degree(void)
{
    fail_after(PITCH, 6);
    TEST_ASSERT_FALSE(is_beyond());
    fail_after(PITCH, -1);
    TEST_ASSERT_TRUE(is_beyond());
}

void test_SWR_NEXT_024_an_axis_that_homes_in_the_try_begins_anew(void)
{
    fail_after(HEAD, 100);
    homing_account_begin(&account, &robot_neuro, axes);
    axes[HEAD].sealed.encoder.reading += 100;
    home(HEAD);
    homing_account_charge(&account, &robot_neuro, axes, ROBOT_AXIS_MAX);
    TEST_ASSERT_EQUAL_INT32(0, account.ways_ticks[HEAD]);
}

/* Its encoder may stand while it moves. */
void test_SWR_NEXT_024_the_axis_that_fails_is_charged_with_what_it_may_have_moved_unseen(void)
{
    const int32_t unseen = robot_neuro.axes[HEAD].following_error_ticks;
    homing_account_begin(&account, &robot_neuro, axes);
    homing_account_charge(&account, &robot_neuro, axes, HEAD);
    TEST_ASSERT_EQUAL_INT32(unseen, account.ways_ticks[HEAD]);
    axes[HEAD].sealed.encoder.reading += unseen + 1;
    homing_account_charge(&account, &robot_neuro, axes, HEAD);
    TEST_ASSERT_EQUAL_INT32(unseen + unseen + 1, account.ways_ticks[HEAD]);
    TEST_ASSERT_EQUAL_INT32(0, account.ways_ticks[PITCH]);
}

void test_SWR_NEXT_024_one_that_was_homed_before_is_charged(void)
{
    home(HEAD);
    fail_after(HEAD, 40);
    TEST_ASSERT_TRUE(is_beyond());
}
