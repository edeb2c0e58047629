/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a sweep seeks the slowest word at which its axis begins to turn, measures up to
 * 24 points upwards and downwards, each in whole runs, and ends before anything is too fast.
 */
#include "unity.h"

#include "card/link.h"
#include "limits/requirement_limits.h"
#include "mode/leg/leg.h"
#include "mode/leg/mode_frame.h"
#include "mode/sweep/sweep_mode.h"
#include "robot/joints.h"
#include "robot/margin.h"
#include "safety/needle.h"
#include "unit/support/mode_world.h"

#include <string.h>

#define STEP_CYCLES 6000U
#define PAUSE_CYCLES 1000U
#define LONG_CYCLES 900000U
#define NOTES 256U
#define FIRST_WORD 1210495000U
#define COARSE 22009000U
#define FINE 4063228U
/* The motor begins to turn between two points of the fine search. */
#define BEGIN_WORD (FIRST_WORD - (2U * COARSE) + (4U * FINE) + (FINE / 2U))

static leg_t leg;
static sweep_mode_t mode;
static link_t links[CARD_SLOT_COUNT];
static mode_note_t notes[NOTES];
static uint32_t note_count;
static double place;
static double speeds[LIMIT_SWEEP_POINTS + 1U]; /* In ticks/s, of the fine steps from its first. */
static double down_share;                      /* Share of the speed upwards. */
static uint32_t cycles;
static uint32_t driven;

/* The rotation as that of the ProstateRobot. */
static void make_waves(void)
{
    axis_config_t *const config = &robot.axes[NEURO_AXIS_ROTATION];
    config->card_type = (uint8_t)CARD_TYPE_HIGH_FREQUENCY;
    config->unit_per_tick_q16 = INT64_C(168876000000);
    config->is_motor_inverted = 0U;
    config->amplitude = 255U;
    config->maximum_duty = LIMIT_RESONANCE_WORD;
    config->minimum_ticks = -8073;
    config->maximum_ticks = 8073;
    config->speed_ticks_per_s = 1285;
}

void setUp(void)
{
    world_start();
    make_waves();
    frame.links = links;
    (void)memset(links, 0, sizeof links);
    leg = (leg_t){.axes = 0U};
    mode = (sweep_mode_t){.stage = 0U};
    note_count = 0U;
    place = 0.0;
    down_share = 1.0;
    cycles = 0U;
    driven = 0U;
    for (uint32_t i = 0U; i <= LIMIT_SWEEP_POINTS; i++) {
        speeds[i] = 10.0 * (double)i;
    }
}

void tearDown(void)
{
}

static void expect(uint32_t axis, bool is_free, status_t status)
{
    const solution_t judged =
        sweep_mode_judge(&(sweep_mode_t){.is_free = is_free ? 1U : 0U}, axis, &robot, axes);
    TEST_ASSERT_EQUAL(status, judged.status);
}

/* The motor of this test: still above BEGIN_WORD. */
static double speed_of(uint32_t word)
{
    if (word > BEGIN_WORD) {
        return 0.0;
    }
    const uint32_t step = (BEGIN_WORD - word) / FINE;
    return speeds[(step < LIMIT_SWEEP_POINTS) ? (step + 1U) : LIMIT_SWEEP_POINTS];
}

static void keep_notes(void)
{
    for (uint32_t i = 0U; i < result.note_count; i++) {
        TEST_ASSERT_LESS_THAN_UINT32(NOTES, note_count);
        TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_ROTATION, result.notes[i].axis);
        notes[note_count] = result.notes[i];
        note_count++;
    }
}

