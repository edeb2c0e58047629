/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: the first START_UP of a run is refused while nothing is recorded, unless an
 * engineer accepts that; never a later one, never while the needle is not known to be out, and
 * nothing else is.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "robot/robot_neuro.h"

#include <string.h>

#define NEEDLE NEURO_AXIS_INSERTION
#define POWER_ON 0xCAFE0001U

static rig_t rig;
static kept_positions_t kept;

void setUp(void)
{
    rig_start(&rig);
    kept = (kept_positions_t){.power_on = POWER_ON, .verdict = (uint32_t)KEPT_GOOD};
}

void tearDown(void)
{
}

static status_t start_up(void)
{
    return (status_t)rig_workphase(&rig, WORKPHASE_START_UP).status;
}

static status_t accept(void)
{
    const command_t command = {.kind = (uint32_t)COMMAND_ACCEPT_NO_BLACK_BOX};
    return (status_t)rig_command(&rig, command).status;
}

static void expect_step(next_step_t step)
{
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(step, rig.outputs.snapshot.next_step);
}

/* Programs that end and start again in the same power-on, without a recorder that writes; of the
 * needle `grade` is kept, `in_ticks` from home, and it has counted `way_ticks` since. The others
 * were not known. */
static void restart(kept_grade_t grade, int32_t in_ticks, int32_t way_ticks)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const snapshot_axis_t *const shown = &rig.outputs.snapshot.axes[i];
        kept.axes[i] = (kept_axis_t){.grade = (uint32_t)KEPT_FRESH,
                                     .position_ticks = shown->position_ticks,
                                     .reading_ticks = shown->reading_ticks};
    }
    kept.axes[NEEDLE].grade = (uint32_t)grade;
    kept.axes[NEEDLE].position_ticks = robot_neuro.axes[NEEDLE].home_ticks + in_ticks;
    kept.axes[NEEDLE].reading_ticks -= way_ticks;
    box_advance(&rig.box, 20000U);
    (void)memset(&rig.outputs, 0, sizeof rig.outputs);
    controller_init(&rig.controller, &robot_neuro);
    controller_restore(&rig.controller, &kept);
    rig_forget(&rig);
    rig.lacks_black_box = 1U;
    rig_cycles(&rig, 50U);
}

void test_SWR_NEXT_027_the_first_start_up_without_a_recording_is_refused_and_clears_nothing(void)
{
    rig.lacks_black_box = 1U;
    TEST_ASSERT_EQUAL(STATUS_NO_BLACK_BOX, start_up());
    TEST_ASSERT_EQUAL_UINT32(WORKPHASE_UNDEFINED, rig.outputs.snapshot.workphase);
    TEST_ASSERT_EQUAL_UINT32(ESTOP_LATCH_STATE_LATCHED, rig.outputs.snapshot.estop);
    rig.lacks_black_box = 0U;
    TEST_ASSERT_EQUAL(STATUS_OK, start_up());
}

void test_SWR_NEXT_027_nothing_but_start_up_is_refused(void)
{
    rig.lacks_black_box = 1U;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_EMERGENCY).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_STOP).status);
}

void test_SWR_NEXT_027_a_later_one_is_not_refused_also_after_the_e_stop(void)
{
    TEST_ASSERT_EQUAL(STATUS_OK, start_up());
    rig.lacks_black_box = 1U;
    TEST_ASSERT_EQUAL(STATUS_OK, start_up());
    rig_box(&rig, "estop pull");
    rig_cycles(&rig, 100U);
    rig_box(&rig, "estop reset");
    rig_cycles(&rig, 500U);
    expect_step(NEXT_STEP_START_UP);
    TEST_ASSERT_EQUAL(STATUS_OK, start_up());
}

void test_SWR_NEXT_027_one_that_was_refused_for_something_else_settles_nothing(void)
{
    rig_box(&rig, "card yaw silent");
    rig_cycles(&rig, 100U);
    TEST_ASSERT_EQUAL(STATUS_HARDWARE_NOT_READY, start_up());
    rig_box(&rig, "card yaw normal");
    rig_cycles(&rig, 100U);
    rig.lacks_black_box = 1U;
    TEST_ASSERT_EQUAL(STATUS_NO_BLACK_BOX, start_up());
}

