/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: a wiring is taken as it is written, from a text or a file, and a wrong one is
 * refused with line, word and reason.
 */
#include "unity.h"

#include "sbrio/wiring.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Ends a test that would wait for ever. */
#define GIVE_UP_S 30U

#define GOOD                                                                                       \
    "spidev: /dev/spidev1.0, slots=0-9, clock=50000000\n"                                          \
    "gpio: /dev/gpiochip0, pedal_a=0, pedal_b=1, estop=2, scanner=3, power=8\n"

static wiring_t wiring;
static char error[256];

void setUp(void)
{
    error[0] = '\0';
}

void tearDown(void)
{
}

static void assert_taken(const char *text)
{
    TEST_ASSERT_TRUE_MESSAGE(wiring_read(&wiring, text, error, sizeof error), error);
}

static void assert_refused(const char *text, const char *sentence)
{
    TEST_ASSERT_FALSE_MESSAGE(wiring_read(&wiring, text, error, sizeof error), text);
    TEST_ASSERT_EQUAL_STRING(sentence, error);
}

/* Error in the second line, after a first one that is good. */
static void assert_wrong(const char *statement, const char *reason)
{
    char text[512];
    char sentence[512];
    (void)snprintf(text, sizeof text, "gpio: /dev/gpiochip7, confirm=5\n%s", statement);
    (void)snprintf(sentence, sizeof sentence, "The wiring is wrong in line 2: %s.", reason);
    assert_refused(text, sentence);
}

static void assert_line(wiring_line_name_t name, uint32_t chip, uint32_t offset, bool is_active_low)
{
    TEST_ASSERT_TRUE(wiring.lines[name].is_there);
    TEST_ASSERT_EQUAL_UINT32(chip, wiring.lines[name].chip);
    TEST_ASSERT_EQUAL_UINT32(offset, wiring.lines[name].offset);
    TEST_ASSERT_EQUAL(is_active_low, wiring.lines[name].is_active_low);
}

void test_SWR_SPI_001_a_wiring_is_taken_as_it_is_written(void)
{
    assert_taken("# the box of room 3\n\n" GOOD "watchdog: /dev/watchdog\n");
    TEST_ASSERT_EQUAL_UINT32(1U, wiring.spi_count);
    TEST_ASSERT_EQUAL_STRING("/dev/spidev1.0", wiring.spi[0].path);
    TEST_ASSERT_EQUAL_UINT32(1U, wiring.spi[0].bus);
    TEST_ASSERT_EQUAL_UINT32(0U, wiring.spi[0].first_slot);
    TEST_ASSERT_EQUAL_UINT32(10U, wiring.spi[0].slot_count);
    TEST_ASSERT_EQUAL_UINT32(50000000U, wiring.spi[0].clock_hz);
    TEST_ASSERT_EQUAL_UINT32(0U, wiring.spi[0].mode);
    TEST_ASSERT_EQUAL_UINT32(0U, wiring.spi[0].gap_us);
    TEST_ASSERT_EQUAL_STRING("/dev/gpiochip0", wiring.chips[0]);
    TEST_ASSERT_FALSE(wiring.are_pulled[0]);
    assert_line(WIRING_PEDAL_A, 0U, 0U, false);
    assert_line(WIRING_POWER, 0U, 8U, false);
    TEST_ASSERT_FALSE(wiring.lines[WIRING_CONFIRM].is_there);
    TEST_ASSERT_EQUAL_STRING("/dev/watchdog", wiring.watchdog);
    TEST_ASSERT_EQUAL_UINT32(5U, wiring.watchdog_s);
    TEST_ASSERT_EQUAL_UINT32(1U, wiring.slowness);
}

