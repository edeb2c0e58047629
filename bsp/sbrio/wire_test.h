/* SPDX-License-Identifier: Apache-2.0 */
/** @file The self test of the wires to the cards, with drives off. */
#ifndef BORESIGHT_WIRE_TEST_H
#define BORESIGHT_WIRE_TEST_H

#include "sbrio/card_buses.h"

/**
 * Exchanges frames that no card obeys: first far apart, twice, then as the wiring has it, several
 * times; and judges every slot. Takes up to 100 ms of the box's time.
 *
 * @return false: `error` says in one sentence what is wrong and what to do
 *
 * @satisfies SWR-SPI-008
 * @satisfies SWR-SPI-009
 * @satisfies SWR-SPI-010
 */
bool wire_test_run(card_buses_t *buses, const wiring_t *wiring, char *error, uint32_t error_size);

#endif
