/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: in real time the box' world follows the world's clock; in elastic time it goes
 * just as far as control has come, until control has asked for nothing for too long. Time is handed
 * in; no clock is read.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "sim/box_clock.h"

#include <stddef.h>

#define START_US UINT64_C(5000000)
#define CYCLE_US 1000U
#define PATIENT_LOOKS (LIMIT_ELASTIC_ANSWER_CLOCK_US / BOX_CLOCK_LOOK_US)

static box_clock_t box;
static uint64_t world_us;

static void start(bool is_elastic, uint32_t slowness)
{
    world_us = UINT64_C(700000000);
    box_clock_init(&box, (box_time_t){is_elastic, slowness, 1U}, START_US, world_us);
}

void setUp(void)
{
    start(true, 1U);
}

void tearDown(void)
{
}

/* A look after `elapsed_us` of the world's time, in which no program asks. */
static uint32_t look_alone(uint64_t elapsed_us)
{
    world_us += elapsed_us;
    return box_clock_look(&box, NULL, world_us);
}

/* Control asks for an exchange at `wanted_us`. */
static uint32_t look_asked(uint64_t wanted_us, uint64_t elapsed_us)
{
    world_us += elapsed_us;
    return box_clock_look(&box, &wanted_us, world_us);
}

void test_SWR_BOX_006_the_world_goes_on_as_far_as_control_has_come(void)
{
    for (uint32_t cycle = 1U; cycle <= 100U; cycle++) {
        TEST_ASSERT_EQUAL_UINT32(CYCLE_US, look_asked(START_US + cycle * CYCLE_US, 900U));
    }
    TEST_ASSERT_EQUAL_UINT64(START_US + 100U * CYCLE_US, box.now_us);
}

void test_SWR_BOX_006_nothing_passes_while_nobody_asks(void)
{
    for (uint32_t i = 0U; i < PATIENT_LOOKS; i++) {
        TEST_ASSERT_EQUAL_UINT32(0U, look_alone(BOX_CLOCK_LOOK_US));
    }
    TEST_ASSERT_EQUAL_UINT64(START_US, box.now_us);
}

void test_SWR_BOX_006_a_pause_of_the_machine_is_no_time(void)
{
    TEST_ASSERT_EQUAL_UINT32(0U, look_alone(60000000U));
    TEST_ASSERT_EQUAL_UINT32(CYCLE_US, look_asked(START_US + CYCLE_US, 60000000U));
}

void test_SWR_BOX_006_time_never_goes_back(void)
{
    TEST_ASSERT_EQUAL_UINT32(CYCLE_US, look_asked(START_US + CYCLE_US, 1000U));
    TEST_ASSERT_EQUAL_UINT32(0U, look_asked(START_US, 1000U));
    TEST_ASSERT_EQUAL_UINT64(START_US + CYCLE_US, box.now_us);
}

void test_SWR_BOX_006_a_leap_of_control_moves_the_world_one_stride(void)
{
    TEST_ASSERT_EQUAL_UINT32(BOX_CLOCK_STRIDE_US, look_asked(START_US + 3600000000U, 1000U));
    TEST_ASSERT_EQUAL_UINT64(START_US + 3600000000U, box.now_us);
}

static void use_up_patience(void)
{
    for (uint32_t i = 0U; i < PATIENT_LOOKS; i++) {
        (void)look_alone(BOX_CLOCK_LOOK_US);
    }
}

void test_SWR_BOX_007_left_alone_for_its_patience_the_world_goes_on_by_itself(void)
{
    use_up_patience();
    const uint64_t since_us = box.now_us;
    for (uint32_t i = 0U; i < 20U; i++) {
        TEST_ASSERT_EQUAL_UINT32(BOX_CLOCK_LOOK_US, look_alone(BOX_CLOCK_LOOK_US));
    }
    TEST_ASSERT_EQUAL_UINT64(since_us + 20U * BOX_CLOCK_LOOK_US, box.now_us);
}

void test_SWR_BOX_007_a_request_renews_the_patience(void)
{
    use_up_patience();
    TEST_ASSERT_EQUAL_UINT32(CYCLE_US, look_asked(box.now_us + CYCLE_US, 1000U));
    for (uint32_t i = 0U; i < PATIENT_LOOKS; i++) {
        TEST_ASSERT_EQUAL_UINT32(0U, look_alone(BOX_CLOCK_LOOK_US));
    }
}

void test_SWR_BOX_007_control_that_waits_is_waited_for(void)
{
    for (uint32_t i = 0U; i < 10U; i++) {
        use_up_patience();
        box_clock_hear(&box);
    }
    use_up_patience();
    TEST_ASSERT_EQUAL_UINT64(START_US, box.now_us);
    TEST_ASSERT_EQUAL_UINT32(BOX_CLOCK_LOOK_US, look_alone(BOX_CLOCK_LOOK_US));
}

void test_SWR_BOX_007_a_pause_of_the_machine_does_not_use_the_patience_up(void)
{
    for (uint32_t i = 0U; i < PATIENT_LOOKS; i++) {
        TEST_ASSERT_EQUAL_UINT32(0U, look_alone(1000000U));
    }
}

void test_SWR_BOX_007_alone_it_pauses_with_the_machine(void)
{
    use_up_patience();
    TEST_ASSERT_EQUAL_UINT32(BOX_CLOCK_STRIDE_US, look_alone(1000000U));
}

void test_SWR_BOX_007_alone_it_is_as_slow_as_requested(void)
{
    start(true, 10U);
    use_up_patience();
    TEST_ASSERT_EQUAL_UINT32(150U, look_alone(BOX_CLOCK_LOOK_US));
}

void test_SWR_BOX_005_in_real_time_the_world_follows_the_clock_divided_by_the_slowness(void)
{
    start(false, 7U);
    const uint64_t start_us = box.now_us;
    uint64_t passed_us = 0U;
    for (uint32_t i = 0U; i < 7000U; i++) {
        passed_us += look_alone(1000U + (i % 3U));
    }
    TEST_ASSERT_EQUAL_UINT64(world_us / 7U, box.now_us);
    TEST_ASSERT_EQUAL_UINT64(box.now_us - start_us, passed_us);
}

void test_SWR_BOX_005_in_real_time_nobody_is_waited_for(void)
{
    start(false, 1U);
    TEST_ASSERT_EQUAL_UINT32(1500U, look_alone(1500U));
    TEST_ASSERT_EQUAL_UINT32(500U, look_asked(0U, 500U));
}

void test_SWR_BOX_048_in_real_time_a_pause_of_the_machine_is_time_for_the_world(void)
{
    start(false, 1U);
    const uint64_t start_us = box.now_us;
    TEST_ASSERT_EQUAL_UINT32(18000U, look_asked(0U, 18000U));
    TEST_ASSERT_EQUAL_UINT32(LIMIT_BOX_LEAP_US, look_alone(LIMIT_BOX_LEAP_US));
    TEST_ASSERT_EQUAL_UINT64(start_us + 18000U + LIMIT_BOX_LEAP_US, box.now_us);
}

void test_SWR_BOX_048_a_pause_that_is_longer_leaves_the_rest_out(void)
{
    start(false, 1U);
    TEST_ASSERT_EQUAL_UINT32(LIMIT_BOX_LEAP_US, look_alone(LIMIT_BOX_LEAP_US + 1U));
}
