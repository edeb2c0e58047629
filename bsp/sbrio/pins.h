/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The digital lines of a box, by libgpiod 1.6. An input is 1 only while its wire is whole and its
 * contact closed. The kernel keeps every edge until it is read, so that no pulse is too short.
 */
#ifndef BORESIGHT_PINS_H
#define BORESIGHT_PINS_H

#include "sbrio/wiring.h"

#include <gpiod.h>
#include <stdbool.h>
#include <stdint.h>

/** Open lines. */
typedef struct {
    struct gpiod_chip *chips[WIRING_CHIPS];
    struct gpiod_line *lines[WIRING_LINES]; /**< NULL: not there. */
    uint32_t lamps;                         /**< BSP_LAMP_ bits that are lit. */
} pins_t;

/** Sample of the inputs: bit n is input n of the wiring, as BSP_IN_. */
typedef struct {
    uint32_t levels;
    uint32_t dropped; /**< Was 0 at any time since the sample before. */
    uint32_t valid;   /**< Is there, and was read. */
} pins_sample_t;

/**
 * Takes the lines that the wiring names: inputs with their edges, outputs at 0, so that the drives
 * have no power.
 *
 * @return false: `error` holds one sentence that says what to do, and nothing is open
 *
 * @satisfies SWR-GPIO-001
 * @satisfies SWR-GPIO-005
 */
bool pins_open(pins_t *self, const wiring_t *wiring, char *error, uint32_t error_size);

/**
 * Reads all inputs. An edge, whichever, means that its input was 0. All inputs count as dropped
 * where the kernel's memory of edges may have overflowed.
 *
 * @satisfies SWR-GPIO-001
 * @satisfies SWR-GPIO-002
 * @satisfies SWR-GPIO-003
 * @satisfies SWR-GPIO-004
 */
pins_sample_t pins_sample(pins_t *self);

/** Gives or takes the power of the drives; callable from a signal handler. @return whether the line
 * then reads so */
bool pins_set_power(const pins_t *self, bool is_on);

/**
 * Lights the lamps of BSP_LAMP_ bits that are there.
 *
 * @satisfies SWR-GPIO-006
 */
void pins_set_lamps(pins_t *self, uint32_t lamps);

/** Gives the lines back; what is open is closed. */
void pins_close(pins_t *self);

#endif
