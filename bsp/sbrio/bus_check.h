/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Check of a slot's wires by its answers: judged in the self test, where frames are first exchanged
 * far apart and then as they always will be.
 */
#ifndef BORESIGHT_BUS_CHECK_H
#define BORESIGHT_BUS_CHECK_H

#include "card/card_frame.h"
#include "sbrio/wiring.h"

#include <stdbool.h>
#include <stdint.h>

/** Kind of an answer from a slot. */
typedef enum {
    BUS_CHECK_EMPTY = 0,   /**< The wire stood still: only zeros or only ones. */
    BUS_CHECK_ALIVE = 1,   /**< A whole report of the card in this slot. */
    BUS_CHECK_SHIFTED = 2, /**< The start word stands one to seven bits beside its place. */
    BUS_CHECK_OTHER = 3,   /**< A report of another slot's card. */
    BUS_CHECK_DAMAGED = 4, /**< A start word, and no whole report behind it. */
    BUS_CHECK_NOISE = 5    /**< No start word. */
} bus_check_answer_t;

/** Answer that was seen from one slot. */
typedef struct {
    bus_check_answer_t answer;
    uint32_t shift_bits; /**< With BUS_CHECK_SHIFTED. */
    uint32_t heartbeat;  /**< With BUS_CHECK_ALIVE. */
    uint32_t slot;       /**< With BUS_CHECK_OTHER: slot of the report. */
} bus_check_seen_t;

/** The wire stood still: all bytes are 0x00, or all 0xFF. */
bool bus_check_stands_still(const uint8_t bytes[CARD_FRAME_BYTES]);

/** Looks at the answer from `slot`. */
bus_check_seen_t bus_check_look(uint32_t slot, const uint8_t bytes[CARD_FRAME_BYTES]);

/**
 * Judges a slot: `apart` and `apart_again` came back with frames far apart, `together` as the
 * wiring has it.
 *
 * @return false: `error` says in one sentence what is wrong and what to do
 *
 * @satisfies SWR-SPI-008
 * @satisfies SWR-SPI-009
 * @satisfies SWR-SPI-010
 */
bool bus_check_judge(const wiring_spi_t *wiring, uint32_t slot, const bus_check_seen_t *apart,
                     const bus_check_seen_t *apart_again, const bus_check_seen_t *together,
                     char *error, uint32_t error_size);

#endif
