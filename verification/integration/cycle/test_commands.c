/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Commands, answers, events and the plan, on the simulated box.
 */
#include "unit/support/commands.h"
#include "integration/support/rig.h"

#include "unity.h"

#include "base/fixed.h"
#include "controller/controller.h"
#include "robot/robot_neuro.h"
#include "unit/support/contract_trap.h"

#include <string.h>

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

void test_SWR_EVENT_001_events_are_numbered_without_gaps(void)
{
    rig_start(&rig);
    rig_home(&rig);
    for (uint32_t i = 0U; i < rig.event_count; i++) {
        TEST_ASSERT_EQUAL_UINT32(i, rig.events[i].number);
    }
    TEST_ASSERT_EQUAL_UINT32(rig.event_count, rig.outputs.snapshot.events);
}

/* The only event `id` since rig_forget(). */
static const event_t *only(event_id_t id)
{
    const event_t *found = NULL;
    for (uint32_t i = 0U; i < rig.event_count; i++) {
        if (rig.events[i].id == (uint32_t)id) {
            TEST_ASSERT_NULL(found);
            found = &rig.events[i];
        }
    }
    TEST_ASSERT_NOT_NULL(found);
    return found;
}

static void expect_cause(event_id_t id, event_cause_t cause, uint32_t peer)
{
    TEST_ASSERT_EQUAL_UINT32(cause, only(id)->cause);
    TEST_ASSERT_EQUAL_UINT32(peer, only(id)->peer);
}

static void command_by(command_source_t source, uint32_t peer, command_kind_t kind,
                       uint32_t argument)
{
    command_t command = commands_of_number(kind, argument);
    command.source = (uint32_t)source;
    command.peer = peer;
    rig_forget(&rig);
    (void)rig_command(&rig, command);
}

void test_SWR_EVENT_005_what_a_command_caused_names_its_source_and_connection(void)
{
    rig_start_homed(&rig);
    rig_leave(&rig);
    command_by(COMMAND_SOURCE_IGTL, 3U, COMMAND_WORKPHASE, WORKPHASE_CALIBRATION);
    expect_cause(EVENT_WORKPHASE, EVENT_CAUSE_IGTL, 3U);
    command_by(COMMAND_SOURCE_IGTL, 3U, COMMAND_REGISTRATION, 0U);
    expect_cause(EVENT_REGISTERED, EVENT_CAUSE_IGTL, 3U);
    command_by(COMMAND_SOURCE_IGTL, 3U, COMMAND_TARGET, 0U);
    expect_cause(EVENT_COMMAND_REFUSED, EVENT_CAUSE_IGTL, 3U);
    command_by(COMMAND_SOURCE_IGTL, 5U, COMMAND_TARGET, 0U);
    expect_cause(EVENT_AUTHORITY_REFUSED, EVENT_CAUSE_IGTL, 5U);
    command_by(COMMAND_SOURCE_IGTL, 4U, COMMAND_PROPOSE_ENTRY, 0U);
    expect_cause(EVENT_PROPOSAL, EVENT_CAUSE_IGTL, 4U);
    rig_start_targeted(&rig);
    rig_leave(&rig);
    command_by(COMMAND_SOURCE_IGTL, 7U, COMMAND_WORKPHASE, WORKPHASE_MOVE_TO_TARGET);
    expect_cause(EVENT_ORDER_ARMED, EVENT_CAUSE_IGTL, 7U);
    command_by(COMMAND_SOURCE_HTTP, 0U, COMMAND_WORKPHASE, WORKPHASE_STOP);
    expect_cause(EVENT_ORDER_DISCARDED, EVENT_CAUSE_CONSOLE, 0U);
    expect_cause(EVENT_WORKPHASE, EVENT_CAUSE_CONSOLE, 0U);
}

