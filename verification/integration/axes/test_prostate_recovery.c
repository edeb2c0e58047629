/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: wherever the ProstateRobot legally stands, START_UP homes a carriage that has a
 * switch and has lost its position, and on the whole way no limit that the carriages share is left
 * and no carriage goes beyond its end, by where they truly are. In every test the rig counts cycles
 * that drive without the pedal; there must be none.
 */
#include "integration/support/rig.h"
#include "robot/app/robots.h"

#include "unity.h"

#include "limits/requirement_limits.h"
#include "robot/coupled_limit.h"
#include "robot/joints.h"
#include "robot/kinematics.h"
#include "robot/robot_prostate.h"
#include "unit/support/scenes.h"

#include <stdlib.h>

#define HOLD_CYCLES (LIMIT_CONFIRM_HOLD_US / LIMIT_CYCLE_US)
#define MOST_CYCLES SCENES(SCENES(300000U))
#define CARRIAGES 4U
/* In so many no carriage goes 0.02 mm. */
#define LOOK_CYCLES 8U
/* In so many the block would have left its room. */
#define BEYOND_CYCLES 10000U
/* A carriage may stand so far beyond its switch. */
#define END_TICKS 400

static const robot_t *robot;
static robot_t simulated;
static rig_t rig;
static uint32_t seed;

void setUp(void)
{
    robot = robots_find("prostate");
    TEST_ASSERT_NOT_NULL(robot);
    simulated = *robot;
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static uint32_t chance(uint32_t below)
{
    seed = (seed * 1664525U) + 1013904223U;
    return (uint32_t)(((uint64_t)(seed >> 1U) * below) >> 31U);
}

static bool find_pose(int32_t ticks[ROBOT_AXIS_MAX])
{
    joints_t joints;
    for (uint32_t i = 0U; i < CARRIAGES; i++) {
        const axis_config_t *const config = &robot->axes[i];
        ticks[i] = config->minimum_ticks +
                   (int32_t)chance((uint32_t)(config->maximum_ticks - config->minimum_ticks));
    }
    joints_from_ticks(robot, ticks, &joints);
    return coupled_limit_judge(robot, &joints).status == STATUS_OK;
}

/* Restored there, and confirmed by the button. */
static void start_at(const int32_t ticks[ROBOT_AXIS_MAX])
{
    command_t restore = {.kind = COMMAND_RESTORE,
                         .as.positions = {.axes = (1U << robot->axis_count) - 1U}};
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        simulated.start_ticks[i] = ticks[i];
        restore.as.positions.ticks[i] = ticks[i];
    }
    rig_start_robot(&rig, &simulated);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    rig_cycles(&rig, 500U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, restore).status);
    rig_box(&rig, "button press");
    rig_cycles(&rig, HOLD_CYCLES + 1U);
    rig_box(&rig, "button release");
    rig_cycles(&rig, 2U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_homed);
    rig_forget(&rig);
}

static bool is_inside(void)
{
    double truth[ROBOT_AXIS_MAX];
    int32_t ticks[ROBOT_AXIS_MAX] = {0};
    joints_t joints;
    bool is_in = true;
    box_true_positions(&rig.box, truth);
    for (uint32_t i = 0U; i < CARRIAGES; i++) {
        const axis_config_t *const config = &robot->axes[i];
        ticks[i] = (int32_t)truth[i];
        is_in = is_in && (ticks[i] >= (config->minimum_ticks - END_TICKS)) &&
                (ticks[i] <= (config->maximum_ticks + END_TICKS));
    }
    joints_from_ticks(robot, ticks, &joints);
    for (uint32_t i = 0U; i < robot->coupled_limit_count; i++) {
        const coupled_limit_t *const limit = &robot->coupled_limits[i];
        const int64_t value = kinematics_coupled(robot, i, &joints);
        is_in = is_in && (value >= limit->minimum) && (value <= limit->maximum);
    }
    return is_in;
}

