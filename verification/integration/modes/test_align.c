/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: ALIGN lines the base up by a confirmed entry point with the needle out, INSERT
 * sends the needle alone in once the base is there; meanwhile no client changes where to. On the
 * simulated box, whose true positions are looked at.
 */
#include "unit/support/commands.h"
#include "integration/support/rig.h"

#include "unity.h"

#include "charts/arming_chart.h"
#include "robot/robot_neuro.h"
#include "safety/needle.h"

static rig_t rig;
static const command_t align = {.kind = (uint32_t)COMMAND_ALIGN};
static const command_t insert = {.kind = (uint32_t)COMMAND_INSERT};

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static uint32_t status_of(command_t command)
{
    return rig_command(&rig, command).status;
}

/* The entry point of a needle straight down to (5, 190, 60) mm, `depth_nm` + 36 mm above. */
static command_t entry(command_kind_t kind, int32_t depth_nm)
{
    return commands_of_pose(kind, rig_pose(5000000, 190000000 + 36000000 + depth_nm, 60000000));
}

static uint32_t send_target(void)
{
    const rigid_t pose = rig_pose(5000000, 190000000, 60000000);
    return rig_target(&rig, &pose).status;
}

/* TARGETING, with a target that was accepted with its entry point. */
static void start_aimed(void)
{
    rig_start_targeted(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, status_of(entry(COMMAND_ENTRY, 20000000)));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send_target());
    rig_forget(&rig);
}

static void expect_done(command_kind_t kind)
{
    const answer_t answer = rig_finish(&rig, 60000U);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, answer.kind);
    TEST_ASSERT_EQUAL_UINT32(kind, answer.command);
    rig_release(&rig);
    rig_cycles(&rig, 100U);
}

static void run(command_t command)
{
    const answer_t answer = rig_command(&rig, command);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, answer.status);
    TEST_ASSERT_EQUAL_UINT32(0U, answer.is_final);
    rig_press(&rig);
    expect_done((command_kind_t)command.kind);
}

static bool is_base_at_target(void)
{
    double ticks[ROBOT_AXIS_MAX];
    bool is_there = true;
    box_true_positions(&rig.box, ticks);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const double way = ticks[i] - (double)rig.controller.plan.target_ticks[i];
        is_there =
            is_there && ((i == (uint32_t)NEURO_AXIS_INSERTION) || ((way < 3.0) && (way > -3.0)));
    }
    return is_there;
}

void test_SWR_ALIGN_001_the_base_lines_up_with_the_needle_out_then_the_needle_goes_in_alone(void)
{
    start_aimed();
    TEST_ASSERT_FALSE(is_base_at_target());
    run(align);
    TEST_ASSERT_TRUE(is_base_at_target());
    TEST_ASSERT_TRUE(needle_is_out(&robot_neuro, rig.controller.axes));
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_TARGETING, rig.outputs.snapshot.workphase);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_target);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    rig_forget(&rig);
    run(insert);
    TEST_ASSERT_TRUE(is_base_at_target());
    TEST_ASSERT_INT32_WITHIN(robot_neuro.axes[NEURO_AXIS_INSERTION].deadband_ticks,
                             rig.controller.plan.target_ticks[NEURO_AXIS_INSERTION],
                             rig_position(&rig, NEURO_AXIS_INSERTION));
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_NOTHING, rig.outputs.snapshot.next_step);
    TEST_ASSERT_EQUAL_INT32(rig.controller.plan.target_ticks[NEURO_AXIS_INSERTION],
                            rig.outputs.snapshot.axes[NEURO_AXIS_INSERTION].target_ticks);
}

/* As it was: one order, align then insert, with an entry point or without. */
void test_SWR_ALIGN_001_a_move_does_both_at_once_as_before(void)
{
    start_aimed();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    rig_press(&rig);
    expect_done(COMMAND_WORKPHASE);
    TEST_ASSERT_TRUE(is_base_at_target());
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_NOTHING, rig.outputs.snapshot.next_step);
}

void test_SWR_ALIGN_001_an_alignment_takes_out_a_needle_that_is_in(void)
{
    start_aimed();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    rig_press(&rig);
    expect_done(COMMAND_WORKPHASE);
    (void)rig_workphase(&rig, WORKPHASE_TARGETING);
    const rigid_t other = rig_pose(6000000, 190000000, 60000000);
    command_t above = entry(COMMAND_ENTRY, 20000000);
    above.as.pose.pose.translation.x_nm = 6000000;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, status_of(above));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &other).status);
    TEST_ASSERT_FALSE(needle_is_out(&robot_neuro, rig.controller.axes));
    run(align);
    TEST_ASSERT_TRUE(is_base_at_target());
    TEST_ASSERT_TRUE(needle_is_out(&robot_neuro, rig.controller.axes));
}

void test_SWR_ALIGN_003_neither_is_armed_without_a_target_and_its_confirmed_entry_point(void)
{
    rig_start_homed(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_TARGET, status_of(align));
    rig_start_targeted(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_ENTRY_POINT, status_of(align));
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_ENTRY_POINT, status_of(insert));
    (void)status_of(entry(COMMAND_PROPOSE_ENTRY, 20000000));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send_target());
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_ENTRY_POINT, status_of(align));
    (void)status_of((command_t){.kind = (uint32_t)COMMAND_ACCEPT_ENTRY});
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_ENTRY_POINT, status_of(align));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send_target());
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, status_of(align));
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_WAITING, rig.outputs.snapshot.order);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_PRESS_PEDAL, rig.outputs.snapshot.next_step);
}

