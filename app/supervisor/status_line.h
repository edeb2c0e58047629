/* SPDX-License-Identifier: Apache-2.0 */
/** @file The state of the machine and of the programs in one line. */
#ifndef BORESIGHT_STATUS_LINE_H
#define BORESIGHT_STATUS_LINE_H

#include "exchange/exchange.h"
#include "supervisor/family.h"

#include <stddef.h>

/**
 * Writes the line: workphase, pedal, e-stop, permit, links, loop, and each program with its state.
 *
 * @satisfies SWR-SUP-004
 */
void status_line_write(char *text, size_t size, const exchange_t *exchange, family_t *family);

#endif
