/* SPDX-License-Identifier: Apache-2.0 */
/** @file The state of the machine and of the programs, for one line. */
#ifndef BORESIGHT_STATUS_LINE_H
#define BORESIGHT_STATUS_LINE_H

#include "exchange/exchange.h"
#include "supervisor/process_group.h"
#include "supervisor/status_parts.h"

/**
 * Takes its parts: workphase, permit, pedal and e-stop, cycles that are not recorded, when the disk
 * is full, who asks for the button, programs that are not well, links, who commands, who is not
 * reached, time, and the programs that are well.
 *
 * @satisfies SWR-SUP-004
 */
void status_line_take(status_parts_t *parts, const exchange_t *exchange, process_group_t *group);

#endif
