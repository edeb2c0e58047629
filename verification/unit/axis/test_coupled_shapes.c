/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: limits of any shape are kept wherever the axes would stop. The robot of this
 * test has three: a sum of two axes, a sum of four, and a saddle of four, which turns around in
 * each of them. The verdict of the guard is compared with each place where the axes might stop.
 */
#include "unity.h"

#include "axis/axis.h"
#include "limits/requirement_limits.h"
#include "robot/coupled_limit.h"
#include "robot/joints.h"
#include "robot/robot_neuro.h"
#include "safety/coupled_guard.h"
#include "unit/support/scenes.h"

#define AXES 4U
#define TICK_NM 1000
#define FULL_SPEED 9000
/* 9000 ticks/s for 4.5 ms, rounded up, and the tick of a count. */
#define DRIVEN_TICKS 42
#define SADDLE_NM INT64_C(50000000)
#define FAR_NM 1000000000

enum { PAIR, FOUR, SADDLE, LIMITS };

static robot_t robot;
static axis_t axes[ROBOT_AXIS_MAX];
static card_drive_t sent[ROBOT_AXIS_MAX];
static card_drive_t requests[ROBOT_AXIS_MAX];
static const coupled_view_t view = {axes, sent, requests};
static uint32_t looks;
static uint32_t seed;

int64_t kinematics_coupled(const robot_t *of, uint32_t index, const joints_t *joints);

/* In the place of what a robot's folder would have. */
int64_t kinematics_coupled(const robot_t *of, uint32_t index, const joints_t *joints)
{
    const int32_t *const q = joints->value;
    int64_t value = (int64_t)q[0] - q[1];
    TEST_ASSERT_EQUAL_PTR(&robot, of);
    looks++;
    if (index == (uint32_t)FOUR) {
        value = ((int64_t)q[0] + q[1] - q[2] - q[3]) / 2;
    } else if (index == (uint32_t)SADDLE) {
        const int64_t up = ((int64_t)q[0] * q[0]) + ((int64_t)q[1] * q[2]);
        value = (up - ((int64_t)q[3] * q[3])) / SADDLE_NM;
    } else {
        TEST_ASSERT_EQUAL_UINT32(PAIR, index);
    }
    return value;
}

static void set_limit(uint32_t index, uint32_t mask, int32_t minimum, int32_t maximum)
{
    coupled_limit_t *const limit = &robot.coupled_limits[index];
    *limit = (coupled_limit_t){.unit = (uint8_t)AXIS_UNIT_MM,
                               .refusal = (uint8_t)(40U + index),
                               .is_curved = (index == (uint32_t)SADDLE) ? 1U : 0U,
                               .axes = mask,
                               .minimum = minimum,
                               .maximum = maximum};
}

void setUp(void)
{
    robot = robot_neuro;
    robot.axis_count = AXES;
    robot.coupled_limit_count = LIMITS;
    set_limit(PAIR, 0x3U, -FAR_NM, FAR_NM);
    set_limit(FOUR, 0xFU, -FAR_NM, FAR_NM);
    set_limit(SADDLE, 0xFU, -FAR_NM, FAR_NM);
    for (uint32_t i = 0U; i < AXES; i++) {
        axis_init(&axes[i]);
        axes[i].chart.reference = AXIS_REFERENCE_VERIFIED;
        robot.axes[i].unit_per_tick_q16 = (int64_t)TICK_NM * 65536;
        robot.axes[i].full_speed_ticks_per_s = FULL_SPEED;
        sent[i] = (card_drive_t){0U, 0U, 0U, 0U};
        requests[i] = sent[i];
    }
    seed = 1U;
}

void tearDown(void)
{
}

static uint32_t draw(uint32_t below)
{
    seed = (seed * 1664525U) + 1013904223U;
    return (uint32_t)(((uint64_t)(seed >> 8U) * below) >> 24U);
}

static card_drive_t drive(uint32_t axis, bool is_upwards)
{
    const bool is_inverted = robot.axes[axis].is_motor_inverted != 0U;
    return (card_drive_t){CARD_DRIVE_PWM, (is_upwards != is_inverted) ? 1U : 0U, 1U, 0U};
}

