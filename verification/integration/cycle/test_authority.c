/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: at most one page or connection commands, what it has armed ends with its
 * authority, and stopping is everyone's. On the simulated box.
 */
#include "unit/support/commands.h"
#include "integration/support/rig.h"

#include "unity.h"

#include "interface/note_kind.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"
#include "unit/support/scenes.h"

#include "integration/support/authority_world.inc"

#define PEER 11U
#define OTHER_PEER 21U

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static status_t by_peer(uint32_t peer, command_kind_t kind, uint32_t argument)
{
    return send(COMMAND_SOURCE_IGTL, peer, kind, argument);
}

void test_SWR_AUTH_002_a_page_takes_what_is_free(void)
{
    start_free();
    expect_nobody();
    TEST_ASSERT_EQUAL(STATUS_NO_AUTHORITY,
                      by_page(OTHER_PAGE, COMMAND_WORKPHASE, WORKPHASE_PLANNING));
    TEST_ASSERT_EQUAL(STATUS_NO_AUTHORITY, by_page(0U, COMMAND_TAKE, 0U));
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(OTHER_PAGE, COMMAND_TAKE, 0U));
    expect_holder(COMMAND_SOURCE_HTTP, OTHER_PAGE);
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(OTHER_PAGE, COMMAND_TAKE, 0U));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AUTHORITY_TAKEN));
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(OTHER_PAGE, COMMAND_WORKPHASE, WORKPHASE_PLANNING));
    TEST_ASSERT_EQUAL(STATUS_NO_AUTHORITY, by_page(RIG_PAGE, COMMAND_TAKE, 0U));
    expect_holder(COMMAND_SOURCE_HTTP, OTHER_PAGE);
}

void test_SWR_AUTH_002_a_connection_takes_it_with_its_first_accepted_command(void)
{
    start_free();
    TEST_ASSERT_EQUAL(STATUS_OK, by_peer(PEER, COMMAND_WORKPHASE, WORKPHASE_STOP));
    TEST_ASSERT_EQUAL(STATUS_OK, by_peer(PEER, COMMAND_PROPOSE_ENTRY, 0U));
    TEST_ASSERT_EQUAL(STATUS_OK, by_peer(PEER, COMMAND_WITHDRAW, COMMAND_PROPOSE_ENTRY));
    TEST_ASSERT_EQUAL(STATUS_WRONG_WORKPHASE, by_peer(PEER, COMMAND_NEEDLE, 0U));
    TEST_ASSERT_EQUAL(STATUS_NO_AUTHORITY, by_peer(0U, COMMAND_WORKPHASE, WORKPHASE_PLANNING));
    expect_nobody();
    TEST_ASSERT_EQUAL(STATUS_OK, by_peer(PEER, COMMAND_WORKPHASE, WORKPHASE_PLANNING));
    expect_holder(COMMAND_SOURCE_IGTL, PEER);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AUTHORITY_TAKEN));
}

void test_SWR_AUTH_002_a_connection_that_shows_a_needle_takes_nothing(void)
{
    start_moving();
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(RIG_PAGE, COMMAND_RELEASE, 0U));
    rig_cycles(&rig, CYCLES(LIMIT_AUTHORITY_END_US));
    expect_nobody();
    TEST_ASSERT_EQUAL(STATUS_OK, by_peer(PEER, COMMAND_NEEDLE, 0U));
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_seen_needle);
    expect_nobody();
}

void test_SWR_AUTH_003_who_has_no_authority_is_refused_by_name(void)
{
    start_free();
    TEST_ASSERT_EQUAL(STATUS_OK, by_peer(PEER, COMMAND_WORKPHASE, WORKPHASE_CALIBRATION));
    rig_forget(&rig);
    TEST_ASSERT_EQUAL(STATUS_NO_AUTHORITY,
                      by_peer(OTHER_PEER, COMMAND_WORKPHASE, WORKPHASE_PLANNING));
    TEST_ASSERT_EQUAL(STATUS_NO_AUTHORITY, by_peer(OTHER_PEER, COMMAND_REGISTRATION, 0U));
    TEST_ASSERT_EQUAL(STATUS_NO_AUTHORITY, by_peer(OTHER_PEER, COMMAND_WITHDRAW, COMMAND_ENTRY));
    TEST_ASSERT_EQUAL(STATUS_NO_AUTHORITY, by_peer(OTHER_PEER, COMMAND_NEEDLE, 0U));
    TEST_ASSERT_EQUAL(STATUS_NO_AUTHORITY, by_page(RIG_PAGE, COMMAND_JOG, 0U));
    TEST_ASSERT_EQUAL(STATUS_NO_AUTHORITY,
                      by_page(RIG_PAGE, COMMAND_WITHDRAW, COMMAND_PROPOSE_ENTRY));
    TEST_ASSERT_EQUAL_UINT32(6U, rig_count(&rig, EVENT_AUTHORITY_REFUSED));
    TEST_ASSERT_EQUAL(STATUS_NO_AUTHORITY, by_page(RIG_PAGE, COMMAND_RENEW, 0U));
    TEST_ASSERT_EQUAL_UINT32(6U, rig_count(&rig, EVENT_AUTHORITY_REFUSED));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_COMMAND_REFUSED));
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_CALIBRATION, rig.outputs.snapshot.workphase);
    expect_holder(COMMAND_SOURCE_IGTL, PEER);
}

