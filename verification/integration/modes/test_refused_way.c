/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: where the way to the target would leave a limit that axes share, the next step
 * is no move that is refused for ever, but one that leads there.
 */
#include "unit/support/commands.h"
#include "integration/support/refused_way.h"
#include "integration/support/rig.h"

#include "base/seal.h"
#include "interface/app/names.h"
#include "interface/next_step.h"
#include "robot/robot_prostate.h"
#include "unit/support/refused_pair.h"
#include "unit/support/scenes.h"
#include "unity.h"

#include <stddef.h>

#define MOVE_CYCLES 90000U

static rig_t rig;
static robot_t standing;

/* The angle of the needle would leave its range on the way. */
static const refused_pair_t needle_in = {
    .from_ticks = {300129, -321160, 144661, -113624, 233757, 7992},
    .to_ticks = {276974, -383369, 208027, -225566, 61173, -4617}};

static refused_pair_t with_needle_out(void)
{
    refused_pair_t way = needle_in;
    way.from_ticks[PROSTATE_AXIS_INSERTION] =
        robot_prostate.poses[POSE_HOME].ticks[PROSTATE_AXIS_INSERTION];
    return way;
}

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static void expect(next_step_t step)
{
    TEST_ASSERT_EQUAL_STRING(next_step_name((int32_t)step),
                             next_step_name((int32_t)rig.outputs.snapshot.next_step));
}

static void phase(workphase_t workphase)
{
    TEST_ASSERT_EQUAL_STRING("OK", status_name((int32_t)rig_workphase(&rig, workphase).status));
}

static void command(command_kind_t kind, uint32_t argument)
{
    const command_t said = commands_of_number(kind, argument);
    TEST_ASSERT_EQUAL_STRING("OK", status_name((int32_t)rig_command(&rig, said).status));
}

static void run(void)
{
    rig_forget(&rig);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, MOVE_CYCLES).kind);
    rig_release(&rig);
}

void test_SWR_NEXT_023_a_refused_way_is_never_shown_as_a_move(void)
{
    const refused_pair_t way = with_needle_out();
    refused_way_start(&way, &robot_prostate, &standing, &rig);
    TEST_ASSERT_EQUAL_STRING(
        "BETA_LIMIT", status_name((int32_t)rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status));
    expect(NEXT_STEP_MANUAL);
    phase(WORKPHASE_STOP);
    expect(NEXT_STEP_MANUAL);
    phase(WORKPHASE_MANUAL);
    expect(NEXT_STEP_DRAPING);
    command(COMMAND_POSE, POSE_DRAPING);
    expect(NEXT_STEP_PRESS_PEDAL);
}

void test_SWR_NEXT_023_a_needle_that_is_in_comes_out_first(void)
{
    refused_way_start(&needle_in, &robot_prostate, &standing, &rig);
    expect(NEXT_STEP_MANUAL);
    phase(WORKPHASE_MANUAL);
    expect(NEXT_STEP_RETRACT);
    command(COMMAND_RETRACT, 0U);
    if (ARE_SCENES_WHOLE) {
        run();
        expect(NEXT_STEP_DRAPING);
        command(COMMAND_POSE, POSE_DRAPING);
        run();
        expect(NEXT_STEP_TARGETING);
        phase(WORKPHASE_TARGETING);
        expect(NEXT_STEP_MOVE);
        phase(WORKPHASE_MOVE_TO_TARGET);
        run();
        expect(NEXT_STEP_NOTHING);
    }
}

void test_SWR_NEXT_023_where_no_way_leads_round_another_target_is_asked_for(void)
{
    const refused_pair_t way = with_needle_out();
    refused_way_start(&way, &robot_prostate, &standing, &rig);
    rig.robot.pose_mask = 0U;
    rig.robot.seal = seal_of(SEAL_START, (const uint8_t *)&rig.robot, offsetof(robot_t, seal));
    rig.controller.way.seal ^= 1U;
    rig_cycle(&rig);
    expect(NEXT_STEP_WAIT);
    rig_cycles(&rig, 2U);
    expect(NEXT_STEP_TARGET);
    phase(WORKPHASE_PLANNING);
    expect(NEXT_STEP_TARGETING);
}
