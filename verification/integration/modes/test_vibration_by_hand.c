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

#include <math.h>
#include <stdio.h>

#define ENTRY_Z_NM 32000000
#define TARGET_Z_NM 92000000
#define LONG_CYCLES 60000U
#define GRIP_MN 800
#define TICKS_PER_MM 1666.67
#define TICKS_PER_UM (TICKS_PER_MM / 1000.0)
#define STILL_TICKS 3.0 /* Way that a motor runs on after it was switched off. */
#define PUSH_CYCLES 5000U
#define FILTERED_CYCLES 30U /* From a hand that lets go to a force below the dead zone. */
#define BEGUN_CYCLES 60U    /* After a puncture its stroke has surely begun. */
#define RANDOM_SCENES 25U
#define SOFT_MN 500
#define NEAR_TRIALS 10U
#define BEFORE_MM 8.0 /* More than a membrane yields before it ruptures. */

static const command_t cooperate = {.kind = (uint32_t)COMMAND_COOPERATE};

/* The true needle through one vibration. */
typedef struct {
    bool was_on;
    bool has_begun; /* The set-point has gone back. */
    double begin_ticks;
    double deepest_ticks; /* The largest way beyond where one began. */
    double farthest_ticks;
    double ended_ticks; /* The largest distance between end and beginning of one that was whole. */
    uint32_t count;
} witness_t;

/* All that a test has come to, so that another one goes on from there without playing the same
 * again. */
typedef struct {
    bool is_kept;
    rig_t rig;
    uint32_t pushed;
    witness_t witness;
} moment_t;

static rig_t rig;
static uint32_t pushed;
static witness_t witness;
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

static void keep(moment_t *moment)
{
    *moment = (moment_t){true, rig, pushed, witness};
}

static void go_on_from(const moment_t *moment)
{
    rig = moment->rig;
    pushed = moment->pushed;
    witness = moment->witness;
}

static uint32_t random_below(uint32_t count)
{
    random_state = (random_state * UINT64_C(6364136223846793005)) + UINT64_C(1442695040888963407);
    return (uint32_t)(random_state >> 33U) % count;
}

static double needle_ticks(void)
{
    return rig.box.axes[BY_HAND_NEEDLE].motor.position_ticks;
}

static double target_ticks(void)
{
    return (double)rig.controller.plan.target_ticks[BY_HAND_NEEDLE];
}

static bool is_vibrating(void)
{
    return rig.outputs.snapshot.membranes.sight == (uint32_t)MEMBRANE_SIGHT_VIBRATING;
}

static bool is_driven(void)
{
    return rig.outputs.snapshot.axes[BY_HAND_NEEDLE].drive_mode != (uint32_t)CARD_DRIVE_OFF;
}

static bool is_over(void)
{
    return rig.outputs.snapshot.order == (uint32_t)ARMING_STATE_NONE;
}

static int32_t speed_q8(void)
{
    return rig.outputs.snapshot.axes[BY_HAND_NEEDLE].setpoint_speed_ticks_per_s_q8;
}

static uint32_t found(void)
{
    return rig_count(&rig, EVENT_MEMBRANE_FOUND) + rig_count(&rig, EVENT_MEMBRANE_UNEXPECTED);
}

/* Where it truly stands, before the first stroke, is where the vibration begins. */
static void look(void)
{
    const bool is_on = is_vibrating();
    if (is_on && !witness.has_begun && (speed_q8() < 0)) {
        witness.has_begun = true;
        witness.begin_ticks = needle_ticks();
        witness.count++;
    }
    if (is_on && witness.has_begun) {
        const double deeper_ticks = needle_ticks() - witness.begin_ticks;
        witness.deepest_ticks = fmax(witness.deepest_ticks, deeper_ticks);
        witness.farthest_ticks = fmax(witness.farthest_ticks, -deeper_ticks);
    }
    if (!is_on && witness.was_on && witness.has_begun) {
        witness.ended_ticks = fmax(witness.ended_ticks, fabs(needle_ticks() - witness.begin_ticks));
    }
    witness.has_begun = witness.has_begun && is_on;
    witness.was_on = is_on;
    TEST_ASSERT_TRUE(needle_ticks() <=
                     (target_ticks() + (LIMIT_VIBRATION_DEEPER_UM * TICKS_PER_UM)));
}