/* One cycle, and what the motor makes of it. */
static void step(void)
{
    mode_clear(&result);
    sweep_mode_step(&mode, NEURO_AXIS_ROTATION, &leg, &frame, &result);
    keep_notes();
    const card_drive_t *const drive = &result.requests[NEURO_AXIS_ROTATION];
    for (uint32_t i = 0U; i < robot.axis_count; i++) {
        TEST_ASSERT_TRUE((i == NEURO_AXIS_ROTATION) ||
                         (result.requests[i].mode == (uint32_t)CARD_DRIVE_OFF));
    }
    if (drive->mode != (uint32_t)CARD_DRIVE_OFF) {
        const double way = speed_of(drive->duty) / 1000.0;
        TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_HIGH_FREQUENCY, drive->mode);
        TEST_ASSERT_EQUAL_UINT32(255U, drive->amplitude);
        TEST_ASSERT_LESS_OR_EQUAL_UINT32(LIMIT_WAVE_SLOWEST_WORD, drive->duty);
        TEST_ASSERT_GREATER_OR_EQUAL_UINT32(LIMIT_RESONANCE_WORD, drive->duty);
        place += (drive->direction != 0U) ? way : -(way * down_share);
        driven++;
    }
    world_put(NEURO_AXIS_ROTATION, (int32_t)(place + ((place < 0.0) ? -0.5 : 0.5)));
    cycles++;
}

static void steps(uint32_t count)
{
    for (uint32_t i = 0U; i < count; i++) {
        step();
    }
}

static void run_to_end(void)
{
    while (result.progress == MODE_RUNNING) {
        TEST_ASSERT_LESS_THAN_UINT32(LONG_CYCLES, cycles);
        step();
    }
}

static uint32_t count_of(event_id_t id)
{
    uint32_t count = 0U;
    for (uint32_t i = 0U; i < note_count; i++) {
        count += (notes[i].id == id) ? 1U : 0U;
    }
    return count;
}

static int32_t nth(event_id_t id, uint32_t index)
{
    uint32_t count = 0U;
    for (uint32_t i = 0U; i < note_count; i++) {
        if (notes[i].id == id) {
            if (count == index) {
                return notes[i].value;
            }
            count++;
        }
    }
    return INT32_MIN;
}

static void expect_failed(status_t status)
{
    TEST_ASSERT_EQUAL(MODE_FAILED, result.progress);
    TEST_ASSERT_EQUAL(status, result.status);
    TEST_ASSERT_EQUAL_UINT32(NEURO_AXIS_ROTATION, result.axis);
    TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_OFF, result.requests[NEURO_AXIS_ROTATION].mode);
    TEST_ASSERT_EQUAL_UINT32(0U, count_of(EVENT_SWEEP_ENDED));
}

/* To the first driven cycle of the run that begins next. */
static void go_into_run(void)
{
    const uint32_t before = count_of(EVENT_SWEEP_WORD);
    while (count_of(EVENT_SWEEP_WORD) == before) {
        step();
    }
}

void test_SWR_SWEEP_001_a_free_turning_axis_with_waves_is_swept(void)
{
    expect(NEURO_AXIS_ROTATION, true, STATUS_OK);
    const int32_t room = 8073 - (1285 * 5);
    world_put(NEURO_AXIS_ROTATION, room);
    expect(NEURO_AXIS_ROTATION, true, STATUS_OK);
    world_put(NEURO_AXIS_ROTATION, -room);
    expect(NEURO_AXIS_ROTATION, true, STATUS_OK);
}

void test_SWR_SWEEP_002_what_cannot_be_swept_or_is_not_confirmed_is_refused(void)
{
    const int32_t room = 8073 - (1285 * 5);
    expect(NEURO_AXIS_LATERAL, true, STATUS_NO_SWEEP);
    expect(robot.axis_count, true, STATUS_UNKNOWN_COMMAND);
    expect(UINT32_MAX, true, STATUS_UNKNOWN_COMMAND);
    expect(NEURO_AXIS_ROTATION, false, STATUS_NOT_FREE);
    world_put(NEURO_AXIS_ROTATION, room + 1);
    expect(NEURO_AXIS_ROTATION, true, STATUS_AXIS_LIMIT);
    world_put(NEURO_AXIS_ROTATION, -room - 1);
    expect(NEURO_AXIS_ROTATION, true, STATUS_AXIS_LIMIT);
    TEST_ASSERT_EQUAL_UINT32(
        NEURO_AXIS_ROTATION,
        sweep_mode_judge(&(sweep_mode_t){.is_free = 1U}, NEURO_AXIS_ROTATION, &robot, axes).axis);
    robot.axes[NEURO_AXIS_ROTATION].unit = (uint8_t)AXIS_UNIT_MM;
    expect(NEURO_AXIS_ROTATION, true, STATUS_NO_SWEEP);
    robot.axes[NEURO_AXIS_ROTATION].unit = (uint8_t)AXIS_UNIT_RAD;
    robot.coupled_limits[0].axes |= 1UL << NEURO_AXIS_ROTATION;
    expect(NEURO_AXIS_ROTATION, true, STATUS_NO_SWEEP);
}

