/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: counts that a missed report or a brief drive leaves in doubt accuse no axis,
 * and those that are lost all the same are found.
 */
#include "unity.h"

#include "axis/encoder.h"
#include "axis/supervision.h"
#include "card/card_frame.h"
#include "limits/requirement_limits.h"
#include "motion/motor_model.h"

#include "unit/axis/axis_counts_world.inc"

void setUp(void)
{
    use(head);
}

void tearDown(void)
{
}

static const card_drive_t off = {CARD_DRIVE_OFF, 0U, 0U, 0U};

/* Cycles of the motor without a report, and one with it: their whole way comes at once. */
static uint32_t missed(card_drive_t sent, uint32_t cycles, int32_t percent)
{
    const int32_t before_ticks = position_ticks;
    for (uint32_t i = 0U; i < cycles; i++) {
        way_q16 += (motor_model_step_q16(&motor, config, &sent, CYCLE_US) * percent) / 100;
        TEST_ASSERT_EQUAL_HEX32(0U, step(sent, 0, 0U));
    }
    way_q16 += (motor_model_step_q16(&motor, config, &sent, CYCLE_US) * percent) / 100;
    edge_age_us = ENCODER_AGE_UNKNOWN;
    return step(sent, (int32_t)(way_q16 / 65536) - before_ticks, (cycles + 1U) * CYCLE_US);
}

/* One of three reports comes. */
static uint32_t run_missed(int32_t percent, uint32_t reports)
{
    uint32_t notes = 0U;
    for (uint32_t i = 0U; (i < reports) && (notes == 0U); i++) {
        notes = missed(drive(true), 2U, percent);
    }
    return notes;
}

void test_SWR_AXIS_047_reports_that_are_missed_under_one_drive_leave_nothing_out(void)
{
    TEST_ASSERT_EQUAL_HEX32(0U, run(drive(true), 100, 2U * SHORT_CYCLES));
    TEST_ASSERT_EQUAL_HEX32(0U, run_missed(100, LONG_CYCLES));
    TEST_ASSERT_EQUAL_INT64(0, supervision.sealed.account.short_e2_q16);
    TEST_ASSERT_EQUAL_INT64(0, supervision.sealed.account.over_e2_q16);
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_WRONG_SPEED, run_missed(50, LONG_CYCLES));
}

/* A motor that was off and on again meanwhile begins anew. */
void test_SWR_AXIS_047_what_a_changed_drive_made_unheard_is_left_out(void)
{
    TEST_ASSERT_EQUAL_HEX32(0U, run(drive(true), 100, 2U * SHORT_CYCLES));
    for (uint32_t i = 0U; i < LONG_CYCLES; i++) {
        TEST_ASSERT_EQUAL_HEX32(0U, step(off, 0, 0U));
        TEST_ASSERT_EQUAL_HEX32(0U, step(drive(true), 0, 2U * CYCLE_US));
        TEST_ASSERT_EQUAL_UINT32(LIMIT_RISING_TIME_US, supervision.sealed.account.unsure_us);
        TEST_ASSERT_EQUAL_UINT32(0U, supervision.sealed.off_us);
        TEST_ASSERT_EQUAL_HEX32(0U, run(drive(true), 60, 10U));
    }
    TEST_ASSERT_EQUAL_INT64(0, supervision.sealed.account.short_e2_q16);
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_WRONG_SPEED, run(drive(true), 50, 6U * SHORT_CYCLES));
}

void test_SWR_AXIS_047_a_reversal_unheard_is_left_out(void)
{
    for (uint32_t i = 0U; i < 2U; i++) {
        const bool is_upwards = i == 0U;
        use(head);
        TEST_ASSERT_EQUAL_HEX32(0U, run(drive(is_upwards), 100, 2U * SHORT_CYCLES));
        TEST_ASSERT_EQUAL_HEX32(0U, step(drive(!is_upwards), 0, 0U));
        TEST_ASSERT_EQUAL_HEX32(0U, step(drive(!is_upwards), 0, 2U * CYCLE_US));
        TEST_ASSERT_EQUAL_UINT32(LIMIT_RISING_TIME_US, supervision.sealed.account.unsure_us);
    }
}

