/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the table says where each mode runs, from which command, and what is special
 * about it.
 */
#include "unity.h"

#include "interface/command.h"
#include "interface/mode_list.h"
#include "mode/leg/leg.h"
#include "mode/mode.h"
#include "robot/robot_neuro.h"
#include "unit/support/mode_world.h"

#include "unit/mode/armed_mode_world.inc"

void setUp(void)
{
    world_start();
    mode = (mode_state_t){.sealed.kind = MODE_NONE};
}

void tearDown(void)
{
}

/* A letter for each mode that runs in a workphase; a small one has a command of its own. */
void test_SWR_PHASE_001_each_mode_has_its_workphase(void)
{
    static const char *const runs[WORKPHASE_COUNT] = {
        [WORKPHASE_UNDEFINED] = "..............", [WORKPHASE_START_UP] = ".H..r.........",
        [WORKPHASE_PLANNING] = "....r.........",  [WORKPHASE_CALIBRATION] = "....r.........",
        [WORKPHASE_TARGETING] = "....r...l.....", [WORKPHASE_MOVE_TO_TARGET] = "..M.r....i.g.c",
        [WORKPHASE_MANUAL] = "...jratv..p.s.",    [WORKPHASE_STOP] = "....r.........",
        [WORKPHASE_EMERGENCY] = "....r.........",
    };
    for (uint32_t i = 0U; i < WORKPHASE_COUNT; i++) {
        mode_kind_t own = MODE_NONE;
        for (uint32_t kind = 0U; kind < MODE_KIND_COUNT; kind++) {
            mode_begin(&mode, (mode_kind_t)kind, &request);
            TEST_ASSERT_EQUAL((runs[i][kind] != '.') ? kind : (uint32_t)MODE_NONE,
                              mode_in(&mode, (workphase_t)i));
            own = ((runs[i][kind] >= 'A') && (runs[i][kind] <= 'Z')) ? (mode_kind_t)kind : own;
        }
        TEST_ASSERT_EQUAL(own, mode_of((workphase_t)i));
    }
}

void test_SWR_MODE_001_each_mode_is_armed_by_its_command(void)
{
    static const mode_kind_t armed[COMMAND_KIND_COUNT] = {[COMMAND_JOG] = MODE_JOG,
                                                          [COMMAND_JOG_BY] = MODE_JOG,
                                                          [COMMAND_RETRACT] = MODE_RETRACT,
                                                          [COMMAND_HOME_AXIS] = MODE_HOME_AXIS,
                                                          [COMMAND_RUN_TRAJECTORY] =
                                                              MODE_TRAJECTORY,
                                                          [COMMAND_VELOCITY] = MODE_VELOCITY,
                                                          [COMMAND_ALIGN] = MODE_ALIGN,
                                                          [COMMAND_INSERT] = MODE_INSERT,
                                                          [COMMAND_POSE] = MODE_POSE,
                                                          [COMMAND_RUN_PROGRAM] = MODE_PROGRAM,
                                                          [COMMAND_SWEEP] = MODE_SWEEP,
                                                          [COMMAND_COOPERATE] = MODE_COOPERATE};
    for (uint32_t i = 0U; i < COMMAND_KIND_COUNT; i++) {
        TEST_ASSERT_EQUAL(armed[i], mode_of_command(i));
    }
    TEST_ASSERT_EQUAL(MODE_NONE, mode_of_command(UINT32_MAX));
    TEST_ASSERT_FALSE(mode_runs_in(MODE_JOG, WORKPHASE_COUNT));
    TEST_ASSERT_EQUAL(MODE_NONE, mode_of((workphase_t)WORKPHASE_COUNT));
}

static mode_request_t ask(mode_kind_t kind, const command_t *command)
{
    const mode_asked_t asked = {
        .command = command, .robot = &robot, .axes = axes, .list = &mode.sealed.list, .rows = NULL};
    return mode_ask(kind, &asked);
}

