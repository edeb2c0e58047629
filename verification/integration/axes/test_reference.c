/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * How far the controller trusts the position of an axis, and what makes it trusted again, on the
 * simulated box.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "controller/controller.h"
#include "robot/robot_neuro.h"

#define HOLD_CYCLES (LIMIT_CONFIRM_HOLD_US / LIMIT_CYCLE_US)
#define SILENT_CYCLES (LIMIT_SILENT_KEPT_CYCLES + 20U)

static rig_t rig;

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static uint32_t grade(uint32_t axis)
{
    return rig.outputs.snapshot.axes[axis].reference;
}

/* The button is held for so long, and released. @return the axes that were confirmed by it */
static uint32_t hold_button(uint32_t cycles)
{
    const uint32_t before = rig_count(&rig, EVENT_AXIS_CONFIRMED);
    rig_box(&rig, "button press");
    rig_cycles(&rig, cycles);
    rig_box(&rig, "button release");
    rig_cycles(&rig, 2U);
    return rig_count(&rig, EVENT_AXIS_CONFIRMED) - before;
}

static void start_with_doubt(uint32_t axis)
{
    rig_start_homed(&rig);
    axis_doubt(&rig.controller.axes[axis]);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_UNVERIFIED, grade(axis));
}

void test_SWR_REF_006_the_operator_holds_the_button_and_the_axis_is_verified(void)
{
    start_with_doubt(NEURO_AXIS_ROTATION);
    const int32_t position = rig.outputs.snapshot.axes[NEURO_AXIS_ROTATION].position_ticks;
    TEST_ASSERT_EQUAL_UINT32(1U, hold_button(HOLD_CYCLES + 1U));
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_VERIFIED, grade(NEURO_AXIS_ROTATION));
    TEST_ASSERT_EQUAL_INT32(position,
                            rig.outputs.snapshot.axes[NEURO_AXIS_ROTATION].position_ticks);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_TAKEN, grade(NEURO_AXIS_FEET));
}

void test_SWR_REF_006_a_short_press_confirms_nothing(void)
{
    start_with_doubt(NEURO_AXIS_ROTATION);
    TEST_ASSERT_EQUAL_UINT32(0U, hold_button(HOLD_CYCLES - 2U));
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_UNVERIFIED, grade(NEURO_AXIS_ROTATION));
}

void test_SWR_REF_006_a_button_that_is_held_from_the_start_confirms_nothing(void)
{
    start_with_doubt(NEURO_AXIS_ROTATION);
    rig_box(&rig, "button press");
    rig_cycle(&rig);
    rig.controller.confirm = (confirm_button_t){.sealed = {0U, 0U}};
    controller_seal(&rig.controller);
    TEST_ASSERT_EQUAL_UINT32(0U, hold_button(3U * HOLD_CYCLES));
    TEST_ASSERT_EQUAL_UINT32(1U, hold_button(HOLD_CYCLES + 1U));
}

void test_SWR_REF_006_nothing_is_confirmed_while_an_order_is_armed(void)
{
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    const command_t jog = {.kind = (uint32_t)COMMAND_JOG,
                           .as.jog = {.axis = NEURO_AXIS_FEET, .to_ticks = 10}};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    axis_lose_reference(&rig.controller.axes[NEURO_AXIS_ROTATION]);
    TEST_ASSERT_EQUAL_UINT32(0U, hold_button(3U * HOLD_CYCLES));
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_LOST, grade(NEURO_AXIS_ROTATION));
    (void)rig_workphase(&rig, WORKPHASE_STOP);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, hold_button(HOLD_CYCLES + 1U));
}

void test_SWR_REF_006_nothing_is_confirmed_while_the_emergency_stop_is_open(void)
{
    start_with_doubt(NEURO_AXIS_FEET);
    rig_box(&rig, "estop pull");
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(0U, hold_button(3U * HOLD_CYCLES));
    rig_box(&rig, "estop reset");
    rig_cycles(&rig, 2U);
    TEST_ASSERT_EQUAL_UINT32(1U, hold_button(HOLD_CYCLES + 1U));
}

