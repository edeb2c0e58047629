/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/scenario/hand_deeds.h"

#include "charts/arming_chart.h"
#include "safety/needle.h"
#include "supervise/scenario/scenario_deeds.h"
#include "supervise/scenario/scenario_sends.h"

static void command(scenario_t *self, rig_t *rig, command_kind_t kind)
{
    scenario_send(self, rig, (command_t){.kind = (uint32_t)kind});
}

static bool is_out(const rig_t *rig)
{
    return needle_is_out(rig->box.robot, rig->controller.axes);
}

static bool is_doubtful(const rig_t *rig)
{
    return rig->outputs.snapshot.forces[FORCE_CHANNEL_HAND].doubts != 0U;
}

/* With the needle out; a careful operator sees to it that nobody touches the handle. */
static void zero(scenario_t *self, rig_t *rig)
{
    if (self->hands.is_careful && !hands_are_away(&self->hands, rig)) {
        hands_leave(&self->hands, rig);
        self->wait_cycles = 400U + scenario_random_below(self, 300U);
    } else {
        command(self, rig, COMMAND_ZERO_FORCE);
        self->wait_cycles = scenario_has_whim(self, 8U) ? 10U : 300U;
    }
}

/* Somehow, now and then by more than the needle can be bent. */
static void steer(scenario_t *self, rig_t *rig)
{
    const uint32_t most_per_km = rig->box.robot->steering.most_per_km;
    scenario_send(
        self, rig,
        (command_t){
            .kind = (uint32_t)COMMAND_STEER,
            .as.steering = {.method = scenario_random_below(self, STEERING_METHOD_COUNT),
                            .curvature_per_km =
                                scenario_random_below(self, most_per_km + (most_per_km / 8U) + 1U),
                            .direction_deg = (int32_t)scenario_random_below(self, 721U) - 360}});
}

static void aim(scenario_t *self, rig_t *rig)
{
    if (is_doubtful(rig) && is_out(rig) && !scenario_has_whim(self, 12U)) {
        zero(self, rig);
    } else if (scenario_has_whim(self, 8U)) {
        scenario_send_target(self, rig);
    } else if (scenario_has_whim(self, 4U)) {
        command(self, rig, COMMAND_ALIGN);
    } else if (scenario_has_whim(self, 4U)) {
        steer(self, rig);
    } else {
        scenario_send_phase(self, rig, WORKPHASE_MOVE_TO_TARGET);
    }
}

/* The needle is out or in, and nothing is armed. */
static void go_on(scenario_t *self, rig_t *rig)
{
    if (is_doubtful(rig) && !scenario_has_whim(self, 8U)) {
        if (is_out(rig)) {
            zero(self, rig);
        } else {
            command(self, rig, COMMAND_RETRACT);
        }
    } else if (scenario_has_whim(self, 12U)) {
        command(self, rig, COMMAND_INSERT);
    } else if (scenario_has_whim(self, 12U)) {
        command(self, rig, COMMAND_RETRACT);
    } else if (scenario_has_whim(self, 12U)) {
        steer(self, rig);
    } else if (rig->outputs.snapshot.next_step == (uint32_t)NEXT_STEP_NOTHING) {
        scenario_send_phase(self, rig, WORKPHASE_TARGETING);
    } else {
        command(self, rig, COMMAND_COOPERATE);
    }
}

static void begin(scenario_t *self, rig_t *rig)
{
    const snapshot_t *const shown = &rig->outputs.snapshot;
    rig_box(rig, "pedal release");
    if ((shown->is_homed != 0U) && (shown->workphase == (uint32_t)WORKPHASE_TARGETING)) {
        aim(self, rig);
    } else if ((shown->is_homed != 0U) &&
               (shown->workphase == (uint32_t)WORKPHASE_MOVE_TO_TARGET)) {
        go_on(self, rig);
    } else {
        scenario_do_next_step(self, rig);
    }
}

void hand_deeds_do_order(scenario_t *self, rig_t *rig)
{
    const snapshot_t *const shown = &rig->outputs.snapshot;
    const bool is_move = shown->mode == (uint32_t)MODE_MOVE;
    if (shown->order == (uint32_t)ARMING_STATE_NONE) {
        begin(self, rig);
    } else if ((shown->order == (uint32_t)ARMING_STATE_WAITING) && is_move &&
               !scenario_has_whim(self, 12U)) {
        command(self, rig, COMMAND_COOPERATE);
    } else if (shown->order == (uint32_t)ARMING_STATE_WAITING) {
        rig_box(rig, scenario_has_whim(self, 8U) ? "pedal release" : "pedal press");
    } else if (scenario_has_whim(self, 30U)) {
        rig_box(rig, "pedal release");
    } else if (scenario_has_whim(self, 60U)) {
        command(self, rig, scenario_has_whim(self, 2U) ? COMMAND_COOPERATE : COMMAND_RETRACT);
    } else if (scenario_has_whim(self, 160U)) {
        scenario_send_phase(self, rig, WORKPHASE_STOP);
    } else {
        /* The hand goes on. */
    }
}

void hand_deeds_do_step(scenario_t *self, rig_t *rig)
{
    switch (rig->outputs.snapshot.next_step) {
    case NEXT_STEP_PUSH:
        rig_box(rig, "grip 800");
        rig_box(rig, "hand press");
        break;
    case NEXT_STEP_LET_GO:
        rig_box(rig, "hand release");
        break;
    default:
        command(self, rig, is_out(rig) ? COMMAND_ZERO_FORCE : COMMAND_RETRACT);
        break;
    }
}
