/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the box behaves as its parts do, moves only by its own time, and gives the same
 * bytes for the same seed and calls.
 */
#include "unity.h"
#include "sim/box.h"
#include "base/crc.h"
#include "sim/model/sim_encoder.h"
#include "unit/support/box_world.inc"

void setUp(void)
{
    begin_box();
}

void tearDown(void)
{
}

void test_SWR_BOX_002_every_axis_moves_up_with_an_upward_drive_and_back(void)
{
    for (uint32_t axis = NEURO_AXIS_HEAD; axis <= NEURO_AXIS_YAW; axis++) {
        setUp();
        const int start = position_of(axis);
        drive(axis, true);
        cycles(100U);
        const int top = position_of(axis);
        TEST_ASSERT_TRUE(top > start + 20);
        drive(axis, false);
        cycles(200U);
        TEST_ASSERT_TRUE(position_of(axis) < start - 20);
    }
}

void test_SWR_BOX_002_full_drive_gives_full_speed_within_3_percent(void)
{
    drive(NEURO_AXIS_INSERTION, true);
    cycles(200U);
    const int start = position_of(NEURO_AXIS_INSERTION);
    cycles(1000U);
    TEST_ASSERT_INT_WITHIN(25000 * 3 / 100, 25000, position_of(NEURO_AXIS_INSERTION) - start);
}

void test_SWR_BOX_001_axes_stand_still_when_the_exchanges_end(void)
{
    drive(NEURO_AXIS_HEAD, false);
    cycles(100U);
    box_advance(&box, LIMIT_CARD_WATCHDOG_US);
    const int stopped = position_of(NEURO_AXIS_HEAD);
    box_advance(&box, 1000000U);
    TEST_ASSERT_EQUAL_INT(stopped, position_of(NEURO_AXIS_HEAD));
    TEST_ASSERT_EQUAL_HEX32(CARD_STATUS_WATCHDOG,
                            report_of(NEURO_AXIS_HEAD).status & CARD_STATUS_FAULTS);
}

void test_SWR_BSP_005_the_amplifier_off_line_takes_the_torque_whatever_the_cards_are_sent(void)
{
    drive(NEURO_AXIS_FEET, true);
    cycles(100U);
    const int moving = position_of(NEURO_AXIS_FEET);
    cycles(10U);
    TEST_ASSERT_NOT_EQUAL_INT(moving, position_of(NEURO_AXIS_FEET));
    box.is_off = true;
    cycles(5U);
    const int stopped = position_of(NEURO_AXIS_FEET);
    cycles(100U);
    const card_report_t report = report_of(NEURO_AXIS_FEET);
    TEST_ASSERT_EQUAL_INT(stopped, position_of(NEURO_AXIS_FEET));
    TEST_ASSERT_NOT_EQUAL_UINT32(CARD_DRIVE_OFF, report.applied.mode);
    TEST_ASSERT_EQUAL_UINT32(0U, report.supply_mv);
    box.is_off = false;
    cycles(100U);
    TEST_ASSERT_NOT_EQUAL_INT(stopped, position_of(NEURO_AXIS_FEET));
}

void test_SWR_BOX_002_a_pulled_emergency_stop_takes_the_torque_and_blames_no_card(void)
{
    drive(NEURO_AXIS_FEET, true);
    cycles(100U);
    order("estop pull");
    const int stopped = position_of(NEURO_AXIS_FEET);
    cycles(100U);
    const card_report_t report = report_of(NEURO_AXIS_FEET);
    TEST_ASSERT_EQUAL_INT(stopped, position_of(NEURO_AXIS_FEET));
    TEST_ASSERT_EQUAL_UINT32(0U, report.supply_mv);
    TEST_ASSERT_EQUAL_HEX32(0U, report.status & CARD_STATUS_FAULTS);
    TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_NON_PWM, report.applied.mode);
}

