/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a pose of the robot's file is gone to by all axes but the needle, only with the
 * needle out and on a way inside the coupled limits; what is no pose is refused by name.
 */
#include "unity.h"

#include "base/seal.h"
#include "mode/leg/leg.h"
#include "mode/leg/mode_frame.h"
#include "mode/move/move_mode.h"
#include "mode/pose/pose_mode.h"
#include "robot/robot_neuro.h"
#include "safety/needle.h"
#include "unit/support/mode_world.h"

#include <stddef.h>

#define LONG_CYCLES 100000U
#define OUT_TICKS 900

static leg_t leg;
static move_mode_t move;

void setUp(void)
{
    world_start();
    leg = (leg_t){.axes = 0U};
    world_put(NEURO_AXIS_INSERTION, OUT_TICKS);
}

void tearDown(void)
{
}

static status_t judge(uint32_t pose)
{
    const status_t status = pose_mode_find(pose, &robot, axes, &move);
    return (status == STATUS_OK) ? pose_mode_judge(&move, &robot, axes).status : status;
}

void test_SWR_POSE_001_every_axis_but_the_needle_goes_to_the_pose_in_step(void)
{
    for (uint32_t pose = (uint32_t)POSE_PARK; pose < POSE_NAME_COUNT; pose++) {
        uint32_t cycles = 0U;
        TEST_ASSERT_EQUAL(STATUS_OK, judge(pose));
        mode_clear(&result);
        while (result.progress == MODE_RUNNING) {
            TEST_ASSERT_LESS_THAN_UINT32(LONG_CYCLES, cycles);
            cycles++;
            pose_mode_step(&move, &leg, &frame, &result);
            TEST_ASSERT_TRUE(world_rests(NEURO_AXIS_INSERTION));
            world_follow();
        }
        TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
        for (uint32_t i = 0U; i < robot.axis_count; i++) {
            const int32_t place = (i == (uint32_t)NEURO_AXIS_INSERTION)
                                      ? OUT_TICKS
                                      : robot_neuro.poses[pose].ticks[i];
            TEST_ASSERT_EQUAL_INT32(place, axes[i].sealed.encoder.position_ticks);
        }
    }
}

void test_SWR_POSE_001_a_needle_that_is_touched_on_the_way_is_not_driven_back(void)
{
    TEST_ASSERT_EQUAL(STATUS_OK, judge(POSE_DRAPING));
    mode_clear(&result);
    pose_mode_step(&move, &leg, &frame, &result);
    world_put(NEURO_AXIS_INSERTION, OUT_TICKS + 60);
    pose_mode_step(&move, &leg, &frame, &result);
    TEST_ASSERT_TRUE(world_rests(NEURO_AXIS_INSERTION));
}

void test_SWR_POSE_002_the_needle_must_be_known_to_be_out(void)
{
    world_put(NEURO_AXIS_INSERTION, needle_out_ticks(&robot));
    TEST_ASSERT_EQUAL(STATUS_OK, judge(POSE_DRAPING));
    world_put(NEURO_AXIS_INSERTION, needle_out_ticks(&robot) + 1);
    TEST_ASSERT_EQUAL(STATUS_NEEDLE_IN, judge(POSE_DRAPING));
    TEST_ASSERT_EQUAL_UINT8(NEURO_AXIS_INSERTION, pose_mode_judge(&move, &robot, axes).axis);
    world_put(NEURO_AXIS_INSERTION, OUT_TICKS);
    world_lose(NEURO_AXIS_INSERTION);
    TEST_ASSERT_EQUAL(STATUS_NEEDLE_IN, judge(POSE_DRAPING));
}

void test_SWR_POSE_003_a_pose_that_the_file_does_not_name_is_none(void)
{
    TEST_ASSERT_EQUAL(STATUS_NO_POSE, judge(POSE_HOME));
    TEST_ASSERT_EQUAL(STATUS_NO_POSE, judge(POSE_NAME_COUNT));
    TEST_ASSERT_EQUAL(STATUS_NO_POSE, judge(UINT32_MAX));
}

void test_SWR_POSE_003_a_damaged_pose_is_not_gone_to(void)
{
    for (size_t i = 0U; i < (offsetof(pose_t, seal) + 4U); i++) {
        uint8_t *const byte = (uint8_t *)&robot.poses[POSE_EGRESS] + i;
        *byte ^= (uint8_t)(1U << (i % 8U));
        TEST_ASSERT_EQUAL(STATUS_MEMORY_DAMAGED, judge(POSE_EGRESS));
        *byte ^= (uint8_t)(1U << (i % 8U));
    }
    TEST_ASSERT_EQUAL(STATUS_OK, judge(POSE_EGRESS));
}

/* The measure of a limit that is not curved lies between its ends, which the compiler has judged.
 */
void test_SWR_POSE_004_a_way_that_leaves_a_coupled_limit_is_refused_by_its_name(void)
{
    pose_t *const pose = &robot.poses[POSE_PARK];
    pose->ticks[NEURO_AXIS_HEAD] = -100;
    pose->ticks[NEURO_AXIS_FEET] = -500;
    robot.coupled_limits[0].is_curved = 1U;
    pose->seal = seal_of(SEAL_START, (const uint8_t *)pose, offsetof(pose_t, seal));
    TEST_ASSERT_EQUAL(robot.coupled_limits[0].refusal, judge(POSE_PARK));
}
