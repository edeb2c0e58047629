/* SPDX-License-Identifier: Apache-2.0 */
#include "safety/pedal_gate.h"

static pedal_gate_inputs_t chart_inputs(const pedal_gate_t *self)
{
    const pedal_gate_inputs_t inputs = {.is_released = (self->sealed.is_released != 0U)};
    return inputs;
}

void pedal_gate_init(pedal_gate_t *self)
{
    pedal_gate_chart_init(&self->chart);
    self->sealed.is_released = 0U;
}

void pedal_gate_step(pedal_gate_t *self, bool is_a_closed, bool is_b_closed, uint32_t elapsed_us)
{
    self->sealed.is_released = 1U;
    if (is_a_closed || is_b_closed) {
        self->sealed.is_released = 0U;
    }
    const pedal_gate_inputs_t inputs = chart_inputs(self);
    (void)pedal_gate_chart_advance(&self->chart, &inputs, elapsed_us);
    pedal_gate_event_t event = PEDAL_GATE_EVENT_DIFFER;
    if (inputs.is_released) {
        event = PEDAL_GATE_EVENT_BOTH_OPEN;
    } else if (is_a_closed == is_b_closed) {
        event = PEDAL_GATE_EVENT_BOTH_CLOSED;
    } else {
        event = PEDAL_GATE_EVENT_DIFFER;
    }
    (void)pedal_gate_chart_dispatch(&self->chart, &inputs, event);
}

void pedal_gate_renew(pedal_gate_t *self)
{
    const pedal_gate_inputs_t inputs = chart_inputs(self);
    (void)pedal_gate_chart_dispatch(&self->chart, &inputs, PEDAL_GATE_EVENT_RENEW);
}

void pedal_gate_reset(pedal_gate_t *self)
{
    const pedal_gate_inputs_t inputs = chart_inputs(self);
    (void)pedal_gate_chart_dispatch(&self->chart, &inputs, PEDAL_GATE_EVENT_RESET);
}

bool pedal_gate_is_open(const pedal_gate_t *self)
{
    return self->chart.state == PEDAL_GATE_STATE_PRESSED;
}
