/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: an axis knows how far its position is trusted. A position lost or in doubt
 * becomes true again by the edge of a switch or by the operator, and by nothing else.
 */
#include "unity.h"

#include "axis/axis.h"
#include "axis/supervision.h"
#include "card/card_frame.h"
#include "charts/axis_chart.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"

#include <stddef.h>
#include <string.h>

#define CYCLE_US 1000U
#define SOMEWHERE 1234

static const axis_config_t *const with_switch = &robot_neuro.axes[NEURO_AXIS_INSERTION];
static const axis_config_t *const without_switch = &robot_neuro.axes[NEURO_AXIS_ROTATION];

static axis_t axis;
static const axis_config_t *config;
static card_report_t report;

/* A cycle at rest in which the axis has moved by `ticks`. */
static uint32_t rest_cycle(int32_t ticks)
{
    const card_drive_t off = {.mode = CARD_DRIVE_OFF};
    const axis_sample_t sample = {.applied = &off, .elapsed_us = CYCLE_US, .is_timed = true};
    report.time_us += CYCLE_US;
    if (ticks != 0) {
        report.last_edge_us = report.time_us;
    }
    report.encoder_count += ticks;
    const uint32_t notes = axis_observe(&axis, config, &report, CYCLE_US);
    (void)axis_rest(&axis, CYCLE_US);
    return notes | axis_supervise(&axis, config, false, &sample);
}

/* Cycles in which the card is silent. */
static void silent_cycles(uint32_t cycles)
{
    const card_drive_t off = {.mode = CARD_DRIVE_OFF};
    const axis_sample_t sample = {.applied = &off, .elapsed_us = 0U, .is_timed = false};
    for (uint32_t i = 0U; i < cycles; i++) {
        TEST_ASSERT_EQUAL_HEX32(0U, axis_observe(&axis, config, NULL, CYCLE_US));
        TEST_ASSERT_EQUAL_HEX32(0U, axis_supervise(&axis, config, false, &sample));
    }
}

static void rest_cycles(uint32_t cycles)
{
    for (uint32_t i = 0U; i < cycles; i++) {
        TEST_ASSERT_EQUAL_HEX32(0U, rest_cycle(0));
    }
}

/* No edge for so long that the axis is at rest. */
static void stand_still(void)
{
    report.time_us += LIMIT_SPEED_TIMEOUT_US - CYCLE_US;
    rest_cycles(1U);
}

/* An axis that is enabled, stands, and of which nothing is known. */
static void use(const axis_config_t *which)
{
    config = which;
    (void)memset(&report, 0, sizeof report);
    axis_init(&axis);
    rest_cycles(1U);
    stand_still();
    axis_enable(&axis, false);
}

static void expect(axis_reference_t grade)
{
    TEST_ASSERT_EQUAL(grade, axis.chart.reference);
    TEST_ASSERT_EQUAL((grade == AXIS_REFERENCE_TAKEN) || (grade == AXIS_REFERENCE_VERIFIED),
                      axis_is_homed(&axis));
}

static void make(axis_reference_t grade)
{
    switch (grade) {
    case AXIS_REFERENCE_LOST:
        axis_forget(&axis);
        break;
    case AXIS_REFERENCE_APPROACH:
        (void)axis_begin_homing(&axis, with_switch);
        break;
    case AXIS_REFERENCE_UNVERIFIED:
        axis_restore(&axis, config, SOMEWHERE);
        break;
    case AXIS_REFERENCE_TAKEN:
        (void)axis_begin_homing(&axis, without_switch);
        break;
    case AXIS_REFERENCE_VERIFIED:
        axis_restore(&axis, config, SOMEWHERE);
        (void)axis_confirm(&axis, config);
        break;
    case AXIS_REFERENCE_FRESH:
    case AXIS_REFERENCE_LEAVE:
    case AXIS_REFERENCE_BACK_OFF:
    case AXIS_REFERENCE_LATCH:
    default:
        break;
    }
    expect(grade);
}

static void use_with(const axis_config_t *which, axis_reference_t grade)
{
    use(which);
    make(grade);
}

void setUp(void)
{
    use(with_switch);
}

void tearDown(void)
{
}

void test_SWR_REF_001_nothing_is_known_at_the_start(void)
{
    expect(AXIS_REFERENCE_FRESH);
}

