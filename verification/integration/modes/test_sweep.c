/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a sweep of the ProstateRobot's rotation measures the published curve that its
 * simulated motor has, under the pedal and in MANUAL alone, and is aborted by name.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "base/seal.h"
#include "controller/controller.h"
#include "http/view/mode_availability.h"
#include "robot/robot_neuro.h"
#include "robot/robot_prostate.h"
#include "unit/support/scenes.h"

#include <stddef.h>
#include <string.h>

#define LONG_CYCLES 600000U
#define FINE_HZ 184.62
/* The published table, scaled to the axis' full speed at 50.862 kHz: ticks in a run of 5 s. */
#define TICKS_PER_TURN_A_MINUTE (1928.0 / 139.8 * 5.0)

static rig_t rig;

void setUp(void)
{
    rig_start_robot_homed(&rig, rig_short_prostate());
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static answer_t sweep(uint32_t axis, int32_t is_free)
{
    const command_t command = {.kind = (uint32_t)COMMAND_SWEEP,
                               .as.sweep = {.axis = axis, .is_free = is_free}};
    return rig_command(&rig, command);
}

static void arm(void)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, sweep(PROSTATE_AXIS_ROTATION, 1).status);
}

/* Into a run of the search, in which the motor is driven. */
static void begin(void)
{
    arm();
    rig_press(&rig);
    rig_cycles(&rig, 1500U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
}

static uint32_t rig_nth(event_id_t id, uint32_t index, int32_t *value)
{
    uint32_t count = 0U;
    for (uint32_t i = 0U; i < rig.event_count; i++) {
        if (rig.events[i].id == (uint32_t)id) {
            *value = (count == index) ? rig.events[i].value : *value;
            count++;
        }
    }
    return count;
}

static int32_t nth(event_id_t id, uint32_t index)
{
    int32_t value = INT32_MIN;
    TEST_ASSERT_GREATER_THAN_UINT32(index, rig_nth(id, index, &value));
    return value;
}

static void expect_aborted(status_t status)
{
    const answer_t answer = rig_finish(&rig, LONG_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, answer.kind);
    TEST_ASSERT_EQUAL_UINT32(status, answer.status);
    TEST_ASSERT_EQUAL_UINT32(PROSTATE_AXIS_ROTATION, answer_axis(&answer));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_SWEEP_ENDED));
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
}

void test_SWR_SWEEP_001_it_is_armed_in_manual_alone_with_every_axis_homed(void)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_WRONG_WORKPHASE, sweep(PROSTATE_AXIS_ROTATION, 1).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_FREE, sweep(PROSTATE_AXIS_ROTATION, 0).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_FREE, sweep(PROSTATE_AXIS_ROTATION, 2).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_SWEEP, sweep(PROSTATE_AXIS_FRONT_LEFT, 1).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_UNKNOWN_COMMAND, sweep(UINT32_MAX, 1).status);
    const command_t clear = {.kind = (uint32_t)COMMAND_CLEAR_AXIS,
                             .as.axis = {.axis = PROSTATE_AXIS_REAR_LEFT}};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, clear).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_HOMED, sweep(PROSTATE_AXIS_ROTATION, 1).status);
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
}

void test_SWR_SWEEP_001_the_published_curve_is_measured_up_to_the_speed_of_the_axis(void)
{
    static const double published[][2] = {
        {20.96, 20.23}, {27.36, 27.24}, {36.04, 35.24}, {45.55, 45.33}, {59.00, 58.50}};
    const double first_hz = 52154.0;
    uint32_t compared = 0U;
    arm();
    rig_press(&rig);
    if (!ARE_SCENES_WHOLE) {
        rig_cycles(&rig, SCENES(60000U)); /* A beginning. */
        return;
    }
    const answer_t answer = rig_finish(&rig, LONG_CYCLES);
    rig_release(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, answer.kind);
    TEST_ASSERT_EQUAL_INT32(SWEEP_END_SPEED, nth(EVENT_SWEEP_ENDED, 0U));
    const uint32_t points = rig_count(&rig, EVENT_SWEEP_DOWNWARDS);
    const uint32_t searched = rig_count(&rig, EVENT_SWEEP_WORD) - (2U * points);
    TEST_ASSERT_EQUAL_UINT32(points, rig_count(&rig, EVENT_SWEEP_UPWARDS));
    for (uint32_t i = 0U; i < points; i++) {
        const double at = (first_hz - (double)nth(EVENT_SWEEP_WORD, searched + (2U * i))) / FINE_HZ;
        if ((at < 0.0) || (at >= 4.0)) {
            continue;
        }
        for (uint32_t way = 0U; way < 2U; way++) {
            const double low = published[(uint32_t)at][way];
            const double high = published[(uint32_t)at + 1U][way];
            const double due = low + ((high - low) * (at - (double)(uint32_t)at));
            const int32_t reported =
                nth((way == 0U) ? EVENT_SWEEP_UPWARDS : EVENT_SWEEP_DOWNWARDS, i);
            /* Its directions differ by 3 %, and warm it is slower. */
            TEST_ASSERT_DOUBLE_WITHIN(0.1, 0.94,
                                      (double)reported / (due * TICKS_PER_TURN_A_MINUTE));
            compared++;
        }
    }
    TEST_ASSERT_EQUAL_UINT32(8U, compared);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_UNVERIFIED,
                             rig.outputs.snapshot.axes[PROSTATE_AXIS_ROTATION].reference);
    TEST_ASSERT_TRUE(axis_is_enabled(&rig.controller.axes[PROSTATE_AXIS_ROTATION]));
}

