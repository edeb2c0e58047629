/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: the whole check measures for itself, and says of every check what it has found,
 * with what to do where that is not good.
 */
#include "check/checkup.h"

#include "unity.h"

#include "exchange/exchange.h"
#include "interface/app/names.h"
#include "limits/requirement_limits.h"
#include "mock_check.h"
#include "mock_realtime.h"

#include <string.h>

#define TEXT_SIZE 8192U

static check_facts_t facts;
static char text[TEXT_SIZE];
static uint64_t now_ns;
static uint32_t bad; /* Bit n: check n is not good. */

/* Each wake-up is as late as its number, in microseconds; the deadlines lie far back. */
static uint64_t give_now(int calls)
{
    return now_ns + ((uint64_t)calls * 1001000U);
}

static void count_faults(uint64_t *minor, uint64_t *major, int calls)
{
    *minor = (calls == 0) ? 100U : 107U;
    *major = (calls == 0) ? 10U : 12U;
}

static uint32_t acquire(int calls)
{
    (void)calls;
    return EXCHANGE_RIGHT_FIFO;
}

static uint32_t report_core(uint32_t *cores, int calls)
{
    (void)calls;
    *cores = 4U;
    return 3U;
}

static bool judge(const check_facts_t *about, computer_check_t check, char found[CHECK_TEXT_SIZE],
                  int calls)
{
    (void)calls;
    TEST_ASSERT_EQUAL_PTR(&facts, about);
    (void)snprintf(found, CHECK_TEXT_SIZE, "Found %u.", (unsigned)check);
    return ((bad >> (uint32_t)check) & 1U) == 0U;
}

static void count_interrupts(const char *root, uint32_t core, uint64_t counts[CHECK_INTERRUPTS],
                             int calls)
{
    (void)calls;
    TEST_ASSERT_EQUAL_STRING("/root", root);
    TEST_ASSERT_EQUAL_UINT32(3U, core);
    counts[5] = 55U;
}

static bool stay_awake(const char *root, int calls)
{
    (void)calls;
    TEST_ASSERT_EQUAL_STRING("/root", root);
    return true;
}

void setUp(void)
{
    facts = (check_facts_t){.root = "/root"};
    bad = 0U;
    check_is_good_Stub(judge);
    check_count_interrupts_Stub(count_interrupts);
    now_ns = 0U;
    realtime_now_ns_Stub(give_now);
    realtime_acquire_Stub(acquire);
    realtime_core_Stub(report_core);
    realtime_stay_awake_Stub(stay_awake);
    realtime_count_faults_Stub(count_faults);
}

void tearDown(void)
{
}

void test_SWR_CHECK_003_what_was_measured_is_that_of_the_loops_core_and_rights(void)
{
    checkup_measure(&facts, 200U);
    TEST_ASSERT_EQUAL_UINT32(3U, facts.core);
    TEST_ASSERT_EQUAL_UINT32(4U, facts.cores);
    TEST_ASSERT_EQUAL_HEX32(EXCHANGE_RIGHT_FIFO, facts.rights);
    TEST_ASSERT_EQUAL_UINT32(200U, facts.cycles);
    TEST_ASSERT_EQUAL_UINT32(200U, facts.wake_worst_us);
    TEST_ASSERT_EQUAL_UINT32(198U, facts.wake_p99_us);
    TEST_ASSERT_EQUAL_UINT64(7U, facts.minor_faults);
    TEST_ASSERT_EQUAL_UINT64(2U, facts.major_faults);
    TEST_ASSERT_NOT_EQUAL(0U, facts.clock_ns);
    TEST_ASSERT_EQUAL_UINT64(55U, facts.interrupts[5]);
}

void test_SWR_CHECK_003_what_is_longer_than_all_is_not_lost(void)
{
    checkup_measure(&facts, 6000U);
    TEST_ASSERT_EQUAL_UINT32(6000U, facts.wake_worst_us);
    TEST_ASSERT_EQUAL_UINT32(4095U, facts.wake_p99_us);
}

void test_SWR_CHECK_007_a_real_boards_computer_is_kept_awake_while_it_is_measured(void)
{
    checkup_measure(&facts, 1U);
    TEST_ASSERT_TRUE(facts.is_awake);
    facts.is_simulated = true;
    checkup_measure(&facts, 1U);
    TEST_ASSERT_FALSE(facts.is_awake);
}

static int report(void)
{
    FILE *const out = fmemopen(text, sizeof text, "w");
    TEST_ASSERT_NOT_NULL(out);
    const int code = checkup_report(&facts, out);
    (void)fclose(out);
    return code;
}

static void expect_line(const char *mark, computer_check_t check, bool says_what_to_do)
{
    char line[CHECK_TEXT_SIZE];
    (void)snprintf(line, sizeof line, "%s  %-12s Found %u.\n", mark,
                   computer_check_name((int32_t)check), (unsigned)check);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(text, line), text);
    TEST_ASSERT_EQUAL_MESSAGE(says_what_to_do,
                              strstr(text, computer_check_text((int32_t)check)) != NULL, line);
}

void test_SWR_CHECK_001_all_are_good_and_it_ends_with_0(void)
{
    TEST_ASSERT_EQUAL_INT(0, report());
    for (uint32_t i = 0U; i < COMPUTER_CHECK_COUNT; i++) {
        expect_line("ok", (computer_check_t)i, false);
    }
    TEST_ASSERT_NOT_NULL(strstr(text, "\n15 of 15 are good.\n"));
}

void test_SWR_CHECK_001_each_that_is_not_good_says_what_to_do_and_it_ends_with_1(void)
{
    for (uint32_t i = 0U; i < COMPUTER_CHECK_COUNT; i++) {
        const bool blocks = i <= (uint32_t)COMPUTER_CHECK_PAGE_FAULTS;
        bad = 1UL << i;
        TEST_ASSERT_EQUAL_INT(1, report());
        for (uint32_t k = 0U; k < COMPUTER_CHECK_COUNT; k++) {
            const char *const mark = blocks ? "!!" : "no";
            expect_line((k == i) ? mark : "ok", (computer_check_t)k, k == i);
        }
        TEST_ASSERT_NOT_NULL(strstr(
            text, blocks ? "\n14 of 15 are good; 1 (!!) keep a real robot from being enabled.\n"
                         : "\n14 of 15 are good.\n"));
    }
}
