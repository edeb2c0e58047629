/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The e-stop latch: motion stays forbidden after the switch has closed again, until START_UP is
 * commanded. Behaviour: statecharts/estop_latch.scxml. The power itself is cut by the e-stop chain
 * in hardware.
 */
#ifndef BORESIGHT_ESTOP_LATCH_H
#define BORESIGHT_ESTOP_LATCH_H

#include "charts/estop_latch_chart.h"

#include <stdbool.h>

/**
 * One cycle with the level of this cycle.
 *
 * @satisfies SWR-ESTOP-001
 */
void estop_latch_step(estop_latch_chart_t *self, bool is_open);

/**
 * Clears the latch if the switch is closed.
 *
 * @satisfies SWR-ESTOP-002
 */
void estop_latch_reset(estop_latch_chart_t *self);

#endif
