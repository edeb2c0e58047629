/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: two carriages stay inside the limit that they share wherever they are driven,
 * and a jog does nothing with the needle, with an axis that is not homed, or for a sender that is
 * not entitled, that it must not do. On the simulated box, whose true positions are looked at.
 */
#include "unit/support/commands.h"
#include "integration/support/rig.h"

#include "unity.h"

#include "controller/controller.h"
#include "robot/robot_neuro.h"
#include "safety/needle.h"
#include "safety/permit.h"
#include "supervise/scenario/prng.h"
#include "unit/support/scenes.h"

#define HOME_MM 143.0
#define LEAST_MM 75.0
#define MOST_MM 146.0

static rig_t rig;

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

static bool has_reason(uint32_t axis, permit_reason_t reason)
{
    return (rig.outputs.snapshot.axes[axis].permit_reasons & (1UL << reason)) != 0U;
}

static int32_t position(uint32_t axis)
{
    return rig.outputs.snapshot.axes[axis].position_ticks;
}

static answer_t jog(uint32_t axis, int32_t ticks)
{
    const command_t command = {.kind = (uint32_t)COMMAND_JOG,
                               .as.jog = {.axis = axis, .to_ticks = ticks}};
    return rig_command(&rig, command);
}

static void expect_jog(uint32_t axis, int32_t ticks, status_t status)
{
    TEST_ASSERT_EQUAL_UINT32(status, jog(axis, ticks).status);
}

/* Jogs there. */
static void go(uint32_t axis, int32_t ticks)
{
    expect_jog(axis, ticks, STATUS_OK);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 30000U).kind);
    rig_release(&rig);
}

static void start_manual(void)
{
    rig_start_homed(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
}

/* The axis is counted elsewhere, as if it had crept there unnoticed. */
static void shift(uint32_t axis, int32_t ticks)
{
    axis_t *const shifted = &rig.controller.axes[axis];
    encoder_set_position(&shifted->sealed.encoder, shifted->sealed.encoder.position_ticks + ticks);
    supervision_shift(&shifted->supervision, ticks);
    drift_audit_settle(&shifted->sealed.drift);
    controller_seal(&rig.controller);
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

void test_SWR_JOG_002_an_axis_that_shares_a_limit_with_one_not_homed_goes_a_short_way_only(void)
{
    start_manual();
    go(NEURO_AXIS_HEAD, -1000);
    axis_lose_reference(&rig.controller.axes[NEURO_AXIS_FEET]);
    expect_jog(NEURO_AXIS_HEAD, -1158, STATUS_JOG_TOO_FAR);
    expect_jog(NEURO_AXIS_HEAD, -1157, STATUS_OK);
    expect_jog(NEURO_AXIS_LATERAL, -2000, STATUS_OK);
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

static void expect_needle(bool is_in)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const bool is_across = robot_neuro.axes[i].needle_motion == (uint32_t)NEEDLE_ACROSS;
        expect_jog(
            i, position(i) + (((i == NEURO_AXIS_FEET) || (i == NEURO_AXIS_INSERTION)) ? 20 : -20),
            (is_in && is_across) ? STATUS_NEEDLE_IN : STATUS_OK);
    }
}

void test_SWR_JOG_001_no_axis_is_jogged_across_a_needle_that_is_in(void)
{
    start_manual();
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        if (robot_neuro.axes[i].limit_switch == (uint8_t)LIMIT_SWITCH_UPPER) {
            go(i, robot_neuro.axes[i].home_ticks - 100);
        }
    }
    go(NEURO_AXIS_INSERTION, 2000);
    shift(NEURO_AXIS_INSERTION, needle_out_ticks(&robot_neuro) - position(NEURO_AXIS_INSERTION));
    rig_cycle(&rig);
    expect_needle(false);
    shift(NEURO_AXIS_INSERTION, 1);
    rig_cycle(&rig);
    expect_needle(true);
}

