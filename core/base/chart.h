/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Common parts of every compiled statechart: the trace of the transitions it took, and the
 * contracts of its queue of raised events.
 */
#ifndef BORESIGHT_CHART_H
#define BORESIGHT_CHART_H

#include "base/contract.h"

#include <stdint.h>

/** Steps that a trace keeps; a power of two. */
#define CHART_TRACE_LENGTH 8U

/** One transition: its number in charts.json, 0 for a repair, and the chart's time when it was
 * taken. */
typedef struct {
    uint64_t now_us;
    uint32_t transition;
} chart_step_t;

/** Ring of the last steps: step n stands in `steps[n % CHART_TRACE_LENGTH]`. Owned by the chart. */
typedef struct {
    chart_step_t steps[CHART_TRACE_LENGTH];
    uint32_t count; /**< Steps ever added, wraps. */
} chart_trace_t;

/**
 * Adds one step; the oldest one is forgotten.
 *
 * @satisfies SWR-CHART-007
 */
static inline void chart_trace_add(chart_trace_t *self, uint64_t now_us, uint32_t transition)
{
    chart_step_t *const step = &self->steps[self->count % CHART_TRACE_LENGTH];
    step->now_us = now_us;
    step->transition = transition;
    self->count++;
}

/** Contract 1: `raised` events are in a queue of `length`, one more fits. Returns the slot for it.
 */
static inline uint32_t chart_queue_slot(uint32_t raised, uint32_t length)
{
    if (raised >= length) {
        contract_broken("chart", 1U);
    }
    return raised;
}

/** Contract 2: all `raised` events were `taken`; the bound on the rounds of a macrostep held. */
static inline void chart_require_settled(uint32_t taken, uint32_t raised)
{
    if (taken != raised) {
        contract_broken("chart", 2U);
    }
}

#endif
