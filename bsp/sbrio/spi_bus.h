/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * One SPI bus: its devices take turns, and as the kernel blocks the caller of a transfer, a thread
 * of the bus does it. Starting an exchange never waits. Start and await may be called by a signal
 * handler, whatever it has interrupted: they take no lock.
 */
#ifndef BORESIGHT_SPI_BUS_H
#define BORESIGHT_SPI_BUS_H

#include "sbrio/spi_device.h"

#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>

/** State of one bus. */
typedef struct {
    uint32_t number; /**< Bus number of the wiring. */
    uint32_t slots;  /**< Bit n: slot n is behind it. */
    spi_device_t devices[CARD_SLOT_COUNT];
    uint32_t device_count;
    uint8_t sent[CARD_SLOT_COUNT][CARD_FRAME_BYTES];
    uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES];
    uint64_t sampled_ns[CARD_SLOT_COUNT];
    uint32_t gap_us;      /**< At least, of the exchange under way. */
    uint64_t finished_ns; /**< Monotonic time of the last exchange's end. */
    bool needs_rest;      /**< Before the next exchange. */
    uint32_t requested;   /**< Number of the last exchange asked for; the thread waits for it. */
    uint32_t done;        /**< Number of the last one that has ended. */
    uint32_t is_ending;
    pthread_t thread;
} spi_bus_t;

/** Time of an exchange of all devices of bus `number`, us. */
uint32_t spi_bus_time_us(const wiring_t *wiring, uint32_t number);

/**
 * The clock at which they would take at most `time_us`, Hz; 0: none is fast enough.
 */
uint32_t spi_bus_clock_needed_hz(const wiring_t *wiring, uint32_t number, uint32_t time_us);

/**
 * Opens the devices of bus `number` and starts its thread, with the FIFO priority `priority` where
 * that is allowed. Until it is closed, `self` stays where it is.
 *
 * @return false: `error` holds one sentence that says what to do, and nothing is open
 *
 * @satisfies SWR-SPI-004
 */
bool spi_bus_open(spi_bus_t *self, const wiring_t *wiring, uint32_t number, int priority,
                  char *error, uint32_t error_size);

/**
 * Begins to exchange the frames of its slots; those that `send` leaves out are zeros, which no card
 * takes. `gap_us`: at least so far apart; 0: as the wiring has it. After an exchange that failed or
 * took long, the bus rests first.
 *
 * @return false: the exchange before is still under way, and is not disturbed
 *
 * @satisfies SWR-SPI-004
 * @satisfies SWR-SPI-011
 */
bool spi_bus_start(spi_bus_t *self, uint32_t send,
                   const uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES], uint32_t gap_us);

/** Waits for the end of the exchange until `deadline_ns` at most. @return whether it has ended */
bool spi_bus_await(const spi_bus_t *self, uint64_t deadline_ns);

/** errno of the transfer to `slot` in the exchange that has ended. */
int32_t spi_bus_error(const spi_bus_t *self, uint32_t slot);

/** Ends the thread and closes the devices; a transfer that hangs is left alone. */
void spi_bus_close(spi_bus_t *self);

/** Monotonic time, ns. */
uint64_t spi_bus_now_ns(void);

#endif
