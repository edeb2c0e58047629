/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: only fresh and whole frames keep a card usable, and date its reports; a card
 * that is silent is lost, and stays lost until a reset in a cycle with a good frame.
 */
#include "unity.h"

#include "card/card_frame.h"
#include "card/link.h"
#include "charts/card_link_chart.h"
#include "limits/requirement_limits.h"
#include "unit/support/link_world.inc"

/* The frame in `bytes` is refused as `result`, and nothing but the count has changed. */
static void expect_discarded(card_frame_result_t result)
{
    const card_report_t before = card.report;
    const uint32_t errors = card.sealed.frame_errors;

    link_step(&card, SLOT, bytes, &samples, elapsed_us);
    TEST_ASSERT_EQUAL_UINT32(result, card.last_error);
    TEST_ASSERT_EQUAL_UINT32(errors + 1U, card.sealed.frame_errors);
    TEST_ASSERT_EQUAL_UINT32(0U, card.is_fresh);
    TEST_ASSERT_EQUAL_MEMORY(&before, &card.report, sizeof before);
    TEST_ASSERT_FALSE(link_is_healthy_now(&card));
}

void setUp(void)
{
    begin_link();
}

void tearDown(void)
{
}

void test_SWR_LINK_001_a_card_is_not_usable_before_its_first_frame(void)
{
    link_init(&card, CARD_TYPE_PWM, FIRMWARE);
    TEST_ASSERT_FALSE(link_is_usable(&card));
    repeat(silent_cycle, 2U * LIMIT_LINK_AGE_CYCLES);
    TEST_ASSERT_FALSE(link_is_usable(&card));
    TEST_ASSERT_EQUAL_UINT32(LINK_CAUSE_NONE, card.sealed.cause);
    good_cycle();
    TEST_ASSERT_TRUE(link_is_usable(&card));
}

void test_SWR_LINK_001_a_card_silent_for_one_cycle_less_than_the_limit_is_usable(void)
{
    repeat(silent_cycle, LIMIT_LINK_AGE_CYCLES - 1U);
    TEST_ASSERT_TRUE(link_is_usable(&card));
    TEST_ASSERT_EQUAL_UINT32(CARD_LINK_STATE_LATE, card.chart.state);
    TEST_ASSERT_EQUAL_UINT32(LINK_CAUSE_NONE, card.sealed.cause);
}

void test_SWR_LINK_001_a_card_silent_up_to_the_limit_is_lost_in_that_cycle(void)
{
    repeat(silent_cycle, LIMIT_LINK_AGE_CYCLES);
    TEST_ASSERT_FALSE(link_is_usable(&card));
    TEST_ASSERT_EQUAL_UINT32(LINK_CAUSE_AGE, card.sealed.cause);
}

void test_SWR_LINK_001_a_good_frame_begins_the_count_anew(void)
{
    for (uint32_t i = 0U; i < 10U; i++) {
        repeat(silent_cycle, LIMIT_LINK_AGE_CYCLES - 1U);
        good_cycle();
        TEST_ASSERT_TRUE(link_is_usable(&card));
        TEST_ASSERT_EQUAL_UINT32(CARD_LINK_STATE_LIVE, card.chart.state);
        TEST_ASSERT_EQUAL_UINT32(0U, card.sealed.age_cycles);
    }
}

void test_SWR_LINK_001_discarded_frames_count_as_silence(void)
{
    for (uint32_t i = 0U; i < LIMIT_LINK_AGE_CYCLES; i++) {
        TEST_ASSERT_TRUE(link_is_usable(&card));
        make_report();
        card_frame_encode_report(&report, bytes);
        bytes[100] ^= 1U;
        link_step(&card, SLOT, bytes, &samples, elapsed_us);
    }
    TEST_ASSERT_FALSE(link_is_usable(&card));
}

void test_SWR_LINK_001_the_age_saturates(void)
{
    card.sealed.age_cycles = UINT32_MAX - 1U;
    silent_cycle();
    TEST_ASSERT_EQUAL_UINT32(UINT32_MAX, card.sealed.age_cycles);
    silent_cycle();
    TEST_ASSERT_EQUAL_UINT32(UINT32_MAX, card.sealed.age_cycles);
}

