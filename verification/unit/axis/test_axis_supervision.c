/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: an axis that stands still, goes the wrong way or moves while it is off is found
 * out in time, and that is said once.
 */
#include "unity.h"

#include "axis/axis.h"
#include "axis/supervision.h"
#include "card/card_frame.h"
#include "charts/stall_watchdog_chart.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"

#include "unit/support/axis_world.h"

void setUp(void)
{
    use(with_upper_switch);
}

void tearDown(void)
{
}

/* The first of these cycles begins the watch. */
static void expect_stall_after(uint32_t cycles)
{
    TEST_ASSERT_EQUAL_HEX32(0U, push(cycles));
    TEST_ASSERT_TRUE(axis_is_enabled(&axis));
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_STALLED, push(1U));
    TEST_ASSERT_TRUE(axis_is_faulty(&axis));
    TEST_ASSERT_FALSE(axis_is_enabled(&axis));
}

void test_SWR_STALL_001_a_driven_axis_that_does_not_move_up_stalls_at_the_limit(void)
{
    setpoint_ticks = ABOVE;
    expect_stall_after(STALL_CYCLES);
}

void test_SWR_STALL_001_a_driven_axis_that_does_not_move_down_stalls_at_the_limit(void)
{
    setpoint_ticks = BELOW;
    expect_stall_after(STALL_CYCLES);
}

void test_SWR_STALL_001_an_inverted_axis_stalls_in_both_directions(void)
{
    use(inverted);
    setpoint_ticks = ABOVE;
    expect_stall_after(STALL_CYCLES);
    use(inverted);
    setpoint_ticks = BELOW;
    expect_stall_after(STALL_CYCLES);
}

void test_SWR_STALL_001_too_little_progress_does_not_count(void)
{
    setpoint_ticks = ABOVE;
    (void)push(STALL_CYCLES - 9U);
    TEST_ASSERT_EQUAL_HEX32(0U, driven_cycle(PROGRESS - 1));
    expect_stall_after(8U);
}

void test_SWR_STALL_001_enough_progress_begins_the_time_anew(void)
{
    setpoint_ticks = ABOVE;
    (void)push(STALL_CYCLES - 9U);
    (void)driven_cycle(PROGRESS - 1);
    TEST_ASSERT_EQUAL_HEX32(0U, driven_cycle(1));
    expect_stall_after(STALL_CYCLES - 1U);
}

void test_SWR_STALL_001_progress_downwards_begins_the_time_anew(void)
{
    setpoint_ticks = BELOW;
    (void)push(STALL_CYCLES - 1U);
    TEST_ASSERT_EQUAL_HEX32(0U, driven_cycle(-PROGRESS));
    expect_stall_after(STALL_CYCLES - 1U);
}

void test_SWR_STALL_001_moving_the_wrong_way_is_no_progress(void)
{
    setpoint_ticks = ABOVE;
    (void)push(1U);
    TEST_ASSERT_EQUAL_HEX32(0U, driven_cycle(1 - WRONG_WAY));
    expect_stall_after(STALL_CYCLES - 2U);
}

void test_SWR_STALL_001_trembling_is_no_net_progress(void)
{
    setpoint_ticks = ABOVE;
    (void)push(1U);
    for (uint32_t i = 1U; i < STALL_CYCLES; i++) {
        TEST_ASSERT_EQUAL_HEX32(0U, driven_cycle((i % 2U == 0U) ? WRONG_WAY - 1 : 1 - WRONG_WAY));
    }
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_STALLED, driven_cycle(0));
}

/* A cycle in which the motor got a pulse upwards or none, and the axis moved by `ticks`. */
static uint32_t creeping_cycle(bool is_pulse, int32_t ticks)
{
    const card_drive_t sent = {.mode = is_pulse ? CARD_DRIVE_NON_PWM : CARD_DRIVE_OFF,
                               .direction = (config->is_motor_inverted != 0U) ? 0U : 1U};
    const axis_sample_t sample = {.applied = &sent, .elapsed_us = CYCLE_US, .is_timed = true};
    (void)axis_follow(&axis, config, setpoint_ticks, 0, CYCLE_US);
    return observe_way(ticks) | axis_supervise(&axis, config, true, &sample);
}

