/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: what counts are missing of the way of a motor, or too much, is added up, whether
 * it comes steadily, in short motions or in bursts; only a little of it is given back; and a motor
 * stays as fast as it has shown.
 *
 * The needle at full speed makes 25 ticks in a cycle: so much of it counts that a share is a whole
 * number of ticks. Its sums may reach 333 ticks.
 */
#include "unity.h"

#include "axis/count_balance.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"

#define CYCLE_US 1000U
#define FULL 25
#define REST_CYCLES 10U
/* A run so short is one of gaining speed to its end, and so are all after a pause. */
#define TAP_CYCLES 20U
#define RISING_CYCLES (LIMIT_RISING_TIME_US / CYCLE_US)
#define CALIBRATION_CYCLES (LIMIT_CALIBRATION_TIME_US / CYCLE_US)
#define LONG_CYCLES 20000U
#define MOST_SHORT_TICKS 333

static const axis_config_t *const needle = &robot_neuro.axes[NEURO_AXIS_INSERTION];
static const axis_config_t *const head = &robot_neuro.axes[NEURO_AXIS_HEAD];

static count_balance_t account;
static const axis_config_t *config;
static uint32_t since_q16;
static uint32_t cycles_run;

void setUp(void)
{
    count_balance_init(&account);
    config = needle;
    since_q16 = 0U;
    cycles_run = 0U;
}

void tearDown(void)
{
}

/* The counts at its end. */
static bool step(int64_t model_q16, int32_t counted_ticks, uint32_t elapsed_us)
{
    const bool is_counted = (model_q16 != 0) && (counted_ticks != 0);
    since_q16 += (uint32_t)((model_q16 < 0) ? -model_q16 : model_q16);
    const count_cycle_t cycle = {.model_q16 = model_q16,
                                 .counted_ticks = counted_ticks,
                                 .due_q16 = is_counted ? since_q16 : 0U,
                                 .elapsed_us = elapsed_us};
    since_q16 = is_counted ? 0U : since_q16;
    return count_balance_step(&account, config, &cycle);
}

static bool cycle(int32_t model_ticks, int32_t counted_ticks)
{
    cycles_run++;
    return step((int64_t)model_ticks * 65536, counted_ticks, CYCLE_US);
}

/* True when one of these cycles is reported, the last one then. */
static bool run(uint32_t cycles, int32_t model_ticks, int32_t counted_ticks)
{
    bool is_reported = false;
    for (uint32_t i = 0U; (i < cycles) && !is_reported; i++) {
        is_reported = cycle(model_ticks, counted_ticks);
    }
    return is_reported;
}

/* Driven so often for a short while, with pauses. */
static bool tap(uint32_t taps, int32_t counted_ticks)
{
    bool is_reported = false;
    for (uint32_t i = 0U; (i < taps) && !is_reported; i++) {
        is_reported = run(TAP_CYCLES, FULL, counted_ticks) || run(2U * REST_CYCLES, 0, 0);
    }
    return is_reported;
}

/* From the next cycle on the motor runs steadily; its sums are empty. */
static void run_up(void)
{
    TEST_ASSERT_FALSE(run(RISING_CYCLES, FULL, FULL));
    count_balance_settle(&account);
}

/* It has shown in both regimes that it counts so much in a cycle. */
static void calibrate(int32_t counted_ticks)
{
    TEST_ASSERT_FALSE(tap((2U * CALIBRATION_CYCLES) / TAP_CYCLES, counted_ticks));
    TEST_ASSERT_FALSE(run(RISING_CYCLES + CALIBRATION_CYCLES + TAP_CYCLES, FULL, counted_ticks));
    count_balance_settle(&account);
}

static int32_t short_ticks(void)
{
    return (int32_t)(account.short_e2_q16 / 6553600);
}

static int32_t over_ticks(void)
{
    return (int32_t)(account.over_e2_q16 / 6553600);
}

static void expect_shares(count_regime_t regime, uint32_t least, uint32_t most)
{
    TEST_ASSERT_EQUAL_UINT32(least, account.calibrations[regime].least_percent);
    TEST_ASSERT_EQUAL_UINT32(most, account.calibrations[regime].most_percent);
}

