/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a vibration is as many strokes back and forward as its law has periods, between
 * rests; it never leaves its side, keeps within the acceleration that its strokes need, and ends
 * at rest where it began.
 */
#include "unity.h"

#include "limits/requirement_limits.h"
#include "motion/vibration.h"
#include "robot/robot_prostate.h"

#include <math.h>
#include <stdint.h>

#define PER_S (1000000.0 / LIMIT_CYCLE_US)
#define MOST_CYCLES 20000U

static const vibration_law_t laws[] = {
    {116U, 110U, 15U, 3U}, {166U, 130U, 15U, 2U}, {50U, 71U, 15U, 10U},  {1U, 1U, 1U, 1U},
    {7U, 2U, 0U, 3U},      {1000U, 255U, 0U, 1U}, {166U, 256U, 30U, 1U},
};
#define LAWS (sizeof laws / sizeof laws[0])

void setUp(void)
{
}

void tearDown(void)
{
}

static double leg_cycles(const vibration_law_t *law)
{
    return (double)law->dwell_cycles + (double)law->stroke_cycles;
}

static double train_cycles(const vibration_law_t *law)
{
    return (2.0 * (double)law->periods * leg_cycles(law)) + (double)law->dwell_cycles;
}

/* Way of a stroke from rest to rest, by its two parabolas. */
static double stroke(const vibration_law_t *law, double cycle)
{
    const double share = fmax(0.0, cycle) / (double)law->stroke_cycles;
    return (double)law->amplitude_ticks *
           ((share <= 0.5) ? (2.0 * share * share) : (1.0 - (2.0 * (1.0 - share) * (1.0 - share))));
}

static double reference_ticks(const vibration_law_t *law, double cycle)
{
    const double leg = floor(cycle / leg_cycles(law));
    const double way = stroke(law, cycle - (leg * leg_cycles(law)) - (double)law->dwell_cycles);
    return (fmod(leg, 2.0) == 0.0) ? way : ((double)law->amplitude_ticks - way);
}

void test_SWR_VIB_701_every_set_point_is_that_of_the_equation(void)
{
    for (uint32_t i = 0U; i < LAWS; i++) {
        const uint32_t count = (uint32_t)train_cycles(&laws[i]);
        for (uint32_t cycle = 0U; cycle < count; cycle++) {
            const vibration_point_t point = vibration_at(&laws[i], cycle);
            TEST_ASSERT_FALSE(point.is_over);
            TEST_ASSERT_DOUBLE_WITHIN(0.501, reference_ticks(&laws[i], (double)cycle),
                                      (double)point.behind_ticks);
        }
    }
}

/* As the reference moves from half a cycle before to half a cycle behind: the middle of a parabola.
 */
void test_SWR_VIB_701_every_speed_is_that_of_the_equation(void)
{
    const vibration_law_t *const law = &laws[0];
    for (uint32_t cycle = 1U; cycle < (uint32_t)train_cycles(law) - 1U; cycle++) {
        const double way =
            reference_ticks(law, (double)cycle + 0.01) - reference_ticks(law, (double)cycle - 0.01);
        const double speed_q8 = -way / 0.02 * PER_S * 256.0;
        TEST_ASSERT_DOUBLE_WITHIN(6000.0, speed_q8,
                                  (double)vibration_at(law, cycle).speed_ticks_per_s_q8);
    }
}