void test_SWR_SWEEP_002_no_sweep_while_the_needle_is_not_known_to_be_out(void)
{
    world_put(NEURO_AXIS_INSERTION, needle_out_ticks(&robot) + 2);
    expect(NEURO_AXIS_ROTATION, true, STATUS_NEEDLE_IN);
    world_put(NEURO_AXIS_INSERTION, 0);
    expect(NEURO_AXIS_ROTATION, true, STATUS_OK);
    world_lose(NEURO_AXIS_INSERTION);
    expect(NEURO_AXIS_ROTATION, true, STATUS_NEEDLE_IN);
}

void test_SWR_SWEEP_003_the_first_point_is_the_fastest_word_that_does_not_turn(void)
{
    run_to_end();
    /* 55 kHz stands, 54 kHz stands, 53 kHz turns; from there back to where it stands. */
    TEST_ASSERT_EQUAL_INT32(55000, nth(EVENT_SWEEP_WORD, 0U));
    TEST_ASSERT_EQUAL_INT32(54000, nth(EVENT_SWEEP_WORD, 1U));
    TEST_ASSERT_EQUAL_INT32(53000, nth(EVENT_SWEEP_WORD, 2U));
    TEST_ASSERT_EQUAL_INT32(53184, nth(EVENT_SWEEP_WORD, 3U));
    TEST_ASSERT_EQUAL_INT32(53738, nth(EVENT_SWEEP_WORD, 6U));
    TEST_ASSERT_EQUAL_INT32(53923, nth(EVENT_SWEEP_WORD, 7U));
    TEST_ASSERT_EQUAL_INT32(53923, nth(EVENT_SWEEP_WORD, 8U));
    TEST_ASSERT_EQUAL_INT32(1, (int32_t)count_of(EVENT_SWEEP_BEGUN));
    TEST_ASSERT_EQUAL_INT32(0, nth(EVENT_SWEEP_UPWARDS, 0U));
}

void test_SWR_SWEEP_003_three_degrees_in_a_run_are_no_turning(void)
{
    /* 13.9 ticks are 3 degrees. */
    speeds[1] = 2.5;
    run_to_end();
    TEST_ASSERT_EQUAL_INT32(53738, nth(EVENT_SWEEP_WORD, 7U));
    TEST_ASSERT_INT32_WITHIN(1, 12, nth(EVENT_SWEEP_UPWARDS, 0U));
}

void test_SWR_SWEEP_004_a_point_has_a_run_each_way_after_a_pause(void)
{
    run_to_end();
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
    TEST_ASSERT_EQUAL_UINT32(24U, count_of(EVENT_SWEEP_UPWARDS));
    TEST_ASSERT_EQUAL_UINT32(24U, count_of(EVENT_SWEEP_DOWNWARDS));
    TEST_ASSERT_EQUAL_INT32(SWEEP_END_POINTS, nth(EVENT_SWEEP_ENDED, 0U));
    for (uint32_t i = 0U; i < 24U; i++) {
        TEST_ASSERT_INT32_WITHIN(1, (int32_t)(50U * i), nth(EVENT_SWEEP_UPWARDS, i));
        TEST_ASSERT_INT32_WITHIN(1, (int32_t)(50U * i), nth(EVENT_SWEEP_DOWNWARDS, i));
    }
    const uint32_t runs = count_of(EVENT_SWEEP_WORD);
    TEST_ASSERT_EQUAL_UINT32(8U + 48U, runs);
    TEST_ASSERT_EQUAL_UINT32(runs * 5000U, driven);
    TEST_ASSERT_EQUAL_UINT32((runs * STEP_CYCLES) + 1U, cycles);
}

