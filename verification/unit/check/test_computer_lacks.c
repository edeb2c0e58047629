/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: control knows from its start what its computer lacks, says it, and learns of
 * page faults while it runs.
 */
#include "control/computer.h"

#include "unity.h"

#include "exchange/exchange.h"
#include "interface/app/names.h"
#include "limits/requirement_limits.h"
#include "mock_check.h"
#include "mock_realtime.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define KERNEL (1UL << COMPUTER_CHECK_KERNEL)
#define THROTTLING (1UL << COMPUTER_CHECK_THROTTLING)
#define RIGHTS (1UL << COMPUTER_CHECK_RIGHTS)
#define PAGE_FAULTS (1UL << COMPUTER_CHECK_PAGE_FAULTS)
#define GRANTED 5U

static computer_t computer;
static loop_figures_t published;
static uint32_t bad; /* Bits of checks that are not good. */
static uint64_t minor_faults;
static uint64_t major_faults;
static uint32_t reported_rights;
static char said[2048];

static bool judge(const check_facts_t *about, computer_check_t check, char found[CHECK_TEXT_SIZE],
                  int calls)
{
    (void)calls;
    TEST_ASSERT_EQUAL_STRING("/root", about->root);
    TEST_ASSERT_EQUAL_HEX32(GRANTED, about->rights);
    (void)snprintf(found, CHECK_TEXT_SIZE, "Found %u.", (unsigned)check);
    return ((bad >> (uint32_t)check) & 1U) == 0U;
}

static void count_faults(uint64_t *minor, uint64_t *major, int calls)
{
    (void)calls;
    *minor = minor_faults;
    *major = major_faults;
}

static void report_rights(uint32_t rights, int calls)
{
    (void)calls;
    reported_rights = rights;
}

void setUp(void)
{
    (void)memset(&published, 0, sizeof published);
    bad = 0U;
    minor_faults = 1000U; /* Before it began. */
    major_faults = 50U;
    reported_rights = 0U;
    check_is_good_Stub(judge);
    realtime_count_faults_Stub(count_faults);
    realtime_report_Stub(report_rights);
}

void tearDown(void)
{
}

typedef struct {
    int from;
    int kept;
} hearing_t;

/* Output on standard error from now on is heard, */
static hearing_t hear(void)
{
    int ends[2];
    hearing_t hearing = {.kept = dup(STDERR_FILENO)};
    TEST_ASSERT_EQUAL_INT(0, pipe(ends));
    (void)dup2(ends[1], STDERR_FILENO);
    (void)close(ends[1]);
    hearing.from = ends[0];
    return hearing;
}

/* until now: `said` is that. */
static void end(const hearing_t *hearing)
{
    (void)dup2(hearing->kept, STDERR_FILENO);
    (void)close(hearing->kept);
    const ssize_t length = read(hearing->from, said, sizeof said - 1U);
    said[(length > 0) ? length : 0] = '\0';
    (void)close(hearing->from);
}

/* Begins with `wrong`; `said` is what it said. */
static void begin(uint32_t wrong)
{
    const hearing_t hearing = hear();
    bad = wrong;
    computer_begin(&computer, "/root", GRANTED);
    end(&hearing);
}

void test_SWR_LOOP_007_a_fit_computer_lacks_nothing_and_nothing_is_said(void)
{
    begin(0U);
    TEST_ASSERT_EQUAL_HEX32(0U, computer.lacks);
    TEST_ASSERT_EQUAL_STRING("", said);
    TEST_ASSERT_EQUAL_HEX32(GRANTED, reported_rights);
}

void test_SWR_LOOP_007_each_thing_that_it_lacks_is_kept_and_said_by_name(void)
{
    static const char *const names[] = {"KERNEL (Found 0)", "THROTTLING (Found 1)",
                                        "RIGHTS (Found 2)",
                                        "KERNEL (Found 0), THROTTLING (Found 1), RIGHTS (Found 2)"};
    static const uint32_t lacks[] = {KERNEL, THROTTLING, RIGHTS, KERNEL | THROTTLING | RIGHTS};
    for (size_t i = 0U; i < (sizeof names / sizeof names[0]); i++) {
        char line[2U * CHECK_TEXT_SIZE];
        (void)snprintf(line, sizeof line,
                       "control: this computer cannot drive a real robot: %s; boresight --check "
                       "says what to do.\n",
                       names[i]);
        begin((i < 3U) ? lacks[i] : UINT32_MAX);
        TEST_ASSERT_EQUAL_HEX32(lacks[i], computer.lacks);
        TEST_ASSERT_EQUAL_STRING(line, said);
    }
}

