/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: the force on a needle in simulated tissue follows its equations, here in their
 * closed forms.
 */
#include "unity.h"

#include "sim/model/sim_tissue.h"

#include <math.h>
#include <string.h>

#define STEP_S 0.0001
#define NEAR_N 0.002
#define SURFACE_MM 20.0
#define FIRST_MM 8.0

static sim_phantom_t phantom;
static sim_tissue_t tissue;

/* Two membranes, without cutting, friction and relaxation. */
void setUp(void)
{
    static const sim_layer_t bare = {.thickness_mm = FIRST_MM,
                                     .rupture_n = 1.5,
                                     .rupture_fast_share = 0.6,
                                     .rupture_half_speed_mm_per_s = 2.0,
                                     .stiffness_n_per_mm = 0.2,
                                     .stiffening_n_per_mm2 = 0.1,
                                     .relaxing_s = 0.5};

    phantom = (sim_phantom_t){
        .surface_mm = SURFACE_MM, .presliding_mm = 0.2, .stick_mm_per_s = 0.05, .layer_count = 2U};
    phantom.layers[0] = bare;
    phantom.layers[1] = bare;
    phantom.layers[1].thickness_mm = 100.0;
    phantom.layers[1].rupture_n = 0.9;
    sim_tissue_init(&tissue, &phantom, 0.0);
}

void tearDown(void)
{
}

static void go(double to_mm, double speed_mm_per_s)
{
    const double signed_speed = (to_mm < tissue.depth_mm) ? -speed_mm_per_s : speed_mm_per_s;
    const double from_mm = tissue.depth_mm;
    const uint32_t steps = (uint32_t)(fabs(to_mm - from_mm) / speed_mm_per_s / STEP_S + 0.5);

    for (uint32_t i = 1U; i <= steps; i++) {
        sim_tissue_step(&tissue, &phantom, STEP_S, from_mm + signed_speed * STEP_S * i,
                        signed_speed);
    }
}

static void stand(double seconds)
{
    for (uint32_t i = 0U; i < (uint32_t)(seconds / STEP_S + 0.5); i++) {
        sim_tissue_step(&tissue, &phantom, STEP_S, tissue.depth_mm, 0.0);
    }
}

static void expect_force(double expected_n)
{
    TEST_ASSERT_DOUBLE_WITHIN(NEAR_N, expected_n, tissue.force_n);
}

void test_SWR_BOX_520_a_membrane_is_pressed_with_a1_d_and_a2_d2(void)
{
    go(SURFACE_MM, 2.0);
    expect_force(0.0);
    for (double d = 0.5; d < 2.6; d += 0.5) {
        go(SURFACE_MM + d, 2.0);
        expect_force(0.2 * d + 0.1 * d * d);
        TEST_ASSERT_DOUBLE_WITHIN(1e-9, d, tissue.indentation_mm);
    }
    TEST_ASSERT_EQUAL_UINT32(0U, tissue.popped);
}

void test_SWR_BOX_520_a_faster_needle_presses_harder_by_the_relaxing_branch(void)
{
    const double tau = 0.5;
    const double gain = 0.4 / 0.6;
    const double d = 2.0;

    phantom.layers[0].relaxing_share = 0.4;
    phantom.layers[0].rupture_n = 100.0;
    for (double v = 0.5; v < 9.0; v *= 2.0) {
        sim_tissue_init(&tissue, &phantom, SURFACE_MM);
        go(SURFACE_MM + d, v);
        const double t = d / v;
        const double done = 1.0 - exp(-t / tau);
        const double branch =
            gain * (0.2 * v * tau * done + 2.0 * 0.1 * v * v * (tau * t - tau * tau * done));
        expect_force(0.2 * d + 0.1 * d * d + branch);
    }
}