void test_SWR_SPI_001_everything_can_be_said_in_one_line(void)
{
    assert_taken("spidev:/dev/spidev1.0,slots=1,clock=5000000,mode=3,gap=20;"
                 "spidev:/dev/spidev2.1,slots=2-4,clock=9000000;spidev:/dev/card,slots=6,clock=1;"
                 "gpio:/dev/gpiochip0,pull,pedal_a=!0,pedal_b=1,estop=2,scanner=3,lamp_fault=!9;"
                 "gpio:/dev/gpiochip1,power=1023,confirm=0,dose=1,treatment=2,lamp_alive=3,"
                 "lamp_may_move=4,lamp_moving=5;watchdog:/dev/watchdog1,timeout=60;slow:100 # dry");
    TEST_ASSERT_EQUAL_UINT32(3U, wiring.spi_count);
    TEST_ASSERT_EQUAL_UINT32(3U, wiring.spi[0].mode);
    TEST_ASSERT_EQUAL_UINT32(20U, wiring.spi[0].gap_us);
    TEST_ASSERT_EQUAL_UINT32(2U, wiring.spi[1].bus);
    TEST_ASSERT_EQUAL_UINT32(2U, wiring.spi[1].first_slot);
    TEST_ASSERT_EQUAL_UINT32(3U, wiring.spi[1].slot_count);
    TEST_ASSERT_NOT_EQUAL_UINT32(wiring.spi[0].bus, wiring.spi[2].bus);
    TEST_ASSERT_TRUE(wiring.are_pulled[0]);
    TEST_ASSERT_FALSE(wiring.are_pulled[1]);
    assert_line(WIRING_PEDAL_A, 0U, 0U, true);
    assert_line(WIRING_LAMPS + 3, 0U, 9U, true);
    assert_line(WIRING_POWER, 1U, 1023U, false);
    assert_line(WIRING_CONFIRM, 1U, 0U, false);
    assert_line(WIRING_DOSE, 1U, 1U, false);
    assert_line(WIRING_TREATMENT, 1U, 2U, false);
    assert_line(WIRING_LAMPS, 1U, 3U, false);
    assert_line(WIRING_LAMPS + 1, 1U, 4U, false);
    assert_line(WIRING_LAMPS + 2, 1U, 5U, false);
    TEST_ASSERT_EQUAL_UINT32(60U, wiring.watchdog_s);
    TEST_ASSERT_EQUAL_UINT32(100U, wiring.slowness);
}

void test_SWR_SPI_001_an_address_with_a_slash_first_is_a_file(void)
{
    char path[64];
    (void)snprintf(path, sizeof path, "/tmp/boresight-wiring-%d", (int)getpid());
    FILE *const file = fopen(path, "w");
    TEST_ASSERT_NOT_NULL(file);
    (void)fputs(GOOD, file);
    (void)fclose(file);
    const bool is_taken = wiring_read(&wiring, path, error, sizeof error);
    (void)unlink(path);
    TEST_ASSERT_TRUE_MESSAGE(is_taken, error);
    TEST_ASSERT_EQUAL_STRING("/dev/spidev1.0", wiring.spi[0].path);
}

void test_SWR_SPI_002_a_file_that_cannot_be_read_is_named(void)
{
    assert_refused("/nowhere", "The wiring \"/nowhere\" cannot be read (No such file or "
                               "directory); write the file, or name another one.");
    assert_refused("/tmp", "The wiring \"/tmp\" cannot be read; it must be a text of less than "
                           "4096 bytes.");
    assert_refused("/dev/zero", "The wiring \"/dev/zero\" cannot be read; it must be a text of "
                                "less than 4096 bytes.");
}

void test_SWR_NI_020_what_is_no_regular_file_is_refused_without_waiting(void)
{
    char path[64];
    char expected[256];
    (void)snprintf(path, sizeof path, "/tmp/boresight-wiring-%d", (int)getpid());
    (void)snprintf(expected, sizeof expected,
                   "The wiring \"%s\" cannot be read; it must be a text of less than 4096 bytes.",
                   path);
    TEST_ASSERT_EQUAL_INT(0, mkfifo(path, 0600));
    (void)alarm(GIVE_UP_S);
    const bool is_taken = wiring_read(&wiring, path, error, sizeof error);
    (void)alarm(0U);
    (void)unlink(path);
    TEST_ASSERT_FALSE(is_taken);
    TEST_ASSERT_EQUAL_STRING(expected, error);
}