void test_SWR_REF_007_an_axis_whose_card_is_silent_is_not_confirmed(void)
{
    start_with_doubt(NEURO_AXIS_FEET);
    axis_doubt(&rig.controller.axes[NEURO_AXIS_ROTATION]);
    rig_box(&rig, "card rotation silent");
    rig_cycles(&rig, SILENT_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(1U, hold_button(HOLD_CYCLES + 1U));
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_VERIFIED, grade(NEURO_AXIS_FEET));
    TEST_ASSERT_NOT_EQUAL_UINT32(AXIS_REFERENCE_VERIFIED, grade(NEURO_AXIS_ROTATION));
    rig_box(&rig, "card rotation normal");
    rig_cycles(&rig, 20U);
    TEST_ASSERT_EQUAL_UINT32(1U, hold_button(HOLD_CYCLES + 1U));
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_VERIFIED, grade(NEURO_AXIS_ROTATION));
}

static void expect_start_up(status_t expected)
{
    const uint32_t before = rig.outputs.snapshot.workphase;
    TEST_ASSERT_EQUAL_UINT32(expected, rig_workphase(&rig, WORKPHASE_START_UP).status);
    TEST_ASSERT_EQUAL_UINT32((expected == STATUS_OK) ? (uint32_t)WORKPHASE_START_UP : before,
                             rig.outputs.snapshot.workphase);
}

static void expect_step(next_step_t expected)
{
    TEST_ASSERT_EQUAL_UINT32(expected, rig.outputs.snapshot.next_step);
}

void test_SWR_REF_008_start_up_waits_for_the_operator_when_an_axis_without_switch_is_in_doubt(void)
{
    start_with_doubt(NEURO_AXIS_FEET);
    expect_start_up(STATUS_CONFIRM_POSITIONS);
    expect_step(NEXT_STEP_CONFIRM);
    (void)hold_button(HOLD_CYCLES + 1U);
    expect_step(NEXT_STEP_PLANNING);
    expect_start_up(STATUS_OK);
}

void test_SWR_REF_008_start_up_waits_for_the_operator_when_an_axis_without_switch_is_lost(void)
{
    rig_start_homed(&rig);
    axis_lose_reference(&rig.controller.axes[NEURO_AXIS_ROTATION]);
    rig_cycle(&rig);
    expect_start_up(STATUS_CONFIRM_POSITIONS);
    (void)hold_button(HOLD_CYCLES + 1U);
    expect_start_up(STATUS_OK);
}

void test_SWR_REF_008_a_refused_start_up_clears_nothing(void)
{
    rig_start_homed(&rig);
    rig_box(&rig, "estop pull");
    rig_cycles(&rig, 2U);
    rig_box(&rig, "estop reset");
    rig_cycles(&rig, 2U);
    axis_doubt(&rig.controller.axes[NEURO_AXIS_FEET]);
    expect_start_up(STATUS_CONFIRM_POSITIONS);
    TEST_ASSERT_EQUAL_UINT32(ESTOP_LATCH_STATE_LATCHED, rig.outputs.snapshot.estop);
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_DISABLED, rig.outputs.snapshot.axes[NEURO_AXIS_HEAD].power);
}

void test_SWR_REF_008_what_a_switch_finds_needs_no_operator(void)
{
    start_with_doubt(NEURO_AXIS_YAW);
    expect_step(NEXT_STEP_START_UP);
    rig_home(&rig);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_VERIFIED, grade(NEURO_AXIS_YAW));
}

void test_SWR_REF_008_a_first_start_up_that_failed_is_repeated_without_the_operator(void)
{
    rig_start(&rig);
    rig_box(&rig, "motor insertion stuck");
    expect_start_up(STATUS_OK);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 31000U).kind);
    rig_release(&rig);
    rig_box(&rig, "motor insertion normal");
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_FRESH, grade(NEURO_AXIS_FEET));
    rig_home(&rig);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_TAKEN, grade(NEURO_AXIS_FEET));
}

