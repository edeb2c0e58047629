/* SPDX-License-Identifier: Apache-2.0 */
/** @file Rule under test: of all that ask for authority at any time at most one has it. */
#include "safety/authority.h"

#include "unity.h"

#include "charts/authority_chart.h"
#include "limits/requirement_limits.h"

static authority_t authority;
static authority_time_t now;
static const authority_party_t page = {(uint32_t)COMMAND_SOURCE_HTTP, 5U};
static const authority_party_t other_page = {(uint32_t)COMMAND_SOURCE_HTTP, 7U};
static const authority_party_t connection = {(uint32_t)COMMAND_SOURCE_IGTL, 5U};

void setUp(void)
{
    authority_init(&authority);
    now = (authority_time_t){.cycle = 10U, .time_us = UINT32_MAX - 500U};
}

void tearDown(void)
{
}

static bool step(bool is_at_rest, uint32_t elapsed_us)
{
    now.time_us += elapsed_us;
    return authority_step(&authority, is_at_rest, elapsed_us, now);
}

void test_SWR_AUTH_001_who_takes_what_is_free_is_the_only_holder(void)
{
    const authority_party_t nobody = {(uint32_t)COMMAND_SOURCE_HTTP, 0U};
    TEST_ASSERT_FALSE(authority_take(&authority, &nobody, now));
    TEST_ASSERT_TRUE(authority_take(&authority, &page, now));
    TEST_ASSERT_FALSE(authority_take(&authority, &page, now));
    TEST_ASSERT_FALSE(authority_take(&authority, &other_page, now));
    TEST_ASSERT_FALSE(authority_take(&authority, &connection, now));
    TEST_ASSERT_TRUE(authority_is_of(&authority, &page));
    TEST_ASSERT_FALSE(authority_is_of(&authority, &other_page));
    TEST_ASSERT_FALSE(authority_is_of(&authority, &connection));
}

void test_SWR_AUTH_001_what_is_lost_is_nobodys(void)
{
    TEST_ASSERT_EQUAL_HEX32(0U, authority_lose(&authority, now.time_us));
    (void)authority_take(&authority, &page, now);
    TEST_ASSERT_EQUAL_HEX32(AUTHORITY_ACTION_DISCARD_ORDER,
                            authority_lose(&authority, now.time_us));
    TEST_ASSERT_FALSE(authority_is_of(&authority, &page));
    TEST_ASSERT_EQUAL_HEX32(0U, authority_lose(&authority, now.time_us));
    TEST_ASSERT_FALSE(authority_take(&authority, &page, now));
}

void test_SWR_AUTH_006_it_ends_at_rest_or_in_the_end(void)
{
    (void)authority_take(&authority, &page, now);
    (void)authority_lose(&authority, now.time_us);
    TEST_ASSERT_FALSE(step(false, 0U));
    TEST_ASSERT_TRUE(authority_is_ending(&authority));
    TEST_ASSERT_FALSE(step(true, 1U));
    TEST_ASSERT_TRUE(authority_take(&authority, &page, now));
    (void)authority_lose(&authority, now.time_us);
    TEST_ASSERT_FALSE(step(false, LIMIT_AUTHORITY_END_US - 1U));
    TEST_ASSERT_TRUE(authority_is_ending(&authority));
    TEST_ASSERT_FALSE(step(false, 1U));
    TEST_ASSERT_TRUE(authority_is_free(&authority));
}

void test_SWR_AUTH_006_who_was_granted_it_waits_for_that_too(void)
{
    (void)authority_take(&authority, &page, now);
    TEST_ASSERT_TRUE(
        authority_ask(&authority, AUTHORITY_REQUEST_TAKE, 0U, &other_page, now.time_us));
    authority.sealed.request = (uint32_t)AUTHORITY_REQUEST_GRANTED;
    (void)authority_lose(&authority, now.time_us);
    TEST_ASSERT_FALSE(step(false, 1U));
    TEST_ASSERT_FALSE(authority_is_of(&authority, &other_page));
    TEST_ASSERT_EQUAL_UINT32(0U, authority_request_left_us(&authority, now.time_us));
    TEST_ASSERT_TRUE(step(true, 1U));
    TEST_ASSERT_TRUE(authority_is_of(&authority, &other_page));
    TEST_ASSERT_EQUAL_UINT32(0U, authority.sealed.requester.peer);
}

