/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the last axis of a linkage that is not homed gets to its switch from any legal
 * pose, the others travel with it, and no limit is left by where it truly is, wherever its counts
 * have it. Each axis is in the next cycle where it was to be; the rest of the controller is not
 * there.
 */
#include "unity.h"

#include "axis/axis.h"
#include "axis/homing.h"
#include "mode/leg/escort.h"
#include "robot/coupled_limit.h"
#include "robot/joints.h"
#include "robot/kinematics.h"
#include "robot/robot_prostate.h"
#include "unit/support/scenes.h"

#define FRONT_LEFT ((uint32_t)PROSTATE_AXIS_FRONT_LEFT)
#define FRONT_RIGHT ((uint32_t)PROSTATE_AXIS_FRONT_RIGHT)
#define REAR_LEFT ((uint32_t)PROSTATE_AXIS_REAR_LEFT)
#define REAR_RIGHT ((uint32_t)PROSTATE_AXIS_REAR_RIGHT)
#define CARRIAGES 4U

#define POSES SCENES(30U)
/* Step of a cycle, here; at most the shorter way ahead until it is looked at again. */
#define STEP_TICKS 12
#define MOST_STEPS 60000U

static robot_t robot;
static axis_t axes[ROBOT_AXIS_MAX];
static escort_t escort;
static uint32_t seed;

/* Where the leader truly is, less where its counts have it. */
static int32_t hidden_ticks;

static void grade(uint32_t axis, axis_reference_t reference)
{
    axes[axis].chart.reference = reference;
    axes[axis].chart.reference_inverse = ~(uint32_t)reference;
}

void setUp(void)
{
    robot = robot_prostate;
    seed = 1U;
    hidden_ticks = 0;
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        axis_init(&axes[i]);
        grade(i, AXIS_REFERENCE_VERIFIED);
        axes[i].sealed.encoder.position_ticks = robot.poses[POSE_HOME].ticks[i];
    }
    escort_end(&escort);
}

void tearDown(void)
{
}

static int32_t chance(int32_t below)
{
    seed = (seed * 1664525U) + 1013904223U;
    return (int32_t)(((uint64_t)(seed >> 1U) * (uint64_t)below) >> 31U);
}

static int64_t coupled(uint32_t limit, uint32_t leader)
{
    joints_t joints = {.value = {0}};
    for (uint32_t i = 0U; i < CARRIAGES; i++) {
        const int32_t hidden = (i == leader) ? hidden_ticks : 0;
        joints.value[i] = joints_of(&robot.axes[i], axes[i].sealed.encoder.position_ticks + hidden);
    }
    return kinematics_coupled(&robot, limit, &joints);
}

/* The limits by where the axes truly are, `margin` parts of the margin of ends inside. */
static bool is_inside(uint32_t leader, int64_t margin)
{
    bool is_in = true;
    for (uint32_t i = 0U; i < robot.coupled_limit_count; i++) {
        const coupled_limit_t *const limit = &robot.coupled_limits[i];
        const int64_t value = coupled(i, leader);
        is_in = is_in && (value >= (limit->minimum + (margin * coupled_limit_margin(limit)))) &&
                (value <= (limit->maximum - (margin * coupled_limit_margin(limit))));
    }
    return is_in;
}

static void put_by_chance(uint32_t leader)
{
    hidden_ticks = 0;
    do {
        for (uint32_t i = 0U; i < CARRIAGES; i++) {
            const axis_config_t *const config = &robot.axes[i];
            axes[i].sealed.encoder.position_ticks =
                config->minimum_ticks + chance(config->maximum_ticks - config->minimum_ticks);
        }
    } while (!is_inside(leader, 1));
}

/* It homes, or its counts are `hidden` off. */
static void begin(uint32_t leader, int32_t hidden, axis_reference_t leg)
{
    hidden_ticks = hidden;
    axes[leader].sealed.encoder.position_ticks -= hidden;
    grade(leader, AXIS_REFERENCE_LOST);
    TEST_ASSERT_TRUE(escort_is_for(&robot, axes, leader));
    homing_begin(&axes[leader].sealed.homing, axes[leader].sealed.encoder.position_ticks);
    grade(leader, leg);
    escort_begin(&escort, &robot, axes, leader);
}

