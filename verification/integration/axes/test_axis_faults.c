/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Faults of an axis on the simulated box: effect of its encoder, motor or switch on a motion, how
 * soon it is noticed, and what is known of the axis afterwards.
 * In every test the rig counts cycles that drive without the pedal; there must be none.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "controller/controller.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"
#include "unit/support/scenes.h"

#include <stdio.h>

static rig_t rig;

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

void test_SWR_STALL_001_a_blocked_motor_stalls_and_needs_start_up(void)
{
    rig_start_moving(&rig);
    rig_box(&rig, "motor head stuck");
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_FAULT_PRESENT, rig_finish(&rig, 700U).status);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_FAULT, rig.outputs.snapshot.axes[NEURO_AXIS_HEAD].power);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_TARGET,
                             rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    rig_release(&rig);
    rig_press(&rig);
    rig_cycles(&rig, 300U);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    rig_release(&rig);
    rig_box(&rig, "motor head normal");
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_ENABLED, rig.outputs.snapshot.axes[NEURO_AXIS_HEAD].power);
}

void test_SWR_AXIS_012_after_an_encoder_was_gone_in_a_move_the_axis_homes_anew(void)
{
    double true_ticks[ROBOT_AXIS_MAX];
    rig_start_moving(&rig);
    rig_box(&rig, "encoder head stuck");
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 700U).kind);
    rig_box(&rig, "encoder head normal");
    rig_expect_nothing_known(&rig, NEURO_AXIS_HEAD);
    rig_release(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ACCEPTED, rig_workphase(&rig, WORKPHASE_START_UP).kind);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.answer_count);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 40000U).kind);
    box_true_positions(&rig.box, true_ticks);
    TEST_ASSERT_DOUBLE_WITHIN(2.0, (double)rig_position(&rig, NEURO_AXIS_HEAD),
                              true_ticks[NEURO_AXIS_HEAD]);
}

void test_SWR_AXIS_012_a_stall_loses_reference_and_target(void)
{
    rig_start_moving(&rig);
    rig_box(&rig, "motor head stuck");
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 700U).kind);
    rig_expect_nothing_known(&rig, NEURO_AXIS_HEAD);
}

static void begin_jog(uint32_t axis, int32_t ticks)
{
    const command_t jog = {.kind = COMMAND_JOG, .as.jog = {.axis = axis, .to_ticks = ticks}};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    rig_release(&rig);
    rig_press(&rig);
}

/* Its counts go forth and back: the motor seems to turn, and gets nowhere. */
void test_SWR_AXIS_019_an_axis_that_trembles_in_place_is_reported_once(void)
{
    sim_motor_t *const motor = &rig.box.axes[NEURO_AXIS_INSERTION].motor;
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    begin_jog(NEURO_AXIS_INSERTION, 1000);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 5000U).kind);
    const int32_t place = rig_position(&rig, NEURO_AXIS_INSERTION);
    begin_jog(NEURO_AXIS_INSERTION, place + 12);
    for (uint32_t i = 0U; i < 2000U; i++) {
        motor->asymmetry = (rig_position(&rig, NEURO_AXIS_INSERTION) > place) ? -1.2 : -0.5;
        rig_cycle(&rig);
    }
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_STALLED) +
                                     rig_count(&rig, EVENT_AXIS_WRONG_SPEED));
    rig_expect_nothing_known(&rig, NEURO_AXIS_INSERTION);
}

/* A finding of its watchdog is reported, even if no other check finds it. */
void test_SWR_STALL_003_a_stall_is_reported_with_its_place(void)
{
    stall_watchdog_chart_t *const stall = &rig.controller.axes[NEURO_AXIS_HEAD].supervision.stall;
    rig_start_moving(&rig);
    while (stall->state != (uint32_t)STALL_WATCHDOG_STATE_WATCHING) {
        rig_cycle(&rig);
    }
    stall->no_progress_us = LIMIT_STALL_TIME_US - 1U;
    controller_seal(&rig.controller);
    rig_forget(&rig);
    rig_cycles(&rig, 5U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_STALLED));
    TEST_ASSERT_INT32_WITHIN(5, rig_position(&rig, NEURO_AXIS_HEAD), rig.events[0].value);
    rig_expect_nothing_known(&rig, NEURO_AXIS_HEAD);
}

void test_SWR_AXIS_018_a_cut_encoder_is_reported_exactly_once(void)
{
    rig_start_moving(&rig);
    rig_box(&rig, "encoder head stuck");
    rig_forget(&rig);
    rig_cycles(&rig, 2000U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_NO_COUNTS));
}

