/* SPDX-License-Identifier: Apache-2.0 */
/** @file Who does what is asked for next is obeyed, in every workphase, whatever is known of the
 * plan, and comes to the target. */
#include "unity.h"

#include "integration/support/rig.h"
#include "interface/app/names.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"
#include "unit/support/scenes.h"

#include <stdio.h>
#include <string.h>

#include "integration/support/next_step_world.inc"

void setUp(void)
{
}

void tearDown(void)
{
}

typedef enum { UNREGISTERED, REGISTERED, TARGETED, WITHOUT_PROBE } knowledge_t;

/* Homed, and so much of the plan is known. */
static void plan(knowledge_t knowledge)
{
    rigid_t identity;
    rigid_set_identity(&identity);
    if (knowledge == UNREGISTERED) {
        rig_start_homed(&rig);
    } else if (knowledge == REGISTERED) {
        rig_start_homed(&rig);
        rig_register(&rig, &identity);
    } else {
        rig_start_targeted(&rig);
    }
}

static void start(workphase_t workphase, knowledge_t knowledge)
{
    plan(knowledge);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, workphase).status);
    if (rig.outputs.snapshot.order != (uint32_t)ARMING_STATE_NONE) {
        rig_let_expire(&rig); /* The armed order expires. */
    }
    if (knowledge == WITHOUT_PROBE) {
        (void)memcpy(probe_nm, rig.outputs.snapshot.probe_nm, sizeof probe_nm);
        rig.controller.plan.probe.length_nm[0] ^= 0x10000;
        rig_cycle(&rig);
    }
}

/* START_UP, which homes, is asked for by itself where it is. */
static void follow_to_the_move(const char *where)
{
    next_step_t step = NEXT_STEP_NOTHING;
    for (uint32_t i = 0U; (i < 8U) && (step != NEXT_STEP_START_UP) && (step != NEXT_STEP_MOVE);
         i++) {
        step = (next_step_t)rig.outputs.snapshot.next_step;
        TEST_ASSERT_EQUAL_STRING_MESSAGE("OK", status_name((int32_t)follow(step)), where);
    }
    TEST_ASSERT_TRUE_MESSAGE((step == NEXT_STEP_START_UP) || (step == NEXT_STEP_MOVE), where);
}

void test_SWR_NEXT_001_what_is_asked_for_is_obeyed_in_each_workphase_and_leads_to_the_target(void)
{
    static const struct {
        workphase_t workphase;
        knowledge_t knowledge;
        next_step_t step;
    } rows[] = {
        /* Always played: no other test reaches this. */
        {WORKPHASE_MOVE_TO_TARGET, WITHOUT_PROBE, NEXT_STEP_PLANNING},
        {WORKPHASE_PLANNING, UNREGISTERED, NEXT_STEP_CALIBRATION},
        {WORKPHASE_PLANNING, REGISTERED, NEXT_STEP_TARGETING},
        {WORKPHASE_PLANNING, TARGETED, NEXT_STEP_TARGETING},
        {WORKPHASE_PLANNING, WITHOUT_PROBE, NEXT_STEP_PROBE},
        {WORKPHASE_CALIBRATION, UNREGISTERED, NEXT_STEP_REGISTER},
        {WORKPHASE_CALIBRATION, REGISTERED, NEXT_STEP_TARGETING},
        {WORKPHASE_CALIBRATION, TARGETED, NEXT_STEP_TARGETING},
        {WORKPHASE_TARGETING, REGISTERED, NEXT_STEP_TARGET},
        {WORKPHASE_TARGETING, TARGETED, NEXT_STEP_MOVE},
        {WORKPHASE_TARGETING, WITHOUT_PROBE, NEXT_STEP_PROBE},
        {WORKPHASE_MOVE_TO_TARGET, TARGETED, NEXT_STEP_MOVE},
        {WORKPHASE_MANUAL, UNREGISTERED, NEXT_STEP_CALIBRATION},
        {WORKPHASE_MANUAL, REGISTERED, NEXT_STEP_TARGETING},
        {WORKPHASE_MANUAL, TARGETED, NEXT_STEP_TARGETING},
        {WORKPHASE_STOP, UNREGISTERED, NEXT_STEP_CALIBRATION},
        {WORKPHASE_STOP, REGISTERED, NEXT_STEP_TARGETING},
        {WORKPHASE_STOP, TARGETED, NEXT_STEP_TARGETING},
        {WORKPHASE_STOP, WITHOUT_PROBE, NEXT_STEP_PROBE},
        {WORKPHASE_EMERGENCY, UNREGISTERED, NEXT_STEP_START_UP},
        {WORKPHASE_EMERGENCY, TARGETED, NEXT_STEP_START_UP},
        {WORKPHASE_START_UP, UNREGISTERED, NEXT_STEP_PLANNING},
        {WORKPHASE_START_UP, REGISTERED, NEXT_STEP_PLANNING},
    };
    for (uint32_t i = 0U; i < SCENES(sizeof rows / sizeof rows[0]); i++) {
        const char *const where = workphase_name((int32_t)rows[i].workphase);
        start(rows[i].workphase, rows[i].knowledge);
        TEST_ASSERT_EQUAL_STRING_MESSAGE(next_step_name((int32_t)rows[i].step),
                                         next_step_name((int32_t)rig.outputs.snapshot.next_step),
                                         where);
        follow_to_the_move(where);
    }
}