/* Leader and escort go on, or rest. */
static escort_verdict_t step(uint32_t leader)
{
    axis_t *const axis = &axes[leader];
    const bool is_upper = robot.axes[leader].limit_switch == (uint8_t)LIMIT_SWITCH_UPPER;
    const int32_t ticks = escort_is_slow(&escort) ? (STEP_TICKS / 2) : STEP_TICKS;
    const escort_verdict_t verdict = escort_step(&escort, &robot, axes);
    if (verdict != ESCORT_GOES) {
        return verdict;
    }
    axis->sealed.encoder.position_ticks += is_upper ? ticks : -ticks;
    const int32_t gone = axis->sealed.encoder.position_ticks - axis->sealed.homing.start_ticks;
    for (uint32_t i = 0U; i < CARRIAGES; i++) {
        const int32_t pace = (int32_t)escort_pace(&escort, i);
        if (pace > 0) {
            axes[i].sealed.encoder.position_ticks =
                axes[i].sealed.homing.start_ticks + (pace * gone);
        }
    }
    return verdict;
}

static bool is_at_switch(uint32_t leader)
{
    const int32_t place = axes[leader].sealed.encoder.position_ticks + hidden_ticks;
    return homing_way_from_switch(&robot.axes[leader], place) <= 0;
}

static void expect_within(uint32_t axis)
{
    TEST_ASSERT_TRUE(axes[axis].sealed.encoder.position_ticks >= robot.axes[axis].minimum_ticks);
    TEST_ASSERT_TRUE(axes[axis].sealed.encoder.position_ticks <= robot.axes[axis].maximum_ticks);
}

static void expect_home(uint32_t leader)
{
    uint32_t steps = 0U;
    while (!is_at_switch(leader)) {
        TEST_ASSERT_NOT_EQUAL(ESCORT_NONE, step(leader));
        TEST_ASSERT_TRUE_MESSAGE(((steps % 8U) != 0U) || is_inside(leader, 0), "beyond a limit");
        TEST_ASSERT_LESS_THAN_UINT32(MOST_STEPS, steps);
        steps++;
    }
    TEST_ASSERT_TRUE(is_inside(leader, 0));
    for (uint32_t i = 0U; i < CARRIAGES; i++) {
        if (i != leader) {
            expect_within(i);
        }
    }
}

static void expect_home_from_anywhere(uint32_t leader)
{
    for (uint32_t i = 0U; i < POSES; i++) {
        put_by_chance(leader);
        begin(leader, chance(200000) - 100000, AXIS_REFERENCE_APPROACH);
        expect_home(leader);
        grade(leader, AXIS_REFERENCE_VERIFIED);
    }
}

void test_SWR_AXIS_051_front_left_gets_to_its_switch_from_any_legal_pose(void)
{
    expect_home_from_anywhere(FRONT_LEFT);
}

void test_SWR_AXIS_051_front_right_gets_to_its_switch_from_any_legal_pose(void)
{
    expect_home_from_anywhere(FRONT_RIGHT);
}

void test_SWR_AXIS_051_rear_right_gets_to_its_switch_from_any_legal_pose(void)
{
    expect_home_from_anywhere(REAR_RIGHT);
}

void test_SWR_AXIS_051_only_one_of_a_block_whose_partners_are_placed_is_escorted(void)
{
    TEST_ASSERT_FALSE(escort_is_for(&robot, axes, FRONT_LEFT));
    grade(FRONT_LEFT, AXIS_REFERENCE_LOST);
    TEST_ASSERT_TRUE(escort_is_for(&robot, axes, FRONT_LEFT));
    grade(REAR_RIGHT, AXIS_REFERENCE_UNVERIFIED);
    TEST_ASSERT_TRUE(escort_is_for(&robot, axes, FRONT_LEFT));
    TEST_ASSERT_FALSE(escort_is_for(&robot, axes, REAR_RIGHT));
    grade(REAR_RIGHT, AXIS_REFERENCE_LOST);
    TEST_ASSERT_FALSE(escort_is_for(&robot, axes, FRONT_LEFT));
    TEST_ASSERT_FALSE(escort_is_for(&robot, axes, REAR_RIGHT));
    grade(FRONT_LEFT, AXIS_REFERENCE_VERIFIED);
    TEST_ASSERT_TRUE(escort_is_for(&robot, axes, REAR_RIGHT));
}

