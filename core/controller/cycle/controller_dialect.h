/* SPDX-License-Identifier: Apache-2.0 */
/** @file Cards that speak another dialect than our own. */
#ifndef BORESIGHT_CONTROLLER_DIALECT_H
#define BORESIGHT_CONTROLLER_DIALECT_H

#include "controller/controller_events.h"

/**
 * Says what goes out once more in the dialect of the cards, if it is another one; a drive that
 * cannot be said is off.
 *
 * @satisfies SWR-NI-005
 */
void controller_translate(const cycle_t *cycle);

#endif
