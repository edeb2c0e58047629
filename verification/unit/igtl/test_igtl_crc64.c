/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: the checksum is the remainder of the bytes, as their bits are divided one by
 * one.
 */
#include "igtl/wire/igtl_crc64.h"
#include "unity.h"

#include <stdint.h>

#define BYTES 300U

static uint8_t bytes[BYTES];

void setUp(void)
{
    uint32_t seed = 1U;

    for (uint32_t i = 0U; i < BYTES; i++) {
        seed = (seed * 1664525U) + 1013904223U;
        bytes[i] = (uint8_t)(seed >> 24U);
    }
}

void tearDown(void)
{
}

static uint64_t divided_bit_by_bit(const uint8_t *from, uint32_t length)
{
    uint64_t rest = 0U;

    for (uint32_t i = 0U; i < length; i++) {
        rest ^= (uint64_t)from[i] << 56U;
        for (uint32_t bit = 0U; bit < 8U; bit++) {
            rest = (rest << 1U) ^ (((rest >> 63U) != 0U) ? UINT64_C(0x42F0E1EBA9EA3693) : 0U);
        }
    }
    return rest;
}

void test_SWR_IGTL_002_checksum_has_the_check_value_of_ecma_182(void)
{
    TEST_ASSERT_EQUAL_HEX64(0U, igtl_crc64(0U, NULL, 0U));
    TEST_ASSERT_EQUAL_HEX64(UINT64_C(0x6C40DF5F0B497347),
                            igtl_crc64(0U, (const uint8_t *)"123456789", 9U));
}

void test_SWR_IGTL_002_each_byte_has_its_remainder_at_each_place_of_a_word(void)
{
    for (uint32_t place = 0U; place < 8U; place++) {
        for (uint32_t value = 0U; value < 256U; value++) {
            uint8_t word[8] = {0U};

            word[place] = (uint8_t)value;
            TEST_ASSERT_EQUAL_HEX64(divided_bit_by_bit(word, 8U), igtl_crc64(0U, word, 8U));
        }
    }
}

void test_SWR_IGTL_002_each_length_at_each_place_has_its_checksum(void)
{
    for (uint32_t begin = 0U; begin < 9U; begin++) {
        for (uint32_t length = 0U; length <= (BYTES - begin); length++) {
            TEST_ASSERT_EQUAL_HEX64(divided_bit_by_bit(&bytes[begin], length),
                                    igtl_crc64(0U, &bytes[begin], length));
        }
    }
}

void test_SWR_IGTL_002_checksum_goes_on_where_it_was(void)
{
    for (uint32_t first = 0U; first <= 40U; first++) {
        const uint64_t begun = igtl_crc64(0U, bytes, first);

        TEST_ASSERT_EQUAL_HEX64(divided_bit_by_bit(bytes, 40U),
                                igtl_crc64(begun, &bytes[first], 40U - first));
    }
}
