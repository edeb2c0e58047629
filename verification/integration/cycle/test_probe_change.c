/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Another probe while the programs run, and from whom a registration is and what counts of it, on
 * the simulated box.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "base/fixed.h"
#include "robot/kinematics.h"
#include "robot/robot_bench2.h"
#include "robot/robot_neuro.h"

#include <string.h>

static rig_t rig;

/* 5 mm longer from the robot to the treatment point than that of the robot's file. */
static const int32_t longer_nm[] = {12000000, 6000000, 7000000, 46000000};

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static command_t probe_of(const int32_t length_nm[ROBOT_PROBE_LENGTHS])
{
    command_t command = {.kind = (uint32_t)COMMAND_PROBE,
                         .as.probe = {.count = ROBOT_PROBE_LENGTHS}};
    (void)memcpy(command.as.probe.lengths_nm, length_nm, ROBOT_PROBE_LENGTHS * sizeof length_nm[0]);
    return command;
}

static uint32_t send(const int32_t length_nm[ROBOT_PROBE_LENGTHS])
{
    return rig_command(&rig, probe_of(length_nm)).status;
}

static void expect_first_probe(void)
{
    TEST_ASSERT_EQUAL_INT32_ARRAY(robot_neuro.probe.length_nm, rig.outputs.snapshot.probe_nm,
                                  ROBOT_PROBE_LENGTHS);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_PROBE_TAKEN));
}

void test_SWR_PROBE_003_the_robot_starts_with_the_probe_of_its_file(void)
{
    rig_start(&rig);
    rig_cycle(&rig);
    expect_first_probe();
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_probe);
}

void test_SWR_PROBE_003_another_probe_moves_the_pose_by_what_it_is_longer(void)
{
    rig_start_targeted(&rig);
    const rigid_t before = rig.outputs.snapshot.scanner_treatment;
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send(longer_nm));
    const snapshot_t *const shown = &rig.outputs.snapshot;
    TEST_ASSERT_EQUAL_INT32_ARRAY(longer_nm, shown->probe_nm, ROBOT_PROBE_LENGTHS);
    const int32_t moved_nm[] = {shown->scanner_treatment.translation.x_nm - before.translation.x_nm,
                                shown->scanner_treatment.translation.y_nm - before.translation.y_nm,
                                shown->scanner_treatment.translation.z_nm -
                                    before.translation.z_nm};
    for (uint32_t i = 0U; i < 3U; i++) {
        TEST_ASSERT_INT32_WITHIN(10, fixed_multiply_q30(5000000, before.rotation_q30[i][2]),
                                 moved_nm[i]);
    }
    TEST_ASSERT_EQUAL_MEMORY(before.rotation_q30, shown->scanner_treatment.rotation_q30,
                             sizeof before.rotation_q30);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_PROBE_TAKEN));
    TEST_ASSERT_EQUAL_UINT32(ROBOT_PROBE_LENGTHS, rig_count(&rig, EVENT_PROBE_LENGTH));
    TEST_ASSERT_EQUAL_INT32(longer_nm[3], rig.events[rig.event_count - 1U].value);
}

void test_SWR_PROBE_003_target_and_entry_are_forgotten_and_the_registration_stands(void)
{
    const command_t entry = {.kind = (uint32_t)COMMAND_ENTRY,
                             .as.pose = {.pose = rig_pose(5000000, 240000000, 60000000)}};
    rig_start_targeted(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, entry).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send(longer_nm));
    const snapshot_t *const shown = &rig.outputs.snapshot;
    TEST_ASSERT_EQUAL_UINT32(1U, shown->is_registered);
    TEST_ASSERT_EQUAL_UINT32(0U, shown->has_target | shown->has_entry);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_TARGET,
                             rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
}

/* The same place with a longer probe is reached with the robot that much farther back. */
void test_SWR_PROBE_003_a_target_is_reached_by_the_treatment_point_of_the_present_probe(void)
{
    const rigid_t target = rig_pose(5000000, 190000000, 60000000);
    rig_start_targeted(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send(longer_nm));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &target).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 60000U).kind);
    int32_t ticks[ROBOT_AXIS_MAX] = {0};
    joints_t joints;
    rigid_t reached;
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        ticks[i] = rig_position(&rig, i);
    }
    joints_from_ticks(&robot_neuro, ticks, &joints);
    kinematics_forward(&robot_neuro, &(probe_t){{12000000, 6000000, 7000000, 46000000}}, &joints,
                       &reached);
    TEST_ASSERT_INT32_WITHIN(50000, target.translation.y_nm, reached.translation.y_nm);
    kinematics_forward(&robot_neuro, &robot_neuro.probe, &joints, &reached);
    TEST_ASSERT_INT32_WITHIN(50000, target.translation.y_nm + 5000000, reached.translation.y_nm);
}

