/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: two carriages stay inside the limit that they share, wherever they are driven.
 * On the simulated box, whose true positions are looked at.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "controller/controller.h"
#include "robot/robot_neuro.h"
#include "supervise/scenario/prng.h"
#include "unit/support/scenes.h"

#include "integration/support/jog_world.inc"

#define HOME_MM 143.0
#define LEAST_MM 75.0
#define MOST_MM 146.0

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static double true_mm(uint32_t axis)
{
    return rig.box.axes[axis].motor.position_ticks / 78.74;
}

static double separation_mm(void)
{
    return HOME_MM + true_mm(NEURO_AXIS_HEAD) - true_mm(NEURO_AXIS_FEET);
}

static void cycle_apart(void)
{
    rig_cycle(&rig);
    TEST_ASSERT_TRUE((separation_mm() >= LEAST_MM) && (separation_mm() <= MOST_MM));
}

/* A jog whose end was damaged after it had been accepted, until it is given up. */
static void run_into_limit(uint32_t axis, int32_t accepted, int32_t damaged)
{
    bool has_stood = false;
    start_manual();
    expect_jog(axis, accepted, STATUS_OK);
    rig.controller.mode.request.sealed.way.end_ticks = damaged;
    controller_seal(&rig.controller);
    rig_press(&rig);
    while (rig.outputs.snapshot.order != (uint32_t)ARMING_STATE_NONE) {
        cycle_apart();
        has_stood = has_stood || has_reason(axis, PERMIT_REASON_COUPLED_LIMIT);
    }
    TEST_ASSERT_TRUE(has_stood);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ORDER_OVERDUE));
}

void test_SWR_COUPLE_001_the_head_driven_towards_the_feet_stops_inside_of_the_limit(void)
{
    run_into_limit(NEURO_AXIS_HEAD, -5300, -11418);
    TEST_ASSERT_DOUBLE_WITHIN(0.1, LEAST_MM + 0.1, separation_mm());
}

void test_SWR_COUPLE_001_the_feet_driven_away_from_the_head_stop_inside_of_the_limit(void)
{
    run_into_limit(NEURO_AXIS_FEET, -200, -5000);
    TEST_ASSERT_DOUBLE_WITHIN(0.1, MOST_MM - 0.1, separation_mm());
}

/* A move whose ends were damaged. */
static void begin_wrong_move(int32_t head_ticks, int32_t feet_ticks)
{
    rig_start_targeted(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    rig.controller.mode.request.sealed.move.target_ticks[NEURO_AXIS_HEAD] = head_ticks;
    rig.controller.mode.request.sealed.move.target_ticks[NEURO_AXIS_FEET] = feet_ticks;
    controller_seal(&rig.controller);
}

void test_SWR_COUPLE_001_two_carriages_that_move_at_once_stop_inside_of_the_limit(void)
{
    static const int32_t ends[][2] = {{-8000, 4000}, {-2000, 5900}, {-11000, 500}, {-20, -3000}};
    for (uint32_t i = 0U; i < SCENES(sizeof ends / sizeof ends[0]); i++) {
        begin_wrong_move(ends[i][0], ends[i][1]);
        rig_press(&rig);
        while (rig.outputs.snapshot.order != (uint32_t)ARMING_STATE_NONE) {
            cycle_apart();
        }
        TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_ORDER_DONE));
        TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ORDER_DISCARDED));
    }
}

static uint32_t random_state = 1U;

static uint32_t below(uint32_t bound)
{
    return prng_below(&random_state, bound);
}

void test_SWR_COUPLE_001_a_pedal_pressed_and_released_at_random_keeps_them_inside(void)
{
    for (uint32_t i = 0U; i < SCENES(12U); i++) {
        begin_wrong_move(-(int32_t)below(11418U), (int32_t)below(11000U) - 5500);
        for (uint32_t k = 0U; k < 15U; k++) {
            rig_box(&rig, ((k % 2U) == 0U) ? "pedal press" : "pedal release");
            const uint32_t cycles = 20U + below(((k % 2U) == 0U) ? 3000U : 50U);
            for (uint32_t n = 0U; n < cycles; n++) {
                cycle_apart();
            }
        }
    }
}

void test_SWR_COUPLE_001_from_outside_of_the_limit_only_the_way_back_is_free(void)
{
    start_manual();
    go(NEURO_AXIS_HEAD, -5000);
    shift(NEURO_AXIS_HEAD, -1000);
    expect_jog(NEURO_AXIS_HEAD, -5000, STATUS_OK);
    rig.controller.mode.request.sealed.way.end_ticks = -7000;
    controller_seal(&rig.controller);
    rig_press(&rig);
    const int32_t start = position(NEURO_AXIS_HEAD);
    rig_cycles(&rig, 2000U);
    TEST_ASSERT_EQUAL_INT32(start, position(NEURO_AXIS_HEAD));
    TEST_ASSERT_TRUE(has_reason(NEURO_AXIS_HEAD, PERMIT_REASON_COUPLED_LIMIT));
    rig_release(&rig);
    go(NEURO_AXIS_HEAD, -5000);
}

