/* SPDX-License-Identifier: Apache-2.0 */
/** @file Rule under test: control hears which of the processes that command do not live any more.
 */
#include "control/sources.h"

#include "unity.h"

#include "limits/requirement_limits.h"

#include <string.h>

#define IGTL ((uint32_t)1U << (uint32_t)COMMAND_SOURCE_IGTL)
#define HTTP ((uint32_t)1U << (uint32_t)COMMAND_SOURCE_HTTP)
#define CYCLES (LIMIT_AUTHORITY_SILENT_US / LIMIT_CYCLE_US)

static sources_t sources;
static uint32_t beats[COMMAND_SOURCE_COUNT];

void setUp(void)
{
    (void)memset(&sources, 0, sizeof sources);
    (void)memset(beats, 0, sizeof beats);
}

void tearDown(void)
{
}

/* In each of which `living` beat. @return what the last one said */
static uint32_t listen(uint32_t count, uint32_t living)
{
    uint32_t silent = 0U;
    for (uint32_t cycle = 0U; cycle < count; cycle++) {
        for (uint32_t i = 0U; i < COMMAND_SOURCE_COUNT; i++) {
            beats[i] += (living >> i) & 1U;
        }
        silent = sources_listen(&sources, beats, LIMIT_CYCLE_US);
    }
    return silent;
}

void test_SWR_AUTH_015_who_lives_is_not_silent(void)
{
    TEST_ASSERT_EQUAL_UINT32(0U, listen(3U * CYCLES, IGTL | HTTP));
}

void test_SWR_AUTH_015_each_is_silent_by_itself_and_from_the_limit_on(void)
{
    TEST_ASSERT_EQUAL_UINT32(0U, listen(1U, IGTL | HTTP));
    TEST_ASSERT_EQUAL_UINT32(0U, listen(CYCLES - 1U, HTTP));
    TEST_ASSERT_EQUAL_UINT32(IGTL, listen(1U, HTTP));
    TEST_ASSERT_EQUAL_UINT32(IGTL, listen(1U, HTTP));
    TEST_ASSERT_EQUAL_UINT32(IGTL, listen(CYCLES - 1U, 0U));
    TEST_ASSERT_EQUAL_UINT32(IGTL | HTTP, listen(1U, 0U));
}

void test_SWR_AUTH_015_who_was_never_heard_is_silent(void)
{
    TEST_ASSERT_EQUAL_UINT32(0U, listen(CYCLES - 1U, 0U));
    TEST_ASSERT_EQUAL_UINT32(IGTL | HTTP, listen(1U, 0U));
}

void test_SWR_AUTH_015_a_beat_ends_the_silence_at_once(void)
{
    (void)listen(2U * CYCLES, 0U);
    TEST_ASSERT_EQUAL_UINT32(HTTP, listen(1U, IGTL));
    TEST_ASSERT_EQUAL_UINT32(HTTP, listen(CYCLES - 1U, 0U));
    TEST_ASSERT_EQUAL_UINT32(IGTL | HTTP, listen(1U, 0U));
}

void test_SWR_AUTH_015_a_cycle_that_is_late_says_little_of_the_others(void)
{
    (void)listen(1U, IGTL | HTTP);
    TEST_ASSERT_EQUAL_UINT32(0U, sources_listen(&sources, beats, UINT32_MAX));
    TEST_ASSERT_EQUAL_UINT32(LIMIT_OVERRUN_US, sources.silent_us[COMMAND_SOURCE_HTTP]);
}
