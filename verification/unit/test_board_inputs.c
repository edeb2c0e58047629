/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: an input counts as safe only if the board read it, and it was so all the time
 * since the sample before; what a box does not have is not taken for something it says.
 */
#include "unity.h"

#include "control/board_inputs.h"

#include <string.h>

static board_inputs_t board;
static controller_inputs_t inputs;

void setUp(void)
{
    (void)memset(&board, 0, sizeof board);
    (void)memset(&inputs, 0xA5, sizeof inputs);
}

void tearDown(void)
{
}

static void take(uint32_t levels, uint32_t dropped, uint32_t valid)
{
    const bsp_inputs_t sampled = {.levels = levels, .dropped = dropped, .valid = valid};
    board_inputs_take(&board, &sampled, &inputs);
}

static void expect_cut(void)
{
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.pedal_a);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.pedal_b);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.estop_open);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.scanner_active);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.confirm_pressed);
}

void test_SWR_BSP_001_each_level_has_its_meaning(void)
{
    take(BSP_IN_ALL, 0U, BSP_IN_ALL);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.pedal_a);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.pedal_b);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.estop_open);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.scanner_active);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.has_button);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.confirm_pressed);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.dose_reached);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.treatment_stopped);
    take(BSP_IN_PEDAL_B | BSP_IN_SCANNER_IDLE | BSP_IN_TREATMENT_MAY, 0U, BSP_IN_ALL);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.pedal_a);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.pedal_b);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.estop_open);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.scanner_active);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.confirm_pressed);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.dose_reached);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.treatment_stopped);
    TEST_ASSERT_EQUAL_HEX32(0xA5A5A5A5U, inputs.elapsed_us); /* Nothing else is touched. */
    TEST_ASSERT_EQUAL_HEX32(0xA5A5A5A5U, inputs.frames_received);
}

void test_SWR_BSP_001_what_was_low_in_between_is_low(void)
{
    take(BSP_IN_ALL, BSP_IN_ALL, BSP_IN_ALL);
    expect_cut();
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.dose_reached);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.treatment_stopped);
    take(BSP_IN_ALL, BSP_IN_ESTOP_CHAIN, BSP_IN_ALL);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.estop_open);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.pedal_a);
}

void test_SWR_BSP_001_what_was_not_read_is_as_with_a_cut_wire(void)
{
    take(BSP_IN_ALL, 0U, BSP_IN_ALL);
    take(BSP_IN_ALL, 0U, 0U);
    expect_cut();
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.has_button); /* It is there, and does not answer. */
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.dose_reached);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.treatment_stopped);
}

void test_SWR_BSP_001_a_box_without_button_or_gate_says_nothing_of_them(void)
{
    const uint32_t there = BSP_IN_PEDAL_A | BSP_IN_PEDAL_B | BSP_IN_ESTOP_CHAIN;
    take(there, 0U, there);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.has_button);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.confirm_pressed);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.dose_reached);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.treatment_stopped);
    TEST_ASSERT_EQUAL_UINT32(1U, inputs.scanner_active);
    TEST_ASSERT_EQUAL_UINT32(0U, inputs.estop_open);
}
