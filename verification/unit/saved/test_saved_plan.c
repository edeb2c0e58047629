/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: the effect of restoring is stated for each axis, with its reason; an axis that
 * the counters of this power-on contradict, that was not known or stands there already is left
 * alone. */
#include "unity.h"

#include "axis/supervision.h"
#include "charts/axis_chart.h"
#include "robot/robot_neuro.h"
#include "saved/saved_plan.h"

#include <string.h>

#define POWER_ON 0xCAFE0001U

static saved_t saved;
static snapshot_t snapshot;
static saved_plan_t plan;
static int32_t rest;

void setUp(void)
{
    (void)memset(&saved, 0, sizeof saved);
    (void)memset(&snapshot, 0, sizeof snapshot);
    saved.record.power_on = POWER_ON;
    snapshot.power_on = POWER_ON;
    rest = supervision_rest_ticks(&robot_neuro.axes[NEURO_AXIS_HEAD]);
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        saved.record.axes[i] = (kept_axis_t){.grade = (uint32_t)KEPT_KNOWN,
                                             .position_ticks = -1000 * (int32_t)i,
                                             .reading_ticks = 50 * (int32_t)i};
        snapshot.axes[i].reference = (uint32_t)AXIS_REFERENCE_LOST;
        snapshot.axes[i].reading_ticks = 50 * (int32_t)i;
    }
}

void tearDown(void)
{
}

static const saved_row_t *head(void)
{
    saved_plan_make(&plan, &saved, &snapshot, &robot_neuro);
    return &plan.rows[NEURO_AXIS_HEAD];
}

static void expect_head(saved_why_t why)
{
    const bool is_restored = why <= SAVED_WHY_MISCOUNTED;
    TEST_ASSERT_EQUAL(why, head()->why);
    TEST_ASSERT_EQUAL_UINT32(is_restored ? 1U : 0U, (plan.axes >> NEURO_AXIS_HEAD) & 1U);
}

static int32_t upwards(int32_t ticks)
{
    return (robot_neuro.axes[NEURO_AXIS_HEAD].is_encoder_inverted != 0U) ? -ticks : ticks;
}

void test_SWR_STORE_027_in_the_same_power_on_what_was_counted_is_added(void)
{
    snapshot.axes[NEURO_AXIS_HEAD].reading_ticks += rest;
    snapshot.axes[NEURO_AXIS_HEAD].position_ticks = 33;
    expect_head(SAVED_WHY_COUNTS_AGREE);
    TEST_ASSERT_EQUAL_HEX32(0x7FU, plan.axes);
    TEST_ASSERT_EQUAL_INT32(33, head()->now_ticks);
    TEST_ASSERT_EQUAL_INT32(-1000 * NEURO_AXIS_HEAD, head()->saved_ticks);
    TEST_ASSERT_EQUAL_INT32(head()->saved_ticks + upwards(rest), head()->next_ticks);
}

void test_SWR_STORE_027_an_axis_whose_counter_has_moved_stays(void)
{
    snapshot.axes[NEURO_AXIS_HEAD].reading_ticks += rest + 1;
    expect_head(SAVED_WHY_MOVED);
    snapshot.axes[NEURO_AXIS_HEAD].reading_ticks -= 2 * (rest + 1);
    expect_head(SAVED_WHY_MOVED);
    saved.origin = SAVED_UNSEALED;
    expect_head(SAVED_WHY_MOVED);
    TEST_ASSERT_EQUAL_HEX32(0x7FU & ~(1U << NEURO_AXIS_HEAD), plan.axes);
}

void test_SWR_REF_020_an_axis_that_is_miscounted_is_restored_where_it_was_saved(void)
{
    snapshot.axes[NEURO_AXIS_HEAD].reading_ticks += rest + 1;
    saved.miscounted = 1U << NEURO_AXIS_HEAD;
    expect_head(SAVED_WHY_MISCOUNTED);
    TEST_ASSERT_EQUAL_HEX32(0x7FU, plan.axes);
    TEST_ASSERT_EQUAL_INT32(head()->saved_ticks, head()->next_ticks);
    TEST_ASSERT_TRUE(saved_plan_fits(&plan, &saved));
}

void test_SWR_REF_020_an_axis_that_has_not_moved_is_not_miscounted(void)
{
    static const uint32_t axes[] = {1U << NEURO_AXIS_FEET, 1U << 7, UINT32_MAX};
    snapshot.axes[NEURO_AXIS_HEAD].reading_ticks += rest + 1;
    expect_head(SAVED_WHY_MOVED);
    TEST_ASSERT_TRUE(saved_plan_fits(&plan, &saved));
    for (uint32_t i = 0U; i < (sizeof axes / sizeof axes[0]); i++) {
        saved.miscounted = axes[i];
        (void)head();
        TEST_ASSERT_FALSE(saved_plan_fits(&plan, &saved));
    }
    saved.miscounted = 1U << NEURO_AXIS_HEAD;
    snapshot.power_on++; /* The counts prove nothing there. */
    expect_head(SAVED_WHY_OTHER_POWER_ON);
    TEST_ASSERT_FALSE(saved_plan_fits(&plan, &saved));
}