void test_SWR_REF_001_only_taken_and_verified_are_homed(void)
{
    static const axis_reference_t grades[] = {AXIS_REFERENCE_FRESH,    AXIS_REFERENCE_LOST,
                                              AXIS_REFERENCE_APPROACH, AXIS_REFERENCE_UNVERIFIED,
                                              AXIS_REFERENCE_TAKEN,    AXIS_REFERENCE_VERIFIED};
    for (uint32_t i = 0U; i < (sizeof grades / sizeof grades[0]); i++) {
        use_with(without_switch, grades[i]);
    }
}

void test_SWR_REF_001_the_edge_of_the_switch_verifies(void)
{
    make(AXIS_REFERENCE_APPROACH);
    report.limits = CARD_LIMIT_LOWER;
    (void)rest_cycle(0);
    report.limits = 0U;
    (void)rest_cycle(config->switch_hysteresis_ticks + 3);
    report.limits = CARD_LIMIT_LOWER;
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_HOMED, rest_cycle(-config->switch_hysteresis_ticks - 3));
    expect(AXIS_REFERENCE_VERIFIED);
}

void test_SWR_REF_002_a_fresh_axis_without_switch_is_taken_where_it_stands(void)
{
    use(without_switch);
    (void)rest_cycle(-5);
    stand_still();
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_HOMED, axis_begin_homing(&axis, config));
    expect(AXIS_REFERENCE_TAKEN);
    TEST_ASSERT_EQUAL_INT32(config->home_ticks, axis.sealed.encoder.position_ticks);
}

void test_SWR_REF_002_what_was_lost_or_is_in_doubt_is_not_taken_again(void)
{
    static const axis_reference_t grades[] = {AXIS_REFERENCE_LOST, AXIS_REFERENCE_UNVERIFIED};
    for (uint32_t i = 0U; i < (sizeof grades / sizeof grades[0]); i++) {
        use_with(without_switch, grades[i]);
        const int32_t before = axis.sealed.encoder.position_ticks;
        TEST_ASSERT_EQUAL_HEX32(0U, axis_begin_homing(&axis, config));
        expect(grades[i]);
        TEST_ASSERT_EQUAL_INT32(before, axis.sealed.encoder.position_ticks);
    }
}

void test_SWR_REF_002_where_nothing_was_known_nothing_is_lost_without_a_fault(void)
{
    use(without_switch);
    axis_lose_reference(&axis);
    axis_doubt(&axis);
    axis_stop_homing(&axis);
    expect(AXIS_REFERENCE_FRESH);
}

void test_SWR_AXIS_012_a_fault_before_anything_was_known_makes_the_axis_lost(void)
{
    use(without_switch);
    (void)rest_cycle(config->jump_ticks + 1);
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_ENCODER_FAULT, rest_cycle(0));
    expect(AXIS_REFERENCE_LOST);
    axis_enable(&axis, false);
    stand_still();
    TEST_ASSERT_EQUAL_HEX32(0U, axis_begin_homing(&axis, config));
    axis_restore(&axis, config, SOMEWHERE);
    expect(AXIS_REFERENCE_LOST);
    TEST_ASSERT_TRUE(axis_confirm(&axis, config));
}

void test_SWR_STORE_020_an_axis_is_placed_whatever_it_was_and_is_unverified(void)
{
    static const axis_reference_t grades[] = {AXIS_REFERENCE_FRESH,    AXIS_REFERENCE_LOST,
                                              AXIS_REFERENCE_APPROACH, AXIS_REFERENCE_UNVERIFIED,
                                              AXIS_REFERENCE_TAKEN,    AXIS_REFERENCE_VERIFIED};
    for (uint32_t i = 0U; i < (sizeof grades / sizeof grades[0]); i++) {
        use_with((grades[i] == AXIS_REFERENCE_TAKEN) ? without_switch : with_switch, grades[i]);
        axis.sealed.elsewhere_ticks = 7;
        axis_place(&axis, config, SOMEWHERE - 3);
        expect(AXIS_REFERENCE_UNVERIFIED);
        TEST_ASSERT_EQUAL_INT32(SOMEWHERE - 3, axis.sealed.encoder.position_ticks);
        TEST_ASSERT_FALSE(axis_is_contradicted(&axis));
    }
}

