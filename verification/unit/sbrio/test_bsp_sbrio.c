/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: the board exchanges frames with the firmware of real cards behind the kernel's
 * SPI, and no process waits for it.
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

#define NS_PER_US UINT64_C(1000)

void setUp(void)
{
    begin_board();
}

void tearDown(void)
{
    end_board();
}

static void assert_results(uint32_t slots, bsp_slot_result_t expected)
{
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        const bsp_slot_result_t one = ((slots & (1U << slot)) != 0U) ? expected : BSP_SLOT_NOT_SENT;
        TEST_ASSERT_EQUAL_UINT8(one, result.results[slot]);
    }
}

/* Each card that is there has heard `sequence`. */
static void assert_heard(uint32_t sequence)
{
    for (uint32_t slot = 1U; slot <= 7U; slot++) {
        card_report_t report;
        TEST_ASSERT_EQUAL(CARD_FRAME_OK, card_frame_decode_report(received[slot], slot, &report));
        TEST_ASSERT_EQUAL_UINT32(sequence, report.accepted_sequence);
    }
}

/* One after the other, as they go over the wire. */
static void expect_times(uint64_t least_ns)
{
    uint64_t before_ns = result.started_ns;
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        if (((result.received >> slot) & 1U) != 0U) {
            TEST_ASSERT_TRUE(result.sampled_ns[slot] >= (before_ns + least_ns));
            before_ns = result.sampled_ns[slot];
        } else {
            TEST_ASSERT_EQUAL_UINT64(0U, result.sampled_ns[slot]);
        }
    }
}

void test_SWR_BSP_007_each_report_has_the_time_of_its_chip_select(void)
{
    open_board(ONE_BUS LINES);
    TEST_ASSERT_EQUAL_UINT32(LIMIT_SAMPLE_ERROR_SPI_US, identity.sample_error_us);
    exchange(1U);
    TEST_ASSERT_EQUAL_HEX32(OUR_SLOTS, result.received);
    expect_times(1U);
}

void test_SWR_BSP_007_with_a_gap_each_frame_has_its_own_time(void)
{
    open_board("spidev:/dev/spidev1.0,slots=0-4,clock=100000000,gap=1;" LINES);
    exchange(1U);
    TEST_ASSERT_NOT_EQUAL_HEX32(0U, result.received);
    expect_times(0U);
}

void test_SWR_SPI_003_frames_of_all_slots_are_exchanged_in_one_message(void)
{
    open_board(ONE_BUS LINES);
    exchange(1U);
    TEST_ASSERT_EQUAL_HEX32(OUR_SLOTS, result.received);
    exchange(2U);
    assert_results(OUR_SLOTS, BSP_SLOT_OK);
    assert_heard(1U);
    TEST_ASSERT_EQUAL_UINT(2U, spi_world_devices[0].messages);
    TEST_ASSERT_EQUAL_UINT(20U, spi_world_devices[0].frames);
    TEST_ASSERT_EQUAL_INT(0, result.error);
    TEST_ASSERT_TRUE((result.started_ns != 0U) && (result.finished_ns > result.started_ns));
}

void test_SWR_SPI_003_with_a_gap_each_frame_has_a_message_of_its_own(void)
{
    spi_world_wrong.needs_gap = true;
    open_board("spidev:/dev/spidev1.0,slots=1-7,clock=90000000,gap=10;slow:100;" LINES);
    spi_world_devices[0].first_slot = 1U;
    spi_world_devices[0].slot_count = 7U;
    exchange(1U);
    exchange(2U);
    assert_heard(1U);
    TEST_ASSERT_EQUAL_UINT(14U, spi_world_devices[0].messages);
}

void test_SWR_SPI_003_two_buses_work_at_once(void)
{
    open_board("spidev:/dev/spidev1.0,slots=0-4,clock=50000000;"
               "spidev:/dev/spidev2.0,slots=5-9,clock=50000000;" LINES);
    exchange(1U);
    exchange(2U);
    assert_results(OUR_SLOTS, BSP_SLOT_OK);
    assert_heard(1U);
    TEST_ASSERT_EQUAL_UINT(10U, spi_world_devices[0].frames);
    TEST_ASSERT_EQUAL_UINT(10U, spi_world_devices[1].frames);
}

void test_SWR_SPI_003_two_devices_of_a_bus_take_turns(void)
{
    open_board("spidev:/dev/spidev1.0,slots=0-4,clock=100000000;"
               "spidev:/dev/spidev1.1,slots=5-9,clock=100000000;" LINES);
    exchange(1U);
    exchange(2U);
    assert_results(OUR_SLOTS, BSP_SLOT_OK);
    assert_heard(1U);
    TEST_ASSERT_EQUAL_UINT(10U, spi_world_devices[2].frames);
}

