/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the board exchanges packets with each card that is idle without any process
 * waiting for it, and gives the drives power only while its cards were found good. Below is a
 * library in NI's place.
 */
#include "unity.h"

#include "bsp.h"
#include "card/aim32_frame.h"
#include "card/card_frame.h"

#include "unit/support/fpga_world.h"

#include <unistd.h>

#include "unit/nifpga/nifpga_world.inc"

#define POWER_BIT 7U
#define ALIVE_BIT 8U
#define LAMP_BIT 9U

/* The deadline has passed already: each state is looked at once. */
static void finish_at_once(void)
{
    bsp_finish(0U, received, &result);
}

void setUp(void)
{
    begin_nifpga();
}

void tearDown(void)
{
    bsp_close();
    (void)unlink(path);
}

void test_SWR_BSP_007_each_report_has_the_time_at_which_its_packet_began(void)
{
    open_good_box();
    start(OUR_SLOTS);
    finish();
    for (uint32_t slot = FPGA_WORLD_FIRST_SLOT; slot < FPGA_WORLD_END_SLOT; slot++) {
        TEST_ASSERT_TRUE((result.sampled_ns[slot] >= result.started_ns) &&
                         (result.sampled_ns[slot] <= result.finished_ns));
    }
}

void test_SWR_NI_011_each_card_gets_its_packet_and_is_heard(void)
{
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        fpga_world.cards[slot].takes_looks = slot;
    }
    open_good_box();
    start(OUR_SLOTS);
    finish();
    TEST_ASSERT_EQUAL_HEX32(OUR_SLOTS, result.received);
    TEST_ASSERT_EQUAL_INT32(0, result.error);
    TEST_ASSERT_TRUE(result.started_ns <= result.finished_ns);
    for (uint32_t slot = FPGA_WORLD_FIRST_SLOT; slot < FPGA_WORLD_END_SLOT; slot++) {
        card_report_t report = {.slot = 0U};
        TEST_ASSERT_EQUAL_HEX32(0xFEFEFE01U, fpga_world.cards[slot].sent[0]);
        TEST_ASSERT_EQUAL_HEX32(0x1234U, fpga_world.cards[slot].sent[3]);
        TEST_ASSERT_EQUAL_HEX32(1U, fpga_world.cards[slot].sent[14]);
        TEST_ASSERT_EQUAL_HEX32(0xFFFFFFFFU - (0xFEFEFE01U + 0x1235U),
                                fpga_world.cards[slot].sent[31]);
        TEST_ASSERT_EQUAL(CARD_FRAME_OK, aim32_frame_decode_report(received[slot], &report));
        TEST_ASSERT_EQUAL_INT32((int32_t)(100U * slot), report.encoder_count);
        TEST_ASSERT_EACH_EQUAL_HEX8(0U, &received[slot][128], 128U);
    }
    TEST_ASSERT_EACH_EQUAL_HEX8(0xEEU, received[8], CARD_FRAME_BYTES);
}

void test_SWR_NI_011_only_who_is_asked_is_transacted(void)
{
    open_good_box();
    start(0x08U);
    finish();
    TEST_ASSERT_EQUAL_HEX32(0x08U, result.received);
    TEST_ASSERT_EQUAL_UINT32(1U, fpga_world.cards[3].transacts);
    TEST_ASSERT_EQUAL_UINT32(0U, fpga_world.cards[2].transacts);
    TEST_ASSERT_EQUAL_UINT32(BSP_SLOT_NOT_SENT, result.results[2]);
}

void test_SWR_NI_011_a_card_that_hangs_is_late_then_not_idle_and_never_heard_for_another(void)
{
    open_good_box();
    fpga_world.cards[3].takes_looks = FPGA_WORLD_FOREVER;
    start(OUR_SLOTS);
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        fpga_world.cards[slot].busy_looks = (slot == 3U) ? FPGA_WORLD_FOREVER : 0U;
    }
    finish_at_once();
    TEST_ASSERT_EQUAL_HEX32(OUR_SLOTS & ~0x08U, result.received);
    TEST_ASSERT_EQUAL_UINT32(BSP_SLOT_LATE, result.results[3]);
    fpga_world.cards[3].sent[3] = 0U;
    start(OUR_SLOTS);
    TEST_ASSERT_EQUAL_UINT32(1U, fpga_world.cards[3].transacts);
    TEST_ASSERT_EQUAL_HEX32(0U, fpga_world.cards[3].sent[3]);
    fpga_world.cards[3].busy_looks = 0U;
    finish();
    TEST_ASSERT_EQUAL_UINT32(BSP_SLOT_NOT_IDLE, result.results[3]);
    TEST_ASSERT_EQUAL_HEX32(OUR_SLOTS & ~0x08U, result.received);
    start(OUR_SLOTS);
    fpga_world.cards[3].busy_looks = 0U;
    finish();
    TEST_ASSERT_EQUAL_HEX32(OUR_SLOTS, result.received);
}

