/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: the needle follows the hand that pushes it, under the pedal and up to its depth,
 * whatever the hand does; and nothing moves by a force that is doubtful.
 */
#include "integration/support/by_hand.h"
#include "integration/support/rig.h"

#include "unity.h"

#include "base/fixed.h"
#include "controller/controller.h"
#include "limits/requirement_limits.h"
#include "unit/support/scenes.h"

#include <math.h>
#include <stdio.h>

#include "integration/support/cooperate_world.inc"

#define OVERSHOOT_TICKS 166.0 /* 0.1 mm. */
#define DEADBAND_TICKS 10.0   /* Of the axis, a count, and what homing is inexact by. */
#define FILTERED_CYCLES 30U   /* From a hand that lets go to a force below the dead zone. */
#define TICKS_PER_MM 1666.67
#define SWING_TRIALS (ARE_SCENES_WHOLE ? 500U : 60U)
#define SWING_CYCLES 500U
#define JERK_SCENES 40U
#define JERK_MN 4000 /* A larger step is doubted. */
#define PUSH_CYCLES 5000U
#define STOP_CYCLES 100U
#define PULL_MN 5000

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

static int32_t target_ticks(void)
{
    return rig.controller.plan.target_ticks[NEEDLE];
}

/* It lets go between pushes that are not too long, until the order has ended. */
static answer_t push_on(int32_t force_mn)
{
    rig_forget(&rig);
    for (uint32_t i = 0U; (i < LONG_CYCLES) && !is_over(); i++) {
        if ((i % PUSH_CYCLES) == 0U) {
            push(force_mn);
        } else if ((i % PUSH_CYCLES) == (PUSH_CYCLES - OFF_CYCLES)) {
            let_go();
        } else {
            /* As it is. */
        }
        rig_cycle(&rig);
    }
    TEST_ASSERT_NOT_EQUAL_UINT32(0U, rig.answer_count);
    return rig.answers[rig.answer_count - 1U];
}

void test_SWR_COOP_001_a_hand_brings_the_needle_to_its_depth(void)
{
    start_armed();
    const answer_t answer = push_on(800);
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, answer.kind);
    TEST_ASSERT_EQUAL_UINT32(COMMAND_COOPERATE, answer.command);
    TEST_ASSERT_DOUBLE_WITHIN(DEADBAND_TICKS, (double)target_ticks(), depth_ticks());
    rig_release(&rig);
    rig_cycles(&rig, 50U);
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_NOTHING, rig.outputs.snapshot.next_step);
}

/* It jerks, pushes as hard as the sensor can show, pulls and lets go, as chance has it. */
void test_SWR_COOP_003_no_hand_takes_the_true_needle_past_its_depth(void)
{
    for (uint32_t scene = 0U; scene < SCENES(JERK_SCENES); scene++) {
        int32_t force_mn = 0;
        start_armed();
        random_state = scene;
        for (uint32_t i = 0U; i < LONG_CYCLES; i++) {
            if (random_below(40U) == 0U) {
                force_mn = fixed_saturate(fixed_within(
                    force_mn + JERK_MN - (int64_t)random_below(2U * JERK_MN), -PULL_MN, HARD_MN));
                push(force_mn);
            } else if ((i % PUSH_CYCLES) == 0U) {
                push(force_mn / 2);
                rig_cycles(&rig, 2U);
                force_mn = 0;
                let_go();
                rig_cycles(&rig, OFF_CYCLES);
            } else {
                /* As it is. */
            }
            rig_cycle(&rig);
            TEST_ASSERT_TRUE(depth_ticks() <= ((double)target_ticks() + OVERSHOOT_TICKS));
            if (rig.outputs.snapshot.order == (uint32_t)ARMING_STATE_NONE) {
                break;
            }
        }
        TEST_ASSERT_TRUE(depth_ticks() >= ((double)target_ticks() - DEADBAND_TICKS));
    }
}

