/* SPDX-License-Identifier: Apache-2.0 */
/** @file Where the registers of a box are in its FPGA; docs/board-nifpga.md lists their names. */
#ifndef BORESIGHT_FABRIC_H
#define BORESIGHT_FABRIC_H

#include "card/card.h"
#include "nifpga/bitfile.h"

#include <stdbool.h>
#include <stdint.h>

/** Registers of one bit. Inputs stand first, bit n of BSP_IN_ is input n; lamps last, as BSP_LAMP_.
 */
typedef enum {
    FABRIC_INPUTS = 7, /**< So many inputs. */
    FABRIC_POWER = 7,  /**< The drives have power while it is true. */
    FABRIC_ALIVE = 8,  /**< Changes with every kick. */
    FABRIC_LAMPS = 9,
    FABRIC_BITS = 13
} fabric_bit_t;

/** Addresses of a card's registers. */
typedef struct {
    uint32_t outgoing;
    uint32_t incoming;
    uint32_t transact;
    uint32_t state;
    uint16_t idle; /**< Value of `state` when nothing is under way. */
} fabric_card_t;

typedef struct {
    fabric_card_t cards[CARD_SLOT_COUNT];
    uint32_t slots; /**< Bit n: there is a card[n]. */
    uint32_t bits[FABRIC_BITS];
    uint32_t has; /**< Bit n: there is a bits[n]. */
} fabric_t;

/**
 * Finds all registers. A slot whose OutgoingPacket is not there is none; of any other, and of the
 * inputs that every box has, each register must be there, and at an address of its own.
 *
 * @return false: `error` names the register that is missing, is another one or is there twice, or
 * the address
 *
 * @satisfies SWR-NI-009
 * @satisfies SWR-NI-017
 */
bool fabric_find(fabric_t *self, const bitfile_t *bitfile, char *error, uint32_t error_size);

#endif
