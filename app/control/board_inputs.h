/* SPDX-License-Identifier: Apache-2.0 */
/** @file What a board says of its inputs and its frames, as the controller takes it and the record
 * has it. Control owns one. */
#ifndef BORESIGHT_BOARD_INPUTS_H
#define BORESIGHT_BOARD_INPUTS_H

#include "bsp.h"
#include "controller/controller.h"
#include "exchange/exchange.h"

#include <stdint.h>

/** At first all zero: nothing was read yet. */
typedef struct {
    uint32_t known; /**< BSP_IN_ bits that were ever read: the box has them. */
} board_inputs_t;

/**
 * Sets the digital inputs of `inputs`, and nothing else of it. An input that was 0 at any time, or
 * was not read, counts as 0. Without a button no press exists; without a gate of the treatment
 * nothing is stated about dose and stop; each other input that was never read stays as a cut wire
 * has it, and is named as not read.
 *
 * @satisfies SWR-BSP-001
 * @satisfies SWR-EVENT-031
 */
void board_inputs_take(board_inputs_t *self, const bsp_inputs_t *sampled,
                       controller_inputs_t *inputs);

/**
 * Sets which frames were received, when each was sampled, and which were late or failed.
 *
 * @satisfies SWR-CTRL-014
 * @satisfies SWR-CARD-015
 */
void board_inputs_receive(const bsp_exchange_t *exchanged, controller_inputs_t *inputs);

/**
 * The board's report in this cycle, for the record: `exchanged` is the exchange that was ended in
 * it.
 *
 * @satisfies SWR-REC-018
 */
void board_inputs_note(const bsp_inputs_t *sampled, const bsp_exchange_t *exchanged,
                       cycle_board_t *said);

#endif
