/* SPDX-License-Identifier: Apache-2.0 */
/** @file Contract of chart_trace_add() of core/base/chart.h for Eva: it writes any values into the
 * trace, and nothing else. `sums.c` follows the real one. */
#ifndef BORESIGHT_EVA_CHART_H
#define BORESIGHT_EVA_CHART_H

#define chart_trace_add chart_trace_add_as_it_is
#include "../../../../core/base/chart.h"
#undef chart_trace_add

/*@ requires valid: \valid(self);
    assigns *self \from *self, now_us, transition; */
void chart_trace_add(chart_trace_t *self, uint64_t now_us, uint32_t transition);

#endif
