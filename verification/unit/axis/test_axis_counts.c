/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: an axis that is driven and not counted is reported, and one whose counts fall
 * short of its motor, whether it runs on or is tapped; reported once, and by its name.
 */
#include "unity.h"

#include "axis/axis.h"
#include "axis/count_balance.h"
#include "axis/supervision.h"
#include "card/card_frame.h"
#include "charts/axis_chart.h"
#include "limits/requirement_limits.h"
#include "motion/motor_model.h"
#include "robot/robot_neuro.h"

#include <string.h>

#include "unit/axis/axis_counts_world.inc"

#define BROKEN_CYCLES 3U
#define RHYTHM_CYCLES 10U
#define SILENT_CYCLES (LIMIT_SILENT_TIME_US / CYCLE_US)

static const axis_config_t *const needle = &robot_neuro.axes[NEURO_AXIS_INSERTION];

void setUp(void)
{
    use(head);
}

void tearDown(void)
{
}

/* Up so often for a short while, with pauses. */
static uint32_t tap(int32_t percent, uint32_t cycles, uint32_t taps)
{
    uint32_t notes = 0U;
    for (uint32_t i = 0U; (i < taps) && (notes == 0U); i++) {
        notes = run(drive(true), percent, cycles);
        notes |= (notes == 0U) ? rest(50U) : 0U;
    }
    return notes;
}

/* 984 ticks/s with a rise of 15 ms make 4 ticks within 14 ms. */
void test_SWR_AXIS_018_without_any_count_a_driven_axis_is_reported(void)
{
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_NO_COUNTS, run(drive(true), 0, LONG_CYCLES));
    TEST_ASSERT_LESS_OR_EQUAL_UINT32(14U + SILENT_CYCLES, driven_cycles);
    TEST_ASSERT_GREATER_THAN_INT32(LIMIT_SILENT_TICKS, supervision.sealed.missing_ticks);
    use(needle);
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_NO_COUNTS, run(drive(false), 0, LONG_CYCLES));
    TEST_ASSERT_LESS_OR_EQUAL_UINT32(4U + SILENT_CYCLES, driven_cycles);
}

/* 0.25 mm of the head are 19.7 ticks: at full speed they are due within 21 ms. */
void test_SWR_AXIS_018_a_blind_way_is_reported_before_the_time(void)
{
    TEST_ASSERT_EQUAL_HEX32(0U, run(drive(true), 100, 100U));
    driven_cycles = 0U;
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_NO_COUNTS, run(drive(true), 0, LONG_CYCLES));
    TEST_ASSERT_LESS_OR_EQUAL_UINT32(21U, driven_cycles);
    TEST_ASSERT_EQUAL_INT32(19, supervision.sealed.missing_ticks);
}

void test_SWR_AXIS_018_a_pause_makes_nothing_good(void)
{
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_NO_COUNTS, tap(0, 10U, 100U));
    TEST_ASSERT_LESS_OR_EQUAL_UINT32(3U * 10U + SILENT_CYCLES, driven_cycles);
    use(needle);
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_NO_COUNTS, tap(0, 3U, 1000U));
    TEST_ASSERT_LESS_OR_EQUAL_UINT32(3U * 3U + SILENT_CYCLES, driven_cycles);
}

void test_SWR_AXIS_018_time_that_is_not_driven_does_not_count(void)
{
    TEST_ASSERT_EQUAL_HEX32(0U, run(drive(true), 0, 20U));
    TEST_ASSERT_GREATER_THAN_UINT32(0U, supervision.sealed.silent_us);
    TEST_ASSERT_LESS_THAN_UINT32(20000U, supervision.sealed.silent_us);
    TEST_ASSERT_EQUAL_HEX32(0U, rest(LONG_CYCLES));
}

void test_SWR_AXIS_018_a_count_in_the_direction_of_the_drive_begins_anew(void)
{
    TEST_ASSERT_EQUAL_HEX32(0U, run(drive(false), 0, 15U));
    TEST_ASSERT_GREATER_THAN_UINT32(0U, supervision.sealed.silent_us);
    TEST_ASSERT_EQUAL_HEX32(0U, step((card_drive_t){CARD_DRIVE_OFF, 0U, 0U, 0U}, -1, CYCLE_US));
    TEST_ASSERT_EQUAL_UINT32(0U, supervision.sealed.silent_us);
    TEST_ASSERT_EQUAL_INT64(0, supervision.sealed.due_q16);
}

