/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: the box obeys orders by name, and an order that is unknown or refused changes
 * nothing.
 */
#include "unity.h"
#include "sim/box.h"
#include "sim/model/sim_motor.h"
#include "unit/support/box_world.inc"

void setUp(void)
{
    begin_box();
}

void tearDown(void)
{
}

static void expect_refused(const char *line, const char *mentions)
{
    static box_t before;

    before = box;
    TEST_ASSERT_FALSE_MESSAGE(box_command(&box, line, reply, sizeof reply), line);
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(reply, mentions), reply);
    TEST_ASSERT_EQUAL_MEMORY(&before, &box, sizeof box);
}

static bool is_high(uint32_t input)
{
    return (box_inputs(&box) & input) != 0U;
}

/* Since the sample before, which this one is for the next. */
static bool was_high(uint32_t input)
{
    const bsp_inputs_t sample = box_sample(&box);

    TEST_ASSERT_EQUAL_HEX32(BSP_IN_ALL, sample.valid);
    return (sample.levels & ~sample.dropped & input) != 0U;
}

static void expect_pedal(bool a, bool b)
{
    TEST_ASSERT_EQUAL(a, is_high(BSP_IN_PEDAL_A));
    TEST_ASSERT_EQUAL(b, is_high(BSP_IN_PEDAL_B));
}

void test_SWR_BOX_003_press_closes_b_and_4_ms_later_a(void)
{
    expect_pedal(false, false);
    order("pedal press");
    expect_pedal(false, true);
    box_advance(&box, BOX_PEDAL_CLOSE_SPREAD_US - SIM_STEP_US);
    expect_pedal(false, true);
    box_advance(&box, SIM_STEP_US);
    expect_pedal(true, true);
}

void test_SWR_BOX_003_release_opens_both_2_ms_apart(void)
{
    order("pedal press");
    box_advance(&box, 10000U);
    order("pedal release");
    expect_pedal(false, true);
    box_advance(&box, BOX_PEDAL_OPEN_SPREAD_US - SIM_STEP_US);
    expect_pedal(false, true);
    box_advance(&box, SIM_STEP_US);
    expect_pedal(false, false);
}

void test_SWR_BOX_003_a_quick_release_overtakes_the_press(void)
{
    order("pedal press");
    box_advance(&box, 1000U);
    order("pedal release");
    box_advance(&box, 100000U);
    expect_pedal(false, false);
}

void test_SWR_BOX_003_single_pedal_channels_obey(void)
{
    order("pedal a close");
    expect_pedal(true, false);
    order("pedal b close");
    expect_pedal(true, true);
    order("pedal a open");
    expect_pedal(false, true);
    order("pedal b open");
    expect_pedal(false, false);
}

void test_SWR_BOX_003_emergency_stop_and_scanner_levels_obey(void)
{
    order("estop pull");
    order("scanner on");
    TEST_ASSERT_FALSE(is_high(BSP_IN_ESTOP_CHAIN));
    TEST_ASSERT_FALSE(is_high(BSP_IN_SCANNER_IDLE));
    order("estop reset");
    order("scanner off");
    TEST_ASSERT_TRUE(is_high(BSP_IN_ESTOP_CHAIN));
    TEST_ASSERT_TRUE(is_high(BSP_IN_SCANNER_IDLE));
}

void test_SWR_BOX_003_the_gate_of_the_treatment_obeys_and_is_latched(void)
{
    order("gate dose");
    TEST_ASSERT_FALSE(is_high(BSP_IN_DOSE_BELOW));
    TEST_ASSERT_TRUE(is_high(BSP_IN_TREATMENT_MAY));
    order("gate stop");
    TEST_ASSERT_TRUE(is_high(BSP_IN_DOSE_BELOW));
    TEST_ASSERT_FALSE(is_high(BSP_IN_TREATMENT_MAY));
    box_advance(&box, 1000U);
    order("gate off");
    TEST_ASSERT_TRUE(is_high(BSP_IN_TREATMENT_MAY));
    TEST_ASSERT_FALSE(was_high(BSP_IN_TREATMENT_MAY));
    TEST_ASSERT_TRUE(was_high(BSP_IN_TREATMENT_MAY));
}

