/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a reading becomes a filtered force by slope and zero of its channel, and
 * whatever cannot be true of it makes the force doubtful by name, until the channel is zeroed.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "robot/robot_prostate.h"
#include "sensor/force_channel.h"

#include <math.h>
#include <stdlib.h>

#define PI 3.14159265358979323846
#define REST 1970U /* Of the hand. */
#define MN_PER_COUNT (0.902478 * 9.80665)
#define CYCLE_HZ 1000.0
#define SETTLED_CYCLES 200U

static force_channel_t channel;
static force_channel_config_t config;

void setUp(void)
{
    config = robot_prostate.force.channels[FORCE_CHANNEL_HAND];
    force_channel_init(&channel, &config);
}

void tearDown(void)
{
}

static uint32_t step(uint32_t reading)
{
    return force_channel_step(&channel, &config, reading, false);
}

/* `deviation` counts of noise, half of the readings above and half below `mean`. */
static force_readings_t readings_of(uint32_t mean, uint32_t deviation)
{
    force_readings_t readings = {0U, 0U};
    for (uint32_t i = 0U; i < LIMIT_FORCE_ZERO_CYCLES; i++) {
        const uint32_t count = ((i % 2U) == 0U) ? (mean + deviation) : (mean - deviation);
        readings.sum += count;
        readings.squares += count * count;
    }
    return readings;
}

static force_zero_end_t zero(uint32_t mean, uint32_t deviation, int32_t *moved_mn)
{
    const force_readings_t readings = readings_of(mean, deviation);
    return force_channel_zero(&channel, &config, &readings, moved_mn);
}

/* A channel that is zeroed where it rests, with so much noise, and reads that. */
static void begin_zeroed(uint32_t deviation)
{
    int32_t moved_mn = 0;
    (void)step(REST);
    TEST_ASSERT_EQUAL_INT(FORCE_ZERO_END_DONE, zero(REST, deviation, &moved_mn));
    TEST_ASSERT_TRUE(force_channel_is_believed(&channel));
}

void test_SWR_FORCE_563_a_force_is_doubtful_until_it_is_zeroed(void)
{
    int32_t moved_mn = 0;
    TEST_ASSERT_FALSE(force_channel_is_believed(&channel));
    TEST_ASSERT_EQUAL_HEX32(0U, step(REST));
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_NOT_ZEROED), channel.doubts);
    TEST_ASSERT_EQUAL_INT(FORCE_ZERO_END_DONE, zero(REST, 0U, &moved_mn));
    TEST_ASSERT_TRUE(force_channel_is_believed(&channel));
}

void test_SWR_FORCE_561_a_reading_is_a_force_by_slope_and_zero(void)
{
    begin_zeroed(0U);
    for (uint32_t reading = REST - 500U; reading <= (REST + 500U); reading += 100U) {
        for (uint32_t i = 0U; i < SETTLED_CYCLES; i++) {
            (void)step(reading);
        }
        const double force_mn = ((double)reading - (double)REST) * MN_PER_COUNT;
        TEST_ASSERT_INT32_WITHIN(1, (int32_t)force_mn, force_channel_mn(&channel, &config));
    }
}

void test_SWR_FORCE_561_a_falling_slope_turns_the_sign(void)
{
    config.mn_per_count_q16 = -config.mn_per_count_q16;
    begin_zeroed(2U);
    TEST_ASSERT_EQUAL_UINT32(17U, force_channel_noise_mn(&channel, &config));
    for (uint32_t i = 0U; i < SETTLED_CYCLES; i++) {
        (void)step(REST - 100U);
    }
    TEST_ASSERT_INT32_WITHIN(1, 885, force_channel_mn(&channel, &config));
}

