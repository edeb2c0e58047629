/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: commands are carried out or refused by name, in the workphase that they need;
 * registration, target, proposals and jogs. On the simulated box.
 */
#include "unit/support/commands.h"
#include "integration/support/rig.h"

#include "unity.h"

#include "base/fixed.h"
#include "controller/controller.h"
#include "robot/robot_neuro.h"
#include "unit/support/contract_trap.h"

static rig_t rig;

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static command_t proposal(command_kind_t kind, int32_t x_nm, int32_t y_nm, int32_t z_nm)
{
    return commands_of_pose(kind, rig_pose(x_nm, y_nm, z_nm));
}

void test_SWR_CMD_001_each_command_is_answered_once_with_its_id_and_source(void)
{
    rig_start(&rig);
    for (uint32_t i = 0U; i < CONTROLLER_COMMANDS; i++) {
        rig.commands[i].id = 700U + i;
        rig.commands[i].source = i % COMMAND_SOURCE_COUNT;
        rig.commands[i].peer = RIG_PAGE;
        rig.commands[i].kind = (uint32_t)COMMAND_WORKPHASE;
        rig.commands[i].as.workphase.workphase = (uint32_t)WORKPHASE_PLANNING;
    }
    rig.command_count = CONTROLLER_COMMANDS;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(CONTROLLER_COMMANDS, rig.outputs.answer_count);
    for (uint32_t i = 0U; i < CONTROLLER_COMMANDS; i++) {
        TEST_ASSERT_EQUAL_UINT32(700U + i, rig.outputs.answers[i].id);
        TEST_ASSERT_EQUAL_UINT32(i % COMMAND_SOURCE_COUNT, rig.outputs.answers[i].source);
        TEST_ASSERT_EQUAL_UINT32((i % COMMAND_SOURCE_COUNT) == COMMAND_SOURCE_HTTP
                                     ? STATUS_WRONG_WORKPHASE
                                     : STATUS_NO_AUTHORITY,
                                 rig.outputs.answers[i].status);
    }
}

void test_SWR_CMD_002_more_commands_than_a_cycle_takes_break_the_contract(void)
{
    rig_start(&rig);
    rig.inputs.command_count = CONTROLLER_COMMANDS + 1U;
    EXPECT_CONTRACT("controller", 100U,
                    controller_step(&rig.controller, &robot_neuro, &rig.inputs, &rig.outputs));
}

void test_SWR_CMD_004_unknown_commands_workphases_and_axes_are_refused(void)
{
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    const command_t nothing = {.kind = (uint32_t)COMMAND_NONE};
    const command_t unknown = {.kind = 99U};
    const command_t jog = {.kind = (uint32_t)COMMAND_JOG,
                           .as.jog = {.axis = robot_neuro.axis_count}};
    TEST_ASSERT_EQUAL_UINT32(STATUS_UNKNOWN_COMMAND, rig_command(&rig, nothing).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_UNKNOWN_COMMAND, rig_command(&rig, unknown).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_UNKNOWN_COMMAND, rig_command(&rig, jog).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_UNKNOWN_COMMAND,
                             rig_workphase(&rig, WORKPHASE_UNDEFINED).status);
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_MANUAL, rig.outputs.snapshot.workphase);
}

void test_SWR_PHASE_002_a_refused_request_changes_nothing_but_the_record(void)
{
    rig_start_homed(&rig);
    const controller_t before = rig.controller;
    TEST_ASSERT_EQUAL_UINT32(STATUS_WRONG_WORKPHASE,
                             rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    TEST_ASSERT_EQUAL_UINT32(before.procedure.workphase.state,
                             rig.controller.procedure.workphase.state);
    TEST_ASSERT_EQUAL_UINT32(before.procedure.arming.state, rig.controller.procedure.arming.state);
    TEST_ASSERT_EQUAL_MEMORY(&before.plan, &rig.controller.plan, sizeof before.plan);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_COMMAND_REFUSED));
}

void test_SWR_PHASE_006_targeting_needs_a_registration_and_moving_a_target(void)
{
    rigid_t identity;
    rigid_set_identity(&identity);
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_PLANNING);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_REGISTERED,
                             rig_workphase(&rig, WORKPHASE_TARGETING).status);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_CALIBRATION, rig.outputs.snapshot.next_step);
    rig_register(&rig, &identity);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_TARGET, rig.outputs.snapshot.next_step);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_TARGET,
                             rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    const rigid_t pose = rig_pose(5000000, 190000000, 60000000);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &pose).status);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_MOVE, rig.outputs.snapshot.next_step);
    axis_lose_reference(&rig.controller.axes[NEURO_AXIS_YAW]);
    controller_seal(&rig.controller);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_TARGET,
                             rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_START_UP, rig.outputs.snapshot.next_step);
}