void test_SWR_AXIS_047_a_motor_that_is_off_is_known_again(void)
{
    TEST_ASSERT_EQUAL_HEX32(0U, run(drive(true), 100, 2U * SHORT_CYCLES));
    TEST_ASSERT_EQUAL_HEX32(0U, step(drive(true), 0, 0U));
    TEST_ASSERT_EQUAL_HEX32(0U, step(off, 0, 2U * CYCLE_US));
    TEST_ASSERT_NOT_EQUAL_UINT32(0U, supervision.sealed.account.unsure_us);
    TEST_ASSERT_EQUAL_HEX32(0U, rest(1U));
    TEST_ASSERT_EQUAL_UINT32(0U, supervision.sealed.account.unsure_us);
}

/* The model runs on as if it had never been off; counts of a motor that begins anew are not uneven.
 */
void test_SWR_AXIS_047_until_the_speed_is_known_no_count_is_uneven(void)
{
    TEST_ASSERT_EQUAL_HEX32(0U, run(drive(true), 100, 2U * SHORT_CYCLES));
    TEST_ASSERT_EQUAL_HEX32(0U, step(off, 0, 0U));
    TEST_ASSERT_EQUAL_HEX32(0U, step(drive(true), 0, 2U * CYCLE_US));
    motor = (motor_model_t){0};
    TEST_ASSERT_EQUAL_HEX32(0U, run(drive(true), 100, SHORT_CYCLES - 13U));
    expect_begun(true);
    TEST_ASSERT_EQUAL_HEX32(0U, run(drive(true), 100, 10U));
    expect_begun(false);
}

/* Steady, then another drive for `brief_us`, in which the motor runs on and its card stands still,
 * and on with the first one. */
static uint32_t run_on(card_drive_t brief, uint32_t brief_us, uint32_t times)
{
    uint32_t notes = run(drive(true), 100, 2U * SHORT_CYCLES);
    for (uint32_t i = 0U; (i < times) && (notes == 0U); i++) {
        notes = step(brief, 0, brief_us) | run(drive(true), 100, SHORT_CYCLES);
    }
    return notes;
}

void test_SWR_AXIS_160_a_drive_of_less_than_half_a_cycle_changes_nothing_for_its_counts(void)
{
    const card_drive_t changes[] = {off, drive(false)};
    for (uint32_t i = 0U; i < 2U; i++) {
        use(head);
        TEST_ASSERT_EQUAL_HEX32(0U, run_on(changes[i], LIMIT_BRIEF_DRIVE_US - 1U, 10U));
        TEST_ASSERT_EQUAL_HEX32(0U, run_on(changes[i], 33U, 10U));
        TEST_ASSERT_EQUAL_INT64(0, supervision.sealed.account.short_e2_q16);
        TEST_ASSERT_EQUAL_INT64(0, supervision.sealed.account.over_e2_q16);
    }
}

void test_SWR_AXIS_160_a_longer_one_and_the_same_one_are_judged(void)
{
    TEST_ASSERT_EQUAL_HEX32(0U, run(drive(true), 100, 2U * SHORT_CYCLES));
    TEST_ASSERT_EQUAL_HEX32(0U, step(drive(true), 0, 33U));
    TEST_ASSERT_EQUAL_UINT32(0U, supervision.sealed.account.unsure_us);
    TEST_ASSERT_EQUAL_HEX32(0U, step(off, 0, LIMIT_BRIEF_DRIVE_US));
    TEST_ASSERT_EQUAL_UINT32(0U, supervision.sealed.account.unsure_us);
    use(head);
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_UNEVEN_COUNTS, run_on(off, LIMIT_BRIEF_DRIVE_US, 10U));
}

/* At rest a short report is one of rest, and a motor that is off is known again. */
void test_SWR_AXIS_160_a_short_report_at_rest_leaves_nothing_out(void)
{
    TEST_ASSERT_EQUAL_HEX32(0U, run(drive(true), 100, 2U * SHORT_CYCLES));
    TEST_ASSERT_EQUAL_HEX32(0U, step(off, 0, 33U));
    TEST_ASSERT_EQUAL_UINT32(LIMIT_RISING_TIME_US, supervision.sealed.account.unsure_us);
    TEST_ASSERT_EQUAL_HEX32(0U, step(off, 0, 33U));
    TEST_ASSERT_EQUAL_UINT32(0U, supervision.sealed.account.unsure_us);
}

/* Half of what is counted gets lost: it is found between such cycles as well. */
void test_SWR_AXIS_160_lost_counts_are_found_between_brief_changes(void)
{
    uint32_t notes = run(drive(true), 100, 2U * SHORT_CYCLES);
    for (uint32_t i = 0U; (i < 100U) && (notes == 0U); i++) {
        notes = step(off, 0, 33U) | run(drive(true), 50, 4U * SHORT_CYCLES);
    }
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_WRONG_SPEED, notes);
}
