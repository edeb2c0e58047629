/* SPDX-License-Identifier: Apache-2.0 */
/* Parts of a cycle that precede controller_drive() and may arm, disarm or stop, each from any sound
 * state; SOUNDNESS.md names those that are not among them. What they leave is what
 * controller_drive() begins with (prove_controller_drive.c). */
#include "prove.h"

#include "controller/controller_facts.h"
#include "controller/cycle/controller_move.h"
#include "controller/orders/controller_authority.h"
#include "controller/orders/controller_workphase.h"
#include "procedure/command_kinds.h"

static controller_t controller;
static robot_t robot;
static controller_inputs_t inputs;
static controller_outputs_t outputs;
static command_t command;
static const cycle_t cycle = {.robot = &robot, .inputs = &inputs, .outputs = &outputs};

#define AXES 2U

static void begin(void)
{
    controller_t any_controller;
    robot_t any_robot;
    controller_inputs_t any_inputs;
    controller = any_controller;
    robot = any_robot;
    inputs = any_inputs;
    outputs.answer_count = 0U;
    controller.sealed.axis_count = AXES;
    for (uint32_t i = 0U; i < AXES; i++) {
        controller.cards.slots[i] = i;
    }
    controller.sealed.pending.is_waiting = 0U; /* An answer that is owed decides nothing. */
}

/* As controller_check_memory() and controller_observe() leave the charts in each cycle. */
static bool are_charts_but_authority_sound(void)
{
    return estop_latch_chart_is_sound(&controller.estop) &&
           loop_guard_chart_is_sound(&controller.loop.chart) &&
           pedal_gate_chart_is_sound(&controller.pedal.chart) &&
           arming_chart_is_sound(&controller.procedure.arming) &&
           workphase_chart_is_sound(&controller.procedure.workphase);
}

static bool are_charts_sound(void)
{
    return are_charts_but_authority_sound() &&
           authority_chart_is_sound(&controller.authority.chart);
}

static bool is_armed(void)
{
    return procedure_is_armed(&controller.procedure);
}

/* Every armed order has a holder of authority. */
static bool is_order_held(void)
{
    return !is_armed() || authority_is_held(&controller.authority);
}

/* One of the facts for which no drive leaves. */
static bool is_stopped(void)
{
    return !is_armed() || !pedal_gate_is_open(&controller.pedal);
}

/* A command about authority, of any kind. */
static void obey_authority(answer_t *answer)
{
    if (command.kind == (uint32_t)COMMAND_TAKE) {
        (void)controller_obey_take(&controller, &cycle, &command, answer);
    } else if (command.kind == (uint32_t)COMMAND_RENEW) {
        (void)controller_obey_renew(&controller, &cycle, &command, answer);
    } else if (command.kind == (uint32_t)COMMAND_RELEASE) {
        (void)controller_obey_release(&controller, &cycle, &command, answer);
    } else {
        assume(command.kind == (uint32_t)COMMAND_REQUEST);
        (void)controller_obey_request(&controller, &cycle, &command, answer);
    }
}

/* Facts before one of the ways in which authority is lost. */
typedef struct {
    bool was_armed;
    bool was_held;
    bool was_order_held;
    bool was_stopped;
} before_t;

static before_t before_a_loss(void)
{
    const before_t before = {.was_armed = is_armed(),
                             .was_held = authority_is_held(&controller.authority),
                             .was_order_held = is_order_held(),
                             .was_stopped = is_stopped()};
    return before;
}

static void prove_disarmed(const before_t *before)
{
    PROVE(IMPLIES(before->was_held && !authority_is_held(&controller.authority), !is_armed()),
          "SWR-AUTH-270: authority that is lost disarms in that cycle, from any sound state");
    PROVE(IMPLIES(before->was_order_held, is_order_held()),
          "SWR-AUTH-270: no order stays armed without a holder");
    PROVE(IMPLIES(is_armed(), before->was_armed), "SWR-AUTH-270: nothing is armed by it");
    PROVE(IMPLIES(before->was_stopped, is_stopped()),
          "SWR-PERMIT-270: what was stopped stays stopped");
}