/* -1, 0 or 1 of a drive. */
static int32_t way_of(uint32_t axis, const card_drive_t *of)
{
    if (of->mode == (uint32_t)CARD_DRIVE_OFF) {
        return 0;
    }
    return motor_model_is_upwards(&robot.axes[axis], of) ? 1 : -1;
}

static int32_t way_ticks(uint32_t axis, int32_t sign)
{
    const bool is_driven =
        (way_of(axis, &sent[axis]) == sign) || (way_of(axis, &requests[axis]) == sign);
    const int64_t measured = (int64_t)axes[axis].sealed.encoder.speed_ticks_per_s_q8 * sign;
    const int64_t full = is_driven ? (FULL_SPEED * INT64_C(256)) : 0;
    const int64_t speed = (measured > full) ? measured : full;
    return 1 + (int32_t)(((speed * (int64_t)LIMIT_COUPLED_STOP_US) + 255999999) / 256000000);
}

static int64_t value_at(uint32_t limit, const int32_t ticks[AXES])
{
    joints_t joints = {{0}};
    for (uint32_t i = 0U; i < AXES; i++) {
        joints.value[i] = ticks[i] * TICK_NM;
    }
    return kinematics_coupled(&robot, limit, &joints);
}

typedef struct {
    int64_t lowest;
    int64_t highest;
    int64_t change[AXES]; /* By the whole way of the request. */
} truth_t;

/* Five places of each way, all with all. */
static truth_t find_truth(uint32_t limit)
{
    truth_t truth = {INT64_MAX, INT64_MIN, {0}};
    int32_t here[AXES];
    for (uint32_t i = 0U; i < AXES; i++) {
        here[i] = axes[i].sealed.encoder.position_ticks;
    }
    const int64_t now = value_at(limit, here);
    for (uint32_t place = 0U; place < 625U; place++) {
        int32_t ticks[AXES];
        uint32_t rest = place;
        for (uint32_t i = 0U; i < AXES; i++) {
            const int32_t part = (int32_t)(rest % 5U) - 2;
            const int32_t way = way_ticks(i, (part < 0) ? -1 : 1);
            ticks[i] = here[i] + ((part * way) / 2);
            rest /= 5U;
        }
        const int64_t value = value_at(limit, ticks);
        truth.lowest = (value < truth.lowest) ? value : truth.lowest;
        truth.highest = (value > truth.highest) ? value : truth.highest;
    }
    for (uint32_t i = 0U; i < AXES; i++) {
        int32_t ticks[AXES];
        for (uint32_t k = 0U; k < AXES; k++) {
            ticks[k] = here[k];
        }
        const int32_t sign = way_of(i, &requests[i]);
        ticks[i] += sign * way_ticks(i, (sign == 0) ? 1 : sign);
        truth.change[i] = value_at(limit, ticks) - now;
    }
    return truth;
}

/* Any drives, and speeds of which some are more than the motor's. */
static void draw_scene(bool may_be_fast)
{
    for (uint32_t i = 0U; i < AXES; i++) {
        const int32_t most = may_be_fast ? 30000 : FULL_SPEED;
        axes[i].sealed.encoder.position_ticks = (int32_t)draw(40000U) - 20000;
        axes[i].sealed.encoder.speed_ticks_per_s_q8 =
            (draw(2U) == 0U) ? 0 : (((int32_t)draw((uint32_t)most * 2U) - most) * 256);
        sent[i] = (draw(2U) == 0U) ? (card_drive_t){0U, 0U, 0U, 0U} : drive(i, draw(2U) == 0U);
        requests[i] = (draw(3U) == 0U) ? (card_drive_t){0U, 0U, 0U, 0U} : drive(i, draw(2U) == 0U);
    }
}

