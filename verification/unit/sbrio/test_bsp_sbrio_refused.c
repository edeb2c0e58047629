/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a board that cannot work is refused in one sentence.
 */
#include "unity.h"
#include "bsp.h"
#include "mock_gpiod.h"
#include "sbrio/spi_bus.h"
#include "unit/support/gpio_world.h"
#include "unit/support/spi_world.h"
#include "limits/requirement_limits.h"
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

static void assert_refused(const char *address, const char *sentence)
{
    TEST_ASSERT_FALSE(bsp_open(address, &identity, error, sizeof error));
    TEST_ASSERT_EQUAL_STRING(sentence, error);
}

void test_SWR_SPI_005_a_device_that_is_not_there_is_refused(void)
{
    assert_refused("spidev:/dev/spidev7.0,slots=3,clock=5000000;" LINES,
                   "The SPI device /dev/spidev7.0 cannot be opened (No such file or directory); "
                   "load spidev, check the device tree and the rights of this user.");
    assert_refused("spidev:/dev/spidev1.0,slots=0-4,clock=50000000;"
                   "spidev:/dev/spidev1.7,slots=5,clock=50000000;" LINES,
                   "The SPI device /dev/spidev1.7 cannot be opened (No such file or directory); "
                   "load spidev, check the device tree and the rights of this user.");
}

void test_SWR_SPI_005_a_mode_that_is_not_taken_is_refused(void)
{
    static const unsigned long requests[] = {SPI_IOC_WR_MODE, SPI_IOC_WR_BITS_PER_WORD,
                                             SPI_IOC_RD_MODE, SPI_IOC_RD_BITS_PER_WORD};
    for (uint32_t i = 0U; i < sizeof requests / sizeof requests[0]; i++) {
        spi_world_wrong.refused = requests[i];
        assert_refused(ONE_BUS LINES, "/dev/spidev1.0 does not take mode 0 with 8 bits (Invalid "
                                      "argument); choose another mode=.");
    }
}

void test_SWR_SPI_005_a_mode_that_reads_back_as_another_is_refused(void)
{
    spi_world_wrong.forced_mode = 1U + 3U;
    assert_refused(ONE_BUS LINES,
                   "/dev/spidev1.0 has mode 3 with 8 bits after mode 0 with 8 bits was set; choose "
                   "another mode=, or mend its entry in the device tree.");
    spi_world_wrong.forced_mode = 0U;
    spi_world_wrong.forced_bits = 1U + 16U;
    assert_refused(ONE_BUS LINES,
                   "/dev/spidev1.0 has mode 0 with 16 bits after mode 0 with 8 bits was set; "
                   "choose another mode=, or mend its entry in the device tree.");
    spi_world_wrong.forced_bits = 1U;
    open_board(ONE_BUS LINES);
}

void test_SWR_SPI_005_a_clock_that_is_not_taken_is_refused(void)
{
    spi_world_wrong.refused = SPI_IOC_WR_MAX_SPEED_HZ;
    assert_refused(ONE_BUS LINES, "/dev/spidev1.0 does not take a clock of 100000000 Hz (Invalid "
                                  "argument); choose another.");
    spi_world_wrong.refused = SPI_IOC_RD_MAX_SPEED_HZ;
    assert_refused(ONE_BUS LINES, "/dev/spidev1.0 does not take a clock of 100000000 Hz (Invalid "
                                  "argument); choose another.");
    spi_world_wrong.refused = 0U;
    spi_world_wrong.clock_most_hz = 50000000U;
    assert_refused(ONE_BUS LINES, "/dev/spidev1.0 has a clock of 50000000 Hz after 100000000 Hz "
                                  "were set; choose one that it can have.");
}

void test_SWR_SPI_005_a_message_that_the_kernel_does_not_take_is_refused(void)
{
    spi_world_set_limit("2048\n");
    assert_refused(ONE_BUS LINES, "The kernel takes 2048 bytes in one SPI message, and "
                                  "/dev/spidev1.0 needs 2560; boot with spidev.bufsiz=4096.");
    open_board("spidev:/dev/spidev1.0,slots=0-4,clock=100000000,gap=1;" LINES);
    bsp_close();
    spi_world_set_limit("4096\n");
    open_board(ONE_BUS LINES);
    bsp_close();
    spi_world_set_limit("many\n");
    open_board(ONE_BUS LINES);
}

void test_SWR_SPI_006_cards_that_do_not_fit_the_cycle_are_refused_with_the_clock_needed(void)
{
    assert_refused("spidev:/dev/spidev1.0,slots=0-9,clock=5000000;" LINES,
                   "The cards on the bus of /dev/spidev1.0 take 4216 us of a cycle, and have 600 "
                   "us; give clock=42700000 or more, or spread them over more buses.");
    open_board("spidev:/dev/spidev1.0,slots=0-9,clock=42700000;" LINES);
    bsp_close();
    is_board_open = false;
    assert_refused("spidev:/dev/spidev1.0,slots=0-9,clock=42600000;" LINES,
                   "The cards on the bus of /dev/spidev1.0 take 601 us of a cycle, and have 600 "
                   "us; give clock=42700000 or more, or spread them over more buses.");
}

void test_SWR_SPI_006_devices_of_one_bus_take_turns(void)
{
    assert_refused("spidev:/dev/spidev1.0,slots=0,clock=5000000;"
                   "spidev:/dev/spidev1.1,slots=1,clock=5000000;" LINES,
                   "The cards on the bus of /dev/spidev1.0 take 880 us of a cycle, and have 600 "
                   "us; give clock=7600000 or more, or spread them over more buses.");
    open_board("spidev:/dev/spidev1.0,slots=1,clock=5000000;"
               "spidev:/dev/spidev2.0,slots=5,clock=5000000;" LINES);
}

void test_SWR_SPI_006_pauses_that_no_clock_makes_up_for_are_refused(void)
{
    assert_refused("spidev:/dev/spidev1.0,slots=0-9,clock=100000000,gap=50;" LINES,
                   "The cards on the bus of /dev/spidev1.0 take 905 us of a cycle, and have 600 "
                   "us; spread them over more buses, as no clock is fast enough.");
}

void test_SWR_GPIO_004_lines_that_are_not_there_are_refused(void)
{
    assert_refused(ONE_BUS "gpio:/dev/gpiochip9,pedal_a=0,pedal_b=1,estop=2,scanner=3,power=8",
                   "The GPIO chip /dev/gpiochip9 cannot be opened (No such file or directory); "
                   "check the device tree and the rights of this user.");
}
