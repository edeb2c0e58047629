/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: the self test names the fault of the wires, and the drives have power only
 * after a self test without a fault.
 */
#include "unity.h"
#include "bsp.h"
#include "mock_gpiod.h"
#include "sbrio/spi_bus.h"
#include "unit/support/gpio_world.h"
#include "unit/support/spi_world.h"
#include "unit/support/sbrio_world.inc"

TEST_INCLUDE_PATH("/usr/include")

void setUp(void)
{
    begin_board();
}

void tearDown(void)
{
    end_board();
}

static void assert_test_fails(const char *address, const char *sentence)
{
    open_board(address);
    TEST_ASSERT_FALSE(bsp_self_test(error, sizeof error));
    TEST_ASSERT_EQUAL_STRING(sentence, error);
    TEST_ASSERT_EQUAL_INT(0, POWER);
}

void test_SWR_SPI_008_the_self_test_names_shifted_bits(void)
{
    spi_world_wrong.late_bits = 1U;
    assert_test_fails(ONE_BUS LINES PATIENT,
                      "Slot 1 of /dev/spidev1.0 answers 1 bits beside its place: the clock of "
                      "100.0 MHz is probably too high, or mode=0 is not that of the card.");
}

void test_SWR_SPI_009_the_self_test_names_the_gap_that_is_needed(void)
{
    spi_world_wrong.needs_gap = true;
    assert_test_fails(ONE_BUS LINES PATIENT,
                      "Slot 1 of /dev/spidev1.0 answers while frames are far apart, and not as "
                      "they are: the chip select's pause is too short for it; give gap=20.");
}

void test_SWR_SPI_010_the_self_test_names_exchanged_slots(void)
{
    spi_world_wrong.shift_slots = 1U;
    assert_test_fails(ONE_BUS LINES PATIENT,
                      "Where slot 0 of /dev/spidev1.0 should answer, the card of slot 1 does; "
                      "compare slots= with the wires and the multiplexer.");
}

void test_SWR_SPI_010_the_self_test_names_damaged_reports(void)
{
    spi_world_wrong.damaged_byte = 99U;
    assert_test_fails(ONE_BUS LINES PATIENT,
                      "Slot 1 of /dev/spidev1.0 answers with damaged reports: check shield and "
                      "ground of its wires, and the firmware of the card, or lower the clock of "
                      "100.0 MHz.");
}

void test_SWR_SPI_010_the_self_test_names_a_card_that_stands_still(void)
{
    spi_world_wrong.repeats = true;
    assert_test_fails(ONE_BUS LINES PATIENT,
                      "Slot 1 of /dev/spidev1.0 gives the same report twice: its card does not "
                      "run; switch the box off and on.");
}

void test_SWR_SPI_010_the_self_test_says_that_no_card_answers(void)
{
    (void)memset(spi_world_has, 0, sizeof spi_world_has);
    assert_test_fails(ONE_BUS LINES PATIENT,
                      "No card answers; switch the box on, and check the plugs of its SPI wires.");
}

void test_SWR_SPI_010_the_self_test_says_that_nothing_is_transferred(void)
{
    spi_world_wrong.error = EIO;
    assert_test_fails(ONE_BUS LINES PATIENT,
                      "/dev/spidev1.0 does not transfer (Input/output error); check its "
                      "controller's driver.");
}

void test_SWR_SPI_010_the_self_test_says_that_a_transfer_does_not_end(void)
{
    spi_world_wrong.hangs = true;
    assert_test_fails(ONE_BUS LINES,
                      "/dev/spidev1.0 does not end a transfer in 50 ms; check its controller's "
                      "driver.");
    spi_world_wrong.hangs = false;
    (void)sem_post(&spi_world_released);
}

void test_SWR_SPI_010_no_card_obeys_what_the_self_test_sends(void)
{
    open_board(ONE_BUS LINES PATIENT);
    TEST_ASSERT_TRUE_MESSAGE(bsp_self_test(error, sizeof error), error);
    for (uint32_t slot = 1U; slot <= 7U; slot++) {
        TEST_ASSERT_FALSE(spi_world_cards[slot].has_sequence);
        TEST_ASSERT_EQUAL_UINT32(0U, spi_world_cards[slot].rx_crc_errors);
    }
}

