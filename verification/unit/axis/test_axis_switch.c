/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: switch and counts are held against each other. A homed axis knows where its
 * switch must be, and homing that meets it elsewhere than the counts have it makes the axis lost
 * until the two agree again or the operator has looked.
 */
#include "unity.h"

#include "axis/axis.h"
#include "axis/supervision.h"
#include "card/card_frame.h"
#include "charts/axis_chart.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"

#include <string.h>

#define CYCLE_US 1000U
#define ELSEWHERE 3000
#define CLEAR 3

/* An axis, and how many ticks 0.5 mm or 2.5 degrees of it are. */
typedef struct {
    const axis_config_t *config;
    int32_t margin;
} subject_t;

static const subject_t subjects[] = {{&robot_neuro.axes[NEURO_AXIS_INSERTION], 1666},
                                     {&robot_neuro.axes[NEURO_AXIS_HEAD], 39},
                                     {&robot_neuro.axes[NEURO_AXIS_PITCH], 34}};
#define SUBJECTS (sizeof subjects / sizeof subjects[0])

static axis_t axis;
static const axis_config_t *config;
static int32_t margin;
static card_report_t report;

static uint32_t observe_way(int32_t ticks)
{
    report.time_us += CYCLE_US;
    report.last_edge_us = report.time_us;
    report.encoder_count += (config->is_encoder_inverted != 0U) ? -ticks : ticks;
    return axis_observe(&axis, config, &report, CYCLE_US);
}

static uint32_t observe_switch(bool is_active)
{
    const bool is_lower = config->limit_switch == (uint8_t)LIMIT_SWITCH_LOWER;
    report.limits = is_active ? (is_lower ? CARD_LIMIT_LOWER : CARD_LIMIT_UPPER) : 0U;
    return observe_way(0);
}

/* The position so many ticks away from home. */
static int32_t away(int32_t ticks)
{
    const bool is_upper = config->limit_switch == (uint8_t)LIMIT_SWITCH_UPPER;
    return config->home_ticks + (is_upper ? -ticks : ticks);
}

static uint32_t move_to(int32_t position_ticks)
{
    uint32_t notes = 0U;
    while (axis.sealed.encoder.position_ticks != position_ticks) {
        const int32_t way = position_ticks - axis.sealed.encoder.position_ticks;
        const int32_t most = config->jump_ticks;
        notes |= observe_way((way > most) ? most : ((way < -most) ? -most : way));
    }
    return notes;
}

static void use(const subject_t *subject)
{
    config = subject->config;
    margin = subject->margin;
    (void)memset(&report, 0, sizeof report);
    axis_init(&axis);
    TEST_ASSERT_EQUAL_HEX32(0U, axis_observe(&axis, config, &report, CYCLE_US));
    axis_enable(&axis, false);
}

/* Homes by a switch that acts where the axis has `ticks` away from home. @return the last notes */
static uint32_t home_at(int32_t ticks)
{
    const int32_t clear = config->switch_hysteresis_ticks + CLEAR;
    axis_enable(&axis, false);
    TEST_ASSERT_EQUAL_HEX32(0U, move_to(away(ticks + clear)));
    TEST_ASSERT_EQUAL_HEX32(0U, axis_begin_homing(&axis, config));
    TEST_ASSERT_EQUAL_HEX32(0U, move_to(away(ticks)));
    TEST_ASSERT_EQUAL_HEX32(0U, observe_switch(true));
    TEST_ASSERT_EQUAL_HEX32(0U, observe_switch(false));
    TEST_ASSERT_EQUAL_HEX32(0U, move_to(away(ticks + clear)));
    TEST_ASSERT_EQUAL(AXIS_REFERENCE_LATCH, axis.chart.reference);
    TEST_ASSERT_EQUAL_HEX32(0U, move_to(away(ticks)));
    const uint32_t notes = observe_switch(true);
    TEST_ASSERT_EQUAL_INT32(config->home_ticks, axis.sealed.encoder.position_ticks);
    TEST_ASSERT_EQUAL_HEX32(0U, observe_switch(false));
    return notes;
}

static void expect_homed(uint32_t notes)
{
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_HOMED, notes);
    TEST_ASSERT_EQUAL(AXIS_REFERENCE_VERIFIED, axis.chart.reference);
    TEST_ASSERT_FALSE(axis_is_contradicted(&axis));
}

static void expect_contradicted(uint32_t notes, int32_t ticks)
{
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_SWITCH_ELSEWHERE, notes);
    TEST_ASSERT_EQUAL(AXIS_REFERENCE_LOST, axis.chart.reference);
    TEST_ASSERT_TRUE(axis_is_faulty(&axis));
    TEST_ASSERT_TRUE(axis_is_contradicted(&axis));
    TEST_ASSERT_EQUAL_INT32(away(ticks) - config->home_ticks, axis.sealed.contradiction_ticks);
}