void test_SWR_PROBE_002_wrong_lengths_are_refused_whole(void)
{
    const int32_t negative[] = {-1, 6000000, 7000000, 46000000};
    const int32_t deeper[] = {12000000, 46000001, 7000000, 46000000};
    command_t few = probe_of(longer_nm);
    rig_start_homed(&rig);
    rig_forget(&rig);
    few.as.probe.count = ROBOT_PROBE_LENGTHS - 1U;
    TEST_ASSERT_EQUAL_UINT32(STATUS_PROBE_LENGTH, rig_command(&rig, few).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_PROBE_LENGTH, send(negative));
    TEST_ASSERT_EQUAL_UINT32(STATUS_PROBE_ORDER, send(deeper));
    expect_first_probe();
    TEST_ASSERT_EQUAL_UINT32(3U, rig_count(&rig, EVENT_COMMAND_REFUSED));
}

/* So that it, too, can go on after damage. */
void test_SWR_PROBE_002_a_robot_without_lengths_takes_a_probe_without_any(void)
{
    command_t command = {.kind = (uint32_t)COMMAND_PROBE};
    rig_start_robot_homed(&rig, &robot_bench2);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, command).status);
    command.as.probe.count = 1U;
    TEST_ASSERT_EQUAL_UINT32(STATUS_PROBE_LENGTH, rig_command(&rig, command).status);
    command.as.probe.count = 0U;
    command.as.probe.lengths_nm[0] = 1;
    TEST_ASSERT_EQUAL_UINT32(STATUS_PROBE_LENGTH, rig_command(&rig, command).status);
}

void test_SWR_PROBE_004_no_probe_is_taken_where_the_needle_is_not_known_to_be_out(void)
{
    rig_start(&rig);
    rig_cycles(&rig, 20U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NEEDLE_IN, send(longer_nm));
    expect_first_probe();
}

void test_SWR_PROBE_004_no_probe_is_taken_while_something_is_armed(void)
{
    const command_t jog = {.kind = (uint32_t)COMMAND_JOG,
                           .as.jog = {.axis = NEURO_AXIS_YAW, .to_ticks = -200}};
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_AT_REST, send(longer_nm));
    expect_first_probe();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_STOP).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send(longer_nm));
}

void test_SWR_PROBE_004_no_probe_is_taken_in_move_to_target(void)
{
    rig_start_targeted(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET);
    TEST_ASSERT_EQUAL_UINT32(STATUS_WRONG_WORKPHASE, send(longer_nm));
    expect_first_probe();
}

/* Events of memory that name `part`. */
static uint32_t count_memory(event_memory_t part)
{
    uint32_t count = 0U;
    for (uint32_t i = 0U; i < rig.event_count; i++) {
        if ((rig.events[i].id == (uint32_t)EVENT_MEMORY_DAMAGED) &&
            (rig.events[i].subject == (uint32_t)part)) {
            count++;
        }
    }
    return count;
}

void test_SWR_PROBE_005_a_damaged_probe_is_forgotten_with_the_plan_and_not_guessed(void)
{
    const rigid_t target = rig_pose(5000000, 190000000, 60000000);
    rigid_t identity;
    rigid_set_identity(&identity);
    rig_start_targeted(&rig);
    rig_forget(&rig);
    rig.controller.plan.probe.length_nm[NEURO_PROBE_ROBOT_TO_TREATMENT] ^= 0x10000;
    rig_cycle(&rig);
    const snapshot_t *const shown = &rig.outputs.snapshot;
    TEST_ASSERT_EQUAL_UINT32(1U, count_memory(EVENT_MEMORY_PLAN));
    TEST_ASSERT_EQUAL_UINT32(1U, count_memory(EVENT_MEMORY_PROBE));
    TEST_ASSERT_EQUAL_UINT32(0U, shown->has_probe | shown->is_registered | shown->has_target);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_PROBE, shown->pose_status);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_PROBE, shown->next_step);
    rig_register(&rig, &identity);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_PROBE, rig_target(&rig, &target).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_PROBE, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send(longer_nm));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, shown->pose_status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &target).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
}

void test_SWR_PROBE_005_without_a_probe_nothing_that_is_proposed_is_called_reachable(void)
{
    const command_t entry = {.kind = (uint32_t)COMMAND_PROPOSE_ENTRY,
                             .as.seen_pose = {.pose = rig_pose(0, 246000000, 50000000)}};
    const command_t target = {.kind = (uint32_t)COMMAND_PROPOSE_TARGET,
                              .as.seen_pose = {.pose = rig_pose(0, 200000000, 50000000)}};
    for (uint32_t has_probe = 0U; has_probe <= 1U; has_probe++) {
        rig_start_targeted(&rig);
        rig.controller.plan.has_probe = has_probe;
        plan_seal(&rig.controller.plan);
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, entry).status);
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, target).status);
        TEST_ASSERT_EQUAL_UINT32(has_probe, rig.outputs.snapshot.is_proposal_reachable);
    }
}