void test_SWR_AUTH_004_stopping_is_everyones_and_takes_nothing(void)
{
    static const workphase_t stops[] = {WORKPHASE_STOP, WORKPHASE_EMERGENCY};
    for (uint32_t i = 0U; i < 2U; i++) {
        start_moving();
        TEST_ASSERT_EQUAL(STATUS_OK, by_peer(OTHER_PEER, COMMAND_WORKPHASE, stops[i]));
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
        expect_holder(COMMAND_SOURCE_HTTP, RIG_PAGE);
        start_moving();
        TEST_ASSERT_EQUAL(STATUS_OK, by_page(0U, COMMAND_WORKPHASE, stops[i]));
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
        expect_holder(COMMAND_SOURCE_HTTP, RIG_PAGE);
    }
}

void test_SWR_AUTH_005_releasing_it_ends_the_order_in_that_cycle(void)
{
    static const uint32_t peers[] = {RIG_PAGE, 0U};
    for (uint32_t i = 0U; i < 2U; i++) {
        start_moving();
        rig.commands[0] = (command_t){.source = COMMAND_SOURCE_HTTP,
                                      .peer = peers[i],
                                      .kind = COMMAND_RELEASE,
                                      .id = RIG_OWN_ID};
        rig.command_count = 1U;
        rig_cycle(&rig);
        expect_lost(AUTHORITY_LOSS_RELEASED);
    }
}

/* Positions of the axes after so many cycles. */
static void run_on(uint32_t cycles, int32_t ticks[ROBOT_AXIS_MAX])
{
    rig_cycles(&rig, cycles);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        ticks[i] = rig_position(&rig, i);
    }
}

/* STOP is everyone's and switches off at once; so does the loss. No drive leaves after it, and
 * where the axes come to rest is the same. */
void test_SWR_AUTH_005_after_a_loss_the_axes_stop_as_after_stop(void)
{
    static rig_t moving;
    int32_t stopped[ROBOT_AXIS_MAX] = {0};
    int32_t lost[ROBOT_AXIS_MAX] = {0};
    start_moving();
    moving = rig;
    TEST_ASSERT_EQUAL(STATUS_OK, by_peer(PEER, COMMAND_WORKPHASE, WORKPHASE_STOP));
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    run_on(500U, stopped);
    rig = moving;
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(RIG_PAGE, COMMAND_RELEASE, 0U));
    for (uint32_t i = 0U; i < 500U; i++) {
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
        run_on(1U, lost);
    }
    TEST_ASSERT_EQUAL_INT32_ARRAY(stopped, lost, robot_neuro.axis_count);
    run_on(500U, lost);
    TEST_ASSERT_EQUAL_INT32_ARRAY(stopped, lost, robot_neuro.axis_count);
}

void test_SWR_AUTH_005_who_has_nothing_releases_nothing(void)
{
    start_moving();
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(OTHER_PAGE, COMMAND_RELEASE, 0U));
    TEST_ASSERT_EQUAL(STATUS_OK, by_peer(RIG_PAGE, COMMAND_RELEASE, 0U));
    TEST_ASSERT_EQUAL(STATUS_OK, by_peer(0U, COMMAND_RELEASE, 0U));
    expect_holder(COMMAND_SOURCE_HTTP, RIG_PAGE);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
}

static bool are_axes_at_rest(void)
{
    bool is_every_one = true;
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        is_every_one = is_every_one && (rig.outputs.snapshot.axes[i].speed_ticks_per_s_q8 == 0);
    }
    return is_every_one;
}