/* `slack`: so much nearer to the ends nothing is asked. Returns how many requests were blocked. */
static uint32_t compare(uint32_t limit, int64_t slack)
{
    const truth_t truth = find_truth(limit);
    const coupled_limit_t *const of = &robot.coupled_limits[limit];
    const uint32_t blocked = coupled_guard_blocks(&robot, &view);
    uint32_t count = 0U;
    for (uint32_t i = 0U; i < AXES; i++) {
        const bool is_on = (way_of(i, &requests[i]) != 0) && coupled_limit_has(of, i);
        const int64_t above = (truth.change[i] > 0) ? (truth.highest - of->maximum) : -FAR_NM;
        const int64_t below = (truth.change[i] < 0) ? (of->minimum - truth.lowest) : -FAR_NM;
        const int64_t beyond = (above > below) ? above : below;
        const bool is_blocked = ((blocked >> i) & 1U) != 0U;
        if (!is_on || (beyond <= -slack)) {
            TEST_ASSERT_FALSE(is_blocked);
        } else if (beyond > 0) {
            TEST_ASSERT_TRUE(is_blocked);
        } else {
            /* So near to the end that both are right. */
        }
        count += is_blocked ? 1U : 0U;
    }
    return count;
}

/* Ends of the range about where the axes are. */
static uint32_t compare_many(uint32_t limit, bool may_be_fast, int64_t slack)
{
    uint32_t count = 0U;
    for (uint32_t i = 0U; i < SCENES(3000U); i++) {
        draw_scene(may_be_fast);
        const truth_t truth = find_truth(limit);
        const int64_t off = (int64_t)draw(300000U) - 150000;
        const bool is_upper = draw(2U) == 0U;
        const int64_t end = is_upper ? (truth.highest - off) : (truth.lowest + off);
        set_limit(limit, robot.coupled_limits[limit].axes, is_upper ? -FAR_NM : (int32_t)end,
                  is_upper ? (int32_t)end : FAR_NM);
        count += compare(limit, slack);
    }
    return count;
}

void test_SWR_COUPLE_005_a_sum_of_two_axes_is_kept_to_the_nanometre(void)
{
    TEST_ASSERT_GREATER_THAN_UINT32(SCENES(500U), compare_many(PAIR, false, 0));
    TEST_ASSERT_GREATER_THAN_UINT32(SCENES(500U), compare_many(PAIR, true, 0));
}

void test_SWR_COUPLE_005_a_sum_of_four_axes_is_kept_to_the_nanometre(void)
{
    /* Halves of nanometres are cut. */
    TEST_ASSERT_GREATER_THAN_UINT32(SCENES(500U), compare_many(FOUR, false, 4));
    TEST_ASSERT_GREATER_THAN_UINT32(SCENES(500U), compare_many(FOUR, true, 4));
}

void test_SWR_COUPLE_005_a_curved_limit_of_four_axes_is_kept(void)
{
    TEST_ASSERT_GREATER_THAN_UINT32(SCENES(500U), compare_many(SADDLE, false, 1000));
    TEST_ASSERT_GREATER_THAN_UINT32(SCENES(500U), compare_many(SADDLE, true, 1000));
}

/* Both ways lead up from 0 of q0 * q0. */
void test_SWR_COUPLE_005_a_limit_that_turns_around_blocks_what_takes_it_further_out_only(void)
{
    set_limit(SADDLE, 0xFU, -FAR_NM, 5000000);
    axes[0].sealed.encoder.position_ticks = 17000;
    requests[0] = drive(0U, true);
    TEST_ASSERT_EQUAL_HEX32(0x1U, coupled_guard_blocks(&robot, &view));
    requests[0] = drive(0U, false);
    TEST_ASSERT_EQUAL_HEX32(0U, coupled_guard_blocks(&robot, &view));
    axes[0].sealed.encoder.position_ticks = -17000;
    TEST_ASSERT_EQUAL_HEX32(0x1U, coupled_guard_blocks(&robot, &view));
    requests[0] = drive(0U, true);
    TEST_ASSERT_EQUAL_HEX32(0U, coupled_guard_blocks(&robot, &view));
}

/* q1 * q2: each alone adds 84 nm to the 200, both together 203. */
void test_SWR_COUPLE_005_what_axes_do_together_counts(void)
{
    axes[1].sealed.encoder.position_ticks = 100;
    axes[2].sealed.encoder.position_ticks = 100;
    requests[1] = drive(1U, true);
    requests[2] = drive(2U, true);
    TEST_ASSERT_EQUAL_INT32(142, 100 + DRIVEN_TICKS);
    set_limit(SADDLE, 0xFU, -FAR_NM, 402);
    TEST_ASSERT_EQUAL_HEX32(0x6U, coupled_guard_blocks(&robot, &view));
    set_limit(SADDLE, 0xFU, -FAR_NM, 403);
    TEST_ASSERT_EQUAL_HEX32(0U, coupled_guard_blocks(&robot, &view));
}

