/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: positions that an operator has saved may be put in place of what is known, all
 * of them or none, only while nothing may move; they are unverified, and nothing but the button at
 * the box makes more of them.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "controller/controller.h"
#include "replay/verify/replay.h"
#include "robot/robot_neuro.h"

#include <string.h>

#define ALL 0x7FU /* The axes of the NeuroRobot. */
#define BIT(axis) (1U << (axis))

static rig_t rig;
static command_t saved;

void setUp(void)
{
    saved = (command_t){.kind = (uint32_t)COMMAND_RESTORE, .as.positions = {.axes = ALL}};
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const axis_config_t *const config = &robot_neuro.axes[i];
        saved.as.positions.ticks[i] =
            (config->minimum_ticks / 2) + (config->maximum_ticks / 2) - (int32_t)i;
    }
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

/* Until all axes count as at rest. */
static void rest(void)
{
    rig_cycles(&rig, (LIMIT_SPEED_TIMEOUT_US / LIMIT_CYCLE_US) + 10U);
}

static void start(void)
{
    rig_start(&rig);
    rest();
    rig_forget(&rig);
}

static void start_homed(workphase_t workphase)
{
    rig_start_homed(&rig);
    rest();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, workphase).status);
}

static uint32_t restore(void)
{
    return rig_command(&rig, saved).status;
}

static void assert_reference(uint32_t axis, axis_reference_t reference)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(reference, rig.outputs.snapshot.axes[axis].reference,
                                     robot_neuro.axes[axis].name);
}

static void assert_placed(uint32_t axes)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        if ((axes & BIT(i)) != 0U) {
            assert_reference(i, AXIS_REFERENCE_UNVERIFIED);
            TEST_ASSERT_EQUAL_INT32(saved.as.positions.ticks[i], rig_position(&rig, i));
        }
    }
}

/* Refused, and not a bit of what is known has changed. */
static void assert_refused(status_t status)
{
    axis_t before[ROBOT_AXIS_MAX];
    (void)memcpy(before, rig.controller.axes, sizeof before);
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(status, restore());
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        TEST_ASSERT_EQUAL_UINT32(before[i].chart.reference, rig.controller.axes[i].chart.reference);
        TEST_ASSERT_EQUAL_INT32(before[i].sealed.home_correction_ticks,
                                rig.controller.axes[i].sealed.home_correction_ticks);
    }
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_AXIS_PLACED));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_COMMAND_REFUSED));
}

static void press_button(uint32_t cycles)
{
    rig_box(&rig, "button press");
    rig_cycles(&rig, cycles);
}

static void confirm(void)
{
    rest();
    press_button(2U * LIMIT_CONFIRM_HOLD_US / LIMIT_CYCLE_US);
    rig_box(&rig, "button release");
    rig_cycles(&rig, 10U);
}

void test_SWR_STORE_020_fresh_axes_stand_where_they_were_saved_and_are_unverified(void)
{
    start();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, restore());
    assert_placed(ALL);
    TEST_ASSERT_EQUAL_UINT32(robot_neuro.axis_count, rig_count(&rig, EVENT_AXIS_PLACED));
    TEST_ASSERT_EQUAL_UINT32(EVENT_CAUSE_CONSOLE, rig.events[0].cause);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(robot_neuro.axis_count, rig_count(&rig, EVENT_AXIS_UNVERIFIED));
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.is_homed);
    TEST_ASSERT_EQUAL_UINT32(STATUS_CONFIRM_POSITIONS,
                             rig_workphase(&rig, WORKPHASE_START_UP).status);
}

void test_SWR_STORE_020_what_was_homed_is_unverified_as_well_and_the_others_stay(void)
{
    rig_start_targeted(&rig);
    rest();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_target);
    saved.as.positions.axes = BIT(NEURO_AXIS_HEAD) | BIT(NEURO_AXIS_ROTATION);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, restore());
    assert_placed(saved.as.positions.axes);
    assert_reference(NEURO_AXIS_LATERAL, AXIS_REFERENCE_VERIFIED);
    assert_reference(NEURO_AXIS_FEET, AXIS_REFERENCE_TAKEN);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_target);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.is_homed);
}