/* A pulse of a cycle makes the motor go 0.035 ticks: two in the time of a stall. */
void test_SWR_STALL_001_slow_but_steady_progress_never_stalls(void)
{
    setpoint_ticks = ABOVE;
    for (uint32_t i = 0U; i < 20U; i++) {
        for (uint32_t cycle = 1U; cycle < STALL_CYCLES; cycle++) {
            const bool is_last = (cycle + 1U) == STALL_CYCLES;
            TEST_ASSERT_EQUAL_HEX32(0U, creeping_cycle((cycle % 9U) == 0U, is_last ? PROGRESS : 0));
        }
    }
}

void test_SWR_STALL_001_a_reversal_begins_the_time_anew(void)
{
    setpoint_ticks = ABOVE;
    (void)push(STALL_CYCLES - 1U);
    setpoint_ticks = BELOW;
    /* The dwell before the new direction still counts for the old one. */
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_STALLED, push(2U));
    use(with_upper_switch);
    setpoint_ticks = ABOVE;
    (void)push(STALL_CYCLES - 100U);
    setpoint_ticks = BELOW;
    TEST_ASSERT_EQUAL_HEX32(0U, push(200U));
}

void test_SWR_STALL_001_one_tick_beside_the_set_point_cannot_stall(void)
{
    setpoint_ticks = PROGRESS - 1;
    TEST_ASSERT_EQUAL_HEX32(0U, push(2U * STALL_CYCLES));
    setpoint_ticks = PROGRESS;
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_STALLED, push(STALL_CYCLES + 1U));
}

void test_SWR_STALL_001_an_axis_within_its_deadband_cannot_stall(void)
{
    use(with_lower_switch);
    setpoint_ticks = config->deadband_ticks;
    TEST_ASSERT_EQUAL_HEX32(0U, push(2U * STALL_CYCLES));
    setpoint_ticks = -config->deadband_ticks - 1;
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_STALLED, push(STALL_CYCLES + 1U));
}

void test_SWR_STALL_001_a_stalled_axis_stays_disabled_until_it_is_enabled_anew(void)
{
    setpoint_ticks = ABOVE;
    expect_stall_after(STALL_CYCLES);
    for (uint32_t i = 0U; i < 100U; i++) {
        (void)axis_rest(&axis, CYCLE_US);
        TEST_ASSERT_EQUAL_HEX32(0U, supervise(false, CYCLE_US));
        TEST_ASSERT_FALSE(axis_is_enabled(&axis));
    }
    axis_enable(&axis, true);
    TEST_ASSERT_EQUAL(STALL_WATCHDOG_STATE_STALLED, axis.supervision.stall.state);
    axis_enable(&axis, false);
    TEST_ASSERT_EQUAL(STALL_WATCHDOG_STATE_IDLE, axis.supervision.stall.state);
    expect_stall_after(STALL_CYCLES);
}

void test_SWR_AXIS_015_an_axis_that_goes_against_its_drive_is_a_fault_at_the_limit(void)
{
    setpoint_ticks = ABOVE;
    (void)push(1U);
    TEST_ASSERT_EQUAL_HEX32(0U, driven_cycle(1 - WRONG_WAY));
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_WRONG_WAY, driven_cycle(-1));
    TEST_ASSERT_EQUAL_INT32(WRONG_WAY, axis.supervision.sealed.backwards_ticks);
    TEST_ASSERT_TRUE(axis_is_faulty(&axis));
    use(inverted);
    setpoint_ticks = BELOW;
    (void)push(1U);
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_WRONG_WAY, driven_cycle(WRONG_WAY));
}

void test_SWR_AXIS_015_an_axis_that_is_not_driven_goes_no_wrong_way(void)
{
    setpoint_ticks = ABOVE;
    (void)push(1U);
    (void)observe_way(-WRONG_WAY);
    TEST_ASSERT_EQUAL_HEX32(0U, supervise(false, CYCLE_US));
}

