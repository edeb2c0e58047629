/* SPDX-License-Identifier: Apache-2.0 */
#include "safety/estop_latch.h"

void estop_latch_step(estop_latch_chart_t *self, bool is_open, uint32_t elapsed_us)
{
    (void)estop_latch_chart_advance(self, elapsed_us);
    (void)estop_latch_chart_dispatch(self,
                                     is_open ? ESTOP_LATCH_EVENT_OPENED : ESTOP_LATCH_EVENT_CLOSED);
}

void estop_latch_reset(estop_latch_chart_t *self)
{
    (void)estop_latch_chart_dispatch(self, ESTOP_LATCH_EVENT_RESET);
}
