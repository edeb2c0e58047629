/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: a needle that is steered is bent the wanted way by the wanted share of what its
 * bevel can do, and never goes deeper while its rotation does not turn.
 */
#include "integration/support/by_hand.h"
#include "integration/support/rig.h"

#include "unity.h"

#include "limits/requirement_limits.h"
#include "robot/robot_prostate.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

#define NEEDLE PROSTATE_AXIS_INSERTION
#define ROTATION PROSTATE_AXIS_ROTATION
#define ENTRY_Z_NM 60000000
#define TARGET_Z_NM 110000000
#define LONG_CYCLES 200000U
#define TICKS_PER_RAD 265.27
#define TURN_RAD 6.283185307179586
#define TICKS_PER_MM 1666.67
#define DEADBAND_TICKS 10 /* Of the axis, and what it counts meanwhile. */
#define PER_KM 1200U
/* The law's average over a turn at the strength of 1.2 per m, 0.833: of cos(d), weighted by time.
 */
#define SHARE 0.415
#define SHARE_OFF 0.05
#define PUSH_MN 3000
#define PUSH_CYCLES 5000U
#define SOME_TURNS_CYCLES 15000U
#define STALLS 8U
#define STALL_MM 0.3

static rig_t rig;
/* What the true needle has done, and where its bevel was meanwhile. */
typedef struct {
    double needle_ticks;
    double way_ticks; /* Deeper, in all. */
    double wanted;    /* The part of it along the direction, */
    double across;    /* and across it. */
} witness_t;

static witness_t witness;
static double direction_rad;

void setUp(void)
{
    by_hand_start(&rig, ENTRY_Z_NM, TARGET_Z_NM);
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static double rotation_rad(void)
{
    return rig.box.axes[ROTATION].motor.position_ticks / TICKS_PER_RAD;
}

static uint32_t steer(steering_method_t method, uint32_t per_km, int32_t direction_deg)
{
    const command_t command = {.kind = (uint32_t)COMMAND_STEER,
                               .as.steering = {.method = (uint32_t)method,
                                               .curvature_per_km = per_km,
                                               .direction_deg = direction_deg}};
    direction_rad = (double)direction_deg * TURN_RAD / 360.0;
    return rig_command(&rig, command).status;
}

static void cycle(void)
{
    rig_cycle(&rig);
    const double before = witness.needle_ticks;
    witness.needle_ticks = rig.box.axes[NEEDLE].motor.position_ticks;
    const double way = witness.needle_ticks - before;
    const double away = rotation_rad() - direction_rad;
    witness.way_ticks += way;
    witness.wanted += way * cos(away);
    witness.across += way * sin(away);
}

static bool is_over(void)
{
    return rig.outputs.snapshot.order == (uint32_t)ARMING_STATE_NONE;
}

static void begin(const command_t *order)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    rig_cycles(&rig, BY_HAND_OFF_CYCLES);
    if (order != NULL) {
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, *order).status);
    }
    rig_press(&rig);
    witness = (witness_t){.needle_ticks = rig.box.axes[NEEDLE].motor.position_ticks};
}

static void expect_bent(void)
{
    TEST_ASSERT_TRUE(is_over());
    TEST_ASSERT_INT32_WITHIN(DEADBAND_TICKS, rig.controller.plan.target_ticks[NEEDLE],
                             rig_position(&rig, NEEDLE));
    TEST_ASSERT_TRUE(fabs((witness.wanted / witness.way_ticks) - SHARE) < SHARE_OFF);
    TEST_ASSERT_TRUE(fabs(witness.across / witness.way_ticks) < SHARE_OFF);
}

static void insert(const command_t *order)
{
    begin(order);
    for (uint32_t i = 0U; (i < LONG_CYCLES) && !is_over(); i++) {
        cycle();
    }
    expect_bent();
}

void test_SWR_STEER_008_a_move_bends_the_needle_the_wanted_way(void)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, steer(STEERING_BIDIRECTIONAL, PER_KM, 90));
    insert(NULL);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_STEERING_TAKEN));
}

void test_SWR_STEER_008_an_insertion_bends_the_needle_the_wanted_way(void)
{
    const command_t order = {.kind = (uint32_t)COMMAND_INSERT};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, steer(STEERING_UNIDIRECTIONAL, PER_KM, -135));
    insert(&order);
}

/* The hand pushes all the time but where no push may last longer. */
void test_SWR_STEER_008_a_push_bends_the_needle_the_wanted_way(void)
{
    const command_t order = {.kind = (uint32_t)COMMAND_COOPERATE};
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, steer(STEERING_BIDIRECTIONAL, PER_KM, 10));
    begin(&order);
    for (uint32_t i = 0U; (i < LONG_CYCLES) && !is_over(); i++) {
        if ((i % PUSH_CYCLES) == 0U) {
            by_hand_push(&rig, PUSH_MN);
        } else if ((i % PUSH_CYCLES) == (PUSH_CYCLES - BY_HAND_OFF_CYCLES)) {
            rig_box(&rig, "hand release");
        } else {
            /* As it is. */
        }
        cycle();
    }
    expect_bent();
}

