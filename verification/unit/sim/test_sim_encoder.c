/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: one count and one time stamp per edge, four unequal states whose sum is exact;
 * the scanner adds edges that nearly all cancel.
 */
#include "unity.h"

#include "sim/model/sim_encoder.h"
#include "sim/model/sim_motor.h"

#include <string.h>

static sim_encoder_t encoder;
static axis_config_t axis;
static double position;
static uint32_t now_us;

void setUp(void)
{
    (void)memset(&axis, 0, sizeof axis);
    position = 0.5;
    now_us = 1000U;
    sim_encoder_init(&encoder, &axis, position, 0, 1U);
}

void tearDown(void)
{
}

static void move_with(double ticks, uint32_t steps, bool is_scanning)
{
    for (uint32_t i = 0U; i < steps; i++) {
        const double next = position + ticks / (double)steps;
        sim_encoder_step(&encoder, position, next, now_us, is_scanning);
        position = next;
        now_us += SIM_STEP_US;
    }
}

static void move(double ticks, uint32_t steps)
{
    move_with(ticks, steps, false);
}

void test_SWR_BOX_004_it_counts_one_for_each_tick_up_and_down(void)
{
    move(1000.0, 777U);
    TEST_ASSERT_EQUAL_INT32(1000, sim_encoder_count(&encoder));
    move(-3000.0, 100U);
    TEST_ASSERT_EQUAL_INT32(-2000, sim_encoder_count(&encoder));
    TEST_ASSERT_EQUAL_UINT32(4000U, encoder.edges);
    sim_encoder_take_edges(&encoder);
    TEST_ASSERT_EQUAL_UINT32(0U, encoder.edges);
}

void test_SWR_BOX_004_it_starts_in_the_right_state_wherever_it_stands(void)
{
    for (int32_t start = -400; start < 400; start++) {
        position = (double)start / 40.0;
        sim_encoder_init(&encoder, &axis, position, 0, 1U);
        sim_encoder_step(&encoder, position, position, now_us, false);
        TEST_ASSERT_EQUAL_UINT32(0U, encoder.edges);
    }
}

void test_SWR_BOX_004_the_reading_wraps(void)
{
    sim_encoder_init(&encoder, &axis, position, INT32_MAX, 1U);
    move(1.0, 1U);
    TEST_ASSERT_EQUAL_INT32(INT32_MIN, sim_encoder_count(&encoder));
    move(-1.0, 1U);
    TEST_ASSERT_EQUAL_INT32(INT32_MAX, sim_encoder_count(&encoder));
}

void test_SWR_BOX_004_an_inverted_encoder_counts_down(void)
{
    axis.is_encoder_inverted = 1U;
    sim_encoder_init(&encoder, &axis, position, 0, 1U);
    move(10.0, 10U);
    TEST_ASSERT_EQUAL_INT32(-10, sim_encoder_count(&encoder));
}

void test_SWR_BOX_004_stamps_of_four_edges_give_the_exact_speed(void)
{
    move(50.0, 500U);
    TEST_ASSERT_UINT32_WITHIN(1U, 4000U, encoder.stamps_us[0] - encoder.stamps_us[4]);
    move(50.0, 20U);
    TEST_ASSERT_UINT32_WITHIN(1U, 160U, encoder.stamps_us[0] - encoder.stamps_us[4]);
}

void test_SWR_BOX_004_stamps_stay_when_the_shaft_stands(void)
{
    move(10.0, 100U);
    const uint32_t last_us = encoder.stamps_us[0];
    move(0.0, 1000U);
    TEST_ASSERT_EQUAL_UINT32(last_us, encoder.stamps_us[0]);
}

void test_SWR_BOX_004_single_states_are_unequal_by_a_tenth_rms(void)
{
    double sum = 0.0;

    for (int32_t i = 0; i < 4; i++) {
        const double width = 1.0 + encoder.edge_offsets[(i + 1) & 3] - encoder.edge_offsets[i];
        sum += (width - 1.0) * (width - 1.0);
    }
    TEST_ASSERT_INT_WITHIN(10, 1000, (int)(sum / 4.0 * 100000.0));
}

void test_SWR_BOX_004_a_stuck_encoder_counts_nothing_and_goes_on_when_repaired(void)
{
    encoder.fault = SIM_ENCODER_STUCK;
    move_with(100.0, 10000U, true);
    TEST_ASSERT_EQUAL_INT32(0, sim_encoder_count(&encoder));
    TEST_ASSERT_EQUAL_UINT32(0U, encoder.edges);
    encoder.fault = SIM_ENCODER_NORMAL;
    move(10.0, 10U);
    TEST_ASSERT_EQUAL_INT32(10, sim_encoder_count(&encoder));
}

void test_SWR_BOX_004_a_reversed_encoder_counts_the_other_way(void)
{
    encoder.fault = SIM_ENCODER_REVERSED;
    move(10.0, 10U);
    TEST_ASSERT_EQUAL_INT32(-10, sim_encoder_count(&encoder));
}

void test_SWR_BOX_004_without_the_scanner_there_are_no_wrong_edges(void)
{
    move(0.0, 600000U);
    TEST_ASSERT_EQUAL_UINT32(0U, encoder.edges);
    TEST_ASSERT_EQUAL_UINT32(0U, encoder.illegal_edges);
}

void test_SWR_BOX_004_the_scanner_adds_bursts_that_nearly_cancel(void)
{
    move_with(0.0, 600000U, true);
    TEST_ASSERT_INT32_WITHIN(15, 0, sim_encoder_count(&encoder));
    /* 60 s at 5 bursts a second of 10.5 edges on average, a tenth of them illegal. */
    TEST_ASSERT_UINT32_WITHIN(900U, 3000U, encoder.edges);
    TEST_ASSERT_UINT32_WITHIN(120U, 315U, encoder.illegal_edges);
}

void test_SWR_BOX_004_little_drift_remains_of_the_scanner_whatever_the_seed(void)
{
    for (uint32_t seed = 0U; seed < 20U; seed++) {
        sim_encoder_init(&encoder, &axis, position, 0, seed);
        move_with(0.0, 200000U, true);
        TEST_ASSERT_INT32_WITHIN(10, 0, sim_encoder_count(&encoder));
    }
}

void test_SWR_BOX_004_an_edge_lies_at_the_same_place_from_both_sides(void)
{
    int32_t counts[1000];

    for (uint32_t i = 0U; i < 1000U; i++) {
        counts[i] = sim_encoder_count(&encoder);
        move(0.01, 1U);
    }
    for (uint32_t i = 1000U; i > 0U; i--) {
        move(-0.01, 1U);
        TEST_ASSERT_EQUAL_INT32(counts[i - 1U], sim_encoder_count(&encoder));
    }
}

void test_SWR_BOX_004_the_scanner_moves_the_reading_by_one_at_most_at_a_time(void)
{
    int32_t before = 0;

    for (uint32_t i = 0U; i < 100000U; i++) {
        move_with(0.0, 1U, true);
        TEST_ASSERT_INT32_WITHIN(1, before, sim_encoder_count(&encoder));
        before = sim_encoder_count(&encoder);
    }
}

void test_SWR_BOX_004_noise_is_the_same_for_the_same_seed(void)
{
    sim_encoder_t first;

    move_with(0.0, 50000U, true);
    first = encoder;
    setUp();
    move_with(0.0, 50000U, true);
    TEST_ASSERT_EQUAL_MEMORY(&first.stamps_us, &encoder.stamps_us, sizeof first.stamps_us);
    TEST_ASSERT_TRUE(first.random.state == encoder.random.state);
}
