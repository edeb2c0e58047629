/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * One SPI device of the kernel (spidev), full duplex. Behind it is one card, or a multiplexer that
 * goes round its slots, one further whenever the chip select is released, and begins with the first
 * one after LIMIT_SPI_REST_US without a transfer.
 */
#ifndef BORESIGHT_SPI_DEVICE_H
#define BORESIGHT_SPI_DEVICE_H

#include "card/card_frame.h"
#include "sbrio/wiring.h"

#include <stdbool.h>
#include <stdint.h>

/** An open device. */
typedef struct {
    wiring_spi_t wiring;
    int file;
    int32_t error; /**< errno of the last transfer; 0: whole. */
} spi_device_t;

/** Bit n: slot n is behind the device. */
uint32_t spi_device_slots(const wiring_spi_t *wiring);

/** Time of a transfer of all its frames, with the pauses of the chip select, us. */
uint32_t spi_device_time_us(const wiring_spi_t *wiring);

/**
 * Opens the device, sets mode, bits per word and clock, and reads them back.
 *
 * @return false: `error` holds one sentence that says what to do
 *
 * @satisfies SWR-SPI-005
 */
bool spi_device_open(spi_device_t *self, const wiring_spi_t *wiring, char *error,
                     uint32_t error_size);

/**
 * Transfers the frames of all its slots and waits for that: as one message with the chip select
 * released between frames or, with a gap, each frame by itself. Then `error` holds the result, and
 * `sampled_ns` when each card was selected.
 *
 * @satisfies SWR-SPI-003
 * @satisfies SWR-BSP-007
 */
void spi_device_transfer(spi_device_t *self, uint32_t gap_us,
                         uint8_t sent[CARD_SLOT_COUNT][CARD_FRAME_BYTES],
                         uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES],
                         uint64_t sampled_ns[CARD_SLOT_COUNT]);

/** Closes the device. */
void spi_device_close(spi_device_t *self);

#endif
