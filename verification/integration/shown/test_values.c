/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The numbers in reported events, and the limit that refuses, in the log of events, on the
 * simulated box.
 */
#include "unit/support/commands.h"
#include "integration/support/rig.h"

#include "unity.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"
#include "robot/robot_prostate.h"

#include <stdlib.h>
#include <string.h>

#define HALF_Q30 536870912
#define ONE_Q30 1073741824

static rig_t rig;

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

/* That of `subject`, which was noted once. */
static int32_t value_of(event_id_t id, uint32_t subject)
{
    const event_t *found = NULL;
    for (uint32_t i = 0U; i < rig.event_count; i++) {
        const event_t *event = &rig.events[i];
        if ((event->id == (uint32_t)id) && (event->subject == subject)) {
            TEST_ASSERT_NULL_MESSAGE(found, "noted twice");
            found = event;
        }
    }
    TEST_ASSERT_NOT_NULL_MESSAGE(found, "not noted");
    return found->value;
}

static void expect_place(plan_place_t first, int32_t x_nm, int32_t y_nm, int32_t z_nm)
{
    TEST_ASSERT_EQUAL_INT32(x_nm, value_of(EVENT_SENT_PLACE, (uint32_t)first));
    TEST_ASSERT_EQUAL_INT32(y_nm, value_of(EVENT_SENT_PLACE, (uint32_t)first + 1U));
    TEST_ASSERT_EQUAL_INT32(z_nm, value_of(EVENT_SENT_PLACE, (uint32_t)first + 2U));
}

static uint32_t send(command_kind_t kind, const rigid_t *pose)
{
    return rig_command(&rig, commands_of_pose(kind, *pose)).status;
}

void test_SWR_EVENT_020_an_accepted_registration_stands_in_the_log_with_its_numbers(void)
{
    rigid_t pose = {.rotation_q30 = {{0, -ONE_Q30, 0}, {ONE_Q30, 0, 0}, {0, 0, ONE_Q30}},
                    .translation = {1, -2000000, 3000000}};
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_CALIBRATION);
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send(COMMAND_REGISTRATION, &pose));
    expect_place(PLAN_PLACE_REGISTRATION_X, 1, -2000000, 3000000);
    TEST_ASSERT_EQUAL_INT32(0, value_of(EVENT_SENT_ROTATION, PLAN_ROTATION_REGISTRATION_XX));
    TEST_ASSERT_EQUAL_INT32(-1000000, value_of(EVENT_SENT_ROTATION, PLAN_ROTATION_REGISTRATION_XY));
    TEST_ASSERT_EQUAL_INT32(1000000, value_of(EVENT_SENT_ROTATION, PLAN_ROTATION_REGISTRATION_YX));
    TEST_ASSERT_EQUAL_INT32(1000000, value_of(EVENT_SENT_ROTATION, PLAN_ROTATION_REGISTRATION_ZZ));
    TEST_ASSERT_EQUAL_UINT32(9U, rig_count(&rig, EVENT_SENT_ROTATION));
}

void test_SWR_EVENT_020_a_refused_registration_stands_in_the_log_with_its_numbers(void)
{
    rigid_t pose = {.rotation_q30 = {{HALF_Q30, 0, 0}, {0, HALF_Q30, 0}, {0, 0, HALF_Q30}},
                    .translation = {7, 8, 9}};
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_CALIBRATION);
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NOT_RIGID, send(COMMAND_REGISTRATION, &pose));
    expect_place(PLAN_PLACE_REGISTRATION_X, 7, 8, 9);
    TEST_ASSERT_EQUAL_INT32(500000, value_of(EVENT_SENT_ROTATION, PLAN_ROTATION_REGISTRATION_YY));
    TEST_ASSERT_EQUAL_UINT32(EVENT_COMMAND_REFUSED, rig.events[0].id);
}

void test_SWR_EVENT_020_targets_and_entry_points_stand_in_the_log_with_their_numbers(void)
{
    const rigid_t target = rig_pose(5000000, 190000000, 60000000);
    const rigid_t entry = rig_pose(5000000, 240000000, 60000000);
    rig_start_targeted(&rig);
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send(COMMAND_TARGET, &target));
    expect_place(PLAN_PLACE_TARGET_X, 5000000, 190000000, 60000000);
    TEST_ASSERT_EQUAL_INT32(fixed_multiply_q30(1000000, target.rotation_q30[2][1]),
                            value_of(EVENT_SENT_ROTATION, PLAN_ROTATION_TARGET_ZY));
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send(COMMAND_ENTRY, &entry));
    expect_place(PLAN_PLACE_ENTRY_X, 5000000, 240000000, 60000000);
}