/* A cycle with the drive off in which the axis moved by `ticks`. */
static uint32_t off_cycle(int32_t ticks)
{
    (void)axis_rest(&axis, CYCLE_US);
    return observe_way(ticks) | supervise(false, CYCLE_US);
}

static uint32_t off_cycles(uint32_t cycles)
{
    uint32_t notes = 0U;
    for (uint32_t i = 0U; i < cycles; i++) {
        notes |= off_cycle(0);
    }
    return notes;
}

void test_SWR_AXIS_016_an_axis_that_moves_while_off_is_a_fault_in_the_cycle_beyond_the_limit(void)
{
    const int32_t limits[ROBOT_AXIS_MAX] = {7, 7, 4, 333, 11, 6, 6};
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        use(&robot_neuro.axes[i]);
        TEST_ASSERT_EQUAL_HEX32(0U, off_cycles(20U));
        TEST_ASSERT_EQUAL_HEX32(0U, off_cycle(limits[i]));
        TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_MOVED_OFF, off_cycle(1));
        TEST_ASSERT_EQUAL_INT32(limits[i] + 1, axis.supervision.sealed.off_ticks);
        TEST_ASSERT_TRUE(axis_is_faulty(&axis));
        TEST_ASSERT_EQUAL_HEX32(0U, off_cycle(5));
    }
}

void test_SWR_AXIS_016_the_way_of_one_second_counts_in_both_directions(void)
{
    use(with_lower_switch);
    (void)off_cycles(20U);
    uint32_t notes = 0U;
    for (uint32_t i = 0U; (i < 1000U) && (notes == 0U); i++) {
        notes = off_cycle(((i % 3U) == 2U) ? -1 : 0);
    }
    TEST_ASSERT_EQUAL_HEX32(0U, notes);
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_MOVED_OFF, off_cycle(-1) | off_cycle(-1));
}

void test_SWR_AXIS_016_what_drifts_more_slowly_is_no_motion(void)
{
    use(with_upper_switch);
    (void)off_cycles(20U);
    for (uint32_t i = 0U; i < 100U; i++) {
        TEST_ASSERT_EQUAL_HEX32(0U, off_cycles(250U));
        TEST_ASSERT_EQUAL_HEX32(0U, off_cycle(1));
    }
}

void test_SWR_AXIS_016_the_last_of_a_driven_motion_does_not_count(void)
{
    use(with_lower_switch);
    setpoint_ticks = ABOVE;
    (void)push(20U);
    TEST_ASSERT_EQUAL_HEX32(0U, off_cycle(400));
    TEST_ASSERT_EQUAL_HEX32(0U, off_cycles(2000U));
}

void test_SWR_AXIS_016_homing_in_place_is_no_motion(void)
{
    use(without_switch);
    move_to(-77);
    (void)off_cycles(2000U);
    home_in_place();
    TEST_ASSERT_EQUAL_HEX32(0U, off_cycles(2000U));
    TEST_ASSERT_TRUE(axis_is_homed(&axis));
}

void test_SWR_AXIS_016_hands_may_move_an_axis_that_nobody_relies_on(void)
{
    axis_disable(&axis);
    (void)off_cycles(20U);
    TEST_ASSERT_EQUAL_HEX32(0U, off_cycle(40));
    use(without_switch);
    home_in_place();
    axis_disable(&axis);
    (void)off_cycles(20U);
    TEST_ASSERT_EQUAL_HEX32(AXIS_NOTE_MOVED_OFF, off_cycle(40));
    TEST_ASSERT_FALSE(axis_is_homed(&axis));
}

static void expect_guard(bool is_driven, int32_t below, int32_t above)
{
    int32_t lowest = 0;
    int32_t highest = 0;
    (void)supervise(false, 0U);
    axis_guard(&axis, config, is_driven, &lowest, &highest);
    TEST_ASSERT_EQUAL_UINT32((uint32_t)axis.sealed.encoder.reading - (uint32_t)below,
                             (uint32_t)lowest);
    TEST_ASSERT_EQUAL_UINT32((uint32_t)axis.sealed.encoder.reading + (uint32_t)above,
                             (uint32_t)highest);
}