void test_SWR_MODE_001_a_mode_makes_its_request_of_what_its_command_says(void)
{
    const command_t jog = {.kind = COMMAND_JOG, .as.jog = {NEURO_AXIS_HEAD, -70}};
    const command_t sweep = {.kind = COMMAND_SWEEP, .as.sweep = {NEURO_AXIS_PITCH, 1U}};
    const command_t home = {.kind = COMMAND_HOME_AXIS, .as.axis = {NEURO_AXIS_YAW}};
    command_t velocity = {.kind = COMMAND_VELOCITY};
    velocity.as.velocity.axes = 5U;
    velocity.as.velocity.time_ms = 300U;
    velocity.as.velocity.speeds_ticks_per_s[2] = -9;
    mode_request_t made = ask(MODE_JOG, &jog);
    TEST_ASSERT_EQUAL_HEX32(LEG_AXIS(NEURO_AXIS_HEAD), made.sealed.axes);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_HEAD, made.sealed.way.axis);
    TEST_ASSERT_EQUAL_INT32(-70, made.sealed.way.end_ticks);
    made = ask(MODE_SWEEP, &sweep);
    TEST_ASSERT_EQUAL_HEX32(LEG_AXIS(NEURO_AXIS_PITCH), made.sealed.axes);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_PITCH, made.sealed.way.axis);
    TEST_ASSERT_EQUAL_UINT32(1U, made.own.sweep.is_free);
    made = ask(MODE_HOME_AXIS, &home);
    TEST_ASSERT_EQUAL_HEX32(LEG_AXIS(NEURO_AXIS_YAW), made.sealed.axes);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_YAW, made.sealed.way.axis);
    made = ask(MODE_VELOCITY, &velocity);
    TEST_ASSERT_EQUAL_HEX32(5U, made.sealed.axes);
    TEST_ASSERT_EQUAL_UINT32(300U, made.own.velocity.time_ms);
    TEST_ASSERT_EQUAL_INT32(-9, made.own.velocity.speeds_ticks_per_s[2]);
}

void test_SWR_MODE_007_a_way_is_from_where_the_axis_stands_and_none_of_an_axis_that_there_is_not(
    void)
{
    command_t command = {.kind = COMMAND_JOG_BY, .as.jog_by = {NEURO_AXIS_HEAD, -70}};
    world_put(NEURO_AXIS_HEAD, 100);
    TEST_ASSERT_EQUAL_INT32(30, ask(MODE_JOG, &command).sealed.way.end_ticks);
    command.as.jog_by.by_ticks = INT32_MAX;
    TEST_ASSERT_EQUAL_INT32(INT32_MAX, ask(MODE_JOG, &command).sealed.way.end_ticks);
    command.as.jog_by.axis = robot.axis_count;
    TEST_ASSERT_EQUAL_INT32(0, ask(MODE_JOG, &command).sealed.way.end_ticks);
    command.as.jog_by.axis = ROBOT_AXIS_MAX;
    TEST_ASSERT_EQUAL_HEX32(0U, ask(MODE_JOG, &command).sealed.axes);
}

void test_SWR_MODE_002_a_mode_needs_all_axes_the_commanded_ones_or_that_of_the_needle(void)
{
    const uint32_t two = LEG_AXIS(NEURO_AXIS_HEAD) | LEG_AXIS(NEURO_AXIS_PITCH);
    TEST_ASSERT_EQUAL_HEX32(LEG_EVERY_AXIS, mode_axes(MODE_HOMING, two, &robot));
    TEST_ASSERT_EQUAL_HEX32(LEG_EVERY_AXIS, mode_axes(MODE_MOVE, two, &robot));
    TEST_ASSERT_EQUAL_HEX32(two, mode_axes(MODE_JOG, two, &robot));
    TEST_ASSERT_EQUAL_HEX32(two, mode_axes(MODE_VELOCITY, two, &robot));
    TEST_ASSERT_EQUAL_HEX32(two, mode_axes(MODE_HOME_AXIS, two, &robot));
    TEST_ASSERT_EQUAL_HEX32(LEG_AXIS(NEURO_AXIS_INSERTION), mode_axes(MODE_RETRACT, two, &robot));
    begin(MODE_JOG, WORKPHASE_MANUAL);
    TEST_ASSERT_TRUE(mode_needs(&mode, NEURO_AXIS_YAW));
    TEST_ASSERT_FALSE(mode_needs(&mode, NEURO_AXIS_HEAD));
}