void test_SWR_NEXT_001_the_cards_and_the_operator_come_before_start_up(void)
{
    rig_start_homed(&rig);
    rig_box(&rig, "card feet silent");
    rig_cycles(&rig, SILENT_CYCLES);
    expect_step(NEXT_STEP_CHECK_CARDS);
    expect_start_up(STATUS_HARDWARE_NOT_READY);
    rig_box(&rig, "card feet normal");
    rig_cycles(&rig, 20U);
    expect_step(NEXT_STEP_CONFIRM);
    (void)hold_button(HOLD_CYCLES + 1U);
    expect_step(NEXT_STEP_START_UP);
    expect_start_up(STATUS_OK);
}

void test_SWR_NEXT_001_a_pedal_fault_and_a_lost_position_ask_for_the_operator(void)
{
    start_with_doubt(NEURO_AXIS_FEET);
    rig_box(&rig, "pedal a close");
    rig_cycles(&rig, 200U);
    expect_step(NEXT_STEP_PEDAL_FAULT);
    rig_box(&rig, "pedal a open");
    rig_cycles(&rig, 2U);
    expect_step(NEXT_STEP_CONFIRM);
}

void test_SWR_REF_015_an_axis_whose_card_falls_silent_at_rest_is_unverified(void)
{
    rig_start_homed(&rig);
    const int32_t position = rig.outputs.snapshot.axes[NEURO_AXIS_ROTATION].position_ticks;
    rig_box(&rig, "card rotation silent");
    rig_cycles(&rig, 3000U);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_UNVERIFIED, grade(NEURO_AXIS_ROTATION));
    rig_box(&rig, "card rotation normal");
    rig_cycles(&rig, 3000U);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_UNVERIFIED, grade(NEURO_AXIS_ROTATION));
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_TAKEN, grade(NEURO_AXIS_FEET));
    TEST_ASSERT_EQUAL_INT32(position,
                            rig.outputs.snapshot.axes[NEURO_AXIS_ROTATION].position_ticks);
}

void test_SWR_REF_015_an_axis_that_comes_back_elsewhere_is_lost(void)
{
    rig_start_homed(&rig);
    rig_box(&rig, "card rotation silent");
    rig_cycles(&rig, SILENT_CYCLES);
    /* Farther than it may move, and not so far that its card sees it leave its guard. */
    rig.box.axes[NEURO_AXIS_ROTATION].encoder.count +=
        (3 * rig.controller.axes[NEURO_AXIS_ROTATION].supervision.sealed.rest_ticks) / 2;
    rig_cycles(&rig, 20U);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_UNVERIFIED, grade(NEURO_AXIS_ROTATION));
    rig_box(&rig, "card rotation normal");
    rig_cycles(&rig, 2U);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_LOST, grade(NEURO_AXIS_ROTATION));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_MOVED_OFF));
}

void test_SWR_REF_015_an_axis_that_was_confirmed_and_falls_silent_again_is_unverified(void)
{
    start_with_doubt(NEURO_AXIS_FEET);
    rig_box(&rig, "card feet silent");
    rig_cycles(&rig, SILENT_CYCLES);
    rig_box(&rig, "card feet normal");
    rig_cycles(&rig, 20U);
    TEST_ASSERT_EQUAL_UINT32(1U, hold_button(HOLD_CYCLES + 1U));
    rig_box(&rig, "card feet silent");
    rig_cycles(&rig, SILENT_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_UNVERIFIED, grade(NEURO_AXIS_FEET));
}