void test_SWR_EVENT_009_a_workphase_that_stands_is_reported_once(void)
{
    rig_start_homed(&rig);
    rig_forget(&rig);
    for (uint32_t i = 0U; i < 20U; i++) {
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_STOP).status);
    }
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_WORKPHASE));
}

void test_SWR_EVENT_005_a_cleared_e_stop_and_an_accepted_target_name_who_asked(void)
{
    const rigid_t pose = rig_pose(5000000, 190000000, 60000000);
    const command_t target = {.peer = 3U, .kind = COMMAND_TARGET, .as.pose = {.pose = pose}};
    rig_start_targeted(&rig);
    rig_leave(&rig);
    (void)rig_command(&rig, target);
    expect_cause(EVENT_TARGET_ACCEPTED, EVENT_CAUSE_IGTL, 3U);
    rig_box(&rig, "estop pull");
    rig_cycles(&rig, 5U);
    rig_box(&rig, "estop reset");
    rig_cycles(&rig, 5U);
    command_by(COMMAND_SOURCE_IGTL, 3U, COMMAND_WORKPHASE, WORKPHASE_START_UP);
    expect_cause(EVENT_ESTOP_CLEARED, EVENT_CAUSE_IGTL, 3U);
}

void test_SWR_EVENT_005_what_happens_after_a_command_is_not_put_down_to_it(void)
{
    rig_start_targeted(&rig);
    rig_leave(&rig);
    command_by(COMMAND_SOURCE_IGTL, 7U, COMMAND_WORKPHASE, WORKPHASE_MOVE_TO_TARGET);
    rig_let_expire(&rig);
    expect_cause(EVENT_ORDER_EXPIRED, EVENT_CAUSE_NONE, 0U);
}