void test_SWR_MEMORY_006_a_mode_that_there_is_not_is_none(void)
{
    mode.sealed.kind = MODE_KIND_COUNT;
    TEST_ASSERT_EQUAL(MODE_NONE, mode_in(&mode, WORKPHASE_MANUAL));
    mode.sealed.kind = UINT32_MAX;
    TEST_ASSERT_EQUAL(MODE_NONE, mode_in(&mode, WORKPHASE_MANUAL));
}

void test_SWR_AXIS_006_a_move_needs_its_axes_homed(void)
{
    TEST_ASSERT_TRUE(mode_may_be_unhomed(MODE_RETRACT));
    TEST_ASSERT_TRUE(mode_may_be_unhomed(MODE_HOMING));
    TEST_ASSERT_TRUE(mode_may_be_unhomed(MODE_JOG));
    TEST_ASSERT_TRUE(mode_may_be_unhomed(MODE_HOME_AXIS));
    TEST_ASSERT_TRUE(mode_may_be_unhomed(MODE_NONE));
    TEST_ASSERT_FALSE(mode_may_be_unhomed(MODE_MOVE));
    TEST_ASSERT_FALSE(mode_may_be_unhomed(MODE_TRAJECTORY));
    TEST_ASSERT_FALSE(mode_may_be_unhomed(MODE_ALIGN));
    TEST_ASSERT_FALSE(mode_may_be_unhomed(MODE_INSERT));
    TEST_ASSERT_FALSE(mode_may_be_unhomed(MODE_POSE));
    TEST_ASSERT_FALSE(mode_may_be_unhomed(MODE_SWEEP));
}

void test_SWR_ALIGN_001_a_mode_ends_at_its_place_at_the_target(void)
{
    TEST_ASSERT_EQUAL(MODE_AIM_LINE, mode_aim_of((uint32_t)MODE_ALIGN));
    TEST_ASSERT_EQUAL(MODE_AIM_DEPTH, mode_aim_of((uint32_t)MODE_COOPERATE));
    TEST_ASSERT_EQUAL(MODE_AIM_STEPS, mode_aim_of((uint32_t)MODE_PROGRAM));
    TEST_ASSERT_EQUAL(MODE_AIM_NONE, mode_aim_of((uint32_t)MODE_JOG));
    TEST_ASSERT_EQUAL(MODE_AIM_NONE, mode_aim_of((uint32_t)MODE_KIND_COUNT));
}

void test_SWR_COOP_008_a_hand_moves_the_needle_in_one_mode_alone(void)
{
    for (uint32_t kind = 0U; kind < MODE_KIND_COUNT; kind++) {
        TEST_ASSERT_EQUAL(kind == (uint32_t)MODE_COOPERATE, mode_is_by_hand((mode_kind_t)kind));
    }
}

void test_SWR_VIB_703_the_hand_is_wanted_off_in_that_mode_alone(void)
{
    mode.request.own.cooperate.stage = (uint32_t)COOPERATE_ENDED;
    for (uint32_t kind = 0U; kind < MODE_KIND_COUNT; kind++) {
        TEST_ASSERT_EQUAL_INT(kind == (uint32_t)MODE_COOPERATE,
                              mode_wants_hand_off(&mode, (mode_kind_t)kind));
    }
}

/* Its parameters lie where another mode has its own. */
void test_SWR_VIB_705_the_needle_vibrates_in_that_mode_alone(void)
{
    mode.request.own.cooperate.stage = (uint32_t)COOPERATE_VIBRATES;
    for (uint32_t kind = 0U; kind < MODE_KIND_COUNT; kind++) {
        TEST_ASSERT_EQUAL_INT(kind == (uint32_t)MODE_COOPERATE,
                              mode_is_vibrating(&mode, (mode_kind_t)kind));
        TEST_ASSERT_FALSE(mode_wants_hand_off(&mode, (mode_kind_t)kind));
    }
}

