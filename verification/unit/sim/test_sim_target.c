/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: a target in tissue moves with the needle by its named parameters. */
#include "unity.h"

#include "sim/model/sim_phantom.h"

#include <math.h>

static const sim_target_t target = {.x_mm = 4.0,
                                    .y_mm = -3.0,
                                    .depth_mm = 100.0,
                                    .push_share = 0.1,
                                    .push_most_mm = 5.0,
                                    .shift_x_mm = 3.0,
                                    .shift_y_mm = -6.0,
                                    .shift_from_mm = 20.0,
                                    .shift_to_mm = 50.0};

void setUp(void)
{
}

void tearDown(void)
{
}

static void expect(double in_mm, double x, double y, double z)
{
    const sim_vector_t place_mm = sim_target_place(&target, in_mm);

    TEST_ASSERT_DOUBLE_WITHIN(1e-12, x, place_mm.x);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, y, place_mm.y);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, z, place_mm.z);
}

void test_SWR_BOX_774_it_rests_while_the_needle_is_outside(void)
{
    expect(-30.0, 4.0, -3.0, 100.0);
    expect(0.0, 4.0, -3.0, 100.0);
}

void test_SWR_BOX_774_the_needle_takes_it_along_as_far_as_the_tissue_gives(void)
{
    expect(10.0, 4.0, -3.0, 101.0);
    expect(50.0, 7.0, -9.0, 105.0);
    expect(90.0, 7.0, -9.0, 105.0);
}

void test_SWR_BOX_774_it_gives_way_to_the_side_between_two_lengths(void)
{
    expect(20.0, 4.0, -3.0, 102.0);
    expect(30.0, 5.0, -5.0, 103.0);
    expect(40.0, 6.0, -7.0, 104.0);
    expect(60.0, 7.0, -9.0, 105.0);
}

void test_SWR_BOX_774_a_shift_between_equal_lengths_comes_at_once(void)
{
    sim_target_t jumping = target;

    jumping.shift_to_mm = jumping.shift_from_mm;
    TEST_ASSERT_EQUAL_DOUBLE(4.0, sim_target_place(&jumping, 19.999).x);
    TEST_ASSERT_EQUAL_DOUBLE(7.0, sim_target_place(&jumping, 20.0).x);
}

void test_SWR_BOX_774_the_usual_one_moves_by_5_mm(void)
{
    const sim_vector_t rest = sim_target_place(&sim_target_usual, 0.0);
    const sim_vector_t moved = sim_target_place(&sim_target_usual, 70.0);
    const sim_vector_t by = sim_space_add(moved, -1.0, rest);

    TEST_ASSERT_TRUE(sim_target_is_there(&sim_target_usual));
    TEST_ASSERT_FALSE(sim_target_is_there(&sim_phantom_usual.target));
    TEST_ASSERT_DOUBLE_WITHIN(1e-9, 5.0, sqrt(sim_space_dot(by, by)));
}