void test_SWR_JOG_001_no_axis_is_jogged_across_a_needle_that_is_not_homed(void)
{
    rig_start(&rig);
    (void)rig_workphase(&rig, WORKPHASE_START_UP);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    expect_jog(NEURO_AXIS_LATERAL, -20, STATUS_NEEDLE_IN);
    rig_box(&rig, "switch insertion stuck");
    rig_cycles(&rig, 30U);
    expect_jog(NEURO_AXIS_LATERAL, -20, STATUS_NEEDLE_IN);
    expect_jog(NEURO_AXIS_ROTATION, -20, STATUS_OK);
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

/* The jogged axis reports it in every cycle, whether it is driven just then or not. */
void test_SWR_JOG_001_a_needle_that_comes_in_stops_the_jog_that_runs(void)
{
    start_manual();
    go(NEURO_AXIS_INSERTION, 2000);
    shift(NEURO_AXIS_INSERTION, needle_out_ticks(&robot_neuro) - position(NEURO_AXIS_INSERTION));
    expect_jog(NEURO_AXIS_LATERAL, -2000, STATUS_OK);
    rig_press(&rig);
    rig_cycles(&rig, 500U);
    TEST_ASSERT_FALSE(has_reason(NEURO_AXIS_LATERAL, PERMIT_REASON_NEEDLE_IN));
    shift(NEURO_AXIS_INSERTION, 100);
    for (uint32_t i = 0U; i < 500U; i++) {
        rig_cycle(&rig);
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
        TEST_ASSERT_TRUE(has_reason(NEURO_AXIS_LATERAL, PERMIT_REASON_NEEDLE_IN));
        TEST_ASSERT_FALSE(has_reason(NEURO_AXIS_PITCH, PERMIT_REASON_NEEDLE_IN));
    }
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_RELEASE_PEDAL, rig.outputs.snapshot.next_step);
    rig_release(&rig);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_START_UP, rig.outputs.snapshot.next_step);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    TEST_ASSERT_FALSE(has_reason(NEURO_AXIS_LATERAL, PERMIT_REASON_NEEDLE_IN));
}

void test_SWR_JOG_002_an_axis_that_is_not_homed_is_jogged_a_short_way_only(void)
{
    static const int32_t most[ROBOT_AXIS_MAX] = {157, 157, 94, 6666, 44, 27, 27};
    rig_start_needle_homed(&rig);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        if (i != (uint32_t)NEURO_AXIS_INSERTION) {
            axis_lose_reference(&rig.controller.axes[i]);
            expect_jog(i, position(i) + most[i], STATUS_OK);
            expect_jog(i, position(i) - most[i], STATUS_OK);
            expect_jog(i, position(i) + most[i] + 1, STATUS_JOG_TOO_FAR);
            expect_jog(i, position(i) - most[i] - 1, STATUS_JOG_TOO_FAR);
        }
    }
    axis_lose_reference(&rig.controller.axes[NEURO_AXIS_INSERTION]);
    expect_jog(NEURO_AXIS_INSERTION, position(NEURO_AXIS_INSERTION) - most[NEURO_AXIS_INSERTION],
               STATUS_OK);
    expect_jog(NEURO_AXIS_INSERTION,
               position(NEURO_AXIS_INSERTION) - most[NEURO_AXIS_INSERTION] - 1, STATUS_JOG_TOO_FAR);
    expect_jog(NEURO_AXIS_YAW, INT32_MIN, STATUS_NEEDLE_IN);
    expect_jog(NEURO_AXIS_ROTATION, INT32_MIN, STATUS_JOG_TOO_FAR);
}

void test_SWR_JOG_002_however_often_the_pedal_is_pressed_the_jog_ends_where_it_was_accepted(void)
{
    rig_start_needle_homed(&rig);
    const int32_t end = position(NEURO_AXIS_HEAD) - 157;
    expect_jog(NEURO_AXIS_HEAD, end, STATUS_OK);
    for (uint32_t i = 0U; i < 5U; i++) {
        rig_press(&rig);
        rig_cycles(&rig, 200U);
        rig_release(&rig);
        TEST_ASSERT_GREATER_OR_EQUAL_INT32(end, position(NEURO_AXIS_HEAD));
    }
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 2000U).kind);
    TEST_ASSERT_EQUAL_INT32(end, position(NEURO_AXIS_HEAD));
}

static void start_unhomed(void)
{
    rig_start(&rig);
    (void)rig_workphase(&rig, WORKPHASE_START_UP);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    rig_forget(&rig);
}

void test_SWR_JOG_003_a_needle_that_is_not_homed_is_jogged_outwards_only(void)
{
    start_unhomed();
    expect_jog(NEURO_AXIS_INSERTION, position(NEURO_AXIS_INSERTION) + 1, STATUS_NEEDLE_IN);
    const double before = rig.box.axes[NEURO_AXIS_INSERTION].motor.position_ticks;
    go(NEURO_AXIS_INSERTION, position(NEURO_AXIS_INSERTION) - 1500);
    TEST_ASSERT_DOUBLE_WITHIN(10.0, before - 1500.0,
                              rig.box.axes[NEURO_AXIS_INSERTION].motor.position_ticks);
}

