/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a card of the dialect aim32 is live while valid frames arrive and lost when they
 * are too old, and only then; numbers that it does not report are counted here.
 */
#include "unity.h"

#include "card/card_frame.h"
#include "card/link.h"
#include "card/link_aim32.h"
#include "charts/card_link_chart.h"
#include "limits/requirement_limits.h"

#include <string.h>

#define SLOT 4U
#define FIRMWARE 0x010200U

static link_t card;
static card_samples_t samples;
static uint8_t bytes[CARD_FRAME_BYTES];

static void put(uint32_t index, uint32_t word)
{
    for (uint32_t i = 0U; i < 4U; i++) {
        bytes[(index * 4U) + i] = (uint8_t)(word >> (24U - (8U * i)));
    }
}

static void report(uint32_t count)
{
    (void)memset(bytes, 0, sizeof bytes);
    put(0U, CARD_FRAME_START);
    put(3U, count);
    put(31U, ~(CARD_FRAME_START + count));
}

/* A cycle with the sample of its frame, or without any. */
static void step(const uint8_t *frame)
{
    samples.sampled_us[SLOT] += 1000U;
    link_aim32_step(&card, SLOT, frame, &samples, 1000U);
}

static void hear(uint32_t count)
{
    report(count);
    step(bytes);
}

static void miss(uint32_t cycles)
{
    for (uint32_t i = 0U; i < cycles; i++) {
        step(NULL);
    }
}

void setUp(void)
{
    link_init(&card, CARD_TYPE_PWM, FIRMWARE);
    hear(10U);
}

void tearDown(void)
{
}

void test_SWR_NI_004_a_valid_frame_makes_the_card_usable(void)
{
    link_init(&card, CARD_TYPE_PWM, FIRMWARE);
    miss(2U * LIMIT_LINK_AGE_CYCLES);
    TEST_ASSERT_FALSE(link_is_usable(&card));
    TEST_ASSERT_EQUAL_UINT32(LINK_CAUSE_NONE, card.sealed.cause);
    hear(10U);
    TEST_ASSERT_TRUE(link_is_usable(&card));
    TEST_ASSERT_TRUE(link_is_healthy_now(&card));
    TEST_ASSERT_EQUAL_UINT32(SLOT, card.report.slot);
    TEST_ASSERT_EQUAL_INT32(10, card.report.encoder_count);
}

void test_SWR_NI_004_without_valid_frames_it_is_lost_at_the_age_limit(void)
{
    miss(LIMIT_LINK_AGE_CYCLES - 1U);
    TEST_ASSERT_TRUE(link_is_usable(&card));
    TEST_ASSERT_EQUAL_UINT32(CARD_LINK_STATE_LATE, card.chart.state);
    miss(1U);
    TEST_ASSERT_FALSE(link_is_usable(&card));
    TEST_ASSERT_EQUAL_UINT32(LINK_CAUSE_AGE, card.sealed.cause);
    hear(10U);
    TEST_ASSERT_FALSE(link_is_usable(&card));
    link_reset(&card);
    TEST_ASSERT_TRUE(link_is_usable(&card));
}

void test_SWR_LINK_040_a_cycle_without_a_frame_is_counted(void)
{
    miss(2U);
    TEST_ASSERT_EQUAL_UINT32(2U, card.frames_missed);
    TEST_ASSERT_EQUAL_UINT32(0U, card.sealed.frame_errors);
}

void test_SWR_NI_004_a_refused_frame_is_counted_and_is_none(void)
{
    report(11U);
    bytes[4] ^= 1U;
    step(bytes);
    TEST_ASSERT_EQUAL_UINT32(CARD_FRAME_BAD_CRC, card.last_error);
    TEST_ASSERT_EQUAL_UINT32(1U, card.sealed.frame_errors);
    TEST_ASSERT_EQUAL_UINT32(1U, card.sealed.age_cycles);
    TEST_ASSERT_EQUAL_INT32(10, card.report.encoder_count);
    TEST_ASSERT_FALSE(link_is_healthy_now(&card));
    card.sealed.frame_errors = UINT32_MAX;
    card.sealed.age_cycles = UINT32_MAX;
    step(bytes);
    TEST_ASSERT_EQUAL_UINT32(UINT32_MAX, card.sealed.frame_errors);
    TEST_ASSERT_EQUAL_UINT32(UINT32_MAX, card.sealed.age_cycles);
    hear(12U);
    TEST_ASSERT_EQUAL_UINT32(CARD_FRAME_OK, card.last_error);
    TEST_ASSERT_EQUAL_UINT32(0U, card.sealed.age_cycles);
}

void test_SWR_NI_004_a_card_that_says_the_same_again_and_does_not_echo_stays_live(void)
{
    const card_drive_t on = {.mode = CARD_DRIVE_PWM, .direction = 1U, .duty = 100U};
    for (uint32_t i = 0U; i < 100U; i++) {
        link_note_sent(&card, i, &on);
        hear(10U);
        TEST_ASSERT_TRUE(link_is_healthy_now(&card));
    }
}

void test_SWR_NI_004_heartbeat_time_and_edges_are_counted_by_the_cycle(void)
{
    const uint32_t heartbeat = card.report.heartbeat;
    hear(10U);
    TEST_ASSERT_EQUAL_UINT32(heartbeat + 1U, card.report.heartbeat);
    TEST_ASSERT_EQUAL_UINT32(2000U, card.report.time_us);
    TEST_ASSERT_EQUAL_UINT32(1000U, card.report.last_edge_us);
    miss(1U);
    hear(11U);
    TEST_ASSERT_EQUAL_UINT32(4000U, card.report.time_us);
    TEST_ASSERT_EQUAL_UINT32(4000U, card.report.last_edge_us);
    hear(11U);
    TEST_ASSERT_EQUAL_UINT32(4000U, card.report.last_edge_us);
}

void test_SWR_NI_004_the_time_of_its_reports_is_that_of_the_board(void)
{
    hear(10U);
    TEST_ASSERT_EQUAL_UINT32(1000U, card.reported_us);
    samples.sampled_us[SLOT] += 250U;
    hear(10U);
    TEST_ASSERT_EQUAL_UINT32(1250U, card.reported_us);
    TEST_ASSERT_EQUAL_UINT32(0U, card.is_timed);
    miss(2U);
    TEST_ASSERT_EQUAL_UINT32(0U, card.reported_us);
    hear(10U);
    TEST_ASSERT_EQUAL_UINT32(3000U, card.reported_us);
}

void test_SWR_NI_004_it_is_believed_to_apply_what_was_sent(void)
{
    const card_drive_t on = {.mode = CARD_DRIVE_PWM, .direction = 1U, .duty = 100U};
    link_note_sent(&card, 1U, &on);
    link_note_sent(&card, 2U, &on);
    hear(10U);
    TEST_ASSERT_EQUAL_UINT32(100U, link_applied(&card)->duty);
}
