/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: an input is 1 only while its contact closes it and it was not interrupted, and
 * the line of the drives' power is 0 until it is set. Below is libgpiod's own header.
 */
#include "unity.h"

#include "bsp.h"
#include "mock_gpiod.h"
#include "sbrio/pins.h"

#include "unit/support/gpio_world.h"

#include <fcntl.h>

TEST_INCLUDE_PATH("/usr/include")

#define FOUR (BSP_IN_PEDAL_A | BSP_IN_PEDAL_B | BSP_IN_ESTOP_CHAIN | BSP_IN_SCANNER_IDLE)

static wiring_t wiring;
static pins_t pins;
static char error[256];

static void wire(wiring_line_name_t name, uint32_t chip, uint32_t offset)
{
    wiring.lines[name] = (wiring_line_t){.is_there = true, .chip = chip, .offset = offset};
}

/* Inputs 0 to 3 and the power on line 8 of the first chip, a lamp on the second. */
void setUp(void)
{
    gpio_world_init();
    wiring =
        (wiring_t){.chip_count = 2U, .chips = {"/dev/gpiochip0", "/dev/gpiochip1"}, .slowness = 1U};
    for (uint32_t i = 0U; i < 4U; i++) {
        wire((wiring_line_name_t)i, 0U, i);
    }
    wire(WIRING_POWER, 0U, 8U);
    wire((wiring_line_name_t)((uint32_t)WIRING_LAMPS + 1U), 1U, 5U);
    error[0] = '\0';
}

void tearDown(void)
{
    pins_close(&pins);
    TEST_ASSERT_FALSE(gpio_world[0].is_open);
    TEST_ASSERT_FALSE(gpio_world[1].is_open);
}

static void open_pins(void)
{
    TEST_ASSERT_TRUE_MESSAGE(pins_open(&pins, &wiring, error, sizeof error), error);
}

static struct gpiod_line *line(unsigned offset)
{
    return &gpio_world[0].lines[offset];
}

static void set_inputs(int value)
{
    for (unsigned i = 0U; i < 4U; i++) {
        line(i)->value = value;
    }
}

static void assert_sample(uint32_t levels, uint32_t dropped, uint32_t valid)
{
    const pins_sample_t sample = pins_sample(&pins);
    TEST_ASSERT_EQUAL_HEX32(levels, sample.levels);
    TEST_ASSERT_EQUAL_HEX32(dropped, sample.dropped);
    TEST_ASSERT_EQUAL_HEX32(valid, sample.valid);
}

void test_SWR_GPIO_001_inputs_are_1_while_their_contacts_close_them(void)
{
    open_pins();
    assert_sample(0U, FOUR, FOUR);
    set_inputs(1);
    assert_sample(FOUR, 0U, FOUR);
    line(2)->value = 0;
    assert_sample(FOUR & ~BSP_IN_ESTOP_CHAIN, BSP_IN_ESTOP_CHAIN, FOUR);
}

void test_SWR_GPIO_001_a_resistor_holds_each_input_at_0(void)
{
    wiring.are_pulled[0] = true;
    wiring.lines[WIRING_ESTOP].is_active_low = true;
    open_pins();
    TEST_ASSERT_EQUAL_INT(GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN, line(0)->flags);
    TEST_ASSERT_EQUAL_INT(GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW | GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP,
                          line(2)->flags);
}

void test_SWR_GPIO_001_without_resistors_of_the_chip_an_old_kernel_is_asked_for_none(void)
{
    wiring.lines[WIRING_ESTOP].is_active_low = true;
    open_pins();
    TEST_ASSERT_EQUAL_INT(0, line(0)->flags);
    TEST_ASSERT_EQUAL_INT(GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW, line(2)->flags);
}

void test_SWR_GPIO_002_a_pulse_that_nobody_sampled_is_dropped(void)
{
    open_pins();
    set_inputs(1);
    (void)pins_sample(&pins);
    line(2)->edges = 2;
    assert_sample(FOUR, BSP_IN_ESTOP_CHAIN, FOUR);
    assert_sample(FOUR, 0U, FOUR);
}

void test_SWR_GPIO_002_one_edge_is_enough(void)
{
    open_pins();
    set_inputs(1);
    line(0)->edges = 1;
    assert_sample(FOUR, BSP_IN_PEDAL_A, FOUR);
}

void test_SWR_GPIO_002_reading_edges_never_waits(void)
{
    open_pins();
    for (unsigned i = 0U; i < 4U; i++) {
        TEST_ASSERT_NOT_EQUAL_INT(0, fcntl(line(i)->file, F_GETFL) & O_NONBLOCK);
    }
}