void test_SWR_JOG_003_a_needle_that_is_not_homed_is_never_driven_inwards(void)
{
    start_unhomed();
    expect_jog(NEURO_AXIS_INSERTION, position(NEURO_AXIS_INSERTION) - 100, STATUS_OK);
    rig.controller.mode.request.sealed.way.end_ticks = 5000;
    controller_seal(&rig.controller);
    rig_press(&rig);
    for (uint32_t i = 0U; i < 1000U; i++) {
        rig_cycle(&rig);
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
    }
    TEST_ASSERT_TRUE(has_reason(NEURO_AXIS_INSERTION, PERMIT_REASON_NEEDLE_IN));
}

/* From 1 mm it is asked to come out by 2 mm. */
void test_SWR_JOG_003_a_needle_that_meets_its_switch_stops_there_and_the_jog_ends_by_name(void)
{
    start_unhomed();
    expect_jog(NEURO_AXIS_INSERTION, position(NEURO_AXIS_INSERTION) - 6666, STATUS_OK);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 20000U).kind);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ORDER_OVERDUE));
    TEST_ASSERT_DOUBLE_WITHIN(60.0, 0.0, rig.box.axes[NEURO_AXIS_INSERTION].motor.position_ticks);
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_ENABLED,
                             rig.outputs.snapshot.axes[NEURO_AXIS_INSERTION].power);
}

void test_SWR_JOG_004_a_jog_drives_no_other_axis(void)
{
    start_manual();
    expect_jog(NEURO_AXIS_INSERTION, 20000, STATUS_OK);
    rig_press(&rig);
    rig_cycles(&rig, 100U);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        if (i != (uint32_t)NEURO_AXIS_INSERTION) {
            shift(i, 5);
        }
    }
    while (rig.outputs.snapshot.order != (uint32_t)ARMING_STATE_NONE) {
        rig_cycle(&rig);
        for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
            TEST_ASSERT_TRUE((i == (uint32_t)NEURO_AXIS_INSERTION) ||
                             (rig_sent(&rig, i).drive.mode == (uint32_t)CARD_DRIVE_OFF));
        }
    }
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ORDER_DONE));
}

static void expect_goal(uint32_t axis, int32_t goal_ticks)
{
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_INT32(goal_ticks, rig.outputs.snapshot.axes[axis].target_ticks);
}

static void expect_no_goal(uint32_t axis)
{
    rig_cycle(&rig);
    const snapshot_axis_t *const shown = &rig.outputs.snapshot.axes[axis];
    TEST_ASSERT_EQUAL_INT32(shown->setpoint_ticks, shown->target_ticks);
}

void test_SWR_CON_048_the_goal_of_a_jog_is_shown_while_it_is_armed(void)
{
    start_manual();
    expect_no_goal(NEURO_AXIS_INSERTION);
    expect_jog(NEURO_AXIS_INSERTION, 20000, STATUS_OK);
    expect_goal(NEURO_AXIS_INSERTION, 20000);
    expect_no_goal(NEURO_AXIS_YAW);
    rig_press(&rig);
    rig_cycles(&rig, 200U);
    TEST_ASSERT_LESS_THAN_INT32(20000,
                                rig.outputs.snapshot.axes[NEURO_AXIS_INSERTION].setpoint_ticks);
    expect_goal(NEURO_AXIS_INSERTION, 20000);
    (void)rig_workphase(&rig, WORKPHASE_STOP);
    expect_no_goal(NEURO_AXIS_INSERTION);
}

/* As it comes, from whom it says. */
static status_t send_as(uint32_t source, uint32_t kind, uint32_t argument)
{
    rig.commands[0] = commands_of_number((command_kind_t)(kind % COMMAND_KIND_COUNT), argument);
    rig.commands[0].source = source;
    rig.commands[0].peer = RIG_PAGE;
    rig.commands[0].kind = kind;
    rig.command_count = 1U;
    rig_cycle(&rig);
    return (status_t)rig.outputs.answers[0].status;
}

