/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: only fresh, whole and healthy frames keep a card usable; a card that is silent,
 * faulty, or does not obey is lost, and stays lost until a reset in a cycle with a good
 * frame.
 */
#include "unity.h"

#include "base/crc.h"
#include "card/card_frame.h"
#include "card/link.h"
#include "charts/card_link_chart.h"
#include "limits/requirement_limits.h"
#include "robot/robot.h"

#include <stddef.h>
#include <string.h>

#define SLOT 4U
#define FIRMWARE 0x010200U
#define FIRST_SEQUENCE 100U
#define ERROR_US 300U /* Error of the board. */
#define HISTORY 3U

static const uint32_t fault_bits[] = {CARD_STATUS_DRIVER_FAULT, CARD_STATUS_WATCHDOG,
                                      CARD_STATUS_HOT,          CARD_STATUS_OVERSPEED,
                                      CARD_STATUS_GUARD,        CARD_STATUS_POWER_BAD};
static const uint32_t harmless_bits[] = {CARD_STATUS_AMPLIFIER_ON, CARD_STATUS_MOVING,
                                         CARD_STATUS_ILLEGAL_EDGE, CARD_STATUS_RX_CRC};

static link_t card;
static card_samples_t samples;
static uint32_t elapsed_us;
static uint8_t bytes[CARD_FRAME_BYTES];
static card_report_t report;       /* The card's next one. */
static card_drive_t drive;         /* The command from now on. */
static card_drive_t sent[HISTORY]; /* Past commands, newest first. */
static uint32_t sequence;

static void command(void)
{
    sent[2] = sent[1];
    sent[1] = sent[0];
    sent[0] = drive;
    link_note_sent(&card, sequence, &drive);
    sequence++;
}

/* A good card reports the command before the last one. */
static void make_report(void)
{
    report.heartbeat++;
    report.accepted_sequence = (sequence < (FIRST_SEQUENCE + 2U)) ? 0U : (sequence - 2U);
    report.applied = sent[1];
}

static void receive(void)
{
    card_frame_encode_report(&report, bytes);
    link_step(&card, SLOT, bytes, &samples, elapsed_us);
}

static void good_cycle(void)
{
    make_report();
    receive();
    command();
}

static void silent_cycle(void)
{
    make_report();
    link_step(&card, SLOT, NULL, &samples, elapsed_us);
    command();
}

static void repeat(void (*cycle)(void), uint32_t count)
{
    for (uint32_t i = 0U; i < count; i++) {
        cycle();
    }
}

static void lose_by_silence(void)
{
    repeat(silent_cycle, LIMIT_LINK_AGE_CYCLES);
    TEST_ASSERT_FALSE(link_is_usable(&card));
}

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
    samples = (card_samples_t){.error_us = ERROR_US};
    elapsed_us = LIMIT_CYCLE_US;
    (void)memset(&report, 0, sizeof report);
    (void)memset(&drive, 0, sizeof drive);
    (void)memset(sent, 0, sizeof sent);
    report.slot = SLOT;
    report.card_type = CARD_TYPE_PWM;
    report.firmware = FIRMWARE;
    report.encoder_count = 4711;
    report.heartbeat = 41U;
    sequence = FIRST_SEQUENCE;
    link_init(&card, CARD_TYPE_PWM, FIRMWARE);
    repeat(good_cycle, 3U);
}

void tearDown(void)
{
}

/* A command of which each field can be wrong alone. */
static void start_driving(void)
{
    setUp();
    drive = (card_drive_t){CARD_DRIVE_PWM, 1U, 0U, 0U};
    repeat(good_cycle, 3U);
}

