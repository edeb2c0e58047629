/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Moves to a target on the simulated box: their legs and their end, and what they need.
 * In every test the rig counts cycles that drive without the pedal; there must be none.
 */
#include "unit/support/commands.h"
#include "integration/support/rig.h"

#include "unity.h"

#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"

static rig_t rig;

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

void test_SWR_IGTL_014_the_pose_is_known_only_while_every_axis_is_homed_and_registered(void)
{
    const snapshot_t *const shown = &rig.outputs.snapshot;
    rigid_t identity;
    rigid_set_identity(&identity);
    rig_start(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_HOMED, shown->pose_status);
    rig_start_homed(&rig);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_REGISTERED, shown->pose_status);
    rig_register(&rig, &identity);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, shown->pose_status);
    rig_box(&rig, "card lateral silent");
    rig_cycles(&rig, LIMIT_SILENT_KEPT_CYCLES + 2U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_HOMED, shown->pose_status);
}

/* So near to home that the switch may be active. */
void test_SWR_MOTION_005_a_move_that_a_switch_blocks_is_discarded_by_name(void)
{
    command_t jog = {.kind = COMMAND_JOG, .as.jog = {.axis = NEURO_AXIS_LATERAL, .to_ticks = -27}};
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    (void)rig_command(&rig, jog);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 10000U).kind);
    rig_release(&rig);
    rig_box(&rig, "switch lateral stuck");
    jog.as.jog.to_ticks = -7;
    (void)rig_command(&rig, jog);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig_finish(&rig, 7000U).kind);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ORDER_OVERDUE));
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_LATERAL, rig.events[rig.event_count - 2U].subject);
    TEST_ASSERT_INT32_WITHIN(2, 20, rig.events[rig.event_count - 2U].value);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
}

void test_SWR_PERMIT_003_each_axis_reports_its_reasons_and_since_when(void)
{
    rig_start(&rig);
    TEST_ASSERT_BITS_HIGH(1UL << PERMIT_REASON_AXIS_DISABLED,
                          rig.outputs.snapshot.axes[2].permit_reasons);
    const uint32_t since = rig.outputs.snapshot.axes[2].permit_since_cycle;
    rig_cycles(&rig, 50U);
    TEST_ASSERT_EQUAL_UINT32(since, rig.outputs.snapshot.axes[2].permit_since_cycle);
    (void)rig_workphase(&rig, WORKPHASE_START_UP);
    TEST_ASSERT_EQUAL_UINT32(rig.outputs.snapshot.cycle,
                             rig.outputs.snapshot.axes[2].permit_since_cycle);
}

void test_SWR_PERMIT_002_the_frame_carries_a_drive_only_with_the_permit(void)
{
    rig_start_moving(&rig);
    TEST_ASSERT_BITS_HIGH(CARD_SYSTEM_PERMIT | CARD_SYSTEM_PEDAL,
                          rig_sent(&rig, NEURO_AXIS_HEAD).system_state);
    TEST_ASSERT_EQUAL_HEX32(CARD_CONTROL_AMPLIFIER, rig_sent(&rig, NEURO_AXIS_HEAD).control);
    rig_release(&rig);
    TEST_ASSERT_BITS_LOW(CARD_SYSTEM_PERMIT | CARD_SYSTEM_PEDAL,
                         rig_sent(&rig, NEURO_AXIS_HEAD).system_state);
    TEST_ASSERT_EQUAL_HEX32(0U, rig_sent(&rig, NEURO_AXIS_HEAD).control);
}

void test_SWR_LOOP_003_a_late_cycle_advances_the_profile_by_one_cycle(void)
{
    rig_start_moving(&rig);
    const uint32_t before = rig.controller.mode.sealed.leg.profile.cycle;
    box_advance(&rig.box, 4000U);
    rig.elapsed_us = 5000U;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(before + 1U, rig.controller.mode.sealed.leg.profile.cycle);
}

void test_SWR_MOTION_004_the_move_ends_at_the_target_with_the_drive_off(void)
{
    rig_start_moving(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 30000U).kind);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        TEST_ASSERT_INT32_WITHIN(robot_neuro.axes[i].deadband_ticks,
                                 rig.controller.plan.target_ticks[i], rig_position(&rig, i));
    }
    int32_t distance_nm = 0;
    int32_t angle_bam = 0;
    rigid_difference(&rig.outputs.snapshot.scanner_treatment, &rig.controller.plan.scanner_target,
                     &distance_nm, &angle_bam);
    TEST_ASSERT_LESS_OR_EQUAL_INT32(2000, distance_nm);
    rig_release(&rig);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_NOTHING, rig.outputs.snapshot.next_step);
}

void test_SWR_MOTION_002_the_needle_is_retracted_before_the_base_moves_again(void)
{
    const rigid_t other = rig_pose(-8000000, 185000000, 40000000);
    rig_start_moving(&rig);
    (void)rig_finish(&rig, 30000U);
    rig_release(&rig);
    (void)rig_workphase(&rig, WORKPHASE_TARGETING);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &other).status);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    const int32_t head = rig_position(&rig, NEURO_AXIS_HEAD);
    rig_press(&rig);
    const int32_t stroke = robot_neuro.axes[NEURO_AXIS_INSERTION].maximum_ticks;
    while (rig_position(&rig, NEURO_AXIS_INSERTION) > (stroke / 64)) {
        TEST_ASSERT_INT32_WITHIN(1, head, rig_position(&rig, NEURO_AXIS_HEAD));
        rig_cycle(&rig);
        TEST_ASSERT_LESS_THAN_UINT32(100000U, rig.controller.sealed.cycle);
    }
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 40000U).kind);
}

void test_SWR_MOTION_004_the_base_also_moves_towards_larger_positions(void)
{
    const rigid_t far = rig_pose(-8000000, 185000000, 40000000);
    const rigid_t near = rig_pose(5000000, 190000000, 60000000);
    rig_start_targeted(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &far).status);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_press(&rig);
    (void)rig_finish(&rig, 40000U);
    rig_release(&rig);
    (void)rig_workphase(&rig, WORKPHASE_TARGETING);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &near).status);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 40000U).kind);
    TEST_ASSERT_EQUAL_INT32(rig.controller.plan.target_ticks[NEURO_AXIS_HEAD],
                            rig_position(&rig, NEURO_AXIS_HEAD));
}

void test_SWR_CMD_003_no_sequence_of_commands_drives_an_axis_without_the_pedal(void)
{
    uint32_t seed = 12345U;
    rig_start_targeted(&rig);
    for (uint32_t i = 0U; i < 5000U; i++) {
        seed = (seed * 1664525U) + 1013904223U;
        const command_kind_t kind = (command_kind_t)((seed >> 8) % 9U);
        command_t command = commands_of_pose(kind, rig_pose(5000000, 190000000, 60000000));
        if (kind == COMMAND_WORKPHASE) {
            command.as.workphase.workphase = (seed >> 16) % 10U;
        } else if (kind == COMMAND_JOG) {
            command.as.jog.axis = (seed >> 16) % 10U;
            command.as.jog.to_ticks = (int32_t)(seed % 2000U) - 1000;
        } else {
            /* A pose says it, or nothing. */
        }
        (void)rig_command(&rig, command);
        TEST_ASSERT_FALSE(rig_is_driving(&rig));
    }
}