/* The same filter in double precision, from the analogue prototype again. */
static double reference(double cutoff_hz, double x[3], double y[2])
{
    const double k = tan(PI * cutoff_hz / CYCLE_HZ);
    const double norm = 1.0 / (1.0 + (sqrt(2.0) * k) + (k * k));
    const double out = (norm * k * k * (x[0] + (2.0 * x[1]) + x[2])) -
                       (2.0 * norm * ((k * k) - 1.0) * y[0]) -
                       (norm * (1.0 - (sqrt(2.0) * k) + (k * k)) * y[1]);
    y[1] = y[0];
    y[0] = out;
    x[2] = x[1];
    x[1] = x[0];
    return out;
}

static void compare_with_reference(force_channel_id_t which, double cutoff_hz)
{
    config = robot_prostate.force.channels[which];
    force_channel_init(&channel, &config);
    double x[3] = {2000.0, 2000.0, 2000.0};
    double y[2] = {2000.0, 2000.0};
    srand(7);
    for (uint32_t i = 0U; i < 20000U; i++) {
        const uint32_t count = 2000U + (uint32_t)(rand() % 500) - (((i / 700U) % 2U) * 900U);
        x[0] = (i == 0U) ? 2000.0 : (double)count;
        (void)step((uint32_t)x[0]);
        const double wanted = reference(cutoff_hz, x, y);
        TEST_ASSERT_DOUBLE_WITHIN(0.01, wanted, (double)channel.outputs_q16[0] / 65536.0);
    }
}

void test_SWR_FORCE_562_the_filter_is_that_of_its_equation(void)
{
    compare_with_reference(FORCE_CHANNEL_HAND, 40.0);
    compare_with_reference(FORCE_CHANNEL_NEEDLE, 20.0);
}

void test_SWR_FORCE_562_a_reading_that_stays_is_shown_as_it_is(void)
{
    for (uint32_t reading = 700U; reading < 2900U; reading += 100U) {
        for (uint32_t i = 0U; i < (2U * SETTLED_CYCLES); i++) {
            (void)step(reading);
        }
        TEST_ASSERT_INT32_WITHIN(64, (int32_t)(reading * 65536U), channel.outputs_q16[0]);
    }
}

void test_SWR_FORCE_562_the_filter_begins_anew_after_a_stale_force(void)
{
    (void)step(REST);
    force_channel_miss(&channel);
    (void)step(REST + 400U);
    TEST_ASSERT_EQUAL_INT32((int32_t)((REST + 400U) * 65536U), channel.outputs_q16[0]);
    TEST_ASSERT_EQUAL_HEX32(0U, channel.doubts & force_doubt_bit(FORCE_DOUBT_STALE));
}

static uint32_t move_still(uint32_t cycles)
{
    uint32_t doubts = 0U;
    for (uint32_t i = 0U; i < cycles; i++) {
        doubts |= force_channel_step(&channel, &config, REST, true);
    }
    return doubts;
}

void test_SWR_FORCE_565_a_reading_that_stands_still_in_a_motion_is_stuck(void)
{
    begin_zeroed(2U);
    TEST_ASSERT_EQUAL_HEX32(0U, move_still(LIMIT_FORCE_STILL_CYCLES - 1U));
    TEST_ASSERT_TRUE(force_channel_is_believed(&channel));
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_STUCK), move_still(1U));
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_STUCK), channel.doubts);
}

void test_SWR_FORCE_565_any_change_and_any_rest_begins_the_time_anew(void)
{
    begin_zeroed(2U);
    TEST_ASSERT_EQUAL_HEX32(0U, move_still(LIMIT_FORCE_STILL_CYCLES - 1U));
    TEST_ASSERT_EQUAL_HEX32(0U, force_channel_step(&channel, &config, REST + 1U, true));
    TEST_ASSERT_EQUAL_HEX32(0U, move_still(LIMIT_FORCE_STILL_CYCLES));
    TEST_ASSERT_EQUAL_HEX32(0U, step(REST));
    TEST_ASSERT_EQUAL_HEX32(0U, move_still(LIMIT_FORCE_STILL_CYCLES - 1U));
}

void test_SWR_FORCE_565_a_channel_with_hardly_any_noise_may_stand_still(void)
{
    begin_zeroed(1U);
    TEST_ASSERT_EQUAL_UINT32(LIMIT_FORCE_STILL_NOISE, channel.noise_q8);
    TEST_ASSERT_EQUAL_HEX32(0U, move_still(10U * LIMIT_FORCE_STILL_CYCLES));
}

