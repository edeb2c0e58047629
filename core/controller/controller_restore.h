/* SPDX-License-Identifier: Apache-2.0 */
/** @file Positions that were kept from before the start. */
#ifndef BORESIGHT_CONTROLLER_RESTORE_H
#define BORESIGHT_CONTROLLER_RESTORE_H

#include "controller/controller_events.h"

#include <stdint.h>

/**
 * At the first report of an axis of which a reading was kept: is it the same? Then what was known
 * is restored, otherwise the axis is lost.
 *
 * @satisfies SWR-STORE-005
 * @satisfies SWR-STORE-006
 */
void controller_compare(controller_t *self, const cycle_t *cycle, uint32_t index);

/** Axes with a kept position that have not reported yet. */
uint32_t controller_count_awaited(const controller_t *self);

#endif
