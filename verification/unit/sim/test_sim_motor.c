/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: speed = full speed * duty share, nothing below a tenth of it; gained with 15 ms,
 * lost with 1.5 ms; off means standing still at once and holding.
 */
#include "unity.h"

#include "card/card_frame.h"
#include "sim/model/sim_motor.h"

#include <string.h>

#define FULL_SPEED 10000
#define MINIMUM_DUTY 10000U
#define MAXIMUM_DUTY 100000U

static sim_motor_t motor;
static const card_drive_t off = {CARD_DRIVE_OFF, 0U, 0U, 0U};
static const card_drive_t run_up = {CARD_DRIVE_PWM, 1U, MAXIMUM_DUTY, 0U};
static const card_drive_t run_down = {CARD_DRIVE_PWM, 0U, MAXIMUM_DUTY, 0U};

static axis_config_t an_axis(void)
{
    axis_config_t axis;

    (void)memset(&axis, 0, sizeof axis);
    axis.minimum_ticks = -10000;
    axis.maximum_ticks = 10000;
    axis.full_speed_ticks_per_s = FULL_SPEED;
    axis.minimum_duty = MINIMUM_DUTY;
    axis.maximum_duty = MAXIMUM_DUTY;
    return axis;
}

void setUp(void)
{
    const axis_config_t axis = an_axis();

    sim_motor_init(&motor, &axis, 0.0, 0.0);
}

void tearDown(void)
{
}

static void drive_for(card_drive_t drive, uint32_t us)
{
    for (uint32_t passed_us = 0U; passed_us < us; passed_us += SIM_STEP_US) {
        sim_motor_step(&motor, &drive, true);
    }
}

static int speed(void)
{
    return (int)motor.speed_ticks_per_s;
}

static int steady_in(card_drive_mode_t mode, uint32_t duty)
{
    const card_drive_t drive = {mode, 1U, duty, 0U};
    const double value = sim_motor_steady_speed(&motor, &drive);

    return (int)(value + 0.5);
}

static int steady(uint32_t duty)
{
    return steady_in(CARD_DRIVE_PWM, duty);
}

void test_SWR_BOX_002_a_motor_that_is_off_holds_its_position(void)
{
    motor.load = 0.9;
    drive_for(off, 1000000U);
    TEST_ASSERT_TRUE(motor.position_ticks == 0.0);
}

void test_SWR_BOX_002_switching_off_stops_and_holds_at_once(void)
{
    drive_for(run_up, 100000U);
    const double position = motor.position_ticks;
    drive_for(off, SIM_STEP_US);
    TEST_ASSERT_EQUAL_INT(0, speed());
    TEST_ASSERT_TRUE(motor.position_ticks == position);
}

void test_SWR_BOX_002_without_power_a_driven_motor_stops_and_holds(void)
{
    drive_for(run_up, 100000U);
    const double position = motor.position_ticks;
    sim_motor_step(&motor, &run_up, false);
    TEST_ASSERT_EQUAL_INT(0, speed());
    TEST_ASSERT_TRUE(motor.position_ticks == position);
}

void test_SWR_BOX_002_below_the_smallest_duty_it_stands_still(void)
{
    TEST_ASSERT_EQUAL_INT(0, steady(0U));
    TEST_ASSERT_EQUAL_INT(0, steady(MINIMUM_DUTY - 1U));
    TEST_ASSERT_EQUAL_INT(FULL_SPEED / 10, steady(MINIMUM_DUTY));
}

void test_SWR_BOX_002_speed_is_linear_in_the_duty_and_ends_at_the_largest(void)
{
    TEST_ASSERT_INT_WITHIN(1, FULL_SPEED * 55 / 100, steady((MINIMUM_DUTY + MAXIMUM_DUTY) / 2U));
    TEST_ASSERT_EQUAL_INT(FULL_SPEED, steady(MAXIMUM_DUTY));
    TEST_ASSERT_EQUAL_INT(FULL_SPEED, steady(0x1FFFFU));
}

void test_SWR_BOX_002_a_motor_without_a_duty_range_does_not_obey_pwm(void)
{
    motor.minimum_duty = 0.0;
    motor.maximum_duty = 0.0;
    TEST_ASSERT_EQUAL_INT(0, steady(0x1FFFFU));
}

void test_SWR_BOX_009_without_magnitudes_a_motor_without_pwm_runs_at_full_speed(void)
{
    motor.minimum_duty = 0.0;
    motor.maximum_duty = 0.0;
    TEST_ASSERT_EQUAL_INT(FULL_SPEED, steady_in(CARD_DRIVE_NON_PWM, 0U));
}