void test_SWR_EVENT_020_an_accepted_proposal_of_an_entry_point_stands_there_with_its_numbers(void)
{
    const rigid_t entry = rig_pose(5000000, 240000000, 60000000);
    rig_start_targeted(&rig);
    rig_forget(&rig);
    TEST_ASSERT_NOT_EQUAL_UINT32(STATUS_OK, send(COMMAND_ACCEPT_ENTRY, &entry));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_SENT_PLACE));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send(COMMAND_PROPOSE_ENTRY, &entry));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send(COMMAND_ACCEPT_ENTRY, &entry));
    expect_place(PLAN_PLACE_ENTRY_X, 5000000, 240000000, 60000000);
}

void test_SWR_EVENT_020_a_refused_proposal_of_an_entry_point_stands_there_with_its_numbers(void)
{
    const rigid_t entry = rig_pose(5000000, 240000000, 60000000);
    rig_start_targeted(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, send(COMMAND_PROPOSE_ENTRY, &entry));
    (void)rig_workphase(&rig, WORKPHASE_PLANNING);
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_WRONG_WORKPHASE, send(COMMAND_ACCEPT_ENTRY, &entry));
    expect_place(PLAN_PLACE_ENTRY_X, 5000000, 240000000, 60000000);
}

void test_SWR_EVENT_020_refused_lengths_stand_in_the_log(void)
{
    const int32_t negative_nm[] = {-1, 6000000, 7000000, 46000000};
    command_t command = {.kind = (uint32_t)COMMAND_PROBE,
                         .as.probe = {.count = ROBOT_PROBE_LENGTHS}};
    (void)memcpy(command.as.probe.lengths_nm, negative_nm, sizeof negative_nm);
    rig_start_homed(&rig);
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_PROBE_LENGTH, rig_command(&rig, command).status);
    TEST_ASSERT_EQUAL_INT32(-1, value_of(EVENT_REFUSED_LENGTH, 0U));
    TEST_ASSERT_EQUAL_INT32(46000000, value_of(EVENT_REFUSED_LENGTH, 3U));
    rig_cycles(&rig, LIMIT_REFUSED_VALUES_MS);
    rig_forget(&rig);
    command.as.probe.count = ROBOT_PROBE_LENGTHS + 1U;
    TEST_ASSERT_EQUAL_UINT32(STATUS_PROBE_LENGTH, rig_command(&rig, command).status);
    TEST_ASSERT_EQUAL_UINT32(ROBOT_PROBE_LENGTHS, rig_count(&rig, EVENT_REFUSED_LENGTH));
    command.as.probe.lengths_nm[0] = 12000000;
    command.as.probe.count = ROBOT_PROBE_LENGTHS;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, command).status);
    TEST_ASSERT_EQUAL_UINT32(ROBOT_PROBE_LENGTHS, rig_count(&rig, EVENT_PROBE_LENGTH));
}

void test_SWR_EVENT_020_of_a_flood_of_refused_ones_some_are_noted(void)
{
    rigid_t pose = rig_pose(0, 0, 0);
    rig_start_homed(&rig);
    rig_forget(&rig);
    for (uint32_t i = 0U; i < 5U; i++) {
        TEST_ASSERT_EQUAL_UINT32(STATUS_WRONG_WORKPHASE, send(COMMAND_ENTRY, &pose));
    }
    TEST_ASSERT_EQUAL_UINT32(5U, rig_count(&rig, EVENT_COMMAND_REFUSED));
    TEST_ASSERT_EQUAL_UINT32(3U, rig_count(&rig, EVENT_SENT_PLACE));
    rig_cycles(&rig, LIMIT_REFUSED_VALUES_MS);
    TEST_ASSERT_EQUAL_UINT32(STATUS_WRONG_WORKPHASE, send(COMMAND_ENTRY, &pose));
    TEST_ASSERT_EQUAL_UINT32(6U, rig_count(&rig, EVENT_SENT_PLACE));
}

