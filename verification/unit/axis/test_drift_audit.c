/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: what an axis counts at rest is added up, and no more.
 */
#include "axis/drift_audit.h"

#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"
#include "unity.h"

#include <string.h>

#define REST_CYCLES 10U

static const axis_config_t *const head =
    &robot_neuro.axes[NEURO_AXIS_HEAD]; /* 78.74 ticks per mm */
static const axis_config_t *const pitch =
    &robot_neuro.axes[NEURO_AXIS_PITCH]; /* 13.9 ticks per degree */
static drift_audit_t audit;
static int32_t stands_ticks;

void setUp(void)
{
    (void)memset(&audit, 0, sizeof audit);
    stands_ticks = 0;
}

void tearDown(void)
{
}

static void step(int32_t position_ticks, bool is_off)
{
    drift_audit_step(&audit, (int64_t)position_ticks - (int64_t)stands_ticks, is_off,
                     LIMIT_CYCLE_US);
    stands_ticks = position_ticks;
}

static void stand(int32_t position_ticks, uint32_t cycles)
{
    for (uint32_t i = 0U; i < cycles; i++) {
        step(position_ticks, true);
    }
}

void test_SWR_AXIS_022_a_tenth_of_a_millimetre_in_small_steps_is_too_much(void)
{
    stand(0, REST_CYCLES);
    for (int32_t i = 1; i <= 7; i++) {
        stand(i, 5000U);
    }
    TEST_ASSERT_FALSE(drift_audit_is_beyond(&audit, head));
    stand(8, 1U);
    TEST_ASSERT_TRUE(drift_audit_is_beyond(&audit, head));
}

void test_SWR_AXIS_022_half_a_degree_is_too_much_in_either_direction(void)
{
    stand(0, REST_CYCLES);
    stand(-6, 1U);
    TEST_ASSERT_FALSE(drift_audit_is_beyond(&audit, pitch));
    stand(-7, 1U);
    TEST_ASSERT_TRUE(drift_audit_is_beyond(&audit, pitch));
}

void test_SWR_AXIS_022_what_a_scan_makes_of_a_coarse_rotation_is_no_drift(void)
{
    axis_config_t coarse = robot_neuro.axes[NEURO_AXIS_ROTATION];
    coarse.unit_per_tick_q16 *= 5; /* Half a degree is 2.2 ticks. */
    stand(0, REST_CYCLES);
    stand(18, 1U);
    TEST_ASSERT_FALSE(drift_audit_is_beyond(&audit, &coarse));
    stand(19, 1U);
    TEST_ASSERT_TRUE(drift_audit_is_beyond(&audit, &coarse));
    coarse.needle_motion = (uint32_t)NEEDLE_ACROSS;
    stand(3, 1U);
    TEST_ASSERT_TRUE(drift_audit_is_beyond(&audit, &coarse));
}

void test_SWR_AXIS_022_counts_that_come_back_are_no_drift(void)
{
    stand(0, REST_CYCLES);
    for (uint32_t i = 0U; i < 100U; i++) {
        stand(5, 1U);
        stand(0, 1U);
    }
    TEST_ASSERT_EQUAL_INT32(0, audit.idle_ticks);
}

void test_SWR_AXIS_022_what_a_drive_moves_and_its_motor_runs_out_is_no_drift(void)
{
    stand(0, REST_CYCLES);
    step(50, false);
    stand(52, REST_CYCLES);
    stand(52, 100U);
    TEST_ASSERT_EQUAL_INT32(0, audit.idle_ticks);
}

void test_SWR_AXIS_022_a_new_reference_begins_a_new_account(void)
{
    stand(0, REST_CYCLES);
    stand(8, 1U);
    drift_audit_settle(&audit);
    stand(8, 10U);
    TEST_ASSERT_FALSE(drift_audit_is_beyond(&audit, head));
}

void test_SWR_AXIS_054_what_is_confirmed_raises_no_doubt_and_stays_in_the_account(void)
{
    stand(0, REST_CYCLES);
    stand(24, 1U);
    drift_audit_confirm(&audit, head);
    TEST_ASSERT_FALSE(drift_audit_is_beyond(&audit, head));
    stand(31, 1U);
    TEST_ASSERT_FALSE(drift_audit_is_beyond(&audit, head));
    TEST_ASSERT_TRUE(drift_audit_is_far(&audit, head));
    drift_audit_confirm(&audit, head);
    TEST_ASSERT_FALSE(drift_audit_is_far(&audit, head));
    TEST_ASSERT_EQUAL_INT32(0, audit.idle_ticks);
}

void test_SWR_AXIS_054_a_reference_takes_what_was_confirmed_out_of_the_account(void)
{
    stand(0, REST_CYCLES);
    stand(24, 1U);
    drift_audit_confirm(&audit, head);
    drift_audit_settle(&audit);
    stand(31, 1U);
    TEST_ASSERT_FALSE(drift_audit_is_beyond(&audit, head));
    stand(32, 1U);
    TEST_ASSERT_TRUE(drift_audit_is_beyond(&audit, head));
}

void test_SWR_AXIS_023_each_scan_has_an_account_of_its_own(void)
{
    stand(0, REST_CYCLES);
    stand(3, 1U);
    drift_audit_begin_scan(&audit);
    stand(5, 1U);
    TEST_ASSERT_EQUAL_INT32(2, audit.scan_ticks);
    TEST_ASSERT_EQUAL_INT32(5, audit.idle_ticks);
}
