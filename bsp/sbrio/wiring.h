/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Wiring of a box, read from a text: which slots are behind which SPI device, which line of which
 * GPIO chip is what, and the watchdog. docs/board-sbrio.md describes the text. Slots need no order;
 * a part that is not named is not there.
 */
#ifndef BORESIGHT_WIRING_H
#define BORESIGHT_WIRING_H

#include "card/card.h"
#include "sbrio/wiring_text.h"

#include <stdbool.h>
#include <stdint.h>

#define WIRING_CHIPS 4U

/** Lines of the box. Inputs stand first, bit n of BSP_IN_ is input n; lamps last, as BSP_LAMP_. */
typedef enum {
    WIRING_PEDAL_A = 0,
    WIRING_PEDAL_B = 1,
    WIRING_ESTOP = 2,
    WIRING_SCANNER = 3,
    WIRING_CONFIRM = 4,
    WIRING_DOSE = 5,
    WIRING_TREATMENT = 6,
    WIRING_INPUTS = 7,
    WIRING_POWER = 7, /**< Output: the drives have power while it is 1. */
    WIRING_LAMPS = 8,
    WIRING_LINES = 12
} wiring_line_name_t;

/** One SPI device. */
typedef struct {
    char path[WIRING_PATH_SIZE];
    uint32_t bus; /**< BUS of "spidevBUS.SELECT": devices of one bus take turns. */
    uint32_t first_slot;
    uint32_t slot_count; /**< More than one: a multiplexer leads from slot to slot. */
    uint32_t clock_hz;
    uint32_t mode;   /**< Mode of SPI, 0..3. */
    uint32_t gap_us; /**< 0: one message; otherwise each frame by itself, so far apart. */
} wiring_spi_t;

/** One line. */
typedef struct {
    bool is_there;
    uint32_t chip;      /**< Place in `chips`. */
    uint32_t offset;    /**< Number of the line in its chip. */
    bool is_active_low; /**< A contact to ground: the line is 1 while it is pulled down. */
} wiring_line_t;

typedef struct {
    wiring_spi_t spi[CARD_SLOT_COUNT];
    uint32_t spi_count;
    char chips[WIRING_CHIPS][WIRING_PATH_SIZE];
    bool are_pulled[WIRING_CHIPS]; /**< The chip's own resistors hold its inputs at 0. */
    uint32_t chip_count;
    wiring_line_t lines[WIRING_LINES];
    char watchdog[WIRING_PATH_SIZE]; /**< "": none. */
    uint32_t watchdog_s;
    uint32_t slowness; /**< Time passes so many times slower; 1 unless the machine is emulated. */
} wiring_t;

/**
 * Reads `address`: the path of a file if it begins with '/', otherwise the text itself.
 *
 * @return false: `error` says in one sentence what is wrong in which line, and `wiring` is
 * undefined
 *
 * @satisfies SWR-SPI-001
 * @satisfies SWR-SPI-002
 * @satisfies SWR-SPI-012
 */
bool wiring_read(wiring_t *wiring, const char *address, char *error, uint32_t error_size);

#endif
