/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: over a restart of the programs a position lives on as unverified, and only if
 * the counts agree; whatever speaks against it makes the axis lost, and nothing makes it fresh
 * again.
 */
#include "integration/support/rig.h"

#include "unity.h"

#include "controller/controller.h"
#include "replay/verify/replay.h"
#include "robot/robot_neuro.h"
#include "unit/support/contract_trap.h"

#include <string.h>

#define POWER_ON 0xCAFE0001U
#define WAY 2 /* Ticks; less than any axis' way of rest. */

static rig_t rig;
static kept_positions_t kept;

/* Keeps the positions of the rig's axes. */
static void keep(uint32_t verdict)
{
    kept.power_on = POWER_ON;
    kept.verdict = verdict;
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const snapshot_axis_t *const shown = &rig.outputs.snapshot.axes[i];
        kept.axes[i] = (kept_axis_t){.grade = (uint32_t)KEPT_KNOWN,
                                     .position_ticks = shown->position_ticks,
                                     .reading_ticks = shown->reading_ticks};
    }
}

/* The programs end; the box is left alone for 20 ms, and they start again. */
static void end_programs(void)
{
    box_advance(&rig.box, 20000U);
    (void)memset(&rig.outputs, 0, sizeof rig.outputs);
    controller_init(&rig.controller, &robot_neuro);
    rig_forget(&rig);
}

static void restart(void)
{
    end_programs();
    controller_restore(&rig.controller, &kept);
    rig_cycles(&rig, 50U);
}

void setUp(void)
{
    rig_start_homed(&rig);
    rig_cycle(&rig);
    keep((uint32_t)KEPT_GOOD);
}

void tearDown(void)
{
}

static void assert_reference(uint32_t axis, axis_reference_t reference)
{
    TEST_ASSERT_EQUAL_UINT32_MESSAGE(reference, rig.outputs.snapshot.axes[axis].reference,
                                     robot_neuro.axes[axis].name);
}

static void assert_references(axis_reference_t reference)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        assert_reference(i, reference);
    }
}

static int32_t position(uint32_t axis)
{
    return rig.outputs.snapshot.axes[axis].position_ticks;
}

static const event_t *event_of(event_id_t id, uint32_t axis)
{
    for (uint32_t i = 0U; i < rig.event_count; i++) {
        if ((rig.events[i].id == (uint32_t)id) && (rig.events[i].subject == axis)) {
            return &rig.events[i];
        }
    }
    TEST_FAIL_MESSAGE("the event was not noted");
    return NULL;
}

/* The counter stood `ticks` lower when the position was kept. */
static void count_up(uint32_t axis, int32_t ticks)
{
    kept.axes[axis].reading_ticks =
        (int32_t)((uint32_t)kept.axes[axis].reading_ticks - (uint32_t)ticks);
}

static int32_t upwards(uint32_t axis, int32_t ticks)
{
    return (robot_neuro.axes[axis].is_encoder_inverted != 0U) ? -ticks : ticks;
}

void test_SWR_STORE_005_each_axis_stands_where_it_was_kept_and_is_unverified(void)
{
    restart();
    assert_references(AXIS_REFERENCE_UNVERIFIED);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        TEST_ASSERT_EQUAL_INT32(kept.axes[i].position_ticks, position(i));
        TEST_ASSERT_EQUAL_INT32(position(i), event_of(EVENT_AXIS_RESTORED, i)->value);
    }
    TEST_ASSERT_EQUAL_UINT32(robot_neuro.axis_count, rig_count(&rig, EVENT_AXIS_RESTORED));
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_AXIS_CONTRADICTED));
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.is_homed);
    TEST_ASSERT_EQUAL_HEX32(POWER_ON, rig.outputs.snapshot.power_on);
    TEST_ASSERT_EQUAL_INT32(KEPT_GOOD, event_of(EVENT_STARTED, 0U)->value);
}