void test_SWR_REG_001_a_registration_that_is_not_rigid_is_refused_and_the_old_one_stands(void)
{
    rigid_t identity;
    rigid_set_identity(&identity);
    rig_start_homed(&rig);
    rig_register(&rig, &identity);
    (void)rig_workphase(&rig, WORKPHASE_CALIBRATION);
    command_t command = {.kind = (uint32_t)COMMAND_REGISTRATION,
                         .as.registration = {.pose = identity}};
    command.as.registration.pose.rotation_q30[0][0] = FIXED_ONE_Q30 / 2;
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_RIGID, rig_command(&rig, command).status);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_registered);
    TEST_ASSERT_EQUAL_MEMORY(&identity, &rig.outputs.snapshot.scanner_zframe, sizeof identity);
}

void test_SWR_REG_002_a_registration_is_taken_in_calibration_only_and_clears_the_target(void)
{
    rigid_t identity;
    rigid_set_identity(&identity);
    const command_t command = {.kind = (uint32_t)COMMAND_REGISTRATION,
                               .as.registration = {.pose = identity}};
    rig_start_targeted(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_WRONG_WORKPHASE, rig_command(&rig, command).status);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_target);
    (void)rig_command(&rig, proposal(COMMAND_PROPOSE_ENTRY, 5000000, 220000000, 60000000));
    (void)rig_workphase(&rig, WORKPHASE_CALIBRATION);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, command).status);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_target);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_proposed_entry);
}

void test_SWR_PLAN_003_a_target_out_of_reach_is_refused_with_the_nearest_limit(void)
{
    const rigid_t pose = rig_pose(200000000, 190000000, 60000000);
    rig_start_targeted(&rig);
    const answer_t answer = rig_target(&rig, &pose);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_REFUSED, answer.kind);
    TEST_ASSERT_EQUAL_UINT32(STATUS_AXIS_LIMIT, answer.status);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_LATERAL, answer_axis(&answer));
    TEST_ASSERT_EQUAL_UINT32(1U, answer_as_limit(&answer)->is_maximum);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_target);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_TARGET,
                             rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
}

void test_SWR_PHASE_006_nothing_is_armed_while_anything_stands_that_start_up_clears(void)
{
    rig_start_targeted(&rig);
    rig_box(&rig, "estop pull");
    rig_cycles(&rig, 5U);
    (void)rig_workphase(&rig, WORKPHASE_STOP);
    (void)rig_workphase(&rig, WORKPHASE_TARGETING);
    TEST_ASSERT_EQUAL_UINT32(STATUS_FAULT_PRESENT,
                             rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    rig_box(&rig, "estop reset");
    rig_cycles(&rig, 20U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_FAULT_PRESENT,
                             rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    (void)rig_workphase(&rig, WORKPHASE_START_UP);
    (void)rig_workphase(&rig, WORKPHASE_PLANNING);
    (void)rig_workphase(&rig, WORKPHASE_TARGETING);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
}

void test_SWR_PHASE_006_nothing_is_armed_after_late_cycles_or_a_pedal_fault(void)
{
    rig_start_targeted(&rig);
    rig.elapsed_us = LIMIT_OVERRUN_US + 1U;
    rig_cycles(&rig, LIMIT_OVERRUNS_IN_A_ROW);
    rig.elapsed_us = 1000U;
    TEST_ASSERT_EQUAL_UINT32(STATUS_FAULT_PRESENT,
                             rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    rig_start_targeted(&rig);
    rig_box(&rig, "pedal b close");
    rig_cycles(&rig, 150U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_FAULT_PRESENT,
                             rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
}

void test_SWR_AXIS_010_a_jog_is_refused_while_the_axes_are_disabled(void)
{
    const command_t jog = {.kind = (uint32_t)COMMAND_JOG,
                           .as.jog = {.axis = NEURO_AXIS_PITCH, .to_ticks = -200}};
    rig_start_homed(&rig);
    rig_box(&rig, "card yaw silent");
    rig_cycles(&rig, 10U);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    TEST_ASSERT_EQUAL_UINT32(STATUS_FAULT_PRESENT, rig_command(&rig, jog).status);
}

void test_SWR_PLAN_004_a_target_is_taken_in_targeting_only_and_returned_as_reachable(void)
{
    const rigid_t pose = rig_pose(5000000, 190000000, 60000000);
    rig_start_targeted(&rig);
    const answer_t answer = rig_target(&rig, &pose);
    int32_t distance_nm = 0;
    int32_t angle_bam = 0;
    rigid_difference(&answer_as_pose(&answer)->pose, &pose, &distance_nm, &angle_bam);
    TEST_ASSERT_LESS_OR_EQUAL_INT32(38000, distance_nm);
    (void)rig_workphase(&rig, WORKPHASE_PLANNING);
    TEST_ASSERT_EQUAL_UINT32(STATUS_WRONG_WORKPHASE, rig_target(&rig, &pose).status);
}

void test_SWR_IGTL_009_proposals_are_shown_and_never_armed(void)
{
    rig_start_targeted(&rig);
    (void)rig_workphase(&rig, WORKPHASE_PLANNING);
    (void)rig_command(&rig, proposal(COMMAND_PROPOSE_ENTRY, 0, 246000000, 50000000));
    (void)rig_command(&rig, proposal(COMMAND_PROPOSE_TARGET, 0, 200000000, 50000000));
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_proposal_reachable);
    TEST_ASSERT_EQUAL_INT32(200000000 / 100000,
                            (rig.outputs.snapshot.scanner_desired.translation.y_nm + 50000) /
                                100000);
    command_t command = proposal(COMMAND_PROPOSE_REGISTRATION, 0, 0, 0);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, command).status);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_proposed_registration);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_proposal_reachable);
    command.as.seen_pose.pose.rotation_q30[1][1] = FIXED_ONE_Q30;
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_RIGID, rig_command(&rig, command).status);
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
}