void test_SWR_AXIS_019_a_motor_that_counts_its_way_is_never_reported(void)
{
    TEST_ASSERT_FALSE(run(LONG_CYCLES, FULL, FULL));
    TEST_ASSERT_FALSE(run(LONG_CYCLES, -FULL, -FULL));
    TEST_ASSERT_FALSE(tap(1000U, FULL));
    TEST_ASSERT_EQUAL_INT32(0, short_ticks());
    TEST_ASSERT_EQUAL_INT32(0, over_ticks());
    TEST_ASSERT_EQUAL_INT32(100, account.percent);
}

/* 17 of 25 are 68 percent. This motor is so slow that its own share does not narrow that. */
void test_SWR_AXIS_019_steadily_the_least_share_is_enough_for_ever_and_less_adds_up(void)
{
    calibrate(19);
    TEST_ASSERT_FALSE(run(RISING_CYCLES + 1U, FULL, 19));
    TEST_ASSERT_FALSE(run(LONG_CYCLES, FULL, 17));
    TEST_ASSERT_EQUAL_INT32(0, short_ticks());
    cycles_run = 0U;
    TEST_ASSERT_TRUE(run(LONG_CYCLES, FULL, 16));
    TEST_ASSERT_UINT32_WITHIN(4U, MOST_SHORT_TICKS + 1, cycles_run);
    TEST_ASSERT_EQUAL_INT32(64, account.percent);
}

/* 35 of 25 are 140 percent. */
void test_SWR_AXIS_019_steadily_the_most_share_is_borne_for_ever_and_more_adds_up(void)
{
    calibrate(27);
    TEST_ASSERT_FALSE(run(RISING_CYCLES + 1U, FULL, 27));
    TEST_ASSERT_FALSE(run(LONG_CYCLES, FULL, 35));
    TEST_ASSERT_EQUAL_INT32(0, over_ticks());
    cycles_run = 0U;
    TEST_ASSERT_TRUE(run(LONG_CYCLES, FULL, 36));
    TEST_ASSERT_UINT32_WITHIN(4U, MOST_SHORT_TICKS + 1, cycles_run);
}

/* 15 of 25 are 60 percent. */
void test_SWR_AXIS_019_gaining_speed_the_least_share_is_less(void)
{
    TEST_ASSERT_FALSE(tap(CALIBRATION_CYCLES / TAP_CYCLES - 1U, 15));
    TEST_ASSERT_EQUAL_INT32(0, short_ticks());
    count_balance_init(&account);
    TEST_ASSERT_FALSE(tap(CALIBRATION_CYCLES / TAP_CYCLES - 1U, 14));
    TEST_ASSERT_INT32_WITHIN(4, 9 * (int32_t)TAP_CYCLES, short_ticks());
}

/* 42 of 25 are 168 percent. */
void test_SWR_AXIS_019_gaining_speed_the_most_share_is_more(void)
{
    TEST_ASSERT_FALSE(tap(CALIBRATION_CYCLES / TAP_CYCLES - 1U, 42));
    TEST_ASSERT_EQUAL_INT32(0, over_ticks());
    count_balance_init(&account);
    TEST_ASSERT_FALSE(tap(CALIBRATION_CYCLES / TAP_CYCLES - 1U, 43));
    TEST_ASSERT_INT32_WITHIN(4, 9 * (int32_t)TAP_CYCLES, over_ticks());
}

/* From the first cycle on: true and believed needle are 0.4 mm apart then, of 0.8 mm. */
void test_SWR_AXIS_019_half_the_counts_are_reported_soon(void)
{
    config = head;
    TEST_ASSERT_TRUE(run(LONG_CYCLES, 2, 1));
    TEST_ASSERT_LESS_THAN_UINT32(60U, cycles_run);
    setUp();
    TEST_ASSERT_TRUE(run(LONG_CYCLES, 2 * 12, 12));
    TEST_ASSERT_LESS_THAN_UINT32(120U, cycles_run);
    TEST_ASSERT_LESS_THAN_UINT32(0.4 / 0.0003, cycles_run * 12U);
}