static bool is_every_homed(uint32_t lost)
{
    bool is_every = true;
    for (uint32_t i = 0U; i < CARRIAGES; i++) {
        const bool is_meant = ((lost >> i) & 1U) != 0U;
        is_every = is_every && (!is_meant || axis_is_homed(&rig.controller.axes[i]));
    }
    return is_every;
}

static void lose(uint32_t lost)
{
    for (uint32_t i = 0U; i < CARRIAGES; i++) {
        const command_t clear = {.kind = COMMAND_CLEAR_AXIS, .as.axis = {.axis = i}};
        if (((lost >> i) & 1U) != 0U) {
            TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, clear).status);
        }
    }
}

/* START_UP under the pedal until the axes of `lost` are homed, for `most` cycles. */
static void home_for(uint32_t lost, uint32_t most)
{
    uint32_t cycles = 0U;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_press(&rig);
    while (!is_every_homed(lost) && (cycles < most)) {
        rig_cycle(&rig);
        cycles++;
        TEST_ASSERT_TRUE_MESSAGE(((cycles % LOOK_CYCLES) != 0U) || is_inside(), "beyond a limit");
        TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig_count(&rig, EVENT_ORDER_DISCARDED), "discarded");
    }
    rig_release(&rig);
}

static void expect_homed_again(uint32_t lost)
{
    home_for(lost, CARRIAGES * MOST_CYCLES);
    if (ARE_SCENES_WHOLE) {
        TEST_ASSERT_TRUE(is_every_homed(lost));
    }
}

static void play(uint32_t lost, uint32_t count)
{
    uint32_t scenes = 0U;
    while (scenes < count) {
        int32_t ticks[ROBOT_AXIS_MAX] = {[PROSTATE_AXIS_INSERTION] = 200};
        if (find_pose(ticks)) {
            start_at(ticks);
            lose(lost);
            expect_homed_again(lost);
            scenes++;
        }
    }
}

/* Homing all carriages as a block would take rear_right beyond its end. */
static const int32_t rear_at_its_end[ROBOT_AXIS_MAX] = {300000, -250000, 300000, -104000, 200};
/* The right carriages as a block on their own would take alpha beyond its limit. */
static const int32_t turned[ROBOT_AXIS_MAX] = {308800, -261747, 371967, -351676, 200};

#define BIT(axis) ((uint32_t)1U << (uint32_t)(axis))

void test_SWR_AXIS_053_two_lost_carriages_home_though_the_block_has_no_room(void)
{
    start_at(rear_at_its_end);
    lose(BIT(PROSTATE_AXIS_FRONT_LEFT) | BIT(PROSTATE_AXIS_REAR_RIGHT));
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_START_UP, rig.outputs.snapshot.next_step);
    expect_homed_again(BIT(PROSTATE_AXIS_FRONT_LEFT) | BIT(PROSTATE_AXIS_REAR_RIGHT));
}

void test_SWR_AXIS_053_both_lost_right_carriages_home_and_alpha_keeps_its_limit(void)
{
    start_at(turned);
    lose(BIT(PROSTATE_AXIS_FRONT_RIGHT) | BIT(PROSTATE_AXIS_REAR_RIGHT));
    expect_homed_again(BIT(PROSTATE_AXIS_FRONT_RIGHT) | BIT(PROSTATE_AXIS_REAR_RIGHT));
}

/* Both cards are out of sight for 30 ms: the positions are right, and in doubt. */
void test_SWR_AXIS_053_a_carriage_in_doubt_is_not_driven_beyond_its_end(void)
{
    start_at(rear_at_its_end);
    rig_box(&rig, "card front_left silent");
    rig_box(&rig, "card rear_right silent");
    rig_cycles(&rig, LIMIT_SILENT_KEPT_CYCLES + 30U);
    rig_box(&rig, "card front_left normal");
    rig_box(&rig, "card rear_right normal");
    rig_cycles(&rig, 100U);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_UNVERIFIED,
                             rig.controller.axes[PROSTATE_AXIS_REAR_RIGHT].chart.reference);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_START_UP, rig.outputs.snapshot.next_step);
    home_for(BIT(PROSTATE_AXIS_FRONT_LEFT), BEYOND_CYCLES);
}