void test_SWR_BOX_520_a_membrane_that_is_left_again_is_not_pulled(void)
{
    phantom.layers[0].relaxing_share = 0.4;
    go(SURFACE_MM + 1.5, 2.0);
    go(SURFACE_MM + 0.01, 10.0);
    TEST_ASSERT_EQUAL_DOUBLE(0.0, tissue.force_n);
    go(SURFACE_MM - 1.0, 2.0);
    TEST_ASSERT_EQUAL_DOUBLE(0.0, tissue.force_n);
    TEST_ASSERT_EQUAL_UINT32(0U, tissue.popped);
}

void test_SWR_BOX_521_it_ruptures_at_the_force_of_its_speed(void)
{
    for (double v = 0.5; v < 9.0; v *= 2.0) {
        double peak = 0.0;
        sim_tissue_init(&tissue, &phantom, SURFACE_MM);
        for (uint32_t i = 1U; tissue.popped == 0U; i++) {
            peak = tissue.force_n;
            sim_tissue_step(&tissue, &phantom, STEP_S, SURFACE_MM + v * STEP_S * i, v);
        }
        const double rupture = 1.5 * (0.6 + 0.4 * 2.0 / (2.0 + v));
        const double d = (-0.2 + sqrt(0.04 + 0.4 * rupture)) / 0.2;
        TEST_ASSERT_DOUBLE_WITHIN(NEAR_N, rupture, peak);
        TEST_ASSERT_DOUBLE_WITHIN(0.002, SURFACE_MM + d, tissue.popped_at_mm[0]);
        TEST_ASSERT_DOUBLE_WITHIN(0.002, d, tissue.recoil_mm);
        TEST_ASSERT_EQUAL_DOUBLE(0.0, tissue.force_n);
    }
}

void test_SWR_BOX_521_each_membrane_ruptures_once(void)
{
    go(SURFACE_MM + FIRST_MM, 2.0);
    TEST_ASSERT_EQUAL_UINT32(1U, tissue.popped);
    go(SURFACE_MM + FIRST_MM + 5.0, 2.0);
    TEST_ASSERT_EQUAL_UINT32(2U, tissue.popped);
    TEST_ASSERT_TRUE(tissue.popped_at_mm[1] > SURFACE_MM + FIRST_MM);
    go(0.0, 5.0);
    go(SURFACE_MM + FIRST_MM + 20.0, 2.0);
    TEST_ASSERT_EQUAL_UINT32(2U, tissue.popped);
    expect_force(0.0);
}

void test_SWR_BOX_521_a_needle_that_does_not_advance_ruptures_nothing(void)
{
    go(SURFACE_MM + 2.7, 0.01);
    stand(1.0);
    TEST_ASSERT_EQUAL_UINT32(0U, tissue.popped);
    go(SURFACE_MM + 2.6, 8.0);
    TEST_ASSERT_EQUAL_UINT32(0U, tissue.popped);
}

static void add_friction(void)
{
    for (uint32_t i = 0U; i < 2U; i++) {
        sim_layer_t *const layer = &phantom.layers[i];
        const double scale = (i == 0U) ? 1.0 : 2.0;
        layer->rupture_n = 0.0;
        layer->cutting_n = 0.3 * scale;
        layer->friction_in_n_per_mm = 0.010 * scale;
        layer->friction_out_n_per_mm = 0.008 * scale;
        layer->viscous_in_n_s_per_mm2 = 0.001 * scale;
        layer->viscous_out_n_s_per_mm2 = 0.002 * scale;
        layer->stick_in_n_per_mm = 0.015 * scale;
        layer->stick_out_n_per_mm = 0.014 * scale;
    }
    sim_tissue_init(&tissue, &phantom, 0.0);
}

void test_SWR_BOX_522_cutting_and_friction_grow_with_the_shaft_in_each_layer(void)
{
    add_friction();
    for (double v = 1.0; v < 9.0; v *= 2.0) {
        sim_tissue_init(&tissue, &phantom, 0.0);
        go(SURFACE_MM + 5.0, v);
        expect_force(0.3 + 5.0 * (0.010 + 0.001 * v));
        go(SURFACE_MM + FIRST_MM + 10.0, v);
        expect_force(0.6 + FIRST_MM * (0.010 + 0.001 * v) + 10.0 * (0.020 + 0.002 * v));
    }
}

