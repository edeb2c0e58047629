/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: the checksum of frames is CRC-32C. */
#include "crc.h"
#include "unity.h"

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

void test_SWR_CARD_002_every_table_entry_is_the_remainder_of_its_byte(void)
{
    for (uint32_t i = 0U; i < 256U; i++) {
        const uint8_t byte = (uint8_t)i;
        uint32_t expected = 0xFFFFFFFFU ^ i;
        for (int bit = 0; bit < 8; bit++) {
            expected =
                ((expected & 1U) != 0U) ? ((expected >> 1U) ^ 0x82F63B78U) : (expected >> 1U);
        }
        TEST_ASSERT_EQUAL_HEX32(expected ^ 0xFFFFFFFFU, crc32c(&byte, 1U));
    }
}
