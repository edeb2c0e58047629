/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: the needle follows the hand that pushes it, under the pedal and up to its depth,
 * whatever the hand does; and nothing moves by a force that is doubtful.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "controller/controller.h"
#include "limits/requirement_limits.h"
#include "robot/robot_prostate.h"
#include "safety/permit.h"
#include "unit/support/scenes.h"

#include <stdio.h>

#define NEEDLE PROSTATE_AXIS_INSERTION
#define NO_FORCE 1970U      /* Reading of the hand's converter. */
#define MN_PER_COUNT 8.8503 /* 0.902478 of 9.80665 mN. */
#define OVERSHOOT_TICKS 166 /* 0.1 mm. */
#define LONG_CYCLES 60000U
#define FILTERED_CYCLES 30U /* From a hand that lets go to a force below the dead zone. */
#define STILL_TICKS 2       /* What a motor runs on for after it was switched off. */
#define JERK_SCENES 40U

static const command_t cooperate = {.kind = (uint32_t)COMMAND_COOPERATE};

static rig_t rig;
static uint64_t random_state;

void setUp(void)
{
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static uint32_t random_below(uint32_t count)
{
    random_state = (random_state * UINT64_C(6364136223846793005)) + UINT64_C(1442695040888963407);
    return (uint32_t)(random_state >> 33U) % count;
}

static void push(int32_t force_mn)
{
    char order[32];
    (void)snprintf(order, sizeof order, "force hand %d",
                   (int)NO_FORCE + (int)((double)force_mn / MN_PER_COUNT));
    rig_box(&rig, order);
}

static int32_t target_ticks(void)
{
    return rig.controller.plan.target_ticks[NEEDLE];
}

static int32_t depth_ticks(void)
{
    return rig_position(&rig, NEEDLE);
}

static uint32_t status_of(command_t command)
{
    return rig_command(&rig, command).status;
}

static bool has_reason(permit_reason_t reason)
{
    return (rig.outputs.snapshot.axes[NEEDLE].permit_reasons & permit_reason(true, reason)) != 0U;
}

static bool is_driven(void)
{
    return rig.outputs.snapshot.axes[NEEDLE].drive_mode != (uint32_t)CARD_DRIVE_OFF;
}

static void zero_force(void)
{
    const command_t zero = {.kind = (uint32_t)COMMAND_ZERO_FORCE,
                            .source = (uint32_t)COMMAND_SOURCE_HTTP,
                            .peer = RIG_PAGE};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, zero).status);
    rig_cycles(&rig, LIMIT_FORCE_ZERO_CYCLES + 1U);
}

static void align(void)
{
    rigid_t pose;
    rigid_set_identity(&pose);
    pose.translation = (point_t){5000000, -10000000, 52000000};
    command_t entry = {.kind = (uint32_t)COMMAND_ENTRY, .as.pose = {.pose = pose}};
    entry.as.pose.pose.translation.z_nm -= 30000000;
    rig_start_robot_targeted(&rig, &robot_prostate, &pose);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, entry).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &pose).status);
    TEST_ASSERT_EQUAL_UINT32(
        STATUS_OK, rig_command(&rig, (command_t){.kind = (uint32_t)COMMAND_ALIGN}).status);
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, 120000U).kind);
    rig_release(&rig);
    rig_cycles(&rig, 500U);
}

/* Aligned once and copied; zeroed, in MOVE_TO_TARGET. */
static void start_ready(void)
{
    static rig_t ready;
    static bool is_ready = false;
    if (!is_ready) {
        align();
        zero_force();
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
        ready = rig;
        is_ready = true;
    }
    rig = ready;
}

static void start_armed(void)
{
    start_ready();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, status_of(cooperate));
    rig_press(&rig);
}

void test_SWR_COOP_001_a_hand_brings_the_needle_to_its_depth(void)
{
    start_armed();
    push(800);
    const answer_t answer = rig_finish(&rig, LONG_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, answer.kind);
    TEST_ASSERT_EQUAL_UINT32(COMMAND_COOPERATE, answer.command);
    TEST_ASSERT_INT32_WITHIN(robot_prostate.axes[NEEDLE].deadband_ticks, target_ticks(),
                             depth_ticks());
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_NOTHING, rig.outputs.snapshot.next_step);
}