/* Range of the distances of its positions from the line that fits them best. */
static double swing_mm(const double *places, uint32_t count)
{
    double sums[4] = {0.0, 0.0, 0.0, 0.0};
    for (uint32_t i = 0U; i < count; i++) {
        const double time = (double)i;
        sums[0] += time;
        sums[1] += time * time;
        sums[2] += places[i];
        sums[3] += time * places[i];
    }
    const double cycles = (double)count;
    const double slope =
        ((cycles * sums[3]) - (sums[0] * sums[2])) / ((cycles * sums[1]) - (sums[0] * sums[0]));
    double lowest = INFINITY;
    double highest = -INFINITY;
    for (uint32_t i = 0U; i < count; i++) {
        lowest = fmin(lowest, places[i] - (slope * (double)i));
        highest = fmax(highest, places[i] - (slope * (double)i));
    }
    return (highest - lowest) / TICKS_PER_MM;
}

/* A hand of any stiffness goes on at a steady pace; the motor is up to a fifth faster or slower. */
static double swing_of(uint32_t trial)
{
    static double places[SWING_CYCLES];
    char order[32];
    random_state = trial;
    start_armed();
    const double stiffness = 0.2 * pow(25.0, (double)random_below(1001U) / 1000.0);
    sim_motor_t *const motor = &rig.box.axes[NEEDLE].motor;
    motor->full_speed_ticks_per_s *= 0.8 + (0.4 * (double)random_below(1001U) / 1000.0);
    count_balance_init(
        &rig.controller.axes[NEEDLE].supervision.sealed.account); /* It is another motor. */
    controller_seal(&rig.controller);
    (void)snprintf(order, sizeof order, "hand stiffness %d", (int)(stiffness * 1000.0));
    rig_box(&rig, order);
    (void)snprintf(order, sizeof order, "hand speed %d", 200 + (int)random_below(2000U));
    rig_box(&rig, order);
    rig_cycles(&rig, 500U + (uint32_t)(1000.0 / stiffness));
    for (uint32_t i = 0U; i < SWING_CYCLES; i++) {
        rig_cycle(&rig);
        places[i] = depth_ticks();
    }
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_MOVING, rig.outputs.snapshot.order);
    return swing_mm(places, SWING_CYCLES);
}

void test_SWR_COOP_011_no_hand_and_needle_swing(void)
{
    double worst = 0.0;
    for (uint32_t trial = 0U; trial < SCENES(SWING_TRIALS); trial++) {
        worst = fmax(worst, swing_of(trial));
    }
    TEST_ASSERT_TRUE(worst <= ((double)LIMIT_HAND_SWING_UM / 1000.0));
}

void test_SWR_COOP_005_the_true_needle_stands_soon_after_the_hand_has_let_go(void)
{
    start_armed();
    push(3000);
    rig_cycles(&rig, 1000U);
    TEST_ASSERT_TRUE(is_driven());
    let_go();
    rig_cycles(&rig, FILTERED_CYCLES + (LIMIT_HAND_OFF_US / LIMIT_CYCLE_US));
    const double there = depth_ticks();
    for (uint32_t i = 0U; i < 2000U; i++) {
        rig_cycle(&rig);
        TEST_ASSERT_FALSE(is_driven());
        TEST_ASSERT_DOUBLE_WITHIN(STILL_TICKS, there, depth_ticks());
    }
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, push_on(800).kind);
}

/* Nobody lets go, or the zero has wandered: a push ends all the same. */
void test_SWR_COOP_013_a_push_without_an_end_moves_the_true_needle_a_bounded_way(void)
{
    start_armed();
    const double there = depth_ticks();
    push(800);
    rig_cycles(&rig, (LIMIT_HAND_PUSH_US / LIMIT_CYCLE_US) + STOP_CYCLES);
    TEST_ASSERT_TRUE((depth_ticks() - there) > (10.0 * TICKS_PER_MM));
    TEST_ASSERT_TRUE((depth_ticks() - there) < (16.0 * TICKS_PER_MM));
    const double stopped = depth_ticks();
    rig_cycles(&rig, 5000U);
    TEST_ASSERT_DOUBLE_WITHIN(STILL_TICKS, stopped, depth_ticks());
    TEST_ASSERT_TRUE(has_reason(PERMIT_REASON_HAND_UNPROVEN));
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_LET_GO, rig.outputs.snapshot.next_step);
}