void test_SWR_REF_013_an_axis_that_counts_is_not_taken(void)
{
    use(without_switch);
    for (uint32_t i = 0U; i < 8U; i++) {
        (void)rest_cycle(1);
        report.time_us += LIMIT_SPEED_TIMEOUT_US - (2U * CYCLE_US);
        (void)rest_cycle(0);
        TEST_ASSERT_EQUAL_HEX32(0U, axis_begin_homing(&axis, config));
        expect(AXIS_REFERENCE_FRESH);
    }
    (void)rest_cycle(0);
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_HOMED, axis_begin_homing(&axis, config));
    expect(AXIS_REFERENCE_TAKEN);
}

void test_SWR_REF_013_an_axis_that_never_reported_its_counts_is_not_taken(void)
{
    axis_init(&axis);
    axis_enable(&axis, false);
    TEST_ASSERT_EQUAL_HEX32(0U, axis_begin_homing(&axis, without_switch));
    expect(AXIS_REFERENCE_FRESH);
}

void test_SWR_REF_013_an_axis_with_a_switch_may_count_when_it_begins_to_home(void)
{
    (void)rest_cycle(5);
    make(AXIS_REFERENCE_APPROACH);
}

static void expect_moving_in_doubt(axis_reference_t grade, bool is_in_doubt)
{
    use_with(without_switch, grade);
    TEST_ASSERT_FALSE(axis_is_moving_in_doubt(&axis));
    (void)rest_cycle(1);
    TEST_ASSERT_EQUAL(is_in_doubt, axis_is_moving_in_doubt(&axis));
    report.time_us += LIMIT_SPEED_TIMEOUT_US - CYCLE_US;
    (void)rest_cycle(0);
    TEST_ASSERT_FALSE(axis_is_moving_in_doubt(&axis));
}

void test_SWR_REF_006_a_lost_or_unverified_axis_that_counts_cannot_be_compared(void)
{
    expect_moving_in_doubt(AXIS_REFERENCE_LOST, true);
    expect_moving_in_doubt(AXIS_REFERENCE_UNVERIFIED, true);
    expect_moving_in_doubt(AXIS_REFERENCE_FRESH, false);
    expect_moving_in_doubt(AXIS_REFERENCE_TAKEN, false);
    expect_moving_in_doubt(AXIS_REFERENCE_VERIFIED, false);
}

void test_SWR_REF_002_an_axis_with_a_switch_homes_from_every_grade_that_is_not_homed(void)
{
    static const axis_reference_t grades[] = {AXIS_REFERENCE_FRESH, AXIS_REFERENCE_LOST,
                                              AXIS_REFERENCE_UNVERIFIED};
    for (uint32_t i = 0U; i < (sizeof grades / sizeof grades[0]); i++) {
        use_with(with_switch, grades[i]);
        (void)axis_begin_homing(&axis, config);
        expect(AXIS_REFERENCE_APPROACH);
        use_with(with_switch, grades[i]);
        report.limits = CARD_LIMIT_LOWER;
        (void)rest_cycle(0);
        (void)axis_begin_homing(&axis, config);
        expect(AXIS_REFERENCE_LEAVE);
    }
}

void test_SWR_REF_003_a_remembered_position_is_unverified(void)
{
    (void)rest_cycle(50);
    axis_restore(&axis, config, SOMEWHERE);
    expect(AXIS_REFERENCE_UNVERIFIED);
    TEST_ASSERT_EQUAL_INT32(SOMEWHERE, axis.sealed.encoder.position_ticks);
    TEST_ASSERT_EQUAL_INT32(SOMEWHERE, axis.sealed.setpoint_ticks);
    (void)rest_cycle(5);
    TEST_ASSERT_EQUAL_INT32(SOMEWHERE + 5, axis.sealed.encoder.position_ticks);
    rest_cycles(2000U);
}

void test_SWR_REF_003_memory_counts_only_before_anything_else_is_known(void)
{
    static const axis_reference_t grades[] = {AXIS_REFERENCE_LOST, AXIS_REFERENCE_APPROACH,
                                              AXIS_REFERENCE_TAKEN, AXIS_REFERENCE_VERIFIED};
    for (uint32_t i = 0U; i < (sizeof grades / sizeof grades[0]); i++) {
        use_with(with_switch, grades[i]);
        const int32_t before = axis.sealed.encoder.position_ticks;
        axis_restore(&axis, config, SOMEWHERE + 1);
        axis_forget(&axis);
        expect(grades[i]);
        TEST_ASSERT_EQUAL_INT32(before, axis.sealed.encoder.position_ticks);
    }
}

