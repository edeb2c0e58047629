/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the rotation of a needle that is steered goes to and fro over whole turns about
 * the direction as the law says, and turns back beyond them; so it is bent by the share of the law
 * along the direction, by nothing across it, and not at all by an even turn.
 */
#include "unity.h"

#include "axis/axis.h"
#include "mode/leg/mode_frame.h"
#include "mode/leg/steer.h"
#include "motion/curv.h"
#include "robot/robot_prostate.h"
#include "robot/steering.h"
#include "unit/support/mode_world.h"

#include <math.h>
#include <string.h>

#define ROTATION PROSTATE_AXIS_ROTATION
#define TICKS_PER_RAD 265.27
#define TICKS_PER_DEG (TICKS_PER_RAD * 3.141592653589793 / 180.0)
#define HALF_TURN_TICKS 833
#define RUN_OUT_TICKS 177 /* 160 of the ramp, a margin of 16, and what is rounded. */
#define TURNS_CYCLES 40000U

static const axis_config_t *const config = &robot_prostate.axes[ROTATION];
static steer_t steer;
static steering_t steering;
/* Over the cycles in which the needle may go in. */
static struct {
    double along;
    double across;
    uint32_t cycles;
    int32_t least_ticks;
    int32_t most_ticks;
    uint32_t reversals;
} seen;

static void set(steering_method_t method, uint32_t alpha_q16, double direction_deg)
{
    steering = (steering_t){.method = (uint32_t)method,
                            .alpha_q16 = alpha_q16,
                            .direction_bam = (int32_t)lround(direction_deg * 4294967296.0 / 360.0)};
}

void setUp(void)
{
    world_start();
    robot = robot_prostate;
    frame.axis_count = robot.axis_count;
    steer = (steer_t){0};
    (void)memset(&seen, 0, sizeof seen);
    seen.least_ticks = INT32_MAX;
    seen.most_ticks = INT32_MIN;
}

void tearDown(void)
{
}

static int32_t place_ticks(void)
{
    return axes[ROTATION].sealed.setpoint_ticks;
}

static int32_t speed_q8(void)
{
    return axes[ROTATION].sealed.setpoint_speed_ticks_per_s_q8;
}

/* Returns whether the needle may go in. */
static bool step(void)
{
    const int32_t before = speed_q8();
    mode_clear(&result);
    const bool may_go_in = steer_step(&steer, &steering, &frame, &result);
    const double away = ((double)place_ticks() / TICKS_PER_RAD) -
                        ((double)steering.direction_bam / 4294967296.0 * 6.283185307179586);
    seen.along += may_go_in ? cos(away) : 0.0;
    seen.across += may_go_in ? sin(away) : 0.0;
    seen.cycles += may_go_in ? 1U : 0U;
    seen.reversals += ((before > 0) && (speed_q8() == 0)) ? 1U : 0U;
    seen.least_ticks = (place_ticks() < seen.least_ticks) ? place_ticks() : seen.least_ticks;
    seen.most_ticks = (place_ticks() > seen.most_ticks) ? place_ticks() : seen.most_ticks;
    return may_go_in;
}

static void steps(uint32_t count)
{
    for (uint32_t i = 0U; i < count; i++) {
        (void)step();
        world_follow();
    }
}

static void expect_share(double expected)
{
    const double along = seen.along / (double)seen.cycles;
    const double across = seen.across / (double)seen.cycles;
    TEST_ASSERT_TRUE(fabs(along - expected) < 0.01);
    TEST_ASSERT_TRUE(fabs(across) < 0.01);
}

/* Over whole turns of the law; what a part of one adds is small among so many. */
void test_SWR_STEER_005_the_needle_is_bent_by_the_share_of_the_law(void)
{
    static const struct {
        uint32_t alpha_q16;
        double share;
    } rows[] = {{0U, 0.0}, {13107U, 0.054}, {32768U, 0.167}, {52429U, 0.375}};
    for (uint32_t i = 0U; i < (sizeof rows / sizeof rows[0]); i++) {
        setUp();
        set(STEERING_BIDIRECTIONAL, rows[i].alpha_q16, 90.0);
        steps(10U * TURNS_CYCLES);
        expect_share(rows[i].share);
    }
}

void test_SWR_STEER_005_it_turns_once_to_and_once_fro_about_the_direction(void)
{
    const int32_t middle_ticks = (int32_t)lround(90.0 * TICKS_PER_DEG);
    set(STEERING_BIDIRECTIONAL, 32768U, 90.0);
    steps(TURNS_CYCLES);
    TEST_ASSERT_GREATER_THAN_UINT32(5U, seen.reversals);
    TEST_ASSERT_INT32_WITHIN(2, middle_ticks + HALF_TURN_TICKS + RUN_OUT_TICKS, seen.most_ticks);
    TEST_ASSERT_INT32_WITHIN(2, middle_ticks - HALF_TURN_TICKS - RUN_OUT_TICKS, seen.least_ticks);
}