void test_SWR_STORE_005_what_was_counted_meanwhile_is_added(void)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        count_up(i, ((i % 2U) == 0U) ? WAY : -WAY);
    }
    restart();
    assert_references(AXIS_REFERENCE_UNVERIFIED);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        TEST_ASSERT_EQUAL_INT32(
            kept.axes[i].position_ticks + upwards(i, ((i % 2U) == 0U) ? WAY : -WAY), position(i));
    }
}

void test_SWR_STORE_005_the_way_of_rest_is_still_believed(void)
{
    count_up(NEURO_AXIS_HEAD, supervision_rest_ticks(&robot_neuro.axes[NEURO_AXIS_HEAD]));
    count_up(NEURO_AXIS_YAW, -supervision_rest_ticks(&robot_neuro.axes[NEURO_AXIS_YAW]));
    restart();
    assert_references(AXIS_REFERENCE_UNVERIFIED);
}

void test_SWR_STORE_005_an_axis_whose_card_is_silent_waits_for_its_first_report(void)
{
    rig_box(&rig, "card feet silent");
    restart();
    TEST_ASSERT_EQUAL_UINT32(1U, rig.outputs.snapshot.positions_awaited);
    assert_reference(NEURO_AXIS_FEET, AXIS_REFERENCE_FRESH);
    TEST_ASSERT_EQUAL_UINT32(STATUS_HARDWARE_NOT_READY,
                             rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_box(&rig, "card feet normal");
    rig_cycles(&rig, 20U);
    TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.positions_awaited);
    assert_references(AXIS_REFERENCE_UNVERIFIED);
}

void test_SWR_STORE_006_an_axis_with_another_reading_is_lost_by_that_much(void)
{
    const int32_t way = supervision_rest_ticks(&robot_neuro.axes[NEURO_AXIS_ROTATION]) + 1;

    count_up(NEURO_AXIS_ROTATION, way);
    count_up(NEURO_AXIS_INSERTION, -100000);
    restart();
    assert_reference(NEURO_AXIS_ROTATION, AXIS_REFERENCE_LOST);
    assert_reference(NEURO_AXIS_INSERTION, AXIS_REFERENCE_LOST);
    assert_reference(NEURO_AXIS_FEET, AXIS_REFERENCE_UNVERIFIED);
    TEST_ASSERT_EQUAL_INT32(upwards(NEURO_AXIS_ROTATION, way),
                            event_of(EVENT_AXIS_CONTRADICTED, NEURO_AXIS_ROTATION)->value);
    TEST_ASSERT_EQUAL_INT32(upwards(NEURO_AXIS_INSERTION, -100000),
                            event_of(EVENT_AXIS_CONTRADICTED, NEURO_AXIS_INSERTION)->value);
    TEST_ASSERT_EQUAL_UINT32(EVENT_SEVERITY_WARNING,
                             event_of(EVENT_AXIS_CONTRADICTED, NEURO_AXIS_ROTATION)->severity);
    TEST_ASSERT_EQUAL_UINT32(robot_neuro.axis_count - 2U, rig_count(&rig, EVENT_AXIS_RESTORED));
}

void test_SWR_STORE_006_an_axis_that_moved_between_the_programs_is_lost(void)
{
    rig_box(&rig, "motor insertion runs");
    end_programs();
    box_advance(&rig.box, 500000U);
    rig_box(&rig, "motor insertion normal");
    controller_restore(&rig.controller, &kept);
    rig_cycles(&rig, 50U);
    assert_reference(NEURO_AXIS_INSERTION, AXIS_REFERENCE_LOST);
    assert_reference(NEURO_AXIS_HEAD, AXIS_REFERENCE_UNVERIFIED);
}