void test_SWR_STEER_011_a_turn_advances_the_needle_by_no_more_than_its_limit(void)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, steer(STEERING_BIDIRECTIONAL, PER_KM, 90));
    begin(NULL);
    double needle_ticks = 0.0;
    double last_rad = rotation_rad();
    for (uint32_t i = 0U; i < SOME_TURNS_CYCLES; i++) {
        cycle();
        if ((last_rad < direction_rad) && (rotation_rad() >= direction_rad)) {
            TEST_ASSERT_TRUE(((witness.needle_ticks - needle_ticks) / TICKS_PER_MM) <=
                             (2.0 * (double)LIMIT_STEERING_ADVANCE_UM / 1000.0));
            needle_ticks = witness.needle_ticks;
        }
        last_rad = rotation_rad();
    }
    TEST_ASSERT_TRUE(needle_ticks > 0.0);
}

/* Its motor turns no more: the needle stops, and no order goes on. */
void test_SWR_STEER_006_a_rotation_that_stalls_stops_the_needle(void)
{
    for (uint32_t trial = 0U; trial < STALLS; trial++) {
        by_hand_start(&rig, ENTRY_Z_NM, TARGET_Z_NM);
        TEST_ASSERT_EQUAL_UINT32(STATUS_OK, steer(STEERING_BIDIRECTIONAL, PER_KM, 90));
        begin(NULL);
        for (uint32_t i = 0U; i < (1000U + (trial * 211U)); i++) {
            cycle();
        }
        rig_box(&rig, "motor 0 stuck");
        const double at_ticks = witness.needle_ticks;
        for (uint32_t i = 0U; i < 2000U; i++) {
            cycle();
        }
        TEST_ASSERT_TRUE((witness.needle_ticks - at_ticks) <= (STALL_MM * TICKS_PER_MM));
        TEST_ASSERT_TRUE(is_over());
    }
}

void test_SWR_STEER_002_what_cannot_be_is_refused_and_the_old_stands(void)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, steer(STEERING_BIDIRECTIONAL, PER_KM, 90));
    TEST_ASSERT_EQUAL_UINT32(STATUS_STEERING_CURVATURE, steer(STEERING_BIDIRECTIONAL, 5000U, 0));
    TEST_ASSERT_EQUAL_UINT32(STATUS_UNKNOWN_COMMAND, steer(STEERING_METHOD_COUNT, 0U, 0));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_MOTION_ARMED, steer(STEERING_NONE, 0U, 0));
    TEST_ASSERT_EQUAL_UINT32(PER_KM, rig.outputs.snapshot.steering_curvature_per_km);
    TEST_ASSERT_EQUAL_INT32(90, rig.outputs.snapshot.steering_direction_deg);
    TEST_ASSERT_EQUAL_UINT32(STEERING_BIDIRECTIONAL, rig.outputs.snapshot.steering_method);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_STOP).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_WRONG_WORKPHASE, steer(STEERING_NONE, 0U, 0));
}

void test_SWR_STEER_002_a_robot_without_it_and_one_without_a_target_refuse_it(void)
{
    rig_start_targeted(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_STEERING, steer(STEERING_BIDIRECTIONAL, PER_KM, 90));
    by_hand_start(&rig, ENTRY_Z_NM, TARGET_Z_NM);
    rigid_t pose;
    rigid_set_identity(&pose);
    rig_register(&rig, &pose);
    TEST_ASSERT_EQUAL_UINT32(STATUS_NO_TARGET, steer(STEERING_BIDIRECTIONAL, PER_KM, 90));
}

void test_SWR_STEER_009_another_target_is_not_steered_to(void)
{
    const rigid_t target = rig.controller.plan.scanner_target;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, steer(STEERING_BIDIRECTIONAL, PER_KM, 90));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_target(&rig, &target).status);
    TEST_ASSERT_EQUAL_UINT32(STEERING_NONE, rig.outputs.snapshot.steering_method);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_STEERING_FORGOTTEN));
}

void test_SWR_STEER_009_a_needle_that_was_steered_and_no_more_is_reported_once(void)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, steer(STEERING_BIDIRECTIONAL, PER_KM, 90));
    rig_cycles(&rig, 3U);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, steer(STEERING_NONE, 0U, 0));
    rig_cycles(&rig, 3U);
    TEST_ASSERT_EQUAL_UINT32(2U, rig_count(&rig, EVENT_STEERING_TAKEN));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_STEERING_FORGOTTEN));
}
