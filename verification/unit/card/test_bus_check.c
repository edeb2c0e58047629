/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: what comes back from a slot is named for what it is, and a slot whose wires are
 * not right is refused with what to do.
 */
#include "unity.h"

#include "card/card_frame.h"
#include "sbrio/bus_check.h"

#include <string.h>

#define SLOT 3U

static const wiring_spi_t spi = {
    .path = "/dev/spidev1.0", .slot_count = 10U, .clock_hz = 25000000U, .mode = 1U};
static uint8_t bytes[CARD_FRAME_BYTES];
static char error[256];

void setUp(void)
{
    error[0] = '\0';
}

void tearDown(void)
{
}

static void report(uint32_t slot, uint32_t heartbeat)
{
    const card_report_t made = {
        .slot = slot, .heartbeat = heartbeat, .card_type = (uint32_t)CARD_TYPE_PWM};
    card_frame_encode_report(&made, bytes);
}

static uint32_t bit_at(const uint8_t *of, uint32_t place)
{
    return (of[place / 8U] >> (7U - (place % 8U))) & 1U;
}

/* Every bit comes `bits` later; what is before the first one is `fill`. */
static void delay(uint32_t bits, uint32_t fill)
{
    uint8_t late[CARD_FRAME_BYTES] = {0};
    for (uint32_t i = 0U; i < 8U * CARD_FRAME_BYTES; i++) {
        const uint32_t bit = (i < bits) ? fill : bit_at(bytes, i - bits);
        late[i / 8U] = (uint8_t)(late[i / 8U] | (bit << (7U - (i % 8U))));
    }
    (void)memcpy(bytes, late, sizeof bytes);
}

/* The first bits are lost. */
static void hasten(uint32_t bits)
{
    uint8_t early[CARD_FRAME_BYTES] = {0};
    for (uint32_t i = 0U; i < (8U * CARD_FRAME_BYTES) - bits; i++) {
        early[i / 8U] = (uint8_t)(early[i / 8U] | (bit_at(bytes, i + bits) << (7U - (i % 8U))));
    }
    (void)memcpy(bytes, early, sizeof bytes);
}

static bus_check_seen_t look(void)
{
    return bus_check_look(SLOT, bytes);
}

static bus_check_seen_t alive(uint32_t heartbeat)
{
    return (bus_check_seen_t){
        .answer = BUS_CHECK_ALIVE, .heartbeat = heartbeat, .slot = SLOT, .shift_bits = 0U};
}

static bool judge(const bus_check_seen_t *apart, const bus_check_seen_t *again,
                  const bus_check_seen_t *together)
{
    return bus_check_judge(&spi, SLOT, apart, again, together, error, sizeof error);
}

static void assert_refused(bus_check_seen_t seen, const char *sentence)
{
    const bus_check_seen_t good = alive(1U);
    TEST_ASSERT_FALSE(judge(&seen, &good, &good));
    TEST_ASSERT_EQUAL_STRING(sentence, error);
    error[0] = '\0';
    TEST_ASSERT_FALSE(judge(&good, &seen, &good));
    TEST_ASSERT_EQUAL_STRING(sentence, error);
}

void test_SWR_SPI_010_a_wire_that_stands_still_is_an_empty_slot(void)
{
    (void)memset(bytes, 0, sizeof bytes);
    TEST_ASSERT_EQUAL(BUS_CHECK_EMPTY, look().answer);
    (void)memset(bytes, 0xFF, sizeof bytes);
    TEST_ASSERT_EQUAL(BUS_CHECK_EMPTY, look().answer);
    bytes[CARD_FRAME_BYTES - 1U] = 0xFEU;
    TEST_ASSERT_EQUAL(BUS_CHECK_NOISE, look().answer);
    (void)memset(bytes, 0x55, sizeof bytes);
    TEST_ASSERT_EQUAL(BUS_CHECK_NOISE, look().answer);
}