void test_SWR_BOX_009_with_magnitudes_a_motor_without_pwm_turns_as_fast_as_they_say(void)
{
    TEST_ASSERT_EQUAL_INT(0, steady_in(CARD_DRIVE_NON_PWM, MINIMUM_DUTY - 1U));
    for (uint32_t duty = MINIMUM_DUTY; duty <= MAXIMUM_DUTY; duty += 10000U) {
        TEST_ASSERT_EQUAL_INT(steady(duty), steady_in(CARD_DRIVE_NON_PWM, duty));
    }
}

void test_SWR_BOX_002_a_load_slows_it_and_sticks_it_below_a_tenth(void)
{
    motor.load = 0.5;
    TEST_ASSERT_EQUAL_INT(FULL_SPEED / 2, steady(MAXIMUM_DUTY));
    motor.load = 0.91;
    TEST_ASSERT_EQUAL_INT(0, steady(MAXIMUM_DUTY));
    drive_for(run_up, 100000U);
    TEST_ASSERT_EQUAL_INT(0, speed());
}

void test_SWR_BOX_002_it_gains_speed_with_15_ms(void)
{
    drive_for(run_up, SIM_MOTOR_RISE_US);
    TEST_ASSERT_INT_WITHIN(FULL_SPEED / 100, FULL_SPEED * 632 / 1000, speed());
    drive_for(run_up, 2U * SIM_MOTOR_RISE_US);
    TEST_ASSERT_INT_WITHIN(FULL_SPEED / 100, FULL_SPEED * 950 / 1000, speed());
}

void test_SWR_BOX_002_it_starts_downwards_as_slowly_as_upwards(void)
{
    sim_motor_t other = motor;
    for (uint32_t i = 0U; i < 1000U; i++) {
        sim_motor_step(&motor, &run_down, true);
        sim_motor_step(&other, &run_up, true);
        TEST_ASSERT_TRUE(motor.speed_ticks_per_s == -other.speed_ticks_per_s);
        TEST_ASSERT_TRUE(motor.position_ticks == -other.position_ticks);
    }
}

void test_SWR_BOX_002_motors_differ_in_how_fast_they_gain_speed(void)
{
    motor.rise_share *= 2.0;
    drive_for(run_down, SIM_MOTOR_RISE_US / 2U);
    TEST_ASSERT_INT_WITHIN(FULL_SPEED / 100, -FULL_SPEED * 632 / 1000, speed());
}

void test_SWR_BOX_002_it_loses_speed_with_1500_us(void)
{
    const card_drive_t slow = {CARD_DRIVE_PWM, 1U, MINIMUM_DUTY, 0U};

    drive_for(run_up, 300000U);
    drive_for(slow, SIM_MOTOR_FALL_US);
    TEST_ASSERT_INT_WITHIN(FULL_SPEED / 100, 1000 + 9000 * 368 / 1000, speed());
}

void test_SWR_BOX_002_a_reversal_passes_through_standstill(void)
{
    drive_for(run_up, 300000U);
    double before = motor.speed_ticks_per_s;
    bool was_standing = false;
    for (uint32_t i = 0U; i < 1000U; i++) {
        drive_for(run_down, SIM_STEP_US);
        was_standing = was_standing || (motor.speed_ticks_per_s == 0.0);
        TEST_ASSERT_TRUE(motor.speed_ticks_per_s <= before || motor.speed_ticks_per_s <= 0.0);
        TEST_ASSERT_TRUE(was_standing || (motor.speed_ticks_per_s > 0.0));
        before = motor.speed_ticks_per_s;
    }
    TEST_ASSERT_INT_WITHIN(FULL_SPEED / 100, -FULL_SPEED, speed());
}

void test_SWR_BOX_002_the_two_directions_differ_by_the_asymmetry(void)
{
    motor.asymmetry = SIM_MOTOR_ASYMMETRY;
    TEST_ASSERT_EQUAL_INT(10300, (int)sim_motor_steady_speed(&motor, &run_up));
    TEST_ASSERT_EQUAL_INT(-9700, (int)sim_motor_steady_speed(&motor, &run_down));
}

void test_SWR_BOX_002_an_inverted_motor_turns_the_other_way(void)
{
    motor.is_inverted = true;
    TEST_ASSERT_EQUAL_INT(-FULL_SPEED, (int)sim_motor_steady_speed(&motor, &run_up));
    TEST_ASSERT_EQUAL_INT(FULL_SPEED, (int)sim_motor_steady_speed(&motor, &run_down));
}

void test_SWR_BOX_002_a_blocked_motor_stands_still_while_driven(void)
{
    motor.fault = SIM_MOTOR_STUCK;
    drive_for(run_up, 100000U);
    TEST_ASSERT_TRUE(motor.position_ticks == 0.0);
}

void test_SWR_BOX_002_a_motor_with_a_shorted_driver_runs_without_being_asked(void)
{
    motor.fault = SIM_MOTOR_RUNS;
    drive_for(off, 200000U);
    TEST_ASSERT_INT_WITHIN(FULL_SPEED / 100, FULL_SPEED / 2, speed());
    sim_motor_step(&motor, &off, false);
    TEST_ASSERT_EQUAL_INT(0, speed());
}