void test_SWR_AXIS_051_without_a_switch_a_block_or_a_shared_limit_there_is_no_escort(void)
{
    grade(REAR_LEFT, AXIS_REFERENCE_LOST);
    TEST_ASSERT_FALSE(escort_is_for(&robot, axes, REAR_LEFT));
    grade(REAR_LEFT, AXIS_REFERENCE_VERIFIED);
    grade(PROSTATE_AXIS_INSERTION, AXIS_REFERENCE_LOST);
    TEST_ASSERT_FALSE(escort_is_for(&robot, axes, PROSTATE_AXIS_INSERTION));
    grade(FRONT_LEFT, AXIS_REFERENCE_LOST);
    robot.coupled_limit_count = 0U;
    TEST_ASSERT_FALSE(escort_is_for(&robot, axes, FRONT_LEFT));
}

/* With the right carriages at -110 and -130 mm no limit is left when front_left goes alone. */
void test_SWR_AXIS_051_an_axis_whose_switch_keeps_every_limit_goes_alone(void)
{
    axes[FRONT_RIGHT].sealed.encoder.position_ticks = -110 * 2500;
    axes[REAR_RIGHT].sealed.encoder.position_ticks = -130 * 2500;
    begin(FRONT_LEFT, 0, AXIS_REFERENCE_APPROACH);
    axes[FRONT_LEFT].sealed.homing.leg_us = 5000U;
    TEST_ASSERT_EQUAL(ESCORT_RESTS, step(FRONT_LEFT));
    TEST_ASSERT_EQUAL(ESCORT_GOES, step(FRONT_LEFT));
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_EQUAL_UINT32(0U, escort_pace(&escort, i));
    }
    TEST_ASSERT_EQUAL_UINT32(0U, axes[FRONT_LEFT].sealed.homing.leg_us);
}

void test_SWR_AXIS_051_from_its_switch_all_leave_together(void)
{
    begin(FRONT_LEFT, 0, AXIS_REFERENCE_LEAVE);
    for (uint32_t i = 0U; i < CARRIAGES; i++) {
        TEST_ASSERT_EQUAL_UINT32((i == FRONT_LEFT) ? 0U : 1U, escort_pace(&escort, i));
        TEST_ASSERT_EQUAL_INT32(axes[i].sealed.encoder.position_ticks,
                                axes[i].sealed.homing.start_ticks);
    }
    TEST_ASSERT_FALSE(escort_is_slow(&escort));
    TEST_ASSERT_EQUAL(ESCORT_GOES, escort_step(&escort, &robot, axes));
    TEST_ASSERT_EQUAL_UINT32(0U, escort_pace(&escort, PROSTATE_AXIS_INSERTION));
}

/* rear_left comes to its soft limit before front_left is at its switch: 3.75 ticks before it. */
void test_SWR_AXIS_051_what_has_no_room_any_more_rests_and_another_escort_is_found(void)
{
    static const int32_t ticks[] = {300000, -350000, 468475 - 5000, -300000};
    uint32_t changes = 0U;
    uint32_t steps = 0U;
    for (uint32_t i = 0U; i < CARRIAGES; i++) {
        axes[i].sealed.encoder.position_ticks = ticks[i];
    }
    begin(FRONT_LEFT, 0, AXIS_REFERENCE_APPROACH);
    while (!is_at_switch(FRONT_LEFT)) {
        const uint32_t before = escort.paces;
        TEST_ASSERT_NOT_EQUAL(ESCORT_NONE, step(FRONT_LEFT));
        changes += (before != escort.paces) ? 1U : 0U;
        TEST_ASSERT_LESS_THAN_UINT32(MOST_STEPS, steps);
        steps++;
        expect_within(REAR_LEFT);
    }
    TEST_ASSERT_GREATER_THAN_UINT32(2U, changes);
}

/* front_right homes, front_left goes twice its way and rear_left once. With the leader at one of
 * the places where it may be, beta changes; with it at the other, it is outside afterwards. */
