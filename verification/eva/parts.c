/* SPDX-License-Identifier: Apache-2.0 */
/* Functions of which Eva sees a contract elsewhere (instead/charts, instead/controller), followed
 * here as they are: from every state that the contract accepts, with any arguments. Each assertion
 * is what the contract, or the body of any_axis_chart_dispatch(), leaves behind. */
#include "charts/axis_chart.h"
#include "controller/controller_events.h"
#undef axis_chart_dispatch
#undef controller_note

#include "../../build/gen/charts/axis_chart.c"
#include "../../core/controller/controller_events.c"

#include "parts.h"

#include <__fc_builtin.h>

#define ANY(member) Frama_C_make_unknown((char *)&(member), sizeof(member))

static controller_t any_state;
static controller_outputs_t any_outputs;

static void set_any_leaves(axis_chart_t *self)
{
    self->power = Frama_C_unsigned_int_interval(0U, AXIS_POWER_FAULT);
    self->power_inverse = Frama_C_unsigned_int_interval(UINT32_MAX - AXIS_POWER_FAULT, UINT32_MAX);
    self->reference = Frama_C_unsigned_int_interval(0U, AXIS_REFERENCE_VERIFIED);
    self->reference_inverse =
        Frama_C_unsigned_int_interval(UINT32_MAX - AXIS_REFERENCE_VERIFIED, UINT32_MAX);
}

/* The trace holds any values before, as age_state() has it, and after. */
uint32_t any_axis_chart_dispatch(axis_chart_t *self, const axis_inputs_t *inputs,
                                 axis_event_t event)
{
    (void)inputs;
    (void)event;
    set_any_leaves(self);
    return Frama_C_unsigned_int_interval(0U, AXIS_ACTION_SET_POSITION);
}

void follow_axis_chart(void)
{
    axis_chart_t chart;
    axis_inputs_t inputs;
    uint32_t event = 0U;
    ANY(chart);
    set_any_leaves(&chart);
    inputs.is_fault_present = Frama_C_nondet(0, 1) != 0;
    inputs.is_switch_active = Frama_C_nondet(0, 1) != 0;
    inputs.is_confirmable = Frama_C_nondet(0, 1) != 0;
    ANY(event);
    const uint32_t actions = axis_chart_dispatch(&chart, &inputs, (axis_event_t)event);
    /*@ assert leaves: EVA_AXIS_LEAVES(&chart); */
    /*@ assert actions: actions <= AXIS_ACTION_SET_POSITION; */
}

void follow_notes(void)
{
    uint32_t numbers[4];
    cycle_t cycle = {.outputs = &any_outputs};
    ANY(numbers);
    ANY(any_state.last_event);
    ANY(any_state.sealed);
    ANY(any_outputs);
    any_outputs.event_count = Frama_C_unsigned_int_interval(0U, CONTROLLER_EVENTS);
    cycle.cause = (event_cause_t)numbers[0];
    cycle.peer = numbers[1];
    controller_note(&any_state, &cycle, (event_id_t)numbers[2], numbers[3], (int32_t)numbers[0]);
    /*@ assert room: any_outputs.event_count <= CONTROLLER_EVENTS; */
}
