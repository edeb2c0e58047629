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
#include "safety/permit.h"

#include <math.h>
#include <stdio.h>

#define NEEDLE PROSTATE_AXIS_INSERTION
#define ROTATION PROSTATE_AXIS_ROTATION
#define ENTRY_Z_NM 60000000
#define TARGET_Z_NM 110000000
#define LONG_CYCLES 200000U
#define TICKS_PER_RAD 265.27
#define TURN_RAD 6.283185307179586

static rig_t rig;
/* What the true needle and the true rotation have done. */
static struct {
    double needle_ticks;
    double way_ticks;  /* Deeper, in all. */
    double wanted;     /* The part of it along the direction, */
    double across;     /* and across it. */
    double least_rad;  /* Ends of the rotation. */
    double most_rad;
} witness;
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
    witness.least_rad = fmin(witness.least_rad, rotation_rad());
    witness.most_rad = fmax(witness.most_rad, rotation_rad());
}

static void insert(void)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MOVE_TO_TARGET).status);
    rig_press(&rig);
    witness.needle_ticks = rig.box.axes[NEEDLE].motor.position_ticks;
    uint32_t used = 0;
    for (uint32_t i = 0U; (i < LONG_CYCLES) && (rig.outputs.snapshot.order != (uint32_t)ARMING_STATE_NONE); i++) {
        cycle();
        used++;
        if (i % 500 == 0) printf("%u needle %.0f rot %.2f rad set %d v %.0f awaited %u reasons %x\n", i, witness.needle_ticks, rotation_rad(), rig.outputs.snapshot.axes[ROTATION].setpoint_ticks, rig.outputs.snapshot.axes[ROTATION].setpoint_speed_ticks_per_s_q8/256.0, rig.outputs.snapshot.is_rotation_awaited, rig.outputs.snapshot.axes[NEEDLE].permit_reasons);
    }
    printf("cycles %u way %.0f share %.3f across %.3f, %.2f to %.2f rad\n", used, witness.way_ticks, witness.wanted / witness.way_ticks, witness.across / witness.way_ticks, witness.least_rad, witness.most_rad);
}

void test_SWR_STEER_008_the_needle_is_bent_the_wanted_way(void)
{
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, steer(STEERING_BIDIRECTIONAL, 1200U, 90));
    insert();
}
