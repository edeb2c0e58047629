/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: the filter in integers is the Butterworth low-pass, here in double precision.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "sensor/membrane_filter.h"
#include "sim/model/sim_random.h"

#include <math.h>
#include <string.h>

#define PI 3.14159265358979323846
#define MOST_MN ((int32_t)LIMIT_MEMBRANE_MOST_MN)
#define NEAR_MN ((double)LIMIT_MEMBRANE_FILTER_ERROR_UN / 1000.0)

static membrane_filter_t filter;
static struct {
    double in[2];
    double out[2];
} truth;

void setUp(void)
{
    (void)memset(&filter, 0, sizeof filter);
    (void)memset(&truth, 0, sizeof truth);
}

void tearDown(void)
{
}

static double true_step(double in)
{
    const double k = tan(PI * (double)LIMIT_MEMBRANE_FILTER_HZ / 1000.0);
    const double n = 1.0 + (sqrt(2.0) * k) + (k * k);
    const double a1 = 2.0 * ((k * k) - 1.0) / n;
    const double a2 = (1.0 - (sqrt(2.0) * k) + (k * k)) / n;
    const double out = (k * k / n * (in + (2.0 * truth.in[0]) + truth.in[1])) -
                       (a1 * truth.out[0]) - (a2 * truth.out[1]);
    truth.in[1] = truth.in[0];
    truth.in[0] = in;
    truth.out[1] = truth.out[0];
    truth.out[0] = out;
    return out;
}

static double step(int32_t force_mn)
{
    return (double)membrane_filter_step(&filter, force_mn) / (double)MEMBRANE_MN_Q12;
}

static void follow(int32_t force_mn)
{
    TEST_ASSERT_DOUBLE_WITHIN(NEAR_MN, true_step((double)force_mn), step(force_mn));
}

void test_SWR_PUNCT_543_it_follows_steps_and_noise_of_any_size(void)
{
    sim_random_t random = {.state = 1U};
    follow(0);
    for (uint32_t most = 1U; most <= LIMIT_MEMBRANE_MOST_MN; most *= 10U) {
        for (uint32_t i = 0U; i < 1000U; i++) {
            follow((int32_t)lrint((double)most * sim_random_signed(&random)));
        }
        for (uint32_t i = 0U; i < 500U; i++) {
            follow((int32_t)most);
        }
        for (uint32_t i = 0U; i < 500U; i++) {
            follow(-(int32_t)most);
        }
    }
}

void test_SWR_PUNCT_543_a_force_that_stays_passes_as_it_is(void)
{
    TEST_ASSERT_EQUAL_DOUBLE(-MOST_MN, step(-MOST_MN));
    for (uint32_t i = 0U; i < 1000U; i++) {
        (void)step(777);
    }
    TEST_ASSERT_DOUBLE_WITHIN(NEAR_MN, 777.0, step(777));
}

void test_SWR_PUNCT_543_a_force_beyond_the_most_counts_as_that(void)
{
    TEST_ASSERT_EQUAL_DOUBLE(MOST_MN, step(INT32_MAX));
    (void)memset(&filter, 0, sizeof filter);
    TEST_ASSERT_EQUAL_DOUBLE(-MOST_MN, step(INT32_MIN));
}

/* A sine of `hz` comes out with this amplitude. */
static double gain_at(double hz)
{
    double most = 0.0;
    setUp();
    for (uint32_t i = 0U; i < 4000U; i++) {
        const double out = step((int32_t)lrint(100000.0 * sin(2.0 * PI * hz * i / 1000.0)));
        most = fmax(most, (i >= 2000U) ? out : 0.0);
    }
    return most / 100000.0;
}

void test_SWR_PUNCT_543_at_its_corner_half_of_the_power_is_left(void)
{
    TEST_ASSERT_DOUBLE_WITHIN(0.001, sqrt(0.5), gain_at((double)LIMIT_MEMBRANE_FILTER_HZ));
    TEST_ASSERT_DOUBLE_WITHIN(0.001, 1.0, gain_at(1.0));
    TEST_ASSERT_LESS_THAN_DOUBLE(0.011, gain_at(190.0));
}
