/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: the noise is the standard deviation of the filtered force at rest, here computed
 * in double precision, and for white noise what is known to pass the filter.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "sensor/membrane_noise.h"
#include "sim/model/sim_random.h"

#include <math.h>
#include <string.h>

#define ALL_MS (LIMIT_MEMBRANE_SETTLE_MS + LIMIT_MEMBRANE_NOISE_MS)

static membrane_noise_t noise;
static membrane_filter_t filter;
static sim_random_t chance;
/* In mN, and their squares. */
static double sum;
static double squares;

void setUp(void)
{
    (void)memset(&noise, 0, sizeof noise);
    (void)memset(&filter, 0, sizeof filter);
    chance.state = 7U;
    sum = 0.0;
    squares = 0.0;
}

void tearDown(void)
{
}

static void take(uint32_t at_ms, int32_t force_mn)
{
    const double out_mn = (double)membrane_filter_step(&filter, force_mn) / (double)MEMBRANE_MN_Q12;
    if (at_ms >= LIMIT_MEMBRANE_SETTLE_MS) {
        sum += out_mn;
        squares += out_mn * out_mn;
    }
    membrane_noise_step(&noise, force_mn);
}

static double true_un(void)
{
    const double n = (double)LIMIT_MEMBRANE_NOISE_MS;
    return 1000.0 * sqrt((squares / n) - (sum / n * sum / n));
}

/* Nearly normal, with a standard deviation of `deviation_mn`. */
static int32_t white_mn(double deviation_mn)
{
    double value = 0.0;
    for (uint32_t i = 0U; i < 4U; i++) {
        value += sim_random_signed(&chance);
    }
    return (int32_t)lrint(deviation_mn * value * sqrt(0.75));
}

void test_SWR_PUNCT_542_slow_noise_is_measured_as_it_leaves_the_filter(void)
{
    for (uint32_t i = 0U; i < ALL_MS; i++) {
        TEST_ASSERT_FALSE(membrane_noise_is_done(&noise));
        take(i, 500 + (int32_t)lrint(80.0 * sin(0.02 * i) + 60.0 * sin(0.05 * i)));
    }
    TEST_ASSERT_TRUE(membrane_noise_is_done(&noise));
    TEST_ASSERT_DOUBLE_WITHIN(2.0, true_un(), (double)membrane_noise_un(&noise));
    TEST_ASSERT_GREATER_THAN_UINT32(60000U, membrane_noise_un(&noise));
}

void test_SWR_PUNCT_542_white_noise_is_never_taken_for_less_than_passes(void)
{
    const double passes_un = 100000.0 * (double)LIMIT_MEMBRANE_WHITE_PERMILLE / 1000.0;
    for (uint32_t k = 0U; k < 50U; k++) {
        (void)memset(&noise, 0, sizeof noise);
        for (uint32_t i = 0U; i < ALL_MS; i++) {
            membrane_noise_step(&noise, white_mn(100.0));
        }
        TEST_ASSERT_GREATER_THAN_DOUBLE(0.93 * passes_un, (double)membrane_noise_un(&noise));
        TEST_ASSERT_LESS_THAN_DOUBLE(1.4 * passes_un, (double)membrane_noise_un(&noise));
    }
}

void test_SWR_PUNCT_542_share_of_white_noise_is_that_of_the_filter(void)
{
    double share2 = 0.0;
    (void)membrane_filter_step(&filter, 0);
    for (uint32_t i = 0U; i < 2000U; i++) {
        const double h =
            (double)membrane_filter_step(&filter, (i == 0U) ? 100000 : 0) / 100000.0 / 4096.0;
        share2 += h * h;
    }
    TEST_ASSERT_DOUBLE_WITHIN(0.001, sqrt(share2), (double)LIMIT_MEMBRANE_WHITE_PERMILLE / 1000.0);
}

void test_SWR_PUNCT_542_before_its_end_there_is_none_and_nothing_counts_after_it(void)
{
    for (uint32_t i = 0U; i < (ALL_MS - 1U); i++) {
        take(i, white_mn(300.0));
    }
    TEST_ASSERT_EQUAL_UINT32(0U, membrane_noise_un(&noise));
    take(ALL_MS - 1U, white_mn(300.0));
    const uint32_t measured_un = membrane_noise_un(&noise);
    for (uint32_t i = 0U; i < 100U; i++) {
        membrane_noise_step(&noise, 100000);
    }
    TEST_ASSERT_GREATER_THAN_UINT32(0U, measured_un);
    TEST_ASSERT_EQUAL_UINT32(measured_un, membrane_noise_un(&noise));
}

void test_SWR_PUNCT_542_a_force_that_stays_has_no_noise(void)
{
    for (uint32_t i = 0U; i < ALL_MS; i++) {
        membrane_noise_step(&noise, -98765);
    }
    TEST_ASSERT_TRUE(membrane_noise_is_done(&noise));
    TEST_ASSERT_EQUAL_UINT32(0U, membrane_noise_un(&noise));
}

void test_SWR_PUNCT_542_the_loudest_noise_does_not_overflow(void)
{
    for (uint32_t i = 0U; i < ALL_MS; i++) {
        membrane_noise_step(&noise, ((i & 256U) == 0U) ? INT32_MAX : INT32_MIN);
    }
    TEST_ASSERT_UINT32_WITHIN(1500000U, 2500000U, membrane_noise_un(&noise));
}