void test_SWR_BOX_004_axes_start_away_from_home_with_arbitrary_readings(void)
{
    for (uint32_t axis = NEURO_AXIS_HEAD; axis <= NEURO_AXIS_YAW; axis++) {
        const int reading =
            (axis == NEURO_AXIS_FEET) ? INT32_MAX - 100 : 1000 * (robot_neuro.axes[axis].slot + 1);
        TEST_ASSERT_EQUAL_INT(robot_neuro.start_ticks[axis], position_of(axis));
        TEST_ASSERT_EQUAL_INT(reading, report_of(axis).encoder_count);
    }
}

void test_SWR_BOX_004_the_reading_follows_the_position_across_the_wrap(void)
{
    const int32_t before = report_of(NEURO_AXIS_FEET).encoder_count;

    drive(NEURO_AXIS_FEET,
          false); /* The feet encoder is inverted: its reading grows here and wraps. */
    cycles(1000U);
    const int32_t after = report_of(NEURO_AXIS_FEET).encoder_count;
    const uint32_t growth = (uint32_t)after - (uint32_t)before;
    TEST_ASSERT_TRUE(after < 0);
    TEST_ASSERT_INT_WITHIN(1, -position_of(NEURO_AXIS_FEET), (int)growth);
}

void test_SWR_BOX_004_driving_home_operates_the_switch_there(void)
{
    drive(NEURO_AXIS_HEAD, true);
    while (report_of(NEURO_AXIS_HEAD).limits_raw == 0U) {
        TEST_ASSERT_TRUE(position_of(NEURO_AXIS_HEAD) < 2);
        box_advance(&box, 1000U);
    }
    TEST_ASSERT_INT_WITHIN(2, 0, position_of(NEURO_AXIS_HEAD));
    cycles(1000U);
    TEST_ASSERT_EQUAL_INT(60, position_of(NEURO_AXIS_HEAD));
    TEST_ASSERT_EQUAL_HEX32(CARD_LIMIT_UPPER, report_of(NEURO_AXIS_HEAD).limits);
    drive(NEURO_AXIS_HEAD, false);
    cycles(200U);
    TEST_ASSERT_EQUAL_HEX32(0U, report_of(NEURO_AXIS_HEAD).limits);
}

void test_SWR_BOX_004_the_scanner_disturbs_resting_axes_a_little(void)
{
    const int32_t before = report_of(NEURO_AXIS_PITCH).encoder_count;
    uint32_t edges = 0U;

    order("scanner on");
    for (uint32_t i = 0U; i < 5000U; i++) {
        edges += report_of(NEURO_AXIS_PITCH).edges;
        box_advance(&box, 1000U);
    }
    TEST_ASSERT_TRUE(edges > 50U);
    TEST_ASSERT_INT32_WITHIN(5, before, report_of(NEURO_AXIS_PITCH).encoder_count);
    TEST_ASSERT_EQUAL_INT(100, position_of(NEURO_AXIS_PITCH));
}

void test_SWR_BOX_004_only_selected_slots_with_a_card_answer(void)
{
    TEST_ASSERT_EQUAL_HEX32(USED_SLOTS, exchange(ALL_SLOTS));
    TEST_ASSERT_EQUAL_HEX32(0x008U, exchange(0x009U));
    TEST_ASSERT_EACH_EQUAL_HEX8(0, received[0], CARD_FRAME_BYTES);
    TEST_ASSERT_EACH_EQUAL_HEX8(0, received[4], CARD_FRAME_BYTES);
}

void test_SWR_BOX_004_a_report_speaks_of_the_exchange_before(void)
{
    drive(NEURO_AXIS_HEAD, true);
    TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_OFF, report_of(NEURO_AXIS_HEAD).applied.mode);
    const card_report_t next = report_of(NEURO_AXIS_HEAD);
    TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_NON_PWM, next.applied.mode);
    TEST_ASSERT_EQUAL_UINT32(commands[7].sequence - 1U, next.accepted_sequence);
}

void test_SWR_BOX_004_time_below_a_step_is_kept(void)
{
    for (uint32_t i = 0U; i < 1000U; i++) {
        box_advance(&box, 33U);
    }
    TEST_ASSERT_EQUAL_UINT32(33000U, (uint32_t)box.time_us + box.pending_us);
    TEST_ASSERT_EQUAL_UINT32(0U, box.pending_us);
    box_advance(&box, 99U);
    TEST_ASSERT_EQUAL_UINT32(99U, box.pending_us);
}

