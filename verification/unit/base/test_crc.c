/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: the checksum of frames is CRC-32C. */
#include "base/crc.h"
#include "unity.h"

#include <stdbool.h>
#include <string.h>

void setUp(void)
{
}

void tearDown(void)
{
}

void test_SWR_CARD_002_checksum_of_the_check_string_is_the_published_one(void)
{
    static const uint8_t text[] = {'1', '2', '3', '4', '5', '6', '7', '8', '9'};
    TEST_ASSERT_EQUAL_HEX32(0xE3069283U, crc32c(text, sizeof text));
}

void test_SWR_CARD_002_checksum_of_the_iscsi_examples_is_the_published_one(void)
{
    uint8_t bytes[32] = {0U};
    TEST_ASSERT_EQUAL_HEX32(0x8A9136AAU, crc32c(bytes, sizeof bytes));
    for (uint32_t i = 0U; i < sizeof bytes; i++) {
        bytes[i] = 0xFFU;
    }
    TEST_ASSERT_EQUAL_HEX32(0x62A8AB43U, crc32c(bytes, sizeof bytes));
    for (uint32_t i = 0U; i < sizeof bytes; i++) {
        bytes[i] = (uint8_t)i;
    }
    TEST_ASSERT_EQUAL_HEX32(0x46DD794EU, crc32c(bytes, sizeof bytes));
}

void test_SWR_CARD_002_checksum_of_nothing_is_zero(void)
{
    static const uint8_t byte = 1U;
    TEST_ASSERT_EQUAL_HEX32(0U, crc32c(&byte, 0U));
}

/* The definition: one bit a step. In continuation of what gave `before`. */
static uint32_t extended_by_bits(uint32_t before, const uint8_t *bytes, size_t length)
{
    uint32_t crc = ~before;
    for (size_t i = 0U; i < length; i++) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; bit++) {
            crc = ((crc & 1U) != 0U) ? ((crc >> 1U) ^ 0x82F63B78U) : (crc >> 1U);
        }
    }
    return ~crc;
}

static uint32_t by_bits(const uint8_t *bytes, size_t length)
{
    return extended_by_bits(0U, bytes, length);
}

/* A single byte uses the first table, each byte of a word one of the four. */
void test_SWR_CARD_002_every_table_entry_is_the_remainder_of_its_byte(void)
{
    for (uint32_t i = 0U; i < 256U; i++) {
        uint8_t bytes[4] = {(uint8_t)i, 0U, 0U, 0U};
        TEST_ASSERT_EQUAL_HEX32(by_bits(bytes, 1U), crc32c(bytes, 1U));
        for (uint32_t place = 0U; place < 4U; place++) {
            (void)memset(bytes, 0, sizeof bytes);
            bytes[place] = (uint8_t)i;
            TEST_ASSERT_EQUAL_HEX32(by_bits(bytes, 4U), crc32c(bytes, 4U));
        }
    }
}

void test_SWR_CARD_002_a_checksum_may_end_at_any_byte(void)
{
    uint8_t bytes[23];
    for (uint32_t i = 0U; i < sizeof bytes; i++) {
        bytes[i] = (uint8_t)(i * 37U + 11U);
    }
    for (size_t length = 0U; length <= sizeof bytes; length++) {
        TEST_ASSERT_EQUAL_HEX32(by_bits(bytes, length), crc32c(bytes, length));
    }
}

/* Bytes of a frame between its header and its checksum. */
#define FRAME_BYTES 244U

static void fill(uint8_t bytes[FRAME_BYTES], size_t before, size_t zeros)
{
    for (size_t i = 0U; i < FRAME_BYTES; i++) {
        const bool is_zero = (i >= before) && (i < (before + zeros));
        bytes[i] = is_zero ? 0U : (uint8_t)((i * 37U) + 11U);
    }
}