void test_SWR_AXIS_017_the_guard_holds_position_and_set_point(void)
{
    use(with_lower_switch);
    const int32_t rest = 2 * 333;
    const int32_t driven = rest + config->following_error_ticks;

    move_to(500);
    expect_guard(false, rest, rest);
    setpoint_ticks = 540;
    (void)driven_cycle(0);
    expect_guard(true, driven, driven + 40);
    setpoint_ticks = 430;
    (void)driven_cycle(0);
    expect_guard(true, driven + 70, driven);
}

void test_SWR_AXIS_017_the_guard_of_an_inverted_encoder_is_that_of_its_readings(void)
{
    use(inverted);
    const int32_t driven = 2 * 7 + config->following_error_ticks;
    setpoint_ticks = 40;
    (void)driven_cycle(0);
    expect_guard(true, driven + 40, driven);
}

void test_SWR_AXIS_017_the_guard_stays_right_across_the_wrap_of_the_reading(void)
{
    use(with_lower_switch);
    axis.sealed.encoder.reading = INT32_MAX;
    expect_guard(false, 2 * 333, 2 * 333);
}

void test_SWR_STALL_001_a_stall_ends_the_homing(void)
{
    begin_homing();
    setpoint_ticks = ABOVE;
    expect_stall_after(STALL_CYCLES);
    TEST_ASSERT_FALSE(axis_is_homing(&axis));
}

void test_SWR_STALL_002_one_cycle_without_drive_begins_the_time_anew(void)
{
    setpoint_ticks = ABOVE;
    (void)push(STALL_CYCLES);
    TEST_ASSERT_EQUAL_UINT32((STALL_CYCLES - 1U) * CYCLE_US, axis.supervision.stall.no_progress_us);
    (void)axis_rest(&axis, CYCLE_US);
    (void)supervise(false, 0U);
    TEST_ASSERT_EQUAL_UINT32(0U, axis.supervision.stall.no_progress_us);
    expect_stall_after(STALL_CYCLES);
}

void test_SWR_STALL_002_time_without_drive_never_stalls(void)
{
    (void)axis_follow(&axis, config, ABOVE, 0, CYCLE_US);
    for (uint32_t i = 0U; i < 10U; i++) {
        TEST_ASSERT_EQUAL_HEX32(0U, supervise(false, LIMIT_STALL_TIME_US));
        TEST_ASSERT_EQUAL_UINT32(0U, axis.supervision.stall.no_progress_us);
    }
}

void test_SWR_STALL_002_what_moved_while_not_driven_is_no_progress(void)
{
    setpoint_ticks = ABOVE;
    (void)push(10U);
    (void)axis_rest(&axis, CYCLE_US);
    (void)observe_way(-20);
    (void)supervise(false, CYCLE_US);
    (void)push(STALL_CYCLES - 1U);
    TEST_ASSERT_EQUAL_HEX32(0U, driven_cycle(PROGRESS));
    TEST_ASSERT_EQUAL_HEX32(0U, push(STALL_CYCLES - 1U));
}

void test_SWR_STALL_003_a_stall_is_reported_exactly_once(void)
{
    uint32_t reported = 0U;

    setpoint_ticks = ABOVE;
    for (uint32_t i = 0U; i < 10U * STALL_CYCLES; i++) {
        const uint32_t notes = driven_cycle(0);
        reported += ((notes & AXIS_NOTE_STALLED) != 0U) ? 1U : 0U;
    }
    TEST_ASSERT_EQUAL_UINT32(1U, reported);
}

void test_SWR_CORE_004_an_axis_with_a_damaged_stall_watchdog_is_not_driven_on(void)
{
    axis.supervision.stall.state_inverse ^= 4U;
    TEST_ASSERT_TRUE(axis_check(&axis));
    TEST_ASSERT_FALSE(axis_check(&axis));
    TEST_ASSERT_TRUE(axis_is_faulty(&axis));
    TEST_ASSERT_EQUAL_HEX32(0U, observe_way(0));
    axis_enable(&axis, false);
    setpoint_ticks = ABOVE;
    expect_stall_after(STALL_CYCLES);
}