void test_SWR_REF_003_what_is_not_to_be_believed_is_lost(void)
{
    axis_forget(&axis);
    expect(AXIS_REFERENCE_LOST);
}

void test_SWR_REF_004_a_homed_axis_in_doubt_is_unverified(void)
{
    use_with(without_switch, AXIS_REFERENCE_TAKEN);
    axis_doubt(&axis);
    expect(AXIS_REFERENCE_UNVERIFIED);
    TEST_ASSERT_TRUE(axis_is_enabled(&axis));
    use_with(with_switch, AXIS_REFERENCE_VERIFIED);
    axis_doubt(&axis);
    expect(AXIS_REFERENCE_UNVERIFIED);
    axis_doubt(&axis);
    expect(AXIS_REFERENCE_UNVERIFIED);
}

void test_SWR_REF_004_homing_in_doubt_is_lost(void)
{
    make(AXIS_REFERENCE_APPROACH);
    axis_doubt(&axis);
    expect(AXIS_REFERENCE_LOST);
}

void test_SWR_REF_004_an_unverified_axis_that_came_back_elsewhere_is_lost(void)
{
    use_with(without_switch, AXIS_REFERENCE_TAKEN);
    rest_cycles(20U);
    axis_doubt(&axis);
    axis_disable(&axis);
    silent_cycles(1500U);
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_MOVED_OFF, rest_cycle(supervision_rest_ticks(config) + 1));
    expect(AXIS_REFERENCE_LOST);
}

void test_SWR_REF_004_an_unverified_axis_that_came_back_where_it_was_stays_unverified(void)
{
    use_with(without_switch, AXIS_REFERENCE_TAKEN);
    rest_cycles(20U);
    axis_doubt(&axis);
    axis_disable(&axis);
    silent_cycles(1500U);
    TEST_ASSERT_EQUAL_HEX32(0U, rest_cycle(supervision_rest_ticks(config)));
    rest_cycles(2000U);
    expect(AXIS_REFERENCE_UNVERIFIED);
}

void test_SWR_REF_005_the_operator_verifies_what_is_unverified(void)
{
    static const axis_config_t *const configs[] = {&robot_neuro.axes[NEURO_AXIS_INSERTION],
                                                   &robot_neuro.axes[NEURO_AXIS_ROTATION]};
    for (uint32_t i = 0U; i < 2U; i++) {
        use_with(configs[i], AXIS_REFERENCE_UNVERIFIED);
        TEST_ASSERT_TRUE(axis_confirm(&axis, config));
        expect(AXIS_REFERENCE_VERIFIED);
        TEST_ASSERT_EQUAL_INT32(SOMEWHERE, axis.sealed.encoder.position_ticks);
        TEST_ASSERT_FALSE(axis_confirm(&axis, config));
        expect(AXIS_REFERENCE_VERIFIED);
    }
}

void test_SWR_REF_005_what_is_lost_is_verified_only_where_no_switch_can_find_it(void)
{
    use_with(without_switch, AXIS_REFERENCE_LOST);
    TEST_ASSERT_TRUE(axis_confirm(&axis, config));
    expect(AXIS_REFERENCE_VERIFIED);
    use_with(with_switch, AXIS_REFERENCE_LOST);
    TEST_ASSERT_FALSE(axis_confirm(&axis, config));
    expect(AXIS_REFERENCE_LOST);
}

void test_SWR_REF_005_nothing_else_is_confirmed(void)
{
    static const axis_reference_t grades[] = {AXIS_REFERENCE_FRESH, AXIS_REFERENCE_APPROACH,
                                              AXIS_REFERENCE_TAKEN};
    for (uint32_t i = 0U; i < (sizeof grades / sizeof grades[0]); i++) {
        use_with(without_switch, grades[i]);
        TEST_ASSERT_FALSE(axis_confirm(&axis, config));
        expect(grades[i]);
    }
}

