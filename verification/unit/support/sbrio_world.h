/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The board sbRIO in a test, with the firmware of simulated cards behind the kernel's SPI.
 */
#ifndef BORESIGHT_SBRIO_WORLD_H
#define BORESIGHT_SBRIO_WORLD_H

#include "unity.h"
#include "bsp.h"
#include "card/card_frame.h"
#include "robot/robot_neuro.h"
#include "sbrio/bsp_sbrio.c"
#include "sbrio/bus_check.h"
#include "sbrio/card_buses.h"
#include "sbrio/spi_bus.h"
#include "sbrio/spi_device.h"
#include "sbrio/wiring.h"
#include "sim/model/sim_card.h"
#include "unit/support/gpio_world.h"
#include "unit/support/spi_world.h"

#include <dirent.h>
#include <signal.h>
#include <sys/time.h>

#define LINES "gpio:/dev/gpiochip0,pedal_a=0,pedal_b=1,estop=2,scanner=3,power=8,lamp_alive=9"
#define ONE_BUS "spidev:/dev/spidev1.0,slots=0-9,clock=100000000;"

/* Time for the self test, however busy this machine is. */
#define PATIENT ";slow:20"

#define OUR_SLOTS 0xFEU /* Slots of the present cards. */
#define POWER (gpio_world[0].lines[8].value)
#define NS_PER_MS UINT64_C(1000000)

static bsp_identity_t identity;
static bool is_board_open;
static uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES];
static uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES];
static bsp_exchange_t result;
static char error[256];

static void begin_board(void)
{
    gpio_world_init();
    spi_world_init(&robot_neuro);
    (void)memset(received, 0xEE, sizeof received);
    is_board_open = false;
    error[0] = '\0';
}

static void end_board(void)
{
    if (is_board_open) {
        bsp_close();
    }
    TEST_ASSERT_EQUAL_INT(0, POWER);
    spi_world_end();
}

static void open_board(const char *address)
{
    is_board_open = bsp_open(address, &identity, error, sizeof error);
    TEST_ASSERT_TRUE_MESSAGE(is_board_open, error);
}

static void write_frames(uint32_t sequence)
{
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        const card_command_t command = {.slot = slot,
                                        .sequence = sequence,
                                        .control = CARD_CONTROL_CLEAR_FAULT,
                                        .axis_id = CARD_NO_AXIS};
        card_frame_encode_command(&command, frames[slot]);
    }
}

static void start(uint32_t send)
{
    bsp_start(send, (const uint8_t(*)[CARD_FRAME_BYTES])frames);
}

static void finish(uint64_t patience_ms)
{
    bsp_finish(bsp_now_ns() + (patience_ms * NS_PER_MS), received, &result);
}

static void exchange(uint32_t sequence)
{
    write_frames(sequence);
    start(OUR_SLOTS);
    finish(1000U);
}

#endif