void test_SWR_STORE_020_lost_axes_are_restored_before_START_UP_and_the_button_confirms_them(void)
{
    start_homed(WORKPHASE_STOP);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        axis_lose_reference(&rig.controller.axes[i]);
    }
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, restore());
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, restore()); /* Unverified ones, too. */
    assert_placed(ALL);
    confirm();
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        TEST_ASSERT_EQUAL_INT32(saved.as.positions.ticks[i], rig_position(&rig, i));
    }
    assert_reference(NEURO_AXIS_FEET, AXIS_REFERENCE_VERIFIED);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
}

/* The switch is not met where the saved position has it: reported as after a restart. */
void test_SWR_STORE_020_a_switch_that_contradicts_a_saved_position_is_reported(void)
{
    start_homed(WORKPHASE_MANUAL);
    saved.as.positions.axes = BIT(NEURO_AXIS_LATERAL);
    saved.as.positions.ticks[NEURO_AXIS_LATERAL] = rig_position(&rig, NEURO_AXIS_LATERAL) - 1000;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, restore());
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_forget(&rig);
    rig_press(&rig);
    (void)rig_finish(&rig, 60000U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_SWITCH_ELSEWHERE));
    assert_reference(NEURO_AXIS_LATERAL, AXIS_REFERENCE_LOST);
}

void test_SWR_STORE_020_who_does_not_command_restores_nothing(void)
{
    start();
    saved.source = (uint32_t)COMMAND_SOURCE_HTTP;
    saved.peer = RIG_PAGE + 1U;
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_AUTHORITY, restore());
    saved.source = (uint32_t)COMMAND_SOURCE_IGTL;
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_ALLOWED, restore());
    assert_reference(NEURO_AXIS_HEAD, AXIS_REFERENCE_FRESH);
}

void test_SWR_STORE_020_an_axis_that_the_robot_does_not_have_is_refused(void)
{
    start();
    saved.as.positions.axes = ALL | BIT(robot_neuro.axis_count);
    assert_refused(STATUS_UNKNOWN_COMMAND);
    saved.as.positions.axes = 0U;
    assert_refused(STATUS_UNKNOWN_COMMAND);
}

void test_SWR_STORE_021_positions_are_restored_where_nothing_moves_by_itself(void)
{
    static const struct {
        workphase_t workphase;
        status_t status;
    } rows[] = {{WORKPHASE_MANUAL, STATUS_OK},
                {WORKPHASE_STOP, STATUS_OK},
                {WORKPHASE_EMERGENCY, STATUS_OK},
                {WORKPHASE_PLANNING, STATUS_WRONG_WORKPHASE},
                {WORKPHASE_CALIBRATION, STATUS_WRONG_WORKPHASE}};
    for (uint32_t i = 0U; i < (sizeof rows / sizeof rows[0]); i++) {
        start_homed(rows[i].workphase);
        TEST_ASSERT_EQUAL_UINT32(rows[i].status, restore());
    }
    rig_start_homed(&rig); /* In START_UP. */
    assert_refused(STATUS_WRONG_WORKPHASE);
    rig_start_targeted(&rig);
    assert_refused(STATUS_WRONG_WORKPHASE);
}

void test_SWR_STORE_021_an_armed_jog_bars_it(void)
{
    const command_t jog = {.kind = (uint32_t)COMMAND_JOG,
                           .as.jog = {.axis = NEURO_AXIS_LATERAL, .to_ticks = -2000}};
    start_homed(WORKPHASE_MANUAL);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    assert_refused(STATUS_NOT_AT_REST);
}

void test_SWR_STORE_021_an_axis_that_moves_bars_it_whichever_is_named(void)
{
    start();
    rig_box(&rig, "motor insertion runs");
    rig_cycles(&rig, 50U);
    saved.as.positions.axes = BIT(NEURO_AXIS_HEAD);
    assert_refused(STATUS_NOT_AT_REST);
    rig_box(&rig, "motor insertion normal");
    rig_cycles(&rig, 1000U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, restore());
}

/* The scanner makes counters tremble, though nothing moves. */
void test_SWR_STORE_021_an_axis_that_counts_in_a_scan_bars_it(void)
{
    bool is_barred = false;
    start();
    rig_box(&rig, "scanner on");
    for (uint32_t i = 0U; (i < 5000U) && !is_barred; i++) {
        rig_cycles(&rig, 1U);
        is_barred = restore() == (uint32_t)STATUS_NOT_AT_REST;
    }
    TEST_ASSERT_TRUE(is_barred);
    rig_box(&rig, "scanner off");
    rig_cycles(&rig, 1000U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, restore());
}

