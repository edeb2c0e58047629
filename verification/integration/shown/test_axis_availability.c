/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: what is said of each axis and way before a mode for single axes is commanded for
 * it is what the controller then says: in many states, reached by chance.
 */
#include "unit/support/commands.h"
#include "integration/support/rig.h"

#include "unity.h"

#include "http/view/axis_availability.h"
#include "http/view/mode_availability.h"
#include "interface/app/names.h"
#include "robot/app/robots.h"
#include "supervise/scenario/prng.h"
#include "unit/support/scenes.h"

#include <stdio.h>

#define STATES SCENES(60U)
#define SEEN_LEAST 5U /* So many different ones, and more. */
#define STATUSES 128U

static const mode_kind_t kinds[] = {MODE_JOG, MODE_HOME_AXIS, MODE_VELOCITY, MODE_SWEEP};
#define KINDS (sizeof kinds / sizeof kinds[0])

static rig_t rig;
static rig_t trial;
static uint32_t random_state;
static bool was_seen[STATUSES];

void setUp(void)
{
    random_state = 2463534242U;
}

void tearDown(void)
{
}

static uint32_t below(uint32_t bound)
{
    return prng_below(&random_state, bound);
}

static command_t of_axis(command_kind_t kind)
{
    return commands_of_number(kind, below(rig.robot.axis_count));
}

/* An end of the way of an axis, its home, or anywhere. */
static int32_t some_place(const axis_config_t *axis)
{
    const int32_t places[] = {axis->target_minimum_ticks, axis->target_maximum_ticks,
                              axis->home_ticks, axis->minimum_ticks};
    const uint32_t choice = below(6U);
    return (choice < 4U) ? places[choice]
                         : (axis->minimum_ticks +
                            (int32_t)below((uint32_t)(axis->maximum_ticks - axis->minimum_ticks)));
}

/* Commands that are obeyed at once, and a jog that is driven to its end or a part of its way. */
static void change_state(void)
{
    static const workphase_t phases[] = {WORKPHASE_MANUAL, WORKPHASE_MANUAL, WORKPHASE_PLANNING,
                                         WORKPHASE_STOP, WORKPHASE_START_UP};
    command_t jog = of_axis(COMMAND_JOG);
    jog.as.jog.to_ticks = some_place(&rig.robot.axes[jog.as.jog.axis]);
    rig_forget(&rig);
    switch (below(8U)) {
    case 0:
        (void)rig_workphase(&rig, phases[below(5U)]);
        break;
    case 1:
        (void)rig_command(&rig, of_axis((below(2U) == 0U) ? COMMAND_CLEAR_AXIS : COMMAND_SET_HOME));
        break;
    case 2:
        (void)rig_command(&rig,
                          of_axis((below(3U) == 0U) ? COMMAND_DISABLE_AXIS : COMMAND_ENABLE_AXIS));
        break;
    default:
        (void)rig_workphase(&rig, WORKPHASE_MANUAL);
        if (rig_command(&rig, jog).status == (uint32_t)STATUS_OK) {
            rig_press(&rig);
            rig_cycles(&rig, 200U + below(20000U));
            rig_release(&rig);
        }
        break;
    }
    rig_cycles(&rig, 20U);
}

/* In a copy, so that the state stays. */
static void expect_axis(const robot_t *robot, mode_kind_t kind, uint32_t axis, bool is_upwards)
{
    const snapshot_t *const shown = &rig.outputs.snapshot;
    char words[96];
    const status_t said = axis_availability(robot, shown, kind, axis, is_upwards);
    trial = rig;
    rig_forget(&trial);
    const answer_t answer =
        rig_command(&trial, axis_availability_command(robot, shown, kind, axis, is_upwards));
    (void)snprintf(words, sizeof words, "%s of %s, %s, in %s", mode_kind_name((int32_t)kind),
                   robot->axes[axis].name, is_upwards ? "upwards" : "downwards",
                   workphase_name((int32_t)shown->workphase));
    TEST_ASSERT_EQUAL_STRING_MESSAGE(status_name((int32_t)answer.status),
                                     status_name((int32_t)said), words);
    was_seen[said] = true;
}

/* One that can be commanded, or a refusal that an axis meets. */
static void expect_mode(const robot_t *robot, mode_kind_t kind)
{
    const status_t said = mode_availability(robot, &rig.outputs.snapshot, NULL, kind);
    bool is_met = false;
    bool is_any_armed = false;
    for (uint32_t i = 0U; i < (2U * robot->axis_count); i++) {
        const status_t one =
            axis_availability(robot, &rig.outputs.snapshot, kind, i / 2U, (i % 2U) != 0U);
        is_met = is_met || (one == said);
        is_any_armed = is_any_armed || (one == STATUS_OK);
    }
    TEST_ASSERT_TRUE(is_met);
    TEST_ASSERT_EQUAL(is_any_armed, said == STATUS_OK);
}

static void expect_states(const robot_t *robot, uint32_t states)
{
    for (uint32_t state = 0U; state < states; state++) {
        for (uint32_t kind = 0U; kind < KINDS; kind++) {
            for (uint32_t i = 0U; i < (2U * robot->axis_count); i++) {
                expect_axis(robot, kinds[kind], i / 2U, (i % 2U) != 0U);
            }
            expect_mode(robot, kinds[kind]);
        }
        change_state();
    }
}

static uint32_t count_seen(void)
{
    uint32_t seen = 0U;
    for (uint32_t i = 0U; i < STATUSES; i++) {
        seen += was_seen[i] ? 1U : 0U;
    }
    return seen;
}

void test_SWR_MODE_013_what_is_said_of_each_axis_is_what_becomes_of_its_command(void)
{
    rig_start_homed(&rig);
    expect_states(robots_find("neuro"), STATES);
    if (ARE_SCENES_WHOLE) {
        TEST_ASSERT_GREATER_THAN_UINT32(SEEN_LEAST, count_seen());
        TEST_ASSERT_TRUE(was_seen[STATUS_NEEDLE_IN]);
    }
}

/* Up to where its switch may be active. */
void test_SWR_MODE_013_the_zone_of_a_switch_is_named_the_way_to_it_alone(void)
{
    const robot_t *const robot = robots_find("neuro");
    const uint32_t head = 0U;
    command_t jog = {.kind = (uint32_t)COMMAND_JOG, .as.jog = {.axis = head}};
    jog.as.jog.to_ticks = robot->axes[head].target_maximum_ticks;
    rig_start_homed(&rig);
    (void)rig_workphase(&rig, WORKPHASE_MANUAL);
    rig_forget(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 60000U).kind);
    rig_release(&rig);
    TEST_ASSERT_EQUAL_INT32(jog.as.jog.to_ticks, rig_position(&rig, head));
    expect_axis(robot, MODE_JOG, head, true);
    TEST_ASSERT_TRUE(was_seen[STATUS_SWITCH_ZONE]);
    was_seen[STATUS_OK] = false;
    expect_axis(robot, MODE_JOG, head, false);
    TEST_ASSERT_TRUE(was_seen[STATUS_OK]);
}

void test_SWR_MODE_013_before_homing_as_well_and_of_axes_that_share_limits(void)
{
    rig_start_robot(&rig, robots_find("prostate"));
    expect_states(robots_find("prostate"), STATES / 3U);
    if (ARE_SCENES_WHOLE) {
        rig_start_robot_homed(&rig, robots_find("prostate"));
        expect_states(robots_find("prostate"), STATES / 3U);
    }
}
