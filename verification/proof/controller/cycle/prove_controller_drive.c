/* SPDX-License-Identifier: Apache-2.0 */
/* Every drive that leaves in a cycle, for any state of the controller, any table of a robot, any
 * inputs and any requests. Permit, charts' state, axes and motors' words are the product's own
 * code; frames, the limits that axes share, the needle and the cap of speed are contracts, which
 * are proved where they belong. */
#include "prove.h"

#include "card/card_dialect.h"
#include "contract/drive_neighbours.h"
#include "controller/controller_facts.h"
#include "controller/cycle/controller_drive.h"
#include "safety/needle.h"

static controller_t controller;
static robot_t robot;
static controller_inputs_t inputs;
static controller_outputs_t outputs;

/* Everything the sentence rests on, of the same for every axis. */
static bool is_machine_ready(uint32_t guards)
{
    const uint32_t unread =
        inputs.unread & (permit_input(BOX_INPUT_PEDAL) | permit_input(BOX_INPUT_ESTOP) |
                         permit_input(BOX_INPUT_SCANNER));
    return (controller.estop.state == ESTOP_LATCH_STATE_CLEAR) &&
           (controller.loop.chart.state != LOOP_GUARD_STATE_STOPPED) &&
           (controller.pedal.chart.state == PEDAL_GATE_STATE_PRESSED) &&
           (inputs.scanner_active == 0U) && (unread == 0U) &&
           (controller.procedure.arming.state != ARMING_STATE_NONE) &&
           (controller.sealed.table_damage == 0U) &&
           ((inputs.dialect == (uint32_t)CARD_DIALECT_OWN) || (inputs.is_dialect_accepted != 0U)) &&
           guards_have(guards, GUARD_LINKED);
}

static bool is_axis_ready(uint32_t index, const card_drive_t *request)
{
    const axis_t *const axis = &controller.axes[index];
    const axis_config_t *const config = &robot.axes[index];
    const bool is_up = motor_model_is_upwards(config, request);
    const bool is_beyond = is_up ? (axis->sealed.encoder.position_ticks >= config->maximum_ticks)
                                 : (axis->sealed.encoder.position_ticks <= config->minimum_ticks);
    const bool is_upper = config->limit_switch == (uint8_t)LIMIT_SWITCH_UPPER;
    return (axis->chart.power == AXIS_POWER_ENABLED) &&
           (axis_is_homed(axis) || drive_neighbours.may_be_unhomed) &&
           !((axis->sealed.limit_switches != 0U) && (is_up == is_upper)) &&
           !(axis_is_homed(axis) && is_beyond) &&
           ((drive_neighbours.at_coupled_limit & (1U << index)) == 0U) &&
           !(((drive_neighbours.heeding_needle & (1U << index)) != 0U) &&
             drive_neighbours.is_needle_in_way[index]) &&
           !drive_neighbours.is_too_fast[index];
}

/* Its frame has no drive word then, whatever else it says (card/prove_card_frame.c). */
static bool is_off(const card_drive_t *drive)
{
    return drive->mode == (uint32_t)CARD_DRIVE_OFF;
}

/* As controller_check_memory() leaves the charts in each cycle. */
static bool are_charts_sound(void)
{
    return estop_latch_chart_is_sound(&controller.estop) &&
           loop_guard_chart_is_sound(&controller.loop.chart) &&
           pedal_gate_chart_is_sound(&controller.pedal.chart) &&
           arming_chart_is_sound(&controller.procedure.arming) &&
           workphase_chart_is_sound(&controller.procedure.workphase);
}

/* The cards of the axes stand in a row, from the last slot down; what the others hold is any. */
static void place_cards(uint32_t axis_count)
{
    controller.sealed.axis_count = axis_count;
    controller.cards.named_slots |= controller.cards.sensor_slots & CARD_EVERY_SLOT;
    for (uint32_t i = 0U; i < axis_count; i++) {
        const uint32_t slot = (CARD_SLOT_COUNT - 1U) - i;
        controller.cards.slots[i] = slot;
        controller.cards.named_slots |= (uint32_t)1U << slot;
        controller.cards.sensor_slots &= ~((uint32_t)1U << slot);
    }
    controller.cards.sensor_slots &= CARD_EVERY_SLOT;
    controller.sealed.unexpected_cards &= CARD_EVERY_SLOT;
}

