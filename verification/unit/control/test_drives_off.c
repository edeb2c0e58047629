/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: whatever ends control, every card is sent "off" whether or not anything was
 * about to be sent, as often as it takes to hear it confirmed, and only what was heard is said.
 */
#include "unity.h"

#include "card/aim32_frame.h"
#include "card/card_dialect.h"
#include "card/card_frame.h"
#include "control/drives_off.h"
#include "limits/requirement_limits.h"
#include "mock_bsp.h"
#include "robot/robot_neuro.h"

#include <string.h>

#define SEQUENCE 0xFFFFFFFEU /* Its wrap is inside. */
#define TIME_US 4711U
#define ALL_SLOTS 0x0FEU

/* State of the cards. */
static uint32_t answering;
static uint32_t damaged;
static uint32_t driving; /* Go on, whatever they are sent. */

/* Acts of control. */
static uint32_t exchanges;
static card_command_t heard[CARD_SLOT_COUNT]; /* The last ones. */
static uint32_t sent[LIMIT_OFF_EXCHANGES];
static uint32_t finished;
static uint8_t reports[CARD_SLOT_COUNT][CARD_FRAME_BYTES]; /* On their way back. */

#define NOW_NS UINT64_C(5000000)

static void answer(uint32_t slot, uint8_t bytes[CARD_FRAME_BYTES])
{
    const bool is_driving = (exchanges == 0U) || ((driving & (1U << slot)) != 0U);
    const card_report_t report = {
        .slot = slot,
        .accepted_sequence = (exchanges == 0U) ? (SEQUENCE - 1U) : heard[slot].sequence,
        .applied.mode = (uint32_t)(is_driving ? CARD_DRIVE_NON_PWM : CARD_DRIVE_OFF)};
    card_frame_encode_report(&report, bytes);
    if ((damaged & (1U << slot)) != 0U) {
        bytes[40] ^= 1U;
    }
}

/* A report is from before the frame is heard. */
static void start(uint32_t send, const uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES], int calls)
{
    TEST_ASSERT_EQUAL_INT((int)exchanges, calls);
    TEST_ASSERT_EQUAL_UINT32(exchanges + 1U, finished); /* Nothing is under way. */
    sent[exchanges] = send;
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        if ((send & answering & (1U << slot)) != 0U) {
            answer(slot, reports[slot]);
        }
        if ((send & (1U << slot)) != 0U) {
            TEST_ASSERT_EQUAL(CARD_FRAME_OK,
                              card_frame_decode_command(frames[slot], slot, &heard[slot]));
            TEST_ASSERT_EQUAL_UINT32(SEQUENCE + exchanges, heard[slot].sequence);
        }
    }
    exchanges++;
}

static void finish(uint64_t deadline_ns, uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES],
                   bsp_exchange_t *result, int calls)
{
    TEST_ASSERT_EQUAL_UINT64(NOW_NS + (UINT64_C(1000) * LIMIT_EXCHANGE_TIMEOUT_US), deadline_ns);
    (void)calls;
    (void)memcpy(received, reports, sizeof reports);
    *result =
        (bsp_exchange_t){.received = (exchanges > 0U) ? (sent[exchanges - 1U] & answering) : 0U};
    finished++;
}

static uint64_t now(int calls)
{
    (void)calls;
    return NOW_NS;
}

static drives_off_t run(void)
{
    return drives_off(&robot_neuro, CARD_DIALECT_OWN, SEQUENCE, TIME_US);
}

static void expect_text(const drives_off_t *done, const char *expected)
{
    char text[DRIVES_OFF_TEXT_SIZE];
    drives_off_report(done, text);
    TEST_ASSERT_EQUAL_STRING(expected, text);
}

static uint8_t off[CARD_FRAME_BYTES]; /* As cards of aim32 receive it. */

static void start_aim32(uint32_t send, const uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES],
                        int calls)
{
    (void)calls;
    sent[exchanges] = send;
    exchanges++;
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const uint32_t slot = robot_neuro.axes[i].slot;
        TEST_ASSERT_EQUAL_HEX8_ARRAY(off, frames[slot], CARD_FRAME_BYTES);
        (void)memcpy(reports[slot], off, CARD_FRAME_BYTES);
    }
}