static void begin_move(void)
{
    rig_start_targeted(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_press(&rig);
    rig_cycles(&rig, 300U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
}

void test_SWR_LOOP_010_a_pause_of_control_at_rest_loses_nothing(void)
{
    rig_start_homed(&rig);
    rig_cycles(&rig, 20U);
    box_advance(&rig.box, 2U * LIMIT_CARD_WATCHDOG_US);
    rig_cycles(&rig, 3U);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        TEST_ASSERT_EQUAL_UINT32(LINK_CAUSE_FAULT, rig_link(&rig, i)->sealed.cause);
        TEST_ASSERT_TRUE(axis_is_homed(&rig.controller.axes[i]));
    }
    expect_start_up(STATUS_OK);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_homed);
}

void test_SWR_LINK_003_any_other_trouble_of_a_card_at_rest_loses_the_position(void)
{
    rig_start_homed(&rig);
    rig_box(&rig, "card rotation foreign");
    rig_cycles(&rig, 3U);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_LOST, grade(NEURO_AXIS_ROTATION));
    rig_start_homed(&rig);
    rig.box.axes[NEURO_AXIS_FEET].card.faults |= CARD_STATUS_HOT;
    rig_cycles(&rig, 3U);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_LOST, grade(NEURO_AXIS_FEET));
}

/* Why the card was given up the last time says nothing of this time. */
void test_SWR_LINK_003_a_damaged_link_at_rest_loses_the_position(void)
{
    rig_start_homed(&rig);
    rig_box(&rig, "card rotation silent");
    rig_cycles(&rig, SILENT_CYCLES);
    rig_box(&rig, "card rotation normal");
    rig_cycles(&rig, 20U);
    (void)hold_button(HOLD_CYCLES + 1U);
    expect_start_up(STATUS_OK);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_VERIFIED, grade(NEURO_AXIS_ROTATION));
    rig_cycles(&rig, 20U);
    rig_link(&rig, NEURO_AXIS_ROTATION)->chart.state_inverse ^= 4U;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_LOST, grade(NEURO_AXIS_ROTATION));
}

void test_SWR_REF_010_a_doubt_ends_the_move_and_forgets_the_target(void)
{
    begin_move();
    axis_doubt(&rig.controller.axes[NEURO_AXIS_PITCH]);
    rig_forget(&rig);
    rig_cycle(&rig);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_HOMED, rig.answers[0].status);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_target);
    rig_release(&rig);
}

void test_SWR_REF_010_nobody_moves_to_a_target_with_an_axis_in_doubt(void)
{
    const rigid_t pose = rig_pose(5000000, 190000000, 60000000);
    rig_start_targeted(&rig);
    axis_doubt(&rig.controller.axes[NEURO_AXIS_PITCH]);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &pose).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_HOMED,
                             rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
}

static const event_t *last_event(event_id_t id)
{
    const event_t *found = NULL;
    for (uint32_t i = 0U; i < rig.event_count; i++) {
        found = (rig.events[i].id == (uint32_t)id) ? &rig.events[i] : found;
    }
    TEST_ASSERT_NOT_NULL(found);
    return found;
}

static void expect_reported(event_id_t id, uint32_t axis)
{
    TEST_ASSERT_EQUAL_UINT32(axis, last_event(id)->subject);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, id));
}

void test_SWR_REF_011_each_change_of_trust_names_its_axis(void)
{
    const uint32_t axis = NEURO_AXIS_ROTATION;
    rig_start_homed(&rig);
    encoder_set_position(&rig.controller.axes[axis].sealed.encoder, 12);
    supervision_shift(&rig.controller.axes[axis].supervision, 12);
    controller_seal(&rig.controller);
    axis_doubt(&rig.controller.axes[axis]);
    rig_cycle(&rig);
    expect_reported(EVENT_AXIS_UNVERIFIED, axis);
    TEST_ASSERT_EQUAL_UINT32(EVENT_SEVERITY_WARNING, last_event(EVENT_AXIS_UNVERIFIED)->severity);
    (void)hold_button(HOLD_CYCLES + 1U);
    expect_reported(EVENT_AXIS_CONFIRMED, axis);
    TEST_ASSERT_EQUAL_INT32(12, last_event(EVENT_AXIS_CONFIRMED)->value);
    axis_lose_reference(&rig.controller.axes[axis]);
    rig_cycles(&rig, 20U);
    expect_reported(EVENT_AXIS_REFERENCE_LOST, axis);
    TEST_ASSERT_EQUAL_INT32(12, last_event(EVENT_AXIS_REFERENCE_LOST)->value);
}