static void expect_behind(void)
{
    TEST_ASSERT_TRUE(witness.deepest_ticks <= (LIMIT_VIBRATION_DEEPER_UM * TICKS_PER_UM));
    TEST_ASSERT_TRUE(witness.farthest_ticks <= (LIMIT_VIBRATION_MOST_UM * TICKS_PER_UM));
}

static void begin(void)
{
    by_hand_enter(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, cooperate).status);
    rig_press(&rig);
    pushed = 0U;
}

/* No push lasts so long that it moves nothing any more. */
static void cycle(int32_t force_mn)
{
    if ((pushed % PUSH_CYCLES) == 0U) {
        by_hand_push(&rig, force_mn);
    } else if (((pushed % PUSH_CYCLES) == (PUSH_CYCLES - BY_HAND_OFF_CYCLES)) && !is_vibrating()) {
        rig_box(&rig, "hand release");
    } else {
        /* As it is. */
    }
    rig_cycle(&rig);
    pushed++;
    look();
}

/* The needle is in its first stroke, a little behind where it began. */
static void begin_vibration_in_this_tissue(void)
{
    begin();
    for (uint32_t i = 0U; (i < LONG_CYCLES) && !witness.has_begun; i++) {
        cycle(GRIP_MN);
    }
    for (uint32_t i = 0U; i < BEGUN_CYCLES; i++) {
        cycle(GRIP_MN);
    }
    TEST_ASSERT_TRUE(is_vibrating());
    TEST_ASSERT_TRUE((witness.begin_ticks - needle_ticks()) > (10.0 * TICKS_PER_UM));
}

/* In the usual tissue, from setUp() on. */
static void begin_vibration(void)
{
    static moment_t begun;
    if (!begun.is_kept) {
        begin_vibration_in_this_tissue();
        keep(&begun);
    }
    go_on_from(&begun);
}

static void finish(void)
{
    for (uint32_t i = 0U; (i < LONG_CYCLES) && !is_over(); i++) {
        cycle(GRIP_MN);
    }
    TEST_ASSERT_TRUE(is_over());
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig.answers[rig.answer_count - 1U].kind);
}

