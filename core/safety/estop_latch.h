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
#include <stdint.h>

/** Starts latched. */
static inline void estop_latch_init(estop_latch_chart_t *self)
{
    estop_latch_chart_init(self);
}

/** Before each step: a damaged latch is latched. True when it was damaged. */
static inline bool estop_latch_check(estop_latch_chart_t *self)
{
    return estop_latch_chart_check(self) != 0U;
}

/**
 * One cycle with the level of this cycle; `elapsed_us` since the step before.
 *
 * @satisfies SWR-ESTOP-001
 */
void estop_latch_step(estop_latch_chart_t *self, bool is_open, uint32_t elapsed_us);

/**
 * Clears the latch if the switch is closed.
 *
 * @satisfies SWR-ESTOP-002
 */
void estop_latch_reset(estop_latch_chart_t *self);

#endif
