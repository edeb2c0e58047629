/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a value that a card measures or counts is reported when it leaves its range and
 * when it is back, once each, however it trembles at the border.
 */
#include "unity.h"

#include "card/card_health.h"
#include "limits/requirement_limits.h"

#include <string.h>

#define LOW card_health_bit(CARD_TROUBLE_SUPPLY_LOW)
#define HIGH card_health_bit(CARD_TROUBLE_SUPPLY_HIGH)
#define WARM card_health_bit(CARD_TROUBLE_DRIVER_WARM)
#define HOT card_health_bit(CARD_TROUBLE_DRIVER_HOT)
#define REFUSED card_health_bit(CARD_TROUBLE_COMMANDS_REFUSED)
#define TRIPPED card_health_bit(CARD_TROUBLE_WATCHDOG_TRIPPED)

static card_health_t health;
static card_report_t report;

static uint32_t look(void)
{
    return card_health_look(&health, &report, true);
}

void setUp(void)
{
    (void)memset(&health, 0, sizeof health);
    report = (card_report_t){.supply_mv = 24000U, .driver_temperature_dc = 330, .uptime_s = 9U};
    TEST_ASSERT_EQUAL_HEX32(0U, look());
}

void tearDown(void)
{
}

/* Looks at this supply so often that a lasting one must be reported. */
static uint32_t look_long(uint32_t supply_mv)
{
    uint32_t changed = 0U;

    report.supply_mv = supply_mv;
    for (uint32_t i = 0U; i < LIMIT_CARD_SUPPLY_LOOKS; i++) {
        changed |= look();
    }
    return changed;
}

void test_SWR_CARD_011_a_supply_at_its_border_is_well(void)
{
    TEST_ASSERT_EQUAL_HEX32(0U, look_long(LIMIT_CARD_SUPPLY_LEAST_MV));
    TEST_ASSERT_EQUAL_HEX32(0U, look_long(LIMIT_CARD_SUPPLY_MOST_MV));
}

void test_SWR_CARD_011_a_supply_below_or_above_is_reported_once(void)
{
    TEST_ASSERT_EQUAL_HEX32(LOW, look_long(LIMIT_CARD_SUPPLY_LEAST_MV - 1U));
    TEST_ASSERT_EQUAL_HEX32(LOW, health.troubles);
    TEST_ASSERT_EQUAL_HEX32(0U, look_long(0U));
    TEST_ASSERT_EQUAL_HEX32(LOW, look_long(24000U));
    TEST_ASSERT_EQUAL_HEX32(HIGH, look_long(LIMIT_CARD_SUPPLY_MOST_MV + 1U));
    TEST_ASSERT_EQUAL_HEX32(HIGH, health.troubles);
}

void test_SWR_CARD_011_a_dip_that_does_not_last_is_not_reported(void)
{
    report.supply_mv = 0U;
    for (uint32_t i = 0U; i < 3U * LIMIT_CARD_SUPPLY_LOOKS; i++) {
        report.supply_mv = ((i % LIMIT_CARD_SUPPLY_LOOKS) == 0U) ? 24000U : 0U;
        TEST_ASSERT_EQUAL_HEX32(0U, look());
    }
}

void test_SWR_CARD_011_it_is_over_a_little_inside_of_the_range(void)
{
    (void)look_long(0U);
    TEST_ASSERT_EQUAL_HEX32(0U,
                            look_long(LIMIT_CARD_SUPPLY_LEAST_MV + LIMIT_CARD_SUPPLY_BACK_MV - 1U));
    TEST_ASSERT_EQUAL_HEX32(LOW, look_long(LIMIT_CARD_SUPPLY_LEAST_MV + LIMIT_CARD_SUPPLY_BACK_MV));
    (void)look_long(UINT16_MAX);
    TEST_ASSERT_EQUAL_HEX32(0U,
                            look_long(LIMIT_CARD_SUPPLY_MOST_MV - LIMIT_CARD_SUPPLY_BACK_MV + 1U));
    TEST_ASSERT_EQUAL_HEX32(HIGH, look_long(LIMIT_CARD_SUPPLY_MOST_MV - LIMIT_CARD_SUPPLY_BACK_MV));
}

void test_SWR_CARD_011_a_supply_that_is_taken_away_is_not_judged(void)
{
    report.supply_mv = 0U;
    for (uint32_t i = 0U; i < 3U * LIMIT_CARD_SUPPLY_LOOKS; i++) {
        TEST_ASSERT_EQUAL_HEX32(0U, card_health_look(&health, &report, false));
    }
    for (uint32_t i = 1U; i < LIMIT_CARD_SUPPLY_LOOKS; i++) {
        TEST_ASSERT_EQUAL_HEX32(0U, look());
    }
    TEST_ASSERT_EQUAL_HEX32(LOW, look());
}

