/* SPDX-License-Identifier: Apache-2.0 */
/* Rule under test: active from the home position outwards, released a little inwards of it,
 * bouncing 1 to 5 ms. */
#include "unity.h"

#include "sim/model/sim_motor.h"
#include "sim/model/sim_switch.h"

#include <string.h>

#define HOME 500
#define HYSTERESIS 10

static sim_switch_t limit_switch;

static void start(limit_switch_t end, double position, uint32_t seed)
{
    axis_config_t axis;

    (void)memset(&axis, 0, sizeof axis);
    axis.limit_switch = (uint8_t)end;
    axis.home_ticks = HOME;
    axis.unit_per_tick_q16 = (int64_t)(SIM_SWITCH_HYSTERESIS_NM / HYSTERESIS) * 65536;
    sim_switch_init(&limit_switch, &axis, position, seed);
}

void setUp(void)
{
}

void tearDown(void)
{
}

static bool settled_at(double position)
{
    for (uint32_t us = 0U; us <= SIM_SWITCH_BOUNCE_MAXIMUM_US; us += SIM_STEP_US) {
        sim_switch_step(&limit_switch, position);
    }
    return limit_switch.is_active;
}

void test_SWR_BOX_004_an_upper_switch_operates_at_home_and_releases_below(void)
{
    start(LIMIT_SWITCH_UPPER, 0.0, 1U);
    TEST_ASSERT_FALSE(settled_at(HOME - 0.1));
    TEST_ASSERT_TRUE(settled_at(HOME));
    TEST_ASSERT_TRUE(settled_at(HOME - HYSTERESIS + 0.1));
    TEST_ASSERT_FALSE(settled_at(HOME - HYSTERESIS - 0.1));
    TEST_ASSERT_FALSE(settled_at(HOME - 0.1));
}

void test_SWR_BOX_004_a_lower_switch_operates_at_home_and_releases_above(void)
{
    start(LIMIT_SWITCH_LOWER, 1000.0, 1U);
    TEST_ASSERT_FALSE(settled_at(HOME + 0.1));
    TEST_ASSERT_TRUE(settled_at(HOME));
    TEST_ASSERT_TRUE(settled_at(HOME + HYSTERESIS - 0.1));
    TEST_ASSERT_FALSE(settled_at(HOME + HYSTERESIS + 0.1));
}

void test_SWR_BOX_004_an_axis_without_switch_never_shows_one(void)
{
    start(LIMIT_SWITCH_NONE, 0.0, 1U);
    TEST_ASSERT_FALSE(settled_at(100000.0));
    TEST_ASSERT_FALSE(settled_at(-100000.0));
}

void test_SWR_BOX_004_a_switch_may_be_active_from_the_start(void)
{
    start(LIMIT_SWITCH_UPPER, HOME, 1U);
    TEST_ASSERT_TRUE(limit_switch.is_active);
    TEST_ASSERT_EQUAL_UINT32(0U, limit_switch.bounce_us);
}

void test_SWR_BOX_004_a_turning_axis_has_its_hysteresis_as_an_angle(void)
{
    axis_config_t axis;

    (void)memset(&axis, 0, sizeof axis);
    axis.unit = AXIS_UNIT_RAD;
    axis.unit_per_tick_q16 = (int64_t)(SIM_SWITCH_HYSTERESIS_BAM / HYSTERESIS) * 65536;
    sim_switch_init(&limit_switch, &axis, 0.0, 1U);
    TEST_ASSERT_EQUAL_INT(HYSTERESIS, (int)(limit_switch.hysteresis_ticks + 0.5));
}

void test_SWR_BOX_004_contacts_bounce_for_1_to_5_ms_and_change_at_once(void)
{
    uint32_t changes_in_all = 0U;

    for (uint32_t seed = 0U; seed < 100U; seed++) {
        uint32_t last_change_us = 0U;
        bool before = true;
        start(LIMIT_SWITCH_UPPER, 0.0, seed);
        sim_switch_step(&limit_switch, HOME);
        TEST_ASSERT_TRUE(limit_switch.is_active);
        TEST_ASSERT_TRUE(limit_switch.bounce_us >= SIM_SWITCH_BOUNCE_MINIMUM_US);
        for (uint32_t us = SIM_STEP_US; us < 20000U; us += SIM_STEP_US) {
            sim_switch_step(&limit_switch, HOME);
            if (limit_switch.is_active != before) {
                last_change_us = us;
                changes_in_all++;
            }
            before = limit_switch.is_active;
        }
        TEST_ASSERT_TRUE(before);
        TEST_ASSERT_TRUE(last_change_us <= SIM_SWITCH_BOUNCE_MAXIMUM_US);
    }
    TEST_ASSERT_TRUE(changes_in_all > 200U);
}

void test_SWR_BOX_004_faults_of_a_switch_show_at_the_card(void)
{
    start(LIMIT_SWITCH_UPPER, 0.0, 1U);
    limit_switch.fault = SIM_SWITCH_STUCK;
    TEST_ASSERT_TRUE(settled_at(0.0));
    limit_switch.fault = SIM_SWITCH_REVERSED;
    TEST_ASSERT_TRUE(settled_at(0.0));
    TEST_ASSERT_FALSE(settled_at(HOME));
    limit_switch.fault = SIM_SWITCH_OPEN;
    TEST_ASSERT_FALSE(settled_at(HOME));
    limit_switch.fault = SIM_SWITCH_NORMAL;
    TEST_ASSERT_TRUE(settled_at(HOME));
}

void test_SWR_BOX_004_a_loose_wire_changes_more_slowly_than_the_card_debounces(void)
{
    uint32_t since_us = 0U;
    uint32_t changes = 0U;
    bool before = false;

    start(LIMIT_SWITCH_UPPER, 0.0, 1U);
    limit_switch.fault = SIM_SWITCH_CHATTER;
    for (uint32_t us = 0U; us < 1000000U; us += SIM_STEP_US) {
        sim_switch_step(&limit_switch, 0.0);
        since_us += SIM_STEP_US;
        if (limit_switch.is_active != before) {
            TEST_ASSERT_TRUE((changes == 0U) || (since_us >= SIM_SWITCH_CHATTER_MINIMUM_US));
            TEST_ASSERT_TRUE(since_us <= SIM_SWITCH_CHATTER_MAXIMUM_US + SIM_STEP_US);
            before = limit_switch.is_active;
            since_us = 0U;
            changes++;
        }
    }
    TEST_ASSERT_TRUE(changes > 30U);
}