void test_SWR_AXIS_010_a_jog_goes_to_its_position_in_manual_only(void)
{
    const command_t jog = {.kind = (uint32_t)COMMAND_JOG,
                           .as.jog = {.axis = NEURO_AXIS_YAW, .to_ticks = -200}};
    rig_start_homed(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_WRONG_WORKPHASE, rig_command(&rig, jog).status);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    const answer_t answer = rig_command(&rig, jog);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, answer.status);
    TEST_ASSERT_EQUAL_UINT32(0U, answer.is_final);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 5000U).kind);
    TEST_ASSERT_EQUAL_INT32(-200, rig.outputs.snapshot.axes[NEURO_AXIS_YAW].position_ticks);
}

void test_SWR_AXIS_004_a_jog_outside_the_soft_limits_is_refused(void)
{
    command_t jog = {.kind = (uint32_t)COMMAND_JOG,
                     .as.jog = {.axis = NEURO_AXIS_YAW, .to_ticks = 9}};
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    answer_t answer = rig_command(&rig, jog);
    TEST_ASSERT_EQUAL_UINT32(STATUS_AXIS_LIMIT, answer.status);
    TEST_ASSERT_EQUAL_UINT32(1U, answer_as_limit(&answer)->is_maximum);
    jog.as.jog.to_ticks = -1223;
    answer = rig_command(&rig, jog);
    TEST_ASSERT_EQUAL_UINT32(STATUS_AXIS_LIMIT, answer.status);
    TEST_ASSERT_EQUAL_UINT32(0U, answer_as_limit(&answer)->is_maximum);
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
}

void test_SWR_PERMIT_005_an_axis_not_homed_jogs_at_reduced_speed(void)
{
    command_t jog = {.kind = (uint32_t)COMMAND_JOG, .as.jog = {.axis = NEURO_AXIS_YAW}};
    rig_start_needle_homed(&rig);
    const int32_t start = rig.outputs.snapshot.axes[NEURO_AXIS_YAW].position_ticks;
    jog.as.jog.to_ticks = start - 27;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    rig_press(&rig);
    const int32_t most_q8 = (robot_neuro.axes[NEURO_AXIS_YAW].speed_ticks_per_s * 256 *
                             (int32_t)LIMIT_UNHOMED_SPEED_PERCENT) /
                            100;
    for (uint32_t i = 0U; i < 1000U; i++) {
        rig_cycle(&rig);
        TEST_ASSERT_INT32_WITHIN(
            most_q8 + 256, 0,
            rig.outputs.snapshot.axes[NEURO_AXIS_YAW].setpoint_speed_ticks_per_s_q8);
        TEST_ASSERT_LESS_OR_EQUAL_UINT32(
            LIMIT_UNHOMED_SPEED_PERCENT,
            rig.outputs.snapshot.axes[NEURO_AXIS_YAW].speed_cap_percent);
    }
    TEST_ASSERT_EQUAL_INT32(start - 27, rig.outputs.snapshot.axes[NEURO_AXIS_YAW].position_ticks);
}

