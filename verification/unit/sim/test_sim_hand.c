/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: a hand presses with a force whatever the handle does, or pulls the handle like a
 * spring to a place that it wishes. */
#include "unity.h"

#include "sim/model/sim_hand.h"

#include <stdint.h>

#define STEP_S 0.0001

static sim_hand_t hand;

void setUp(void)
{
    sim_hand_init(&hand);
}

void tearDown(void)
{
}

static double force_after(double seconds, double handle_mm)
{
    for (uint32_t i = 0U; i < (uint32_t)(seconds / STEP_S + 0.5); i++) {
        sim_hand_step(&hand, STEP_S, handle_mm);
    }
    return hand.force_n;
}

void test_SWR_BOX_525_a_hand_off_has_no_force(void)
{
    TEST_ASSERT_EQUAL_DOUBLE(0.0, force_after(0.01, 5.0));
    sim_hand_press(&hand, 3.0);
    TEST_ASSERT_EQUAL_DOUBLE(3.0, force_after(0.01, 5.0));
    sim_hand_release(&hand);
    TEST_ASSERT_EQUAL_DOUBLE(0.0, force_after(STEP_S, 5.0));
}

void test_SWR_BOX_525_a_press_does_not_depend_on_the_handle_and_has_a_bound(void)
{
    sim_hand_press(&hand, -2.5);
    TEST_ASSERT_EQUAL_DOUBLE(-2.5, force_after(0.01, 5.0));
    TEST_ASSERT_EQUAL_DOUBLE(-2.5, force_after(0.01, -50.0));
    sim_hand_press(&hand, 1000.0);
    TEST_ASSERT_EQUAL_DOUBLE(SIM_HAND_MOST_N, force_after(0.01, 0.0));
    sim_hand_press(&hand, -1000.0);
    TEST_ASSERT_EQUAL_DOUBLE(-SIM_HAND_MOST_N, force_after(0.01, 0.0));
}

void test_SWR_BOX_525_a_spring_pulls_by_its_stiffness_and_the_way_that_is_left(void)
{
    for (double stiffness = 0.2; stiffness < 6.0; stiffness *= 2.0) {
        sim_hand_init(&hand);
        hand.stiffness_n_per_mm = stiffness;
        sim_hand_wish(&hand, 10.0, 2.0, 0.0);
        TEST_ASSERT_DOUBLE_WITHIN(1e-9, stiffness * 2.0, force_after(0.1, 10.0));
        TEST_ASSERT_DOUBLE_WITHIN(1e-9, stiffness * 0.5, force_after(0.1, 11.5));
        TEST_ASSERT_DOUBLE_WITHIN(1e-9, -stiffness, force_after(0.1, 13.0));
    }
}

void test_SWR_BOX_525_a_wish_moves_on_from_where_it_is(void)
{
    sim_hand_wish(&hand, 10.0, 0.0, 2.0);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 1.0, force_after(0.5, 10.0));
    sim_hand_wish(&hand, 10.0, 0.0, -4.0);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, -1.0, force_after(0.5, 10.0));
    sim_hand_wish(&hand, 10.0, 3.0, 0.0);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 3.0, force_after(0.5, 10.0));
}

void test_SWR_BOX_525_a_hand_that_takes_the_handle_again_has_no_old_wish(void)
{
    sim_hand_wish(&hand, 10.0, 0.0, 2.0);
    (void)force_after(1.0, 10.0);
    sim_hand_release(&hand);
    (void)force_after(1.0, 10.0);
    sim_hand_wish(&hand, 20.0, 0.0, 1.0);
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 0.1, force_after(0.1, 20.0));
}