void test_SWR_AXIS_009_an_axis_that_runs_the_wrong_way_is_stopped(void)
{
    rig_start_moving(&rig);
    rig_box(&rig, "encoder head reversed");
    rig_forget(&rig);
    rig_cycles(&rig, 600U);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_FAULT, rig.outputs.snapshot.axes[NEURO_AXIS_HEAD].power);
}

/* Way of `axis` in 0.1 mm or 0.5 degrees. */
static double rest_ways(uint32_t axis, double ticks)
{
    const axis_config_t *const config = &robot_neuro.axes[axis];
    const bool is_mm = config->unit == (uint8_t)AXIS_UNIT_MM;
    const double way = ticks * (double)config->unit_per_tick_q16 / 65536.0;
    return way / (is_mm ? (double)LIMIT_REST_WAY_NM : (double)LIMIT_REST_WAY_BAM);
}

/* The motor of `axis` runs by itself. @return cycles from when it had moved too far to the fault */
static uint32_t cycles_to_notice(uint32_t axis)
{
    const double *const at = &rig.box.axes[axis].motor.position_ticks;
    const double start = *at;
    uint32_t late = 0U;
    rig.box.axes[axis].motor.fault = SIM_MOTOR_RUNS;
    while (rig_count(&rig, EVENT_AXIS_MOVED_OFF) == 0U) {
        rig_cycle(&rig);
        late += (rest_ways(axis, *at - start) >= 1.0) ? 1U : 0U;
        TEST_ASSERT_LESS_THAN_UINT32(200000U, rig.controller.sealed.cycle);
    }
    return late;
}

void test_SWR_AXIS_016_a_motor_that_runs_while_off_is_noticed_on_every_axis(void)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        rig_start_targeted(&rig);
        TEST_ASSERT_LESS_OR_EQUAL_UINT32(LIMIT_REST_NOTICE_US / LIMIT_CYCLE_US,
                                         cycles_to_notice(i));
        rig_expect_nothing_known(&rig, i);
        TEST_ASSERT_EQUAL_HEX32(0U, rig_sent(&rig, i).control);
    }
}

void test_SWR_AXIS_016_a_motor_that_runs_on_after_the_release_is_noticed(void)
{
    rig_start_moving(&rig);
    rig_release(&rig);
    TEST_ASSERT_LESS_OR_EQUAL_UINT32(20U, cycles_to_notice(NEURO_AXIS_FEET));
    rig_expect_nothing_known(&rig, NEURO_AXIS_FEET);
}

void test_SWR_AXIS_017_a_card_that_receives_nothing_more_switches_off_where_it_may_not_be(void)
{
    rig_start_moving(&rig);
    const card_command_t sent = rig_sent(&rig, NEURO_AXIS_HEAD);
    const uint32_t width = (uint32_t)sent.guard_maximum_ticks - (uint32_t)sent.guard_minimum_ticks;
    const uint32_t most = 2U * (uint32_t)robot_neuro.axes[NEURO_AXIS_HEAD].following_error_ticks;
    TEST_ASSERT_LESS_THAN_UINT32(most + most, width);
    rig_cycles(&rig, 5U);
    rig.box.axes[NEURO_AXIS_HEAD].encoder.count += most;
    box_advance(&rig.box, 200U);
    TEST_ASSERT_BITS_HIGH(CARD_STATUS_GUARD, rig.box.axes[NEURO_AXIS_HEAD].card.faults);
}

void test_SWR_AXIS_017_a_lost_card_gets_no_guard(void)
{
    rig_start(&rig);
    rig_box(&rig, "card head silent");
    rig_cycles(&rig, 20U);
    TEST_ASSERT_EQUAL_INT32(rig_sent(&rig, NEURO_AXIS_HEAD).guard_minimum_ticks,
                            rig_sent(&rig, NEURO_AXIS_HEAD).guard_maximum_ticks);
}

