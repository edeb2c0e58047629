/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the speed comes from the times of the edges.
 */
#include "unity.h"

#include "axis/encoder.h"
#include "limits/requirement_limits.h"
#include "sim/model/sim_encoder.h"
#include "sim/model/sim_motor.h"

#include <math.h>
#include <string.h>

#include "unit/axis/encoder_world.inc"

#define SPAN_US 6000U

static void quiet(uint32_t us)
{
    report.time_us += us;
    TEST_ASSERT_FALSE(encoder_step(&encoder, &config, &report));
}

static int32_t speed(void)
{
    return encoder.speed_ticks_per_s_q8;
}

void setUp(void)
{
    begin_encoder();
}

void tearDown(void)
{
}

void test_SWR_ENC_003_the_speed_is_way_by_time_of_the_edges(void)
{
    run(7, 20U);
    TEST_ASSERT_EQUAL_INT32(7000 * 256, speed());
    run(-3, 20U);
    TEST_ASSERT_EQUAL_INT32(-3000 * 256, speed());
}

void test_SWR_ENC_003_the_speed_has_the_sign_of_the_position(void)
{
    config.is_encoder_inverted = 1U;
    run(7, 20U);
    TEST_ASSERT_EQUAL_INT32(-7000 * 256, speed());
}

void test_SWR_ENC_003_the_time_is_that_of_the_edges_and_not_of_the_cycles(void)
{
    const uint32_t first_us = report.last_edge_us;

    report.time_us += 10000U;
    report.encoder_count += 8;
    report.last_edge_us = first_us + 9001U;
    (void)encoder_step(&encoder, &config, &report);
    /* 8 edges in 9001 us: 888.790 ticks/s. */
    TEST_ASSERT_EQUAL_INT32(227530, speed());
}

void test_SWR_ENC_003_fewer_than_six_milliseconds_of_edges_keep_the_last_speed(void)
{
    run(8, 6U);
    TEST_ASSERT_EQUAL_INT32(8000 * 256, speed());
    run(4, 5U);
    TEST_ASSERT_EQUAL_INT32(8000 * 256, speed());
    run(4, 1U);
    TEST_ASSERT_EQUAL_INT32(4000 * 256, speed());
}

void test_SWR_ENC_003_the_speed_is_rounded(void)
{
    report.time_us += 7000U;
    report.last_edge_us += SPAN_US + 7U;
    report.encoder_count += 4;
    (void)encoder_step(&encoder, &config, &report);
    /* 4 * 256e6 / 6007 = 170467.788 */
    TEST_ASSERT_EQUAL_INT32(170468, speed());
}

void test_SWR_ENC_003_the_speed_is_zero_at_the_timeout(void)
{
    run(7, 20U);
    quiet(LIMIT_SPEED_TIMEOUT_US);
    TEST_ASSERT_EQUAL_INT32(0, speed());
}

void test_SWR_ENC_003_an_axis_is_at_rest_from_the_timeout_to_the_next_edge(void)
{
    encoder_init(&encoder);
    TEST_ASSERT_FALSE(encoder_is_at_rest(&encoder));
    start_at(1000);
    run(7, 20U);
    quiet(LIMIT_SPEED_TIMEOUT_US - 1U);
    TEST_ASSERT_FALSE(encoder_is_at_rest(&encoder));
    quiet(1U);
    TEST_ASSERT_TRUE(encoder_is_at_rest(&encoder));
    quiet(1U);
    TEST_ASSERT_TRUE(encoder_is_at_rest(&encoder));
    run(1, 1U);
    TEST_ASSERT_FALSE(encoder_is_at_rest(&encoder));
}

void test_SWR_ENC_003_after_a_rest_the_first_speed_counts_from_its_first_edge(void)
{
    run(7, 20U);
    quiet(LIMIT_SPEED_TIMEOUT_US);
    quiet(899000U);
    TEST_ASSERT_FALSE(read(report.encoder_count + 1));
    TEST_ASSERT_EQUAL_INT32(0, speed());
    run(8, SPAN_US / 1000U);
    TEST_ASSERT_EQUAL_INT32(8000 * 256, speed());
}