void test_SWR_REF_011_what_an_axis_in_doubt_loses_is_reported_and_what_was_never_known_is_not(void)
{
    start_with_doubt(NEURO_AXIS_ROTATION);
    axis_lose_reference(&rig.controller.axes[NEURO_AXIS_ROTATION]);
    rig_cycle(&rig);
    expect_reported(EVENT_AXIS_REFERENCE_LOST, NEURO_AXIS_ROTATION);
    rig_start(&rig);
    axis_forget(&rig.controller.axes[NEURO_AXIS_ROTATION]);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_AXIS_REFERENCE_LOST));
}

void test_SWR_REF_011_a_fault_reports_the_loss_itself(void)
{
    begin_move();
    rig_box(&rig, "motor head stuck");
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 700U).kind);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_LOST, grade(NEURO_AXIS_HEAD));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_AXIS_REFERENCE_LOST));
}

void test_SWR_REF_011_an_axis_without_switch_is_taken_and_not_homed(void)
{
    rig_start(&rig);
    rig_home(&rig);
    TEST_ASSERT_EQUAL_UINT32(2U, rig_count(&rig, EVENT_AXIS_TAKEN));
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_ROTATION, last_event(EVENT_AXIS_TAKEN)->subject);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_TAKEN, grade(NEURO_AXIS_ROTATION));
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_VERIFIED, grade(NEURO_AXIS_HEAD));
}

void test_SWR_REF_006_nothing_is_confirmed_while_an_axis_in_doubt_moves(void)
{
    start_with_doubt(NEURO_AXIS_FEET);
    axis_lose_reference(&rig.controller.axes[NEURO_AXIS_ROTATION]);
    rig_cycle(&rig);
    const uint32_t before = rig_count(&rig, EVENT_AXIS_CONFIRMED);
    rig_box(&rig, "button press");
    for (uint32_t i = 0U; i < (2U * HOLD_CYCLES); i++) {
        rig.box.axes[NEURO_AXIS_ROTATION].motor.position_ticks += 0.05;
        rig_cycle(&rig);
    }
    rig_cycles(&rig, 2U * HOLD_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(before, rig_count(&rig, EVENT_AXIS_CONFIRMED));
    rig_box(&rig, "button release");
    rig_cycles(&rig, 2U);
    TEST_ASSERT_EQUAL_UINT32(2U, hold_button(HOLD_CYCLES + 1U));
}

/* A motor that runs by itself from the first START_UP on, and ends at its stop. */
void test_SWR_REF_013_an_axis_that_runs_by_itself_at_power_on_is_never_taken(void)
{
    rig_start(&rig);
    rig_box(&rig, "motor rotation runs");
    expect_start_up(STATUS_OK);
    rig_press(&rig);
    rig_cycles(&rig, 20000U);
    rig_release(&rig);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_LOST, grade(NEURO_AXIS_ROTATION));
    for (uint32_t i = 0U; i < rig.event_count; i++) {
        TEST_ASSERT_FALSE((rig.events[i].id == (uint32_t)EVENT_AXIS_TAKEN) &&
                          (rig.events[i].subject == (uint32_t)NEURO_AXIS_ROTATION));
    }
    rig_box(&rig, "motor rotation normal");
    rig_cycles(&rig, 200U);
    expect_start_up(STATUS_CONFIRM_POSITIONS);
    TEST_ASSERT_EQUAL_UINT32(1U, hold_button(HOLD_CYCLES + 1U));
    rig_home(&rig);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_VERIFIED, grade(NEURO_AXIS_ROTATION));
}