void test_SWR_NEXT_001_before_start_up_nothing_else_is_asked_for(void)
{
    rig_start(&rig);
    rig_cycles(&rig, 100U);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_START_UP, rig.outputs.snapshot.next_step);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, follow(NEXT_STEP_START_UP));
}

static void hold_button(void)
{
    rig_box(&rig, "button press");
    rig_cycles(&rig, (LIMIT_CONFIRM_HOLD_US / LIMIT_CYCLE_US) + 1U);
    rig_box(&rig, "button release");
    rig_cycles(&rig, 2U);
}

static void jog(uint32_t axis)
{
    const command_t command = {.kind = (uint32_t)COMMAND_JOG_BY,
                               .as.jog_by = {.axis = axis, .by_ticks = 20}};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, command).status);
}

void test_SWR_NEXT_007_what_is_armed_is_stopped_before_a_position_is_confirmed(void)
{
    rig_start_homed(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    fail_axis(NEURO_AXIS_FEET);
    expect_named(NEXT_STEP_PLACE, NEURO_AXIS_FEET, CARD_SLOT_COUNT, EVENT_AXIS_REFERENCE_LOST);
    jog(NEURO_AXIS_ROTATION);
    expect(NEXT_STEP_STOP);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_STOP).status);
    expect(NEXT_STEP_PLACE);
    hold_button();
    expect(NEXT_STEP_START_UP);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, follow(NEXT_STEP_START_UP));
    rig_press(&rig);
    rig_release(&rig);
    expect(NEXT_STEP_PLANNING);
}

void test_SWR_NEXT_006_the_pedal_is_let_go_once_homing_is_done(void)
{
    rig_start(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 150000U).kind);
    expect(NEXT_STEP_RELEASE_PEDAL);
    rig_release(&rig);
    expect(NEXT_STEP_PLANNING);
    rig_box(&rig, "pedal b close");
    rig_cycles(&rig, 10U);
    expect(NEXT_STEP_RELEASE_PEDAL);
}

void test_SWR_NEXT_006_the_pedal_is_let_go_before_START_UP_and_at_the_target(void)
{
    rig_start(&rig);
    rig_press(&rig);
    expect(NEXT_STEP_RELEASE_PEDAL);
    rig_start_moving(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 60000U).kind);
    expect(NEXT_STEP_RELEASE_PEDAL);
    rig_release(&rig);
    expect(NEXT_STEP_NOTHING);
}

void test_SWR_NEXT_003_a_card_that_is_lost_is_named_until_it_answers(void)
{
    rig_start_homed(&rig);
    rig_box(&rig, "card head silent");
    rig_cycles(&rig, 200U);
    expect_named(NEXT_STEP_CHECK_CARDS, NEURO_AXIS_HEAD, slot_of(NEURO_AXIS_HEAD), EVENT_CARD_LOST);
    rig_box(&rig, "card head normal");
    rig_cycles(&rig, 20U);
    expect_named(NEXT_STEP_START_UP, ROBOT_AXIS_MAX, CARD_SLOT_COUNT, EVENT_ID_COUNT);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, follow(NEXT_STEP_START_UP));
}

void test_SWR_NEXT_180_without_any_card_the_box_is_looked_after(void)
{
    rig_start_homed(&rig);
    for (uint32_t i = 0U; i < rig.robot.axis_count; i++) {
        char order[32];
        (void)snprintf(order, sizeof order, "card %s silent", rig.robot.axes[i].name);
        rig_box(&rig, order);
    }
    rig_cycles(&rig, 200U);
    expect_named(NEXT_STEP_CHECK_BOX, ROBOT_AXIS_MAX, CARD_SLOT_COUNT, EVENT_ID_COUNT);
    rig_box(&rig, "card feet normal");
    rig_cycles(&rig, 20U);
    expect_named(NEXT_STEP_CHECK_CARDS, NEURO_AXIS_HEAD, slot_of(NEURO_AXIS_HEAD), EVENT_CARD_LOST);
}

void test_SWR_NEXT_181_a_position_to_be_confirmed_is_named_as_in_doubt(void)
{
    rig_start_homed(&rig);
    rig_box(&rig, "card feet silent");
    rig_cycles(&rig, 200U);
    rig_box(&rig, "card feet normal");
    rig_cycles(&rig, 20U);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_UNVERIFIED,
                             rig.outputs.snapshot.axes[NEURO_AXIS_FEET].reference);
    expect_named(NEXT_STEP_CONFIRM, NEURO_AXIS_FEET, CARD_SLOT_COUNT, EVENT_AXIS_UNVERIFIED);
}