void test_SWR_LINK_002_a_good_frame_brings_its_data(void)
{
    report.encoder_count = -815;
    good_cycle();
    TEST_ASSERT_EQUAL_INT32(-815, card.report.encoder_count);
    TEST_ASSERT_EQUAL_UINT32(1U, card.is_fresh);
    TEST_ASSERT_EQUAL_UINT32(CARD_FRAME_OK, card.last_error);
    TEST_ASSERT_EQUAL_UINT32(0U, card.sealed.frame_errors);
    TEST_ASSERT_TRUE(link_is_healthy_now(&card));
}

void test_SWR_LINK_002_the_first_frame_is_no_repetition_whatever_its_heartbeat(void)
{
    link_init(&card, CARD_TYPE_PWM, FIRMWARE);
    report.heartbeat = UINT32_MAX;
    good_cycle();
    TEST_ASSERT_EQUAL_UINT32(0U, card.report.heartbeat);
    TEST_ASSERT_EQUAL_UINT32(1U, card.is_fresh);
    TEST_ASSERT_EQUAL_UINT32(0U, card.sealed.frame_errors);
}

void test_SWR_LINK_002_a_wrong_start_word_is_discarded(void)
{
    make_report();
    card_frame_encode_report(&report, bytes);
    bytes[0] ^= 0x80U;
    expect_discarded(CARD_FRAME_BAD_START);
}

void test_SWR_LINK_002_a_wrong_crc_is_discarded(void)
{
    make_report();
    report.encoder_count = 1;
    card_frame_encode_report(&report, bytes);
    bytes[CARD_FRAME_BYTES - 1U] ^= 1U;
    expect_discarded(CARD_FRAME_BAD_CRC);
}

void test_SWR_LINK_002_a_frame_of_another_slot_is_discarded(void)
{
    make_report();
    report.slot = SLOT + 1U;
    card_frame_encode_report(&report, bytes);
    expect_discarded(CARD_FRAME_BAD_SLOT);
}

void test_SWR_LINK_002_a_repeated_frame_is_discarded(void)
{
    report.encoder_count = 1;
    card_frame_encode_report(&report, bytes);
    expect_discarded(CARD_FRAME_REPEATED);
}

void test_SWR_LINK_002_a_damaged_first_frame_is_discarded(void)
{
    link_init(&card, CARD_TYPE_PWM, FIRMWARE);
    bytes[0] ^= 0x80U;
    expect_discarded(CARD_FRAME_BAD_START);
    TEST_ASSERT_FALSE(link_is_usable(&card));
}

void test_SWR_LINK_002_a_missing_frame_is_not_counted_as_a_bad_one(void)
{
    silent_cycle();
    TEST_ASSERT_EQUAL_UINT32(0U, card.sealed.frame_errors);
    TEST_ASSERT_EQUAL_UINT32(0U, card.is_fresh);
    TEST_ASSERT_EQUAL_INT32(4711, card.report.encoder_count);
}

void test_SWR_LINK_002_the_count_of_bad_frames_saturates(void)
{
    card.sealed.frame_errors = UINT32_MAX - 1U;
    receive();
    TEST_ASSERT_EQUAL_UINT32(UINT32_MAX, card.sealed.frame_errors);
    receive();
    TEST_ASSERT_EQUAL_UINT32(UINT32_MAX, card.sealed.frame_errors);
}

void test_SWR_LINK_040_what_is_damaged_and_what_is_out_of_order_are_counted_apart(void)
{
    make_report();
    bytes[20] ^= 1U;
    expect_discarded(CARD_FRAME_BAD_CRC);
    TEST_ASSERT_EQUAL_UINT32(0U, card.frames_out_of_order);
    good_cycle();
    expect_discarded(CARD_FRAME_REPEATED);
    TEST_ASSERT_EQUAL_UINT32(1U, card.frames_out_of_order);
    TEST_ASSERT_EQUAL_UINT32(2U, card.sealed.frame_errors);
    TEST_ASSERT_EQUAL_UINT32(0U, card.frames_missed);
    card.frames_out_of_order = UINT32_MAX;
    receive();
    TEST_ASSERT_EQUAL_UINT32(UINT32_MAX, card.frames_out_of_order);
}