void test_SWR_JOG_001_the_jogged_axis_heeds_the_needle(void)
{
    mode_begin(&mode, MODE_JOG, &request);
    TEST_ASSERT_TRUE(heeds(MODE_JOG, NEURO_AXIS_YAW, true));
    TEST_ASSERT_TRUE(heeds(MODE_JOG, NEURO_AXIS_YAW, false));
    TEST_ASSERT_FALSE(heeds(MODE_JOG, NEURO_AXIS_LATERAL, true));
}

void test_SWR_JOG_016_whatever_homes_across_the_needle_heeds_it(void)
{
    TEST_ASSERT_TRUE(heeds(MODE_HOMING, NEURO_AXIS_LATERAL, true));
    TEST_ASSERT_FALSE(heeds(MODE_HOMING, NEURO_AXIS_LATERAL, false));
    TEST_ASSERT_FALSE(heeds(MODE_HOMING, NEURO_AXIS_INSERTION, true));
    TEST_ASSERT_TRUE(heeds(MODE_HOME_AXIS, NEURO_AXIS_LATERAL, true));
    TEST_ASSERT_FALSE(heeds(MODE_HOME_AXIS, NEURO_AXIS_INSERTION, true));
    TEST_ASSERT_FALSE(heeds(MODE_HOMING, NEURO_AXIS_ROTATION, true));
}

void test_SWR_JOG_001_a_move_takes_the_needle_out_itself(void)
{
    TEST_ASSERT_FALSE(heeds(MODE_MOVE, NEURO_AXIS_LATERAL, true));
    TEST_ASSERT_FALSE(heeds(MODE_NONE, NEURO_AXIS_LATERAL, true));
}

/* So nothing drives it deeper from an unknown place, whatever the mode says. */
void test_SWR_JOG_003_a_needle_that_is_drawn_out_heeds_itself(void)
{
    const mode_request_t needle = {.sealed.axes = mode_axes(MODE_RETRACT, 0U, &robot)};
    mode_begin(&mode, MODE_RETRACT, &needle);
    TEST_ASSERT_TRUE(heeds(MODE_RETRACT, NEURO_AXIS_INSERTION, true));
    TEST_ASSERT_FALSE(heeds(MODE_RETRACT, NEURO_AXIS_LATERAL, true));
}

void test_SWR_JOG_002_a_motion_of_one_axis_is_judged_before_it_is_armed_and_nothing_else_is(void)
{
    const mode_request_t no_axis = {.sealed.way = {.axis = 9U, .end_ticks = 0}};
    TEST_ASSERT_EQUAL(STATUS_UNKNOWN_COMMAND, mode_judge(MODE_JOG, &no_axis, &robot, axes).status);
    TEST_ASSERT_EQUAL(STATUS_UNKNOWN_COMMAND,
                      mode_judge(MODE_HOME_AXIS, &no_axis, &robot, axes).status);
    TEST_ASSERT_EQUAL(STATUS_OK, mode_judge(MODE_HOME_AXIS, &request, &robot, axes).status);
    TEST_ASSERT_EQUAL(STATUS_OK, mode_judge(MODE_HOMING, &no_axis, &robot, axes).status);
    TEST_ASSERT_EQUAL(STATUS_OK, mode_judge(MODE_MOVE, &no_axis, &robot, axes).status);
}

void test_SWR_ALIGN_004_an_insertion_and_a_pose_are_judged_before_they_are_armed(void)
{
    TEST_ASSERT_EQUAL(STATUS_OK, mode_judge(MODE_ALIGN, &request, &robot, axes).status);
    TEST_ASSERT_EQUAL(STATUS_NOT_ALIGNED, mode_judge(MODE_INSERT, &request, &robot, axes).status);
    TEST_ASSERT_EQUAL(STATUS_OK, mode_judge(MODE_POSE, &request, &robot, axes).status);
    world_put(NEURO_AXIS_INSERTION, 30000);
    TEST_ASSERT_EQUAL(STATUS_NEEDLE_IN, mode_judge(MODE_POSE, &request, &robot, axes).status);
}
