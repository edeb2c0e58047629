/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the position follows the counter in the configured direction over its wrap;
 * readings that jump are not believed.
 */
#include "unity.h"

#include "axis/encoder.h"
#include "base/fixed.h"

#include <stddef.h>

#include "unit/axis/encoder_world.inc"

void setUp(void)
{
    begin_encoder();
}

void tearDown(void)
{
}

void test_SWR_ENC_001_the_first_reading_is_a_reference_and_no_way(void)
{
    start_at(INT32_MIN);
    start_at(INT32_MAX);
    TEST_ASSERT_FALSE(read(INT32_MAX - 1));
    TEST_ASSERT_EQUAL_INT32(-1, encoder.position_ticks);
}

void test_SWR_ENC_001_the_position_follows_the_reading(void)
{
    (void)read(1007);
    TEST_ASSERT_EQUAL_INT32(7, encoder.position_ticks);
    (void)read(1007);
    TEST_ASSERT_EQUAL_INT32(7, encoder.position_ticks);
    (void)read(995);
    TEST_ASSERT_EQUAL_INT32(-5, encoder.position_ticks);
}

void test_SWR_ENC_001_an_inverted_encoder_counts_the_other_way(void)
{
    config.is_encoder_inverted = 1U;
    (void)read(1007);
    TEST_ASSERT_EQUAL_INT32(-7, encoder.position_ticks);
    (void)read(995);
    TEST_ASSERT_EQUAL_INT32(5, encoder.position_ticks);
}

void test_SWR_ENC_001_the_counter_may_wrap_upwards(void)
{
    start_at(INT32_MAX - 2);
    (void)read(INT32_MIN + 4);
    TEST_ASSERT_EQUAL_INT32(7, encoder.position_ticks);
    config.is_encoder_inverted = 1U;
    start_at(INT32_MAX - 2);
    (void)read(INT32_MIN + 4);
    TEST_ASSERT_EQUAL_INT32(-7, encoder.position_ticks);
}

void test_SWR_ENC_001_the_counter_may_wrap_downwards(void)
{
    start_at(INT32_MIN + 2);
    (void)read(INT32_MAX - 4);
    TEST_ASSERT_EQUAL_INT32(-7, encoder.position_ticks);
    config.is_encoder_inverted = 1U;
    start_at(INT32_MIN + 2);
    (void)read(INT32_MAX - 4);
    TEST_ASSERT_EQUAL_INT32(7, encoder.position_ticks);
}

void test_SWR_ENC_001_the_counter_may_wrap_in_the_middle_of_a_long_way(void)
{
    start_at(INT32_MAX - 100);
    run(JUMP, 50U);
    TEST_ASSERT_EQUAL_INT32(50 * JUMP, encoder.position_ticks);
    run(-JUMP, 100U);
    TEST_ASSERT_EQUAL_INT32(-50 * JUMP, encoder.position_ticks);
}

void test_SWR_ENC_001_the_position_is_set_and_counts_on_from_there(void)
{
    (void)read(1007);
    encoder_set_position(&encoder, -300);
    TEST_ASSERT_EQUAL_INT32(-300, encoder.position_ticks);
    (void)read(1010);
    TEST_ASSERT_EQUAL_INT32(-297, encoder.position_ticks);
}

void test_SWR_ENC_001_the_position_saturates(void)
{
    encoder_set_position(&encoder, INT32_MAX - 3);
    (void)read(1010);
    TEST_ASSERT_EQUAL_INT32(INT32_MAX, encoder.position_ticks);
    encoder_set_position(&encoder, INT32_MIN + 3);
    (void)read(1000);
    TEST_ASSERT_EQUAL_INT32(INT32_MIN, encoder.position_ticks);
}

void test_SWR_ENC_001_without_a_report_the_position_stands(void)
{
    (void)read(1007);
    TEST_ASSERT_FALSE(encoder_step(&encoder, &config, NULL));
    TEST_ASSERT_EQUAL_INT32(7, encoder.position_ticks);
    (void)read(1009);
    TEST_ASSERT_EQUAL_INT32(9, encoder.position_ticks);
}

void test_SWR_ENC_001_without_a_report_there_is_no_reference(void)
{
    encoder_init(&encoder);
    TEST_ASSERT_FALSE(encoder_step(&encoder, &config, NULL));
    (void)read(5000);
    TEST_ASSERT_EQUAL_INT32(0, encoder.position_ticks);
}

void test_SWR_ENC_002_the_largest_change_is_believed(void)
{
    (void)read(1000 + JUMP);
    TEST_ASSERT_EQUAL_INT32(JUMP, encoder.position_ticks);
    (void)read(1000);
    TEST_ASSERT_EQUAL_INT32(0, encoder.position_ticks);
}