void test_SWR_AXIS_019_twice_the_counts_are_reported_soon(void)
{
    TEST_ASSERT_TRUE(run(LONG_CYCLES, FULL, 2 * FULL));
    TEST_ASSERT_LESS_THAN_UINT32(60U, cycles_run);
    setUp();
    TEST_ASSERT_TRUE(run(LONG_CYCLES, -FULL, -2 * FULL));
    TEST_ASSERT_LESS_THAN_UINT32(60U, cycles_run);
}

void test_SWR_AXIS_019_counts_against_the_drive_are_missing_ones(void)
{
    TEST_ASSERT_TRUE(run(LONG_CYCLES, FULL, -FULL));
    TEST_ASSERT_LESS_THAN_UINT32(14U, cycles_run);
    TEST_ASSERT_EQUAL_INT32(-100, account.percent);
    setUp();
    TEST_ASSERT_TRUE(run(LONG_CYCLES, -FULL, FULL));
    TEST_ASSERT_LESS_THAN_UINT32(14U, cycles_run);
}

void test_SWR_AXIS_019_no_pause_hides_what_is_missing(void)
{
    TEST_ASSERT_TRUE(run(LONG_CYCLES, FULL, 12));
    const uint32_t in_one = cycles_run;
    setUp();
    TEST_ASSERT_TRUE(tap(LONG_CYCLES, 12));
    const uint32_t taps = (cycles_run / (TAP_CYCLES + (2U * REST_CYCLES))) + 1U;
    TEST_ASSERT_LESS_OR_EQUAL_UINT32(in_one + (3U * TAP_CYCLES), taps * TAP_CYCLES);
}

/* Blind for 8 ms of 48: in sum it counts five sixths of its way. */
void test_SWR_AXIS_019_an_encoder_that_comes_and_goes_is_reported(void)
{
    bool is_reported = false;
    calibrate(FULL);
    TEST_ASSERT_FALSE(run(RISING_CYCLES + 1U, FULL, FULL));
    uint32_t bursts = 0U;
    while (!is_reported && (bursts < 100U)) {
        is_reported = run(8U, FULL, 0) || run(40U, FULL, FULL);
        bursts++;
    }
    TEST_ASSERT_TRUE(is_reported);
    TEST_ASSERT_LESS_OR_EQUAL_UINT32(4U, bursts);
}

void test_SWR_AXIS_019_of_what_is_more_than_enough_one_twelfth_is_given_back(void)
{
    run_up();
    TEST_ASSERT_FALSE(run(12U, FULL, 0));
    const int64_t before_e2_q16 = account.short_e2_q16;
    TEST_ASSERT_EQUAL_INT32(12 * 17, short_ticks());
    TEST_ASSERT_FALSE(run(4U, FULL, FULL));
    TEST_ASSERT_EQUAL_INT64(INT64_C(4) * (FULL - 17) * 6553600 / 12,
                            before_e2_q16 - account.short_e2_q16);
    TEST_ASSERT_FALSE(run(LONG_CYCLES, FULL, FULL));
    TEST_ASSERT_EQUAL_INT64(0, account.short_e2_q16);
}

/* As many ticks as 0.1 mm are; where these are fewer, eight. */
void test_SWR_AXIS_019_a_sum_is_a_fault_beyond_the_way_and_from_eight_ticks_on(void)
{
    const int32_t most[ROBOT_AXIS_MAX] = {8, 8, 8, 334, 12, 8, 8};
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        for (int32_t missing = most[i] - 1; missing <= most[i]; missing++) {
            setUp();
            config = &robot_neuro.axes[i];
            run_up();
            TEST_ASSERT_FALSE(run(3U, FULL, 17));
            TEST_ASSERT_EQUAL(missing == most[i], cycle(FULL, 17 - missing));
            TEST_ASSERT_EQUAL_INT32(missing, short_ticks());
        }
    }
}