void test_SWR_STORE_021_a_pressed_pedal_bars_it(void)
{
    start();
    rig_press(&rig);
    assert_refused(STATUS_NOT_AT_REST);
    rig_release(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, restore());
}

void test_SWR_STORE_021_a_silent_card_bars_its_axis_alone(void)
{
    start();
    rig_box(&rig, "card feet silent");
    rig_cycles(&rig, 50U);
    assert_refused(STATUS_HARDWARE_NOT_READY);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_FEET, answer_axis(&rig.outputs.answers[0]));
    saved.as.positions.axes = ALL & ~BIT(NEURO_AXIS_FEET);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, restore());
    assert_placed(saved.as.positions.axes);
}

void test_SWR_STORE_022_a_press_that_began_before_confirms_nothing(void)
{
    start();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, restore());
    rest();
    press_button((LIMIT_CONFIRM_HOLD_US / LIMIT_CYCLE_US) / 2U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, restore());
    rig_cycles(&rig, 2U * LIMIT_CONFIRM_HOLD_US / LIMIT_CYCLE_US);
    assert_placed(ALL);
    rig_box(&rig, "button release");
    rig_cycles(&rig, 10U);
    confirm();
    assert_reference(NEURO_AXIS_HEAD, AXIS_REFERENCE_VERIFIED);
}

void test_SWR_STORE_023_a_position_where_its_axis_cannot_stand_is_refused_with_all_others(void)
{
    start();
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const axis_config_t *const config = &robot_neuro.axes[i];
        const int32_t beyond = config->following_error_ticks + config->home_way_ticks;
        const int32_t good = saved.as.positions.ticks[i];
        saved.as.positions.ticks[i] = config->minimum_ticks - beyond - 1;
        assert_refused(STATUS_OUT_OF_RANGE);
        TEST_ASSERT_EQUAL_UINT32(i, answer_axis(&rig.outputs.answers[0]));
        saved.as.positions.ticks[i] = config->maximum_ticks + beyond + 1;
        assert_refused(STATUS_OUT_OF_RANGE);
        saved.as.positions.ticks[i] = good;
    }
    saved.as.positions.ticks[NEURO_AXIS_YAW] = INT32_MIN;
    assert_refused(STATUS_OUT_OF_RANGE);
    saved.as.positions.ticks[NEURO_AXIS_YAW] = INT32_MAX;
    assert_refused(STATUS_OUT_OF_RANGE);
}

void test_SWR_STORE_023_the_last_places_where_an_axis_can_stand_are_restored(void)
{
    for (uint32_t side = 0U; side < 2U; side++) {
        start();
        for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
            const axis_config_t *const config = &robot_neuro.axes[i];
            const int32_t beyond = config->following_error_ticks + config->home_way_ticks;
            saved.as.positions.ticks[i] =
                (side == 0U) ? (config->minimum_ticks - beyond) : (config->maximum_ticks + beyond);
        }
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, restore());
        assert_placed(ALL);
    }
}

void test_SWR_REPLAY_001_a_restoring_is_replayed(void)
{
    static replay_t replay;
    static cycle_record_t record;
    const cycle_known_t known = {.is_whole = true};

    start();
    replay_init(&replay);
    record.kind = CYCLE_RECORD_CHECKPOINT;
    record.cycle = rig.controller.sealed.cycle;
    (void)memcpy(record.body.checkpoint, &rig.controller, CONTROLLER_CHECKPOINT_BYTES);
    TEST_ASSERT_TRUE(replay_take(&replay, &robot_neuro, &record, &known));
    record.kind = CYCLE_RECORD_CYCLE;
    for (uint32_t i = 0U; i < 20U; i++) {
        record.cycle = rig.controller.sealed.cycle;
        if (i == 10U) {
            TEST_ASSERT_EQUAL_UINT32(STATUS_OK, restore());
        } else {
            rig_cycle(&rig);
        }
        record.body.cycle.inputs = rig.inputs;
        record.body.cycle.outputs = rig.outputs;
        TEST_ASSERT_TRUE(replay_take(&replay, &robot_neuro, &record, &known));
    }
    assert_placed(ALL);
}
