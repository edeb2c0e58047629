/* SPDX-License-Identifier: Apache-2.0 */
/** @file In words, what differs if something had been otherwise. */
#ifndef BORESIGHT_WHAT_IF_SAYS_H
#define BORESIGHT_WHAT_IF_SAYS_H

#include "replay/what_if.h"

/** Prints which states, reasons, events and drives of `self->outputs` differ from `recorded` for
 * the first time; in the first cycle that differs numbers, when nothing else does. */
void what_if_says(what_if_t *self, const controller_outputs_t *recorded);

#endif