void test_SWR_STORE_027_in_another_power_on_the_counts_say_nothing(void)
{
    snapshot.power_on++;
    snapshot.axes[NEURO_AXIS_HEAD].reading_ticks = 123456;
    expect_head(SAVED_WHY_OTHER_POWER_ON);
    TEST_ASSERT_EQUAL_INT32(head()->saved_ticks, head()->next_ticks);
}

void test_SWR_STORE_027_where_it_comes_from_is_said(void)
{
    saved.origin = SAVED_UNSEALED;
    expect_head(SAVED_WHY_UNSEALED);
    snapshot.power_on++;
    expect_head(SAVED_WHY_UNSEALED);
    saved.origin = SAVED_OLD_LIST;
    expect_head(SAVED_WHY_OLD_LIST);
    snapshot.power_on = 0U; /* An old list is of no power-on. */
    saved.record.power_on = 0U;
    snapshot.axes[NEURO_AXIS_HEAD].reading_ticks = 123456;
    expect_head(SAVED_WHY_OLD_LIST);
    TEST_ASSERT_EQUAL_INT32(head()->saved_ticks, head()->next_ticks);
}

void test_SWR_STORE_027_what_was_not_known_is_not_restored(void)
{
    static const uint32_t grades[] = {KEPT_FRESH, KEPT_LOST, KEPT_KNOWN + 1U, UINT32_MAX};
    for (uint32_t i = 0U; i < (sizeof grades / sizeof grades[0]); i++) {
        saved.record.axes[NEURO_AXIS_HEAD].grade = grades[i];
        expect_head(SAVED_WHY_NOT_KNOWN);
    }
}

void test_SWR_STORE_027_an_axis_that_is_homed_there_stays_homed(void)
{
    snapshot_axis_t *shown = &snapshot.axes[NEURO_AXIS_HEAD];
    shown->position_ticks = saved.record.axes[NEURO_AXIS_HEAD].position_ticks + rest;
    shown->reference = (uint32_t)AXIS_REFERENCE_VERIFIED;
    expect_head(SAVED_WHY_STANDS_THERE);
    shown->reference = (uint32_t)AXIS_REFERENCE_TAKEN;
    expect_head(SAVED_WHY_STANDS_THERE);
    shown->reference = (uint32_t)AXIS_REFERENCE_UNVERIFIED;
    expect_head(SAVED_WHY_COUNTS_AGREE);
    shown->reference = (uint32_t)AXIS_REFERENCE_VERIFIED;
    shown->position_ticks++;
    expect_head(SAVED_WHY_COUNTS_AGREE);
}

void test_SWR_STORE_027_no_sum_overflows(void)
{
    saved.record.axes[NEURO_AXIS_HEAD].position_ticks = INT32_MIN;
    snapshot.axes[NEURO_AXIS_HEAD].reading_ticks -= upwards(1);
    TEST_ASSERT_EQUAL_INT32(INT32_MIN, head()->next_ticks);
}

static bool holds_after(int32_t way)
{
    saved_plan_t now;
    (void)head();
    snapshot.axes[NEURO_AXIS_HEAD].position_ticks += way;
    saved_plan_make(&now, &saved, &snapshot, &robot_neuro);
    snapshot.axes[NEURO_AXIS_HEAD].position_ticks -= way;
    return saved_plan_holds(&plan, &now, &robot_neuro);
}

void test_SWR_STORE_030_what_was_shown_holds_while_no_axis_moves(void)
{
    TEST_ASSERT_TRUE(holds_after(0));
    TEST_ASSERT_TRUE(holds_after(rest));
    TEST_ASSERT_TRUE(holds_after(-rest));
    TEST_ASSERT_FALSE(holds_after(rest + 1));
    TEST_ASSERT_FALSE(holds_after(-rest - 1));
}

void test_SWR_STORE_030_what_was_shown_does_not_hold_for_other_axes_or_another_power_on(void)
{
    saved_plan_t now;
    (void)head();
    now = plan;
    now.axes ^= 1U;
    TEST_ASSERT_FALSE(saved_plan_holds(&plan, &now, &robot_neuro));
    now = plan;
    now.power_on++;
    TEST_ASSERT_FALSE(saved_plan_holds(&plan, &now, &robot_neuro));
}
