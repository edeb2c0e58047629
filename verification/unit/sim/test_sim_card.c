/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the driver is on only while whole, new frames keep coming and nothing has
 * tripped; each trip is latched until a clear-fault frame, and the report states the truth about
 * the driver.
 */
#include "unity.h"

#include "card/card_frame.h"
#include "limits/requirement_limits.h"
#include "sim/model/sim_card.h"
#include "sim/model/sim_encoder.h"
#include "sim/model/sim_motor.h"

#include <string.h>

#define SLOT 3U

static sim_card_t card;
static sim_encoder_t encoder;
static card_command_t command;
static uint8_t frame[CARD_FRAME_BYTES];
static double position;
static bool is_limit_active;

/* Frame that a card wants to receive first, after a start and after a trip. */
static void begin_sequence(void)
{
    card_command_t first = command;

    first.control = CARD_CONTROL_CLEAR_FAULT;
    first.drive = (card_drive_t){CARD_DRIVE_OFF, 0U, 0U, 0U};
    card_frame_encode_command(&first, frame);
    sim_card_receive(&card, frame);
}

void setUp(void)
{
    axis_config_t axis;

    (void)memset(&axis, 0, sizeof axis);
    axis.slot = SLOT;
    axis.card_type = CARD_TYPE_PWM;
    axis.limit_switch = LIMIT_SWITCH_UPPER;
    position = 0.5;
    is_limit_active = false;
    sim_encoder_init(&encoder, &axis, position, 5000, 1U);
    sim_card_init(&card, &axis, &encoder, false, 0U);
    command = (card_command_t){.slot = SLOT,
                               .sequence = 10U,
                               .system_state = 0x25U,
                               .control = CARD_CONTROL_AMPLIFIER,
                               .drive = {CARD_DRIVE_PWM, 1U, 50000U, 0U},
                               .watchdog_us = LIMIT_CARD_WATCHDOG_US};
    begin_sequence();
}

void tearDown(void)
{
}

static void send(void)
{
    command.sequence++;
    card_frame_encode_command(&command, frame);
    sim_card_receive(&card, frame);
}

static void move(double ticks, uint32_t us)
{
    const uint32_t steps = us / SIM_STEP_US;

    for (uint32_t i = 0U; i < steps; i++) {
        const double next = position + ticks / (double)steps;
        sim_encoder_step(&encoder, position, next, card.time_us, false);
        position = next;
        sim_card_step(&card, &encoder, is_limit_active, true);
    }
}

static void pass(uint32_t us)
{
    move(0.0, us);
}

static card_report_t report(void)
{
    card_report_t read;

    sim_card_report(&card, &encoder, frame);
    TEST_ASSERT_EQUAL_INT(CARD_FRAME_OK, card_frame_decode_report(frame, SLOT, &read));
    return read;
}

static bool is_driving(void)
{
    return card.applied.mode != (uint32_t)CARD_DRIVE_OFF;
}

static void expect_off_with(uint32_t status_bit)
{
    const card_report_t read = report();

    TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_OFF, read.applied.mode);
    TEST_ASSERT_EQUAL_HEX32(status_bit, read.status & CARD_STATUS_FAULTS);
    TEST_ASSERT_EQUAL_HEX32(0U, read.status & CARD_STATUS_AMPLIFIER_ON);
}

void test_SWR_BOX_001_the_drive_goes_off_exactly_at_the_watchdog_time(void)
{
    send();
    pass(LIMIT_CARD_WATCHDOG_US - SIM_STEP_US);
    TEST_ASSERT_TRUE(is_driving());
    pass(SIM_STEP_US);
    expect_off_with(CARD_STATUS_WATCHDOG);
    TEST_ASSERT_EQUAL_UINT32(1U, report().watchdog_trips);
}

void test_SWR_BOX_001_each_valid_frame_starts_the_time_anew(void)
{
    for (uint32_t i = 0U; i < 50U; i++) {
        send();
        pass(LIMIT_CARD_WATCHDOG_US - SIM_STEP_US);
    }
    TEST_ASSERT_TRUE(is_driving());
}

void test_SWR_BOX_001_a_shorter_time_in_the_command_is_obeyed(void)
{
    command.watchdog_us = 3000U;
    send();
    pass(2900U);
    TEST_ASSERT_TRUE(is_driving());
    pass(SIM_STEP_US);
    TEST_ASSERT_FALSE(is_driving());
}