void test_SWR_COUPLE_001_the_limit_is_not_in_force_before_both_are_homed(void)
{
    start_manual();
    go(NEURO_AXIS_HEAD, -5000);
    shift(NEURO_AXIS_HEAD, -1000);
    axis_lose_reference(&rig.controller.axes[NEURO_AXIS_FEET]);
    go(NEURO_AXIS_HEAD, -6100);
}

void test_SWR_COUPLE_002_a_jog_that_would_end_beyond_the_limit_is_refused_by_name(void)
{
    start_manual();
    answer_t answer = jog(NEURO_AXIS_HEAD, -11418);
    TEST_ASSERT_EQUAL_UINT32(STATUS_SEPARATION_LIMIT, answer.status);
    TEST_ASSERT_EQUAL_UINT32(0U, answer_as_shared_limit(&answer)->is_maximum);
    answer = jog(NEURO_AXIS_FEET, -5000);
    TEST_ASSERT_EQUAL_UINT32(STATUS_SEPARATION_LIMIT, answer.status);
    TEST_ASSERT_EQUAL_UINT32(1U, answer_as_shared_limit(&answer)->is_maximum);
    answer = jog(NEURO_AXIS_FEET, -5513);
    TEST_ASSERT_EQUAL_UINT32(STATUS_AXIS_LIMIT, answer.status);
    TEST_ASSERT_EQUAL_UINT32(0U, answer_as_limit(&answer)->is_maximum);
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
    expect_jog(NEURO_AXIS_HEAD, -5338, STATUS_OK);
    expect_jog(NEURO_AXIS_HEAD, -5339, STATUS_SEPARATION_LIMIT);
}

void test_SWR_COUPLE_002_a_target_and_a_jog_at_the_margin_are_reached(void)
{
    start_manual();
    go(NEURO_AXIS_HEAD, -5338);
    TEST_ASSERT_EQUAL_INT32(-5338, position(NEURO_AXIS_HEAD));
    go(NEURO_AXIS_HEAD, -20);
    go(NEURO_AXIS_FEET, -200);
    TEST_ASSERT_EQUAL_INT32(-200, position(NEURO_AXIS_FEET));
}

/* Both carriages are far out, and the head is in doubt: at its switch they would be too far apart.
 */
static void lose_head_far_out(void)
{
    start_manual();
    go(NEURO_AXIS_HEAD, -3500);
    go(NEURO_AXIS_FEET, -3000);
    rig_box(&rig, "card head silent");
    rig_cycles(&rig, LIMIT_SILENT_KEPT_CYCLES + 20U);
    rig_box(&rig, "card head normal");
    rig_cycles(&rig, 20U);
    rig_forget(&rig);
    TEST_ASSERT_FALSE(axis_is_homed(&rig.controller.axes[NEURO_AXIS_HEAD]));
}

/* START_UP with the pedal held, until it ends. */
static void start_up_apart(answer_kind_t expected)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_press(&rig);
    for (uint32_t i = 0U; rig.outputs.snapshot.order != (uint32_t)ARMING_STATE_NONE; i++) {
        TEST_ASSERT_LESS_THAN_UINT32(100000U, i);
        cycle_apart();
    }
    rig_release(&rig);
    TEST_ASSERT_EQUAL_UINT32(expected, rig.answers[rig.answer_count - 1U].kind);
}

void test_SWR_COUPLE_003_homing_that_the_limit_bars_is_discarded_by_name(void)
{
    lose_head_far_out();
    const double before = true_mm(NEURO_AXIS_HEAD);
    start_up_apart(ANSWER_ABORTED);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_HOMING_BARRED));
    TEST_ASSERT_EQUAL_DOUBLE(before, true_mm(NEURO_AXIS_HEAD));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    while (position(NEURO_AXIS_FEET) < -200) {
        go(NEURO_AXIS_FEET, position(NEURO_AXIS_FEET) + 150); /* A short way only. */
    }
    rig_forget(&rig);
    start_up_apart(ANSWER_DONE);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_HOMING_BARRED));
    TEST_ASSERT_DOUBLE_WITHIN(0.1, 0.0, true_mm(NEURO_AXIS_HEAD));
}

void test_SWR_COUPLE_003_no_jog_drives_the_head_towards_a_switch_that_the_limit_bars(void)
{
    lose_head_far_out();
    const double before = true_mm(NEURO_AXIS_HEAD);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    expect_jog(NEURO_AXIS_HEAD, position(NEURO_AXIS_HEAD) + 100, STATUS_OK);
    rig_press(&rig);
    for (uint32_t i = 0U; i < 500U; i++) {
        rig_cycle(&rig);
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
    }
    TEST_ASSERT_TRUE(has_reason(NEURO_AXIS_HEAD, PERMIT_REASON_COUPLED_LIMIT));
    rig_release(&rig);
    go(NEURO_AXIS_HEAD, position(NEURO_AXIS_HEAD) - 100);
    TEST_ASSERT_DOUBLE_WITHIN(0.1, before - (100.0 / 78.74), true_mm(NEURO_AXIS_HEAD));
}