void test_SWR_AUTH_006_nobody_has_it_before_the_axes_rest(void)
{
    start_moving();
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(RIG_PAGE, COMMAND_RELEASE, 0U));
    TEST_ASSERT_EQUAL_UINT32(AUTHORITY_STATE_ENDING, rig.outputs.snapshot.authority);
    TEST_ASSERT_EQUAL(STATUS_NO_AUTHORITY, by_page(OTHER_PAGE, COMMAND_TAKE, 0U));
    TEST_ASSERT_EQUAL(STATUS_NO_AUTHORITY, by_peer(PEER, COMMAND_WORKPHASE, WORKPHASE_PLANNING));
    rig_cycles(&rig, CYCLES(LIMIT_AUTHORITY_END_US));
    expect_nobody();
    TEST_ASSERT_TRUE(are_axes_at_rest());
    /* The pedal is held all the while. */
    TEST_ASSERT_EQUAL(STATUS_OK, by_peer(PEER, COMMAND_WORKPHASE, WORKPHASE_MOVE_TO_TARGET));
    rig_cycles(&rig, 50U);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    rig_release(&rig);
    rig_press(&rig);
    rig_cycles(&rig, 50U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
}

/* The holder falls silent in each of the cycles in which the axes begin to move. */
void test_SWR_AUTH_006_rest_is_measured_after_the_loss(void)
{
    for (uint32_t cycles = 0U; cycles < 100U; cycles += SCENE_DIVISOR) {
        rig_start_targeted(&rig);
        rig_cycles(&rig, 600U);
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
        rig_box(&rig, "pedal press");
        rig_cycles(&rig, cycles);
        rig.silent_sources = (uint32_t)1U << (uint32_t)COMMAND_SOURCE_HTTP;
        rig_cycle(&rig);
        TEST_ASSERT_EQUAL_UINT32(AUTHORITY_STATE_ENDING, rig.outputs.snapshot.authority);
        while (rig.outputs.snapshot.authority == (uint32_t)AUTHORITY_STATE_ENDING) {
            rig_cycle(&rig);
        }
        TEST_ASSERT_EQUAL_UINT32(AUTHORITY_STATE_NOBODY, rig.outputs.snapshot.authority);
        TEST_ASSERT_TRUE(are_axes_at_rest());
    }
}

void test_SWR_AUTH_006_an_axis_that_never_rests_keeps_it_for_a_while_only(void)
{
    start_moving();
    rig_box(&rig, "motor rotation runs");
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(RIG_PAGE, COMMAND_RELEASE, 0U));
    rig_cycles(&rig, CYCLES(LIMIT_AUTHORITY_END_US) - 1U);
    TEST_ASSERT_EQUAL_UINT32(AUTHORITY_STATE_ENDING, rig.outputs.snapshot.authority);
    rig_cycle(&rig);
    expect_nobody();
}

void test_SWR_AUTH_007_a_page_that_does_not_renew_it_loses_it(void)
{
    start_moving();
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(RIG_PAGE, COMMAND_RENEW, 0U));
    rig_release(&rig);
    rig_forget(&rig);
    rig_cycles(&rig, CYCLES(LIMIT_AUTHORITY_RENEW_US) - 11U);
    expect_holder(COMMAND_SOURCE_HTTP, RIG_PAGE);
    rig_cycle(&rig);
    expect_lost(AUTHORITY_LOSS_UNRENEWED);
}

void test_SWR_AUTH_007_a_connection_may_be_silent(void)
{
    start_free();
    TEST_ASSERT_EQUAL(STATUS_OK, by_peer(PEER, COMMAND_WORKPHASE, WORKPHASE_PLANNING));
    rig_cycles(&rig, 3U * CYCLES(LIMIT_AUTHORITY_RENEW_US));
    expect_holder(COMMAND_SOURCE_IGTL, PEER);
}

void test_SWR_AUTH_010_a_dead_process_has_no_authority(void)
{
    start_moving();
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(OTHER_PAGE, COMMAND_REQUEST, AUTHORITY_REQUEST_TAKE));
    rig_forget(&rig);
    rig.silent_sources = (uint32_t)1U << (uint32_t)COMMAND_SOURCE_IGTL;
    rig_cycles(&rig, 20U);
    expect_holder(COMMAND_SOURCE_HTTP, RIG_PAGE);
    rig.silent_sources = (uint32_t)1U << (uint32_t)COMMAND_SOURCE_HTTP;
    rig_cycle(&rig);
    expect_lost(AUTHORITY_LOSS_SILENT);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.requester_peer);
}