/* As SWR-FORCE-565 finds it, at rest or at the highest speed, by a hand that jerks or has gone. */
void test_SWR_COOP_016_a_stuck_sensor_moves_the_true_needle_a_short_way(void)
{
    static const uint32_t before_cycles[] = {10U, 100U, 1000U};
    for (uint32_t i = 0U; i < (sizeof before_cycles / sizeof before_cycles[0]); i++) {
        start_armed();
        rig_cycles(&rig, OFF_CYCLES);
        push(JERK_MN);
        rig_cycles(&rig, before_cycles[i]);
        rig_box(&rig, "force hand stuck");
        let_go();
        const double there = depth_ticks();
        for (uint32_t cycle = 0U; (cycle < 2000U) && !is_over(); cycle++) {
            rig_cycle(&rig);
        }
        TEST_ASSERT_TRUE(is_over());
        TEST_ASSERT_EQUAL_UINT32(STATUS_FORCE_DOUBTFUL, rig.answers[rig.answer_count - 1U].status);
        rig_cycles(&rig, STOP_CYCLES);
        TEST_ASSERT_TRUE((depth_ticks() - there) <= (LIMIT_HAND_STUCK_UM * TICKS_PER_MM / 1000.0));
        TEST_ASSERT_TRUE((depth_ticks() - there) > (0.2 * TICKS_PER_MM));
    }
}

/* Load cell with less than a count of noise. */
static void start_quiet(void)
{
    align();
    rig.box.force.cells[SIM_CELL_HAND].config.noise_n = BY_HAND_QUIET_N;
    zero_force();
    TEST_ASSERT_LESS_OR_EQUAL_UINT32(
        LIMIT_FORCE_STILL_NOISE, rig.controller.force.sealed.channels[FORCE_CHANNEL_HAND].noise_q8);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    rig_cycles(&rig, OFF_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, status_of(cooperate));
    rig_press(&rig);
    rig_cycles(&rig, OFF_CYCLES);
}

void test_SWR_COOP_750_a_quiet_sensor_brings_the_needle_to_its_depth(void)
{
    start_quiet();
    TEST_ASSERT_EQUAL_UINT32(ANSWER_DONE, push_on(800).kind);
    TEST_ASSERT_DOUBLE_WITHIN(DEADBAND_TICKS, (double)target_ticks(), depth_ticks());
}

/* Once it works again, the hand has to be seen off. */
void test_SWR_COOP_750_a_quiet_sensor_that_is_stuck_moves_the_needle_a_short_way(void)
{
    start_quiet();
    push(JERK_MN);
    rig_cycles(&rig, 1000U);
    rig_box(&rig, "force hand stuck");
    const double there = depth_ticks();
    rig_cycles(&rig, PUSH_CYCLES);
    TEST_ASSERT_TRUE(has_reason(PERMIT_REASON_HAND_UNPROVEN));
    TEST_ASSERT_TRUE((depth_ticks() - there) <= (LIMIT_HAND_STUCK_UM * TICKS_PER_MM / 1000.0));
    TEST_ASSERT_TRUE((depth_ticks() - there) > (0.2 * TICKS_PER_MM));
    const double stopped = depth_ticks();
    rig_box(&rig, "force hand normal");
    rig_cycles(&rig, OFF_CYCLES);
    TEST_ASSERT_DOUBLE_WITHIN(STILL_TICKS, stopped, depth_ticks());
    let_go();
    rig_cycles(&rig, OFF_CYCLES);
    push(800);
    rig_cycles(&rig, OFF_CYCLES);
    TEST_ASSERT_TRUE(depth_ticks() > (stopped + STILL_TICKS));
    TEST_ASSERT_FALSE(is_over());
}