void test_SWR_REF_005_once_confirmed_homing_has_its_whole_way(void)
{
    use(without_switch);
    (void)axis_begin_homing(&axis, with_switch);
    axis_lose_reference(&axis);
    TEST_ASSERT_EQUAL_UINT32(1U, axis.sealed.homing.has_nearest);
    TEST_ASSERT_TRUE(axis_confirm(&axis, config));
    TEST_ASSERT_EQUAL_UINT32(0U, axis.sealed.homing.has_nearest);
}

void test_SWR_REF_005_only_an_axis_without_switch_that_was_known_waits_for_the_operator(void)
{
    use_with(without_switch, AXIS_REFERENCE_FRESH);
    TEST_ASSERT_FALSE(axis_needs_confirmation(&axis, config));
    use_with(without_switch, AXIS_REFERENCE_TAKEN);
    TEST_ASSERT_FALSE(axis_needs_confirmation(&axis, config));
    use_with(without_switch, AXIS_REFERENCE_LOST);
    TEST_ASSERT_TRUE(axis_needs_confirmation(&axis, config));
    TEST_ASSERT_FALSE(axis_needs_confirmation(&axis, with_switch));
    use_with(without_switch, AXIS_REFERENCE_UNVERIFIED);
    TEST_ASSERT_TRUE(axis_needs_confirmation(&axis, config));
}

void test_SWR_AXIS_053_counts_say_where_it_is_until_they_break(void)
{
    use_with(with_switch, AXIS_REFERENCE_VERIFIED);
    TEST_ASSERT_TRUE(axis_is_placed(&axis));
    use_with(with_switch, AXIS_REFERENCE_UNVERIFIED);
    TEST_ASSERT_TRUE(axis_is_placed(&axis));
    use_with(with_switch, AXIS_REFERENCE_LOST);
    TEST_ASSERT_FALSE(axis_is_placed(&axis));
    axis_remember(&axis, SOMEWHERE);
    TEST_ASSERT_FALSE(axis_is_placed(&axis));
    axis_place(&axis, config, SOMEWHERE);
    axis_lose_reference(&axis);
    TEST_ASSERT_TRUE(axis_is_placed(&axis));
    axis_break_place(&axis);
    TEST_ASSERT_FALSE(axis_is_placed(&axis));
}

void test_SWR_AXIS_055_it_stands_as_parked_until_more_is_known_of_it(void)
{
    use_with(with_switch, AXIS_REFERENCE_FRESH);
    axis_break_place(&axis);
    TEST_ASSERT_TRUE(axis_is_as_parked(&axis));
    axis_forget(&axis);
    TEST_ASSERT_FALSE(axis_is_as_parked(&axis));
    use_with(with_switch, AXIS_REFERENCE_LOST);
    axis.sealed.place = 0U;
    axis_forget(&axis);
    TEST_ASSERT_TRUE(axis_is_as_parked(&axis));
    axis_distrust(&axis);
    TEST_ASSERT_FALSE(axis_is_as_parked(&axis));
    axis_place(&axis, config, SOMEWHERE);
    axis_refuse_parking(&axis);
    TEST_ASSERT_FALSE(axis_is_as_parked(&axis));
    TEST_ASSERT_TRUE(axis_is_placed(&axis));
}

void test_SWR_AXIS_040_it_says_what_a_confirmation_would_verify(void)
{
    use_with(with_switch, AXIS_REFERENCE_FRESH);
    TEST_ASSERT_FALSE(axis_is_confirmable(&axis, config));
    use_with(with_switch, AXIS_REFERENCE_VERIFIED);
    TEST_ASSERT_FALSE(axis_is_confirmable(&axis, config));
    axis.sealed.elsewhere_ticks = 1;
    TEST_ASSERT_FALSE(axis_is_confirmable(&axis, config));
    use_with(with_switch, AXIS_REFERENCE_UNVERIFIED);
    TEST_ASSERT_TRUE(axis_is_confirmable(&axis, config));
    use_with(with_switch, AXIS_REFERENCE_LOST);
    TEST_ASSERT_FALSE(axis_is_confirmable(&axis, config));
    axis.sealed.elsewhere_ticks = 1;
    TEST_ASSERT_TRUE(axis_is_confirmable(&axis, config));
    use_with(without_switch, AXIS_REFERENCE_LOST);
    TEST_ASSERT_TRUE(axis_is_confirmable(&axis, config));
}
