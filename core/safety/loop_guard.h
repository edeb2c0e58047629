/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The loop guard: counts late cycles and stops motion when they come in a row or too often, or one
 * is so late that cards may have switched their drives off. It keeps stage and times of the last
 * late cycles. Behaviour: statecharts/loop_guard.scxml.
 */
#ifndef BORESIGHT_LOOP_GUARD_H
#define BORESIGHT_LOOP_GUARD_H

#include "charts/loop_guard_chart.h"

#include <stdbool.h>
#include <stdint.h>

/** Late cycles from the first one after punctual ones made up for all before; kept after a stop. */
typedef struct {
    uint32_t count;
    uint32_t span_us;       /**< The intervals from the first to the last of them. */
    uint32_t longest_us;    /**< The longest interval. */
    uint32_t longest_stage; /**< Stage that made it so long, as control numbers them. */
} loop_lateness_t;

/** Under seal. */
typedef struct {
    uint32_t overruns; /**< Late cycles since the start, saturates. */
    loop_lateness_t lateness;
} loop_guard_sealed_t;

typedef struct {
    loop_guard_chart_t chart;
    loop_guard_sealed_t sealed;
} loop_guard_t;

void loop_guard_init(loop_guard_t *self);

/** Before each step: a damaged guard has stopped the loop. True when it was damaged. */
static inline bool loop_guard_check(loop_guard_t *self)
{
    return loop_guard_chart_check(&self->chart) != 0U;
}

/**
 * One cycle that came `elapsed_us` after the one before, of which `stage` took longest. Late above
 * LIMIT_OVERRUN_US, stopped at once above LIMIT_LOOP_SILENT_US.
 *
 * @satisfies SWR-LOOP-001
 * @satisfies SWR-LOOP-002
 * @satisfies SWR-LOOP-004
 * @satisfies SWR-LOOP-009
 */
void loop_guard_step(loop_guard_t *self, uint32_t elapsed_us, uint32_t stage);

/** Lets motion be armed again after a stop. */
void loop_guard_reset(loop_guard_t *self);

#endif