/* One cycle, its time in pieces. @return what the cards have reported before */
static uint32_t crc_of_a_cycle(bool is_exchanged, uint32_t piece_us)
{
    (void)exchange(is_exchanged ? ALL_SLOTS : 0U);
    for (uint32_t us = 0U; us < 1000U; us += piece_us) {
        box_advance(&box, piece_us);
    }
    return crc32c(&received[0][0], sizeof received);
}

/* The sum over all axes, finer than the cards report it. */
static uint32_t sum_of_clocks_and_warmth(void)
{
    uint32_t sum = 0U;

    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        const sim_card_t *const card = &box.axes[i].card;
        sum = (sum * 31U) + (uint32_t)card->uptime_us + card->time_us;
        sum = (sum * 31U) + (uint32_t)(card->motor_temperature_c * 1e6);
    }
    return sum;
}

/* Axes that drive, rest, are warm, are pushed or disturbed, switches that act, and cards that trip.
 */
static uint32_t crc_of_a_course(uint32_t piece_us)
{
    static const struct {
        uint32_t cycle;
        const char *order;
    } orders[] = {
        {200U, "switch lateral stuck"}, {220U, "motor pitch hot"}, {230U, "motor pitch normal"},
        {240U, "scanner on"},           {260U, "scanner off"},     {280U, "estop pull"},
        {300U, "estop reset"},          {320U, "push 1"},          {340U, "switch yaw chatter"}};
    uint32_t next = 0U;
    uint32_t sum = 0U;

    start(1U);
    drive(NEURO_AXIS_HEAD, true);
    for (uint32_t i = 0U; i < 500U; i++) {
        if (i == 150U) {
            commands[robot_neuro.axes[NEURO_AXIS_HEAD].slot].drive = (card_drive_t){0};
        }
        if ((next < (sizeof orders / sizeof orders[0])) && (i == orders[next].cycle)) {
            order(orders[next].order);
            next++;
        }
        sum = (sum * 31U) + crc_of_a_cycle((i < 400U) || (i >= 450U), piece_us);
    }
    TEST_ASSERT_EQUAL_HEX32(CARD_STATUS_WATCHDOG,
                            report_of(NEURO_AXIS_HEAD).status & CARD_STATUS_WATCHDOG);
    return sum + sum_of_clocks_and_warmth();
}

/* Axes at rest are advanced over all of its steps at once. */
void test_SWR_BOX_004_time_in_pieces_is_the_same_time(void)
{
    const uint32_t whole = crc_of_a_course(1000U);

    TEST_ASSERT_EQUAL_HEX32(whole, crc_of_a_course(100U));
    TEST_ASSERT_EQUAL_HEX32(whole, crc_of_a_course(500U));
}

static double needle_mm(void)
{
    return box.axes[NEURO_AXIS_INSERTION].motor.position_ticks / 3333.34;
}

static int32_t needle_count(void)
{
    return sim_encoder_count(&box.axes[NEURO_AXIS_INSERTION].encoder);
}

void test_SWR_BOX_012_a_push_takes_the_axis_along_that_the_probe_is_coupled_to(void)
{
    const double start_mm = needle_mm();
    const int32_t start = needle_count();
    const double head_ticks = box.axes[NEURO_AXIS_HEAD].motor.position_ticks;

    order("push 10");
    box_advance(&box, 1000000U);
    TEST_ASSERT_FLOAT_WITHIN(0.01, start_mm + 5.0, needle_mm());
    box_advance(&box, 5000000U);
    TEST_ASSERT_FLOAT_WITHIN(0.01, start_mm + 10.0, needle_mm());
    TEST_ASSERT_INT32_WITHIN(2, 33333, needle_count() - start);
    order("push -200");
    box_advance(&box, 50000000U);
    TEST_ASSERT_FLOAT_WITHIN(0.03, 0.0, needle_mm());
    TEST_ASSERT_FLOAT_WITHIN(0.001, head_ticks, box.axes[NEURO_AXIS_HEAD].motor.position_ticks);
}