void test_SWR_EVENT_020_in_the_first_cycle_they_are_noted_too(void)
{
    rigid_t pose = rig_pose(1, 2, 3);
    rig_start(&rig);
    TEST_ASSERT_NOT_EQUAL_UINT32(STATUS_OK, send(COMMAND_ENTRY, &pose));
    TEST_ASSERT_EQUAL_UINT32(3U, rig_count(&rig, EVENT_SENT_PLACE));
}

static void jog_too_far(int32_t ticks)
{
    const command_t jog = {.kind = (uint32_t)COMMAND_JOG,
                           .as.jog = {.axis = NEURO_AXIS_YAW, .to_ticks = ticks}};
    rig_cycles(&rig, LIMIT_REFUSED_VALUES_MS);
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_AXIS_LIMIT, rig_command(&rig, jog).status);
}

/* Refused by a limit that axes share; `id` says which end. */
static void expect_shared(uint32_t axis, int32_t ticks, event_id_t id, int32_t value)
{
    const command_t jog = {.kind = (uint32_t)COMMAND_JOG,
                           .as.jog = {.axis = axis, .to_ticks = ticks}};
    rig_cycles(&rig, LIMIT_REFUSED_VALUES_MS);
    rig_forget(&rig);
    const uint32_t status = rig_command(&rig, jog).status;
    TEST_ASSERT_INT32_WITHIN(1, value, value_of(id, status));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_SHARED_LOWER_LIMIT) +
                                     rig_count(&rig, EVENT_SHARED_UPPER_LIMIT) +
                                     rig_count(&rig, EVENT_SHARED_LOWER_ANGLE) +
                                     rig_count(&rig, EVENT_SHARED_UPPER_ANGLE));
}

void test_SWR_EVENT_033_the_shared_limit_that_refuses_stands_in_the_log(void)
{
    const coupled_limit_t *const separation = &robot_neuro.coupled_limits[0];
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    expect_shared(NEURO_AXIS_HEAD, -11418, EVENT_SHARED_LOWER_LIMIT, separation->minimum);
    expect_shared(NEURO_AXIS_FEET, -5000, EVENT_SHARED_UPPER_LIMIT, separation->maximum);
}

/* The end that refuses when this carriage goes far away from the other one of its pair. */
static int32_t angle_of(uint32_t axis)
{
    const command_t jog = {.kind = (uint32_t)COMMAND_JOG,
                           .as.jog = {.axis = axis, .to_ticks = 120000}};
    rig_cycles(&rig, LIMIT_REFUSED_VALUES_MS);
    rig_forget(&rig);
    const answer_t refused = rig_command(&rig, jog);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_SHARED_LOWER_LIMIT) +
                                     rig_count(&rig, EVENT_SHARED_UPPER_LIMIT));
    return value_of((answer_as_shared_limit(&refused)->is_maximum != 0U) ? EVENT_SHARED_UPPER_ANGLE
                                                                         : EVENT_SHARED_LOWER_ANGLE,
                    refused.status);
}

void test_SWR_EVENT_033_an_angle_is_reported_in_millionths_of_a_degree(void)
{
    rig_start_robot_homed(&rig, rig_short_prostate());
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    const int32_t front = angle_of(PROSTATE_AXIS_FRONT_LEFT);
    TEST_ASSERT_INT32_WITHIN(1, 10000000, abs(front));
    TEST_ASSERT_INT32_WITHIN(1, -front, angle_of(PROSTATE_AXIS_REAR_LEFT));
}

void test_SWR_EVENT_021_the_limit_that_refuses_stands_in_the_log(void)
{
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    jog_too_far(1000000);
    TEST_ASSERT_EQUAL_INT32(robot_neuro.axes[NEURO_AXIS_YAW].maximum_ticks,
                            value_of(EVENT_UPPER_LIMIT, NEURO_AXIS_YAW));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_LOWER_LIMIT));
    jog_too_far(-1000000);
    TEST_ASSERT_EQUAL_INT32(robot_neuro.axes[NEURO_AXIS_YAW].minimum_ticks,
                            value_of(EVENT_LOWER_LIMIT, NEURO_AXIS_YAW));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_UPPER_LIMIT));
}