void test_SWR_BOX_001_no_command_can_ask_for_a_longer_time_or_none(void)
{
    static const uint32_t asked_us[] = {0U, LIMIT_CARD_WATCHDOG_US + 1U, UINT32_MAX};

    for (uint32_t i = 0U; i < 3U; i++) {
        setUp();
        command.watchdog_us = asked_us[i];
        send();
        pass(LIMIT_CARD_WATCHDOG_US - SIM_STEP_US);
        TEST_ASSERT_TRUE(is_driving());
        pass(SIM_STEP_US);
        TEST_ASSERT_FALSE(is_driving());
    }
}

void test_SWR_BOX_001_damaged_and_repeated_frames_do_not_count_as_valid(void)
{
    uint8_t damaged[CARD_FRAME_BYTES];

    send();
    (void)memcpy(damaged, frame, sizeof damaged);
    damaged[44] ^= 1U;
    for (uint32_t us = 0U; us < LIMIT_CARD_WATCHDOG_US; us += 1000U) {
        sim_card_receive(&card, frame);
        sim_card_receive(&card, damaged);
        pass(1000U);
    }
    TEST_ASSERT_EQUAL_HEX32(CARD_STATUS_RX_CRC, report().status & CARD_STATUS_RX_CRC);
    TEST_ASSERT_EQUAL_HEX32(0U, report().status & CARD_STATUS_RX_CRC);
    TEST_ASSERT_EQUAL_UINT32(10U, report().rx_crc_errors);
    expect_off_with(CARD_STATUS_WATCHDOG);
}

void test_SWR_BOX_001_a_trip_is_counted_once_and_not_before_the_first_frame(void)
{
    sim_card_init(&card, &(axis_config_t){.slot = SLOT, .card_type = CARD_TYPE_PWM}, &encoder,
                  false, 0U);
    pass(1000000U);
    TEST_ASSERT_EQUAL_UINT32(0U, report().watchdog_trips);
    begin_sequence();
    pass(1000000U);
    TEST_ASSERT_EQUAL_UINT32(1U, report().watchdog_trips);
}

void test_SWR_BOX_001_after_a_trip_new_commands_alone_do_not_drive(void)
{
    send();
    pass(LIMIT_CARD_WATCHDOG_US);
    send();
    expect_off_with(CARD_STATUS_WATCHDOG);
}

void test_SWR_BOX_001_the_frame_after_the_clearing_one_drives(void)
{
    send();
    pass(LIMIT_CARD_WATCHDOG_US);
    begin_sequence();
    TEST_ASSERT_FALSE(is_driving());
    send();
    TEST_ASSERT_TRUE(is_driving());
    TEST_ASSERT_EQUAL_HEX32(0U, report().status & CARD_STATUS_FAULTS);
}

static void replay(uint32_t sequence)
{
    card_command_t old = command;

    old.sequence = sequence;
    card_frame_encode_command(&old, frame);
    sim_card_receive(&card, frame);
}

void test_SWR_BOX_008_only_the_next_sequence_numbers_are_heard(void)
{
    static const uint32_t steps[] = {0U, LIMIT_SEQUENCE_WINDOW + 1U, 0x80000000U, UINT32_MAX};

    for (uint32_t i = 0U; i < 4U; i++) {
        replay(command.sequence + steps[i]);
        TEST_ASSERT_FALSE(is_driving());
    }
    TEST_ASSERT_EQUAL_UINT32(4U, report().sequence_gaps);
    replay(command.sequence + LIMIT_SEQUENCE_WINDOW);
    TEST_ASSERT_TRUE(is_driving());
}

void test_SWR_BOX_008_a_sequence_wraps(void)
{
    sim_card_init(&card, &(axis_config_t){.slot = SLOT, .card_type = CARD_TYPE_PWM}, &encoder,
                  false, 0U);
    command.sequence = UINT32_MAX;
    begin_sequence();
    send();
    TEST_ASSERT_EQUAL_UINT32(0U, card.command.sequence);
    TEST_ASSERT_TRUE(is_driving());
}

void test_SWR_BOX_008_replayed_frames_do_not_drive_beyond_the_watchdog(void)
{
    send();
    for (uint32_t i = 0U; i < 50U; i++) {
        replay(command.sequence - (i % 5U));
        pass(1000U);
        TEST_ASSERT_EQUAL(i < 9U, is_driving());
    }
}

