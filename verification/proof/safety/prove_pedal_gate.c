/* SPDX-License-Identifier: Apache-2.0 */
/* One cycle of the pedal gate with its chart, from any sound state: what holds after each holds
 * always. */
#include "prove.h"

#include "limits/requirement_limits.h"
#include "safety/pedal_gate.h"

static pedal_gate_t self;

/* What every cycle leaves, and the next one relies on: while channels agree no time of disagreement
 * runs. */
static bool is_sound(void)
{
    return pedal_gate_chart_is_sound(&self.chart) &&
           SAME(self.chart.disagreement_is_armed, pedal_gate_chart_in_disagreeing(&self.chart));
}

static void begin(void)
{
    pedal_gate_t any;
    self = any;
    assume(is_sound());
}

void prove_SWR_PEDAL_002_the_gate_is_open_only_with_both_channels_closed(void)
{
    bool is_a_closed;
    bool is_b_closed;
    uint32_t elapsed_us;
    begin();
    const pedal_gate_state_t before = self.chart.state;
    const uint32_t differed_us = self.chart.disagreement_us;
    const bool did_differ = pedal_gate_chart_in_disagreeing(&self.chart);

    pedal_gate_step(&self, is_a_closed, is_b_closed, elapsed_us);

    const bool is_open = pedal_gate_is_open(&self);
    PROVE(IMPLIES(is_open, is_a_closed && is_b_closed), "SWR-PEDAL-002: both channels are closed");
    PROVE(IMPLIES(is_open, (before == PEDAL_GATE_STATE_RELEASED) ||
                               (before == PEDAL_GATE_STATE_PRESSED) ||
                               (before == PEDAL_GATE_STATE_CLOSING)),
          "SWR-PEDAL-003: it was seen released before");
    PROVE(IMPLIES((before == PEDAL_GATE_STATE_UNPROVEN) &&
                      (self.chart.state == PEDAL_GATE_STATE_RELEASED),
                  !is_a_closed && !is_b_closed),
          "SWR-PEDAL-003: unproven ends in released only with both channels open");
    PROVE(IMPLIES(before == PEDAL_GATE_STATE_FAULT, self.chart.state == PEDAL_GATE_STATE_FAULT),
          "SWR-PEDAL-007: a fault stays");
    PROVE(
        IMPLIES(did_differ && (((uint64_t)differed_us + elapsed_us) >= LIMIT_PEDAL_DISCREPANCY_US),
                self.chart.state == PEDAL_GATE_STATE_FAULT),
        "SWR-PEDAL-004: channels that differ for too long are a fault");
    PROVE(is_sound(), "SWR-CORE-004: the next cycle may rely on it");
    POSSIBLE(is_open, "an open gate");
}

void prove_SWR_PEDAL_003_a_renewed_gate_is_shut(void)
{
    bool is_reset;
    begin();
    const bool was_fault = self.chart.state == PEDAL_GATE_STATE_FAULT;
    const bool was_released = self.chart.state == PEDAL_GATE_STATE_RELEASED;
    if (is_reset) {
        pedal_gate_reset(&self);
    }
    PROVE(IMPLIES(was_fault && (self.chart.state != PEDAL_GATE_STATE_FAULT),
                  is_reset && (self.sealed.is_released != 0U)),
          "SWR-PEDAL-007: a fault ends by a reset with both channels open alone");
    pedal_gate_renew(&self);
    PROVE(IMPLIES(!was_released && !was_fault, (self.chart.state == PEDAL_GATE_STATE_UNPROVEN) ||
                                                   (self.chart.state == PEDAL_GATE_STATE_OPENING)),
          "SWR-PEDAL-003: a gate that was not seen released is unproven");
    PROVE(!pedal_gate_is_open(&self), "SWR-PEDAL-003: a renewed gate is shut");
    PROVE(is_sound(), "SWR-CORE-004: the next cycle may rely on it");
    POSSIBLE(self.chart.state == PEDAL_GATE_STATE_UNPROVEN, "unproven");
}