void test_SWR_NI_011_a_wire_that_stands_still_is_no_answer(void)
{
    open_good_box();
    fpga_world.cards[5].is_dead = true;
    start(OUR_SLOTS);
    finish();
    TEST_ASSERT_EQUAL_UINT32(BSP_SLOT_NO_ANSWER, result.results[5]);
    TEST_ASSERT_EQUAL_HEX32(OUR_SLOTS & ~0x20U, result.received);
}

void test_SWR_NI_011_a_register_that_fails_is_a_bus_error_with_nis_status(void)
{
    const uint32_t failing[] = {
        fpga_world_address(FPGA_OUT, 2U), fpga_world_address(FPGA_IN, 2U) | 0x80000000U,
        fpga_world_address(FPGA_TRANSACT, 2U), fpga_world_address(FPGA_STATE, 2U)};
    open_good_box();
    for (uint32_t i = 0U; i < 4U; i++) {
        fpga_world.broken = failing[i];
        start(OUR_SLOTS);
        finish();
        TEST_ASSERT_EQUAL_UINT32(BSP_SLOT_BUS_ERROR, result.results[2]);
        TEST_ASSERT_EQUAL_INT32(FPGA_WORLD_BROKEN, result.error);
        TEST_ASSERT_EQUAL_HEX32(OUR_SLOTS & ~0x04U, result.received);
        fpga_world.cards[2].busy_looks = 0U;
    }
}

void test_SWR_NI_011_without_an_exchange_nothing_is_received(void)
{
    open_good_box();
    finish();
    TEST_ASSERT_EQUAL_HEX32(0U, result.received);
    TEST_ASSERT_EQUAL_UINT64(0U, result.started_ns);
    TEST_ASSERT_EQUAL_UINT64(0U, result.finished_ns);
}

void test_SWR_NI_013_the_self_test_passes_on_good_cards_and_asks_no_drive(void)
{
    open_good_box();
    TEST_ASSERT_TRUE_MESSAGE(bsp_self_test(error, sizeof error), error);
    TEST_ASSERT_EQUAL_HEX32(0U, fpga_world.cards[1].sent[3]);
    TEST_ASSERT_EQUAL_HEX32(0U, fpga_world.cards[1].sent[14]);
    TEST_ASSERT_EQUAL_UINT32(5U, fpga_world.cards[1].transacts);
}

void test_SWR_NI_013_an_empty_slot_is_fine_and_a_box_without_any_card_is_not(void)
{
    open_good_box();
    fpga_world.cards[6].is_dead = true;
    TEST_ASSERT_TRUE_MESSAGE(bsp_self_test(error, sizeof error), error);
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        fpga_world.cards[slot].is_dead = true;
    }
    TEST_ASSERT_FALSE(bsp_self_test(error, sizeof error));
    TEST_ASSERT_EQUAL_STRING("No card answers; check the supply of the cards.", error);
}

static void expect_test_fails(const char *expected)
{
    TEST_ASSERT_FALSE(bsp_self_test(error, sizeof error));
    TEST_ASSERT_EQUAL_STRING(expected, error);
    TEST_ASSERT_EQUAL_UINT8(0U, fpga_world.bits[POWER_BIT]);
}

void test_SWR_NI_013_what_is_wrong_with_a_card_is_named(void)
{
    open_good_box();
    fpga_world.cards[2].is_damaged = true;
    expect_test_fails("The card of slot 2 sends damaged reports (NI's status 0); check its cable.");
    fpga_world.cards[2].is_damaged = false;
    fpga_world.cards[2].flickers = true;
    expect_test_fails(
        "The card of slot 2 answers only sometimes (NI's status 0); check its cable.");
    fpga_world.cards[2].flickers = false;
    fpga_world.broken = fpga_world_address(FPGA_STATE, 2U);
    expect_test_fails("The card of slot 2 cannot be reached through the FPGA (NI's status -61003); "
                      "check its cable.");
    fpga_world.broken = 0U;
    fpga_world.cards[2].takes_looks = FPGA_WORLD_FOREVER;
    expect_test_fails("The card of slot 2 does not come to its state Idle (NI's status 0); check "
                      "its cable.");
}