void test_SWR_AXIS_019_both_sums_are_empty_once_the_position_is_sure(void)
{
    calibrate(FULL);
    TEST_ASSERT_FALSE(run(RISING_CYCLES + 1U, FULL, FULL));
    (void)run(12U, FULL, 0);
    (void)run(9U, FULL, 2 * FULL);
    TEST_ASSERT_GREATER_THAN_INT32(0, short_ticks());
    TEST_ASSERT_GREATER_THAN_INT32(0, over_ticks());
    count_balance_settle(&account);
    TEST_ASSERT_EQUAL_INT32(0, short_ticks());
    TEST_ASSERT_EQUAL_INT32(0, over_ticks());
    TEST_ASSERT_EQUAL_UINT32(0U, account.window_us);
    TEST_ASSERT_EQUAL_INT64(0, account.model_q16);
    expect_shares(COUNT_REGIME_STEADY, 90U, 140U);
}

/* The head makes a tick in a cycle; here they come eight at a time, in the middle of a window. */
void test_SWR_AXIS_019_a_window_ends_with_a_count(void)
{
    config = head;
    for (uint32_t i = 1U; i <= LONG_CYCLES; i++) {
        const bool is_due = (i >= 12U) && (((i - 12U) % 8U) == 0U);
        TEST_ASSERT_FALSE(cycle(1, is_due ? ((i == 12U) ? 12 : 8) : 0));
        TEST_ASSERT_EQUAL_INT32(0, short_ticks());
        TEST_ASSERT_EQUAL_INT32(0, over_ticks());
    }
}

void test_SWR_AXIS_019_without_any_count_a_window_ends_at_twice_its_way(void)
{
    config = head;
    TEST_ASSERT_TRUE(run(LONG_CYCLES, 1, 0));
    TEST_ASSERT_EQUAL_UINT32(2U * LIMIT_ACCOUNT_WINDOW_TICKS, cycles_run);
}

void test_SWR_AXIS_019_a_window_has_its_time_too(void)
{
    TEST_ASSERT_FALSE(run(3U, FULL, FULL));
    TEST_ASSERT_EQUAL_INT64(3 * FULL * 65536, account.model_q16);
    TEST_ASSERT_FALSE(run(REST_CYCLES, 0, 0));
    TEST_ASSERT_EQUAL_INT64(3 * FULL * 65536, account.model_q16);
    TEST_ASSERT_FALSE(run(1U, FULL, FULL));
    TEST_ASSERT_EQUAL_INT64(0, account.model_q16);
}

void test_SWR_AXIS_019_noise_at_rest_is_nothing(void)
{
    TEST_ASSERT_FALSE(run(LONG_CYCLES, 0, 1));
    TEST_ASSERT_EQUAL_INT64(0, account.counted_ticks);
    TEST_ASSERT_FALSE(run(1U, FULL, FULL));
    TEST_ASSERT_FALSE(run(REST_CYCLES, 0, 0));
    TEST_ASSERT_FALSE(run(LONG_CYCLES, 0, -1));
    TEST_ASSERT_EQUAL_INT64(FULL, account.counted_ticks);
    TEST_ASSERT_EQUAL_INT32(0, short_ticks());
    TEST_ASSERT_EQUAL_INT32(0, over_ticks());
}

void test_SWR_AXIS_019_a_rest_of_any_length_is_one(void)
{
    TEST_ASSERT_FALSE(run(1U, FULL, FULL));
    for (uint32_t i = 0U; i < (1U << 12U); i++) {
        TEST_ASSERT_FALSE(step(0, 1, 1U << 20U));
    }
    TEST_ASSERT_EQUAL_INT64(FULL, account.counted_ticks);
}

void test_SWR_AXIS_019_what_is_counted_while_the_motor_comes_to_rest_is_of_its_drive(void)
{
    TEST_ASSERT_FALSE(run(1U, -FULL, 0));
    TEST_ASSERT_FALSE(run(REST_CYCLES - 1U, 0, 0));
    TEST_ASSERT_FALSE(cycle(0, -FULL));
    TEST_ASSERT_EQUAL_INT64(FULL, account.counted_ticks);
    TEST_ASSERT_FALSE(cycle(0, -FULL));
    TEST_ASSERT_EQUAL_INT64(FULL, account.counted_ticks);
}