void setUp(void)
{
    answering = ALL_SLOTS;
    damaged = 0U;
    driving = 0U;
    exchanges = 0U;
    finished = 0U;
    bsp_start_Stub(start);
    bsp_finish_Stub(finish);
    bsp_now_ns_Stub(now);
}

void tearDown(void)
{
}

void test_SWR_CTRL_004_every_card_of_the_robot_is_sent_off(void)
{
    const drives_off_t done = run();
    TEST_ASSERT_EQUAL_HEX32(ALL_SLOTS, sent[0]);
    TEST_ASSERT_EQUAL_HEX32(ALL_SLOTS, done.sent);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const card_command_t *const command = &heard[robot_neuro.axes[i].slot];
        TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_OFF, command->drive.mode);
        TEST_ASSERT_EQUAL_HEX32(CARD_CONTROL_CLEAR_FAULT, command->control);
        TEST_ASSERT_EQUAL_UINT32(LIMIT_CARD_WATCHDOG_US, command->watchdog_us);
        TEST_ASSERT_EQUAL_UINT32(TIME_US, command->time_us);
        TEST_ASSERT_EQUAL_UINT32(i, command->axis_id);
    }
}

void test_SWR_CTRL_022_a_card_without_an_axis_is_sent_off_as_well(void)
{
    robot_t robot = robot_neuro;
    robot.sensor_slots = 0x100U;
    answering = ALL_SLOTS | 0x100U;
    const drives_off_t done = drives_off(&robot, CARD_DIALECT_OWN, SEQUENCE, TIME_US);
    TEST_ASSERT_EQUAL_HEX32(ALL_SLOTS | 0x100U, sent[0]);
    TEST_ASSERT_EQUAL_HEX32(ALL_SLOTS | 0x100U, done.confirmed);
    TEST_ASSERT_EQUAL_HEX32(CARD_NO_AXIS, heard[8].axis_id);
    expect_text(&done, "all 8 cards confirm that their drive is off.\n");
}

void test_SWR_CTRL_004_the_exchange_after_the_frame_confirms_it(void)
{
    const drives_off_t done = run();
    TEST_ASSERT_EQUAL_UINT32(2U, exchanges);
    TEST_ASSERT_EQUAL_HEX32(ALL_SLOTS, done.confirmed);
    expect_text(&done, "all 7 cards confirm that their drive is off.\n");
}

void test_SWR_CTRL_004_a_board_that_does_not_answer_is_informed_again_and_nothing_is_claimed(void)
{
    answering = 0U;
    const drives_off_t done = run();
    TEST_ASSERT_EQUAL_UINT32(LIMIT_OFF_EXCHANGES, exchanges);
    for (uint32_t i = 0U; i < LIMIT_OFF_EXCHANGES; i++) {
        TEST_ASSERT_EQUAL_HEX32(ALL_SLOTS, sent[i]);
    }
    TEST_ASSERT_EQUAL_HEX32(0U, done.confirmed);
    expect_text(&done, "\"off\" was sent to all 7 cards, 0 confirm it; the others' own watchdogs "
                       "switch off within 10 ms of their time.\n");
}

void test_SWR_CTRL_004_silent_damaged_and_driving_cards_do_not_count_as_off(void)
{
    answering = ALL_SLOTS & ~0x002U;
    damaged = 0x004U;
    driving = 0x008U;
    const drives_off_t done = run();
    TEST_ASSERT_EQUAL_UINT32(LIMIT_OFF_EXCHANGES, exchanges);
    TEST_ASSERT_EQUAL_HEX32(0x0F0U, done.confirmed);
}

void test_SWR_NI_007_cards_that_cannot_confirm_are_reported_each_time_and_nothing_is_claimed(void)
{
    const card_command_t command = {.control = CARD_CONTROL_CLEAR_FAULT};
    aim32_frame_encode_command(&command, off);
    bsp_start_Stub(start_aim32);
    const drives_off_t done = drives_off(&robot_neuro, CARD_DIALECT_AIM32, SEQUENCE, TIME_US);
    TEST_ASSERT_EQUAL_UINT32(LIMIT_OFF_EXCHANGES, exchanges);
    TEST_ASSERT_EQUAL_HEX32(ALL_SLOTS, done.sent);
    TEST_ASSERT_EQUAL_HEX32(0U, done.confirmed);
    expect_text(&done,
                "\"off\" was sent to all 7 cards, which can neither confirm it nor switch off "
                "by a watchdog of their own: make sure that nothing moves.\n");
}