void test_SWR_CMD_005_a_source_sends_what_is_its_own_and_nothing_else(void)
{
    static const bool is_igtl[COMMAND_KIND_COUNT] = {
        [COMMAND_PROPOSE_REGISTRATION] = true,
        [COMMAND_PROPOSE_ENTRY] = true,
        [COMMAND_PROPOSE_TARGET] = true,
        [COMMAND_NEEDLE] = true,
    };
    static const bool is_http[COMMAND_KIND_COUNT] = {
        [COMMAND_TAKE] = true,         [COMMAND_RENEW] = true,
        [COMMAND_REQUEST] = true,      [COMMAND_HOME_AXIS] = true,
        [COMMAND_CLEAR_AXIS] = true,   [COMMAND_CONFIRM_AXIS] = true,
        [COMMAND_SET_HOME] = true,     [COMMAND_RESTORE] = true,
        [COMMAND_NOTE] = true,         [COMMAND_ENABLE_AXIS] = true,
        [COMMAND_DISABLE_AXIS] = true, [COMMAND_ACCEPT_NO_BLACK_BOX] = true,
    };
    for (uint32_t kind = (uint32_t)COMMAND_REGISTRATION; kind < COMMAND_KIND_COUNT; kind++) {
        start_manual();
        TEST_ASSERT_EQUAL(is_http[kind],
                          send_as(COMMAND_SOURCE_IGTL, kind, 0U) == STATUS_NOT_ALLOWED);
        start_manual();
        TEST_ASSERT_EQUAL(is_igtl[kind],
                          send_as(COMMAND_SOURCE_HTTP, kind, 0U) == STATUS_NOT_ALLOWED);
    }
    for (uint32_t phase = (uint32_t)WORKPHASE_START_UP; phase < WORKPHASE_COUNT; phase++) {
        const uint32_t kind = (uint32_t)COMMAND_WORKPHASE;
        start_manual();
        TEST_ASSERT_NOT_EQUAL(STATUS_NOT_ALLOWED, send_as(COMMAND_SOURCE_HTTP, kind, phase));
        start_manual();
        TEST_ASSERT_NOT_EQUAL(STATUS_NOT_ALLOWED, send_as(COMMAND_SOURCE_IGTL, kind, phase));
    }
}

void test_SWR_CMD_005_who_is_no_source_sends_nothing(void)
{
    start_manual();
    for (uint32_t kind = 0U; kind <= COMMAND_KIND_COUNT; kind++) {
        TEST_ASSERT_EQUAL(STATUS_NOT_ALLOWED,
                          send_as(COMMAND_SOURCE_COUNT, kind, (uint32_t)WORKPHASE_STOP));
    }
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_MANUAL, rig.outputs.snapshot.workphase);
}

void test_SWR_CMD_005_what_nobody_knows_is_refused_as_unknown(void)
{
    start_manual();
    TEST_ASSERT_EQUAL(STATUS_UNKNOWN_COMMAND, send_as(COMMAND_SOURCE_HTTP, 0U, 0U));
    TEST_ASSERT_EQUAL(STATUS_UNKNOWN_COMMAND, send_as(COMMAND_SOURCE_HTTP, COMMAND_KIND_COUNT, 0U));
    TEST_ASSERT_EQUAL(STATUS_UNKNOWN_COMMAND,
                      send_as(COMMAND_SOURCE_HTTP, (uint32_t)COMMAND_WORKPHASE, 0U));
    TEST_ASSERT_EQUAL(STATUS_UNKNOWN_COMMAND,
                      send_as(COMMAND_SOURCE_HTTP, (uint32_t)COMMAND_WORKPHASE, WORKPHASE_COUNT));
}

/* A command of a connection, which takes authority with it. */
static uint32_t by_network(command_kind_t kind, uint32_t argument, int32_t value)
{
    command_t command = commands_of_number(kind, argument);
    command.source = (uint32_t)COMMAND_SOURCE_IGTL;
    command.peer = RIG_CONNECTION;
    if (kind == COMMAND_JOG) {
        command.as.jog.to_ticks = value;
    } else if (kind == COMMAND_JOG_BY) {
        command.as.jog_by.by_ticks = value;
    } else {
        TEST_ASSERT_EQUAL_INT32(0, value);
    }
    return rig_command(&rig, command).status;
}

void test_SWR_FLOW_006_a_jog_by_openigtlink_is_one_as_of_the_console(void)
{
    rig_start_homed(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_AUTHORITY, by_network(COMMAND_JOG, NEURO_AXIS_YAW, -200));
    rig_leave(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_WRONG_WORKPHASE, by_network(COMMAND_JOG, NEURO_AXIS_YAW, -200));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, by_network(COMMAND_WORKPHASE, WORKPHASE_MANUAL, 0));
    TEST_ASSERT_EQUAL_UINT32(STATUS_AXIS_LIMIT, by_network(COMMAND_JOG, NEURO_AXIS_YAW, 4000));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, by_network(COMMAND_JOG, NEURO_AXIS_YAW, -200));
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 5000U).kind);
    rig_release(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, by_network(COMMAND_JOG_BY, NEURO_AXIS_YAW, -50));
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 5000U).kind);
    TEST_ASSERT_INT32_WITHIN(2, -250, rig_position(&rig, NEURO_AXIS_YAW));
}