void test_SWR_ALIGN_001_each_has_its_workphase(void)
{
    start_aimed();
    (void)rig_workphase(&rig, WORKPHASE_PLANNING);
    TEST_ASSERT_EQUAL_UINT32(STATUS_WRONG_WORKPHASE, status_of(align));
    (void)rig_workphase(&rig, WORKPHASE_TARGETING);
    run(align);
    TEST_ASSERT_EQUAL_UINT32(STATUS_WRONG_WORKPHASE, status_of(insert));
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    TEST_ASSERT_EQUAL_UINT32(STATUS_WRONG_WORKPHASE, status_of(align));
}

void test_SWR_ALIGN_004_a_needle_does_not_go_in_beside_the_line(void)
{
    start_aimed();
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_ALIGNED, status_of(insert));
    /* The armed order stays armed. */
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_WAITING, rig.outputs.snapshot.order);
}

void test_SWR_ALIGN_006_a_target_or_an_entry_point_is_not_taken_on_the_way(void)
{
    start_aimed();
    (void)status_of(entry(COMMAND_PROPOSE_ENTRY, 20000000));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, status_of(align));
    for (uint32_t i = 0U; i < 2U; i++) {
        TEST_ASSERT_EQUAL_UINT32(STATUS_MOTION_ARMED, send_target());
        TEST_ASSERT_EQUAL_UINT32(STATUS_MOTION_ARMED, status_of(entry(COMMAND_ENTRY, 20000000)));
        TEST_ASSERT_EQUAL_UINT32(STATUS_MOTION_ARMED,
                                 status_of((command_t){.kind = (uint32_t)COMMAND_ACCEPT_ENTRY}));
        TEST_ASSERT_EQUAL_UINT32(
            STATUS_MOTION_ARMED,
            status_of((command_t){.kind = (uint32_t)COMMAND_WITHDRAW,
                                  .as.withdrawal = {.of = (uint32_t)COMMAND_ENTRY}}));
        rig_press(&rig);
        rig_cycles(&rig, 100U);
    }
    TEST_ASSERT_EQUAL_UINT32(
        STATUS_OK,
        status_of((command_t){.kind = (uint32_t)COMMAND_WITHDRAW,
                              .as.withdrawal = {.of = (uint32_t)COMMAND_PROPOSE_ENTRY}}));
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_MOVING, rig.outputs.snapshot.order);
    expect_done(COMMAND_ALIGN);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send_target());
}

void test_SWR_ALIGN_006_on_the_way_to_the_target_as_well(void)
{
    rig_start_moving(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_MOTION_ARMED, send_target());
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_target);
    rig_release(&rig);
    (void)rig_workphase(&rig, WORKPHASE_STOP);
    TEST_ASSERT_EQUAL_UINT32(STATUS_WRONG_WORKPHASE, send_target());
}

/* In the middle of the way the pedal is let go and pressed again. */
void test_SWR_ALIGN_005_an_insertion_pauses_and_goes_on(void)
{
    start_aimed();
    run(align);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, status_of(insert));
    rig_press(&rig);
    rig_cycles(&rig, 1500U);
    rig_release(&rig);
    rig_cycles(&rig, 500U);
    const int32_t depth = rig_position(&rig, NEURO_AXIS_INSERTION);
    TEST_ASSERT_GREATER_THAN_INT32(needle_out_ticks(&robot_neuro), depth);
    TEST_ASSERT_LESS_THAN_INT32(rig.controller.plan.target_ticks[NEURO_AXIS_INSERTION] - 100,
                                depth);
    rig_press(&rig);
    expect_done(COMMAND_INSERT);
    TEST_ASSERT_TRUE(is_base_at_target());
}

/* How far its encoder may tremble. */
#define REST_TICKS 2

static void push(const char *order, uint32_t cycles)
{
    rig_box(&rig, order);
    rig_cycles(&rig, cycles);
}

void test_SWR_FLOW_002_a_probe_that_is_not_coupled_is_inserted_by_hand_and_nothing_faults(void)
{
    start_aimed();
    rig_box(&rig, "probe free");
    run(align);
    const int32_t out = rig_position(&rig, NEURO_AXIS_INSERTION);
    rig_forget(&rig);
    push("push 25", 6000U);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.event_count);
    TEST_ASSERT_INT32_WITHIN(REST_TICKS, out, rig_position(&rig, NEURO_AXIS_INSERTION));
    TEST_ASSERT_TRUE(is_base_at_target());
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_homed);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_target);
    push("push -25", 6000U);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.event_count);
}

void test_SWR_FLOW_003_a_push_that_moves_the_axis_is_a_fault_by_name(void)
{
    start_aimed();
    run(align);
    rig_forget(&rig);
    push("push 1", 500U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_MOVED_OFF));
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_FAULT,
                             rig.outputs.snapshot.axes[NEURO_AXIS_INSERTION].power);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.is_homed);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_TARGET, status_of(insert));
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_TARGET,
                             rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
}

/* Any armed order, also before the pedal lets it run. */
void test_SWR_FLOW_003_a_push_ends_what_is_armed(void)
{
    start_aimed();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    rig_forget(&rig);
    push("push 1", 500U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_MOVED_OFF));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ORDER_DISCARDED));
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
}
