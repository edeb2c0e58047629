/* SPDX-License-Identifier: Apache-2.0 */
/** @file Who does what is asked for next is obeyed, in every workphase, whatever is known of the
 * plan, and comes to the target. */
#include "unity.h"

#include "integration/support/rig.h"
#include "interface/app/names.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"
#include "unit/support/scenes.h"

#include <string.h>

static rig_t rig;
static int32_t probe_nm[ROBOT_PROBE_LENGTHS]; /* As the robot has it. */

void setUp(void)
{
}

void tearDown(void)
{
}

typedef enum { UNREGISTERED, REGISTERED, TARGETED, WITHOUT_PROBE } knowledge_t;

static status_t aim(void)
{
    const rigid_t pose = rig_pose(5000000, 190000000, 60000000);
    return (status_t)rig_target(&rig, &pose).status;
}

static status_t tell_registration(void)
{
    command_t command = {.kind = (uint32_t)COMMAND_REGISTRATION};
    rigid_set_identity(&command.pose);
    return (status_t)rig_command(&rig, command).status;
}

static status_t tell_probe(void)
{
    command_t command = {.kind = (uint32_t)COMMAND_PROBE,
                         .argument = robot_neuro.probe_length_count};
    (void)memcpy(command.ticks, probe_nm, sizeof probe_nm);
    return (status_t)rig_command(&rig, command).status;
}

/* What is asked for next, and what becomes of it. */
static status_t follow(next_step_t step)
{
    static const workphase_t ways[] = {[NEXT_STEP_START_UP] = WORKPHASE_START_UP,
                                       [NEXT_STEP_PLANNING] = WORKPHASE_PLANNING,
                                       [NEXT_STEP_CALIBRATION] = WORKPHASE_CALIBRATION,
                                       [NEXT_STEP_TARGETING] = WORKPHASE_TARGETING,
                                       [NEXT_STEP_MOVE] = WORKPHASE_MOVE_TO_TARGET};
    status_t status = STATUS_UNKNOWN_COMMAND;
    if (step == NEXT_STEP_REGISTER) {
        status = tell_registration();
    } else if (step == NEXT_STEP_TARGET) {
        status = aim();
    } else if (step == NEXT_STEP_PROBE) {
        status = tell_probe();
    } else {
        status = (status_t)rig_workphase(&rig, ways[step]).status;
    }
    return status;
}

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
        rig_let_expire(&rig); /* What is armed expires. */
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
        {WORKPHASE_MOVE_TO_TARGET, WITHOUT_PROBE, NEXT_STEP_PLANNING},
        {WORKPHASE_MANUAL, UNREGISTERED, NEXT_STEP_CALIBRATION},
        {WORKPHASE_MANUAL, REGISTERED, NEXT_STEP_TARGETING},
        {WORKPHASE_MANUAL, TARGETED, NEXT_STEP_TARGETING},
        {WORKPHASE_STOP, UNREGISTERED, NEXT_STEP_CALIBRATION},
        {WORKPHASE_STOP, REGISTERED, NEXT_STEP_TARGETING},
        {WORKPHASE_STOP, TARGETED, NEXT_STEP_TARGETING},
        {WORKPHASE_STOP, WITHOUT_PROBE, NEXT_STEP_PROBE},
        {WORKPHASE_EMERGENCY, UNREGISTERED, NEXT_STEP_START_UP},
        {WORKPHASE_EMERGENCY, TARGETED, NEXT_STEP_START_UP},
        {WORKPHASE_START_UP, UNREGISTERED, NEXT_STEP_CALIBRATION},
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
