/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The pedal gate: open only while both channels of the foot pedal are closed and were seen open
 * before. The controller owns one and steps it every cycle. Behaviour:
 * statecharts/pedal_gate.scxml.
 */
#ifndef BORESIGHT_PEDAL_GATE_H
#define BORESIGHT_PEDAL_GATE_H

#include "charts/pedal_gate_chart.h"

#include <stdbool.h>
#include <stdint.h>

/** Under seal. */
typedef struct {
    uint32_t is_released; /**< Both channels were open at the last step: 0 or 1. */
} pedal_gate_sealed_t;

typedef struct {
    pedal_gate_sealed_t sealed;
    pedal_gate_chart_t chart;
} pedal_gate_t;

/** Starts unproven: the pedal must be seen released first. */
void pedal_gate_init(pedal_gate_t *self);

/** Before each step: a damaged gate is in its fault. True when it was damaged. */
static inline bool pedal_gate_check(pedal_gate_t *self)
{
    return pedal_gate_chart_check(&self->chart) != 0U;
}

/**
 * One cycle with the levels of this cycle; `elapsed_us` since the step before.
 *
 * @satisfies SWR-PEDAL-002
 * @satisfies SWR-PEDAL-004
 */
void pedal_gate_step(pedal_gate_t *self, bool is_a_closed, bool is_b_closed, uint32_t elapsed_us);

/**
 * Shuts the gate until the pedal has been seen released again; called whenever a motion is armed
 * and while the scanner acquires.
 *
 * @satisfies SWR-PEDAL-003
 */
void pedal_gate_renew(pedal_gate_t *self);

/**
 * Clears a pedal fault if both channels are open.
 *
 * @satisfies SWR-PEDAL-007
 */
void pedal_gate_reset(pedal_gate_t *self);

/** @return true in the cycles in which the pedal permits motion: pressed, and seen released before
 */
bool pedal_gate_is_open(const pedal_gate_t *self);

#endif
