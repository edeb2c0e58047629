/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/controller.h"

#include "base/clear.h"
#include "base/contract.h"
#include "controller/cycle/controller_drive.h"
#include "controller/controller_events.h"
#include "controller/controller_facts.h"
#include "controller/controller_membranes.h"
#include "controller/memory/controller_memory.h"
#include "controller/cycle/controller_move.h"
#include "controller/orders/controller_obey.h"
#include "controller/cycle/controller_observe.h"
#include "controller/show/controller_show.h"
#include "limits/requirement_limits.h"
#include "robot/robot_cards.h"

#include <stddef.h>
#include <string.h>

static const char contract_module[] = "controller";

void controller_init(controller_t *self, const robot_t *robot)
{
    (void)memset(self, 0, sizeof *self);
    pedal_gate_init(&self->pedal);
    loop_guard_init(&self->loop);
    authority_init(&self->authority);
    estop_latch_init(&self->estop);
    procedure_init(&self->procedure);
    plan_init(&self->plan, robot);
    self->sealed.axis_count =
        (robot->axis_count <= ROBOT_AXIS_MAX) ? robot->axis_count : ROBOT_AXIS_MAX;
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
        axis_init(&self->axes[i]);
    }
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        link_init(&self->links[slot], robot_cards_type(robot, slot), robot->card_firmware);
    }
    force_sensor_init(&self->force, &robot->force);
    robot_cards_find(&self->cards, robot, self->sealed.axis_count);
    robot_cards_bound(&self->cards); /* The table is not checked yet. */
    controller_clear_membranes(self);
    self->refused_cycle = (UINT32_MAX - LIMIT_REFUSED_VALUES_MS) + 1U;
    controller_seal(self);
}

static void begin(controller_t *self, const cycle_t *cycle)
{
    const trajectory_list_t *const list = &self->mode.sealed.list;
    self->sealed.has_started = 1U;
    controller_note(self, cycle, EVENT_STARTED, 0U, (int32_t)self->sealed.kept_verdict);
    if (list->is_whole != 0U) {
        controller_note(self, cycle, EVENT_TRAJECTORY_HELD, 0U, (int32_t)list->count);
    }
}

void controller_step(controller_t *self, const robot_t *robot, const controller_inputs_t *inputs,
                     controller_outputs_t *outputs)
{
    REQUIRE(100U, inputs->command_count <= CONTROLLER_COMMANDS);
    const cycle_t cycle = {.robot = robot,
                           .inputs = inputs,
                           .outputs = outputs,
                           .cause = EVENT_CAUSE_NONE,
                           .peer = 0U};
    mode_result_t result;
    /* The rest is written, or cleared, by controller_show() and controller_drive(). */
    clear_aligned_words((uint8_t *)outputs, offsetof(controller_outputs_t, snapshot));
    controller_check_memory(self, &cycle);
    if (self->sealed.has_started == 0U) {
        begin(self, &cycle);
    }
    self->sealed.time_us += inputs->elapsed_us;
    controller_observe(self, &cycle);
    controller_obey(self, &cycle);
    controller_move(self, &cycle, &result);
    const uint32_t guards = controller_facts(self, &cycle);
    controller_drive(self, &cycle, guards, result.requests);
    controller_look_ahead(self, &cycle, guards);
    controller_show(self, &cycle, guards);
    self->sealed.cycle++;
    controller_seal(self);
}