void test_SWR_BOX_003_the_button_obeys(void)
{
    TEST_ASSERT_FALSE(is_high(BSP_IN_CONFIRM));
    order("button press");
    TEST_ASSERT_TRUE(is_high(BSP_IN_CONFIRM));
    order("button release");
    TEST_ASSERT_FALSE(is_high(BSP_IN_CONFIRM));
}

void test_SWR_REF_006_a_button_that_was_released_since_the_last_sample_is_released(void)
{
    order("button press");
    (void)box_sample(&box);
    box_advance(&box, 1000U);
    TEST_ASSERT_TRUE(was_high(BSP_IN_CONFIRM));
    order("button release");
    box_advance(&box, SIM_STEP_US);
    order("button press");
    box_advance(&box, 1000U);
    TEST_ASSERT_FALSE(was_high(BSP_IN_CONFIRM));
    box_advance(&box, 1000U);
    TEST_ASSERT_TRUE(was_high(BSP_IN_CONFIRM));
}

void test_SWR_BOX_003_a_silent_card_neither_answers_nor_hears(void)
{
    drive(NEURO_AXIS_INSERTION, true);
    cycles(20U);
    order("card 3 silent");
    TEST_ASSERT_EQUAL_HEX32(USED_SLOTS & ~0x008U, exchange(ALL_SLOTS));
    cycles(20U);
    const int stopped = position_of(NEURO_AXIS_INSERTION);
    cycles(100U);
    TEST_ASSERT_EQUAL_INT(stopped, position_of(NEURO_AXIS_INSERTION));
    order("card 3 normal");
    TEST_ASSERT_EQUAL_UINT32(1U, report_of(NEURO_AXIS_INSERTION).watchdog_trips);
}

void test_SWR_BOX_003_a_corrupt_card_sends_a_wrong_checksum(void)
{
    card_report_t report;

    order("card insertion corrupt");
    (void)exchange(ALL_SLOTS);
    TEST_ASSERT_EQUAL_INT(CARD_FRAME_BAD_CRC, card_frame_decode_report(received[3], 3U, &report));
    order("card insertion normal");
    (void)exchange(ALL_SLOTS);
    TEST_ASSERT_EQUAL_INT(CARD_FRAME_OK, card_frame_decode_report(received[3], 3U, &report));
}

void test_SWR_BOX_024_a_deaf_card_answers_and_trips(void)
{
    drive(NEURO_AXIS_INSERTION, true);
    cycles(20U);
    order("card insertion deaf");
    cycles(20U);
    const card_report_t report = report_of(NEURO_AXIS_INSERTION);
    TEST_ASSERT_EQUAL_UINT32(1U, report.watchdog_trips);
    TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_OFF, report.applied.mode);
}

void test_SWR_BOX_024_a_noisy_wire_damages_one_command_of_fifty(void)
{
    drive(NEURO_AXIS_INSERTION, true);
    cycles(20U);
    order("card insertion noisy");
    cycles(100U);
    const card_report_t report = report_of(NEURO_AXIS_INSERTION);
    TEST_ASSERT_EQUAL_UINT32(2U, report.rx_crc_errors);
    TEST_ASSERT_EQUAL_UINT32(2U, report.sequence_gaps);
    TEST_ASSERT_EQUAL_UINT32(CARD_DRIVE_PWM, report.applied.mode);
}