void test_SWR_BOX_012_a_free_probe_is_pushed_alone(void)
{
    const int32_t start = needle_count();

    order("probe free");
    order("push 30");
    box_advance(&box, 1000000U);
    order("show");
    TEST_ASSERT_NOT_NULL(strstr(reply, "free of the insertion, and 5.0000 mm in by hand"));
    box_advance(&box, 9000000U);
    order("show");
    TEST_ASSERT_NOT_NULL(strstr(reply, "30.0000 mm"));
    TEST_ASSERT_EQUAL_INT32(start, needle_count());
    order("push -30");
    box_advance(&box, 1000000U);
    order("probe coupled");
    box_advance(&box, 1000000U);
    order("show");
    TEST_ASSERT_NULL(strstr(reply, "by hand"));
    TEST_ASSERT_EQUAL_INT32(start, needle_count());
}

static uint32_t crc_of_a_run(uint32_t seed)
{
    uint32_t sum = 0U;

    start(seed);
    drive(NEURO_AXIS_HEAD, true);
    drive(NEURO_AXIS_YAW, false);
    order("scanner on");
    for (uint32_t i = 0U; i < 3000U; i++) {
        (void)exchange(ALL_SLOTS);
        sum = sum * 31U + crc32c(&received[0][0], sizeof received);
        box_advance(&box, 900U + i % 200U);
    }
    return sum;
}

void test_SWR_BOX_004_the_same_seed_and_calls_give_the_same_bytes(void)
{
    const uint32_t first = crc_of_a_run(7U);

    TEST_ASSERT_EQUAL_HEX32(first, crc_of_a_run(7U));
    TEST_ASSERT_NOT_EQUAL_HEX32(first, crc_of_a_run(8U));
}

void test_SWR_LINK_010_a_card_without_an_axis_answers_and_trips_at_a_drive(void)
{
    card_report_t report;
    robot_t robot = robot_neuro;
    robot.sensor_slots = 0x100U;
    box_init(&box, &robot, 1U);
    begin_sequence();
    commands[8] = (card_command_t){.slot = 8U,
                                   .sequence = 1U,
                                   .control = CARD_CONTROL_AMPLIFIER,
                                   .drive = {CARD_DRIVE_NON_PWM, 1U, 0U, 0U}};
    TEST_ASSERT_EQUAL_HEX32(USED_SLOTS | 0x100U, exchange(ALL_SLOTS));
    (void)exchange(ALL_SLOTS);
    TEST_ASSERT_EQUAL(CARD_FRAME_OK, card_frame_decode_report(received[8], 8U, &report));
    TEST_ASSERT_EQUAL_UINT32(CARD_TYPE_SENSOR, report.card_type);
    TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_OFF, report.applied.mode);
    TEST_ASSERT_BITS_HIGH(CARD_STATUS_DRIVER_FAULT, report.status);
}

void test_SWR_LINK_010_a_card_without_an_axis_takes_the_orders_of_cards_only(void)
{
    robot_t robot = robot_neuro;
    robot.sensor_slots = 0x100U;
    box_init(&box, &robot, 1U);
    TEST_ASSERT_FALSE(box_command(&box, "motor 8 stuck", reply, sizeof reply));
    TEST_ASSERT_FALSE(box_command(&box, "card 8 asleep", reply, sizeof reply));
    TEST_ASSERT_FALSE(box_command(&box, "card 9 silent", reply, sizeof reply));
    TEST_ASSERT_NOT_NULL(strstr(reply, ", 8 sensor."));
    TEST_ASSERT_TRUE(box_command(&box, "card 8 silent", reply, sizeof reply));
    TEST_ASSERT_EQUAL_HEX32(USED_SLOTS, exchange(ALL_SLOTS));
    TEST_ASSERT_TRUE(box_command(&box, "show", reply, sizeof reply));
    TEST_ASSERT_NOT_NULL(strstr(reply, "8  sensor"));
}