static void insert(void)
{
    begin();
    finish();
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

/* In each part of the vibration. */
void test_SWR_VIB_704_without_the_pedal_it_stops_in_the_same_cycle_and_is_not_resumed(void)
{
    for (uint32_t after = 0U; after < 400U; after += 23U) {
        setUp();
        begin_vibration();
        for (uint32_t i = 0U; i < after; i++) {
            cycle(GRIP_MN);
        }
        rig_box(&rig, "pedal release");
        const uint32_t pressed = rig.outputs.snapshot.pedal;
        while (rig.outputs.snapshot.pedal == pressed) {
            rig_cycle(&rig);
        }
        TEST_ASSERT_FALSE(is_driven());
        rig_cycle(&rig);
        TEST_ASSERT_FALSE(is_vibrating());
        const double there = needle_ticks();
        rig_cycles(&rig, 300U);
        TEST_ASSERT_DOUBLE_WITHIN(STILL_TICKS, there, needle_ticks());
        rig_box(&rig, "hand release");
        rig_cycles(&rig, BY_HAND_OFF_CYCLES);
        rig_press(&rig);
        rig_cycles(&rig, 300U);
        TEST_ASSERT_FALSE(is_vibrating());
        TEST_ASSERT_DOUBLE_WITHIN(STILL_TICKS, there, needle_ticks());
    }
}

void test_SWR_VIB_704_without_the_hand_it_stops_soon(void)
{
    begin_vibration();
    rig_box(&rig, "hand release");
    rig_cycles(&rig, FILTERED_CYCLES);
    TEST_ASSERT_FALSE(is_driven());
    TEST_ASSERT_FALSE(is_vibrating());
    const double there = needle_ticks();
    rig_cycles(&rig, 500U);
    TEST_ASSERT_DOUBLE_WITHIN(STILL_TICKS, there, needle_ticks());
}

/* Whatever ends the insertion ends it, in the cycle that notices. */
void test_SWR_VIB_704_scanner_emergency_stop_and_doubt_end_it(void)
{
    static const char *const ends[] = {"scanner on", "estop pull", "force hand broken"};
    for (uint32_t i = 0U; i < (sizeof ends / sizeof ends[0]); i++) {
        setUp();
        begin_vibration();
        rig_box(&rig, ends[i]);
        uint32_t cycles = 0U;
        while (is_vibrating() && (cycles < 20U)) {
            rig_cycle(&rig);
            cycles++;
        }
        TEST_ASSERT_FALSE(is_driven());
        TEST_ASSERT_FALSE(is_vibrating());
        const double there = needle_ticks();
        rig_cycles(&rig, 500U);
        TEST_ASSERT_DOUBLE_WITHIN(STILL_TICKS, there, needle_ticks());
    }
}

/* Where the last event of the kind says that it was. */
static int32_t last_um(event_id_t id)
{
    int32_t depth_um = INT32_MIN;
    for (uint32_t i = 0U; i < rig.event_count; i++) {
        depth_um = (rig.events[i].id == (uint32_t)id) ? (rig.events[i].value / 1000) : depth_um;
    }
    return depth_um;
}

static uint32_t cuts(void)
{
    return rig_count(&rig, EVENT_VIBRATION_CUT);
}

void test_SWR_VIB_753_each_that_begins_is_in_the_log(void)
{
    insert();
    TEST_ASSERT_EQUAL_UINT32(2U, rig_count(&rig, EVENT_VIBRATION_BEGUN));
    TEST_ASSERT_EQUAL_UINT32(0U, cuts());
}

void test_SWR_VIB_753_one_that_is_ended_is_in_the_log_whatever_ends_it(void)
{
    static const char *const ends[] = {"hand release", "pedal release", "scanner on",
                                       "force hand broken"};
    for (uint32_t i = 0U; i < (sizeof ends / sizeof ends[0]); i++) {
        setUp();
        begin_vibration();
        TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_VIBRATION_BEGUN));
        TEST_ASSERT_EQUAL_UINT32(0U, cuts());
        const int32_t there_um = rig.outputs.snapshot.membranes.depth_um;
        rig_box(&rig, ends[i]);
        rig_cycles(&rig, 2U * FILTERED_CYCLES);
        TEST_ASSERT_EQUAL_UINT32(1U, cuts());
        TEST_ASSERT_INT32_WITHIN((int32_t)LIMIT_VIBRATION_MOST_UM, there_um,
                                 last_um(EVENT_VIBRATION_CUT));
        TEST_ASSERT_GREATER_OR_EQUAL_INT32(there_um, last_um(EVENT_VIBRATION_BEGUN));
    }
}

/* It pushes hardest just behind the membrane, as it has braced itself against a needle that stood.
 */
void test_SWR_VIB_703_a_hand_that_never_lets_go_leads_it_nowhere_afterwards(void)
{
    begin_vibration();
    by_hand_push(&rig, 2 * GRIP_MN);
    while (is_vibrating()) {
        rig_cycle(&rig);
        look();
    }
    const double there = needle_ticks();
    rig_cycles(&rig, 2000U);
    TEST_ASSERT_FALSE(is_driven());
    TEST_ASSERT_TRUE(fabs(needle_ticks() - there) <= TICKS_PER_UM);
    TEST_ASSERT_NOT_EQUAL_HEX32(0U, rig.outputs.snapshot.axes[BY_HAND_NEEDLE].permit_reasons &
                                        permit_reason(true, PERMIT_REASON_HAND_UNPROVEN));
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_LET_GO, rig.outputs.snapshot.next_step);
    rig_box(&rig, "hand release");
    rig_cycles(&rig, BY_HAND_OFF_CYCLES);
    by_hand_push(&rig, GRIP_MN);
    rig_cycles(&rig, BY_HAND_OFF_CYCLES);
    TEST_ASSERT_TRUE(is_driven());
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