static void prove_axis(uint32_t index, uint32_t guards, const card_drive_t *request)
{
    const sent_command_t *const sent = &drive_neighbours.sent[controller.cards.slots[index]];
    const bool is_permitted = (sent->command.system_state & CARD_SYSTEM_PERMIT) != 0U;

    PROVE(sent->count == 1U, "SWR-PERMIT-200: each card of an axis is sent one frame");
    PROVE(IMPLIES(!is_off(&sent->command.drive),
                  is_machine_ready(guards) && is_axis_ready(index, request)),
          "SWR-PERMIT-200: no drive leaves unless nothing stands against it");
    PROVE(IMPLIES(!is_off(&sent->command.drive), drive_neighbours.hand_reasons == 0U),
          "SWR-COOP-008: no drive leaves while anything stands against a hand");
    PROVE(IMPLIES(!is_off(&sent->command.drive) && drive_neighbours.is_waiting_for_rotation,
                  (index != robot.needle_axis) ||
                      !motor_model_is_upwards(&robot.axes[index], request)),
          "SWR-STEER-006: the needle goes no deeper while its rotation does not follow its law");
    PROVE(IMPLIES(is_permitted, is_machine_ready(guards)),
          "SWR-PERMIT-200: no permit is reported unless nothing stands against it");
    PROVE(IMPLIES((sent->command.control & CARD_CONTROL_AMPLIFIER) != 0U, is_permitted),
          "SWR-PERMIT-200: no amplifier has power without the permit");
    PROVE(IMPLIES(!is_off(&sent->command.drive),
                  (sent->command.drive.mode == request->mode) &&
                      (sent->command.drive.direction == request->direction)),
          "SWR-PERMIT-200: a drive goes the way that was asked for");
    POSSIBLE(!is_off(&sent->command.drive), "a drive leaves");
}

static void prove_drive(uint32_t axis_count)
{
    controller_t any_controller;
    robot_t any_robot;
    controller_inputs_t any_inputs;
    drive_neighbours_t any_neighbours;
    card_drive_t requests[ROBOT_AXIS_MAX];
    uint32_t guards;
    const cycle_t cycle = {.robot = &robot, .inputs = &inputs, .outputs = &outputs};

    controller = any_controller;
    robot = any_robot;
    inputs = any_inputs;
    drive_neighbours = any_neighbours;
    for (uint32_t i = 0U; i < CARD_SLOT_COUNT; i++) {
        drive_neighbours.sent[i].count = 0U;
    }
    drive_neighbours.axes = controller.axes;
    drive_neighbours.records = controller.records;
    drive_neighbours.frames = outputs.frames;
    place_cards(axis_count);
    assume(are_charts_sound());

    controller_drive(&controller, &cycle, guards, requests);

    for (uint32_t i = 0U; i < axis_count; i++) {
        prove_axis(i, guards, &requests[i]);
    }
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        bool is_of_axis = false;
        for (uint32_t i = 0U; i < axis_count; i++) {
            is_of_axis = is_of_axis || (controller.cards.slots[i] == slot);
        }
        const sent_command_t *const sent = &drive_neighbours.sent[slot];
        PROVE(IMPLIES(!is_of_axis && (sent->count > 0U),
                      is_off(&sent->command.drive) &&
                          ((sent->command.system_state & CARD_SYSTEM_PERMIT) == 0U)),
              "SWR-PERMIT-200: a card without an axis is sent no drive and no permit");
    }
}

void prove_SWR_PERMIT_200_no_drive_leaves_without_its_permit_of_1_axis(void)
{
    prove_drive(1U);
}

void prove_SWR_PERMIT_200_no_drive_leaves_without_its_permit_of_7_axes(void)
{
    prove_drive(7U);
}

void prove_SWR_PERMIT_200_no_drive_leaves_without_its_permit_of_10_axes(void)
{
    prove_drive(10U);
}
