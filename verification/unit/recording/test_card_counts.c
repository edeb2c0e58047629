/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: what is discarded, missed and refused between control and a card stands in the
 * log when it changes, not too often, and at the end of the run.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "recording/write/card_counts.h"

#include <string.h>

#define SLOT 7U
#define START_US UINT64_C(5000000)
#define PAUSE_US (LIMIT_CARD_COUNTS_PAUSE_MS * UINT64_C(1000))

static card_counts_t counts;
static snapshot_card_t card;
static char text[CARD_COUNTS_SIZE];

void setUp(void)
{
    (void)memset(&counts, 0, sizeof counts);
    (void)memset(&card, 0, sizeof card);
    text[0] = '\0';
    counts.is_settled = true;
}

void tearDown(void)
{
}

static bool look(uint64_t now_us)
{
    return card_counts_look(&counts, SLOT, &card, now_us, text);
}

void test_SWR_REC_053_a_card_without_trouble_is_not_reported_of(void)
{
    card.heartbeat = 4711U;
    card.uptime_s = 60U;
    TEST_ASSERT_FALSE(look(START_US));
    TEST_ASSERT_FALSE(look(CARD_COUNTS_END));
    TEST_ASSERT_EQUAL_STRING("", text);
}

void test_SWR_REC_053_the_counts_of_both_directions_are_one_line(void)
{
    card.frame_errors = 9U;
    card.frames_out_of_order = 2U;
    card.frames_missed = 5U;
    card.rx_crc_errors = 3U;
    card.sequence_gaps = 4U;
    card.watchdog_trips = 1U;
    TEST_ASSERT_TRUE(look(START_US));
    TEST_ASSERT_EQUAL_STRING("CARD_COUNTS value=7 Frames of card 7: 7 damaged, 2 out of order, 5 "
                             "missed. Commands to it: "
                             "3 damaged, 4 out of order. Its watchdog has tripped 1 times.",
                             text);
}

void test_SWR_REC_053_each_count_alone_is_reported(void)
{
    uint32_t *const numbers[] = {&card.frame_errors,  &card.frames_out_of_order,
                                 &card.frames_missed, &card.rx_crc_errors,
                                 &card.sequence_gaps, &card.watchdog_trips};

    for (uint32_t i = 0U; i < (sizeof numbers / sizeof numbers[0]); i++) {
        *numbers[i] += 1U;
        TEST_ASSERT_TRUE(look(START_US + (i * PAUSE_US)));
        TEST_ASSERT_FALSE(look(CARD_COUNTS_END));
    }
}

void test_SWR_REC_053_between_two_lines_is_a_pause(void)
{
    card.frames_missed = 1U;
    TEST_ASSERT_TRUE(look(START_US));
    card.frames_missed = 2U;
    TEST_ASSERT_FALSE(look((START_US + PAUSE_US) - 1U));
    TEST_ASSERT_TRUE(look(START_US + PAUSE_US));
}

void test_SWR_REC_053_at_the_end_no_pause_counts(void)
{
    card.frames_missed = 1U;
    TEST_ASSERT_TRUE(look(START_US));
    card.frames_missed = 2U;
    TEST_ASSERT_TRUE(look(CARD_COUNTS_END));
}

/* In a run that begins, as a recorder that comes to it sees it. */
static void begin_run(void)
{
    counts.is_settled = false;
    TEST_ASSERT_FALSE(look(START_US));
    card.heartbeat = 4711U;
}

void test_SWR_REC_054_what_a_card_has_counted_up_to_its_first_frames_is_not_reported(void)
{
    begin_run();
    card.rx_crc_errors = 3U;
    card.watchdog_trips = 2U;
    TEST_ASSERT_FALSE(look(START_US));
    card.heartbeat += LIMIT_CARD_COUNTS_SETTLE_FRAMES;
    card.sequence_gaps = 1U;
    TEST_ASSERT_FALSE(look(START_US));
    card.heartbeat += LIMIT_CARD_COUNTS_SETTLE_FRAMES;
    TEST_ASSERT_FALSE(look(CARD_COUNTS_END));
}

void test_SWR_REC_054_what_it_counts_after_them_is_reported_with_the_whole_counts(void)
{
    begin_run();
    card.sequence_gaps = 1U;
    TEST_ASSERT_FALSE(look(START_US));
    card.heartbeat += LIMIT_CARD_COUNTS_SETTLE_FRAMES;
    TEST_ASSERT_FALSE(look(START_US));
    card.sequence_gaps = 2U;
    TEST_ASSERT_TRUE(look(START_US));
    TEST_ASSERT_NOT_NULL(strstr(text, "Commands to it: 0 damaged, 2 out of order."));
}

void test_SWR_REC_054_frames_that_control_discards_count_from_the_first_on(void)
{
    begin_run();
    card.frames_missed = 1U;
    TEST_ASSERT_TRUE(look(START_US));
}