/* One field of the read-back is wrong. */
static void wrong_echo_cycle(uint32_t which)
{
    make_report();
    switch (which) {
    case 0U:
        report.applied.mode = CARD_DRIVE_NON_PWM;
        break;
    case 1U:
        report.applied.direction ^= 1U;
        break;
    case 2U:
        report.applied.duty++;
        break;
    default:
        report.accepted_sequence--;
        break;
    }
    receive();
    command();
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

/* Its clock stood, so that its watchdog has not tripped yet, and the numbers of the commands went
 * on. */
void test_SWR_LINK_042_a_lost_card_that_refuses_its_commands_is_not_used_again(void)
{
    for (uint32_t which = 0U; which < 4U; which++) {
        start_driving();
        lose_by_silence();
        wrong_echo_cycle(which);
        TEST_ASSERT_FALSE(link_is_healthy_now(&card));
        link_reset(&card);
        TEST_ASSERT_FALSE(link_is_usable(&card));
        good_cycle();
        TEST_ASSERT_TRUE(link_is_healthy_now(&card));
        link_reset(&card);
        TEST_ASSERT_TRUE(link_is_usable(&card));
    }
}

void test_SWR_LINK_042_a_card_in_use_may_show_another_command_for_less_than_the_limit(void)
{
    start_driving();
    wrong_echo_cycle(2U);
    TEST_ASSERT_TRUE(link_is_healthy_now(&card));
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

void test_SWR_LINK_005_the_read_back_speaks_of_the_command_before_the_last_one(void)
{
    for (uint32_t i = 0U; i < 50U; i++) {
        drive = (i % 3U == 0U) ? (card_drive_t){CARD_DRIVE_OFF, 0U, 0U, 0U}
                               : (card_drive_t){CARD_DRIVE_PWM, i % 2U, i, 0U};
        good_cycle();
        TEST_ASSERT_EQUAL_UINT32(1U, card.is_fresh);
        TEST_ASSERT_EQUAL_UINT32(0U, card.sealed.echo_mismatches);
        TEST_ASSERT_TRUE(link_is_usable(&card));
    }
}

void test_SWR_LINK_005_each_wrong_field_up_to_the_limit_is_a_lost_card(void)
{
    for (uint32_t which = 0U; which < 4U; which++) {
        start_driving();
        for (uint32_t i = 1U; i < LIMIT_ECHO_MISMATCH_CYCLES; i++) {
            wrong_echo_cycle(which);
            TEST_ASSERT_TRUE(link_is_usable(&card));
        }
        wrong_echo_cycle(which);
        TEST_ASSERT_FALSE(link_is_usable(&card));
        TEST_ASSERT_EQUAL_UINT32(LINK_CAUSE_ECHO, card.sealed.cause);
    }
}

static void wave_cycle(uint32_t more_duty, uint32_t more_amplitude)
{
    make_report();
    report.applied.duty += more_duty;
    report.applied.amplitude += more_amplitude;
    receive();
    command();
}

void test_SWR_DRIVE_004_another_frequency_or_amplitude_up_to_the_limit_is_a_lost_card(void)
{
    for (uint32_t which = 0U; which < 2U; which++) {
        setUp();
        drive = (card_drive_t){CARD_DRIVE_HIGH_FREQUENCY, 1U, LIMIT_WAVE_FASTEST_WORD, 7U};
        repeat(good_cycle, 3U);
        for (uint32_t i = 1U; i < LIMIT_ECHO_MISMATCH_CYCLES; i++) {
            wave_cycle(which, 1U - which);
            TEST_ASSERT_TRUE(link_is_usable(&card));
        }
        wave_cycle(which, 1U - which);
        TEST_ASSERT_FALSE(link_is_usable(&card));
        TEST_ASSERT_EQUAL_UINT32(LINK_CAUSE_ECHO, card.sealed.cause);
    }
}

void test_SWR_LINK_005_a_right_read_back_begins_the_count_anew(void)
{
    start_driving();
    for (uint32_t i = 0U; i < 10U; i++) {
        for (uint32_t k = 1U; k < LIMIT_ECHO_MISMATCH_CYCLES; k++) {
            wrong_echo_cycle(2U);
        }
        good_cycle();
        TEST_ASSERT_TRUE(link_is_usable(&card));
        TEST_ASSERT_EQUAL_UINT32(0U, card.sealed.echo_mismatches);
    }
}

void test_SWR_LINK_005_a_cycle_without_frame_does_not_interrupt_the_row(void)
{
    start_driving();
    for (uint32_t k = 1U; k < LIMIT_ECHO_MISMATCH_CYCLES; k++) {
        wrong_echo_cycle(2U);
    }
    silent_cycle();
    TEST_ASSERT_TRUE(link_is_usable(&card));
    wrong_echo_cycle(2U);
    TEST_ASSERT_FALSE(link_is_usable(&card));
}

void test_SWR_LINK_006_each_reported_fault_is_a_lost_card_in_that_cycle(void)
{
    for (size_t i = 0U; i < sizeof fault_bits / sizeof fault_bits[0]; i++) {
        setUp();
        report.status = fault_bits[i];
        good_cycle();
        TEST_ASSERT_FALSE(link_is_usable(&card));
        TEST_ASSERT_FALSE(link_is_healthy_now(&card));
        TEST_ASSERT_EQUAL_UINT32(LINK_CAUSE_FAULT, card.sealed.cause);
        report.status = 0U;
    }
}

void test_SWR_LINK_006_a_fault_after_a_missed_cycle_is_a_lost_card(void)
{
    silent_cycle();
    report.status = CARD_STATUS_WATCHDOG;
    good_cycle();
    TEST_ASSERT_FALSE(link_is_usable(&card));
    TEST_ASSERT_EQUAL_UINT32(LINK_CAUSE_FAULT, card.sealed.cause);
}

void test_SWR_LINK_006_the_fault_of_an_old_report_does_not_count_again(void)
{
    lose_by_silence();
    report.status = CARD_STATUS_WATCHDOG;
    good_cycle();
    report.status = 0U;
    good_cycle();
    link_reset(&card);
    TEST_ASSERT_TRUE(link_is_usable(&card));
    card.report.status = CARD_STATUS_WATCHDOG;
    silent_cycle();
    TEST_ASSERT_TRUE(link_is_usable(&card));
}

void test_SWR_LINK_006_other_status_bits_leave_the_card_usable(void)
{
    for (size_t i = 0U; i < sizeof harmless_bits / sizeof harmless_bits[0]; i++) {
        report.status = harmless_bits[i];
        good_cycle();
        TEST_ASSERT_TRUE(link_is_usable(&card));
        TEST_ASSERT_TRUE(link_is_healthy_now(&card));
    }
}

void test_SWR_LINK_006_a_card_that_starts_with_a_fault_is_not_usable_until_it_is_gone(void)
{
    link_init(&card, CARD_TYPE_PWM, FIRMWARE);
    report.status = CARD_STATUS_WATCHDOG;
    repeat(good_cycle, 20U);
    TEST_ASSERT_FALSE(link_is_usable(&card));
    report.status = 0U;
    good_cycle();
    TEST_ASSERT_TRUE(link_is_usable(&card));
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

static void expect_wrong_card(void)
{
    TEST_ASSERT_FALSE(link_is_usable(&card));
    TEST_ASSERT_EQUAL_UINT32(CARD_LINK_STATE_LOST, card.chart.state);
    TEST_ASSERT_EQUAL_UINT32(LINK_CAUSE_WRONG_CARD, card.sealed.cause);
    TEST_ASSERT_FALSE(link_is_healthy_now(&card));
    link_reset(&card);
    TEST_ASSERT_FALSE(link_is_usable(&card));
}

void test_SWR_LINK_008_another_type_or_firmware_is_lost_by_name(void)
{
    report.card_type = CARD_TYPE_NON_PWM;
    good_cycle();
    expect_wrong_card();
    setUp();
    report.firmware++;
    good_cycle();
    expect_wrong_card();
}

void test_SWR_LINK_008_a_wrong_card_at_the_start_is_lost_too(void)
{
    link_init(&card, CARD_TYPE_PWM, FIRMWARE);
    report.firmware--;
    good_cycle();
    expect_wrong_card();
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

void test_SWR_LINK_013_what_a_card_applies_is_what_it_says(void)
{
    repeat(good_cycle, 3U);
    drive = (card_drive_t){.mode = CARD_DRIVE_PWM, .direction = 1U, .duty = 1000U};
    repeat(command, 2U);
    make_report();
    report.applied.duty = 77U;
    receive();
    TEST_ASSERT_EQUAL_UINT32(77U, link_applied(&card)->duty);
    report.status = CARD_STATUS_WATCHDOG;
    report.heartbeat++;
    receive();
    TEST_ASSERT_EQUAL_PTR(&card.sealed.sent_before, link_applied(&card));
    link_step(&card, SLOT, NULL, &samples, elapsed_us);
    TEST_ASSERT_EQUAL_PTR(&card.sealed.sent_before, link_applied(&card));
}
