/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: a seal reveals every change within one word. */
#include "base/seal.h"
#include "unity.h"

#include <string.h>

/* A step of sixteen, one of four, and three of one. */
#define WORDS 23U

static uint32_t words[WORDS];

void setUp(void)
{
    for (uint32_t i = 0U; i < WORDS; i++) {
        words[i] = i * 2654435761U;
    }
}

void tearDown(void)
{
}

static uint32_t seal_of_words(uint32_t count)
{
    return seal_of(SEAL_START, (const uint8_t *)words, count * sizeof words[0]);
}

void test_SWR_MEMORY_001_the_seal_is_a_sum_that_is_rotated_before_each_word(void)
{
    static const uint32_t two[2] = {0x00000003U, 0xFFFFFFFFU};
    /* 0x80000001 rotated by 5 is 0x30, and 3 is 0x33; rotated it is 0x660, less 1. */
    TEST_ASSERT_EQUAL_HEX32(0x33U, seal_of(0x80000001U, (const uint8_t *)two, 4U));
    TEST_ASSERT_EQUAL_HEX32(0x65FU, seal_of(0x80000001U, (const uint8_t *)two, 8U));
    TEST_ASSERT_EQUAL_HEX32(SEAL_START, seal_of(SEAL_START, (const uint8_t *)two, 0U));
}

void test_SWR_MEMORY_001_a_seal_goes_on_where_it_was_left(void)
{
    for (uint32_t first = 0U; first < WORDS; first++) {
        const uint32_t head = seal_of_words(first);
        TEST_ASSERT_EQUAL_HEX32(seal_of_words(WORDS), seal_of(head, (const uint8_t *)&words[first],
                                                              (WORDS - first) * sizeof words[0]));
    }
}

void test_SWR_MEMORY_001_any_one_to_three_bits_of_any_word_change_the_seal(void)
{
    const uint32_t sound = seal_of_words(WORDS);
    for (uint32_t word = 0U; word < WORDS; word++) {
        for (uint32_t bits = 0U; bits < (32U * 32U * 32U); bits++) {
            const uint32_t mask = ((uint32_t)1U << (bits % 32U)) |
                                  ((uint32_t)1U << ((bits / 32U) % 32U)) |
                                  ((uint32_t)1U << (bits / 1024U));
            words[word] ^= mask;
            TEST_ASSERT_TRUE(sound != seal_of_words(WORDS));
            words[word] ^= mask;
        }
    }
}

void test_SWR_MEMORY_001_cleared_memory_does_not_fit_a_cleared_seal(void)
{
    for (uint32_t count = 1U; count <= WORDS; count++) {
        (void)memset(words, 0, sizeof words);
        TEST_ASSERT_TRUE(seal_of_words(count) != 0U);
        (void)memset(words, 0xFF, sizeof words);
        TEST_ASSERT_TRUE(seal_of_words(count) != UINT32_MAX);
    }
}