void test_SWR_LINK_040_cycles_without_a_frame_are_counted_while_the_card_is_used(void)
{
    repeat(silent_cycle, 2U);
    TEST_ASSERT_EQUAL_UINT32(2U, card.frames_missed);
    TEST_ASSERT_EQUAL_UINT32(0U, card.sealed.frame_errors);
    good_cycle();
    lose_by_silence();
    repeat(silent_cycle, 10U);
    TEST_ASSERT_EQUAL_UINT32(2U + LIMIT_LINK_AGE_CYCLES, card.frames_missed);
    link_init(&card, CARD_TYPE_PWM, FIRMWARE);
    silent_cycle();
    TEST_ASSERT_EQUAL_UINT32(0U, card.frames_missed);
    good_cycle();
    card.frames_missed = UINT32_MAX;
    silent_cycle();
    TEST_ASSERT_EQUAL_UINT32(UINT32_MAX, card.frames_missed);
}

void test_SWR_LINK_003_good_frames_do_not_bring_a_lost_card_back(void)
{
    lose_by_silence();
    for (uint32_t i = 0U; i < 100U; i++) {
        good_cycle();
        TEST_ASSERT_FALSE(link_is_usable(&card));
    }
}

void test_SWR_LINK_003_a_reset_in_a_cycle_with_a_good_frame_brings_the_card_back(void)
{
    lose_by_silence();
    good_cycle();
    link_reset(&card);
    TEST_ASSERT_TRUE(link_is_usable(&card));
    repeat(silent_cycle, LIMIT_LINK_AGE_CYCLES - 1U);
    TEST_ASSERT_TRUE(link_is_usable(&card));
    silent_cycle();
    TEST_ASSERT_FALSE(link_is_usable(&card));
}

void test_SWR_LINK_003_a_reset_in_a_cycle_without_a_frame_changes_nothing(void)
{
    lose_by_silence();
    good_cycle();
    silent_cycle();
    link_reset(&card);
    TEST_ASSERT_FALSE(link_is_usable(&card));
}

void test_SWR_LINK_003_a_reset_while_the_card_has_a_fault_changes_nothing(void)
{
    lose_by_silence();
    report.status = CARD_STATUS_HOT;
    good_cycle();
    link_reset(&card);
    TEST_ASSERT_FALSE(link_is_usable(&card));
}

void test_SWR_LINK_003_the_cause_of_a_loss_is_the_first_one(void)
{
    lose_by_silence();
    report.status = CARD_STATUS_HOT;
    good_cycle();
    TEST_ASSERT_EQUAL_UINT32(LINK_CAUSE_AGE, card.sealed.cause);
}

void test_SWR_LINK_004_an_unchanged_heartbeat_below_the_limit_is_tolerated(void)
{
    repeat(receive, LIMIT_LINK_AGE_CYCLES - 1U);
    TEST_ASSERT_TRUE(link_is_usable(&card));
}

void test_SWR_LINK_004_an_unchanged_heartbeat_up_to_the_limit_is_a_lost_card(void)
{
    repeat(receive, LIMIT_LINK_AGE_CYCLES);
    TEST_ASSERT_FALSE(link_is_usable(&card));
    TEST_ASSERT_EQUAL_UINT32(LINK_CAUSE_AGE, card.sealed.cause);
}

static void receive_with_heartbeat(uint32_t heartbeat)
{
    report.heartbeat = heartbeat;
    card_frame_encode_report(&report, bytes);
}

void test_SWR_LINK_007_a_report_from_before_or_far_ahead_is_discarded(void)
{
    static const uint32_t steps[] = {0U, UINT32_MAX, LIMIT_SEQUENCE_WINDOW + 1U, 0x80000000U};
    const uint32_t last = report.heartbeat;

    for (uint32_t i = 0U; i < 4U; i++) {
        receive_with_heartbeat(last + steps[i]);
        expect_discarded(CARD_FRAME_REPEATED);
    }
    receive_with_heartbeat(last + LIMIT_SEQUENCE_WINDOW);
    link_step(&card, SLOT, bytes, &samples, elapsed_us);
    TEST_ASSERT_EQUAL_UINT32(1U, card.is_fresh);
}