/* It jerks, pushes as hard as the sensor can show, pulls and lets go, as chance has it. */
void test_SWR_COOP_003_no_hand_takes_the_true_needle_past_its_depth(void)
{
    for (uint32_t scene = 0U; scene < SCENES(JERK_SCENES); scene++) {
        start_armed();
        random_state = scene;
        for (uint32_t i = 0U; i < LONG_CYCLES; i++) {
            if (random_below(40U) == 0U) {
                push((int32_t)random_below(14000U) - 5000);
            }
            rig_cycle(&rig);
            TEST_ASSERT_LESS_OR_EQUAL_INT32(target_ticks() + OVERSHOOT_TICKS, depth_ticks());
            if (rig.outputs.snapshot.order == (uint32_t)ARMING_STATE_NONE) {
                break;
            }
        }
        TEST_ASSERT_GREATER_OR_EQUAL_INT32(
            target_ticks() - robot_prostate.axes[NEEDLE].deadband_ticks, depth_ticks());
    }
}

void test_SWR_COOP_005_the_true_needle_stands_soon_after_the_hand_has_let_go(void)
{
    start_armed();
    push(3000);
    rig_cycles(&rig, 1000U);
    TEST_ASSERT_TRUE(is_driven());
    push(0);
    rig_cycles(&rig, FILTERED_CYCLES + (LIMIT_HAND_OFF_US / LIMIT_CYCLE_US));
    const int32_t there = depth_ticks();
    for (uint32_t i = 0U; i < 2000U; i++) {
        rig_cycle(&rig);
        TEST_ASSERT_FALSE(is_driven());
        TEST_ASSERT_INT32_WITHIN(STILL_TICKS, there, depth_ticks());
    }
    push(800);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, LONG_CYCLES).kind);
}

void test_SWR_COOP_006_a_doubtful_force_drives_nothing_and_ends_the_order(void)
{
    start_armed();
    push(1000);
    rig_cycles(&rig, 1000U);
    TEST_ASSERT_TRUE(is_driven());
    rig_forget(&rig);
    rig_box(&rig, "force hand 0");
    while (rig.outputs.snapshot.forces[FORCE_CHANNEL_HAND].doubts == 0U) {
        rig_cycle(&rig);
    }
    TEST_ASSERT_FALSE(is_driven());
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
    TEST_ASSERT_EQUAL_UINT32(STATUS_FORCE_DOUBTFUL, rig.answers[rig.answer_count - 1U].status);
    rig_release(&rig);
    rig_cycles(&rig, 200U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_FORCE_DOUBTFUL, status_of(cooperate));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, status_of((command_t){.kind = (uint32_t)COMMAND_RETRACT}));
    rig_press(&rig);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, rig_finish(&rig, LONG_CYCLES).kind);
}

void test_SWR_COOP_006_also_while_the_order_waits_for_the_pedal(void)
{
    start_ready();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, status_of(cooperate));
    rig_box(&rig, "force hand 0");
    rig_cycles(&rig, 10U);
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
}

void test_SWR_COOP_008_the_permit_says_that_no_hand_pushes(void)
{
    start_armed();
    rig_cycles(&rig, 100U);
    TEST_ASSERT_TRUE(has_reason(PERMIT_REASON_HAND_OFF));
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_PUSH, rig.outputs.snapshot.next_step);
    push(1000);
    rig_cycles(&rig, 100U);
    TEST_ASSERT_EQUAL_HEX32(0U, rig.outputs.snapshot.axes[NEEDLE].permit_reasons);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_HOLD_PEDAL, rig.outputs.snapshot.next_step);
}

void test_SWR_COOP_009_it_is_not_armed_before_the_sensor_was_zeroed(void)
{
    align();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_FORCE_DOUBTFUL, status_of(cooperate));
}
