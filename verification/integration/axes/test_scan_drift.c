/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: counts that a scan leaves in a coarse encoder are no reason to doubt where the
 * needle's tip is.
 */
#include "integration/support/rig.h"

#include "robot/robot_prostate.h"
#include "unit/support/scenes.h"
#include "unity.h"

#include <stdlib.h>

#define SCAN_CYCLES SCENES(60000U)

static rig_t rig;

void setUp(void)
{
    if (ARE_SCENES_WHOLE) {
        rig_start_robot_homed(&rig, rig_short_prostate());
    } else {
        rig_start_robot_needle_homed(&rig, &robot_prostate);
    }
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

static void scan_for_a_minute(uint32_t noise)
{
    rig.box.axes[PROSTATE_AXIS_ROTATION].encoder.random.state = noise;
    rig_box(&rig, "scanner on");
    rig_cycles(&rig, SCAN_CYCLES);
    rig_box(&rig, "scanner off");
    rig_cycles(&rig, 3U);
}

static int32_t drifted_ticks(void)
{
    return rig.controller.axes[PROSTATE_AXIS_ROTATION].sealed.drift.idle_ticks;
}

void test_SWR_AXIS_022_a_minute_of_a_scan_leaves_a_coarse_rotation_verified(void)
{
    scan_for_a_minute(126704U);
    TEST_ASSERT_GREATER_THAN_INT32(ARE_SCENES_WHOLE ? 4 : -1, abs(drifted_ticks()));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_AXIS_DRIFTED));
    TEST_ASSERT_TRUE(axis_is_homed(&rig.controller.axes[PROSTATE_AXIS_ROTATION]));
    TEST_ASSERT_EQUAL_UINT32(ARE_SCENES_WHOLE ? 1U : 0U, rig.outputs.snapshot.is_homed);
}

void test_SWR_AXIS_016_the_trembling_of_a_coarse_rotation_in_a_scan_is_no_motion(void)
{
    scan_for_a_minute(79190U);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_AXIS_MOVED_OFF));
    TEST_ASSERT_TRUE(axis_is_homed(&rig.controller.axes[PROSTATE_AXIS_ROTATION]));
}

void test_SWR_AXIS_016_a_rotation_that_moves_while_off_is_a_fault(void)
{
    rig_box(&rig, "motor rotation runs");
    rig_cycles(&rig, 40U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_MOVED_OFF));
    TEST_ASSERT_FALSE(axis_is_homed(&rig.controller.axes[PROSTATE_AXIS_ROTATION]));
}
