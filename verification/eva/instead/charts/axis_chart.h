/* SPDX-License-Identifier: Apache-2.0 */
/** @file Contract of axis_chart_dispatch() for Eva: from any leaves into any leaves. Under a name
 * of its own: `parts.c` follows the real one. */
#ifndef BORESIGHT_EVA_AXIS_CHART_H
#define BORESIGHT_EVA_AXIS_CHART_H

#include "../../../../build/gen/charts/axis_chart.h"

/** Each region is a leaf, and its copy the inverse of a leaf. */
#define EVA_AXIS_LEAVES(chart)                                                                     \
    ((chart)->power <= AXIS_POWER_FAULT && (chart)->reference <= AXIS_REFERENCE_VERIFIED &&        \
     (chart)->power_inverse >= UINT32_MAX - AXIS_POWER_FAULT &&                                    \
     (chart)->reference_inverse >= UINT32_MAX - AXIS_REFERENCE_VERIFIED)

#define axis_chart_dispatch any_axis_chart_dispatch

/*@ requires valid: \valid(self) && \valid_read(inputs);
    requires initialised: \initialized(self) && \initialized(inputs);
    requires leaves: EVA_AXIS_LEAVES(self); */
uint32_t any_axis_chart_dispatch(axis_chart_t *self, const axis_inputs_t *inputs,
                                 axis_event_t event);

#endif
