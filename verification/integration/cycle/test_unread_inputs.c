/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: an input of the box that is not read stops as one that is low does, and it
 * is not reported as low: the e-stop was not pulled, no scan has begun.
 */
#include "integration/support/rig.h"

#include "unity.h"

static rig_t rig;

void setUp(void)
{
    rig_start_moving(&rig);
    rig_forget(&rig);
}

void tearDown(void)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(0U, rig.driven_without_pedal, "driven without the pedal");
}

/* The board reads all but these BSP_IN_ bits. */
static void leave_out(uint32_t unread)
{
    rig.unread = unread;
    rig_cycle(&rig);
}

static uint32_t reasons(void)
{
    return rig.outputs.snapshot.axes[0].permit_reasons;
}

static uint32_t cause_of(event_id_t id)
{
    const uint32_t first = (rig.event_count > RIG_EVENTS) ? (rig.event_count - RIG_EVENTS) : 0U;
    for (uint32_t i = rig.event_count; i > first; i--) {
        const event_t *const event = &rig.events[(i - 1U) % RIG_EVENTS];
        if (event->id == (uint32_t)id) {
            return event->cause;
        }
    }
    return UINT32_MAX;
}

void test_SWR_EVENT_030_a_box_that_is_not_heard_is_reported_as_that_alone(void)
{
    leave_out(BSP_IN_ALL);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_INPUTS_UNREAD));
    TEST_ASSERT_EQUAL_UINT32(EVENT_CAUSE_INPUTS, cause_of(EVENT_PEDAL_RELEASED));
    TEST_ASSERT_EQUAL_UINT32(EVENT_CAUSE_INPUTS, cause_of(EVENT_WORKPHASE));
    TEST_ASSERT_EQUAL_UINT32(EVENT_CAUSE_INPUTS, cause_of(EVENT_ORDER_DISCARDED));
    rig_cycles(&rig, 100U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_INPUTS_UNREAD));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_ESTOP_PULLED));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_SCANNER));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_SCAN_DRIFT));
    rig_release(&rig);
    leave_out(0U);
    rig_cycles(&rig, 100U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_INPUTS_READ));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_ESTOP_PULLED));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_ESTOP_RELEASED));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_SCANNER));
}

void test_SWR_EVENT_030_what_stops_is_as_strict_as_a_cut_wire(void)
{
    leave_out(BSP_IN_ALL);
    const snapshot_t *const shown = &rig.outputs.snapshot;
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_EMERGENCY, shown->workphase);
    TEST_ASSERT_EQUAL_UINT32(ARMING_STATE_NONE, shown->order);
    TEST_ASSERT_EQUAL_UINT32(AXIS_POWER_DISABLED, shown->axes[0].power);
    TEST_ASSERT_EQUAL_UINT32(STATUS_HARDWARE_NOT_READY,
                             rig_workphase(&rig, WORKPHASE_START_UP).status);
    leave_out(0U);
    rig_cycles(&rig, 20U);
    TEST_ASSERT_EQUAL_UINT32(ESTOP_LATCH_STATE_LATCHED, shown->estop);
    rig_press(&rig);
    rig_cycles(&rig, 300U);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    rig_release(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
}

void test_SWR_PERMIT_040_reason_and_next_step_are_the_box(void)
{
    const snapshot_t *const shown = &rig.outputs.snapshot;
    leave_out(BSP_IN_ALL);
    TEST_ASSERT_EQUAL_HEX32((1U << BOX_INPUT_COUNT) - 1U, shown->unread_inputs);
    TEST_ASSERT_EQUAL_HEX32((1UL << PERMIT_REASON_INPUTS_UNREAD) |
                                (1UL << PERMIT_REASON_AXIS_DISABLED) |
                                (1UL << PERMIT_REASON_NOTHING_ARMED),
                            reasons());
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_CHECK_BOX, shown->next_step);
    TEST_ASSERT_EQUAL_UINT32(0U, shown->is_scanner_active);
    leave_out(0U);
    rig_cycles(&rig, 20U);
    TEST_ASSERT_EQUAL_HEX32(0U, shown->unread_inputs);
    TEST_ASSERT_BITS_LOW(1UL << PERMIT_REASON_INPUTS_UNREAD, reasons());
    TEST_ASSERT_BITS_HIGH(1UL << PERMIT_REASON_ESTOP_LATCHED, reasons());
}

void test_SWR_EVENT_030_an_e_stop_that_was_pulled_meanwhile_is_reported_once_it_is_read(void)
{
    leave_out(BSP_IN_ALL);
    rig_box(&rig, "estop pull");
    rig_cycles(&rig, 50U);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_ESTOP_PULLED));
    leave_out(0U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ESTOP_PULLED));
    TEST_ASSERT_BITS_HIGH(1UL << PERMIT_REASON_ESTOP_PULLED, reasons());
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_RELEASE_ESTOP, rig.outputs.snapshot.next_step);
    rig_box(&rig, "estop reset");
    rig_cycles(&rig, 20U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ESTOP_RELEASED));
}

void test_SWR_EVENT_030_an_e_stop_that_was_pulled_before_is_reported_once(void)
{
    rig_box(&rig, "estop pull");
    rig_cycles(&rig, 20U);
    leave_out(BSP_IN_ALL);
    rig_cycles(&rig, 50U);
    leave_out(0U);
    rig_cycles(&rig, 20U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ESTOP_PULLED));
    leave_out(BSP_IN_ALL);
    rig_box(&rig, "estop reset");
    leave_out(0U);
    rig_cycles(&rig, 20U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ESTOP_PULLED));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_ESTOP_RELEASED));
}

void test_SWR_EVENT_030_a_scan_that_has_begun_meanwhile_is_reported_once_it_is_read(void)
{
    leave_out(BSP_IN_SCANNER_IDLE);
    rig_box(&rig, "scanner on");
    rig_cycles(&rig, 50U);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_SCANNER));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_INPUTS_UNREAD));
    leave_out(0U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_SCANNER));
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_scanner_active);
}

void test_SWR_PERMIT_041_a_pedal_that_was_held_meanwhile_must_be_seen_released_first(void)
{
    leave_out(BSP_IN_PEDAL_B);
    rig_cycles(&rig, 50U);
    TEST_ASSERT_NOT_EQUAL_UINT32(ARMING_STATE_NONE, rig.outputs.snapshot.order);
    rig_forget(&rig);
    leave_out(0U);
    rig_cycles(&rig, 300U);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_PEDAL_PRESSED));
    TEST_ASSERT_EQUAL_UINT32(NEXT_STEP_RELEASE_PEDAL, rig.outputs.snapshot.next_step);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    rig_release(&rig);
    rig_press(&rig);
    rig_cycles(&rig, 300U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
}

void test_SWR_EVENT_030_one_input_after_the_other_is_one_trouble(void)
{
    leave_out(BSP_IN_PEDAL_A);
    TEST_ASSERT_FALSE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(EVENT_CAUSE_INPUTS, cause_of(EVENT_PEDAL_RELEASED));
    leave_out(BSP_IN_PEDAL_A | BSP_IN_ESTOP_CHAIN);
    leave_out(BSP_IN_ESTOP_CHAIN);
    leave_out(0U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_INPUTS_UNREAD));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_INPUTS_READ));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_ESTOP_PULLED));
}