void test_SWR_AXIS_051_what_changes_at_one_place_must_be_inside_at_the_other(void)
{
    static const int32_t ticks[] = {166 * 2500, -87 * 2500, 162 * 2500, -78 * 2500};
    for (uint32_t i = 0U; i < CARRIAGES; i++) {
        axes[i].sealed.encoder.position_ticks = ticks[i];
    }
    begin(FRONT_RIGHT, 0, AXIS_REFERENCE_APPROACH);
    escort.paces = ((uint32_t)2U << (2U * FRONT_LEFT)) | ((uint32_t)1U << (2U * REAR_LEFT));
    escort.search = (uint32_t)ESCORT_SEARCH_DONE;
    TEST_ASSERT_EQUAL(ESCORT_RESTS, escort_step(&escort, &robot, axes));
    TEST_ASSERT_EQUAL_UINT32(ESCORT_SEARCH_EVEN, escort.search);
}

/* One whose ticks are another way cannot keep step. */
void test_SWR_AXIS_051_an_axis_with_other_ticks_does_not_come_along(void)
{
    robot.axes[REAR_LEFT].unit_per_tick_q16 += 1;
    begin(FRONT_LEFT, 0, AXIS_REFERENCE_LEAVE);
    TEST_ASSERT_EQUAL_UINT32(0U, escort_pace(&escort, REAR_LEFT));
    TEST_ASSERT_EQUAL_UINT32(1U, escort_pace(&escort, REAR_RIGHT));
}

static uint32_t rests_until_none(uint32_t leader)
{
    uint32_t rests = 0U;
    escort_verdict_t verdict = ESCORT_RESTS;
    while (verdict == ESCORT_RESTS) {
        verdict = step(leader);
        rests++;
        TEST_ASSERT_LESS_THAN_UINT32(1000U, rests);
    }
    TEST_ASSERT_EQUAL(ESCORT_NONE, verdict);
    return rests;
}

/* 8 that go as far as the leader, and twice 27. The limits leave no place to the angle. */
void test_SWR_AXIS_052_each_escort_is_tried_once_before_there_is_none(void)
{
    for (uint32_t i = 0U; i < CARRIAGES; i++) {
        robot.axes[i].minimum_ticks = axes[i].sealed.encoder.position_ticks - 10;
        robot.axes[i].maximum_ticks = axes[i].sealed.encoder.position_ticks + 10;
    }
    robot.coupled_limits[2].minimum = -1;
    robot.coupled_limits[2].maximum = 1;
    begin(FRONT_LEFT, 0, AXIS_REFERENCE_APPROACH);
    TEST_ASSERT_FALSE(escort_was_missing(&escort, FRONT_LEFT));
    TEST_ASSERT_EQUAL_UINT32(8U + 27U + 27U, rests_until_none(FRONT_LEFT));
    TEST_ASSERT_TRUE(escort_was_missing(&escort, FRONT_LEFT));
    TEST_ASSERT_FALSE(escort_was_missing(&escort, FRONT_RIGHT));
}

/* Between the carriages of a stage are 88 to 308 mm: front_left is between -60 mm, its own end 40
 * mm, and 160 mm; in the middle, at 100 mm. The shorter way is taken of that. */
void test_SWR_AXIS_052_the_way_by_hand_leads_to_the_middle_of_where_it_can_be(void)
{
    axes[FRONT_RIGHT].sealed.encoder.position_ticks = -148 * 2500;
    begin(FRONT_LEFT, 0, AXIS_REFERENCE_APPROACH);
    TEST_ASSERT_INT32_WITHIN(300, (100 - 152) * 2500,
                             escort_way_by_hand_ticks(&escort, &robot, axes));
}

void test_SWR_AXIS_052_with_no_place_left_the_way_by_hand_leads_to_the_nearest_to_its_switch(void)
{
    axes[FRONT_RIGHT].sealed.encoder.position_ticks = -148 * 2500;
    begin(FRONT_LEFT, 0, AXIS_REFERENCE_APPROACH);
    axes[FRONT_LEFT].sealed.homing.start_ticks = -1000000;
    TEST_ASSERT_INT32_WITHIN(300, 472225 - (152 * 2500),
                             escort_way_by_hand_ticks(&escort, &robot, axes));
    grade(FRONT_LEFT, AXIS_REFERENCE_VERIFIED);
    begin(FRONT_RIGHT, 0, AXIS_REFERENCE_APPROACH);
    axes[FRONT_RIGHT].sealed.homing.start_ticks = 1000000;
    TEST_ASSERT_INT32_WITHIN(300, -472225 + (148 * 2500),
                             escort_way_by_hand_ticks(&escort, &robot, axes));
}