void test_SWR_AXIS_018_a_count_against_the_drive_is_none(void)
{
    TEST_ASSERT_EQUAL_HEX32(0U, run(drive(true), 0, 15U));
    const uint32_t silent_us = supervision.sealed.silent_us;
    TEST_ASSERT_EQUAL_HEX32(0U, step(drive(true), -1, CYCLE_US));
    TEST_ASSERT_EQUAL_UINT32(silent_us + CYCLE_US, supervision.sealed.silent_us);
}

void test_SWR_AXIS_018_missing_counts_are_reported_once(void)
{
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_NO_COUNTS, run(drive(true), 0, LONG_CYCLES));
    TEST_ASSERT_EQUAL_INT64(0, supervision.sealed.due_q16);
    TEST_ASSERT_EQUAL_UINT32(0U, supervision.sealed.silent_us);
    TEST_ASSERT_EQUAL_INT64(0, supervision.sealed.account.short_e2_q16);
    TEST_ASSERT_EQUAL_HEX32(0U, run(drive(true), 0, 3U));
}

/* A card that is not fed stops its motor after that time. */
void test_SWR_AXIS_018_a_late_cycle_drives_no_longer_than_the_card(void)
{
    TEST_ASSERT_EQUAL_HEX32(0U, step(drive(true), 0, 1000000U));
    const int64_t most_q16 =
        (int64_t)head->full_speed_ticks_per_s * 65536 * (int64_t)LIMIT_CARD_WATCHDOG_US / 1000000;
    TEST_ASSERT_LESS_OR_EQUAL_INT64(most_q16, supervision.sealed.due_q16);
    TEST_ASSERT_GREATER_THAN_INT64(most_q16 / 4, supervision.sealed.due_q16);
    TEST_ASSERT_EQUAL_UINT32(LIMIT_CARD_WATCHDOG_US, supervision.sealed.account.window_us);
}

void test_SWR_AXIS_019_half_the_counts_are_a_wrong_speed(void)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        use(&robot_neuro.axes[i]);
        TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_WRONG_SPEED, run(drive(true), 50, LONG_CYCLES));
        TEST_ASSERT_LESS_OR_EQUAL_UINT32(200U, driven_cycles);
        TEST_ASSERT_INT32_WITHIN(10, 50, supervision.sealed.account.percent);
        use(&robot_neuro.axes[i]);
        TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_WRONG_SPEED, tap(50, 20U, LONG_CYCLES));
        use(&robot_neuro.axes[i]);
        TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_WRONG_SPEED, run(drive(false), 200, LONG_CYCLES));
    }
}

void test_SWR_AXIS_019_motors_a_fifth_faster_or_slower_are_right(void)
{
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        for (int32_t percent = 80; percent <= 120; percent += 10) {
            use(&robot_neuro.axes[i]);
            TEST_ASSERT_EQUAL_HEX32(0U, run(drive(true), percent, 2000U));
            TEST_ASSERT_EQUAL_HEX32(0U, run(drive(false), percent, 2000U));
            TEST_ASSERT_EQUAL_HEX32(0U, tap(percent, 20U, 200U));
        }
    }
}

/* The needle at full speed lacks 17 ticks in a cycle: its sum is full before the silence is. */
void test_SWR_AXIS_019_a_sum_is_called_missing_counts_while_nothing_is_counted(void)
{
    use(needle);
    TEST_ASSERT_EQUAL_HEX32(0U, run(drive(true), 100, 100U));
    driven_cycles = 0U;
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_NO_COUNTS, run(drive(true), 0, LONG_CYCLES));
    TEST_ASSERT_LESS_OR_EQUAL_UINT32(24U, driven_cycles);
}

void test_SWR_AXIS_019_a_wrong_speed_is_reported_once(void)
{
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_WRONG_SPEED, run(drive(true), 50, LONG_CYCLES));
    TEST_ASSERT_EQUAL_INT64(0, supervision.sealed.account.short_e2_q16);
    TEST_ASSERT_EQUAL_HEX32(0U, run(drive(true), 50, 10U));
}

/* Half of the counts are lost for some cycles of each few. @return notes of the first cycle that
 * has any */
static uint32_t flicker(card_drive_t sent, uint32_t cycles)
{
    uint32_t notes = 0U;
    for (uint32_t i = 0U; (i < cycles) && (notes == 0U); i++) {
        notes = cycle(sent, ((i % RHYTHM_CYCLES) < BROKEN_CYCLES) ? 50 : 100);
    }
    return notes;
}

void test_SWR_AXIS_027_counts_that_come_and_go_are_reported_once(void)
{
    use(needle);
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_UNEVEN_COUNTS, flicker(drive(true), LONG_CYCLES));
    TEST_ASSERT_LESS_OR_EQUAL_UINT32(3U * RHYTHM_CYCLES, driven_cycles);
    TEST_ASSERT_EQUAL_UINT32(0U, supervision.sealed.pace.uneven);
    TEST_ASSERT_EQUAL_INT64(0, supervision.sealed.account.short_e2_q16);
    use(needle);
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_UNEVEN_COUNTS, flicker(drive(false), LONG_CYCLES));
}