void test_SWR_STORE_003_what_was_lost_stays_lost_and_what_was_fresh_stays_fresh(void)
{
    kept.axes[NEURO_AXIS_FEET].grade = (uint32_t)KEPT_LOST;
    kept.axes[NEURO_AXIS_ROTATION].grade = (uint32_t)KEPT_FRESH;
    restart();
    assert_reference(NEURO_AXIS_FEET, AXIS_REFERENCE_LOST);
    assert_reference(NEURO_AXIS_ROTATION, AXIS_REFERENCE_FRESH);
    assert_reference(NEURO_AXIS_HEAD, AXIS_REFERENCE_UNVERIFIED);
}

void test_SWR_STORE_019_an_axis_with_an_unknown_grade_is_lost(void)
{
    kept.axes[NEURO_AXIS_FEET].grade = (uint32_t)KEPT_KNOWN + 1U;
    kept.axes[NEURO_AXIS_ROTATION].grade = UINT32_MAX;
    restart();
    assert_reference(NEURO_AXIS_FEET, AXIS_REFERENCE_LOST);
    assert_reference(NEURO_AXIS_ROTATION, AXIS_REFERENCE_LOST);
    assert_reference(NEURO_AXIS_LATERAL, AXIS_REFERENCE_UNVERIFIED);
}

void test_SWR_STORE_006_a_fresh_axis_that_was_moved_unseen_is_lost(void)
{
    kept.axes[NEURO_AXIS_FEET].grade = (uint32_t)KEPT_FRESH;
    kept.axes[NEURO_AXIS_ROTATION].grade = (uint32_t)KEPT_FRESH;
    count_up(NEURO_AXIS_ROTATION, 100000);
    restart();
    assert_reference(NEURO_AXIS_FEET, AXIS_REFERENCE_FRESH);
    assert_reference(NEURO_AXIS_ROTATION, AXIS_REFERENCE_LOST);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_CONTRADICTED));
}

void test_SWR_STORE_003_with_positions_that_cannot_be_used_every_axis_is_lost(void)
{
    static const kept_verdict_t refusals[] = {KEPT_MISSING, KEPT_DAMAGED, KEPT_OTHER_ROBOT,
                                              KEPT_TOO_OLD, KEPT_FROM_FUTURE};

    for (uint32_t i = 0U; i < (sizeof refusals / sizeof refusals[0]); i++) {
        keep((uint32_t)refusals[i]);
        restart();
        assert_references(AXIS_REFERENCE_LOST);
        TEST_ASSERT_EQUAL_INT32(refusals[i], event_of(EVENT_STARTED, 0U)->value);
        TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_AXIS_RESTORED));
        TEST_ASSERT_EQUAL_UINT32(0U, rig.outputs.snapshot.positions_awaited);
    }
}

void test_SWR_STORE_004_without_kept_positions_every_axis_is_fresh(void)
{
    keep((uint32_t)KEPT_NOTHING);
    restart();
    assert_references(AXIS_REFERENCE_FRESH);
    TEST_ASSERT_EQUAL_HEX32(POWER_ON, rig.outputs.snapshot.power_on);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_AXIS_RESTORED));
}

void test_SWR_STORE_003_positions_are_taken_before_the_first_cycle_only(void)
{
    EXPECT_CONTRACT("controller", 101U, controller_restore(&rig.controller, &kept));
}

void test_SWR_REPLAY_001_a_start_with_kept_positions_is_replayed_from_its_checkpoint(void)
{
    static replay_t replay;
    static cycle_record_t record;
    const cycle_known_t known = {.is_whole = true};

    count_up(NEURO_AXIS_PITCH, 100000);
    end_programs();
    controller_restore(&rig.controller, &kept);
    replay_init(&replay);
    record.kind = CYCLE_RECORD_CHECKPOINT;
    record.cycle = 0U;
    (void)memcpy(record.body.checkpoint, &rig.controller, CONTROLLER_CHECKPOINT_BYTES);
    TEST_ASSERT_TRUE(replay_take(&replay, &robot_neuro, &record, &known));
    record.kind = CYCLE_RECORD_CYCLE;
    for (record.cycle = 0U; record.cycle < 50U; record.cycle++) {
        rig_cycle(&rig);
        record.body.cycle.inputs = rig.inputs;
        record.body.cycle.outputs = rig.outputs;
        TEST_ASSERT_TRUE(replay_take(&replay, &robot_neuro, &record, &known));
    }
    assert_reference(NEURO_AXIS_PITCH, AXIS_REFERENCE_LOST);
    assert_reference(NEURO_AXIS_HEAD, AXIS_REFERENCE_UNVERIFIED);
}