void test_SWR_BOX_008_after_a_trip_only_a_clearing_frame_without_drive_begins_anew(void)
{
    pass(LIMIT_CARD_WATCHDOG_US);
    send();
    TEST_ASSERT_FALSE(is_driving());
    command.control |= CARD_CONTROL_CLEAR_FAULT;
    send();
    TEST_ASSERT_BITS_HIGH(CARD_STATUS_WATCHDOG, report().status);
    command.sequence = 5U;
    command.control = CARD_CONTROL_AMPLIFIER;
    begin_sequence();
    TEST_ASSERT_EQUAL_UINT32(5U, report().accepted_sequence);
    send();
    TEST_ASSERT_TRUE(is_driving());
}

void test_SWR_BOX_001_without_amplifier_nothing_is_driven(void)
{
    command.control = 0U;
    send();
    TEST_ASSERT_FALSE(is_driving());
    TEST_ASSERT_EQUAL_HEX32(0U, report().status & CARD_STATUS_AMPLIFIER_ON);
}

void test_SWR_BOX_001_a_drive_for_another_card_type_is_a_driver_fault(void)
{
    command.drive = (card_drive_t){CARD_DRIVE_NON_PWM, 1U, 0U, 0U};
    send();
    expect_off_with(CARD_STATUS_DRIVER_FAULT);
}

/* A card without pwm that hears of `drive`; its axis has magnitudes up to `maximum_duty`. */
static void drive_without_pwm(uint32_t maximum_duty, card_drive_t drive)
{
    const axis_config_t axis = {
        .slot = SLOT, .card_type = CARD_TYPE_NON_PWM, .maximum_duty = maximum_duty};

    sim_card_init(&card, &axis, &encoder, false, 0U);
    begin_sequence();
    command.drive = drive;
    send();
}

void test_SWR_BOX_009_a_magnitude_that_the_axis_has_not_is_a_driver_fault(void)
{
    drive_without_pwm(0U, (card_drive_t){CARD_DRIVE_NON_PWM, 1U, 0U, 0U});
    TEST_ASSERT_TRUE(is_driving());
    drive_without_pwm(0U, (card_drive_t){CARD_DRIVE_NON_PWM, 1U, 1U, 0U});
    expect_off_with(CARD_STATUS_DRIVER_FAULT);
}

void test_SWR_BOX_009_a_magnitude_that_the_axis_has_is_applied(void)
{
    drive_without_pwm(50000U, (card_drive_t){CARD_DRIVE_NON_PWM, 1U, 40000U, 0U});
    TEST_ASSERT_TRUE(is_driving());
    TEST_ASSERT_EQUAL_UINT32(40000U, report().applied.duty);
}

void test_SWR_BOX_001_speed_above_the_guard_trips(void)
{
    command.overspeed_ticks_per_s = 10000U;
    send();
    move(-50.0, 5000U);
    send();
    move(-50.0, 5000U);
    send();
    move(-50.0, 5000U);
    TEST_ASSERT_TRUE(is_driving());
    send();
    move(-55.0, 5000U);
    expect_off_with(CARD_STATUS_OVERSPEED);
}

void test_SWR_BOX_001_a_reading_outside_the_position_guard_trips(void)
{
    command.guard_minimum_ticks = 4990;
    command.guard_maximum_ticks = 5010;
    send();
    move(10.0, 5000U);
    TEST_ASSERT_TRUE(is_driving());
    send();
    move(1.0, 5000U);
    expect_off_with(CARD_STATUS_GUARD);
}

void test_SWR_BOX_001_the_position_guard_holds_across_the_wrap_of_the_reading(void)
{
    encoder.count = (uint32_t)INT32_MAX;
    command.guard_minimum_ticks = INT32_MAX - 10;
    command.guard_maximum_ticks = INT32_MIN + 10;
    send();
    move(11.0, 5000U);
    TEST_ASSERT_TRUE(is_driving());
    send();
    move(1.0, 5000U);
    TEST_ASSERT_FALSE(is_driving());
}