void test_SWR_PERMIT_005_an_axis_that_has_lagged_catches_up_within_the_cap(void)
{
    const int32_t speed_ticks_per_s = robot_neuro.axes[NEURO_AXIS_LATERAL].speed_ticks_per_s;
    command_t jog = {.kind = (uint32_t)COMMAND_JOG, .as.jog = {.axis = NEURO_AXIS_LATERAL}};
    const uint32_t most = LIMIT_UNHOMED_SPEED_PERCENT + LIMIT_SPEED_CAP_TOLERANCE_PERCENT;
    rig_start_needle_homed(&rig);
    jog.as.jog.to_ticks = rig.outputs.snapshot.axes[NEURO_AXIS_LATERAL].position_ticks - 94;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    rig_press(&rig);
    rig_cycles(&rig, 500U);
    rig_box(&rig, "motor lateral stuck");
    rig_cycles(&rig, 300U);
    rig_box(&rig, "motor lateral normal");
    for (uint32_t i = 0U; i < 10U; i++) {
        const int32_t before = rig.outputs.snapshot.axes[NEURO_AXIS_LATERAL].position_ticks;
        rig_cycles(&rig, 200U);
        const int32_t way = before - rig.outputs.snapshot.axes[NEURO_AXIS_LATERAL].position_ticks;
        /* Two ticks are the motor's fall time. */
        TEST_ASSERT_LESS_OR_EQUAL_INT32(
            2 + ((speed_ticks_per_s * (int32_t)most * 25) / (100 * 100)), way);
    }
}

void test_SWR_ENC_002_an_impossible_count_faults_the_axis_and_loses_its_home(void)
{
    rig_start_homed(&rig);
    rig.controller.axes[NEURO_AXIS_YAW].sealed.encoder.reading ^= 0x40000000;
    controller_seal(&rig.controller);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_ENABLED, rig.outputs.snapshot.axes[NEURO_AXIS_YAW].power);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_FAULT, rig.outputs.snapshot.axes[NEURO_AXIS_YAW].power);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_LOST,
                             rig.outputs.snapshot.axes[NEURO_AXIS_YAW].reference);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_ENCODER_FAULT));
}

void test_SWR_AXIS_020_a_jog_to_where_the_switch_may_be_active_is_refused_by_name(void)
{
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const axis_config_t *const config = &robot_neuro.axes[i];
        const bool has_switch = config->limit_switch != (uint8_t)LIMIT_SWITCH_NONE;
        const bool is_lower = config->limit_switch == (uint8_t)LIMIT_SWITCH_LOWER;
        const int32_t out = is_lower ? 1 : -1;
        command_t jog = {.kind = (uint32_t)COMMAND_JOG,
                         .as.jog = {.axis = i, .to_ticks = config->home_ticks + out}};
        if (has_switch) {
            jog.as.jog.to_ticks =
                is_lower ? config->target_minimum_ticks : config->target_maximum_ticks;
            jog.as.jog.to_ticks -= out;
            const answer_t answer = rig_command(&rig, jog);
            TEST_ASSERT_EQUAL_UINT32(STATUS_SWITCH_ZONE, answer.status);
            TEST_ASSERT_EQUAL_UINT32(i, answer_axis(&answer));
            jog.as.jog.to_ticks += out;
        }
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    }
}

void test_SWR_AXIS_020_a_target_where_a_switch_may_be_active_is_refused_by_name(void)
{
    joints_t joints;
    rigid_t pose;
    int32_t ticks[ROBOT_AXIS_MAX] = {-3000, -2000, -1, 33334, 0, 0, 0};
    rig_start_targeted(&rig);
    joints_from_ticks(&robot_neuro, ticks, &joints);
    kinematics_forward(&robot_neuro, &robot_neuro.probe, &joints, &pose);
    const answer_t answer = rig_target(&rig, &pose);
    TEST_ASSERT_EQUAL_UINT32(STATUS_SWITCH_ZONE, answer.status);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_LATERAL, answer_axis(&answer));
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_target);
    ticks[NEURO_AXIS_LATERAL] = -20;
    joints_from_ticks(&robot_neuro, ticks, &joints);
    kinematics_forward(&robot_neuro, &robot_neuro.probe, &joints, &pose);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &pose).status);
}

void test_SWR_AXIS_003_driven_time_of_homing_is_bounded(void)
{
    rig_start(&rig);
    (void)rig_workphase(&rig, WORKPHASE_START_UP);
    rig_press(&rig);
    rig_cycles(&rig, 100U);
    rig.controller.axes[NEURO_AXIS_INSERTION].sealed.homing.leg_us =
        robot_neuro.axes[NEURO_AXIS_INSERTION].home_time_us - 500U;
    controller_seal(&rig.controller);
    rig_cycles(&rig, 2U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_HOME_TIMEOUT));
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_FAULT,
                             rig.outputs.snapshot.axes[NEURO_AXIS_INSERTION].power);
}

void test_SWR_AXIS_009_a_following_error_is_noted_with_its_size(void)
{
    rig_start_targeted(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_press(&rig);
    rig_cycles(&rig, 300U);
    rig.controller.axes[NEURO_AXIS_HEAD].sealed.setpoint_ticks +=
        robot_neuro.axes[NEURO_AXIS_HEAD].following_error_ticks + 100;
    controller_seal(&rig.controller);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_FOLLOWING_ERROR));
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
}