void test_SWR_SPI_003_a_bus_whose_slots_are_not_sent_rests(void)
{
    open_board("spidev:/dev/spidev1.0,slots=0-4,clock=50000000;"
               "spidev:/dev/spidev2.0,slots=5-9,clock=50000000;" LINES);
    write_frames(1U);
    start(0x2U);
    finish(1000U);
    assert_results(0x2U, BSP_SLOT_OK);
    TEST_ASSERT_TRUE(spi_world_cards[1].has_sequence);
    TEST_ASSERT_FALSE(spi_world_cards[2].has_sequence);
    TEST_ASSERT_EQUAL_UINT(0U, spi_world_devices[1].frames);
}

void test_SWR_SPI_004_who_finishes_twice_or_without_a_start_has_sent_nothing(void)
{
    open_board(ONE_BUS LINES);
    finish(0U);
    assert_results(0U, BSP_SLOT_NOT_SENT);
    TEST_ASSERT_EQUAL_UINT64(0U, result.started_ns);
    TEST_ASSERT_EQUAL_UINT64(0U, result.finished_ns);
    exchange(1U);
    finish(0U);
    assert_results(0U, BSP_SLOT_NOT_SENT);
    TEST_ASSERT_EQUAL_HEX32(0U, result.received);
}

void test_SWR_SPI_004_a_transfer_that_hangs_is_late_and_then_not_idle(void)
{
    open_board(ONE_BUS LINES);
    spi_world_wrong.hangs = true;
    write_frames(1U);
    const uint64_t before_ns = bsp_now_ns();
    start(OUR_SLOTS);
    const uint64_t after_ns = bsp_now_ns();
    finish(20U);
    assert_results(OUR_SLOTS, BSP_SLOT_LATE);
    TEST_ASSERT_TRUE((after_ns - before_ns) < (bsp_now_ns() - after_ns));
    start(OUR_SLOTS);
    finish(5U);
    assert_results(OUR_SLOTS, BSP_SLOT_NOT_IDLE);
    TEST_ASSERT_EQUAL_HEX32(0U, result.received);
    spi_world_wrong.hangs = false;
    (void)sem_post(&spi_world_released);
    finish(1000U);
    assert_results(0U, BSP_SLOT_NOT_SENT);
    TEST_ASSERT_EACH_EQUAL_UINT8(0xEEU, received, sizeof received);
    exchange(2U);
    assert_heard(1U);
}

void test_SWR_SPI_004_late_answers_are_not_those_of_a_later_exchange(void)
{
    open_board(ONE_BUS LINES);
    spi_world_wrong.hangs = true;
    write_frames(1U);
    start(OUR_SLOTS);
    finish(1U);
    start(OUR_SLOTS);
    spi_world_wrong.hangs = false;
    (void)sem_post(&spi_world_released);
    finish(1000U);
    assert_results(OUR_SLOTS, BSP_SLOT_NOT_IDLE);
    TEST_ASSERT_EACH_EQUAL_UINT8(0xEEU, received, sizeof received);
}

/* As control does when it has crashed, here while it waits for a transfer that hangs. */
static void crash(int signal_number)
{
    (void)signal_number;
    bsp_drives_off();
    finish(1U);
    start(OUR_SLOTS);
    finish(1U);
    assert_results(OUR_SLOTS, BSP_SLOT_NOT_IDLE);
    spi_world_wrong.hangs = false;
    (void)sem_post(&spi_world_released);
    finish(1000U);
    exchange(2U);
    assert_results(OUR_SLOTS, BSP_SLOT_OK);
}

void test_SWR_SPI_004_a_signal_handler_starts_and_finishes_whatever_it_interrupts(void)
{
    const struct itimerval soon = {.it_value = {.tv_usec = 20000}};
    open_board(ONE_BUS LINES PATIENT);
    TEST_ASSERT_TRUE_MESSAGE(bsp_self_test(error, sizeof error), error);
    TEST_ASSERT_EQUAL_INT(1, POWER);
    (void)signal(SIGALRM, crash);
    spi_world_wrong.hangs = true;
    write_frames(1U);
    start(OUR_SLOTS);
    (void)setitimer(ITIMER_REAL, &soon, NULL);
    finish(10000U);
    (void)signal(SIGALRM, SIG_DFL);
    assert_heard(1U);
    TEST_ASSERT_EQUAL_INT(0, POWER);
}