void test_SWR_SPI_002_a_text_that_is_too_long_is_refused(void)
{
    static char text[5000];
    (void)memset(text, '#', sizeof text - 1U);
    assert_refused(text, "The wiring is too long; write it into a file.");
}

void test_SWR_SPI_002_what_every_box_has_must_be_there(void)
{
    assert_refused("", "The wiring has no card; add \"spidev: ...\".");
    assert_refused("spidev: /dev/spidev1.0, slots=3, clock=5000000",
                   "The wiring lacks the line \"pedal_a\"; add it to \"gpio: ...\".");
    assert_refused("spidev: /dev/spidev1.0, slots=3, clock=5000000; gpio: /dev/gpiochip0, "
                   "pedal_a=1, pedal_b=2, estop=3, scanner=4",
                   "The wiring lacks the line \"power\"; add it to \"gpio: ...\".");
}

void test_SWR_SPI_002_a_statement_that_is_none_is_refused(void)
{
    assert_wrong("hello", "\"hello\" is no statement; expected spidev: ..., gpio: ... or "
                          "watchdog: ...");
    assert_wrong("i2c: /dev/i2c-0", "\"i2c\" is unknown; expected spidev, gpio, watchdog or slow");
    assert_wrong("slow: 0", "\"0\" is no slowness; expected 1, or 10 to 100");
    assert_wrong("slow: 101", "\"101\" is no slowness; expected 1, or 10 to 100");
}

/* One of two clocks is not known to be the right one. */
void test_SWR_SPI_002_what_is_said_twice_is_refused(void)
{
    assert_wrong("spidev: /dev/a, clock=9, slots=1, clock=8", "\"clock\" is said twice");
    assert_wrong("spidev: /dev/a, mode=0, slots=1, mode=0", "\"mode\" is said twice");
    assert_wrong("spidev: /dev/a, slots=1, slots=2", "\"slots\" is said twice");
    assert_wrong("spidev: /dev/a, gap=1, gap=2", "\"gap\" is said twice");
    assert_wrong("watchdog: /dev/v; watchdog: /dev/w", "\"watchdog\" is said twice");
    assert_wrong("watchdog: /dev/w; watchdog: /dev/w", "\"watchdog\" is said twice");
    assert_wrong("slow: 1; slow: 100", "\"slow\" is said twice");
}

void test_SWR_SPI_012_a_slowness_at_which_real_cards_would_drive_is_refused(void)
{
    for (uint32_t slowness = 2U; slowness < 10U; slowness++) {
        char text[32];
        char reason[64];
        (void)snprintf(text, sizeof text, "slow: %u", (unsigned)slowness);
        (void)snprintf(reason, sizeof reason, "\"%u\" is no slowness; expected 1, or 10 to 100",
                       (unsigned)slowness);
        assert_wrong(text, reason);
    }
    assert_taken(GOOD "slow: 10");
    TEST_ASSERT_EQUAL_UINT32(10U, wiring.slowness);
    assert_taken(GOOD "slow: 1");
    TEST_ASSERT_EQUAL_UINT32(1U, wiring.slowness);
    assert_taken(GOOD);
    TEST_ASSERT_EQUAL_UINT32(1U, wiring.slowness);
}