/* The operator does, once everything has come to rest. */
static void confirm(void)
{
    rig_cycles(&rig, LIMIT_SPEED_TIMEOUT_US / LIMIT_CYCLE_US);
    rig_box(&rig, "button press");
    rig_cycles(&rig, 2U * LIMIT_CONFIRM_HOLD_US / LIMIT_CYCLE_US);
    rig_box(&rig, "button release");
}

/* Its motor has shown nothing of itself since the start of the programs. */
void test_SWR_AXIS_027_counts_that_come_and_go_are_found_where_a_kept_position_was_confirmed(void)
{
    const command_t jog = {.kind = (uint32_t)COMMAND_JOG,
                           .as.jog = {.axis = NEURO_AXIS_INSERTION, .to_ticks = 120000}};
    uint32_t cycle = 0U;
    restart();
    confirm();
    assert_references(AXIS_REFERENCE_VERIFIED);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_MANUAL).status);
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_command(&rig, jog).status);
    rig_box(&rig, "pedal press");
    while (rig_count(&rig, EVENT_AXIS_UNEVEN_COUNTS) == 0U) {
        TEST_ASSERT_LESS_THAN_UINT32(1000U, cycle);
        rig_box(&rig, ((cycle % 10U) < 2U) ? "encoder insertion half" : "encoder insertion normal");
        rig_cycle(&rig);
        cycle++;
    }
    assert_reference(NEURO_AXIS_INSERTION, AXIS_REFERENCE_LOST);
    TEST_ASSERT_DOUBLE_WITHIN(300.0, (double)position(NEURO_AXIS_INSERTION),
                              rig.box.axes[NEURO_AXIS_INSERTION].motor.position_ticks);
}

/* The carriage stands where its counts have it: `ticks` from where the true switch is. */
static void home_contradicted_lateral(int32_t ticks)
{
    count_up(NEURO_AXIS_LATERAL, upwards(NEURO_AXIS_LATERAL, -100));
    kept.axes[NEURO_AXIS_LATERAL].position_ticks += ticks + 100;
    restart();
    assert_reference(NEURO_AXIS_LATERAL, AXIS_REFERENCE_LOST);
    TEST_ASSERT_EQUAL_INT32(kept.axes[NEURO_AXIS_LATERAL].position_ticks - 100,
                            position(NEURO_AXIS_LATERAL));
    confirm();
    TEST_ASSERT_EQUAL_UINT32(STATUS_OK, rig_workphase(&rig, WORKPHASE_START_UP).status);
    rig_press(&rig);
    rig_finish(&rig, 60000U);
    rig_release(&rig);
}

void test_SWR_AXIS_026_homing_is_compared_with_counts_that_contradict_a_kept_position(void)
{
    home_contradicted_lateral(0);
    assert_reference(NEURO_AXIS_LATERAL, AXIS_REFERENCE_VERIFIED);
    TEST_ASSERT_EQUAL_UINT32(0U, rig_count(&rig, EVENT_AXIS_SWITCH_ELSEWHERE));
}

void test_SWR_AXIS_026_homing_elsewhere_than_counts_that_contradict_a_kept_position_is_lost(void)
{
    home_contradicted_lateral(100);
    assert_reference(NEURO_AXIS_LATERAL, AXIS_REFERENCE_LOST);
    TEST_ASSERT_EQUAL_UINT32(1U, rig_count(&rig, EVENT_AXIS_SWITCH_ELSEWHERE));
}