void test_SWR_COOP_750_a_quiet_channel_is_still_until_its_reading_changes(void)
{
    begin_zeroed(1U);
    (void)move_still(LIMIT_FORCE_STILL_CYCLES - 1U);
    TEST_ASSERT_FALSE(force_channel_is_still(&channel));
    (void)move_still(2U);
    TEST_ASSERT_TRUE(force_channel_is_still(&channel));
    (void)force_channel_step(&channel, &config, REST + 1U, true);
    TEST_ASSERT_FALSE(force_channel_is_still(&channel));
}

void test_SWR_FORCE_566_a_reading_outside_of_the_range_is_doubted(void)
{
    begin_zeroed(0U);
    config.step_counts = 4095U;
    TEST_ASSERT_EQUAL_HEX32(0U, step(config.maximum_count));
    TEST_ASSERT_EQUAL_HEX32(0U, step(config.minimum_count));
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_OUT_OF_RANGE),
                            step(config.maximum_count + 1U));
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_OUT_OF_RANGE),
                            step(config.minimum_count - 1U));
}

void test_SWR_FORCE_567_a_reading_that_jumps_is_doubted(void)
{
    begin_zeroed(0U);
    TEST_ASSERT_DOUBLE_WITHIN(MN_PER_COUNT, LIMIT_FORCE_STEP_MN,
                              (double)config.step_counts * MN_PER_COUNT);
    TEST_ASSERT_EQUAL_HEX32(0U, step(REST + config.step_counts));
    TEST_ASSERT_EQUAL_HEX32(0U, step(REST));
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_STEP),
                            step(REST + config.step_counts + 1U));
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_STEP), step(REST));
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_STEP), channel.doubts);
}

void test_SWR_FORCE_568_no_and_full_reading_are_a_broken_wire(void)
{
    static const uint32_t broken[] = {0U, FORCE_CHANNEL_FULL_SCALE, 4096U, 65535U};
    for (uint32_t i = 0U; i < (sizeof broken / sizeof broken[0]); i++) {
        force_channel_init(&channel, &config);
        TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_BROKEN_WIRE) |
                                    force_doubt_bit(FORCE_DOUBT_OUT_OF_RANGE),
                                step(broken[i]));
    }
    TEST_ASSERT_EQUAL_HEX32(0U, step(1U) & force_doubt_bit(FORCE_DOUBT_BROKEN_WIRE));
    TEST_ASSERT_EQUAL_HEX32(0U, step(4094U) & force_doubt_bit(FORCE_DOUBT_BROKEN_WIRE));
}

void test_SWR_FORCE_570_a_zero_far_from_the_one_before_is_not_taken(void)
{
    int32_t moved_mn = 0;
    const uint32_t far = (uint32_t)(LIMIT_FORCE_WANDER_MN / MN_PER_COUNT) + 2U;
    (void)step(REST);
    TEST_ASSERT_EQUAL_INT(FORCE_ZERO_END_WANDERED, zero(REST + far, 0U, &moved_mn));
    TEST_ASSERT_GREATER_THAN_INT32((int32_t)LIMIT_FORCE_WANDER_MN, moved_mn);
    TEST_ASSERT_EQUAL_INT(FORCE_ZERO_END_WANDERED, zero(REST - far, 0U, &moved_mn));
    TEST_ASSERT_LESS_THAN_INT32(-(int32_t)LIMIT_FORCE_WANDER_MN, moved_mn);
    TEST_ASSERT_EQUAL_INT32(0, force_channel_zero_mn(&channel, &config));
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_NOT_ZEROED) |
                                force_doubt_bit(FORCE_DOUBT_ZERO_WANDERED),
                            channel.doubts);
    TEST_ASSERT_EQUAL_INT(FORCE_ZERO_END_DONE, zero(REST + far - 2U, 0U, &moved_mn));
}

