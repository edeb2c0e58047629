/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: a load cell reads zero + slope times force once a millisecond, with noise,
 * drift, offset and latency, and fails as it is ordered to. */
#include "unity.h"

#include "sim/model/sim_load_cell.h"

#include <math.h>
#include <string.h>

#define ZERO 1780.0
#define STEP_US 100U
#define SECOND_STEPS 10000U
/* The published slope is 0.902478 of a unit a count, taken for gram-force. */
#define COUNTS_PER_N 112.9913

static sim_load_cell_config_t config;
static sim_load_cell_t cell;

void setUp(void)
{
    (void)memset(&config, 0, sizeof config);
    sim_load_cell_init(&cell, &config, ZERO, 7U);
}

void tearDown(void)
{
}

static uint32_t read_after(uint32_t steps, double force_n)
{
    for (uint32_t i = 0U; i < steps; i++) {
        sim_load_cell_step(&cell, STEP_US, force_n);
    }
    return cell.reading;
}

static void expect_reading(double expected_n, uint32_t steps, double force_n)
{
    TEST_ASSERT_DOUBLE_WITHIN(1.0, ZERO + COUNTS_PER_N * expected_n, read_after(steps, force_n));
}

void test_SWR_BOX_526_a_reading_is_the_force_by_the_slope(void)
{
    TEST_ASSERT_EQUAL_UINT32(1780U, cell.reading);
    for (double force = -15.0; force < 20.0; force += 0.7) {
        expect_reading(force, 10U, force);
    }
}

void test_SWR_BOX_526_it_reads_once_a_millisecond(void)
{
    TEST_ASSERT_EQUAL_UINT32(1780U, read_after(9U, 3.0));
    expect_reading(3.0, 1U, 3.0);
}

void test_SWR_BOX_526_a_reading_ends_at_the_ends_of_twelve_bits(void)
{
    TEST_ASSERT_EQUAL_UINT32(SIM_LOAD_CELL_MOST, read_after(10U, 21.0));
    TEST_ASSERT_EQUAL_UINT32(0U, read_after(10U, -16.0));
}

void test_SWR_BOX_526_noise_has_its_standard_deviation(void)
{
    double sum = 0.0;
    double squares = 0.0;

    config.noise_n = 0.1;
    sim_load_cell_init(&cell, &config, ZERO, 7U);
    for (uint32_t i = 0U; i < SECOND_STEPS; i++) {
        const double reading = read_after(10U, 0.0);
        sum += reading;
        squares += reading * reading;
    }
    const double mean = sum / SECOND_STEPS;
    TEST_ASSERT_DOUBLE_WITHIN(0.5, ZERO, mean);
    TEST_ASSERT_DOUBLE_WITHIN(0.3, 0.1 * COUNTS_PER_N, sqrt(squares / SECOND_STEPS - mean * mean));
}

void test_SWR_BOX_526_offset_and_drift_shift_the_zero(void)
{
    config.offset_n = 1.0;
    config.drift_n_per_s = -0.2;
    sim_load_cell_init(&cell, &config, ZERO, 7U);
    TEST_ASSERT_EQUAL_UINT32(1893U, cell.reading);
    expect_reading(1.0 - 0.2, SECOND_STEPS, 0.0);
    expect_reading(1.0 - 0.8 + 2.0, 3U * SECOND_STEPS, 2.0);
}

void test_SWR_BOX_526_a_force_is_read_after_the_latency(void)
{
    for (uint32_t latency = 0U; latency <= SIM_LOAD_CELL_LATENCY_MOST; latency++) {
        config.latency_ms = latency;
        sim_load_cell_init(&cell, &config, ZERO, 7U);
        TEST_ASSERT_EQUAL_UINT32(1780U, read_after(10U * latency, 2.0));
        expect_reading(2.0, 10U, 2.0);
    }
}

void test_SWR_BOX_526_the_same_seed_gives_the_same_readings(void)
{
    sim_load_cell_t other;
    uint32_t differences = 0U;

    config.noise_n = 0.05;
    sim_load_cell_init(&cell, &config, ZERO, 7U);
    sim_load_cell_init(&other, &config, ZERO, 7U);
    for (uint32_t i = 0U; i < SECOND_STEPS; i++) {
        sim_load_cell_step(&other, STEP_US, 1.0);
        TEST_ASSERT_EQUAL_UINT32(other.reading, read_after(1U, 1.0));
    }
    sim_load_cell_init(&other, &config, ZERO, 8U);
    for (uint32_t i = 0U; i < 100U; i++) {
        sim_load_cell_step(&other, SIM_LOAD_CELL_PERIOD_US, 1.0);
        differences += (other.reading != read_after(10U, 1.0)) ? 1U : 0U;
    }
    TEST_ASSERT_TRUE(differences > 50U);
}

void test_SWR_BOX_527_a_cell_that_is_stuck_keeps_its_reading_and_works_again(void)
{
    config.noise_n = 0.05;
    sim_load_cell_init(&cell, &config, ZERO, 7U);
    const uint32_t before = read_after(10U, 1.0);
    cell.fault = SIM_LOAD_CELL_STUCK;
    for (uint32_t i = 0U; i < 100U; i++) {
        TEST_ASSERT_EQUAL_UINT32(before, read_after(10U, 5.0));
    }
    cell.fault = SIM_LOAD_CELL_NORMAL;
    TEST_ASSERT_DOUBLE_WITHIN(40.0, ZERO + COUNTS_PER_N * 5.0, read_after(10U, 5.0));
}

void test_SWR_BOX_527_a_broken_wire_reads_nothing_or_all(void)
{
    cell.fault = SIM_LOAD_CELL_BROKEN;
    TEST_ASSERT_EQUAL_UINT32(0U, read_after(10U, 1.0));
    cell.fault = SIM_LOAD_CELL_FULL;
    TEST_ASSERT_EQUAL_UINT32(SIM_LOAD_CELL_MOST, read_after(10U, 1.0));
}

void test_SWR_BOX_527_a_zero_jumps_or_wanders(void)
{
    cell.fault = SIM_LOAD_CELL_STEP;
    expect_reading(1.0 + SIM_LOAD_CELL_STEP_N, 10U, 1.0);
    cell.fault = SIM_LOAD_CELL_NORMAL;
    expect_reading(1.0, 10U, 1.0);
    cell.fault = SIM_LOAD_CELL_DRIFT;
    expect_reading(1.0 + 3.0 * SIM_LOAD_CELL_DRIFT_N_PER_S, 3U * SECOND_STEPS, 1.0);
}

void test_SWR_BOX_527_a_noisy_cell_reads_far_from_the_force(void)
{
    uint32_t far = 0U;

    cell.fault = SIM_LOAD_CELL_NOISY;
    for (uint32_t i = 0U; i < 1000U; i++) {
        far += (fabs(read_after(10U, 0.0) - ZERO) > SIM_LOAD_CELL_NOISE_N * COUNTS_PER_N) ? 1U : 0U;
    }
    TEST_ASSERT_UINT32_WITHIN(60U, 320U, far);
}

void test_SWR_BOX_527_a_reading_may_be_set(void)
{
    sim_load_cell_set(&cell, 4000U);
    TEST_ASSERT_EQUAL_UINT32(4000U, cell.reading);
    TEST_ASSERT_EQUAL_UINT32(4000U, read_after(100U, 1.0));
    cell.fault = SIM_LOAD_CELL_NORMAL;
    expect_reading(1.0, 10U, 1.0);
}
