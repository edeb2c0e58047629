/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a client holds pedal or button from afar alone, and it opens when the client
 * lets go, says nothing any more, or a person at the box works it; late words do not close it
 * again.
 */
#include "unity.h"

#include "bsp_bench.h"
#include "limits/requirement_limits.h"
#include "robot/robot_neuro.h"
#include "sim/box.h"
#include "sim/box_grip.h"
#include "sim/model/sim_encoder.h"
#include "sim/model/sim_motor.h"
#include "sim/model/sim_switch.h"

#include <string.h>

#define NOW_US UINT64_C(5000000000000)

static box_t box;
static box_grip_t grip;
static char reply[BOX_REPLY_SIZE];

void setUp(void)
{
    box_init(&box, &robot_neuro, 1U);
    (void)memset(&grip, 0, sizeof grip);
}

void tearDown(void)
{
}

static bool order(const char *line)
{
    const bool is_done = box_command(&box, line, reply, sizeof reply);

    box_advance(&box, 10000U);
    return is_done;
}

static bool is_high(uint32_t input)
{
    return (box_inputs(&box) & input) != 0U;
}

static void expect_pedal(bool is_pressed)
{
    box_advance(&box, 10000U);
    TEST_ASSERT_EQUAL(is_pressed, is_high(BSP_IN_PEDAL_A));
    TEST_ASSERT_EQUAL(is_pressed, is_high(BSP_IN_PEDAL_B));
}

void test_SWR_BOX_020_what_is_not_renewed_opens(void)
{
    TEST_ASSERT_TRUE(order("pedal hold 7"));
    box_grip_look(&grip, &box, NOW_US);
    box_grip_look(&grip, &box, NOW_US + LIMIT_BOX_GRIP_US - 1U);
    expect_pedal(true);
    box_grip_look(&grip, &box, NOW_US + LIMIT_BOX_GRIP_US);
    expect_pedal(false);
}

void test_SWR_BOX_020_each_renewal_gives_it_as_long_again(void)
{
    TEST_ASSERT_TRUE(order("pedal hold 7"));
    box_grip_look(&grip, &box, NOW_US);
    for (uint64_t i = 1U; i < 20U; i++) {
        TEST_ASSERT_TRUE(order("keep 7"));
        box_grip_look(&grip, &box, NOW_US + i * (LIMIT_BOX_GRIP_US - 1U));
        expect_pedal(true);
    }
    box_grip_look(&grip, &box, NOW_US + 19U * (LIMIT_BOX_GRIP_US - 1U) + LIMIT_BOX_GRIP_US);
    expect_pedal(false);
}

void test_SWR_BOX_020_the_world_counts_and_not_the_box(void)
{
    TEST_ASSERT_TRUE(order("pedal hold 7"));
    box_grip_look(&grip, &box, NOW_US);
    box_advance(&box, 10U * LIMIT_BOX_GRIP_US);
    box_grip_look(&grip, &box, NOW_US + 1U);
    expect_pedal(true);
}

void test_SWR_BOX_020_a_late_renewal_closes_nothing(void)
{
    TEST_ASSERT_TRUE(order("pedal hold 7"));
    TEST_ASSERT_TRUE(order("button hold 7"));
    box_grip_look(&grip, &box, NOW_US);
    box_grip_look(&grip, &box, NOW_US + LIMIT_BOX_GRIP_US);
    TEST_ASSERT_TRUE(order("keep 7"));
    box_grip_look(&grip, &box, NOW_US + LIMIT_BOX_GRIP_US);
    expect_pedal(false);
    TEST_ASSERT_FALSE(is_high(BSP_IN_CONFIRM));
}

void test_SWR_BOX_020_pedal_and_button_are_held_apart(void)
{
    TEST_ASSERT_TRUE(order("pedal hold 7"));
    TEST_ASSERT_TRUE(order("button hold 8"));
    box_grip_look(&grip, &box, NOW_US);
    TEST_ASSERT_TRUE(order("keep 8"));
    box_grip_look(&grip, &box, NOW_US + LIMIT_BOX_GRIP_US);
    expect_pedal(false);
    TEST_ASSERT_TRUE(is_high(BSP_IN_CONFIRM));
    TEST_ASSERT_TRUE(order("button drop 8"));
    TEST_ASSERT_FALSE(is_high(BSP_IN_CONFIRM));
}