/* `axis` is jogged and has run at its speed for a while. */
static void cruise(uint32_t axis)
{
    static const int32_t ends[ROBOT_AXIS_MAX] = {-5000, 4000, -2000, 60000, 5000, -300, -1100};
    const command_t jog = {.kind = COMMAND_JOG, .as.jog = {.axis = axis, .to_ticks = ends[axis]}};
    const int32_t almost_percent = (int32_t)LIMIT_PROFILE_SPEED_PERCENT - 1;
    const int32_t speed_q8 = robot_neuro.axes[axis].speed_ticks_per_s * 256 / 100 * almost_percent;
    rig_start_homed(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    rig_press(&rig);
    const snapshot_axis_t *const shown = &rig.outputs.snapshot.axes[axis];
    while ((shown->setpoint_speed_ticks_per_s_q8 < speed_q8) &&
           (shown->setpoint_speed_ticks_per_s_q8 > -speed_q8)) {
        rig_cycle(&rig);
        TEST_ASSERT_LESS_THAN_UINT32(200000U, rig.controller.sealed.cycle);
    }
    rig_cycles(&rig, 100U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
    rig_forget(&rig);
}

/* A fault, its event, and the figures within which it must come. */
typedef struct {
    const char *part;
    const char *fault;
    event_id_t event;
    uint32_t most_ms;
    double most_ways[2]; /* For lines, 0.1 mm; for turns, 0.5 degrees. */
} blindness_t;

/* The fault's event, or the lag that it makes. */
static bool is_noticed(event_id_t event)
{
    return (rig_count(&rig, event) + rig_count(&rig, EVENT_AXIS_FOLLOWING_ERROR)) != 0U;
}

/* Time to the event, and how far true and believed position have gone apart. */
static void expect_notice(uint32_t axis, const blindness_t *fault)
{
    char order[48];
    const double *const at = &rig.box.axes[axis].motor.position_ticks;
    cruise(axis);
    const double start = *at - (double)rig_position(&rig, axis);
    (void)snprintf(order, sizeof order, "%s %s %s", fault->part, robot_neuro.axes[axis].name,
                   fault->fault);
    rig_box(&rig, order);
    uint32_t cycles = 0U;
    while (!is_noticed(fault->event)) {
        rig_cycle(&rig);
        cycles++;
        TEST_ASSERT_LESS_OR_EQUAL_UINT32_MESSAGE(fault->most_ms, cycles, order);
    }
    rig_cycles(&rig, 200U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_WRONG_WAY) +
                                     rig_count(&rig, EVENT_AXIS_NO_COUNTS) +
                                     rig_count(&rig, EVENT_AXIS_FOLLOWING_ERROR) +
                                     rig_count(&rig, EVENT_AXIS_WRONG_SPEED));
    const double apart = rest_ways(axis, *at - (double)rig_position(&rig, axis) - start);
    const double most = fault->most_ways[robot_neuro.axes[axis].unit];
    TEST_ASSERT_TRUE_MESSAGE((apart <= most) && (apart >= -most), order);
    rig_expect_nothing_known(&rig, axis);
}

static void expect_notice_on_every_axis(blindness_t fault)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        expect_notice(i, &fault);
    }
}

void test_SWR_AXIS_018_a_cut_encoder_is_noticed_on_every_axis(void)
{
    expect_notice_on_every_axis(
        (blindness_t){"encoder", "stuck", EVENT_AXIS_NO_COUNTS, 40U, {3.0, 5.0}});
}

void test_SWR_AXIS_018_a_blocked_shaft_is_noticed_on_every_axis(void)
{
    expect_notice_on_every_axis(
        (blindness_t){"motor", "stuck", EVENT_AXIS_NO_COUNTS, 40U, {0.4, 0.4}});
}

void test_SWR_AXIS_015_swapped_lines_are_noticed_on_every_axis(void)
{
    expect_notice_on_every_axis(
        (blindness_t){"encoder", "reversed", EVENT_AXIS_WRONG_WAY, 30U, {3.0, 5.0}});
}

void test_SWR_AXIS_019_half_the_counts_are_noticed_on_every_axis(void)
{
    expect_notice_on_every_axis(
        (blindness_t){"encoder", "half", EVENT_AXIS_WRONG_SPEED, 150U, {8.0, 18.0}});
}

void test_SWR_AXIS_019_a_motor_half_as_fast_is_noticed_on_every_axis(void)
{
    expect_notice_on_every_axis(
        (blindness_t){"motor", "half", EVENT_AXIS_WRONG_SPEED, 150U, {0.4, 0.4}});
}

void test_SWR_AXIS_019_a_motor_twice_as_fast_is_noticed_on_every_axis(void)
{
    expect_notice_on_every_axis(
        (blindness_t){"motor", "twice", EVENT_AXIS_WRONG_SPEED, 150U, {0.4, 0.4}});
}

/* Homing and a move to a target with motors that are `gain` times as fast as the table says. */
static void move_with_gain(double gain)
{
    rigid_t identity;
    const rigid_t pose = rig_pose(5000000, 190000000, 60000000);
    rigid_set_identity(&identity);
    rig_start(&rig);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        rig.box.axes[i].motor.full_speed_ticks_per_s *= gain;
    }
    rig_home(&rig);
    rig_register(&rig, &identity);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &pose).status);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 40000U).kind);
}

void test_SWR_AXIS_019_motors_a_fifth_slower_or_faster_raise_no_alarm(void)
{
    static const double gains[] = {0.8, 1.2};
    for (uint32_t i = 0U; i < SCENES(sizeof gains / sizeof gains[0]); i++) {
        move_with_gain(gains[i]);
    }
}