void test_SWR_SPI_010_a_report_is_that_of_its_slot_or_of_another(void)
{
    report(SLOT, 77U);
    const bus_check_seen_t seen = look();
    TEST_ASSERT_EQUAL(BUS_CHECK_ALIVE, seen.answer);
    TEST_ASSERT_EQUAL_UINT32(77U, seen.heartbeat);
    report(9U, 77U);
    TEST_ASSERT_EQUAL(BUS_CHECK_OTHER, look().answer);
    TEST_ASSERT_EQUAL_UINT32(9U, look().slot);
    report(SLOT, 77U);
    bytes[100] ^= 1U;
    TEST_ASSERT_EQUAL(BUS_CHECK_DAMAGED, look().answer);
}

void test_SWR_SPI_008_an_answer_that_is_late_or_early_by_bits_is_seen(void)
{
    for (uint32_t bits = 1U; bits <= 7U; bits++) {
        for (uint32_t fill = 0U; fill <= 1U; fill++) {
            report(SLOT, 1U);
            delay(bits, fill);
            TEST_ASSERT_EQUAL(BUS_CHECK_SHIFTED, look().answer);
            TEST_ASSERT_EQUAL_UINT32(bits, look().shift_bits);
        }
        report(SLOT, 1U);
        hasten(bits);
        TEST_ASSERT_EQUAL(BUS_CHECK_SHIFTED, look().answer);
        TEST_ASSERT_EQUAL_UINT32(bits, look().shift_bits);
    }
    report(SLOT, 1U);
    delay(8U, 0U);
    TEST_ASSERT_EQUAL(BUS_CHECK_NOISE, look().answer);
}

void test_SWR_SPI_008_shifted_bits_fail_with_slot_bits_and_clock(void)
{
    assert_refused((bus_check_seen_t){.answer = BUS_CHECK_SHIFTED, .shift_bits = 2U},
                   "Slot 3 of /dev/spidev1.0 answers 2 bits beside its place: the clock of 25.0 "
                   "MHz is probably too high, or mode=1 is not that of the card.");
}

void test_SWR_SPI_009_who_answers_only_while_frames_are_apart_needs_a_gap(void)
{
    const bus_check_seen_t first = alive(1U);
    const bus_check_seen_t second = alive(2U);
    const bus_check_seen_t garbled = {.answer = BUS_CHECK_NOISE};
    TEST_ASSERT_FALSE(judge(&first, &second, &garbled));
    TEST_ASSERT_EQUAL_STRING("Slot 3 of /dev/spidev1.0 answers while frames are far apart, and not "
                             "as they are: the chip select's pause is too short for it; give "
                             "gap=20.",
                             error);
}

void test_SWR_SPI_010_a_slot_is_empty_or_alive(void)
{
    const bus_check_seen_t empty = {.answer = BUS_CHECK_EMPTY};
    const bus_check_seen_t first = alive(UINT32_MAX);
    const bus_check_seen_t second = alive(0U);
    TEST_ASSERT_TRUE(judge(&empty, &empty, &empty));
    TEST_ASSERT_TRUE(judge(&first, &second, &second));
    TEST_ASSERT_EQUAL_STRING("", error);
}

void test_SWR_SPI_010_what_is_neither_is_named(void)
{
    assert_refused((bus_check_seen_t){.answer = BUS_CHECK_OTHER, .slot = 4U},
                   "Where slot 3 of /dev/spidev1.0 should answer, the card of slot 4 does; compare "
                   "slots= with the wires and the multiplexer.");
    assert_refused((bus_check_seen_t){.answer = BUS_CHECK_DAMAGED},
                   "Slot 3 of /dev/spidev1.0 answers with damaged reports: check shield and ground "
                   "of its wires, and the firmware of the card, or lower the clock of 25.0 MHz.");
    assert_refused((bus_check_seen_t){.answer = BUS_CHECK_NOISE},
                   "Slot 3 of /dev/spidev1.0 answers without a start word: its card has another "
                   "protocol, or its wires are open.");
    assert_refused((bus_check_seen_t){.answer = BUS_CHECK_EMPTY},
                   "Slot 3 of /dev/spidev1.0 answers only sometimes; check its plug and its "
                   "supply.");
}

void test_SWR_SPI_010_an_old_report_is_no_life(void)
{
    const bus_check_seen_t same = alive(7U);
    TEST_ASSERT_FALSE(judge(&same, &same, &same));
    TEST_ASSERT_EQUAL_STRING("Slot 3 of /dev/spidev1.0 gives the same report twice: its card does "
                             "not run; switch the box off and on.",
                             error);
}