void test_SWR_HTTP_039_one_holds_it_at_a_time(void)
{
    TEST_ASSERT_TRUE(order("pedal hold 7"));
    TEST_ASSERT_FALSE(order("pedal hold 8"));
    TEST_ASSERT_TRUE(order("pedal drop 8"));
    TEST_ASSERT_TRUE(order("keep 8"));
    expect_pedal(true);
    TEST_ASSERT_TRUE(order("pedal hold 7"));
    TEST_ASSERT_TRUE(order("pedal drop 7"));
    expect_pedal(false);
    TEST_ASSERT_TRUE(order("pedal hold 8"));
    expect_pedal(true);
}

void test_SWR_BOX_020_who_stands_at_the_box_has_the_last_word(void)
{
    TEST_ASSERT_TRUE(order("pedal hold 7"));
    TEST_ASSERT_TRUE(order("pedal release"));
    TEST_ASSERT_TRUE(order("keep 7"));
    expect_pedal(false);
    TEST_ASSERT_TRUE(order("pedal press"));
    box_grip_look(&grip, &box, NOW_US);
    box_grip_look(&grip, &box, NOW_US + 10U * LIMIT_BOX_GRIP_US);
    expect_pedal(true);
    TEST_ASSERT_TRUE(order("pedal drop 7"));
    expect_pedal(true);
}

void test_SWR_BOX_003_nobody_is_no_holder(void)
{
    static const char *const lines[] = {
        "pedal hold", "pedal hold 0", "pedal hold x",    "pedal hold 7x",  "pedal hold 4294967296",
        "pedal drop", "pedal drop 0", "button hold",     "button hold -1", "button press 7",
        "keep",       "keep 0",       "pedal release 7", "keep 7 7",       "button pulse"};
    for (uint32_t i = 0U; i < (sizeof lines / sizeof lines[0]); i++) {
        TEST_ASSERT_FALSE_MESSAGE(order(lines[i]), lines[i]);
    }
    expect_pedal(false);
    TEST_ASSERT_TRUE(order("pedal hold 4294967295"));
    expect_pedal(true);
}

void test_SWR_BOX_003_what_orders_have_made_of_the_box_is_seen(void)
{
    static const char *const lines[] = {
        "pedal hold 7",   "button hold 8", "gate dose",         "probe free",    "card 3 foreign",
        "encoder 3 half", "motor 3 hot",   "switch 3 reversed", "plug 9 analog", "card 9 silent"};
    bsp_bench_t seen;

    for (uint32_t i = 0U; i < (sizeof lines / sizeof lines[0]); i++) {
        TEST_ASSERT_TRUE_MESSAGE(order(lines[i]), lines[i]);
    }
    box_show(&box, &seen);
    TEST_ASSERT_EQUAL_UINT32(7U, seen.pedal_holder);
    TEST_ASSERT_EQUAL_UINT32(8U, seen.button_holder);
    TEST_ASSERT_EQUAL_UINT32(BOX_GATE_DOSE, seen.gate);
    TEST_ASSERT_EQUAL_UINT32(1U, seen.is_probe_free);
    TEST_ASSERT_EQUAL_UINT8(1U, seen.slots[3].has_axis);
    TEST_ASSERT_EQUAL_UINT8(BOX_CARD_FOREIGN, seen.slots[3].card_fault);
    TEST_ASSERT_EQUAL_UINT8(SIM_ENCODER_HALF, seen.slots[3].encoder_fault);
    TEST_ASSERT_EQUAL_UINT8(SIM_MOTOR_HOT, seen.slots[3].motor_fault);
    TEST_ASSERT_EQUAL_UINT8(SIM_SWITCH_REVERSED, seen.slots[3].switch_fault);
    TEST_ASSERT_EQUAL_UINT8(CARD_TYPE_ANALOG, seen.slots[9].card_type);
    TEST_ASSERT_EQUAL_UINT8(0U, seen.slots[9].has_axis);
    TEST_ASSERT_EQUAL_UINT8(BOX_CARD_SILENT, seen.slots[9].card_fault);
    TEST_ASSERT_EQUAL_UINT8(CARD_TYPE_NONE, seen.slots[0].card_type);
}