void test_SWR_SPI_004_a_bus_without_the_right_to_a_priority_works_all_the_same(void)
{
    static spi_bus_t bus;
    wiring_t wired;
    TEST_ASSERT_TRUE(wiring_read(&wired, ONE_BUS LINES, error, sizeof error));
    TEST_ASSERT_TRUE_MESSAGE(spi_bus_open(&bus, &wired, 1U, -1, error, sizeof error), error);
    write_frames(1U);
    TEST_ASSERT_TRUE(
        spi_bus_start(&bus, OUR_SLOTS, (const uint8_t(*)[CARD_FRAME_BYTES])frames, 0U));
    TEST_ASSERT_TRUE(spi_bus_await(&bus, spi_bus_now_ns() + (1000U * NS_PER_MS)));
    TEST_ASSERT_EQUAL_INT32(0, spi_bus_error(&bus, 1U));
    spi_bus_close(&bus);
}

static uint32_t count_threads(void)
{
    DIR *const tasks = opendir("/proc/self/task");
    uint32_t count = 0U;
    while (readdir(tasks) != NULL) {
        count++;
    }
    (void)closedir(tasks);
    return count;
}

void test_SWR_SPI_004_closing_does_not_wait_for_a_transfer_that_hangs(void)
{
    open_board(ONE_BUS LINES);
    spi_world_wrong.hangs = true;
    write_frames(1U);
    start(OUR_SLOTS);
    finish(1U);
    bsp_close();
    is_board_open = false;
    const uint32_t threads = count_threads();
    spi_world_wrong.hangs = false;
    (void)sem_post(&spi_world_released);
    const uint64_t until_ns = spi_bus_now_ns() + (60000U * NS_PER_MS);
    while ((count_threads() == threads) && (spi_bus_now_ns() < until_ns)) {
        (void)usleep(1000U);
    }
    TEST_ASSERT_EQUAL_UINT32(threads - 1U, count_threads()); /* That of the bus has ended. */
}

void test_SWR_SPI_007_a_transfer_that_fails_reports_the_error(void)
{
    open_board(ONE_BUS LINES);
    spi_world_wrong.error = ETIMEDOUT;
    exchange(1U);
    assert_results(OUR_SLOTS, BSP_SLOT_BUS_ERROR);
    TEST_ASSERT_EQUAL_INT32(ETIMEDOUT, result.error);
    TEST_ASSERT_EQUAL_HEX32(0U, result.received);
    spi_world_wrong.error = -1;
    exchange(1U);
    assert_results(OUR_SLOTS, BSP_SLOT_BUS_ERROR);
    TEST_ASSERT_EQUAL_INT32(EIO, result.error);
    spi_world_wrong.error = 0;
    exchange(2U);
    assert_results(OUR_SLOTS, BSP_SLOT_OK);
    TEST_ASSERT_EQUAL_INT32(0, result.error);
}

void test_SWR_SPI_007_with_a_gap_the_rest_of_a_failed_exchange_is_left_out(void)
{
    open_board("spidev:/dev/spidev1.0,slots=0-4,clock=100000000,gap=1;" LINES);
    spi_world_wrong.error = EIO;
    write_frames(1U);
    start(0x1FU);
    finish(1000U);
    assert_results(0x1FU, BSP_SLOT_BUS_ERROR);
}

void test_SWR_SPI_007_a_slot_without_a_card_does_not_answer(void)
{
    open_board(ONE_BUS LINES);
    write_frames(1U);
    start(CARD_EVERY_SLOT);
    finish(1000U);
    TEST_ASSERT_EQUAL_HEX32(OUR_SLOTS, result.received);
    TEST_ASSERT_EQUAL_UINT8(BSP_SLOT_NO_ANSWER, result.results[0]);
    TEST_ASSERT_EQUAL_UINT8(BSP_SLOT_OK, result.results[1]);
    TEST_ASSERT_EQUAL_UINT8(BSP_SLOT_NO_ANSWER, result.results[9]);
    TEST_ASSERT_EACH_EQUAL_UINT8(0xEEU, received[0], CARD_FRAME_BYTES);
}

void test_SWR_SPI_007_a_slot_behind_no_device_is_not_sent(void)
{
    open_board("spidev:/dev/spidev1.0,slots=0-4,clock=100000000;" LINES);
    write_frames(1U);
    start(CARD_EVERY_SLOT);
    finish(1000U);
    TEST_ASSERT_EQUAL_UINT8(BSP_SLOT_OK, result.results[4]);
    TEST_ASSERT_EQUAL_UINT8(BSP_SLOT_NOT_SENT, result.results[5]);
}

void test_SWR_SPI_011_after_a_failed_exchange_the_bus_rests(void)
{
    open_board(ONE_BUS LINES);
    spi_world_wrong.error = EIO;
    exchange(1U);
    const uint64_t failed_ns = result.finished_ns;
    spi_world_wrong.error = 0;
    exchange(2U);
    assert_results(OUR_SLOTS, BSP_SLOT_OK);
    TEST_ASSERT_TRUE((result.finished_ns - failed_ns) >= (NS_PER_US * LIMIT_SPI_REST_US));
}

