/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: images of the tip come at their rate, after their delay and with their noise. */
#include "unity.h"

#include "sim/model/sim_imager.h"

#include <math.h>

#define STEP_US UINT64_C(100)
#define MS UINT64_C(1000)

static sim_imager_config_t config;
static sim_imager_t imager;
static uint64_t now_us;
static const sim_vector_t ahead = {0.6, 0.0, 0.8};

void setUp(void)
{
    config = (sim_imager_config_t){.period_ms = 200.0, .delay_ms = 50.0};
    sim_imager_init(&imager, 7U);
    now_us = 0U;
}

void tearDown(void)
{
}

/* The tip is as far along x as it is ms late. */
static void go_to(uint64_t ms)
{
    while (now_us < ms * MS) {
        now_us += STEP_US;
        if (sim_imager_step(&imager, &config, now_us)) {
            sim_imager_take(&imager, &config, now_us,
                            (sim_vector_t){(double)now_us / 1000.0, 1.0, 2.0}, ahead);
        }
    }
}

static void expect_last(uint32_t number, uint64_t taken_ms)
{
    TEST_ASSERT_EQUAL_UINT32(number, imager.last.number);
    TEST_ASSERT_EQUAL_UINT64(taken_ms * MS, imager.last.taken_us);
    TEST_ASSERT_EQUAL_DOUBLE((double)taken_ms, imager.last.place_mm.x);
}

void test_SWR_BOX_775_one_is_taken_in_each_period_and_comes_after_its_delay(void)
{
    go_to(249U);
    TEST_ASSERT_EQUAL_UINT32(0U, imager.last.number);
    go_to(250U);
    expect_last(1U, 200U);
    go_to(449U);
    expect_last(1U, 200U);
    go_to(450U);
    expect_last(2U, 400U);
}

void test_SWR_BOX_775_a_delay_may_be_longer_than_the_period(void)
{
    config.delay_ms = 900.0;
    go_to(1099U);
    TEST_ASSERT_EQUAL_UINT32(0U, imager.last.number);
    go_to(1100U);
    expect_last(1U, 200U);
    go_to(2100U);
    expect_last(6U, 1200U);
}

void test_SWR_BOX_775_none_is_taken_while_too_many_are_on_their_way(void)
{
    config.delay_ms = 10000.0;
    go_to(5000U);
    TEST_ASSERT_EQUAL_UINT32(SIM_IMAGER_WAITING, imager.taken);
    go_to(10200U);
    expect_last(1U, 200U);
}

void test_SWR_BOX_775_none_is_taken_without_a_period(void)
{
    config.period_ms = 0.0;
    go_to(3000U);
    TEST_ASSERT_EQUAL_UINT32(0U, imager.taken);
}

void test_SWR_BOX_775_without_noise_it_shows_the_tip(void)
{
    go_to(300U);
    TEST_ASSERT_EQUAL_DOUBLE(1.0, imager.last.place_mm.y);
    TEST_ASSERT_EQUAL_DOUBLE(2.0, imager.last.place_mm.z);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 0.6, imager.last.direction.x);
    TEST_ASSERT_DOUBLE_WITHIN(1e-15, 0.8, imager.last.direction.z);
}

#define IMAGES 4000U

void test_SWR_BOX_775_place_and_direction_have_their_noise(void)
{
    double squares[3] = {0.0, 0.0, 0.0};
    double sum = 0.0;

    config =
        (sim_imager_config_t){.period_ms = 1.0, .delay_ms = 0.0, .noise_mm = 0.5, .noise_deg = 0.5};
    go_to(1U);
    for (uint32_t i = 0U; i < IMAGES; i++) {
        go_to((now_us / MS) + 1U);
        const sim_image_t *const image = &imager.last;
        const double off_mm = image->place_mm.y - 1.0;
        squares[0] += off_mm * off_mm;
        sum += off_mm;
        const double up = asin(image->direction.y);
        squares[1] += up * up;
        const double aside = atan2(image->direction.x, image->direction.z) - atan2(0.6, 0.8);
        squares[2] += aside * aside;
        TEST_ASSERT_DOUBLE_WITHIN(1e-14, 1.0, sim_space_dot(image->direction, image->direction));
    }
    TEST_ASSERT_DOUBLE_WITHIN(0.03, 0.0, sum / IMAGES);
    TEST_ASSERT_DOUBLE_WITHIN(0.02, 0.5, sqrt(squares[0] / IMAGES));
    TEST_ASSERT_DOUBLE_WITHIN(0.02, 0.5, sqrt(squares[1] / IMAGES) / SIM_RAD_PER_DEG);
    TEST_ASSERT_DOUBLE_WITHIN(0.02, 0.5, sqrt(squares[2] / IMAGES) / SIM_RAD_PER_DEG);
}

void test_SWR_BOX_775_the_same_seed_gives_the_same_images(void)
{
    config.noise_mm = 0.5;
    config.noise_deg = 0.5;
    go_to(2000U);
    const sim_image_t first = imager.last;
    setUp();
    config.noise_mm = 0.5;
    config.noise_deg = 0.5;
    go_to(2000U);
    TEST_ASSERT_EQUAL_DOUBLE(first.place_mm.y, imager.last.place_mm.y);
    TEST_ASSERT_EQUAL_DOUBLE(first.direction.y, imager.last.direction.y);
    sim_imager_init(&imager, 8U);
    now_us = 0U;
    go_to(2000U);
    TEST_ASSERT_FALSE(first.place_mm.y == imager.last.place_mm.y);
}
