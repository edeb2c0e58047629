/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: outputs that differ in any bit have another proof, which names the part.
 */
#include "unity.h"

#include "recording/format/proof.h"

#include <string.h>

static prover_t recorder;
static prover_t replay;
static uint32_t words[CYCLE_WORDS_CHECKED];
static uint32_t others[CYCLE_WORDS_CHECKED];
static proof_t proof;
static proof_t other;

void setUp(void)
{
    prover_begin(&recorder);
    prover_begin(&replay);
    (void)memset(words, 0, sizeof(words));
    (void)memset(others, 0, sizeof(others));
}

void tearDown(void)
{
}

/* The part in which the proofs of the cycle differ. */
static uint32_t take(void)
{
    prover_take(&recorder, 1000U, words, &proof);
    prover_take(&replay, 1000U, others, &other);
    return proof_difference(&proof, &other);
}

static uint32_t part_of(uint32_t word)
{
    return (word < CYCLE_WORDS_SNAPSHOT)
               ? PROOF_SNAPSHOT
               : (PROOF_FRAMES +
                  ((word - (uint32_t)CYCLE_WORDS_SNAPSHOT) / (uint32_t)CYCLE_WORDS_FRAME));
}

/* Every word changes in each cycle, so that all parts are hashed. */
static void change_all(void)
{
    for (uint32_t i = 0U; i < CYCLE_WORDS_CHECKED; i++) {
        words[i] = (words[i] * 1664525U) + 1013904223U + i;
        others[i] = words[i];
    }
}

void test_SWR_REPLAY_004_a_bit_of_any_word_is_found_in_its_part(void)
{
    for (uint32_t i = 0U; i < CYCLE_WORDS_CHECKED; i++) {
        setUp();
        change_all();
        TEST_ASSERT_EQUAL_UINT32(PROOF_PARTS, take());
        change_all();
        others[i] ^= 1UL << (i % 32U);
        TEST_ASSERT_EQUAL_UINT32(part_of(i), take());
    }
}

void test_SWR_REPLAY_004_a_bit_of_a_word_that_stood_still_is_found_with_what_it_was(void)
{
    for (uint32_t i = 0U; i < CYCLE_WORDS_CHECKED; i++) {
        setUp();
        words[i] = 5U;
        others[i] = 5U;
        for (uint32_t cycle = 0U; cycle < 3U; cycle++) {
            TEST_ASSERT_EQUAL_UINT32(PROOF_PARTS, take());
        }
        others[i] ^= 1UL << (i % 32U);
        const uint32_t part = take();
        TEST_ASSERT_EQUAL_UINT32(part_of(i), part);
        TEST_ASSERT_EQUAL_HEX32(0U, proof.surprises);
        TEST_ASSERT_EQUAL_UINT32(5U, replay.surprises[part].expected);
    }
}

void test_SWR_REPLAY_004_a_difference_stays_in_the_hash_of_its_part(void)
{
    change_all();
    (void)take();
    change_all();
    others[0] ^= 1U;
    TEST_ASSERT_EQUAL_UINT32(PROOF_SNAPSHOT, take());
    for (uint32_t i = 0U; i < 100U; i++) {
        change_all();
        TEST_ASSERT_EQUAL_UINT32(PROOF_SNAPSHOT, take());
    }
}

void test_SWR_REPLAY_004_the_same_difference_twice_does_not_cancel_itself(void)
{
    change_all();
    (void)take();
    for (uint32_t i = 0U; i < 2U; i++) {
        change_all();
        others[3] ^= 4U;
        TEST_ASSERT_EQUAL_UINT32(PROOF_SNAPSHOT, take());
    }
}