void test_SWR_BOX_024_driver_and_supply_are_measured_as_ordered(void)
{
    static const struct {
        const char *order;
        int32_t driver_dc;
        uint32_t supply_mv;
    } orders[] = {
        {"card 3 warm", 620, SIM_CARD_SUPPLY_MV},
        {"card 3 hot", 700, SIM_CARD_SUPPLY_MV},
        {"card 3 low", 300, 18000U},
        {"card 3 high", 300, 30000U},
        {"card 3 normal", 300, SIM_CARD_SUPPLY_MV},
    };

    for (uint32_t i = 0U; i < sizeof orders / sizeof orders[0]; i++) {
        order(orders[i].order);
        const card_report_t report = report_of(NEURO_AXIS_INSERTION);
        TEST_ASSERT_EQUAL_INT32_MESSAGE(orders[i].driver_dc, report.driver_temperature_dc,
                                        orders[i].order);
        TEST_ASSERT_EQUAL_UINT32_MESSAGE(orders[i].supply_mv, report.supply_mv, orders[i].order);
    }
}

void test_SWR_BOX_003_encoder_faults_obey(void)
{
    const int32_t before = report_of(NEURO_AXIS_INSERTION).encoder_count;

    drive(NEURO_AXIS_INSERTION, true);
    order("encoder 3 stuck");
    cycles(50U);
    TEST_ASSERT_EQUAL_INT32(before, report_of(NEURO_AXIS_INSERTION).encoder_count);
    order("encoder insertion reversed");
    cycles(50U);
    TEST_ASSERT_TRUE(report_of(NEURO_AXIS_INSERTION).encoder_count < before - 20);
    order("encoder 3 half");
    const int32_t half = report_of(NEURO_AXIS_INSERTION).encoder_count;
    const int there = position_of(NEURO_AXIS_INSERTION);
    cycles(50U);
    TEST_ASSERT_INT_WITHIN(2, (position_of(NEURO_AXIS_INSERTION) - there) / 2,
                           report_of(NEURO_AXIS_INSERTION).encoder_count - half);
    order("encoder 3 normal");
    const int32_t middle = report_of(NEURO_AXIS_INSERTION).encoder_count;
    cycles(50U);
    TEST_ASSERT_TRUE(report_of(NEURO_AXIS_INSERTION).encoder_count > middle + 20);
}

void test_SWR_BOX_003_a_stuck_motor_stands_until_freed(void)
{
    const int start = position_of(NEURO_AXIS_YAW);

    drive(NEURO_AXIS_YAW, false);
    order("motor yaw stuck");
    cycles(100U);
    TEST_ASSERT_EQUAL_INT(start, position_of(NEURO_AXIS_YAW));
    order("motor 5 normal");
    cycles(100U);
    TEST_ASSERT_TRUE(position_of(NEURO_AXIS_YAW) < start - 20);
}

void test_SWR_BOX_003_switch_faults_obey(void)
{
    order("switch insertion stuck");
    cycles(20U);
    TEST_ASSERT_EQUAL_HEX32(CARD_LIMIT_LOWER, report_of(NEURO_AXIS_INSERTION).limits);
    order("switch 3 open");
    cycles(20U);
    TEST_ASSERT_EQUAL_HEX32(0U, report_of(NEURO_AXIS_INSERTION).limits);
    order("switch 3 reversed");
    cycles(20U);
    TEST_ASSERT_EQUAL_HEX32(CARD_LIMIT_LOWER, report_of(NEURO_AXIS_INSERTION).limits);
    order("switch 3 chatter");
    order("switch 3 normal");
    cycles(20U);
    TEST_ASSERT_EQUAL_HEX32(0U, report_of(NEURO_AXIS_INSERTION).limits);
}

void test_SWR_ESTOP_004_a_pulse_is_in_the_next_sample_only(void)
{
    order("pedal press");
    box_advance(&box, 10000U);
    (void)box_sample(&box);
    order("estop pulse");
    order("pedal pulse");
    box_advance(&box, 1000U);
    TEST_ASSERT_TRUE(is_high(BSP_IN_ESTOP_CHAIN));
    const bsp_inputs_t pulsed = box_sample(&box);
    TEST_ASSERT_EQUAL_HEX32(BSP_IN_PEDAL_A | BSP_IN_PEDAL_B | BSP_IN_ESTOP_CHAIN,
                            pulsed.levels & pulsed.dropped);
    box_advance(&box, 1000U);
    const bsp_inputs_t after = box_sample(&box);
    TEST_ASSERT_EQUAL_HEX32(pulsed.levels, after.levels);
    TEST_ASSERT_EQUAL_HEX32(0U, after.levels & after.dropped);
    TEST_ASSERT_TRUE(is_high(BSP_IN_SCANNER_IDLE));
}

