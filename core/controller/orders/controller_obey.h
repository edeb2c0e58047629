/* SPDX-License-Identifier: Apache-2.0 */
/** @file The commands of a cycle. */
#ifndef BORESIGHT_CONTROLLER_OBEY_H
#define BORESIGHT_CONTROLLER_OBEY_H

#include "controller/controller_events.h"

/**
 * Commands of this cycle, each answered at once.
 *
 * @satisfies SWR-AXIS-020
 * @satisfies SWR-CMD-001
 * @satisfies SWR-CMD-004
 * @satisfies SWR-CMD-005
 * @satisfies SWR-CMD-340
 * @satisfies SWR-EVENT-009
 * @satisfies SWR-EVENT-011
 * @satisfies SWR-LOOP-006
 * @satisfies SWR-NEXT-026
 */
void controller_obey(controller_t *self, const cycle_t *cycle);

#endif
