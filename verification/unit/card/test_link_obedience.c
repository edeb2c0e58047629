/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a card that reports a fault, does not apply its commands, or is another one than
 * configured is lost, with the cause.
 */
#include "unity.h"

#include "card/card_frame.h"
#include "card/link.h"
#include "charts/card_link_chart.h"
#include "limits/requirement_limits.h"
#include "unit/support/link_world.inc"

#include <stddef.h>

static const uint32_t fault_bits[] = {CARD_STATUS_DRIVER_FAULT, CARD_STATUS_WATCHDOG,
                                      CARD_STATUS_HOT,          CARD_STATUS_OVERSPEED,
                                      CARD_STATUS_GUARD,        CARD_STATUS_POWER_BAD};
static const uint32_t harmless_bits[] = {CARD_STATUS_AMPLIFIER_ON, CARD_STATUS_MOVING,
                                         CARD_STATUS_ILLEGAL_EDGE, CARD_STATUS_RX_CRC};

void setUp(void)
{
    begin_link();
}

void tearDown(void)
{
}

/* A command of which each field can be wrong alone. */
static void start_driving(void)
{
    begin_link();
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
        begin_link();
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
        begin_link();
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
    begin_link();
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