/* An axis that is homed and stands at home. */
static void use_homed(const subject_t *subject)
{
    use(subject);
    expect_homed(home_at(0));
}

/* An axis that was homed and is lost. */
static void use_lost(const subject_t *subject)
{
    use_homed(subject);
    axis_lose_reference(&axis);
}

void setUp(void)
{
    use(&subjects[0]);
}

void tearDown(void)
{
}

void test_SWR_AXIS_025_a_switch_that_is_active_where_it_must_have_released_is_a_fault(void)
{
    for (uint32_t i = 0U; i < SUBJECTS; i++) {
        use_homed(&subjects[i]);
        const int32_t farthest = config->switch_hysteresis_ticks + margin;
        (void)observe_switch(true);
        TEST_ASSERT_EQUAL_HEX32(0U, move_to(away(farthest)));
        TEST_ASSERT_TRUE(axis_is_homed(&axis));
        TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_SWITCH_ELSEWHERE, move_to(away(farthest + 1)));
        TEST_ASSERT_EQUAL(AXIS_REFERENCE_LOST, axis.chart.reference);
        TEST_ASSERT_TRUE(axis_is_faulty(&axis));
        TEST_ASSERT_EQUAL_INT32(away(farthest + 1) - config->home_ticks,
                                axis.sealed.contradiction_ticks);
        TEST_ASSERT_FALSE(axis_is_contradicted(&axis));
        TEST_ASSERT_EQUAL_HEX32(0U, observe_way(0));
    }
}

void test_SWR_AXIS_025_a_switch_that_is_free_where_it_must_be_active_is_a_fault(void)
{
    for (uint32_t i = 0U; i < SUBJECTS; i++) {
        use_homed(&subjects[i]);
        TEST_ASSERT_EQUAL_HEX32(0U, move_to(away(-margin)));
        TEST_ASSERT_TRUE(axis_is_homed(&axis));
        TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_SWITCH_ELSEWHERE, move_to(away(-margin - 1)));
        TEST_ASSERT_EQUAL(AXIS_REFERENCE_LOST, axis.chart.reference);
        TEST_ASSERT_EQUAL_INT32(away(-margin - 1) - config->home_ticks,
                                axis.sealed.contradiction_ticks);
    }
}

void test_SWR_AXIS_025_a_switch_that_does_what_it_should_is_no_fault(void)
{
    for (uint32_t i = 0U; i < SUBJECTS; i++) {
        use_homed(&subjects[i]);
        TEST_ASSERT_EQUAL_HEX32(0U, move_to(away(5 * margin)));
        TEST_ASSERT_EQUAL_HEX32(0U, move_to(config->home_ticks));
        TEST_ASSERT_EQUAL_HEX32(0U, observe_switch(true));
        TEST_ASSERT_EQUAL_HEX32(0U, move_to(away(-3 * margin)));
        TEST_ASSERT_TRUE(axis_is_homed(&axis));
    }
}

void test_SWR_AXIS_025_where_nobody_knows_the_position_the_switch_is_not_compared(void)
{
    TEST_ASSERT_EQUAL_HEX32(0U, move_to(away(-3 * margin)));
    TEST_ASSERT_EQUAL_HEX32(0U, observe_switch(true));
    TEST_ASSERT_EQUAL_HEX32(0U, move_to(away(3 * margin)));
    use(&subjects[0]);
    axis_restore(&axis, config, away(3 * margin));
    TEST_ASSERT_EQUAL_HEX32(0U, observe_switch(true));
    TEST_ASSERT_EQUAL(AXIS_REFERENCE_UNVERIFIED, axis.chart.reference);
}

void test_SWR_AXIS_025_an_axis_without_a_switch_has_none_to_compare(void)
{
    const subject_t rotation = {&robot_neuro.axes[NEURO_AXIS_ROTATION], 55};
    use(&rotation);
    report.time_us += LIMIT_SPEED_TIMEOUT_US;
    TEST_ASSERT_EQUAL_HEX32(0U, axis_observe(&axis, config, &report, CYCLE_US));
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_HOMED, axis_begin_homing(&axis, config));
    report.limits = CARD_LIMIT_LOWER | CARD_LIMIT_UPPER;
    TEST_ASSERT_EQUAL_HEX32(0U, move_to(-1000));
    TEST_ASSERT_EQUAL_HEX32(0U, move_to(1000));
    TEST_ASSERT_TRUE(axis_is_homed(&axis));
}