/* The chart of authority may be damaged: it is looked at here. */
void prove_SWR_AUTH_270_silence_or_a_damaged_chart_leaves_no_order_armed(void)
{
    begin();
    assume(are_charts_but_authority_sound());
    const bool was_sound = authority_chart_is_sound(&controller.authority.chart);
    const bool is_holder_silent =
        (inputs.silent_sources >> (controller.authority.sealed.holder.source % 32U)) & 1U;
    const before_t before = before_a_loss();

    controller_observe_authority(&controller, &cycle);

    prove_disarmed(&before);
    PROVE(authority_chart_is_sound(&controller.authority.chart),
          "SWR-AUTH-270: the rest of the cycle may rely on the chart");
    PROVE(IMPLIES(!was_sound, !is_armed()), "SWR-AUTH-270: a damaged chart disarms");
    POSSIBLE(was_sound && is_holder_silent && before.was_armed && before.was_held && !is_armed(),
             "the holder of an armed order is silent");
    POSSIBLE(was_sound && !is_holder_silent && before.was_armed && before.was_held && !is_armed(),
             "the holder of an armed order misses its renewal");
    POSSIBLE(!was_sound && before.was_armed, "an order is armed under a damaged chart");
}

void prove_SWR_AUTH_270_a_release_leaves_no_order_armed(void)
{
    command_t any_command;
    answer_t answer;
    begin();
    assume(are_charts_sound());
    command = any_command;
    const before_t before = before_a_loss();

    obey_authority(&answer);

    prove_disarmed(&before);
    POSSIBLE((command.kind == (uint32_t)COMMAND_RELEASE) && before.was_armed && before.was_held &&
                 !is_armed(),
             "the holder of an armed order releases authority");
}

void prove_SWR_AUTH_270_a_grant_leaves_no_order_armed(void)
{
    begin();
    assume(are_charts_sound());
    const before_t before = before_a_loss();

    controller_grant(&controller, &cycle);

    prove_disarmed(&before);
    PROVE(!authority_is_held(&controller.authority), "SWR-AUTH-270: nobody holds it after a grant");
    POSSIBLE(before.was_armed && before.was_held && !is_armed(),
             "authority is granted to another client while an order is armed");
}

void prove_SWR_PERMIT_270_a_stop_disarms_and_no_workphase_starts_a_drive(void)
{
    command_t any_command;
    answer_t answer;
    begin();
    assume(are_charts_sound());
    command = any_command;
    command.kind = (uint32_t)COMMAND_WORKPHASE;
    const bool was_armed = is_armed();
    const bool was_stopped = is_stopped();
    const bool was_open = pedal_gate_is_open(&controller.pedal);
    const bool was_pulled = controller.estop.state == ESTOP_LATCH_STATE_PULLED;
    const bool is_stop = command_kinds_is_stop(&command);

    (void)controller_obey_workphase(&controller, &cycle, &command, &answer);

    PROVE(IMPLIES(is_stop, !is_armed()), "SWR-PERMIT-270: STOP and EMERGENCY disarm");
    PROVE(IMPLIES(was_stopped, is_stopped()),
          "SWR-PERMIT-270: an order that is armed waits for a new press of the pedal");
    PROVE(IMPLIES(!was_open, !pedal_gate_is_open(&controller.pedal)),
          "SWR-PERMIT-270: no workphase opens the gate of the pedal");
    PROVE(IMPLIES(was_pulled, controller.estop.state == ESTOP_LATCH_STATE_PULLED),
          "SWR-PERMIT-270: no workphase clears a pulled e-stop");
    POSSIBLE(was_armed && was_open && is_stop, "a stop while an order moves");
    POSSIBLE(!was_armed && is_armed(), "a workphase arms an order");
}

void prove_SWR_PERMIT_270_the_armed_order_undoes_no_stop(void)
{
    mode_result_t result;
    begin();
    assume(are_charts_sound());
    const bool was_order_held = is_order_held();
    const bool was_armed = is_armed();
    const bool was_stopped = is_stopped();
    const bool was_open = pedal_gate_is_open(&controller.pedal);
    const estop_latch_state_t estop = controller.estop.state;
    const authority_state_t authority = controller.authority.chart.state;

    controller_move(&controller, &cycle, &result);

    PROVE(IMPLIES(is_armed(), was_armed), "SWR-PERMIT-270: the order does not arm itself");
    PROVE(IMPLIES(was_stopped, is_stopped()), "SWR-PERMIT-270: what was stopped stays stopped");
    PROVE(IMPLIES(pedal_gate_is_open(&controller.pedal), was_open),
          "SWR-PERMIT-270: the gate of the pedal stays shut");
    PROVE(controller.estop.state == estop, "SWR-PERMIT-270: the e-stop stays as it is");
    PROVE(controller.authority.chart.state == authority, "SWR-AUTH-270: authority stays as it is");
    PROVE(IMPLIES(was_order_held, is_order_held()),
          "SWR-AUTH-270: no order is armed without a holder");
    POSSIBLE(was_armed && !is_armed(), "an order that is done");
}