void test_SWR_NEXT_003_channels_that_disagree_are_reported_until_they_are_open(void)
{
    rig_start_homed(&rig);
    rig_box(&rig, "pedal a close");
    rig_cycles(&rig, 150U);
    expect(NEXT_STEP_PEDAL_FAULT);
    rig_box(&rig, "pedal a open");
    rig_cycles(&rig, 10U);
    expect(NEXT_STEP_START_UP);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, follow(NEXT_STEP_START_UP));
}

void test_SWR_NEXT_005_a_hot_motor_is_waited_for(void)
{
    rig_start_homed(&rig);
    rig_box(&rig, "motor yaw hot");
    rig_cycles(&rig, SCENES(60000U));
    expect_named(NEXT_STEP_WAIT, NEURO_AXIS_YAW, CARD_SLOT_COUNT, EVENT_AXIS_HOT);
    rig_box(&rig, "motor yaw normal");
    rig.box.axes[NEURO_AXIS_YAW].card.motor_temperature_c = 20.0;
    rig_cycles(&rig, 20U);
    expect(NEXT_STEP_START_UP);
}

void test_SWR_NEXT_005_a_hot_driver_is_waited_for(void)
{
    rig_start_homed(&rig);
    rig_box(&rig, "card yaw hot");
    rig_cycles(&rig, 100U);
    expect_named(NEXT_STEP_WAIT, NEURO_AXIS_YAW, slot_of(NEURO_AXIS_YAW), EVENT_CARD_HOT);
    rig_box(&rig, "card yaw normal");
    rig_cycles(&rig, 100U);
    expect(NEXT_STEP_START_UP);
}

void test_SWR_NEXT_005_a_position_that_moves_is_not_to_be_confirmed(void)
{
    rig_start_homed(&rig);
    fail_axis(NEURO_AXIS_FEET);
    rig_box(&rig, "motor feet runs");
    rig_cycles(&rig, 100U);
    expect_named(NEXT_STEP_WAIT, NEURO_AXIS_FEET, CARD_SLOT_COUNT, EVENT_AXIS_MOVED_OFF);
    rig_box(&rig, "scanner on");
    rig_cycles(&rig, 100U);
    expect(NEXT_STEP_SCANNER);
    rig_box(&rig, "scanner off");
    rig_box(&rig, "motor feet normal");
    rig_cycles(&rig, 2000U);
    expect(NEXT_STEP_PLACE);
}

void test_SWR_NEXT_003_who_has_authority_next_waits_until_the_axes_rest(void)
{
    rig_start_moving(&rig);
    const command_t release = {.source = (uint32_t)COMMAND_SOURCE_HTTP,
                               .peer = RIG_PAGE,
                               .kind = (uint32_t)COMMAND_RELEASE};
    rig.is_page_away = true;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, release).status);
    rig_release(&rig);
    expect(NEXT_STEP_WAIT);
    rig_cycles(&rig, 1000U);
    expect(NEXT_STEP_AUTHORITY);
}

void test_SWR_NEXT_003_what_was_just_granted_is_not_to_be_taken(void)
{
    const command_t ask = {.source = (uint32_t)COMMAND_SOURCE_HTTP,
                           .peer = 7U,
                           .kind = (uint32_t)COMMAND_REQUEST,
                           .as.request = {.request = (uint32_t)AUTHORITY_REQUEST_TAKE}};
    rig_start_homed(&rig);
    rig_leave(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, ask).status);
    expect(NEXT_STEP_GRANT);
    rig_box(&rig, "button press");
    while (rig.outputs.snapshot.request != (uint32_t)AUTHORITY_REQUEST_GRANTED) {
        TEST_ASSERT_LESS_THAN_UINT32(20000U, rig.controller.sealed.cycle);
        rig_cycle(&rig);
    }
    expect(NEXT_STEP_WAIT);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(7U, rig.outputs.snapshot.holder_peer);
    expect(NEXT_STEP_PLANNING);
}

/* At its switch the head would be too far from the feet. */
static void go_out(void)
{
    static const uint32_t axes[] = {NEURO_AXIS_HEAD, NEURO_AXIS_FEET};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    for (uint32_t i = 0U; i < 2U; i++) {
        const command_t out = {.kind = (uint32_t)COMMAND_JOG,
                               .as.jog = {.axis = axes[i], .to_ticks = -2000}};
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, out).status);
        rig_release(&rig);
        rig_press(&rig);
        TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 60000U).kind);
    }
    rig_release(&rig);
}

void test_SWR_NEXT_003_an_axis_that_must_not_be_homed_asks_for_room_and_gets_it_in_jogs(void)
{
    rig_start_homed(&rig);
    go_out();
    fail_axis(NEURO_AXIS_HEAD);
    expect_named(NEXT_STEP_MAKE_ROOM, NEURO_AXIS_HEAD, CARD_SLOT_COUNT, EVENT_HOMING_BARRED);
    jog(NEURO_AXIS_FEET);
    expect(NEXT_STEP_MAKE_ROOM);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 60000U).kind);
    rig_release(&rig);
    expect(NEXT_STEP_MAKE_ROOM);
}