void test_SWR_COUPLE_005_one_look_is_enough_where_no_axis_can_leave(void)
{
    requests[0] = drive(0U, true);
    looks = 0U;
    TEST_ASSERT_EQUAL_HEX32(0U, coupled_guard_blocks(&robot, &view));
    TEST_ASSERT_EQUAL_UINT32(LIMITS, looks);
    requests[0] = (card_drive_t){0U, 0U, 0U, 0U};
    looks = 0U;
    TEST_ASSERT_EQUAL_HEX32(0U, coupled_guard_blocks(&robot, &view));
    TEST_ASSERT_EQUAL_UINT32(0U, looks);
    /* Faster than the margin allows for, up or down. */
    requests[3] = drive(3U, true);
    axes[3].sealed.encoder.speed_ticks_per_s_q8 = FULL_SPEED * 256;
    TEST_ASSERT_EQUAL_HEX32(0U, coupled_guard_blocks(&robot, &view));
    TEST_ASSERT_EQUAL_UINT32(2U, looks);
    axes[3].sealed.encoder.speed_ticks_per_s_q8 = (FULL_SPEED * 256) + 1;
    TEST_ASSERT_EQUAL_HEX32(0U, coupled_guard_blocks(&robot, &view));
    TEST_ASSERT_EQUAL_UINT32(2U + 20U, looks);
    axes[3].sealed.encoder.speed_ticks_per_s_q8 = -(FULL_SPEED * 256) - 1;
    TEST_ASSERT_EQUAL_HEX32(0U, coupled_guard_blocks(&robot, &view));
    TEST_ASSERT_EQUAL_UINT32(2U + 40U, looks);
}

void test_SWR_COUPLE_005_a_limit_of_four_axes_is_in_force_once_all_are_homed(void)
{
    set_limit(FOUR, 0xFU, -FAR_NM, 0);
    requests[0] = drive(0U, true);
    TEST_ASSERT_EQUAL_HEX32(0x1U, coupled_guard_blocks(&robot, &view));
    for (uint32_t i = 0U; i < AXES; i++) {
        axes[i].chart.reference = AXIS_REFERENCE_LOST;
        robot.axes[i].limit_switch = (uint8_t)LIMIT_SWITCH_NONE;
        TEST_ASSERT_EQUAL_HEX32(0U, coupled_guard_blocks(&robot, &view));
        TEST_ASSERT_FALSE(coupled_guard_is_known(&robot, axes, 0U));
        axes[i].chart.reference = AXIS_REFERENCE_VERIFIED;
    }
}

/* The last of four axes that is not homed knows where the others are. */
void test_SWR_COUPLE_003_the_last_axis_of_four_does_not_go_to_a_switch_beyond_the_limit(void)
{
    set_limit(FOUR, 0xFU, -FAR_NM, 1000 * TICK_NM);
    robot.axes[0].limit_switch = (uint8_t)LIMIT_SWITCH_UPPER;
    robot.axes[0].home_ticks = 2000;
    axes[0].chart.reference = AXIS_REFERENCE_LOST;
    requests[0] = drive(0U, true);
    TEST_ASSERT_FALSE(coupled_guard_bars_homing(&robot, axes, 0U));
    TEST_ASSERT_EQUAL_HEX32(0U, coupled_guard_blocks(&robot, &view));
    axes[2].sealed.encoder.position_ticks = -1;
    TEST_ASSERT_TRUE(coupled_guard_bars_homing(&robot, axes, 0U));
    TEST_ASSERT_EQUAL_HEX32(0x1U, coupled_guard_blocks(&robot, &view));
    /* With a second one that is not, it is not known. */
    axes[2].chart.reference = AXIS_REFERENCE_LOST;
    TEST_ASSERT_FALSE(coupled_guard_bars_homing(&robot, axes, 0U));
    TEST_ASSERT_EQUAL_HEX32(0U, coupled_guard_blocks(&robot, &view));
}