/* A tick in pushes that make no more than one or two. */
void test_SWR_AXIS_027_pauses_are_no_way(void)
{
    uint32_t notes = 0U;
    for (uint32_t i = 0U; (i < 400U) && (notes == 0U); i++) {
        notes = run(drive(true), ((i % 8U) < 4U) ? 50 : 100, 6U);
        notes |= (notes == 0U) ? rest(20U) : 0U;
    }
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_UNEVEN_COUNTS, notes);
    use(head);
    TEST_ASSERT_EQUAL_HEX32(0U, tap(100, 6U, 400U));
    TEST_ASSERT_EQUAL_UINT32(0U, supervision.sealed.pace.uneven);
}

void test_SWR_AXIS_027_a_turn_or_a_count_that_is_not_of_the_drive_begins_anew(void)
{
    use(needle);
    expect_begun(true);
    TEST_ASSERT_EQUAL_HEX32(0U, run(drive(true), 100, 20U));
    expect_begun(false);
    TEST_ASSERT_EQUAL_HEX32(0U, step(drive(true), -1, CYCLE_US));
    expect_begun(true);
    TEST_ASSERT_EQUAL_HEX32(0U, run(drive(true), 100, 20U));
    TEST_ASSERT_EQUAL_HEX32(0U, rest(20U));
    expect_begun(false);
    TEST_ASSERT_EQUAL_HEX32(0U, step((card_drive_t){CARD_DRIVE_OFF, 0U, 0U, 0U}, 1, CYCLE_US));
    expect_begun(true);
    TEST_ASSERT_EQUAL_HEX32(0U, run(drive(true), 100, 20U));
    TEST_ASSERT_EQUAL_HEX32(0U, step(drive(false), 0, CYCLE_US));
    expect_begun(true);
}

/* Loses counts, in hundredths of ticks; the motor has shown its speed. */
static void lose_counts(supervision_t *which)
{
    which->sealed.account.short_e2_q16 = 100;
    which->sealed.due_q16 = 100;
    which->sealed.account.calibrations[COUNT_REGIME_STEADY].least_percent = 90U;
}

static void expect_kept(const supervision_t *which, bool is_kept)
{
    TEST_ASSERT_EQUAL_INT64(is_kept ? 100 : 0, which->sealed.account.short_e2_q16);
    TEST_ASSERT_EQUAL_INT64(is_kept ? 100 : 0, which->sealed.due_q16);
}

static void expect_shown(const supervision_t *which)
{
    TEST_ASSERT_EQUAL_UINT32(90U,
                             which->sealed.account.calibrations[COUNT_REGIME_STEADY].least_percent);
}

static void use_axis(axis_t *axis, axis_reference_t grade)
{
    card_report_t report;
    (void)memset(&report, 0, sizeof report);
    axis_init(axis);
    (void)axis_observe(axis, head, &report, CYCLE_US);
    axis_enable(axis, false);
    axis->chart.reference = grade;
    axis->chart.reference_inverse = ~(uint32_t)grade;
    lose_counts(&axis->supervision);
}

void test_SWR_AXIS_019_a_new_start_of_a_homed_axis_makes_nothing_good(void)
{
    axis_t axis;
    use_axis(&axis, AXIS_REFERENCE_VERIFIED);
    axis_enable(&axis, false);
    expect_kept(&axis.supervision, true);
    expect_shown(&axis.supervision);
    axis_disable(&axis);
    axis_enable(&axis, false);
    expect_kept(&axis.supervision, true);
    expect_shown(&axis.supervision);
}

void test_SWR_AXIS_024_what_a_motor_has_shown_stays_when_its_axis_is_enabled_without_a_reference(
    void)
{
    axis_t axis;
    use_axis(&axis, AXIS_REFERENCE_LOST);
    axis_enable(&axis, true);
    expect_shown(&axis.supervision);
    use_axis(&axis, AXIS_REFERENCE_UNVERIFIED);
    axis_disable(&axis);
    axis_enable(&axis, true);
    expect_shown(&axis.supervision);
    axis_enable(&axis, false);
    expect_kept(&axis.supervision, false);
    expect_shown(&axis.supervision);
}

/* The yaw at the servo's slowest speed, a tick in 5 cycles. */
static card_drive_t slow_drive(void)
{
    card_drive_t slow = drive(true);
    slow.duty =
        motor_model_duty(config, ((int64_t)config->full_speed_ticks_per_s * 256 * 15) / 100);
    return slow;
}