void test_SWR_SWEEP_004_nothing_is_driven_in_a_pause(void)
{
    steps(PAUSE_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(0U, driven);
    steps(1U);
    TEST_ASSERT_EQUAL_UINT32(1U, driven);
    steps(STEP_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(5001U, driven);
}

void test_SWR_SWEEP_004_an_inverted_motor_turns_the_same_ways(void)
{
    robot.axes[NEURO_AXIS_ROTATION].is_motor_inverted = 1U;
    go_into_run();
    TEST_ASSERT_EQUAL_UINT32(0U, result.requests[NEURO_AXIS_ROTATION].direction);
}

void test_SWR_SWEEP_005_a_word_beyond_the_range_is_never_driven_with(void)
{
    go_into_run();
    mode.word = LIMIT_RESONANCE_WORD - 1U;
    step();
    TEST_ASSERT_EQUAL_UINT32(LIMIT_RESONANCE_WORD, result.requests[NEURO_AXIS_ROTATION].duty);
    mode.word = UINT32_MAX;
    step();
    TEST_ASSERT_EQUAL_UINT32(LIMIT_WAVE_SLOWEST_WORD, result.requests[NEURO_AXIS_ROTATION].duty);
}

static void grow(void)
{
    speeds[1] = 10.0;
    for (uint32_t i = 2U; i <= LIMIT_SWEEP_POINTS; i++) {
        speeds[i] = speeds[i - 1U] * 1.4;
    }
}

void test_SWR_SWEEP_006_it_ends_before_a_point_that_would_be_too_fast(void)
{
    grow();
    run_to_end();
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
    TEST_ASSERT_EQUAL_INT32(SWEEP_END_SPEED, nth(EVENT_SWEEP_ENDED, 0U));
    const uint32_t last = count_of(EVENT_SWEEP_DOWNWARDS) - 1U;
    TEST_ASSERT_LESS_THAN_UINT32(23U, last);
    TEST_ASSERT_LESS_OR_EQUAL_INT32(6425, nth(EVENT_SWEEP_DOWNWARDS, last));
    TEST_ASSERT_GREATER_THAN_INT32(6425 / 2, nth(EVENT_SWEEP_DOWNWARDS, last));
}

void test_SWR_SWEEP_006_the_faster_direction_decides(void)
{
    grow();
    down_share = 1.5;
    run_to_end();
    TEST_ASSERT_EQUAL(MODE_DONE, result.progress);
    TEST_ASSERT_LESS_OR_EQUAL_INT32(
        6425, nth(EVENT_SWEEP_DOWNWARDS, count_of(EVENT_SWEEP_DOWNWARDS) - 1U));
}

void test_SWR_SWEEP_006_it_ends_at_the_fastest_word_of_the_axis(void)
{
    go_into_run();
    mode.stage = 3U;
    mode.word = LIMIT_RESONANCE_WORD + FINE - 1U;
    run_to_end();
    TEST_ASSERT_EQUAL_INT32(SWEEP_END_WORDS, nth(EVENT_SWEEP_ENDED, 0U));
    TEST_ASSERT_EQUAL_UINT32(1U, count_of(EVENT_SWEEP_DOWNWARDS));
}

void test_SWR_SWEEP_007_an_axis_that_never_turns_has_no_beginning(void)
{
    for (uint32_t i = 0U; i <= LIMIT_SWEEP_POINTS; i++) {
        speeds[i] = 0.0;
    }
    run_to_end();
    expect_failed(STATUS_SWEEP_NO_START);
    TEST_ASSERT_EQUAL_INT32(50000, nth(EVENT_SWEEP_WORD, 5U));
    TEST_ASSERT_EQUAL_UINT32(6U, count_of(EVENT_SWEEP_WORD));
}

void test_SWR_SWEEP_007_an_axis_that_turns_by_the_slowest_word_has_none_either(void)
{
    go_into_run();
    place += 20.0;
    run_to_end();
    expect_failed(STATUS_SWEEP_NO_START);
}

void test_SWR_SWEEP_007_more_than_the_speed_of_the_axis_aborts_it_at_once(void)
{
    go_into_run();
    place += 128.0;
    world_put(NEURO_AXIS_ROTATION, (int32_t)place);
    step();
    TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
    place += 1.0;
    world_put(NEURO_AXIS_ROTATION, (int32_t)place);
    step();
    expect_failed(STATUS_TOO_FAST);
}

void test_SWR_SWEEP_007_speed_is_held_against_all_of_the_run(void)
{
    go_into_run();
    steps(200U);
    place += 257.0;
    world_put(NEURO_AXIS_ROTATION, (int32_t)place);
    step();
    TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
    place += 3.0;
    world_put(NEURO_AXIS_ROTATION, (int32_t)place);
    step();
    expect_failed(STATUS_TOO_FAST);
}

void test_SWR_SWEEP_007_current_aborts_it(void)
{
    go_into_run();
    links[robot.axes[NEURO_AXIS_ROTATION].slot].report.current_ma = LIMIT_SWEEP_CURRENT_MA;
    step();
    TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
    links[robot.axes[NEURO_AXIS_ROTATION].slot].report.current_ma = LIMIT_SWEEP_CURRENT_MA + 1U;
    step();
    expect_failed(STATUS_SWEEP_CURRENT);
}

void test_SWR_SWEEP_007_the_wrong_way_a_limit_and_a_needle_that_is_in_abort_it(void)
{
    go_into_run();
    world_put(NEURO_AXIS_ROTATION, -(int32_t)LIMIT_WRONG_WAY_TICKS);
    mode_clear(&result);
    sweep_mode_step(&mode, NEURO_AXIS_ROTATION, &leg, &frame, &result);
    expect_failed(STATUS_FAULT_PRESENT);
    place = 8072.0;
    mode.start_ticks = 8072;
    world_put(NEURO_AXIS_ROTATION, 8072);
    step();
    TEST_ASSERT_EQUAL(MODE_RUNNING, result.progress);
    world_put(NEURO_AXIS_ROTATION, 8073);
    step();
    expect_failed(STATUS_AXIS_LIMIT);
    world_put(NEURO_AXIS_INSERTION, needle_out_ticks(&robot) + 2);
    step();
    expect_failed(STATUS_NEEDLE_IN);
}

void test_SWR_SWEEP_007_an_axis_that_is_none_is_not_driven(void)
{
    mode_clear(&result);
    sweep_mode_step(&mode, ROBOT_AXIS_MAX, &leg, &frame, &result);
    TEST_ASSERT_EQUAL(MODE_FAILED, result.progress);
    TEST_ASSERT_EQUAL_UINT32(MODE_NO_AXIS, result.axis);
}

void test_SWR_SWEEP_008_an_interrupted_step_begins_anew_and_is_reported(void)
{
    steps(STEP_CYCLES + PAUSE_CYCLES + 3000U);
    TEST_ASSERT_EQUAL_INT32(54000, nth(EVENT_SWEEP_WORD, 1U));
    const uint32_t before = driven;
    leg_stop(&leg);
    mode_rest(&frame, &result);
    steps(PAUSE_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(before, driven);
    TEST_ASSERT_EQUAL_INT32(54000, nth(EVENT_SWEEP_AGAIN, 0U));
    steps(STEP_CYCLES - PAUSE_CYCLES);
    TEST_ASSERT_EQUAL_UINT32(before + 5000U, driven);
    TEST_ASSERT_EQUAL_INT32(54000, nth(EVENT_SWEEP_WORD, 2U));
    go_into_run();
    TEST_ASSERT_EQUAL_INT32(53000, nth(EVENT_SWEEP_WORD, 3U));
    TEST_ASSERT_EQUAL_UINT32(1U, count_of(EVENT_SWEEP_AGAIN));
    TEST_ASSERT_EQUAL_UINT32(1U, count_of(EVENT_SWEEP_BEGUN));
}