static void begin_move(void)
{
    rig_start_targeted(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_press(&rig);
    rig_cycles(&rig, 300U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
    rig_forget(&rig);
}

void test_SWR_EVENT_006_what_ended_a_move_is_named(void)
{
    static const struct {
        const char *order;
        event_cause_t cause;
        uint32_t peer;
    } cases[] = {{"estop pull", EVENT_CAUSE_ESTOP, 0U},
                 {"pedal a open", EVENT_CAUSE_PEDAL, 0U},
                 {"motor head stuck", EVENT_CAUSE_AXIS, NEURO_AXIS_HEAD}};
    for (uint32_t i = 0U; i < (sizeof cases / sizeof cases[0]); i++) {
        begin_move();
        rig_box(&rig, cases[i].order);
        rig_cycles(&rig, 700U);
        expect_cause(EVENT_ORDER_DISCARDED, cases[i].cause, cases[i].peer);
    }
}

void test_SWR_EVENT_006_a_lost_card_and_late_cycles_are_named(void)
{
    begin_move();
    rig_box(&rig, "card insertion silent");
    rig_cycles(&rig, 20U);
    expect_cause(EVENT_ORDER_DISCARDED, EVENT_CAUSE_CARD,
                 robot_neuro.axes[NEURO_AXIS_INSERTION].slot);
    begin_move();
    rig.elapsed_us = LIMIT_OVERRUN_US + 1U;
    rig_cycles(&rig, LIMIT_OVERRUNS_IN_A_ROW);
    expect_cause(EVENT_ORDER_DISCARDED, EVENT_CAUSE_LOOP, 0U);
}

void test_SWR_EVENT_006_a_shut_gate_says_whether_pedal_or_scanner_shut_it(void)
{
    begin_move();
    rig_release(&rig);
    expect_cause(EVENT_PEDAL_RELEASED, EVENT_CAUSE_PEDAL, 0U);
    begin_move();
    rig_box(&rig, "scanner on");
    rig_cycles(&rig, 3U);
    expect_cause(EVENT_PEDAL_RELEASED, EVENT_CAUSE_SCANNER, 0U);
    begin_move();
    (void)rig_workphase(&rig, WORKPHASE_TARGETING);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_cycles(&rig, 3U);
    expect_cause(EVENT_PEDAL_RELEASED, EVENT_CAUSE_NONE, 0U); /* Arming shut it. */
}

static void damage_everything(void)
{
    rig.controller.pedal.chart.state_inverse ^= 1U;
    rig.controller.estop.state_inverse ^= 1U;
    rig.controller.loop.chart.state_inverse ^= 1U;
    rig.controller.procedure.workphase.state_inverse ^= 1U;
    rig.controller.procedure.arming.state_inverse ^= 1U;
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        rig.controller.axes[i].chart.power_inverse ^= 1U;
        rig_link(&rig, i)->chart.state_inverse ^= 1U;
    }
}

void test_SWR_CORE_004_damaged_charts_are_repaired_to_their_safe_states_and_reported(void)
{
    rig_start_targeted(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_press(&rig);
    rig_cycles(&rig, 300U);
    damage_everything();
    rig_cycle(&rig);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(19U, rig_count(&rig, EVENT_CHART_REPAIRED));
    TEST_ASSERT_EQUAL_UINT32(PEDAL_GATE_STATE_FAULT, rig.outputs.snapshot.pedal);
    TEST_ASSERT_EQUAL_UINT32(LOOP_GUARD_STATE_STOPPED, rig.outputs.snapshot.loop);
}

void test_SWR_CHART_007_every_chart_is_advanced_in_every_cycle(void)
{
    rig_start_homed(&rig);
    const controller_t *const self = &rig.controller;
    const uint64_t now_us = self->loop.chart.now_us;
    TEST_ASSERT_GREATER_THAN_UINT64(0U, now_us);
    TEST_ASSERT_EQUAL_UINT64(now_us, self->pedal.chart.now_us);
    TEST_ASSERT_EQUAL_UINT64(now_us, self->estop.now_us);
    TEST_ASSERT_EQUAL_UINT64(now_us, self->procedure.workphase.now_us);
    TEST_ASSERT_EQUAL_UINT64(now_us, self->procedure.arming.now_us);
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
        TEST_ASSERT_EQUAL_UINT64(now_us, rig_link(&rig, i)->chart.now_us);
        TEST_ASSERT_EQUAL_UINT64(now_us, self->axes[i].chart.now_us);
        /* It goes by the time between two reports; there was none before the first. */
        TEST_ASSERT_EQUAL_UINT64(now_us - LIMIT_CYCLE_US, self->axes[i].supervision.stall.now_us);
    }
}

/* Five charts of which there is one, and each card's and axis'. */
static void expect_all_charts_named(void)
{
    uint32_t single = 0U;
    uint32_t cards = 0U;
    uint32_t axes = 0U;
    for (uint32_t i = 0U; i < rig.outputs.event_count; i++) {
        const event_t *const event = &rig.outputs.events[i];
        if (event->id != (uint32_t)EVENT_CHART_REPAIRED) {
            continue;
        }
        if (event->subject == (uint32_t)EVENT_CHART_CARD) {
            cards |= (uint32_t)1U << (uint32_t)event->value;
        } else if (event->subject == (uint32_t)EVENT_CHART_AXIS) {
            axes |= (uint32_t)1U << (uint32_t)event->value;
        } else {
            single |= (uint32_t)1U << event->subject;
        }
    }
    TEST_ASSERT_EQUAL_HEX32(0x4FU, single);
    TEST_ASSERT_EQUAL_HEX32(0xFEU, cards);
    TEST_ASSERT_EQUAL_HEX32(0x7FU, axes);
}

void test_SWR_EVENT_003_each_repaired_chart_is_named_with_its_card_or_axis(void)
{
    rig_start_homed(&rig);
    damage_everything();
    rig_cycle(&rig);
    expect_all_charts_named();
}

/* For any value of the damaged copy, lost and absent among them. */
void test_SWR_LINK_003_a_damaged_link_is_a_lost_card(void)
{
    for (uint32_t state = 0U; state < 8U; state++) {
        rig_start_targeted(&rig);
        (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
        rig_link(&rig, 2U)->chart.state ^= (card_link_state_t)(state + 1U);
        rig_cycle(&rig);
        TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_CARD_LOST));
        TEST_ASSERT_EQUAL_UINT32(CARD_LINK_STATE_LOST, rig_link(&rig, 2U)->chart.state);
        TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_DISABLED, rig.outputs.snapshot.axes[2].power);
        TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_LOST, rig.outputs.snapshot.axes[2].reference);
        TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.has_target);
        TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
    }
}