void test_SWR_BOX_522_a_needle_that_goes_out_is_held_back_and_cuts_nothing(void)
{
    add_friction();
    go(SURFACE_MM + FIRST_MM + 10.0, 2.0);
    go(SURFACE_MM + FIRST_MM + 5.0, 2.0);
    expect_force(-(FIRST_MM * (0.008 + 0.004) + 5.0 * (0.016 + 0.008)));
    go(SURFACE_MM + FIRST_MM + 9.0, 2.0);
    expect_force(FIRST_MM * 0.012 + 9.0 * 0.024);
    go(SURFACE_MM + FIRST_MM + 12.0, 2.0);
    expect_force(0.6 + FIRST_MM * 0.012 + 12.0 * 0.024);
    go(SURFACE_MM - 1.0, 2.0);
    TEST_ASSERT_EQUAL_DOUBLE(0.0, tissue.force_n);
}

void test_SWR_BOX_522_friction_sticks_up_to_its_bound_while_the_needle_creeps(void)
{
    add_friction();
    phantom.layers[0].cutting_n = 0.0;
    go(SURFACE_MM + 6.0, 2.0);
    go(SURFACE_MM + 7.0, 0.04);
    expect_force(7.0 * 0.015);
    go(SURFACE_MM + 7.1, 1.0);
    expect_force(7.1 * 0.011);
    go(SURFACE_MM + 6.0, 0.04);
    expect_force(-6.0 * 0.014);
}

void test_SWR_BOX_522_nothing_holds_the_tip_beyond_the_last_layer(void)
{
    add_friction();
    go(SURFACE_MM + FIRST_MM + 105.0, 5.0);
    expect_force(FIRST_MM * 0.015 + 100.0 * 0.030);
}

static double fall_in_a_second(double depth_mm, double speed)
{
    go(depth_mm, speed);
    const double before = tissue.force_n;
    stand(1.0);
    return 1.0 - tissue.force_n / before;
}

void test_SWR_BOX_523_a_needle_that_stops_is_let_go_slowly_by_its_share(void)
{
    const double fallen = 0.4 * (1.0 - exp(-1.0 / 0.5));

    add_friction();
    phantom.layers[0].relaxing_share = 0.4;
    TEST_ASSERT_DOUBLE_WITHIN(0.001, fallen, fall_in_a_second(SURFACE_MM + 5.0, 2.0));
    stand(5.0);
    expect_force(0.6 * (0.3 + 5.0 * 0.012));
}

void test_SWR_BOX_523_a_membrane_under_a_needle_that_stops_relaxes_to_its_elastic_force(void)
{
    phantom.layers[0].relaxing_share = 0.4;
    phantom.layers[0].rupture_n = 2.0;
    go(SURFACE_MM + 2.0, 4.0);
    TEST_ASSERT_TRUE(tissue.force_n > 1.1);
    stand(5.0);
    expect_force(0.8);
    TEST_ASSERT_EQUAL_UINT32(0U, tissue.popped);
}

void test_SWR_BOX_524_the_same_steps_give_the_same_bits(void)
{
    sim_tissue_t first;

    add_friction();
    phantom.layers[1].rupture_n = 1.0;
    for (uint32_t run = 0U; run < 2U; run++) {
        (void)memset(&tissue, 0, sizeof tissue);
        sim_tissue_init(&tissue, &phantom, 0.0);
        go(SURFACE_MM + FIRST_MM + 6.0, 3.7);
        stand(0.1);
        go(SURFACE_MM + 1.0, 2.3);
        if (run == 0U) {
            first = tissue;
        }
    }
    TEST_ASSERT_EQUAL_MEMORY(&first, &tissue, sizeof tissue);
}

void test_SWR_BOX_520_without_layers_there_is_no_force(void)
{
    phantom.layer_count = 0U;
    sim_tissue_init(&tissue, &phantom, 0.0);
    go(60.0, 5.0);
    TEST_ASSERT_EQUAL_DOUBLE(0.0, tissue.force_n);
}