/* A late cycle has its counts, and a report that is missed leaves them to the next. */
void test_SWR_AXIS_019_late_cycles_are_no_missing_counts(void)
{
    for (uint32_t i = 0U; i < LONG_CYCLES; i++) {
        TEST_ASSERT_FALSE(step(INT64_C(3) * FULL * 65536, 3 * FULL, 3000U));
        TEST_ASSERT_FALSE(cycle(FULL, 0));
        TEST_ASSERT_FALSE(cycle(FULL, 2 * FULL));
    }
    TEST_ASSERT_EQUAL_INT32(0, short_ticks());
    TEST_ASSERT_EQUAL_INT32(0, over_ticks());
}

void test_SWR_AXIS_019_a_pause_or_a_reversal_begins_the_gaining_of_speed_anew(void)
{
    TEST_ASSERT_FALSE(run(RISING_CYCLES, FULL, FULL));
    TEST_ASSERT_EQUAL_UINT32(COUNT_REGIME_RISING, account.regime);
    TEST_ASSERT_FALSE(run(1U, FULL, FULL));
    TEST_ASSERT_EQUAL_UINT32(COUNT_REGIME_STEADY, account.regime);
    TEST_ASSERT_FALSE(run(1U, -FULL, -FULL));
    TEST_ASSERT_EQUAL_UINT32(COUNT_REGIME_RISING, account.regime);
    TEST_ASSERT_FALSE(run(RISING_CYCLES, -FULL, -FULL));
    TEST_ASSERT_EQUAL_UINT32(COUNT_REGIME_STEADY, account.regime);
    TEST_ASSERT_FALSE(run(1U, 0, 0));
    TEST_ASSERT_FALSE(run(1U, -FULL, -FULL));
    TEST_ASSERT_EQUAL_UINT32(COUNT_REGIME_RISING, account.regime);
}

/* 0.9 of 100 percent: 22 of 25 are too few from then on, and were enough before. */
void test_SWR_AXIS_024_a_motor_stays_as_fast_as_it_has_shown(void)
{
    calibrate(FULL);
    expect_shares(COUNT_REGIME_STEADY, 90U, 140U);
    expect_shares(COUNT_REGIME_RISING, 86U, 140U);
    TEST_ASSERT_FALSE(run(RISING_CYCLES + 1U, FULL, FULL));
    TEST_ASSERT_FALSE(run(LONG_CYCLES, FULL, 23));
    TEST_ASSERT_TRUE(run(LONG_CYCLES, FULL, 22));
    setUp();
    calibrate(FULL);
    TEST_ASSERT_FALSE(tap(100U, 22));
    TEST_ASSERT_TRUE(tap(100U, 21));
}

void test_SWR_AXIS_024_a_slow_motor_may_not_become_a_fast_one(void)
{
    calibrate(19);
    expect_shares(COUNT_REGIME_STEADY, 68U, 106U);
    expect_shares(COUNT_REGIME_RISING, 65U, 106U);
    TEST_ASSERT_FALSE(run(RISING_CYCLES + 1U, FULL, 19));
    TEST_ASSERT_FALSE(run(LONG_CYCLES, FULL, 26));
    TEST_ASSERT_TRUE(run(LONG_CYCLES, FULL, 27));
}

void test_SWR_AXIS_024_what_a_motor_shows_never_widens_its_shares(void)
{
    calibrate(18);
    expect_shares(COUNT_REGIME_STEADY, 68U, 100U);
    setUp();
    calibrate(32);
    expect_shares(COUNT_REGIME_STEADY, 115U, 140U);
    expect_shares(COUNT_REGIME_RISING, 110U, 168U);
}

void test_SWR_AXIS_024_nothing_is_narrowed_before_the_time(void)
{
    run_up();
    TEST_ASSERT_FALSE(run(CALIBRATION_CYCLES - 1U, FULL, FULL));
    expect_shares(COUNT_REGIME_STEADY, 68U, 140U);
    TEST_ASSERT_FALSE(run(1U, FULL, FULL));
    expect_shares(COUNT_REGIME_STEADY, 90U, 140U);
    expect_shares(COUNT_REGIME_RISING, 60U, 168U);
}