void test_SWR_AXIS_026_the_first_homing_is_right_wherever_it_meets_the_switch(void)
{
    for (uint32_t i = 0U; i < SUBJECTS; i++) {
        use(&subjects[i]);
        expect_homed(home_at(ELSEWHERE));
        use(&subjects[i]);
        expect_homed(home_at(-ELSEWHERE));
        use(&subjects[i]);
        axis_forget(&axis);
        expect_homed(home_at(-ELSEWHERE));
    }
}

void test_SWR_AXIS_026_home_may_be_as_far_from_where_it_was_as_the_margin(void)
{
    for (uint32_t i = 0U; i < SUBJECTS; i++) {
        use_lost(&subjects[i]);
        expect_homed(home_at(margin));
        axis_lose_reference(&axis);
        expect_homed(home_at(-margin));
    }
}

void test_SWR_AXIS_026_home_that_is_farther_from_where_it_was_makes_the_axis_lost(void)
{
    for (uint32_t i = 0U; i < SUBJECTS; i++) {
        use_lost(&subjects[i]);
        expect_contradicted(home_at(margin + 1), margin + 1);
        use_lost(&subjects[i]);
        expect_contradicted(home_at(-margin - 1), -margin - 1);
    }
}

/* The axis shows itself at home; that is ELSEWHERE away from where its counts have it. */
void test_SWR_AXIS_026_the_same_wrong_place_again_does_not_home_it(void)
{
    for (uint32_t i = 0U; i < SUBJECTS; i++) {
        use_lost(&subjects[i]);
        expect_contradicted(home_at(ELSEWHERE), ELSEWHERE);
        expect_contradicted(home_at(0), ELSEWHERE);
        expect_contradicted(home_at(margin / 2), ELSEWHERE + (margin / 2));
    }
}

void test_SWR_AXIS_026_homing_that_meets_the_switch_where_the_counts_had_it_homes_it(void)
{
    for (uint32_t i = 0U; i < SUBJECTS; i++) {
        use_lost(&subjects[i]);
        expect_contradicted(home_at(ELSEWHERE), ELSEWHERE);
        expect_homed(home_at(-ELSEWHERE + margin));
        axis_lose_reference(&axis);
        expect_homed(home_at(0));
    }
}

void test_SWR_AXIS_026_what_the_operator_confirms_is_home_from_then_on(void)
{
    for (uint32_t i = 0U; i < SUBJECTS; i++) {
        use_lost(&subjects[i]);
        TEST_ASSERT_FALSE(axis_confirm(&axis, config));
        expect_contradicted(home_at(ELSEWHERE), ELSEWHERE);
        TEST_ASSERT_TRUE(axis_confirm(&axis, config));
        TEST_ASSERT_TRUE(axis_is_homed(&axis));
        TEST_ASSERT_FALSE(axis_is_contradicted(&axis));
        axis_lose_reference(&axis);
        TEST_ASSERT_FALSE(axis_confirm(&axis, config));
        expect_homed(home_at(0));
        axis_lose_reference(&axis);
        expect_contradicted(home_at(-ELSEWHERE), -ELSEWHERE);
    }
}

void test_SWR_AXIS_026_a_position_that_was_handed_in_is_one_that_was_known(void)
{
    axis_restore(&axis, config, away(ELSEWHERE));
    expect_contradicted(home_at(-ELSEWHERE), -ELSEWHERE);
    use(&subjects[0]);
    axis_restore(&axis, config, away(ELSEWHERE));
    TEST_ASSERT_TRUE(axis_confirm(&axis, config));
    axis_lose_reference(&axis);
    expect_contradicted(home_at(ELSEWHERE), ELSEWHERE);
}

/* Lost at once, and confirmed where it stood: it has no switch that says where that is. */
void test_SWR_AXIS_026_a_position_that_was_confirmed_is_one_that_was_known(void)
{
    axis_config_t in_place = *config;
    in_place.home_method = (uint8_t)HOME_IN_PLACE;
    axis_forget(&axis);
    TEST_ASSERT_TRUE(axis_confirm(&axis, &in_place));
    axis_lose_reference(&axis);
    expect_contradicted(home_at(ELSEWHERE), ELSEWHERE);
}

void test_SWR_AXIS_026_nothing_but_these_two_ends_a_contradiction(void)
{
    use_lost(&subjects[0]);
    expect_contradicted(home_at(ELSEWHERE), ELSEWHERE);
    axis_enable(&axis, false);
    axis_doubt(&axis);
    axis_restore(&axis, config, 0);
    axis_forget(&axis);
    TEST_ASSERT_EQUAL_HEX32(0U, axis_begin_homing(&axis, config));
    axis_stop_homing(&axis);
    axis_disable(&axis);
    TEST_ASSERT_TRUE(axis_is_contradicted(&axis));
    TEST_ASSERT_FALSE(axis_is_homed(&axis));
}