void test_SWR_SPI_011_after_a_long_exchange_the_bus_rests(void)
{
    open_board(ONE_BUS LINES);
    spi_world_wrong.hangs = true;
    write_frames(1U);
    start(OUR_SLOTS);
    finish(5U);
    spi_world_wrong.hangs = false;
    (void)sem_post(&spi_world_released);
    finish(1000U);
    const uint64_t late_ns = buses.buses[0].finished_ns;
    exchange(2U);
    assert_results(OUR_SLOTS, BSP_SLOT_OK);
    TEST_ASSERT_TRUE((result.finished_ns - late_ns) >= (NS_PER_US * LIMIT_SPI_REST_US));
}

void test_SWR_SPI_011_after_opening_the_bus_rests(void)
{
    static spi_bus_t bus;
    wiring_t wired;
    TEST_ASSERT_TRUE(wiring_read(&wired, ONE_BUS LINES, error, sizeof error));
    const uint64_t before_ns = spi_bus_now_ns();
    TEST_ASSERT_TRUE_MESSAGE(spi_bus_open(&bus, &wired, 1U, 1, error, sizeof error), error);
    TEST_ASSERT_TRUE(bus.needs_rest);
    TEST_ASSERT_TRUE(bus.finished_ns >= before_ns);
    spi_bus_close(&bus);
}

void test_SWR_GPIO_001_inputs_are_those_of_the_lines(void)
{
    bsp_inputs_t inputs;
    open_board(ONE_BUS LINES);
    gpio_world[0].lines[2].value = 1;
    gpio_world[0].lines[3].value = 1;
    gpio_world[0].lines[3].edges = 2;
    bsp_sample_inputs(&inputs);
    TEST_ASSERT_EQUAL_HEX32(BSP_IN_ESTOP_CHAIN | BSP_IN_SCANNER_IDLE, inputs.levels);
    TEST_ASSERT_EQUAL_HEX32(BSP_IN_PEDAL_A | BSP_IN_PEDAL_B | BSP_IN_SCANNER_IDLE, inputs.dropped);
    TEST_ASSERT_EQUAL_HEX32(0xFU, inputs.valid);
    TEST_ASSERT_TRUE((inputs.sampled_ns != 0U) && (inputs.sampled_ns <= bsp_now_ns()));
}

void test_SWR_GPIO_006_lamps_are_shown(void)
{
    open_board(ONE_BUS LINES);
    bsp_set_lamps(BSP_LAMP_ALIVE);
    TEST_ASSERT_EQUAL_INT(1, gpio_world[0].lines[9].value);
}

void test_SWR_STORE_001_a_box_that_does_not_know_its_power_on_is_another_one_each_time(void)
{
    open_board(ONE_BUS LINES);
    const uint32_t first = identity.power_on;
    TEST_ASSERT_EQUAL_STRING("sbrio", identity.board);
    TEST_ASSERT_TRUE(identity.was_used);
    TEST_ASSERT_FALSE(identity.is_elastic);
    TEST_ASSERT_EQUAL_UINT32(1U, identity.slowness);
    TEST_ASSERT_EQUAL_UINT32(1U, identity.speedup);
    TEST_ASSERT_EQUAL_UINT32(BSP_HAS_EDGE_LATCH | BSP_HAS_DRIVES_OFF | BSP_HAS_LAMPS,
                             identity.abilities);
    bsp_close();
    open_board(ONE_BUS LINES);
    TEST_ASSERT_NOT_EQUAL_UINT32(0U, first);
    TEST_ASSERT_NOT_EQUAL_UINT32(first, identity.power_on);
}

void test_SWR_SPI_001_time_passes_as_slowly_as_the_wiring_says(void)
{
    open_board(ONE_BUS LINES ";slow:10");
    TEST_ASSERT_EQUAL_UINT32(10U, identity.slowness);
    const unsigned long long before_ns = spi_world_now_ns();
    const uint64_t before_slow_ns = bsp_now_ns();
    bsp_sleep_until_ns(before_slow_ns + NS_PER_MS);
    const unsigned long long passed_ns = spi_world_now_ns() - before_ns;
    TEST_ASSERT_TRUE(passed_ns >= (9U * NS_PER_MS));
    TEST_ASSERT_TRUE((bsp_reached_ns() - before_slow_ns) >= NS_PER_MS);
    exchange(1U);
    assert_results(OUR_SLOTS, BSP_SLOT_OK);
    TEST_ASSERT_TRUE(result.finished_ns <= bsp_now_ns());
}