void test_SWR_BOX_003_show_lists_inputs_and_every_axis(void)
{
    drive(NEURO_AXIS_HEAD, true);
    drive(NEURO_AXIS_INSERTION, false);
    commands[robot_neuro.axes[NEURO_AXIS_INSERTION].slot].drive.duty = 0U;
    (void)exchange(ALL_SLOTS);
    order("encoder yaw reversed");
    order("card pitch silent");
    order("motor rotation stuck");
    order("pedal a close");
    order("show");
    for (uint32_t i = 0U; i < robot_neuro.axis_count; i++) {
        TEST_ASSERT_NOT_NULL(strstr(reply, robot_neuro.axes[i].name));
    }
    TEST_ASSERT_NOT_NULL(
        strstr(reply, "pedal a closed, pedal b open, e-stop closed, button released, scanner off, "
                      "gate off"));
    TEST_ASSERT_NOT_NULL(strstr(reply, "amplifier line on, lamps dark\n"));
    order("button press");
    box.is_off = true;
    box.lamps = BSP_LAMP_ALIVE | BSP_LAMP_FAULT;
    order("show");
    TEST_ASSERT_NOT_NULL(strstr(reply, "button pressed"));
    TEST_ASSERT_NOT_NULL(strstr(reply, "amplifier line off, lamps alive fault\n"));
    TEST_ASSERT_NOT_NULL(strstr(reply, "-20.0025 mm"));
    TEST_ASSERT_NOT_NULL(strstr(reply, "7.1998 deg"));
    TEST_ASSERT_NOT_NULL(strstr(reply, "- run"));
    TEST_ASSERT_NOT_NULL(strstr(reply, "- 0 "));
    TEST_ASSERT_NOT_NULL(strstr(reply, "reversed"));
    TEST_ASSERT_NOT_NULL(strstr(reply, "silent"));
    TEST_ASSERT_NOT_NULL(strstr(reply, "stuck"));
    box.axes[NEURO_AXIS_HEAD].card.applied.duty = 4321U;
    order("show");
    TEST_ASSERT_NOT_NULL(strstr(reply, "- 4321 "));
}

void test_SWR_BOX_003_orders_that_are_unknown_change_nothing_and_are_answered_with_the_known_ones(
    void)
{
    static const char *const wrong[] = {"",
                                        "dance",
                                        "pedal",
                                        "pedal up",
                                        "pedal c open",
                                        "pedal a up",
                                        "estop",
                                        "estop push",
                                        "estop pull now",
                                        "scanner maybe",
                                        "gate",
                                        "gate open",
                                        "gate stop now",
                                        "button",
                                        "button push",
                                        "card 3 broken",
                                        "card 3",
                                        "encoder 3 up",
                                        "motor 3 fast",
                                        "switch 3 loose",
                                        "show me",
                                        "probe",
                                        "probe loose",
                                        "push",
                                        "push x",
                                        "push 201",
                                        "push -201",
                                        "push 10 now",
                                        "card 3 silent now",
                                        "aVeryLongWordIndeed on"};

    for (uint32_t i = 0U; i < sizeof wrong / sizeof wrong[0]; i++) {
        expect_refused(wrong[i], "encoder SLOT stuck|reversed|half|normal");
    }
}

void test_SWR_BOX_003_an_empty_slot_is_refused_with_the_occupied_ones(void)
{
    expect_refused("card 9 silent", "there are 7 head, 6 feet, 4 lateral, 3 insertion");
    expect_refused("motor 33 stuck", "there are");
    expect_refused("encoder tail stuck", "there are");
}