void test_SWR_SPI_002_a_wrong_spi_device_is_refused(void)
{
    assert_wrong("spidev: spidev1.0",
                 "\"spidev1.0\" is no device; give its path, such as /dev/...");
    assert_wrong("spidev: /dev/a-name-that-is-longer-than-any-that-a-device-of-the-kernel-ever-had",
                 "\"/dev/a-name-that-is-longer-than-any-that-a-device-of-the-kernel-ever-had\" is "
                 "too long for a path");
    assert_wrong("spidev: /dev/a", "\"/dev/a\" needs slots=... and clock=...");
    assert_wrong("spidev: /dev/a, slots=1", "\"/dev/a\" needs slots=... and clock=...");
    assert_wrong("spidev: /dev/a, slots", "\"slots\" lacks its \"=\" and a value");
    assert_wrong("spidev: /dev/a, speed=3",
                 "\"speed\" is unknown here; expected slots, clock, mode or gap");
    assert_wrong("spidev: /dev/a, mode=4", "\"mode\" needs 0, 1, 2 or 3");
    assert_wrong("spidev: /dev/a, gap=101", "\"gap\" needs a time in us, 1 to 100");
    assert_wrong("spidev: /dev/a, clock=0", "\"clock\" needs a clock in Hz, 1 to 100000000");
    assert_wrong("spidev: /dev/a, clock=5MHz", "\"clock\" needs a clock in Hz, 1 to 100000000");
    assert_wrong("spidev: /dev/a, clock=99999999999999999999",
                 "\"clock\" needs a clock in Hz, 1 to 100000000");
}

void test_SWR_SPI_002_slots_that_no_box_has_are_refused(void)
{
    static const char *const wrong[] = {"10", "x", "", "3-2", "0-10", "-3", "1-", "1-x"};
    for (uint32_t i = 0U; i < sizeof wrong / sizeof wrong[0]; i++) {
        char text[64];
        (void)snprintf(text, sizeof text, "spidev: /dev/a, slots=%s", wrong[i]);
        assert_wrong(text, "\"slots\" needs a slot or a range of them, such as 3 or 0-9");
    }
    assert_wrong("spidev: /dev/a, slots=1-3, clock=9; spidev: /dev/b, slots=3, clock=9",
                 "\"/dev/b\" has a slot that another device has, too");
}

void test_SWR_SPI_002_a_wrong_line_is_refused(void)
{
    assert_wrong("gpio: gpiochip0", "\"gpiochip0\" is no device; give its path, such as /dev/...");
    assert_wrong("gpio: /dev/g, brake=1", "\"brake\" is no line of a box");
    assert_wrong("gpio: /dev/g, estop", "\"estop\" lacks its \"=\" and a line");
    assert_wrong("gpio: /dev/g, estop=x",
                 "\"estop\" needs the number of a line, such as 4, or !4 for a contact to ground");
    assert_wrong("gpio: /dev/g, estop=1024",
                 "\"estop\" needs the number of a line, such as 4, or !4 for a contact to ground");
    assert_wrong("gpio: /dev/g, confirm=1", "\"confirm\" is said twice");
    assert_wrong("gpio: /dev/g, estop=4, scanner=4",
                 "\"scanner\" has the line that another one has");
    assert_wrong("gpio: /dev/gpiochip7, estop=4",
                 "\"/dev/gpiochip7\" is said twice; give all its lines at once");
    assert_wrong("gpio: /dev/a; gpio: /dev/b; gpio: /dev/c; gpio: /dev/d",
                 "\"/dev/d\" is one chip too many; 4 are possible");
}

void test_SWR_SPI_002_power_that_a_cut_wire_gives_is_refused(void)
{
    assert_wrong("gpio: /dev/g, power=!4",
                 "\"power\" cannot be active low: a cut wire must take the power of the drives");
}

void test_SWR_SPI_002_a_wrong_watchdog_is_refused(void)
{
    assert_wrong("watchdog: rex", "\"rex\" is no device; give its path, such as /dev/...");
    assert_wrong("watchdog: /dev/w, bite=5",
                 "\"bite\" is unknown here; expected timeout=1 to timeout=60, in s");
    assert_wrong("watchdog: /dev/w, timeout",
                 "\"timeout\" is unknown here; expected timeout=1 to timeout=60, in s");
    assert_wrong("watchdog: /dev/w, timeout=61",
                 "\"timeout\" is unknown here; expected timeout=1 to timeout=60, in s");
}