void test_SWR_VIB_701_it_ends_at_rest_where_it_began_after_its_periods(void)
{
    for (uint32_t i = 0U; i < LAWS; i++) {
        const uint32_t count = (uint32_t)train_cycles(&laws[i]);
        uint32_t turns = 0U;
        for (uint32_t cycle = 1U; cycle < count; cycle++) {
            const bool is_there = vibration_at(&laws[i], cycle).behind_ticks == 0;
            const bool was_there = vibration_at(&laws[i], cycle - 1U).behind_ticks == 0;
            turns += (is_there && !was_there) ? 1U : 0U;
        }
        const vibration_point_t over = vibration_at(&laws[i], count);
        turns += (vibration_at(&laws[i], count - 1U).behind_ticks != 0) ? 1U : 0U;
        TEST_ASSERT_EQUAL_UINT32(laws[i].periods, turns);
        TEST_ASSERT_TRUE(over.is_over);
        TEST_ASSERT_EQUAL_INT32(0, over.behind_ticks);
        TEST_ASSERT_EQUAL_INT32(0, over.speed_ticks_per_s_q8);
        TEST_ASSERT_TRUE(vibration_at(&laws[i], UINT32_MAX).is_over);
    }
}

void test_SWR_VIB_701_it_rests_before_each_stroke_and_at_the_end(void)
{
    const vibration_law_t *const law = &laws[0];
    const uint32_t leg = law->dwell_cycles + law->stroke_cycles;
    for (uint32_t i = 0U; i <= (2U * law->periods); i++) {
        const int32_t there = ((i % 2U) == 0U) ? 0 : (int32_t)law->amplitude_ticks;
        for (uint32_t cycle = 0U; cycle < law->dwell_cycles; cycle++) {
            const vibration_point_t point = vibration_at(law, (i * leg) + cycle);
            TEST_ASSERT_EQUAL_INT32(there, point.behind_ticks);
            TEST_ASSERT_EQUAL_INT32(0, point.speed_ticks_per_s_q8);
        }
    }
}

void test_SWR_VIB_702_it_never_leaves_its_side_nor_its_amplitude(void)
{
    for (uint32_t i = 0U; i < LAWS; i++) {
        int32_t farthest = 0;
        for (uint32_t cycle = 0U; cycle < MOST_CYCLES; cycle++) {
            const vibration_point_t point = vibration_at(&laws[i], cycle);
            TEST_ASSERT_GREATER_OR_EQUAL_INT32(0, point.behind_ticks);
            farthest = (point.behind_ticks > farthest) ? point.behind_ticks : farthest;
        }
        TEST_ASSERT_EQUAL_INT32(laws[i].amplitude_ticks, farthest);
    }
}

void test_SWR_VIB_702_no_law_or_a_wrong_one_moves_nothing(void)
{
    static const vibration_law_t none[] = {
        {0U, 0U, 0U, 0U}, {116U, 110U, 15U, 0U}, {116U, 257U, 15U, 3U}, {116U, 0U, 0U, 3U}};
    for (uint32_t i = 0U; i < (sizeof none / sizeof none[0]); i++) {
        for (uint32_t cycle = 0U; cycle < MOST_CYCLES; cycle++) {
            TEST_ASSERT_TRUE(vibration_at(&none[i], cycle).is_over);
        }
    }
}

/* The file's: its strokes fit the axis. */
void test_SWR_VIB_701_the_needle_of_the_file_is_driven_within_its_limits(void)
{
    const vibration_law_t *const law = &robot_prostate.vibration;
    const axis_config_t *const axis = &robot_prostate.axes[PROSTATE_AXIS_INSERTION];
    const double step_q8 = (double)axis->acceleration_ticks_per_s2 * 256.0 / PER_S;
    int32_t before = 0;
    TEST_ASSERT_FALSE(vibration_at(law, 0U).is_over);
    for (uint32_t cycle = 1U; cycle < (uint32_t)train_cycles(law); cycle++) {
        const int32_t speed_q8 = vibration_at(law, cycle).speed_ticks_per_s_q8;
        TEST_ASSERT_TRUE(fabs((double)speed_q8 - (double)before) <= (step_q8 + 1.0));
        TEST_ASSERT_TRUE(fabs((double)speed_q8) <= ((double)axis->speed_ticks_per_s * 256.0));
        before = speed_q8;
    }
    TEST_ASSERT_TRUE(law->dwell_cycles * LIMIT_CYCLE_US >
                     (uint32_t)axis->reversal_dwell_ms * 1000U);
}
