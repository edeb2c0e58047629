/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: a puncture is answered by a vibration of the true needle that stays behind the
 * place where it began, under pedal, hand and permit, while nothing is found.
 */
#include "integration/support/by_hand.h"
#include "integration/support/rig.h"

#include "unity.h"

#include "controller/controller.h"
#include "limits/requirement_limits.h"
#include "robot/robot_prostate.h"
#include "unit/support/scenes.h"

#include "integration/support/vibration_world.inc"

#define RANDOM_SCENES 25U
#define SOFT_MN 500
#define NEAR_TRIALS 10U
#define BEFORE_MM 8.0 /* More than a membrane yields before it ruptures. */

static uint64_t random_state;

void setUp(void)
{
    by_hand_start(&rig, ENTRY_Z_NM, TARGET_Z_NM);
    witness = (witness_t){0};
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static uint32_t random_below(uint32_t count)
{
    random_state = (random_state * UINT64_C(6364136223846793005)) + UINT64_C(1442695040888963407);
    return (uint32_t)(random_state >> 33U) % count;
}

static uint32_t found(void)
{
    return rig_count(&rig, EVENT_MEMBRANE_FOUND) + rig_count(&rig, EVENT_MEMBRANE_UNEXPECTED);
}

static void expect_behind(void)
{
    TEST_ASSERT_TRUE(witness.deepest_ticks <= (LIMIT_VIBRATION_DEEPER_UM * TICKS_PER_UM));
    TEST_ASSERT_TRUE(witness.farthest_ticks <= (LIMIT_VIBRATION_MOST_UM * TICKS_PER_UM));
}

/* The whole insertion in the usual tissue, from setUp() on. */
static void insert_as_usual(void)
{
    static moment_t inserted;
    if (!inserted.is_kept) {
        insert();
        keep(&inserted);
    }
    go_on_from(&inserted);
}

/* A pause from the box, and the membranes at these depths behind the first layer's. */
static void lay_membranes(double apart_mm)
{
    sim_phantom_file_t phantom = rig.box.force.phantom;
    phantom.tissue.layers[1] = phantom.tissue.layers[0];
    phantom.tissue.layers[0].thickness_mm = apart_mm;
    phantom.tissue.layers[0].stiffness_n_per_mm = 2.0;
    phantom.tissue.layers[1].stiffness_n_per_mm = 2.0;
    phantom.tissue.layers[1].thickness_mm = 140.0;
    phantom.tissue.layers[1].rupture_n = 1.5;
    box_force_lay(&rig.box.force, &phantom);
    by_hand_zero(&rig);
}

/* It cannot follow its set-point to the last tick: half of the amplitude it makes at least. */
void test_SWR_VIB_700_each_puncture_is_felt_as_a_motion_of_the_true_needle(void)
{
    insert_as_usual();
    TEST_ASSERT_EQUAL_UINT32(2U, found());
    TEST_ASSERT_EQUAL_UINT32(2U, witness.count);
    TEST_ASSERT_TRUE(witness.farthest_ticks >
                     (0.5 * (double)robot_prostate.vibration.amplitude_ticks));
}

void test_SWR_VIB_707_the_true_needle_stays_behind_and_ends_where_it_began(void)
{
    insert_as_usual();
    expect_behind();
    TEST_ASSERT_TRUE(witness.ended_ticks <= (LIMIT_VIBRATION_DEEPER_UM * TICKS_PER_UM));
}

/* It jerks and presses as hard as the sensor shows while it vibrates, and inserts in between. */
void test_SWR_VIB_707_nor_does_any_hand_lead_it_forward(void)
{
    uint32_t vibrations = 0U;
    for (uint32_t scene = 0U; scene < SCENES(RANDOM_SCENES); scene++) {
        setUp();
        random_state = scene;
        begin();
        for (uint32_t i = 0U; (i < LONG_CYCLES) && !is_over(); i++) {
            if (is_vibrating() && (random_below(30U) == 0U)) {
                by_hand_push(&rig, SOFT_MN + (int32_t)random_below(3000U));
            }
            if (is_vibrating() && (random_below(2000U) == 0U)) {
                rig_box(&rig, "hand release");
            }
            cycle(SOFT_MN + (int32_t)random_below(600U));
        }
        expect_behind();
        vibrations += witness.count;
    }
    TEST_ASSERT_GREATER_THAN_UINT32(SCENES(RANDOM_SCENES), vibrations);
}

/* The motor may be a fifth faster or slower than its model. */
void test_SWR_VIB_707_nor_does_another_motor(void)
{
    static const double paces[] = {0.8, 0.9, 1.1, 1.2};
    for (uint32_t i = 0U; i < SCENES(sizeof paces / sizeof paces[0]); i++) {
        setUp();
        rig.box.axes[BY_HAND_NEEDLE].motor.full_speed_ticks_per_s *= paces[i];
        count_balance_init(
            &rig.controller.axes[BY_HAND_NEEDLE].supervision.sealed.account); /* Another motor. */
        controller_seal(&rig.controller);
        insert();
        expect_behind();
        TEST_ASSERT_EQUAL_UINT32(2U, witness.count);
    }
}

/* The needle stands in front of all tissue, and of its target by this way. */
static void insert_before_tissue(double surface_mm, double before_mm)
{
    setUp();
    lay_membranes(6.0);
    rig.box.force.phantom.tissue.surface_mm = surface_mm;
    box_force_heal(&rig.box.force);
    begin();
    for (uint32_t i = 0U;
         (i < LONG_CYCLES) && (needle_ticks() < (target_ticks() - (before_mm * TICKS_PER_MM)));
         i++) {
        cycle(GRIP_MN);
    }
}

/* Untouched tissue of which only the surface is elsewhere. */
static void move_surface(double surface_mm)
{
    rig.box.force.phantom.tissue.surface_mm = surface_mm;
    box_force_heal(&rig.box.force);
    TEST_ASSERT_TRUE(box_depth_mm(&rig.box) < surface_mm);
}

/* The needle comes to rest for it just in front of its depth, or there. */
void test_SWR_VIB_707_nor_beyond_the_target_behind_a_membrane_close_to_it(void)
{
    static moment_t before;
    lay_membranes(6.0);
    const double surface_mm = rig.box.force.phantom.tissue.surface_mm;
    begin_vibration_in_this_tissue();
    const double left_mm = (target_ticks() - witness.begin_ticks) / TICKS_PER_MM;
    uint32_t vibrations = 0U;
    insert_before_tissue(surface_mm + left_mm, BEFORE_MM);
    keep(&before);
    for (uint32_t i = 0U; i < NEAR_TRIALS; i++) {
        go_on_from(&before);
        move_surface(surface_mm + left_mm + 0.02 - (0.01 * (double)i));
        finish();
        expect_behind();
        vibrations += witness.count;
        TEST_ASSERT_LESS_OR_EQUAL_UINT32(1U, witness.count);
    }
    TEST_ASSERT_GREATER_THAN_UINT32(0U, vibrations);
    TEST_ASSERT_LESS_THAN_UINT32(NEAR_TRIALS, vibrations);
}

/* Two membranes are farther apart than a puncture hides; the second one is found as well. */
void test_SWR_VIB_705_it_is_blind_meanwhile_and_sees_again_afterwards(void)
{
    lay_membranes(6.0);
    insert();
    TEST_ASSERT_EQUAL_UINT32(2U, rig.box.force.tissue.popped);
    TEST_ASSERT_EQUAL_UINT32(2U, found());
    TEST_ASSERT_EQUAL_UINT32(2U, witness.count);
}

void test_SWR_VIB_705_a_membrane_close_behind_another_begins_no_second_one(void)
{
    lay_membranes(1.0);
    insert();
    TEST_ASSERT_EQUAL_UINT32(2U, rig.box.force.tissue.popped);
    TEST_ASSERT_EQUAL_UINT32(1U, found());
    TEST_ASSERT_EQUAL_UINT32(1U, witness.count);
}

/* Its force falls while it vibrates, as that of a puncture does. */
void test_SWR_VIB_705_nothing_is_found_while_it_vibrates(void)
{
    begin_vibration();
    const uint32_t before = found();
    sim_phantom_file_t none = rig.box.force.phantom;
    none.tissue.layer_count = 0U;
    box_force_lay(&rig.box.force, &none);
    while (is_vibrating()) {
        TEST_ASSERT_EQUAL_UINT32(1U, rig.controller.membranes.run.detector.is_blind);
        cycle(GRIP_MN);
        TEST_ASSERT_EQUAL_UINT32(before, found());
    }
}