/* As robot.yml would have its row, with the words of the other robot's card. */
static const robot_t *neuro_with_waves(void)
{
    static robot_t robot;
    const axis_config_t *waves = &robot_prostate.axes[PROSTATE_AXIS_ROTATION];
    robot = robot_neuro;
    rig_put_near_switches(&robot);
    axis_config_t *rotation = &robot.axes[NEURO_AXIS_ROTATION];
    rotation->card_type = waves->card_type;
    rotation->amplitude = waves->amplitude;
    rotation->resonance_hz_per_k = waves->resonance_hz_per_k;
    (void)memcpy(rotation->speed_curve, waves->speed_curve, sizeof rotation->speed_curve);
    rotation->minimum_duty = waves->minimum_duty;
    rotation->maximum_duty = waves->maximum_duty;
    rotation->seal = seal_of(SEAL_START, (const uint8_t *)rotation, offsetof(axis_config_t, seal));
    return &robot;
}

void test_SWR_SWEEP_001_the_neuro_robot_sweeps_its_rotation_on_a_card_that_makes_waves(void)
{
    rig_start_homed(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_SWEEP, sweep(NEURO_AXIS_ROTATION, 1).status);
    rig_start_robot_homed(&rig, neuro_with_waves());
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, sweep(NEURO_AXIS_ROTATION, 1).status);
    rig_press(&rig);
    rig_cycles(&rig, 60000U); /* The search, and the first point. */
    TEST_ASSERT_GREATER_THAN_UINT32(2U, rig_count(&rig, EVENT_SWEEP_WORD));
    TEST_ASSERT_GREATER_THAN_UINT32(0U, rig_count(&rig, EVENT_SWEEP_UPWARDS));
    TEST_ASSERT_TRUE(axis_is_enabled(&rig.controller.axes[NEURO_AXIS_ROTATION]));
    rig_release(&rig);
}

void test_SWR_SWEEP_007_heat_aborts_it(void)
{
    begin();
    rig_box(&rig, "motor rotation hot");
    expect_aborted(STATUS_FAULT_PRESENT);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_HOT));
    rig_release(&rig);
}

void test_SWR_SWEEP_007_a_motor_that_is_stuck_has_no_beginning(void)
{
    rig_box(&rig, "motor rotation stuck");
    begin();
    const answer_t answer = rig_finish(&rig, LONG_CYCLES);
    rig_release(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, answer.kind);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_SWEEP_UPWARDS));
}

static uint32_t grade(void)
{
    return rig.outputs.snapshot.axes[PROSTATE_AXIS_ROTATION].reference;
}

static void confirm(void)
{
    rig_box(&rig, "button press");
    rig_cycles(&rig, (LIMIT_CONFIRM_HOLD_US / LIMIT_CYCLE_US) + 2U);
    rig_box(&rig, "button release");
    rig_cycles(&rig, 2U);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_VERIFIED, grade());
}

/* A run is its own measure: what the motor should make of the frequency is what the sweep is for.
 * The next drive has a speed to compare with. */