void test_SWR_PROBE_005_a_probe_that_its_checksum_proves_outlives_damage_of_the_plan(void)
{
    rig_start_targeted(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send(longer_nm));
    rig_forget(&rig);
    rig.controller.plan.scanner_zframe.translation.x_nm ^= 0x10000;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, count_memory(EVENT_MEMORY_PLAN));
    TEST_ASSERT_EQUAL_UINT32(0U, count_memory(EVENT_MEMORY_PROBE));
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.is_registered);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.has_probe);
    TEST_ASSERT_EQUAL_INT32_ARRAY(longer_nm, rig.outputs.snapshot.probe_nm, ROBOT_PROBE_LENGTHS);
}

/* A turn by 90 degrees about z, 7 mm along x. */
static command_t turned(uint32_t use)
{
    command_t command = {.kind = (uint32_t)COMMAND_REGISTRATION, .as.registration = {.use = use}};
    rigid_set_identity(&command.as.registration.pose);
    command.as.registration.pose.rotation_q30[0][0] = 0;
    command.as.registration.pose.rotation_q30[0][1] = -FIXED_ONE_Q30;
    command.as.registration.pose.rotation_q30[1][0] = FIXED_ONE_Q30;
    command.as.registration.pose.rotation_q30[1][1] = 0;
    command.as.registration.pose.translation.x_nm = 7000000;
    return command;
}

void test_SWR_PLAN_023_a_rotation_is_ignored_on_request_alone_and_this_is_shown_and_noted(void)
{
    rigid_t moved;
    rigid_set_identity(&moved);
    moved.translation.x_nm = 7000000;
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_CALIBRATION);
    const snapshot_t *const shown = &rig.outputs.snapshot;
    const command_t whole = turned(REGISTRATION_WHOLE);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, whole).status);
    TEST_ASSERT_EQUAL_MEMORY(&whole.as.registration.pose, &shown->scanner_zframe, sizeof moved);
    TEST_ASSERT_EQUAL_UINT32(0U, shown->is_rotation_ignored);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_ROTATION_IGNORED));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, turned(REGISTRATION_TRANSLATION)).status);
    TEST_ASSERT_EQUAL_MEMORY(&moved, &shown->scanner_zframe, sizeof moved);
    TEST_ASSERT_EQUAL_UINT32(1U, shown->is_rotation_ignored);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ROTATION_IGNORED));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, whole).status);
    TEST_ASSERT_EQUAL_UINT32(0U, shown->is_rotation_ignored);
}

void test_SWR_PLAN_023_a_use_that_nobody_knows_and_a_matrix_that_is_not_rigid_are_refused(void)
{
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_CALIBRATION);
    TEST_ASSERT_EQUAL_UINT32(STATUS_UNKNOWN_COMMAND,
                             rig_command(&rig, turned(REGISTRATION_USE_COUNT)).status);
    command_t bent = turned(REGISTRATION_TRANSLATION);
    bent.as.registration.pose.rotation_q30[0][0] = FIXED_ONE_Q30;
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_RIGID, rig_command(&rig, bent).status);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.is_registered);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_ROTATION_IGNORED));
}

void test_SWR_PLAN_022_a_registration_is_shown_with_its_sender_and_its_cycle(void)
{
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_CALIBRATION);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, turned(REGISTRATION_WHOLE)).status);
    const snapshot_t *const shown = &rig.outputs.snapshot;
    uint32_t at = 0U;
    while ((at < rig.event_count) && (rig.events[at].id != (uint32_t)EVENT_REGISTERED)) {
        at++;
    }
    TEST_ASSERT_LESS_THAN_UINT32(rig.event_count, at);
    const event_t *const reported = &rig.events[at];
    TEST_ASSERT_EQUAL_UINT32(reported->cycle, shown->registered_cycle);
    TEST_ASSERT_EQUAL_UINT32(reported->peer, shown->registered_peer);
    TEST_ASSERT_EQUAL_UINT32((reported->cause == (uint32_t)EVENT_CAUSE_CONSOLE)
                                 ? COMMAND_SOURCE_HTTP
                                 : COMMAND_SOURCE_IGTL,
                             shown->registered_source);
    TEST_ASSERT_NOT_EQUAL_UINT32(0U, shown->registered_peer);
}