void test_SWR_ENC_002_one_larger_change_is_ignored(void)
{
    TEST_ASSERT_FALSE(read(1000 + JUMP + 1));
    TEST_ASSERT_EQUAL_INT32(0, encoder.position_ticks);
    TEST_ASSERT_EQUAL_INT32(JUMP + 1, encoder.jump_ticks);
    TEST_ASSERT_FALSE(read(1003));
    TEST_ASSERT_EQUAL_INT32(3, encoder.position_ticks);
    TEST_ASSERT_FALSE(read(1002 - JUMP));
    TEST_ASSERT_EQUAL_INT32(3, encoder.position_ticks);
    TEST_ASSERT_EQUAL_INT32(-JUMP - 1, encoder.jump_ticks);
}

void test_SWR_ENC_002_the_second_in_a_row_is_a_fault(void)
{
    TEST_ASSERT_FALSE(read(1000 - JUMP - 1));
    TEST_ASSERT_TRUE(read(1000 - JUMP - 1));
    TEST_ASSERT_EQUAL_INT32(0, encoder.position_ticks);
}

void test_SWR_ENC_002_a_believed_reading_begins_the_row_anew(void)
{
    for (uint32_t i = 0U; i < 10U; i++) {
        TEST_ASSERT_FALSE(read(5000));
        TEST_ASSERT_FALSE(read(1000));
    }
    TEST_ASSERT_EQUAL_INT32(0, encoder.position_ticks);
}

void test_SWR_ENC_002_after_a_fault_the_new_reading_is_the_reference(void)
{
    (void)read(5000);
    TEST_ASSERT_TRUE(read(5000));
    TEST_ASSERT_FALSE(read(5002));
    TEST_ASSERT_EQUAL_INT32(2, encoder.position_ticks);
    TEST_ASSERT_FALSE(read(9000));
    TEST_ASSERT_TRUE(read(9000));
}

void test_SWR_ENC_002_a_cycle_without_report_doubles_what_is_believed(void)
{
    (void)encoder_step(&encoder, &config, NULL);
    TEST_ASSERT_FALSE(read(1000 + 2 * JUMP));
    TEST_ASSERT_EQUAL_INT32(2 * JUMP, encoder.position_ticks);
    (void)encoder_step(&encoder, &config, NULL);
    TEST_ASSERT_FALSE(read(1000 - 1));
    TEST_ASSERT_EQUAL_INT32(2 * JUMP, encoder.position_ticks);
}

void test_SWR_ENC_002_believed_readings_end_the_allowance_for_missed_cycles(void)
{
    (void)encoder_step(&encoder, &config, NULL);
    (void)read(1000);
    (void)read(1000 + JUMP + 1);
    TEST_ASSERT_EQUAL_INT32(0, encoder.position_ticks);
}

void test_SWR_ENC_002_a_fault_ends_the_allowance_for_missed_cycles(void)
{
    (void)encoder_step(&encoder, &config, NULL);
    (void)read(5000);
    TEST_ASSERT_TRUE(read(5000));
    (void)read(5000 + JUMP + 1);
    TEST_ASSERT_EQUAL_INT32(0, encoder.position_ticks);
}

void test_SWR_ENC_002_a_cycle_without_report_does_not_interrupt_the_row(void)
{
    (void)read(5000);
    (void)encoder_step(&encoder, &config, NULL);
    TEST_ASSERT_TRUE(read(5000));
}

void test_SWR_ENC_002_missed_cycles_saturate(void)
{
    encoder.missed_cycles = UINT32_MAX - 1U;
    (void)encoder_step(&encoder, &config, NULL);
    TEST_ASSERT_EQUAL_UINT32(UINT32_MAX, encoder.missed_cycles);
    (void)encoder_step(&encoder, &config, NULL);
    TEST_ASSERT_EQUAL_UINT32(UINT32_MAX, encoder.missed_cycles);
    /* So long a silence makes any reading believable. */
    TEST_ASSERT_FALSE(read(INT32_MIN));
    TEST_ASSERT_EQUAL_INT32((int32_t)(INT32_C(2147483647) - 999), encoder.position_ticks);
}

void test_SWR_ENC_002_half_a_turn_of_the_counter_is_not_believed(void)
{
    start_at(0);
    TEST_ASSERT_FALSE(read(INT32_MIN));
    TEST_ASSERT_EQUAL_INT32(INT32_MIN, encoder.jump_ticks);
    TEST_ASSERT_FALSE(read(-1));
    TEST_ASSERT_EQUAL_INT32(-1, encoder.position_ticks);
}
