/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the needle is out when it is homed and no deeper than its limit; what a jog must
 * not do before follows from how each axis moves it.
 */
#include "unity.h"

#include "axis/axis.h"
#include "robot/robot_neuro.h"
#include "safety/needle.h"

/* 0.625 mm of 3333.34 ticks. */
#define OUT_TICKS 2083

static axis_t axes[ROBOT_AXIS_MAX];

void setUp(void)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        axis_init(&axes[i]);
    }
    axes[NEURO_AXIS_INSERTION].chart.reference = AXIS_REFERENCE_VERIFIED;
}

void tearDown(void)
{
}

static bool forbids(uint32_t axis, bool is_upwards)
{
    return needle_forbids_jog(&robot_neuro, axes, axis, is_upwards);
}

void test_SWR_JOG_001_the_needle_is_out_as_far_as_its_limit(void)
{
    TEST_ASSERT_EQUAL_INT32(OUT_TICKS, needle_out_ticks(&robot_neuro));
    axes[NEURO_AXIS_INSERTION].sealed.encoder.position_ticks = OUT_TICKS;
    TEST_ASSERT_FALSE(forbids(NEURO_AXIS_LATERAL, true));
    axes[NEURO_AXIS_INSERTION].sealed.encoder.position_ticks = OUT_TICKS + 1;
    TEST_ASSERT_TRUE(forbids(NEURO_AXIS_LATERAL, true));
}

void test_SWR_JOG_001_a_needle_that_is_not_homed_is_not_known_to_be_out(void)
{
    axes[NEURO_AXIS_INSERTION].chart.reference = AXIS_REFERENCE_LOST;
    axes[NEURO_AXIS_INSERTION].sealed.limit_switches = CARD_LIMIT_LOWER;
    TEST_ASSERT_TRUE(forbids(NEURO_AXIS_LATERAL, true));
}

void test_SWR_JOG_001_across_it_nothing_is_jogged_either_way(void)
{
    static const uint32_t across[] = {NEURO_AXIS_HEAD, NEURO_AXIS_FEET, NEURO_AXIS_LATERAL,
                                      NEURO_AXIS_PITCH, NEURO_AXIS_YAW};
    for (uint32_t i = 0U; i < (sizeof across / sizeof across[0]); i++) {
        axes[NEURO_AXIS_INSERTION].sealed.encoder.position_ticks = OUT_TICKS;
        TEST_ASSERT_FALSE(forbids(across[i], true));
        TEST_ASSERT_FALSE(forbids(across[i], false));
        axes[NEURO_AXIS_INSERTION].sealed.encoder.position_ticks = OUT_TICKS + 1;
        TEST_ASSERT_TRUE(forbids(across[i], true));
        TEST_ASSERT_TRUE(forbids(across[i], false));
    }
    TEST_ASSERT_FALSE(forbids(NEURO_AXIS_ROTATION, true));
    TEST_ASSERT_FALSE(forbids(NEURO_AXIS_INSERTION, true));
}

void test_SWR_JOG_003_before_homing_the_needle_goes_outwards_only(void)
{
    axes[NEURO_AXIS_INSERTION].chart.reference = AXIS_REFERENCE_LOST;
    TEST_ASSERT_TRUE(forbids(NEURO_AXIS_INSERTION, true));
    TEST_ASSERT_FALSE(forbids(NEURO_AXIS_INSERTION, false));
    TEST_ASSERT_FALSE(forbids(NEURO_AXIS_ROTATION, true));
}

void test_SWR_NEXT_029_a_needle_of_which_nothing_was_known_since_the_power_on_is_out(void)
{
    axes[NEURO_AXIS_INSERTION].chart.reference = AXIS_REFERENCE_FRESH;
    axes[NEURO_AXIS_INSERTION].sealed.encoder.position_ticks = OUT_TICKS + 1;
    TEST_ASSERT_FALSE(needle_may_be_in(&robot_neuro, axes));
}

void test_SWR_NEXT_029_counts_that_can_be_believed_say_whether_it_may_be_in(void)
{
    axes[NEURO_AXIS_INSERTION].sealed.place = AXIS_PLACE_COUNTED;
    axes[NEURO_AXIS_INSERTION].sealed.encoder.position_ticks = OUT_TICKS;
    TEST_ASSERT_FALSE(needle_may_be_in(&robot_neuro, axes));
    axes[NEURO_AXIS_INSERTION].sealed.encoder.position_ticks = OUT_TICKS + 1;
    TEST_ASSERT_TRUE(needle_may_be_in(&robot_neuro, axes));
}

void test_SWR_NEXT_029_where_they_cannot_it_may_be_in_wherever_they_have_it(void)
{
    axes[NEURO_AXIS_INSERTION].sealed.encoder.position_ticks = 0;
    axes[NEURO_AXIS_INSERTION].sealed.place = AXIS_PLACE_COUNTED | AXIS_PLACE_BROKEN;
    TEST_ASSERT_TRUE(needle_may_be_in(&robot_neuro, axes));
    axes[NEURO_AXIS_INSERTION].sealed.place = AXIS_PLACE_BROKEN;
    TEST_ASSERT_TRUE(needle_may_be_in(&robot_neuro, axes));
}