void test_SWR_FORCE_611_small_steps_of_the_zero_do_not_add_up(void)
{
    int32_t moved_mn = 0;
    const uint32_t most = (uint32_t)(LIMIT_FORCE_DRIFT_MN / MN_PER_COUNT);
    (void)step(REST);
    TEST_ASSERT_EQUAL_INT(FORCE_ZERO_END_DONE, zero(REST + 50U, 0U, &moved_mn));
    TEST_ASSERT_EQUAL_INT32(442, moved_mn);
    TEST_ASSERT_EQUAL_INT(FORCE_ZERO_END_DONE, zero(REST + 50U + most, 0U, &moved_mn));
    TEST_ASSERT_EQUAL_INT(FORCE_ZERO_END_WANDERED, zero(REST + 51U + most, 0U, &moved_mn));
    TEST_ASSERT_EQUAL_INT32(8, moved_mn);
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_ZERO_WANDERED), channel.doubts);
    TEST_ASSERT_EQUAL_INT32((int32_t)((REST + 50U + most) * 65536U), channel.zero_q16);
    TEST_ASSERT_EQUAL_INT(FORCE_ZERO_END_DONE, zero(REST + 50U - most, 0U, &moved_mn));
    TEST_ASSERT_EQUAL_INT(FORCE_ZERO_END_WANDERED, zero(REST + 49U - most, 0U, &moved_mn));
}

void test_SWR_FORCE_571_a_zeroing_ends_all_doubts_and_nothing_else_does(void)
{
    int32_t moved_mn = 0;
    begin_zeroed(0U);
    (void)step(0U);
    for (uint32_t i = 0U; i < SETTLED_CYCLES; i++) {
        (void)step(REST);
    }
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_OUT_OF_RANGE) |
                                force_doubt_bit(FORCE_DOUBT_BROKEN_WIRE) |
                                force_doubt_bit(FORCE_DOUBT_STEP),
                            channel.doubts);
    TEST_ASSERT_EQUAL_INT(FORCE_ZERO_END_DONE, zero(REST, 0U, &moved_mn));
    TEST_ASSERT_EQUAL_HEX32(0U, channel.doubts);
}

void test_SWR_FORCE_572_the_mean_is_the_zero_and_the_deviation_the_noise(void)
{
    int32_t moved_mn = 0;
    (void)step(REST);
    TEST_ASSERT_EQUAL_UINT32(0U, force_channel_noise_mn(&channel, &config));
    TEST_ASSERT_EQUAL_INT(FORCE_ZERO_END_DONE, zero(REST + 10U, 3U, &moved_mn));
    TEST_ASSERT_EQUAL_INT32((int32_t)((REST + 10U) * 65536U), channel.zero_q16);
    TEST_ASSERT_EQUAL_INT32(88, moved_mn);
    TEST_ASSERT_EQUAL_UINT32(3U * 256U, channel.noise_q8);
    TEST_ASSERT_EQUAL_UINT32(26U, force_channel_noise_mn(&channel, &config));
}

void test_SWR_FORCE_574_trembling_readings_are_no_zero(void)
{
    int32_t moved_mn = 0;
    (void)step(REST);
    TEST_ASSERT_EQUAL_INT(FORCE_ZERO_END_NOISY, zero(REST, 40U, &moved_mn));
    TEST_ASSERT_EQUAL_HEX32(force_doubt_bit(FORCE_DOUBT_NOT_ZEROED), channel.doubts);
    TEST_ASSERT_EQUAL_INT(FORCE_ZERO_END_DONE, zero(REST, 30U, &moved_mn));
}

void test_SWR_FORCE_574_the_greatest_noise_that_is_told_is_too_much(void)
{
    int32_t moved_mn = 0;
    (void)step(REST);
    TEST_ASSERT_EQUAL_INT(FORCE_ZERO_END_NOISY, zero(2000U, 1900U, &moved_mn));
    TEST_ASSERT_EQUAL_UINT32(UINT16_MAX, channel.noise_q8);
}