void test_SWR_BOX_001_the_report_reports_what_is_applied_and_accepted(void)
{
    send();
    const card_report_t read = report();
    TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_PWM, read.applied.mode);
    TEST_ASSERT_EQUAL_UINT32(1U, read.applied.direction);
    TEST_ASSERT_EQUAL_UINT32(50000U, read.applied.duty);
    TEST_ASSERT_EQUAL_UINT32(command.sequence, read.accepted_sequence);
    TEST_ASSERT_EQUAL_HEX32(0x25U, read.system_state);
    TEST_ASSERT_EQUAL_UINT32(CARD_TYPE_PWM, read.card_type);
    TEST_ASSERT_EQUAL_HEX32(SIM_CARD_FIRMWARE, read.firmware);
    TEST_ASSERT_EQUAL_HEX32(CARD_STATUS_AMPLIFIER_ON, read.status & CARD_STATUS_AMPLIFIER_ON);
    TEST_ASSERT_EQUAL_UINT32(24000U, read.supply_mv);
    TEST_ASSERT_EQUAL_UINT32(350U, read.current_ma);
}

void test_SWR_BOX_001_heartbeat_time_and_gaps_are_counted(void)
{
    const uint32_t heartbeat = report().heartbeat;
    const uint32_t time_us = report().time_us;

    send();
    command.sequence += 5U;
    send();
    pass(1000000U);
    const card_report_t read = report();
    TEST_ASSERT_EQUAL_UINT32(heartbeat + 2U, read.heartbeat);
    TEST_ASSERT_EQUAL_UINT32(1000000U, read.time_us - time_us);
    TEST_ASSERT_EQUAL_UINT32(1U, read.sequence_gaps);
    TEST_ASSERT_EQUAL_UINT32(1U, read.uptime_s);
}

static void drive_for_a_minute(void)
{
    for (uint32_t i = 0U; i < 12000U; i++) {
        send();
        pass(5000U);
    }
}

void test_SWR_BOX_010_a_driven_motor_grows_warm_and_cools_down(void)
{
    TEST_ASSERT_EQUAL_INT32(220, report().motor_temperature_dc);
    drive_for_a_minute();
    TEST_ASSERT_INT32_WITHIN(1, 220 + 34, report().motor_temperature_dc);
    pass(60000000U);
    TEST_ASSERT_INT32_WITHIN(1, 220 + 29, report().motor_temperature_dc);
}

void test_SWR_BOX_010_driven_for_long_it_settles(void)
{
    card.motor_temperature_c = 47.0;
    drive_for_a_minute();
    TEST_ASSERT_EQUAL_INT32(470, report().motor_temperature_dc);
}

void test_SWR_BOX_004_the_limit_counts_after_3_ms_without_a_change(void)
{
    is_limit_active = true;
    pass(SIM_STEP_US);
    TEST_ASSERT_EQUAL_HEX32(CARD_LIMIT_UPPER, report().limits_raw);
    pass(SIM_CARD_DEBOUNCE_US - SIM_STEP_US);
    TEST_ASSERT_EQUAL_HEX32(0U, report().limits);
    pass(SIM_STEP_US);
    TEST_ASSERT_EQUAL_HEX32(CARD_LIMIT_UPPER, report().limits);
}

void test_SWR_BOX_004_a_bouncing_limit_does_not_count(void)
{
    for (uint32_t i = 0U; i < 100U; i++) {
        is_limit_active = !is_limit_active;
        pass(2000U);
    }
    TEST_ASSERT_EQUAL_HEX32(0U, report().limits);
}

void test_SWR_BOX_004_edges_are_reported_once_with_their_card_times(void)
{
    move(8.0, 8000U);
    const card_report_t first = report();
    TEST_ASSERT_EQUAL_INT32(5008, first.encoder_count);
    TEST_ASSERT_EQUAL_UINT32(8U, first.edges);
    TEST_ASSERT_UINT32_WITHIN(1U, 4000U, first.last_edge_us - first.fourth_edge_us);
    TEST_ASSERT_TRUE(first.time_us - first.last_edge_us < 1500U);
    TEST_ASSERT_EQUAL_HEX32(CARD_STATUS_MOVING, first.status & CARD_STATUS_MOVING);
    pass(100000U);
    const card_report_t second = report();
    TEST_ASSERT_EQUAL_UINT32(0U, second.edges);
    TEST_ASSERT_EQUAL_UINT32(first.last_edge_us, second.last_edge_us);
    TEST_ASSERT_EQUAL_HEX32(0U, second.status & CARD_STATUS_MOVING);
}

void test_SWR_BOX_004_illegal_edges_are_flagged(void)
{
    encoder.illegal_edges = 2U;
    const card_report_t read = report();
    TEST_ASSERT_EQUAL_UINT32(2U, read.illegal_edges);
    TEST_ASSERT_EQUAL_HEX32(CARD_STATUS_ILLEGAL_EDGE, read.status & CARD_STATUS_ILLEGAL_EDGE);
}