void test_SWR_BOX_003_a_reply_never_exceeds_its_room(void)
{
    char tiny[8];

    (void)memset(tiny, 'x', sizeof tiny);
    TEST_ASSERT_TRUE(box_command(&box, " show\n", tiny, 4U));
    TEST_ASSERT_EQUAL_STRING("neu", tiny);
    TEST_ASSERT_EQUAL_CHAR('x', tiny[4]);
}

void test_SWR_BOX_003_the_list_of_orders_names_each(void)
{
    TEST_ASSERT_NOT_NULL(strstr(box_orders(), "pedal press|release"));
    TEST_ASSERT_NOT_NULL(strstr(box_orders(), "show"));
}

void test_SWR_BOX_003_a_card_is_plugged_in_where_no_axis_has_its_own(void)
{
    card_report_t report;

    TEST_ASSERT_FALSE(box_command(&box, "plug 7 pwm", reply, sizeof reply));
    TEST_ASSERT_FALSE(box_command(&box, "plug 9 steam", reply, sizeof reply));
    TEST_ASSERT_FALSE(box_command(&box, "plug 10 pwm", reply, sizeof reply));
    TEST_ASSERT_EQUAL_HEX32(USED_SLOTS, exchange(ALL_SLOTS));
    TEST_ASSERT_TRUE(box_command(&box, "plug 9 high_frequency", reply, sizeof reply));
    TEST_ASSERT_EQUAL_HEX32(USED_SLOTS | 0x200U, exchange(ALL_SLOTS));
    TEST_ASSERT_EQUAL(CARD_FRAME_OK, card_frame_decode_report(received[9], 9U, &report));
    TEST_ASSERT_EQUAL_UINT32(CARD_TYPE_HIGH_FREQUENCY, report.card_type);
    TEST_ASSERT_TRUE(box_command(&box, "show", reply, sizeof reply));
    TEST_ASSERT_NOT_NULL(strstr(reply, "9  high_frequency"));
    TEST_ASSERT_TRUE(box_command(&box, "plug 9 none", reply, sizeof reply));
    TEST_ASSERT_EQUAL_HEX32(USED_SLOTS, exchange(ALL_SLOTS));
}

void test_SWR_BOX_003_the_load_cell_reads_the_value_that_was_set(void)
{
    card_report_t report;
    static const char *const wrong[] = {"force foot 1",  "force hand 4096", "force hand x",
                                        "force hand 1x", "force hand",      "force needle -1"};

    TEST_ASSERT_TRUE(box_command(&box, "plug 9 sensor", reply, sizeof reply));
    for (uint32_t i = 0U; i < sizeof wrong / sizeof wrong[0]; i++) {
        TEST_ASSERT_FALSE_MESSAGE(box_command(&box, wrong[i], reply, sizeof reply), wrong[i]);
    }
    (void)exchange(ALL_SLOTS);
    TEST_ASSERT_EQUAL(CARD_FRAME_OK, card_frame_decode_report(received[9], 9U, &report));
    TEST_ASSERT_EQUAL_HEX32(BOX_HAND_AT_REST, report.adc_words[0]);
    TEST_ASSERT_EQUAL_HEX32(BOX_NEEDLE_AT_REST << 16U, report.adc_words[1]);
    TEST_ASSERT_TRUE(box_command(&box, "force hand 4095", reply, sizeof reply));
    TEST_ASSERT_TRUE(box_command(&box, "force needle 0", reply, sizeof reply));
    (void)exchange(ALL_SLOTS);
    TEST_ASSERT_EQUAL(CARD_FRAME_OK, card_frame_decode_report(received[9], 9U, &report));
    TEST_ASSERT_EQUAL_HEX32(4095U, report.adc_words[0]);
    TEST_ASSERT_EQUAL_HEX32(0U, report.adc_words[1]);
}