void test_SWR_ENC_003_the_times_of_the_card_may_wrap(void)
{
    report.time_us = UINT32_MAX - 3500U;
    report.last_edge_us = report.time_us;
    start_at(0);
    run(8, 6U);
    TEST_ASSERT_EQUAL_INT32(8000 * 256, speed());
}

void test_SWR_ENC_003_setting_the_position_does_not_change_the_speed(void)
{
    run(7, 9U);
    encoder_set_position(&encoder, 100000);
    run(7, 3U);
    TEST_ASSERT_EQUAL_INT32(7000 * 256, speed());
}

void test_SWR_ENC_003_a_jump_does_not_enter_the_speed(void)
{
    run(8, 6U);
    (void)read(report.encoder_count + 4000);
    TEST_ASSERT_TRUE(read(report.encoder_count + 1));
    run(8, 6U);
    TEST_ASSERT_EQUAL_INT32(8000 * 256, speed());
}

/* Root mean square of the error at a constant speed, in ticks/s; every tenth cycle is 100 us
 * longer. */
static double noise_at(double ticks_per_s, uint32_t seed)
{
    sim_encoder_t shaft;
    axis_config_t axis = config;
    double place = 0.5;
    double sum = 0.0;
    uint32_t now_us = 1000U;
    const uint32_t cycles = 3000U;
    sim_encoder_init(&shaft, &axis, place, 0, seed);
    encoder_init(&encoder);
    (void)memset(&report, 0, sizeof report);
    for (uint32_t cycle = 0U; cycle < cycles; cycle++) {
        const uint32_t steps = (1000U / SIM_STEP_US) + (((cycle % 10U) == 0U) ? 1U : 0U);
        for (uint32_t i = 0U; i < steps; i++) {
            const double next = place + (ticks_per_s * (double)SIM_STEP_US * 1e-6);
            sim_encoder_step(&shaft, place, next, now_us, false);
            place = next;
            now_us += SIM_STEP_US;
        }
        report.time_us = now_us;
        report.last_edge_us = shaft.stamps_us[0];
        report.encoder_count = sim_encoder_count(&shaft);
        TEST_ASSERT_FALSE(encoder_step(&encoder, &config, &report));
        const double error = ((double)speed() / 256.0) - ticks_per_s;
        sum += (cycle >= (cycles / 2U)) ? (error * error) : 0.0;
    }
    return sqrt(sum / ((double)cycles / 2.0));
}

static void expect_noise_below(double ticks_per_s, uint32_t most_dticks_per_s)
{
    for (uint32_t seed = 1U; seed < 4U; seed++) {
        TEST_ASSERT_TRUE(noise_at(ticks_per_s, seed) * 10.0 <= (double)most_dticks_per_s);
        TEST_ASSERT_TRUE(noise_at(-ticks_per_s, seed) * 10.0 <= (double)most_dticks_per_s);
    }
}

void test_SWR_ENC_004_the_speed_of_a_cruise_has_little_noise(void)
{
    expect_noise_below((double)LIMIT_SPEED_CRUISE_TICKS_PER_S,
                       LIMIT_SPEED_CRUISE_NOISE_DTICKS_PER_S);
    expect_noise_below(2500.0 / 3.0, LIMIT_SPEED_CRUISE_NOISE_DTICKS_PER_S);
}

void test_SWR_ENC_004_the_speed_has_little_noise_from_slow_to_fast(void)
{
    for (double rate = (double)LIMIT_SPEED_NOISE_FROM_TICKS_PER_S;
         rate < (double)LIMIT_SPEED_NOISE_TO_TICKS_PER_S; rate *= 1.61) {
        expect_noise_below(rate, LIMIT_SPEED_NOISE_DTICKS_PER_S);
    }
    expect_noise_below((double)LIMIT_SPEED_NOISE_TO_TICKS_PER_S, LIMIT_SPEED_NOISE_DTICKS_PER_S);
}

void test_SWR_ENC_004_only_whole_cycles_of_four_states_count(void)
{
    run(1, 7U);
    TEST_ASSERT_EQUAL_INT32(0, speed());
    run(1, 1U);
    TEST_ASSERT_EQUAL_INT32(1000 * 256, speed());
}