void test_SWR_AUTH_007_a_page_renews_and_a_connection_need_not(void)
{
    (void)authority_take(&authority, &page, now);
    TEST_ASSERT_FALSE(
        authority_is_unrenewed(&authority, now.time_us + LIMIT_AUTHORITY_RENEW_US - 1U));
    TEST_ASSERT_TRUE(authority_is_unrenewed(&authority, now.time_us + LIMIT_AUTHORITY_RENEW_US));
    authority_renew(&authority, now.time_us + 1U);
    TEST_ASSERT_FALSE(authority_is_unrenewed(&authority, now.time_us + LIMIT_AUTHORITY_RENEW_US));
    (void)authority_lose(&authority, now.time_us);
    TEST_ASSERT_FALSE(authority_is_unrenewed(&authority, now.time_us + LIMIT_AUTHORITY_RENEW_US));
    (void)step(true, 1U);
    (void)authority_take(&authority, &connection, now);
    TEST_ASSERT_FALSE(authority_is_unrenewed(&authority, now.time_us + LIMIT_AUTHORITY_RENEW_US));
}

void test_SWR_AUTH_012_one_asks_at_a_time(void)
{
    TEST_ASSERT_TRUE(authority_ask(&authority, AUTHORITY_REQUEST_TAKE, 0U, &page, now.time_us));
    TEST_ASSERT_FALSE(
        authority_ask(&authority, AUTHORITY_REQUEST_TAKE, 0U, &connection, now.time_us));
    TEST_ASSERT_TRUE(authority_is_asked(&authority, AUTHORITY_REQUEST_TAKE, 0U, &page));
    TEST_ASSERT_FALSE(authority_is_asked(&authority, AUTHORITY_REQUEST_CONFIRM, 0U, &page));
    TEST_ASSERT_FALSE(authority_is_asked(&authority, AUTHORITY_REQUEST_TAKE, 1U, &page));
    TEST_ASSERT_FALSE(authority_is_asked(&authority, AUTHORITY_REQUEST_TAKE, 0U, &connection));
    TEST_ASSERT_TRUE(authority_ask(&authority, AUTHORITY_REQUEST_CONFIRM, 0U, &page, now.time_us));
    TEST_ASSERT_EQUAL_UINT32(
        1U, authority_request_left_us(&authority, now.time_us + LIMIT_AUTHORITY_ASK_US - 1U));
    TEST_ASSERT_EQUAL_UINT32(
        0U, authority_request_left_us(&authority, now.time_us + LIMIT_AUTHORITY_ASK_US));
    authority_forget_request(&authority);
    TEST_ASSERT_TRUE(
        authority_ask(&authority, AUTHORITY_REQUEST_TAKE, 0U, &connection, now.time_us));
}

void test_SWR_CORE_004_of_a_damaged_one_nobody_has_it_and_nobody_asks(void)
{
    TEST_ASSERT_FALSE(authority_check(&authority));
    (void)authority_take(&authority, &page, now);
    (void)authority_ask(&authority, AUTHORITY_REQUEST_TAKE, 0U, &other_page, now.time_us);
    authority.chart.state_inverse ^= 1U;
    TEST_ASSERT_TRUE(authority_check(&authority));
    TEST_ASSERT_TRUE(authority_is_free(&authority));
    TEST_ASSERT_FALSE(authority_is_of(&authority, &page));
    TEST_ASSERT_EQUAL_UINT32(0U, authority.sealed.holder.peer);
    TEST_ASSERT_EQUAL_UINT32(0U, authority.sealed.requester.peer);
}