/* One bit of one of the two charts. */
static void expect_aborted_once(uint32_t *word)
{
    rig_start_targeted(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_forget(&rig);
    *word ^= 2U;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.answer_count);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_ABORTED, rig.answers[0].kind);
    TEST_ASSERT_EQUAL_UINT32(ROBOT_AXIS_MAX, answer_axis(&rig.answers[0]));
    *word ^= 2U;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.answer_count);
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_EMERGENCY, rig.outputs.snapshot.workphase);
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
}

void test_SWR_CORE_004_a_damaged_workphase_or_order_aborts_what_was_armed_once(void)
{
    expect_aborted_once(&rig.controller.procedure.workphase.state_inverse);
    expect_aborted_once(&rig.controller.procedure.arming.state_inverse);
}

void test_SWR_EVENT_002_events_beyond_the_most_of_a_cycle_are_counted(void)
{
    rig_start_targeted(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    rig_press(&rig);
    for (uint32_t i = 0U; i < CONTROLLER_COMMANDS; i++) {
        rig.commands[i].kind = (uint32_t)COMMAND_WORKPHASE;
        rig.commands[i].as.workphase.workphase = (uint32_t)WORKPHASE_MOVE_TO_TARGET;
    }
    damage_everything();
    rig_box(&rig, "scanner on");
    rig_box(&rig, "estop pull");
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        rig.controller.axes[i].sealed.encoder.reading ^= 0x40000000;
        rig.controller.axes[i].sealed.encoder.jumps = 1U;
    }
    controller_seal(&rig.controller);
    rig.elapsed_us = 2000U;
    rig.command_count = CONTROLLER_COMMANDS;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(CONTROLLER_EVENTS, rig.outputs.event_count);
    TEST_ASSERT_GREATER_THAN_UINT32(0U, rig.outputs.snapshot.events_lost);
    TEST_ASSERT_EQUAL_UINT32(rig.outputs.snapshot.events,
                             rig.outputs.events[CONTROLLER_EVENTS - 1U].number + 1U);
}

void test_SWR_CORE_002_equal_inputs_give_equal_outputs(void)
{
    static rig_t twin;
    rig_start_targeted(&rig);
    twin = rig;
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    (void)rig_workphase(&twin, WORKPHASE_MOVE_TO_TARGET);
    rig_press(&rig);
    rig_press(&twin);
    for (uint32_t i = 0U; i < 2000U; i++) {
        rig_cycle(&rig);
        rig_cycle(&twin);
        TEST_ASSERT_EQUAL_MEMORY(&rig.outputs, &twin.outputs, sizeof rig.outputs);
    }
}

/* A cycle of the rig, and the same one into outputs that hold something else. */
static void expect_rewritten(void)
{
    static controller_t controller;
    static controller_outputs_t outputs;
    controller = rig.controller;
    (void)memset(&outputs, 0xA5, sizeof outputs);
    rig_cycle(&rig);
    controller_step(&controller, &rig.robot, &rig.inputs, &outputs);
    TEST_ASSERT_EQUAL_MEMORY(&rig.outputs, &outputs, sizeof outputs);
}

void test_SWR_CORE_002_outputs_do_not_depend_on_what_was_in_them(void)
{
    rig_start_moving(&rig);
    expect_rewritten();
    rig.robot.axes[0].home_ticks++;
    expect_rewritten();
    expect_rewritten();
}