void test_SWR_CORE_004_damaged_authority_is_nobodys_and_ends_the_order(void)
{
    start_moving();
    rig.controller.authority.chart.state_inverse ^= 1U;
    rig_cycle(&rig);
    expect_nobody();
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_CHART_REPAIRED));
}

void test_SWR_MEMORY_002_a_holder_that_changes_by_itself_is_forgotten(void)
{
    start_moving();
    rig.controller.authority.sealed.holder.peer = OTHER_PAGE;
    rig_cycle(&rig);
    expect_nobody();
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_MEMORY_DAMAGED));
}

/* `kind` of a note that the events name. */
static void expect_note(note_kind_t kind, event_id_t id)
{
    rig_forget(&rig);
    rig.commands[0] = (command_t){.source = COMMAND_SOURCE_HTTP,
                                  .peer = RIG_PAGE,
                                  .kind = COMMAND_NOTE,
                                  .as.note = {.note = (uint32_t)kind, .number = 17}};
    rig.command_count = 1U;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL(STATUS_OK, rig.outputs.answers[0].status);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, id));
    TEST_ASSERT_EQUAL_UINT32(1U, rig.event_count);
    TEST_ASSERT_EQUAL_UINT32(kind, rig.events[0].subject);
    TEST_ASSERT_EQUAL_INT32(17, rig.events[0].value);
}

void test_SWR_EVENT_011_a_note_is_everyones_and_is_one_event(void)
{
    start_free();
    for (uint32_t kind = 0U; kind < NOTE_KIND_COUNT; kind++) {
        expect_note((note_kind_t)kind,
                    (kind == (uint32_t)NOTE_LOGIN_REFUSED) ? EVENT_LOGIN_REFUSED : EVENT_NOTE);
    }
    expect_nobody();
    TEST_ASSERT_EQUAL(STATUS_UNKNOWN_COMMAND, by_page(RIG_PAGE, COMMAND_NOTE, NOTE_KIND_COUNT));
    TEST_ASSERT_EQUAL(STATUS_NOT_ALLOWED, by_peer(PEER, COMMAND_NOTE, NOTE_LOGIN));
}

void test_SWR_EVENT_011_a_note_disturbs_no_motion(void)
{
    start_moving();
    for (uint32_t i = 0U; i < 100U; i++) {
        expect_note(NOTE_OPERATOR, EVENT_NOTE);
        TEST_ASSERT_TRUE(rig_is_driving(&rig));
    }
}

void test_SWR_EVENT_011_a_note_is_no_sign_of_life(void)
{
    start_moving();
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(RIG_PAGE, COMMAND_RENEW, 0U));
    rig_release(&rig);
    rig_forget(&rig);
    rig_cycles(&rig, CYCLES(LIMIT_AUTHORITY_RENEW_US) - 12U);
    expect_note(NOTE_OPERATOR, EVENT_NOTE);
    expect_holder(COMMAND_SOURCE_HTTP, RIG_PAGE);
    rig_forget(&rig);
    rig_cycle(&rig);
    expect_lost(AUTHORITY_LOSS_UNRENEWED);
}

static void expect_step(next_step_t step)
{
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(step, rig.outputs.snapshot.next_step);
}

void test_SWR_AUTH_014_where_nobody_commands_that_is_the_next_step(void)
{
    start_free();
    expect_step(NEXT_STEP_AUTHORITY);
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(RIG_PAGE, COMMAND_TAKE, 0U));
    expect_step(NEXT_STEP_MOVE);
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(RIG_PAGE, COMMAND_RELEASE, 0U));
    rig_box(&rig, "estop pull");
    rig_cycles(&rig, 20U);
    expect_step(NEXT_STEP_RELEASE_ESTOP);
    rig_box(&rig, "estop reset");
    rig_cycles(&rig, 20U);
    expect_step(NEXT_STEP_AUTHORITY);
}

void test_SWR_AUTH_014_a_press_that_is_waited_for_is_the_next_step_unless_something_moves(void)
{
    start_moving();
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(OTHER_PAGE, COMMAND_REQUEST, AUTHORITY_REQUEST_TAKE));
    expect_step(NEXT_STEP_HOLD_PEDAL);
    rig_release(&rig);
    expect_step(NEXT_STEP_GRANT);
    TEST_ASSERT_EQUAL(STATUS_OK, by_page(OTHER_PAGE, COMMAND_RELEASE, 0U));
    expect_step(NEXT_STEP_PRESS_PEDAL);
}
