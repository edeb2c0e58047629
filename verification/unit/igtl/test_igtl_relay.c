/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: a stop that the controller's lane does not take yet waits, and nothing that was
 * commanded after it goes ahead of it.
 */
#include "unity.h"

#include "igtl/dialect/igtl_requests.h"
#include "exchange/exchange.h"
#include "igtl/server/igtl_relay.h"

#include <stdio.h>
#include <unistd.h>

#define LANE (EXCHANGE_COMMANDS + EXCHANGE_STOPS)

static exchange_t *control;
static exchange_t *process;
static igtl_requests_t requests;
static command_t taken[LANE];
static answer_t refusal;
static uint32_t refused;

static bool hand_in(const answer_t *answer)
{
    refusal = *answer;
    refused++;
    return true;
}

static void ask(uint32_t peer, workphase_t phase)
{
    command_t command = {.kind = (uint32_t)COMMAND_WORKPHASE,
                         .as.workphase = {.workphase = (uint32_t)phase}};

    TEST_ASSERT_NOT_NULL(igtl_requests_add(&requests, peer, &command, 0U));
}

static void relay(void)
{
    igtl_relay_requests(process, &requests, (uint32_t)WORKPHASE_PLANNING, hand_in);
}

static void fill_with(uint32_t count, workphase_t phase)
{
    const command_t command = {.kind = (uint32_t)COMMAND_WORKPHASE,
                               .as.workphase = {.workphase = (uint32_t)phase}};

    for (uint32_t i = 0U; i < count; i++) {
        TEST_ASSERT_EQUAL_INT(STATUS_OK, exchange_send_command(process, &command));
    }
}

void setUp(void)
{
    char name[32];
    char error[256];

    (void)snprintf(name, sizeof name, "test-relay-%d", (int)getpid());
    control = exchange_create(name, 64U, error, sizeof error);
    TEST_ASSERT_NOT_NULL_MESSAGE(control, error);
    process = exchange_open(name, error, sizeof error);
    TEST_ASSERT_NOT_NULL_MESSAGE(process, error);
    igtl_requests_init(&requests, 2U, IGTL_REQUESTS_COMMON);
    refused = 0U;
}

void tearDown(void)
{
    exchange_close(process);
    exchange_close(control);
}

void test_SWR_IGTL_047_commands_are_passed_on_in_their_order(void)
{
    ask(0U, WORKPHASE_PLANNING);
    ask(0U, WORKPHASE_MANUAL);
    TEST_ASSERT_TRUE(igtl_relay_awaits_answer(&requests));
    relay();
    TEST_ASSERT_EQUAL_UINT32(2U, exchange_take_commands(control, taken, LANE));
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_PLANNING, taken[0].as.workphase.workphase);
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_MANUAL, taken[1].as.workphase.workphase);
    TEST_ASSERT_EQUAL_UINT32(0U, refused);
}

void test_SWR_IGTL_047_what_finds_no_room_is_refused_and_a_stop_finds_it_still(void)
{
    fill_with(EXCHANGE_COMMANDS, WORKPHASE_PLANNING);
    ask(0U, WORKPHASE_MANUAL);
    ask(0U, WORKPHASE_EMERGENCY);
    relay();
    TEST_ASSERT_EQUAL_UINT32(1U, refused);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_REFUSED, refusal.kind);
    TEST_ASSERT_EQUAL_UINT32(STATUS_BUSY, refusal.status);
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_MANUAL, refusal.asked);
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_PLANNING, refusal.workphase);
    TEST_ASSERT_EQUAL_UINT32(1U, refusal.is_final);
    TEST_ASSERT_EQUAL_UINT32(0U, requests.queued);
}

void test_SWR_IGTL_047_nothing_overtakes_a_stop_that_waits(void)
{
    fill_with(LANE, WORKPHASE_STOP);
    ask(0U, WORKPHASE_STOP);
    relay();
    TEST_ASSERT_EQUAL_UINT32(1U, requests.queued);
    TEST_ASSERT_EQUAL_UINT32(0U, refused);
    ask(0U, WORKPHASE_MANUAL);
    relay();
    TEST_ASSERT_EQUAL_UINT32(1U, requests.queued);
    TEST_ASSERT_EQUAL_UINT32(1U, refused);
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_MANUAL, refusal.asked);
    (void)exchange_take_commands(control, taken, LANE);
    relay();
    TEST_ASSERT_EQUAL_UINT32(0U, requests.queued);
    TEST_ASSERT_EQUAL_UINT32(1U, exchange_take_commands(control, taken, LANE));
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_STOP, taken[0].as.workphase.workphase);
}