void test_SWR_GPIO_003_so_many_edges_that_some_may_be_lost_drop_everything(void)
{
    open_pins();
    set_inputs(1);
    line(1)->edges = 15;
    assert_sample(FOUR, BSP_IN_PEDAL_B, FOUR);
    line(1)->edges = 16;
    assert_sample(FOUR, BSP_IN_ALL, FOUR);
    line(1)->edges = 1000;
    assert_sample(FOUR, BSP_IN_ALL, FOUR);
    TEST_ASSERT_EQUAL_INT(1000 - 16, line(1)->edges);
}

void test_SWR_GPIO_004_an_input_that_cannot_be_read_is_not_valid(void)
{
    open_pins();
    set_inputs(1);
    line(3)->value = -1;
    assert_sample(FOUR & ~BSP_IN_SCANNER_IDLE, BSP_IN_SCANNER_IDLE, FOUR & ~BSP_IN_SCANNER_IDLE);
    line(3)->value = 1;
    line(0)->edges = -1;
    assert_sample(FOUR & ~BSP_IN_PEDAL_A, BSP_IN_PEDAL_A, FOUR & ~BSP_IN_PEDAL_A);
}

void test_SWR_GPIO_004_an_input_that_is_not_wired_is_not_valid(void)
{
    wire(WIRING_CONFIRM, 1U, 0U);
    open_pins();
    gpio_world[1].lines[0].value = 1;
    assert_sample(BSP_IN_CONFIRM, FOUR, FOUR | BSP_IN_CONFIRM);
}

void test_SWR_GPIO_005_drives_have_no_power_until_it_is_given(void)
{
    line(8)->value = 1;
    open_pins();
    TEST_ASSERT_EQUAL_INT(0, line(8)->value);
    TEST_ASSERT_EQUAL_INT(0, line(8)->flags);
    TEST_ASSERT_TRUE(pins_set_power(&pins, true));
    TEST_ASSERT_EQUAL_INT(1, line(8)->value);
    TEST_ASSERT_TRUE(pins_set_power(&pins, false));
    TEST_ASSERT_EQUAL_INT(0, line(8)->value);
}

void test_SWR_GPIO_005_a_line_that_does_not_follow_is_reported(void)
{
    open_pins();
    line(8)->stuck_at = 0;
    TEST_ASSERT_FALSE(pins_set_power(&pins, true));
    line(8)->stuck_at = 1;
    TEST_ASSERT_FALSE(pins_set_power(&pins, false));
}

void test_SWR_GPIO_006_a_lamp_is_set_when_it_changes(void)
{
    open_pins();
    const struct gpiod_line *const lamp = &gpio_world[1].lines[5];
    pins_set_lamps(&pins, BSP_LAMP_ALIVE);
    TEST_ASSERT_EQUAL_UINT(0U, lamp->sets);
    pins_set_lamps(&pins, BSP_LAMP_ALIVE | BSP_LAMP_MAY_MOVE);
    TEST_ASSERT_EQUAL_INT(1, lamp->value);
    pins_set_lamps(&pins, BSP_LAMP_MAY_MOVE);
    TEST_ASSERT_EQUAL_UINT(1U, lamp->sets);
    pins_set_lamps(&pins, 0U);
    TEST_ASSERT_EQUAL_INT(0, lamp->value);
    TEST_ASSERT_EQUAL_UINT(2U, lamp->sets);
}

void test_SWR_GPIO_004_a_chip_that_is_not_there_is_refused(void)
{
    (void)strcpy(wiring.chips[1], "/dev/gpiochip7");
    TEST_ASSERT_FALSE(pins_open(&pins, &wiring, error, sizeof error));
    TEST_ASSERT_EQUAL_STRING("The GPIO chip /dev/gpiochip7 cannot be opened (No such file or "
                             "directory); check the device tree and the rights of this user.",
                             error);
}

void test_SWR_GPIO_004_a_line_that_another_program_has_is_refused(void)
{
    gpio_world_used = 8U;
    TEST_ASSERT_FALSE(pins_open(&pins, &wiring, error, sizeof error));
    TEST_ASSERT_EQUAL_STRING("Line 8 of /dev/gpiochip0 cannot be taken (Device or resource busy); "
                             "end who uses it, or give another one.",
                             error);
    gpio_world_used = 2U;
    TEST_ASSERT_FALSE(pins_open(&pins, &wiring, error, sizeof error));
}

void test_SWR_GPIO_004_a_line_that_the_chip_does_not_have_is_refused(void)
{
    wiring.are_pulled[0] = true;
    wiring.lines[WIRING_SCANNER].offset = GPIO_WORLD_LINES;
    TEST_ASSERT_FALSE(pins_open(&pins, &wiring, error, sizeof error));
    TEST_ASSERT_EQUAL_STRING("Line 16 of /dev/gpiochip0 cannot be taken (Invalid argument); end "
                             "who uses it, or give another one; a kernel before 5.5 has no "
                             "\"pull\".",
                             error);
}