void test_SWR_BOX_002_a_motor_may_be_half_or_twice_as_fast(void)
{
    motor.fault = SIM_MOTOR_HALF;
    TEST_ASSERT_EQUAL_INT(FULL_SPEED / 2, (int)sim_motor_steady_speed(&motor, &run_up));
    motor.fault = SIM_MOTOR_TWICE;
    TEST_ASSERT_EQUAL_INT(2 * FULL_SPEED, (int)sim_motor_steady_speed(&motor, &run_up));
}

void test_SWR_BOX_002_a_driven_motor_ends_at_its_hard_stops(void)
{
    drive_for(run_up, 3000000U);
    TEST_ASSERT_TRUE(motor.position_ticks == 10400.0);
    TEST_ASSERT_EQUAL_INT(0, speed());
    drive_for(run_down, 5000000U);
    TEST_ASSERT_TRUE(motor.position_ticks == -10400.0);
}

void test_SWR_BOX_002_the_hard_stop_is_60_ticks_beyond_the_end_with_a_switch(void)
{
    axis_config_t axis = an_axis();

    axis.limit_switch = LIMIT_SWITCH_UPPER;
    sim_motor_init(&motor, &axis, 0.0, 0.0);
    TEST_ASSERT_TRUE(motor.highest_ticks == 10060.0);
    TEST_ASSERT_TRUE(motor.lowest_ticks == -10400.0);
    axis.limit_switch = LIMIT_SWITCH_LOWER;
    sim_motor_init(&motor, &axis, 0.0, 0.0);
    TEST_ASSERT_TRUE(motor.highest_ticks == 10400.0);
    TEST_ASSERT_TRUE(motor.lowest_ticks == -10060.0);
}

static void be_of(motor_type_t type)
{
    axis_config_t axis = an_axis();

    axis.motor_type = (uint8_t)type;
    sim_motor_init(&motor, &axis, 0.0, 0.0);
}

void test_SWR_BOX_010_each_type_grows_warm_in_its_own_way(void)
{
    be_of(MOTOR_TYPE_SHINSEI);
    TEST_ASSERT_EQUAL_DOUBLE(25.0, motor.heat.settled_c);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.0001 / 400.0, motor.heat.warming_share);
    be_of(MOTOR_TYPE_PIEZO);
    TEST_ASSERT_EQUAL_DOUBLE(15.0, motor.heat.settled_c);
    TEST_ASSERT_DOUBLE_WITHIN(1e-12, 0.0001 / 300.0, motor.heat.warming_share);
    be_of(MOTOR_TYPE_DTI);
    TEST_ASSERT_EQUAL_DOUBLE(20.0, motor.heat.settled_c);
}

void test_SWR_BOX_011_a_motor_as_warm_as_its_table_has_it_or_colder_is_no_faster(void)
{
    motor.temperature_c = 25.0;
    TEST_ASSERT_EQUAL_INT(FULL_SPEED, steady(MAXIMUM_DUTY));
    motor.temperature_c = 5.0;
    TEST_ASSERT_EQUAL_INT(FULL_SPEED, steady(MAXIMUM_DUTY));
}

void test_SWR_BOX_011_a_warm_motor_is_slower_by_its_type(void)
{
    be_of(MOTOR_TYPE_SHINSEI);
    motor.temperature_c = 50.0;
    TEST_ASSERT_EQUAL_INT(FULL_SPEED * 90 / 100, steady(MAXIMUM_DUTY));
    TEST_ASSERT_EQUAL_INT(-FULL_SPEED * 90 / 100, (int)sim_motor_steady_speed(&motor, &run_down));
    be_of(MOTOR_TYPE_PIEZO);
    motor.temperature_c = 65.0;
    TEST_ASSERT_EQUAL_INT(FULL_SPEED * 96 / 100, steady(MAXIMUM_DUTY));
    be_of(MOTOR_TYPE_DTI);
    motor.temperature_c = 50.0;
    TEST_ASSERT_EQUAL_INT(FULL_SPEED * 90 / 100, steady(MAXIMUM_DUTY));
}

void test_SWR_BOX_011_a_warm_motor_is_weaker_and_a_load_holds_it(void)
{
    motor.temperature_c = 50.0;
    motor.load = 0.425;
    TEST_ASSERT_INT_WITHIN(1, FULL_SPEED * 45 / 100, steady(MAXIMUM_DUTY));
    motor.load = 0.85;
    TEST_ASSERT_EQUAL_INT(0, steady(MAXIMUM_DUTY));
    motor.temperature_c = 25.0;
    TEST_ASSERT_INT_WITHIN(1, FULL_SPEED * 15 / 100, steady(MAXIMUM_DUTY));
}