void test_SWR_NI_014_drives_have_power_after_the_self_test_until_they_are_switched_off(void)
{
    fpga_world.bits[POWER_BIT] = 1U;
    open_good_box();
    TEST_ASSERT_EQUAL_UINT8(0U, fpga_world.bits[POWER_BIT]);
    TEST_ASSERT_TRUE_MESSAGE(bsp_self_test(error, sizeof error), error);
    TEST_ASSERT_EQUAL_UINT8(1U, fpga_world.bits[POWER_BIT]);
    bsp_drives_off();
    TEST_ASSERT_EQUAL_UINT8(0U, fpga_world.bits[POWER_BIT]);
    expect_test_fails("The register DrivesPower cannot be written.");
}

void test_SWR_NI_014_a_box_whose_power_cannot_be_taken_does_not_open(void)
{
    fpga_world.broken = fpga_world_bit(POWER_BIT);
    expect_refused("The register DrivesPower cannot be cleared; check the bitfile and the FPGA.");
    TEST_ASSERT_EQUAL_UINT32(1U, fpga_world.closed);
    fpga_world.broken = 0U;
    open_good_box();
}

void test_SWR_NI_014_switching_off_before_a_box_is_open_does_nothing(void)
{
    bsp_drives_off();
    TEST_ASSERT_EQUAL_UINT32(0U, fpga_world.writes[POWER_BIT]);
}

void test_SWR_NI_014_each_kick_changes_the_register_that_the_fpga_watches(void)
{
    open_good_box();
    for (uint32_t i = 0U; i < 4U; i++) {
        const uint8_t before = fpga_world.bits[ALIVE_BIT];
        bsp_kick();
        TEST_ASSERT_NOT_EQUAL(before, fpga_world.bits[ALIVE_BIT]);
    }
}

void test_SWR_NI_015_inputs_are_read_and_what_is_not_is_not_valid(void)
{
    bsp_inputs_t inputs;
    made.without = "Confirm";
    fpga_world.bits[0] = 1U;
    open_good_box();
    bsp_sample_inputs(&inputs);
    TEST_ASSERT_EQUAL_HEX32(BSP_IN_PEDAL_A | BSP_IN_ESTOP_CHAIN | BSP_IN_SCANNER_IDLE,
                            inputs.levels);
    TEST_ASSERT_EQUAL_HEX32(BSP_IN_ALL & ~BSP_IN_CONFIRM, inputs.valid);
    TEST_ASSERT_EQUAL_HEX32(0U, inputs.dropped);
    fpga_world.broken = fpga_world_bit(2U);
    bsp_sample_inputs(&inputs);
    TEST_ASSERT_EQUAL_HEX32(BSP_IN_PEDAL_A | BSP_IN_SCANNER_IDLE, inputs.levels);
    TEST_ASSERT_EQUAL_HEX32(BSP_IN_ALL & ~(BSP_IN_CONFIRM | BSP_IN_ESTOP_CHAIN), inputs.valid);
}

void test_SWR_NI_015_lamps_are_written_when_they_change(void)
{
    open_good_box();
    bsp_set_lamps(BSP_LAMP_ALIVE | BSP_LAMP_MOVING);
    bsp_set_lamps(BSP_LAMP_ALIVE | BSP_LAMP_MOVING);
    TEST_ASSERT_EQUAL_UINT8(1U, fpga_world.bits[LAMP_BIT]);
    TEST_ASSERT_EQUAL_UINT8(0U, fpga_world.bits[LAMP_BIT + 1U]);
    TEST_ASSERT_EQUAL_UINT8(1U, fpga_world.bits[LAMP_BIT + 2U]);
    TEST_ASSERT_EQUAL_UINT32(1U, fpga_world.writes[LAMP_BIT]);
    bsp_set_lamps(0U);
    TEST_ASSERT_EQUAL_UINT8(0U, fpga_world.bits[LAMP_BIT]);
}

void test_SWR_NI_015_time_goes_on_and_sleep_lasts(void)
{
    const uint64_t before_ns = bsp_now_ns();
    bsp_sleep_until_ns(before_ns + NS_PER_MS);
    TEST_ASSERT_TRUE(bsp_reached_ns() >= before_ns + NS_PER_MS);
}