/* Both cards are others for a while: what these counted says nothing of where the carriages are. */
static void break_two(void)
{
    start_at(rear_at_its_end);
    rig_box(&rig, "card front_left foreign");
    rig_box(&rig, "card rear_right foreign");
    rig_cycles(&rig, 30U);
    rig_box(&rig, "card front_left normal");
    rig_box(&rig, "card rear_right normal");
    rig_cycles(&rig, 500U);
}

/* The needle guide may stand anywhere: nothing is driven. */
void test_SWR_AXIS_055_two_whose_counts_have_broken_are_not_driven(void)
{
    double before[ROBOT_AXIS_MAX];
    double after[ROBOT_AXIS_MAX];
    break_two();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    box_true_positions(&rig.box, before);
    rig_press(&rig);
    rig_cycles(&rig, 20U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ORDER_DISCARDED));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_HOMING_UNPLACED));
    rig_release(&rig);
    box_true_positions(&rig.box, after);
    for (uint32_t i = 0U; i < CARRIAGES; i++) {
        TEST_ASSERT_EQUAL_INT32((int32_t)before[i], (int32_t)after[i]);
    }
}

void test_SWR_NEXT_003_of_two_whose_counts_have_broken_one_is_placed_before_start_up(void)
{
    command_t restore = {.kind = COMMAND_RESTORE,
                         .as.positions = {.axes = BIT(PROSTATE_AXIS_FRONT_LEFT)}};
    break_two();
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_PLACE, rig.outputs.snapshot.next_step);
    TEST_ASSERT_EQUAL_UINT32(PROSTATE_AXIS_FRONT_LEFT, rig.outputs.snapshot.step_axis);
    restore.as.positions.ticks[PROSTATE_AXIS_FRONT_LEFT] =
        rear_at_its_end[PROSTATE_AXIS_FRONT_LEFT];
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, restore).status);
    rig_cycles(&rig, 2U);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_START_UP, rig.outputs.snapshot.next_step);
    home_for(BIT(PROSTATE_AXIS_FRONT_LEFT), BEYOND_CYCLES);
}

/* Number of poses, and seed; POSES=200 SEED=7 plays others. */
static uint32_t asked(const char *name, uint32_t otherwise)
{
    const char *const text = getenv(name);
    return (text != NULL) ? (uint32_t)strtoul(text, NULL, 10) : otherwise;
}

/* One, two and three; which of them go on at the seed that POSES leaves. */
void test_SWR_AXIS_051_lost_carriages_home_again_from_any_legal_pose(void)
{
    static const uint32_t carriages[] = {
        BIT(PROSTATE_AXIS_FRONT_LEFT),
        BIT(PROSTATE_AXIS_FRONT_RIGHT) | BIT(PROSTATE_AXIS_REAR_RIGHT),
        BIT(PROSTATE_AXIS_FRONT_LEFT) | BIT(PROSTATE_AXIS_FRONT_RIGHT) |
            BIT(PROSTATE_AXIS_REAR_RIGHT),
        BIT(PROSTATE_AXIS_FRONT_RIGHT),
        BIT(PROSTATE_AXIS_REAR_RIGHT),
        BIT(PROSTATE_AXIS_FRONT_LEFT) | BIT(PROSTATE_AXIS_FRONT_RIGHT),
        BIT(PROSTATE_AXIS_FRONT_LEFT) | BIT(PROSTATE_AXIS_REAR_RIGHT)};
    const uint32_t poses = asked("POSES", 1U);
    seed = asked("SEED", 1U);
    for (uint32_t i = 0U; i < asked("SETS", 1U); i++) {
        play(carriages[i], poses);
    }
}