void test_SWR_LOOP_008_page_faults_count_from_the_first_cycle_on(void)
{
    begin(0U);
    computer_look(&computer, &published);
    TEST_ASSERT_EQUAL_UINT32(0U, published.minor_faults);
    TEST_ASSERT_EQUAL_UINT32(0U, published.major_faults);
    minor_faults += 7U;
    computer_look(&computer, &published);
    minor_faults += 1U;
    major_faults += 2U;
    computer_look(&computer, &published);
    TEST_ASSERT_EQUAL_UINT32(8U, published.minor_faults);
    TEST_ASSERT_EQUAL_UINT32(2U, published.major_faults);
}

void test_SWR_LOOP_008_a_second_with_page_faults_counts_as_lacking_and_the_next_one_not(void)
{
    begin(KERNEL);
    computer_look(&computer, &published);
    TEST_ASSERT_EQUAL_HEX32(KERNEL, computer.lacks);
    minor_faults += 1U;
    computer_look(&computer, &published);
    TEST_ASSERT_EQUAL_HEX32(KERNEL | PAGE_FAULTS, computer.lacks);
    TEST_ASSERT_EQUAL_HEX32(KERNEL | PAGE_FAULTS, published.computer);
    major_faults += 1U;
    computer_look(&computer, &published);
    TEST_ASSERT_EQUAL_HEX32(KERNEL | PAGE_FAULTS, computer.lacks);
    computer_look(&computer, &published);
    TEST_ASSERT_EQUAL_HEX32(KERNEL, computer.lacks);
    TEST_ASSERT_EQUAL_HEX32(KERNEL, published.computer);
}

static bool judge_wake_up(const check_facts_t *about, computer_check_t check,
                          char found[CHECK_TEXT_SIZE], int calls)
{
    (void)calls;
    TEST_ASSERT_EQUAL(COMPUTER_CHECK_WAKE_UP, check);
    TEST_ASSERT_EQUAL_UINT32(2000U, about->cycles);
    TEST_ASSERT_EQUAL_UINT32(90U, about->wake_p99_us);
    (void)snprintf(found, CHECK_TEXT_SIZE, "Woke up.");
    return about->wake_worst_us < 200U;
}

static void expect_said_of(uint32_t worst_us, const char *sentence)
{
    published = (loop_figures_t){.cycles = 2000U, .wake_p99_us = 90U, .wake_worst_us = worst_us};
    begin(0U);
    check_is_good_Stub(judge_wake_up);
    for (uint32_t i = 1U; i <= (LIMIT_START_LOOK_S + 2U); i++) {
        const hearing_t hearing = hear();
        computer_report_wake_up(&computer, &published);
        end(&hearing);
        TEST_ASSERT_EQUAL_STRING((i == LIMIT_START_LOOK_S) ? sentence : "", said);
    }
    check_is_good_Stub(judge);
}

void test_SWR_LOOP_012_a_punctual_computer_is_expected_to_keep_the_cycle(void)
{
    expect_said_of(199U, "control: Woke up. This computer can be expected to keep 1000 us.\n");
}

void test_SWR_LOOP_012_a_late_computer_is_said_to_stop_now_and_then(void)
{
    expect_said_of(200U, "control: Woke up. This computer cannot be expected to keep 1000 us: "
                         "motion will stop now and then, START_UP goes on; boresight --check says "
                         "what to do.\n");
}

void test_SWR_LOOP_012_elastic_time_needs_none(void)
{
    begin(0U);
    published.is_elastic = 1U;
    for (uint32_t i = 0U; i < (LIMIT_START_LOOK_S + 2U); i++) {
        const hearing_t hearing = hear();
        computer_report_wake_up(&computer, &published);
        end(&hearing);
        TEST_ASSERT_EQUAL_STRING("", said);
    }
}