/* Share shown by a motor that runs steadily for a short while, again and again, each time until it
 * stands between so much of a tick and so much. */
static int32_t shown_percent(int32_t percent, int64_t least_q16, int64_t most_q16)
{
    use(&robot_neuro.axes[NEURO_AXIS_YAW]);
    const card_drive_t slow = slow_drive();
    const count_calibration_t *const shown =
        &supervision.sealed.account.calibrations[COUNT_REGIME_STEADY];
    for (uint32_t i = 0U; (i < LONG_CYCLES) && (shown->least_percent == LIMIT_SPEED_LEAST_PERCENT);
         i++) {
        uint32_t notes = run(slow, percent, SHORT_CYCLES);
        while (((way_q16 % 65536) < least_q16) || ((way_q16 % 65536) >= most_q16)) {
            notes |= cycle(slow, percent);
        }
        TEST_ASSERT_EQUAL_HEX32(0U, notes | rest(50U));
    }
    return (int32_t)(((int64_t)shown->counted_ticks * 6553600) / shown->model_q16);
}

/* The servo ends a run as soon as a count shows the axis ahead. */
void test_SWR_AXIS_024_runs_that_end_with_a_count_or_before_one_show_the_true_motor(void)
{
    const int32_t percents[] = {82, 100, 115};
    for (uint32_t i = 0U; i < 3U; i++) {
        TEST_ASSERT_INT32_WITHIN(2, percents[i], shown_percent(percents[i], 0, 16384));
        TEST_ASSERT_INT32_WITHIN(2, percents[i], shown_percent(percents[i], 49152, 65536));
    }
}

/* The cycle before the pause ended a way. */
void test_SWR_AXIS_024_a_pause_shows_nothing(void)
{
    TEST_ASSERT_EQUAL_HEX32(0U, run(drive(true), 100, 2U * SHORT_CYCLES));
    while (supervision.sealed.pace.ended_q16 == 0U) {
        TEST_ASSERT_EQUAL_HEX32(0U, cycle(drive(true), 100));
    }
    const count_calibration_t shown = supervision.sealed.account.calibrations[COUNT_REGIME_STEADY];
    TEST_ASSERT_GREATER_THAN_INT32(0, shown.counted_ticks);
    TEST_ASSERT_EQUAL_HEX32(0U, rest(50U));
    TEST_ASSERT_EQUAL_MEMORY(&shown, &supervision.sealed.account.calibrations[COUNT_REGIME_STEADY],
                             sizeof shown);
}

void test_SWR_AXIS_019_a_new_reference_empties_the_sums_and_the_motor_stays_known(void)
{
    axis_t axis;
    use_axis(&axis, AXIS_REFERENCE_FRESH);
    axis_restore(&axis, head, 1000);
    expect_kept(&axis.supervision, false);
    lose_counts(&axis.supervision);
    TEST_ASSERT_TRUE(axis_confirm(&axis, head));
    expect_kept(&axis.supervision, false);
    expect_shown(&axis.supervision);
    lose_counts(&axis.supervision);
    TEST_ASSERT_FALSE(axis_confirm(&axis, head));
    expect_kept(&axis.supervision, true);
}

/* Gaining speed for 4 ms, with an edge after half of them: the mean of the rest is a quarter of the
 * gain below the end. */
void test_SWR_AXIS_027_the_way_after_a_count_is_that_of_a_cycle_as_long_as_it_is(void)
{
    use(needle);
    (void)cycle(drive(true), 100);
    const int64_t before_q8 = motor.speed_ticks_per_s_q8;
    const card_drive_t sent = drive(true);
    (void)motor_model_step_q16(&motor, config, &sent, 4U * CYCLE_US);
    const int64_t gained_q8 = motor.speed_ticks_per_s_q8 - before_q8;
    const int64_t mean_q8 = motor.speed_ticks_per_s_q8 - (gained_q8 / 4);
    edge_age_us = 2U * CYCLE_US;
    TEST_ASSERT_EQUAL_HEX32(0U, step(sent, 2, 4U * CYCLE_US));
    TEST_ASSERT_UINT32_WITHIN(4U, (uint32_t)((mean_q8 * 256 * 2) / 1000),
                              supervision.sealed.pace.since_q16);
    edge_age_us = 9U * CYCLE_US; /* Older than the cycle: all of its way came after it. */
    TEST_ASSERT_EQUAL_HEX32(0U, step(sent, 2, 4U * CYCLE_US));
    TEST_ASSERT_EQUAL_UINT32((uint32_t)motor_model_step_q16(&motor, config, &sent, 4U * CYCLE_US),
                             supervision.sealed.pace.since_q16);
}
