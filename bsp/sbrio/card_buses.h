/* SPDX-License-Identifier: Apache-2.0 */
/** @file All SPI buses of a box: an exchange goes over all of them at once. Times are monotonic. */
#ifndef BORESIGHT_CARD_BUSES_H
#define BORESIGHT_CARD_BUSES_H

#include "bsp.h"
#include "sbrio/spi_bus.h"
#include "sbrio/wiring.h"

#include <stdbool.h>
#include <stdint.h>

/** State of all buses. */
typedef struct {
    spi_bus_t buses[CARD_SLOT_COUNT];
    uint32_t count;
    bsp_exchange_t begun; /**< As it is if nothing more comes back. */
    uint32_t awaited;     /**< Bit n: the frame of slot n is under way in this exchange. */
} card_buses_t;

/**
 * Opens every bus of the wiring. Until they are closed, `self` stays where it is.
 *
 * @return false: `error` holds one sentence that says what to do, and nothing is open
 *
 * @satisfies SWR-SPI-006
 */
bool card_buses_open(card_buses_t *self, const wiring_t *wiring, char *error, uint32_t error_size);

/** Begins an exchange, as bsp_start(); frames are at least `gap_us` apart. */
void card_buses_start(card_buses_t *self, uint32_t send,
                      const uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES], uint32_t gap_us);

/**
 * Ends it, as bsp_finish(). A bus that is busy with an exchange before is waited for as well: then
 * it can be asked again.
 *
 * @satisfies SWR-SPI-004
 * @satisfies SWR-SPI-007
 */
void card_buses_finish(card_buses_t *self, uint64_t deadline_ns,
                       uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES], bsp_exchange_t *result);

/** Closes them. */
void card_buses_close(card_buses_t *self);

#endif