static uint32_t heat(int32_t driver_dc)
{
    report.driver_temperature_dc = driver_dc;
    return look();
}

void test_SWR_CARD_012_a_driver_is_warm_and_then_too_hot(void)
{
    TEST_ASSERT_EQUAL_HEX32(0U, heat((int32_t)LIMIT_CARD_DRIVER_WARM_DC));
    TEST_ASSERT_EQUAL_HEX32(WARM, heat((int32_t)LIMIT_CARD_DRIVER_WARM_DC + 1));
    TEST_ASSERT_EQUAL_HEX32(0U, heat((int32_t)LIMIT_CARD_DRIVER_HOT_DC));
    TEST_ASSERT_EQUAL_HEX32(HOT, heat((int32_t)LIMIT_CARD_DRIVER_HOT_DC + 1));
    TEST_ASSERT_EQUAL_HEX32(WARM | HOT, health.troubles);
}

void test_SWR_CARD_012_it_is_over_when_the_driver_has_cooled_down(void)
{
    (void)heat(INT16_MAX);
    TEST_ASSERT_EQUAL_HEX32(
        0U, heat((int32_t)LIMIT_CARD_DRIVER_HOT_DC - (int32_t)LIMIT_CARD_DRIVER_BACK_DC + 1));
    TEST_ASSERT_EQUAL_HEX32(
        HOT, heat((int32_t)LIMIT_CARD_DRIVER_HOT_DC - (int32_t)LIMIT_CARD_DRIVER_BACK_DC));
    TEST_ASSERT_EQUAL_HEX32(
        0U, heat((int32_t)LIMIT_CARD_DRIVER_WARM_DC - (int32_t)LIMIT_CARD_DRIVER_BACK_DC + 1));
    TEST_ASSERT_EQUAL_HEX32(
        WARM, heat((int32_t)LIMIT_CARD_DRIVER_WARM_DC - (int32_t)LIMIT_CARD_DRIVER_BACK_DC));
    TEST_ASSERT_EQUAL_HEX32(0U, heat(INT16_MIN));
}

void test_SWR_CARD_013_damaged_commands_and_gaps_are_reported_while_they_come(void)
{
    report.rx_crc_errors++;
    TEST_ASSERT_EQUAL_HEX32(REFUSED, look());
    for (uint32_t i = 1U; i < LIMIT_CARD_CALM_LOOKS; i++) {
        TEST_ASSERT_EQUAL_HEX32(0U, look());
    }
    report.sequence_gaps++;
    TEST_ASSERT_EQUAL_HEX32(0U, look());
    for (uint32_t i = 1U; i < LIMIT_CARD_CALM_LOOKS; i++) {
        TEST_ASSERT_EQUAL_HEX32(0U, look());
    }
    TEST_ASSERT_EQUAL_HEX32(REFUSED, look());
    TEST_ASSERT_EQUAL_HEX32(0U, health.troubles);
}

void test_SWR_CARD_013_a_trip_is_reported_and_is_over_after_a_while(void)
{
    report.watchdog_trips++;
    TEST_ASSERT_EQUAL_HEX32(TRIPPED, look());
    for (uint32_t i = 1U; i < LIMIT_CARD_CALM_LOOKS; i++) {
        TEST_ASSERT_EQUAL_HEX32(0U, look());
    }
    TEST_ASSERT_EQUAL_HEX32(TRIPPED, look());
}

void test_SWR_CARD_013_what_was_counted_before_the_first_look_is_not_reported(void)
{
    (void)memset(&health, 0, sizeof health);
    report.rx_crc_errors = 7U;
    report.watchdog_trips = 2U;
    TEST_ASSERT_EQUAL_HEX32(0U, look());
    TEST_ASSERT_EQUAL_HEX32(0U, look());
}

void test_SWR_CARD_013_a_card_that_was_started_anew_counts_from_zero(void)
{
    report.rx_crc_errors = 7U;
    report.watchdog_trips = 2U;
    (void)look();
    health.troubles = 0U;
    report.rx_crc_errors = 0U;
    report.watchdog_trips = 0U;
    TEST_ASSERT_EQUAL_HEX32(0U, look());
    report.watchdog_trips = 1U;
    TEST_ASSERT_EQUAL_HEX32(TRIPPED, look());
}

void test_SWR_CARD_013_a_counter_that_wraps_has_grown(void)
{
    report.rx_crc_errors = UINT32_MAX;
    (void)look();
    health.troubles = 0U;
    report.rx_crc_errors = 0U;
    TEST_ASSERT_EQUAL_HEX32(REFUSED, look());
}
