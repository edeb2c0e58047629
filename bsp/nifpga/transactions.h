/* SPDX-License-Identifier: Apache-2.0 */
/** @file The exchange of frames with all cards through the FPGA, one SPI master for each. Times are
 * monotonic. */
#ifndef BORESIGHT_TRANSACTIONS_H
#define BORESIGHT_TRANSACTIONS_H

#include "bsp.h"
#include "nifpga/fabric.h"
#include "nifpga/fpga.h"

#include <stdint.h>

typedef struct {
    const fpga_t *fpga;
    const fabric_t *fabric;
    bsp_exchange_t begun; /**< As it is if nothing more comes back. */
    uint32_t awaited;     /**< Bit n: slot n is under way in this exchange. */
} transactions_t;

uint64_t transactions_now_ns(void);

/** `fpga` and `fabric` stay where they are. */
void transactions_init(transactions_t *self, const fpga_t *fpga, const fabric_t *fabric);

/**
 * Begins an exchange, as bsp_start(). A card whose state is not idle is left alone.
 *
 * @satisfies SWR-NI-011
 */
void transactions_start(transactions_t *self, uint32_t send,
                        const uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES]);

/**
 * Ends it, as bsp_finish(): a packet is read once its card's state is idle again.
 *
 * @satisfies SWR-NI-011
 */
void transactions_finish(transactions_t *self, uint64_t deadline_ns,
                         uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES],
                         bsp_exchange_t *result);

#endif