void test_SWR_SWEEP_001_half_counts_are_not_noticed_in_a_sweep(void)
{
    begin();
    rig_box(&rig, "encoder rotation half");
    rig_cycles(&rig, 20000U);
    rig_release(&rig);
    rig_cycles(&rig, 500U);
    TEST_ASSERT_TRUE(axis_is_homed(&rig.controller.axes[PROSTATE_AXIS_ROTATION]));
    TEST_ASSERT_FALSE(axis_is_faulty(&rig.controller.axes[PROSTATE_AXIS_ROTATION]));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_STOP).status);
    rig_cycle(&rig);
    confirm();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    const command_t jog = {.kind = (uint32_t)COMMAND_JOG_BY,
                           .as.jog_by = {.axis = PROSTATE_AXIS_ROTATION, .by_ticks = 2000}};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    rig_press(&rig);
    expect_aborted(STATUS_FAULT_PRESENT);
    rig_release(&rig);
}

static void expect_doubt(void)
{
    rig_cycles(&rig, 2U);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_UNVERIFIED, grade());
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_UNVERIFIED));
}

static uint32_t homed_grade(void)
{
    rig_start_robot_homed(&rig, rig_short_prostate());
    return grade();
}

/* Lost counts stay lost: the operator compares, and the step says so. */
void test_SWR_SWEEP_025_counts_lost_in_a_sweep_leave_a_doubt_that_the_operator_ends(void)
{
    begin();
    rig_box(&rig, "encoder rotation stuck");
    rig_cycles(&rig, 2000U);
    rig_box(&rig, "encoder rotation normal");
    rig_cycles(&rig, 20000U);
    rig_release(&rig);
    rig_cycles(&rig, 500U);
    TEST_ASSERT_TRUE(axis_is_homed(&rig.controller.axes[PROSTATE_AXIS_ROTATION]));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_STOP).status);
    expect_doubt();
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_CONFIRM, rig.outputs.snapshot.next_step);
    confirm();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
}

void test_SWR_SWEEP_025_whatever_ends_it_leaves_the_doubt(void)
{
    begin();
    rig_box(&rig, "estop pull");
    expect_doubt();
    rig_release(&rig);
    (void)homed_grade();
    begin();
    rig_box(&rig, "motor rotation hot");
    expect_aborted(STATUS_FAULT_PRESENT);
    expect_doubt();
    rig_release(&rig);
    (void)homed_grade();
    begin();
    rig_release(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, LONG_CYCLES).kind);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ORDER_EXPIRED));
    expect_doubt();
}

void test_SWR_SWEEP_025_one_that_has_not_begun_leaves_none(void)
{
    const uint32_t before = grade();
    arm();
    rig_cycles(&rig, 10U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_STOP).status);
    rig_cycles(&rig, 2U);
    TEST_ASSERT_EQUAL_UINT32(before, grade());
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_AXIS_UNVERIFIED));
}

void test_SWR_SWEEP_007_a_motor_that_runs_by_itself_aborts_it(void)
{
    begin();
    rig_box(&rig, "motor rotation runs");
    const answer_t answer = rig_finish(&rig, LONG_CYCLES);
    rig_release(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, answer.kind);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_SWEEP_ENDED));
}

void test_SWR_SWEEP_008_a_released_pedal_drives_nothing_and_the_step_begins_anew(void)
{
    begin();
    rig_release(&rig);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    rig_cycles(&rig, 2000U);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_SWEEP_AGAIN));
    rig_press(&rig);
    rig_cycles(&rig, 100U);
    TEST_ASSERT_EQUAL_INT32(55000, nth(EVENT_SWEEP_AGAIN, 0U));
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    rig_cycles(&rig, 1000U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
    rig_release(&rig);
}

/* The outlook beforehand. */
static void expect_outlook(mode_kind_t kind, status_t status)
{
    TEST_ASSERT_EQUAL_UINT32(status,
                             mode_availability(&robot_prostate, &rig.outputs.snapshot, NULL, kind));
}

void test_SWR_MODE_004_a_needle_that_is_in_is_named_beforehand(void)
{
    const command_t in = {.kind = (uint32_t)COMMAND_JOG,
                          .as.jog = {.axis = PROSTATE_AXIS_INSERTION, .to_ticks = 20000}};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    expect_outlook(MODE_SWEEP, STATUS_OK);
    expect_outlook(MODE_POSE, STATUS_OK);
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, in).status);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, LONG_CYCLES).kind);
    expect_outlook(MODE_SWEEP, STATUS_NEEDLE_IN);
    expect_outlook(MODE_POSE, STATUS_NEEDLE_IN);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NEEDLE_IN, sweep(PROSTATE_AXIS_ROTATION, 1).status);
}