void test_SWR_NEXT_028_the_next_step_names_it_until_it_is_mended_or_accepted(void)
{
    rig.lacks_black_box = 1U;
    rig.is_recorder_failing = 1U;
    expect_step(NEXT_STEP_NO_BLACK_BOX);
    rig.lacks_black_box = 0U;
    rig.is_recorder_failing = 0U;
    expect_step(NEXT_STEP_START_UP);
    rig.lacks_black_box = 1U;
    rig.is_recorder_failing = 1U;
    expect_step(NEXT_STEP_NO_BLACK_BOX);
    TEST_ASSERT_EQUAL(STATUS_OK, accept());
    expect_step(NEXT_STEP_START_UP);
}

void test_SWR_CMD_006_what_is_accepted_is_logged_and_counts_for_the_run(void)
{
    rig.lacks_black_box = 1U;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL(STATUS_OK, accept());
    TEST_ASSERT_EQUAL_UINT32(EVENT_NO_BLACK_BOX_ACCEPTED, rig.outputs.events[0].id);
    TEST_ASSERT_EQUAL_UINT32(EVENT_CAUSE_CONSOLE, rig.outputs.events[0].cause);
    TEST_ASSERT_EQUAL_UINT32(RIG_PAGE, rig.outputs.events[0].peer);
    TEST_ASSERT_EQUAL(STATUS_OK, start_up());
}

void test_SWR_CMD_006_nothing_is_accepted_ahead_or_twice(void)
{
    TEST_ASSERT_EQUAL(STATUS_BLACK_BOX_THERE, accept());
    rig.lacks_black_box = 1U;
    TEST_ASSERT_EQUAL(STATUS_NO_BLACK_BOX, start_up());
    TEST_ASSERT_EQUAL(STATUS_OK, accept());
    TEST_ASSERT_EQUAL(STATUS_BLACK_BOX_THERE, accept());
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_NO_BLACK_BOX_ACCEPTED));
}

void test_SWR_NEXT_029_a_needle_that_was_parked_or_is_out_by_its_counts_is_out(void)
{
    restart(KEPT_KNOWN, 0, 0);
    TEST_ASSERT_EQUAL_UINT32(AXIS_REFERENCE_UNVERIFIED,
                             rig.outputs.snapshot.axes[NEEDLE].reference);
    TEST_ASSERT_EQUAL(STATUS_NO_BLACK_BOX, start_up());
    restart(KEPT_FRESH, 0, 0);
    TEST_ASSERT_EQUAL(STATUS_NO_BLACK_BOX, start_up());
}

void test_SWR_NEXT_029_where_the_needle_may_be_in_start_up_is_not_refused(void)
{
    const int32_t deep_ticks = robot_neuro.axes[NEEDLE].maximum_ticks / 2;
    const int32_t moved_ticks = deep_ticks;

    restart(KEPT_KNOWN, deep_ticks, 0);
    TEST_ASSERT_EQUAL(STATUS_OK, start_up());
    restart(KEPT_LOST, 0, 0);
    TEST_ASSERT_EQUAL(STATUS_OK, start_up());
    restart(KEPT_FRESH, 0, moved_ticks);
    TEST_ASSERT_EQUAL(STATUS_OK, start_up());
    /* Where its counts have it now says nothing: its counter may have been set to 0. */
    restart(KEPT_KNOWN, deep_ticks, -moved_ticks);
    TEST_ASSERT_EQUAL(STATUS_OK, start_up());
}

void test_SWR_NEXT_029_before_what_was_kept_is_compared_nothing_is_known(void)
{
    rig_box(&rig, "card yaw silent");
    rig_cycles(&rig, 100U);
    restart(KEPT_KNOWN, 0, 0);
    TEST_ASSERT_EQUAL(STATUS_HARDWARE_NOT_READY, start_up());
    TEST_ASSERT_EQUAL(STATUS_BLACK_BOX_THERE, accept());
    rig_box(&rig, "card yaw normal");
    rig_cycles(&rig, 100U);
    TEST_ASSERT_EQUAL(STATUS_NO_BLACK_BOX, start_up());
}

void test_SWR_NEXT_029_memory_that_is_damaged_never_leads_to_a_refusal(void)
{
    TEST_ASSERT_EQUAL(STATUS_OK, start_up());
    rig.lacks_black_box = 1U;
    rig.controller.sealed.is_box_settled ^= 1U;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_MEMORY_DAMAGED));
    TEST_ASSERT_NOT_EQUAL(STATUS_NO_BLACK_BOX, start_up());
}

void test_SWR_NEXT_029_a_robot_that_is_not_known_is_not_asked_where_its_needle_is(void)
{
    rig.lacks_black_box = 1U;
    rig.robot.needle_axis = UINT32_MAX;
    rig_cycle(&rig);
    TEST_ASSERT_EQUAL(STATUS_MEMORY_DAMAGED, start_up());
}
