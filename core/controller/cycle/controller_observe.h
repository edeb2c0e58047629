/* SPDX-License-Identifier: Apache-2.0 */
/** @file What the world says in this cycle. */
#ifndef BORESIGHT_CONTROLLER_OBSERVE_H
#define BORESIGHT_CONTROLLER_OBSERVE_H

#include "controller/controller_events.h"

/**
 * Links, encoders, interlocks: what the world says in this cycle. A damaged chart is repaired here.
 *
 * @satisfies SWR-CORE-004
 * @satisfies SWR-CHART-012
 * @satisfies SWR-REF-006
 * @satisfies SWR-REF-010
 * @satisfies SWR-REF-011
 * @satisfies SWR-REF-007
 * @satisfies SWR-EVENT-003
 * @satisfies SWR-AXIS-023
 * @satisfies SWR-AXIS-046
 * @satisfies SWR-AXIS-054
 * @satisfies SWR-DRIVE-008
 */
void controller_observe(controller_t *self, const cycle_t *cycle);

#endif