void test_SWR_LINK_007_the_heartbeat_wraps(void)
{
    link_init(&card, CARD_TYPE_PWM, FIRMWARE);
    report.heartbeat = UINT32_MAX - 1U;
    repeat(good_cycle, 4U);
    TEST_ASSERT_EQUAL_UINT32(2U, report.heartbeat);
    TEST_ASSERT_EQUAL_UINT32(0U, card.sealed.frame_errors);
}

void test_SWR_LINK_007_a_lost_card_may_have_begun_to_count_anew(void)
{
    lose_by_silence();
    make_report();
    receive_with_heartbeat(1U);
    link_step(&card, SLOT, bytes, &samples, elapsed_us);
    TEST_ASSERT_EQUAL_UINT32(1U, card.is_fresh);
    link_reset(&card);
    TEST_ASSERT_TRUE(link_is_usable(&card));
}

/* The next report is sampled so much later by the board, and by the card. */
static void sample(uint32_t board_us, uint32_t card_us)
{
    samples.sampled_us[SLOT] += board_us;
    report.time_us += card_us;
    good_cycle();
}

void test_SWR_LINK_012_the_time_of_a_report_is_that_of_the_card(void)
{
    repeat(good_cycle, 3U);
    sample(1000U, 1000U);
    TEST_ASSERT_EQUAL_UINT32(1000U, card.reported_us);
    TEST_ASSERT_EQUAL_UINT32(1U, card.is_timed);
    sample(1000U, 1000U + ERROR_US);
    TEST_ASSERT_EQUAL_UINT32(1000U + ERROR_US, card.reported_us);
    sample(1000U, 1000U - ERROR_US);
    TEST_ASSERT_EQUAL_UINT32(1000U - ERROR_US, card.reported_us);
    TEST_ASSERT_EQUAL_UINT32(1U, card.is_timed);
}

void test_SWR_LINK_012_a_clock_that_the_board_contradicts_is_not_believed(void)
{
    repeat(good_cycle, 3U);
    sample(1000U, 1000U);
    sample(1000U, 1001U + ERROR_US);
    TEST_ASSERT_EQUAL_UINT32(1000U, card.reported_us);
    TEST_ASSERT_EQUAL_UINT32(0U, card.is_timed);
    sample(1000U, 999U - ERROR_US);
    TEST_ASSERT_EQUAL_UINT32(1000U, card.reported_us);
    TEST_ASSERT_EQUAL_UINT32(0U, card.is_timed);
    sample(1000U, 1000U);
    TEST_ASSERT_EQUAL_UINT32(1U, card.is_timed);
}

void test_SWR_LINK_012_a_clock_that_stands_still_is_never_believed(void)
{
    samples.error_us = UINT32_MAX;
    repeat(good_cycle, 3U);
    sample(1000U, 499U);
    TEST_ASSERT_EQUAL_UINT32(1000U, card.reported_us);
    sample(1000U, 0U);
    TEST_ASSERT_EQUAL_UINT32(1000U, card.reported_us);
    TEST_ASSERT_EQUAL_UINT32(0U, card.is_timed);
    sample(1000U, 500U);
    TEST_ASSERT_EQUAL_UINT32(500U, card.reported_us);
}

void test_SWR_LINK_012_a_board_that_does_not_report_leaves_the_wake_ups(void)
{
    link_init(&card, CARD_TYPE_PWM, FIRMWARE);
    sample(5000U, 70U);
    TEST_ASSERT_EQUAL_UINT32(LIMIT_CYCLE_US, card.reported_us); /* There was none before. */
    elapsed_us = 1234U;
    sample(0U, 0U);
    TEST_ASSERT_EQUAL_UINT32(1234U, card.reported_us);
}

void test_SWR_LINK_012_after_missed_reports_all_their_time_counts(void)
{
    repeat(good_cycle, 3U);
    sample(1000U, 1000U);
    silent_cycle();
    TEST_ASSERT_EQUAL_UINT32(0U, card.reported_us);
    silent_cycle();
    sample(3000U, 3010U);
    TEST_ASSERT_EQUAL_UINT32(3010U, card.reported_us);
    TEST_ASSERT_EQUAL_UINT32(0U, card.is_timed);
    sample(1000U, 1000U);
    TEST_ASSERT_EQUAL_UINT32(1U, card.is_timed);
}
