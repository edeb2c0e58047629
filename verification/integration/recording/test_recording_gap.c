/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: a gap in the recording is reported when it begins and, in the first cycle that
 * is recorded again, with its length; nothing else comes of it.
 */
#include "integration/support/rig.h"

#include "unity.h"

static rig_t rig;

void setUp(void)
{
    rig_start(&rig);
}

void tearDown(void)
{
}

static void lose(uint32_t cycles)
{
    for (uint32_t i = 0U; i < cycles; i++) {
        rig.cycles_lost++;
        rig_cycle(&rig);
    }
}

/* The event of this cycle with `id`; NULL without. */
static const event_t *event_now(event_id_t id)
{
    const event_t *found = NULL;

    for (uint32_t i = 0U; i < rig.outputs.event_count; i++) {
        found = (rig.outputs.events[i].id == (uint32_t)id) ? &rig.outputs.events[i] : found;
    }
    return found;
}

void test_SWR_REC_021_a_gap_is_reported_in_its_first_cycle_and_with_its_length_after_it(void)
{
    lose(1U);
    TEST_ASSERT_NOT_NULL(event_now(EVENT_RECORDING_STOPPED));
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.unrecorded);
    lose(122U);
    TEST_ASSERT_NULL(event_now(EVENT_RECORDING_STOPPED));
    TEST_ASSERT_EQUAL_UINT32(123U, rig.outputs.snapshot.unrecorded);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_RECORDING_RESUMED));
    rig_cycle(&rig);
    TEST_ASSERT_NOT_NULL(event_now(EVENT_RECORDING_RESUMED));
    TEST_ASSERT_EQUAL_INT32(123, event_now(EVENT_RECORDING_RESUMED)->value);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.unrecorded);
    rig_cycles(&rig, 10U);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_RECORDING_STOPPED));
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_RECORDING_RESUMED));
}

void test_SWR_REC_021_the_event_says_whether_the_recorder_does_not_read_or_cannot_write(void)
{
    lose(1U);
    TEST_ASSERT_EQUAL_INT32(0, event_now(EVENT_RECORDING_STOPPED)->value);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.is_recorder_failing);
    rig_cycle(&rig);
    rig.is_recorder_failing = 1U;
    lose(1U);
    TEST_ASSERT_EQUAL_INT32(1, event_now(EVENT_RECORDING_STOPPED)->value);
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.is_recorder_failing);
    rig.is_recorder_failing = 0U;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.is_recorder_failing);
}

/* The minutes that are left; @return whether it is reported that they are few. */
static bool reports_of(uint32_t minutes)
{
    rig.recording_left_min = minutes;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(minutes, rig.outputs.snapshot.recording_left_min);
    const event_t *const event = event_now(EVENT_RECORDING_ENDS_SOON);
    TEST_ASSERT_TRUE((event == NULL) || (event->value == (int32_t)minutes));
    return event != NULL;
}

void test_SWR_REC_036_a_disk_that_is_full_soon_is_logged_once_until_there_is_twice_the_room(void)
{
    const uint32_t limit = LIMIT_RECORDING_LEFT_MIN;

    TEST_ASSERT_FALSE(reports_of(0U));
    TEST_ASSERT_FALSE(reports_of(limit));
    TEST_ASSERT_TRUE(reports_of(limit - 1U));
    rig_cycles(&rig, 10U);
    TEST_ASSERT_FALSE(reports_of(1U));
    TEST_ASSERT_FALSE(reports_of((2U * limit) - 1U));
    TEST_ASSERT_FALSE(reports_of(limit - 1U));
    TEST_ASSERT_FALSE(reports_of(2U * limit));
    TEST_ASSERT_TRUE(reports_of(limit - 1U));
    TEST_ASSERT_FALSE(reports_of(0U));
    TEST_ASSERT_TRUE(reports_of(1U));
    TEST_ASSERT_EQUAL_UINT32(3U, rig_count(&rig, EVENT_RECORDING_ENDS_SOON));
}

/* The next step while the recorder can and cannot write. */
static void expect_steps(next_step_t with, next_step_t without)
{
    rig.is_recorder_failing = 1U;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(without, rig.outputs.snapshot.next_step);
    rig.is_recorder_failing = 0U;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(with, rig.outputs.snapshot.next_step);
}

void test_SWR_REC_034_the_recorder_comes_before_each_command_of_the_plan_at_rest(void)
{
    rig_start_homed(&rig);
    rig_cycles(&rig, 2U);
    expect_steps(NEXT_STEP_PLANNING, NEXT_STEP_RECORDER);
    rig_start_targeted(&rig);
    rig_cycles(&rig, 2U);
    expect_steps(NEXT_STEP_MOVE, NEXT_STEP_RECORDER);
}

void test_SWR_REC_034_who_homes_again_or_moves_or_has_the_needle_in_is_not_sent_to_the_disk(void)
{
    rig_start_moving(&rig);
    expect_steps(NEXT_STEP_HOLD_PEDAL, NEXT_STEP_HOLD_PEDAL);
    rig_box(&rig, "estop pull");
    rig_cycles(&rig, 5U);
    expect_steps(NEXT_STEP_RELEASE_ESTOP, NEXT_STEP_RELEASE_ESTOP);
    rig_box(&rig, "pedal release");
    rig_box(&rig, "estop reset");
    rig_cycles(&rig, 500U);
    expect_steps(NEXT_STEP_START_UP, NEXT_STEP_START_UP);
    rig_start_arrived(&rig);
    expect_steps(NEXT_STEP_NOTHING, NEXT_STEP_NOTHING);
}

void test_SWR_REC_021_each_gap_has_a_length_of_its_own_also_where_the_count_wraps(void)
{
    rig.cycles_lost = UINT32_MAX - 2U; /* It is only counted from here on. */
    rig.controller.cycles_lost = rig.cycles_lost;
    lose(5U);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_INT32(5, event_now(EVENT_RECORDING_RESUMED)->value);
    lose(2U);
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_INT32(2, event_now(EVENT_RECORDING_RESUMED)->value);
}

void test_SWR_REC_021_a_gap_stops_and_refuses_nothing(void)
{
    rig_start_moving(&rig);
    lose(100U);
    TEST_ASSERT_TRUE(rig_is_driving(&rig));
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_STOP).status);
    rig.cycles_lost++;
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
}