void test_SWR_COUPLE_002_each_limit_has_its_own_refusal(void)
{
    joints_t joints = {{0}};
    set_limit(PAIR, 0x3U, -1000000, 1000000);
    set_limit(SADDLE, 0xFU, -FAR_NM, 1000000);
    TEST_ASSERT_EQUAL_UINT8(STATUS_OK, coupled_limit_judge(&robot, &joints).status);
    joints.value[3] = 10000000;
    TEST_ASSERT_EQUAL_UINT8(STATUS_OK, coupled_limit_judge(&robot, &joints).status);
    joints.value[0] = 20000000;
    joints.value[1] = 20000000;
    const solution_t judged = coupled_limit_judge(&robot, &joints);
    TEST_ASSERT_EQUAL_UINT8(40U + SADDLE, judged.status);
    TEST_ASSERT_EQUAL_UINT8(1U, judged.is_maximum);
    joints.value[1] = 21000000;
    TEST_ASSERT_EQUAL_UINT8(40U + PAIR, coupled_limit_judge(&robot, &joints).status);
    TEST_ASSERT_EQUAL_UINT8(0U, coupled_limit_judge(&robot, &joints).is_maximum);
}

void test_SWR_COUPLE_002_an_angle_has_a_margin_of_its_own(void)
{
    coupled_limit_t *const limit = &robot.coupled_limits[PAIR];
    set_limit(PAIR, 0x3U, -10000000, 10000000);
    limit->unit = (uint8_t)AXIS_UNIT_RAD;
    const int64_t most = INT64_C(10000000) - (int64_t)LIMIT_COUPLED_MARGIN_BAM;
    TEST_ASSERT_EQUAL(COUPLED_LIMIT_INSIDE, coupled_limit_side(limit, most));
    TEST_ASSERT_EQUAL(COUPLED_LIMIT_ABOVE, coupled_limit_side(limit, most + 1));
    TEST_ASSERT_EQUAL(COUPLED_LIMIT_INSIDE, coupled_limit_side(limit, -most));
    TEST_ASSERT_EQUAL(COUPLED_LIMIT_BELOW, coupled_limit_side(limit, -most - 1));
}

void test_SWR_COUPLE_004_no_position_is_too_far_to_be_judged(void)
{
    set_limit(PAIR, 0x3U, -1000000, 1000000);
    axes[0].sealed.encoder.position_ticks = INT32_MAX;
    axes[1].sealed.encoder.position_ticks = INT32_MIN;
    axes[0].sealed.encoder.speed_ticks_per_s_q8 = INT32_MAX;
    axes[1].sealed.encoder.speed_ticks_per_s_q8 = INT32_MIN;
    requests[0] = drive(0U, true);
    requests[1] = drive(1U, true);
    robot.coupled_limits[SADDLE].axes = 0U;
    robot.coupled_limits[FOUR].axes = 0U;
    /* Farther than a joint value goes nothing changes any more. */
    TEST_ASSERT_EQUAL_HEX32(0U, coupled_guard_blocks(&robot, &view));
    requests[1] = drive(1U, false);
    axes[0].sealed.encoder.position_ticks = 2000000;
    axes[1].sealed.encoder.position_ticks = -2000000;
    TEST_ASSERT_EQUAL_HEX32(0x3U, coupled_guard_blocks(&robot, &view));
    TEST_ASSERT_EQUAL_UINT8(40U + PAIR, coupled_guard_judge(&robot, axes, 0U, INT32_MIN).status);
}

void test_SWR_AXIS_036_the_first_limit_that_bars_a_homing_is_the_reason(void)
{
    set_limit(PAIR, 0x3U, -1000000, 1000000);
    robot.coupled_limits[FOUR].axes = 0x1U;
    robot.coupled_limits[SADDLE].axes = 0x1U;
    axes[1].chart.reference = AXIS_REFERENCE_LOST;
    looks = 0U;
    TEST_ASSERT_EQUAL(STATUS_NOT_HOMED, coupled_guard_judge_homing(&robot, axes, 0U).status);
    TEST_ASSERT_EQUAL_UINT32(0U, looks);
}