/* From 9 turns and three quarters it goes over 9, and not beyond the limits. */
void test_SWR_STEER_005_in_one_direction_it_turns_over_the_range_of_the_axis(void)
{
    set(STEERING_UNIDIRECTIONAL, 32768U, 0.0);
    steps(5U * TURNS_CYCLES);
    TEST_ASSERT_GREATER_THAN_UINT32(1U, seen.reversals);
    TEST_ASSERT_INT32_WITHIN(6, (9 * HALF_TURN_TICKS) + RUN_OUT_TICKS, seen.most_ticks);
    TEST_ASSERT_INT32_WITHIN(6, -(9 * HALF_TURN_TICKS) - RUN_OUT_TICKS, seen.least_ticks);
    expect_share(0.167);
}

/* Near an end of the axis the turn is the next one that has room. */
void test_SWR_STEER_005_it_never_passes_the_limits_of_its_axis(void)
{
    static const int32_t starts[] = {-8073, -7900, 7900, 8073};
    for (uint32_t i = 0U; i < (sizeof starts / sizeof starts[0]); i++) {
        for (double direction_deg = -180.0; direction_deg < 180.0; direction_deg += 45.0) {
            setUp();
            world_put(ROTATION, starts[i]);
            set(STEERING_BIDIRECTIONAL, 32768U, direction_deg);
            steps(TURNS_CYCLES);
            TEST_ASSERT_TRUE(seen.least_ticks >= config->minimum_ticks);
            TEST_ASSERT_TRUE(seen.most_ticks <= config->maximum_ticks);
            TEST_ASSERT_TRUE((seen.most_ticks - seen.least_ticks) < (5 * HALF_TURN_TICKS));
        }
    }
}

void test_SWR_STEER_007_the_needle_waits_while_it_turns_back(void)
{
    set(STEERING_BIDIRECTIONAL, 32768U, 0.0);
    for (uint32_t i = 0U; i < TURNS_CYCLES; i++) {
        const bool may_go_in = step();
        world_follow();
        if (may_go_in) {
            TEST_ASSERT_TRUE(place_ticks() <= (HALF_TURN_TICKS + 1));
            TEST_ASSERT_TRUE(place_ticks() >= (-HALF_TURN_TICKS - 1));
            TEST_ASSERT_NOT_EQUAL_INT32(0, speed_q8());
        }
    }
    TEST_ASSERT_GREATER_THAN_UINT32(5U, seen.reversals);
}

void test_SWR_STEER_007_the_needle_waits_for_a_rotation_that_stands(void)
{
    set(STEERING_BIDIRECTIONAL, 32768U, 0.0);
    steps(500U);
    TEST_ASSERT_TRUE(step());
    uint32_t went_on = 0U;
    for (uint32_t i = 0U; i < 1000U; i++) {
        went_on += step() ? 1U : 0U;
    }
    TEST_ASSERT_LESS_THAN_UINT32(40U, went_on);
}

/* The pedal was released and pressed again, and the axis has rested. */
void test_SWR_STEER_005_it_goes_on_as_it_did_before_a_pause(void)
{
    set(STEERING_BIDIRECTIONAL, 32768U, 0.0);
    steps(TURNS_CYCLES / 4U);
    const int32_t heading = steer.heading;
    const int32_t before = place_ticks();
    for (uint32_t i = 0U; i < 10U; i++) {
        (void)axis_rest(&axes[ROTATION], LIMIT_CYCLE_US);
    }
    (void)step();
    TEST_ASSERT_EQUAL_INT32(heading, steer.heading);
    TEST_ASSERT_INT32_WITHIN(1, before, place_ticks());
    TEST_ASSERT_TRUE((speed_q8() * heading) > 0);
    TEST_ASSERT_TRUE((speed_q8() * heading) <= (config->acceleration_ticks_per_s2 * 256 / 1000));
}

/* It was turned far beyond its turns meanwhile: it comes back. */
void test_SWR_STEER_005_it_comes_back_from_beyond_its_turns(void)
{
    set(STEERING_BIDIRECTIONAL, 32768U, 0.0);
    steps(500U);
    world_put(ROTATION, 4000);
    (void)axis_rest(&axes[ROTATION], LIMIT_CYCLE_US);
    steps(TURNS_CYCLES);
    TEST_ASSERT_TRUE(place_ticks() <= (HALF_TURN_TICKS + RUN_OUT_TICKS));
    TEST_ASSERT_TRUE(seen.most_ticks <= 4000);
}

/* The permit's cap, and that of the law. */
void test_SWR_STEER_011_the_needle_is_as_slow_as_the_robot_says(void)
{
    TEST_ASSERT_EQUAL_UINT32(robot.steering.needle_percent, steer_needle_percent(&frame));
    frame.speed_cap_percent[robot.needle_axis] = 5U;
    TEST_ASSERT_EQUAL_UINT32(5U, steer_needle_percent(&frame));
}
