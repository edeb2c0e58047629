/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The board support of a control box behind Linux' own SPI and GPIO: cards by spidev, digital lines
 * by libgpiod 1.6.
 */
#include "bsp.h"

#include "limits/requirement_limits.h"
#include "sbrio/card_buses.h"
#include "sbrio/kernel_watchdog.h"
#include "sbrio/pins.h"
#include "sbrio/wire_test.h"
#include "sbrio/wiring.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <sys/random.h>
#include <time.h>

#define NS_PER_S UINT64_C(1000000000)

static wiring_t wiring;
static card_buses_t buses;
static pins_t pins;
static kernel_watchdog_t watchdog;
static uint32_t slowness = 1U;
static volatile sig_atomic_t is_open;
static volatile sig_atomic_t is_cut; /* The power of the drives, until the board is opened again. */

/* The time at which the box was switched on is unknown: no axis is where it was believed to be. */
static void identify(bsp_identity_t *identity)
{
    const uint32_t watchdog_ability = (wiring.watchdog[0] != '\0') ? BSP_HAS_WATCHDOG : 0U;
    uint32_t number = 0U;

    (void)!getrandom(&number, sizeof number, 0U);
    *identity = (bsp_identity_t){.board = "sbrio",
                                 .abilities = BSP_HAS_EDGE_LATCH | BSP_HAS_DRIVES_OFF |
                                              BSP_HAS_LAMPS | watchdog_ability,
                                 .power_on = number | 1U,
                                 .was_used = true,
                                 .slowness = slowness,
                                 .speedup = 1U,
                                 .sample_error_us = LIMIT_SAMPLE_ERROR_SPI_US};
}

bool bsp_open(const char *address, bsp_identity_t *identity, char *error, uint32_t error_size)
{
    kernel_watchdog_init(&watchdog);
    if (!wiring_read(&wiring, address, error, error_size) ||
        !pins_open(&pins, &wiring, error, error_size)) {
        return false;
    }
    if (!card_buses_open(&buses, &wiring, error, error_size)) {
        pins_close(&pins);
        return false;
    }
    slowness = wiring.slowness;
    identify(identity);
    is_cut = 0;
    is_open = 1;
    return true;
}

/*
 * The drives get their power as the last thing, and never after it was cut.
 *
 * @satisfies SWR-GPIO-005
 */
static bool give_power(char *error, uint32_t error_size)
{
    const bool is_given = (is_cut == 0) && pins_set_power(&pins, true);

    if (is_cut != 0) {
        (void)pins_set_power(&pins, false);
    }
    if (!is_given) {
        (void)snprintf(error, error_size,
                       "The line of the drives' power does not follow; check the wire \"power\".");
    }
    return is_given;
}

/** @satisfies SWR-ARM-009 */
static bool arm_watchdog(char *error, uint32_t error_size)
{
    return (wiring.watchdog[0] == '\0') ||
           kernel_watchdog_arm(&watchdog, wiring.watchdog, wiring.watchdog_s, error, error_size);
}

/** @satisfies SWR-ARM-008 */
bool bsp_self_test(char *error, uint32_t error_size)
{
    return wire_test_run(&buses, &wiring, error, error_size) && arm_watchdog(error, error_size) &&
           give_power(error, error_size);
}

void bsp_start(uint32_t send, const uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES])
{
    card_buses_start(&buses, send, frames, 0U);
}

void bsp_finish(uint64_t deadline_ns, uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES],
                bsp_exchange_t *result)
{
    card_buses_finish(&buses, deadline_ns * slowness, received, result);
    result->started_ns /= slowness;
    result->finished_ns /= slowness;
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        result->sampled_ns[slot] /= slowness;
    }
}

void bsp_sample_inputs(bsp_inputs_t *inputs)
{
    const uint64_t sampled_ns = bsp_now_ns();
    const pins_sample_t sample = pins_sample(&pins);

    *inputs = (bsp_inputs_t){.sampled_ns = sampled_ns,
                             .levels = sample.levels,
                             .dropped = sample.dropped,
                             .valid = sample.valid};
}

void bsp_set_lamps(uint32_t lamps)
{
    pins_set_lamps(&pins, lamps);
}

/** @satisfies SWR-GPIO-005 */
void bsp_drives_off(void)
{
    is_cut = 1;
    if (is_open != 0) {
        (void)pins_set_power(&pins, false);
    }
}

void bsp_kick(void)
{
    kernel_watchdog_kick(&watchdog, spi_bus_now_ns());
}

uint64_t bsp_now_ns(void)
{
    return spi_bus_now_ns() / slowness;
}

uint64_t bsp_reached_ns(void)
{
    return bsp_now_ns();
}

void bsp_sleep_until_ns(uint64_t deadline_ns)
{
    const uint64_t world_ns = deadline_ns * slowness;
    const struct timespec deadline = {.tv_sec = (time_t)(world_ns / NS_PER_S),
                                      .tv_nsec = (long)(world_ns % NS_PER_S)};

    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &deadline, NULL) == EINTR) {
    }
}

void bsp_stand_still_ns(uint64_t world_ns)
{
    (void)world_ns; /* It does not wait for control. */
}

/* Lines go last: with them the kernel may let go of the power's line. */
void bsp_close(void)
{
    bsp_drives_off();
    kernel_watchdog_release(&watchdog, pins_set_power(&pins, false));
    card_buses_close(&buses);
    is_open = 0;
    pins_close(&pins);
}