void test_SWR_ENC_005_the_speed_stands_while_the_next_tick_may_be_late(void)
{
    run(8, 20U);
    quiet(LIMIT_SPEED_WAIT_PERCENT * 10U / 8U);
    TEST_ASSERT_EQUAL_INT32(8000 * 256, speed());
}

void test_SWR_ENC_005_then_it_is_that_of_a_tick_just_now(void)
{
    run(8, 20U);
    quiet((LIMIT_SPEED_WAIT_PERCENT * 10U / 8U) + 1U);
    TEST_ASSERT_EQUAL_INT32(256000000 / 188, speed());
    quiet(LIMIT_SPEED_TIMEOUT_US - 189U);
    TEST_ASSERT_EQUAL_INT32(2560, speed());
    run(-8, 20U);
    quiet(50000U);
    TEST_ASSERT_EQUAL_INT32(-5120, speed());
}

/* Mean of the speed that is reported of an axis that goes `burst_ticks` in `burst_us` and then
 * rests as long as it takes to be `ticks_per_s` fast in the mean, in percent of that. */
static double mean_of_bursts(double ticks_per_s, double burst_ticks, double burst_us)
{
    sim_encoder_t shaft;
    double place = 0.5;
    double sum = 0.0;
    uint32_t now_us = 1000U;
    const double period_us = burst_ticks * 1e6 / fabs(ticks_per_s);
    const double step = burst_ticks * SIM_STEP_US / burst_us * ((ticks_per_s < 0.0) ? -1.0 : 1.0);
    sim_encoder_init(&shaft, &config, place, 0, 1U);
    encoder_init(&encoder);
    (void)memset(&report, 0, sizeof report);
    for (uint32_t cycle = 0U; cycle < 2000U; cycle++) {
        for (uint32_t i = 0U; i < (1000U / SIM_STEP_US); i++) {
            const double next = place + ((fmod(now_us, period_us) < burst_us) ? step : 0.0);
            sim_encoder_step(&shaft, place, next, now_us, false);
            place = next;
            now_us += SIM_STEP_US;
        }
        report.time_us = now_us;
        report.last_edge_us = shaft.stamps_us[0];
        report.encoder_count = sim_encoder_count(&shaft);
        TEST_ASSERT_FALSE(encoder_step(&encoder, &config, &report));
        sum += (cycle >= 1000U) ? ((double)speed() / 256.0) : 0.0;
    }
    return sum / 1000.0 * 100.0 / ticks_per_s;
}

void test_SWR_ENC_010_a_late_tick_brings_back_no_more_than_the_way_since_the_measurement(void)
{
    run(8, 18U);
    quiet(49000U);
    run(1, 1U);
    /* Two ticks in 50 ms. */
    TEST_ASSERT_EQUAL_INT32(2 * 5120, speed());
    start_at(0);
    run(-8, 18U);
    quiet(49000U);
    run(-1, 1U);
    TEST_ASSERT_EQUAL_INT32(-2 * 5120, speed());
}

void test_SWR_ENC_010_a_clock_that_goes_back_changes_nothing(void)
{
    run(8, 18U);
    quiet(1000U);
    TEST_ASSERT_EQUAL_INT32(256000, speed());
    quiet(UINT32_MAX - 999U);
    TEST_ASSERT_EQUAL_INT32(256000, speed());
}

void test_SWR_ENC_010_the_speed_of_an_axis_in_bursts_is_right_in_the_mean(void)
{
    for (double burst = 1.1; burst <= (double)LIMIT_SPEED_BURST_TICKS; burst += 0.2) {
        for (double rate = 90.0; rate < 700.0; rate *= 1.37) {
            const double burst_us = 400000.0 * burst / rate;
            TEST_ASSERT_DOUBLE_WITHIN(LIMIT_SPEED_MEAN_PERCENT, 100.0,
                                      mean_of_bursts(rate, burst, burst_us));
            TEST_ASSERT_DOUBLE_WITHIN(LIMIT_SPEED_MEAN_PERCENT, 100.0,
                                      mean_of_bursts(-rate, burst, burst_us));
        }
    }
}
