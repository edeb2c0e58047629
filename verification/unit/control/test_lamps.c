/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: the lamps of the box say what the snapshot of the cycle says. */
#include "unity.h"

#include "bsp.h"
#include "control/lamps.h"

#include <string.h>

#define REASON(name) (1U << (uint32_t)PERMIT_REASON_##name)

static snapshot_t snapshot;

void setUp(void)
{
    (void)memset(&snapshot, 0, sizeof snapshot);
    snapshot.axis_count = 2U;
    snapshot.axes[0].permit_reasons = REASON(NOTHING_ARMED) | REASON(PEDAL_RELEASED);
    snapshot.axes[1].permit_reasons = REASON(NOTHING_ARMED) | REASON(PEDAL_RELEASED);
}

void tearDown(void)
{
}

void test_SWR_BSP_002_at_rest_only_alive_is_lit(void)
{
    TEST_ASSERT_EQUAL_HEX32(BSP_LAMP_ALIVE, lamps_of(&snapshot));
}

void test_SWR_BSP_002_what_the_pedal_would_move_is_shown_before_and_while_it_moves(void)
{
    snapshot.axes[1].permit_reasons = REASON(PEDAL_RELEASED);
    TEST_ASSERT_EQUAL_HEX32(BSP_LAMP_ALIVE | BSP_LAMP_MAY_MOVE, lamps_of(&snapshot));
    snapshot.axes[1].permit_reasons = 0U;
    snapshot.axes[1].drive_mode = 1U;
    TEST_ASSERT_EQUAL_HEX32(BSP_LAMP_ALIVE | BSP_LAMP_MAY_MOVE | BSP_LAMP_MOVING,
                            lamps_of(&snapshot));
}

void test_SWR_BSP_002_what_a_hand_would_move_is_shown_before_it_pushes(void)
{
    snapshot.axes[1].permit_reasons =
        REASON(PEDAL_RELEASED) | REASON(HAND_UNPROVEN) | REASON(HAND_OFF);
    TEST_ASSERT_EQUAL_HEX32(BSP_LAMP_ALIVE | BSP_LAMP_MAY_MOVE, lamps_of(&snapshot));
    snapshot.axes[1].permit_reasons = REASON(HAND_OFF);
    TEST_ASSERT_EQUAL_HEX32(BSP_LAMP_ALIVE | BSP_LAMP_MAY_MOVE, lamps_of(&snapshot));
    snapshot.axes[1].permit_reasons = REASON(AT_DEPTH);
    TEST_ASSERT_EQUAL_HEX32(BSP_LAMP_ALIVE, lamps_of(&snapshot));
}

void test_SWR_BSP_002_a_fault_or_the_emergency_stop_is_shown_and_a_scan_is_none(void)
{
    static const uint32_t faults[] = {
        REASON(ESTOP_PULLED), REASON(ESTOP_LATCHED), REASON(LOOP_STOPPED), REASON(LINK_LOST),
        REASON(PEDAL_FAULT),  REASON(AXIS_FAULT),    REASON(MEMORY),       REASON(FORCE_DOUBTFUL)};
    for (uint32_t i = 0U; i < (sizeof faults / sizeof faults[0]); i++) {
        snapshot.axes[0].permit_reasons = faults[i];
        TEST_ASSERT_EQUAL_HEX32(BSP_LAMP_ALIVE | BSP_LAMP_FAULT, lamps_of(&snapshot));
    }
    snapshot.axes[0].permit_reasons = REASON(SCANNER_ACTIVE) | REASON(AXIS_DISABLED);
    TEST_ASSERT_EQUAL_HEX32(BSP_LAMP_ALIVE, lamps_of(&snapshot));
}

void test_SWR_BSP_002_an_axis_that_the_robot_does_not_have_lights_nothing(void)
{
    snapshot.axis_count = 1U;
    snapshot.axes[1].permit_reasons = 0U;
    snapshot.axes[1].drive_mode = 1U;
    TEST_ASSERT_EQUAL_HEX32(BSP_LAMP_ALIVE, lamps_of(&snapshot));
}