/* Each cycle of these is enough for SWR-AXIS-019, but no motor of that table is like that. */
static void expect_steady_spread(int32_t counted_ticks, bool is_reported)
{
    setUp();
    run_up();
    TEST_ASSERT_FALSE(run(CALIBRATION_CYCLES - 1U, FULL, counted_ticks));
    TEST_ASSERT_EQUAL(is_reported, cycle(FULL, counted_ticks));
    TEST_ASSERT_EQUAL_INT32(0, short_ticks());
    TEST_ASSERT_EQUAL_INT32(0, over_ticks());
}

static void expect_rising_spread(int32_t counted_ticks, bool is_reported)
{
    setUp();
    TEST_ASSERT_EQUAL(is_reported, tap(CALIBRATION_CYCLES / TAP_CYCLES, counted_ticks));
    TEST_ASSERT_EQUAL_INT32(0, short_ticks());
    TEST_ASSERT_EQUAL_INT32(0, over_ticks());
}

void test_SWR_AXIS_024_a_motor_outside_of_the_spread_of_its_kind_is_a_fault(void)
{
    expect_steady_spread(17, true);
    expect_steady_spread(18, false);
    expect_steady_spread(32, false);
    expect_steady_spread(33, true);
    expect_rising_spread(15, true);
    expect_rising_spread(16, false);
    expect_rising_spread(37, false);
    expect_rising_spread(38, true);
}

void test_SWR_AXIS_024_a_motor_that_counts_backwards_has_shown_nothing(void)
{
    run_up();
    for (uint32_t i = 0U; i < CALIBRATION_CYCLES; i++) {
        (void)cycle(FULL, -1);
    }
    expect_shares(COUNT_REGIME_STEADY, 68U, 140U);
}

/* The slowest motion is a tick in some cycles: what it shows of a motor is not enough. */
void test_SWR_AXIS_024_a_motor_has_shown_itself_over_a_way_too(void)
{
    run_up();
    for (uint32_t i = 1U; i < 490U; i++) {
        TEST_ASSERT_FALSE(step(6554, ((i % 10U) == 0U) ? 1 : 0, CYCLE_US));
    }
    expect_shares(COUNT_REGIME_STEADY, 68U, 140U);
    TEST_ASSERT_FALSE(step(6554, 1, CYCLE_US));
    expect_shares(COUNT_REGIME_STEADY, 89U, 138U);
}

/* The way to the first count of a steady run began before it. */
void test_SWR_AXIS_024_a_steady_motor_shows_itself_from_count_to_count(void)
{
    const count_calibration_t *const shown = &account.calibrations[COUNT_REGIME_STEADY];
    for (int32_t i = 1; i <= 3; i++) {
        const int32_t way = ((i % 2) == 0) ? FULL : -FULL;
        TEST_ASSERT_FALSE(run(RISING_CYCLES + 1U, way, way));
        TEST_ASSERT_EQUAL_INT32((i - 1) * 2 * FULL, shown->counted_ticks);
        TEST_ASSERT_FALSE(cycle(way, 0) || cycle(way, 2 * way) || cycle(way, 0));
        TEST_ASSERT_EQUAL_INT64((int64_t)i * 2 * FULL * 65536, shown->model_q16);
        TEST_ASSERT_EQUAL_INT32(i * 2 * FULL, shown->counted_ticks);
    }
}

/* Times of cycles that do not add up to the whole are no more than it. */
void test_SWR_AXIS_047_a_doubt_ends_after_its_time_of_drive_in_cycles_of_any_length(void)
{
    count_balance_doubt(&account);
    (void)step(65536, 1, LIMIT_RISING_TIME_US - 1U);
    TEST_ASSERT_EQUAL_UINT32(1U, account.unsure_us);
    (void)step(65536, 1, CYCLE_US);
    TEST_ASSERT_EQUAL_UINT32(0U, account.unsure_us);
}