void test_SWR_GPIO_005_drives_have_power_from_the_self_test_to_their_switching_off(void)
{
    open_board(ONE_BUS LINES PATIENT);
    TEST_ASSERT_EQUAL_INT(0, POWER);
    exchange(1U);
    TEST_ASSERT_EQUAL_INT(0, POWER);
    TEST_ASSERT_TRUE_MESSAGE(bsp_self_test(error, sizeof error), error);
    TEST_ASSERT_EQUAL_INT(1, POWER);
    bsp_drives_off();
    TEST_ASSERT_EQUAL_INT(0, POWER);
    exchange(2U);
    TEST_ASSERT_EQUAL_INT(0, POWER);
}

void test_SWR_GPIO_005_power_that_was_taken_is_not_given_again_before_the_board_is_opened(void)
{
    open_board(ONE_BUS LINES PATIENT);
    bsp_drives_off();
    TEST_ASSERT_FALSE(bsp_self_test(error, sizeof error));
    TEST_ASSERT_EQUAL_INT(0, POWER);
    bsp_close();
    open_board(ONE_BUS LINES PATIENT);
    TEST_ASSERT_TRUE_MESSAGE(bsp_self_test(error, sizeof error), error);
    TEST_ASSERT_EQUAL_INT(1, POWER);
}

void test_SWR_GPIO_005_a_line_of_power_that_does_not_follow_fails_the_self_test(void)
{
    gpio_world[0].lines[8].stuck_at = 0;
    open_board(ONE_BUS LINES PATIENT);
    TEST_ASSERT_FALSE(bsp_self_test(error, sizeof error));
    TEST_ASSERT_EQUAL_STRING("The line of the drives' power does not follow; check the wire "
                             "\"power\".",
                             error);
    bsp_drives_off();
}

void test_SWR_GPIO_005_switching_off_a_board_that_is_not_open_does_nothing(void)
{
    bsp_drives_off();
    TEST_ASSERT_EQUAL_UINT(0U, gpio_world[0].lines[8].sets);
}

void test_SWR_GPIO_007_a_watchdog_is_kicked_and_let_go_without_power(void)
{
    open_board(ONE_BUS LINES PATIENT ";watchdog:/dev/watchdog");
    TEST_ASSERT_NOT_EQUAL_UINT32(0U, identity.abilities & BSP_HAS_WATCHDOG);
    bsp_kick();
    TEST_ASSERT_EQUAL_STRING("", spi_world_kicks);
    TEST_ASSERT_TRUE_MESSAGE(bsp_self_test(error, sizeof error), error);
    bsp_kick();
    bsp_kick();
    TEST_ASSERT_EQUAL_STRING("k", spi_world_kicks);
    bsp_close();
    is_board_open = false;
    TEST_ASSERT_EQUAL_STRING("kV", spi_world_kicks);
}

void test_SWR_GPIO_007_a_watchdog_is_not_let_go_while_there_may_be_power(void)
{
    open_board(ONE_BUS LINES PATIENT ";watchdog:/dev/watchdog");
    TEST_ASSERT_TRUE_MESSAGE(bsp_self_test(error, sizeof error), error);
    gpio_world[0].lines[8].stuck_at = 1;
    bsp_close();
    is_board_open = false;
    TEST_ASSERT_EQUAL_STRING("", spi_world_kicks);
}

void test_SWR_GPIO_007_a_watchdog_that_cannot_be_had_fails_the_self_test(void)
{
    open_board(ONE_BUS LINES PATIENT ";watchdog:/dev/watchdog7");
    TEST_ASSERT_FALSE(bsp_self_test(error, sizeof error));
    TEST_ASSERT_EQUAL_STRING("The watchdog /dev/watchdog7 cannot be opened (No such file or "
                             "directory); end who uses it, or leave it out.",
                             error);
    TEST_ASSERT_EQUAL_INT(0, POWER);
    bsp_close();
    spi_world_wrong.timeout_s = 60;
    open_board(ONE_BUS LINES PATIENT ";watchdog:/dev/watchdog,timeout=3");
    TEST_ASSERT_FALSE(bsp_self_test(error, sizeof error));
    TEST_ASSERT_EQUAL_STRING("The watchdog /dev/watchdog does not take a timeout of 3 s; choose "
                             "another.",
                             error);
    TEST_ASSERT_EQUAL_STRING("V", spi_world_kicks);
}