/* Every share of every half byte: a step of the checksum is linear, so each bit of the checksum
 * before it is one of the state before the zeros, and all combinations of a half byte come with the
 * others at random. */
void test_SWR_CARD_002_zeros_that_are_not_read_count_as_zeros_that_are(void)
{
    uint8_t bytes[FRAME_BYTES];
    uint32_t crc = 1U;
    for (uint32_t i = 0U; i < 2000U; i++) {
        crc = (crc * 1664525U) + 1013904223U;
        fill(bytes, 108U, 132U);
        TEST_ASSERT_EQUAL_HEX32(extended_by_bits(crc, bytes, FRAME_BYTES),
                                crc32c_over_132(crc, bytes));
        fill(bytes, 64U, 172U);
        TEST_ASSERT_EQUAL_HEX32(extended_by_bits(crc, bytes, FRAME_BYTES),
                                crc32c_over_172(crc, bytes));
    }
}

/* A frame whose drive is off: its zeros are in two places. */
static void fill_quiet(uint8_t bytes[FRAME_BYTES], size_t quiet, size_t before, size_t zeros)
{
    fill(bytes, before, zeros);
    (void)memset(&bytes[quiet], 0, 28U);
}

void test_SWR_CARD_002_zeros_in_two_places_that_are_not_read_count_as_zeros_that_are(void)
{
    uint8_t bytes[FRAME_BYTES];
    uint32_t crc = 1U;
    for (uint32_t i = 0U; i < 2000U; i++) {
        crc = (crc * 1664525U) + 1013904223U;
        fill_quiet(bytes, 72U, 108U, 132U);
        TEST_ASSERT_EQUAL_HEX32(extended_by_bits(crc, bytes, FRAME_BYTES),
                                crc32c_over_28_and_132(crc, bytes));
        fill_quiet(bytes, 16U, 64U, 172U);
        TEST_ASSERT_EQUAL_HEX32(extended_by_bits(crc, bytes, FRAME_BYTES),
                                crc32c_over_28_and_172(crc, bytes));
    }
}

void test_SWR_CARD_002_every_word_of_a_frame_counts_in_its_checksum(void)
{
    uint8_t bytes[FRAME_BYTES];
    for (size_t i = 0U; i < FRAME_BYTES; i++) {
        fill(bytes, 108U, 132U);
        bytes[i] ^= 0x55U;
        if ((i < 108U) || (i >= 240U)) {
            TEST_ASSERT_EQUAL_HEX32(extended_by_bits(0U, bytes, FRAME_BYTES),
                                    crc32c_over_132(0U, bytes));
        }
        fill(bytes, 64U, 172U);
        bytes[i] ^= 0x55U;
        if ((i < 64U) || (i >= 236U)) {
            TEST_ASSERT_EQUAL_HEX32(extended_by_bits(0U, bytes, FRAME_BYTES),
                                    crc32c_over_172(0U, bytes));
        }
    }
}

void test_SWR_CARD_002_every_word_of_a_frame_with_two_places_of_zeros_counts(void)
{
    uint8_t bytes[FRAME_BYTES];
    for (size_t i = 0U; i < FRAME_BYTES; i++) {
        fill_quiet(bytes, 72U, 108U, 132U);
        bytes[i] ^= 0x55U;
        if ((i < 72U) || ((i >= 100U) && (i < 108U)) || (i >= 240U)) {
            TEST_ASSERT_EQUAL_HEX32(extended_by_bits(0U, bytes, FRAME_BYTES),
                                    crc32c_over_28_and_132(0U, bytes));
        }
        fill_quiet(bytes, 16U, 64U, 172U);
        bytes[i] ^= 0x55U;
        if ((i < 16U) || ((i >= 44U) && (i < 64U)) || (i >= 236U)) {
            TEST_ASSERT_EQUAL_HEX32(extended_by_bits(0U, bytes, FRAME_BYTES),
                                    crc32c_over_28_and_172(0U, bytes));
        }
    }
}
