/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/scenario/scenario_deeds.h"

#include "charts/arming_chart.h"
#include "limits/requirement_limits.h"
#include "supervise/scenario/acts.h"
#include "supervise/scenario/hand_deeds.h"
#include "supervise/scenario/scenario_sends.h"

#define OTHER_PARTS 6U   /* One of so many orders is not of the theme of the play. */
#define NEEDLE_PARTS 12  /* Part of its way that the needle goes in before a sweep. */
#define SWEEP_FACTOR 32U /* A sweep is given so much longer than any other order. */

void scenario_do_anything(scenario_t *self, rig_t *rig)
{
    switch (scenario_random_below(self, 6U)) {
    case 0:
        scenario_send_phase(self, rig, (workphase_t)(1U + scenario_random_below(self, 8U)));
        break;
    case 1:
        scenario_send_jog(self, rig);
        break;
    case 2:
        scenario_send(self, rig,
                      (command_t){.kind = (uint32_t)COMMAND_TARGET,
                                  .as.pose = {.pose = scenario_some_target(self)}});
        break;
    case 3:
        rig_box(rig, "pedal press");
        break;
    case 4:
        rig_box(rig, (scenario_random_below(self, 2U) == 0U) ? "pedal release" : "estop reset");
        break;
    default:
        scenario_send_phase(self, rig, WORKPHASE_MOVE_TO_TARGET);
        break;
    }
    if (scenario_has_whim(self, 8U)) {
        scenario_send(self, rig, (command_t){.kind = (uint32_t)COMMAND_RETRACT});
    } else if (scenario_has_whim(self, 8U)) {
        scenario_send(self, rig, (command_t){.kind = (uint32_t)COMMAND_ACCEPT_ENTRY});
    } else if (scenario_has_whim(self, 8U)) {
        scenario_send_saved(self, rig);
    } else if (scenario_has_whim(self, 8U)) {
        scenario_send_act(self, rig);
    } else if (scenario_has_whim(self, 16U)) {
        scenario_send_probe(self, rig);
    } else if (scenario_has_whim(self, 4U)) {
        scenario_send_order(self, rig, WORKPHASE_COUNT);
    } else {
        /* None of these. */
    }
}

static void send_jog_or_act(scenario_t *self, rig_t *rig)
{
    if (scenario_has_whim(self, 6U)) {
        scenario_send_act(self, rig);
    } else if (scenario_has_whim(self, 6U)) {
        scenario_send(self, rig, (command_t){.kind = (uint32_t)COMMAND_RETRACT});
    } else if (scenario_has_whim(self, 4U)) {
        scenario_send_order(self, rig, WORKPHASE_MANUAL);
    } else {
        scenario_send_jog(self, rig);
    }
}

/* One jog after the other, each under a pedal that is pressed anew and sometimes released. */
void scenario_do_jog(scenario_t *self, rig_t *rig)
{
    const snapshot_t *const shown = &rig->outputs.snapshot;
    if ((shown->workphase == (uint32_t)WORKPHASE_UNDEFINED) ||
        (shown->workphase == (uint32_t)WORKPHASE_EMERGENCY)) {
        scenario_send_phase(self, rig, WORKPHASE_START_UP);
    } else if (shown->workphase != (uint32_t)WORKPHASE_MANUAL) {
        scenario_send_phase(self, rig, WORKPHASE_MANUAL);
    } else if (shown->order == (uint32_t)ARMING_STATE_NONE) {
        rig_box(rig, "pedal release");
        send_jog_or_act(self, rig);
    } else if (shown->order == (uint32_t)ARMING_STATE_WAITING) {
        rig_box(rig, "pedal press");
    } else if (scenario_random_below(self, 4U) == 0U) {
        rig_box(rig, "pedal release");
    } else {
        /* It goes on. */
    }
}

static void send_target_or_phase(scenario_t *self, rig_t *rig)
{
    if (rig->outputs.snapshot.workphase == (uint32_t)WORKPHASE_TARGETING) {
        self->wants_target = 0U;
        scenario_send_target(self, rig);
    } else {
        scenario_send_phase(self, rig, WORKPHASE_TARGETING);
    }
}

/* An operator who sees another place than is shown lets go, and homes again if that is allowed. */
static void confirm(scenario_t *self, rig_t *rig)
{
    if (acts_is_shown_true(rig)) {
        rig_box(rig, "button press");
        self->wait_cycles += (LIMIT_CONFIRM_HOLD_US / LIMIT_CYCLE_US);
    } else {
        scenario_send_phase(self, rig, WORKPHASE_START_UP);
    }
}

/* The step that the console asks for. */
void scenario_do_next_step(scenario_t *self, rig_t *rig)
{
    const snapshot_t *const shown = &rig->outputs.snapshot;
    if (scenario_wants_out(self, shown)) {
        scenario_send(self, rig, (command_t){.kind = (uint32_t)COMMAND_RETRACT});
        return;
    }
    switch (shown->next_step) {
    case NEXT_STEP_RELEASE_ESTOP:
        rig_box(rig, "estop reset");
        break;
    case NEXT_STEP_RELEASE_PEDAL:
        rig_box(rig, "pedal release");
        break;
    case NEXT_STEP_PRESS_PEDAL:
        rig_box(rig, "pedal press");
        break;
    case NEXT_STEP_SCANNER:
        rig_box(rig, "scanner off");
        break;
    case NEXT_STEP_PLANNING:
        scenario_send_phase(self, rig, WORKPHASE_PLANNING);
        break;
    case NEXT_STEP_CALIBRATION:
    case NEXT_STEP_REGISTER:
        scenario_send_phase(self, rig, WORKPHASE_CALIBRATION);
        if (shown->workphase == (uint32_t)WORKPHASE_CALIBRATION) {
            command_t command = {.kind = (uint32_t)COMMAND_REGISTRATION};
            rigid_set_identity(&command.as.registration.pose);
            scenario_send(self, rig, command);
        }
        break;
    case NEXT_STEP_NOTHING:
    case NEXT_STEP_PROGRAM_DONE:
        self->wants_target = 1U;
        scenario_send_phase(self, rig, WORKPHASE_TARGETING);
        break;
    case NEXT_STEP_TARGETING:
        scenario_send_phase(self, rig, WORKPHASE_TARGETING);
        break;
    case NEXT_STEP_MANUAL:
        scenario_send_phase(self, rig, WORKPHASE_MANUAL);
        break;
    case NEXT_STEP_RETRACT:
        scenario_send(self, rig, (command_t){.kind = (uint32_t)COMMAND_RETRACT});
        break;
    case NEXT_STEP_DRAPING:
        scenario_send(self, rig,
                      (command_t){.kind = (uint32_t)COMMAND_POSE,
                                  .as.pose_name = {.pose = (uint32_t)POSE_DRAPING}});
        break;
    case NEXT_STEP_PROBE:
        if (scenario_has_whim(self, 3U)) {
            scenario_send_phase(self, rig, WORKPHASE_START_UP);
        } else {
            scenario_send_probe(self, rig);
        }
        break;
    case NEXT_STEP_TARGET:
        if (scenario_has_whim(self, 12U)) {
            scenario_send_probe(self, rig);
        } else {
            send_target_or_phase(self, rig);
        }
        break;
    case NEXT_STEP_MOVE:
        if (self->wants_target != 0U) {
            send_target_or_phase(self, rig);
        } else {
            scenario_send_phase(self, rig, WORKPHASE_MOVE_TO_TARGET);
        }
        break;
    case NEXT_STEP_CONFIRM:
    case NEXT_STEP_PLACE:
    case NEXT_STEP_COMPARE:
        confirm(self, rig);
        break;
    case NEXT_STEP_STOP:
        scenario_send_phase(self, rig, WORKPHASE_STOP);
        break;
    case NEXT_STEP_WAIT:
        break;
    case NEXT_STEP_PUSH:
    case NEXT_STEP_LET_GO:
    case NEXT_STEP_ZERO_FORCE:
        hand_deeds_do_step(self, rig);
        break;
    case NEXT_STEP_AUTHORITY:
    case NEXT_STEP_GRANT:
        rig_box(rig, "pedal release");
        scenario_send(self, rig, (command_t){.kind = (uint32_t)COMMAND_TAKE});
        break;
    case NEXT_STEP_HOLD_PEDAL:
        if (scenario_random_below(self, (self->play == PLAY_INTERRUPTED) ? 2U : 8U) == 0U) {
            rig_box(rig, "pedal release");
        }
        break;
    default:
        scenario_send_phase(self, rig, WORKPHASE_START_UP);
        break;
    }
}

/* Every axis is homed, nothing is armed, and nothing is in the way of a jog. */
static bool is_free(const snapshot_t *shown)
{
    return (shown->is_homed != 0U) && (shown->order == (uint32_t)ARMING_STATE_NONE) &&
           ((shown->next_step == (uint32_t)NEXT_STEP_TARGETING) ||
            (shown->next_step == (uint32_t)NEXT_STEP_CALIBRATION) ||
            (shown->next_step == (uint32_t)NEXT_STEP_PLANNING) ||
            ((shown->next_step >= (uint32_t)NEXT_STEP_REGISTER) &&
             (shown->next_step <= (uint32_t)NEXT_STEP_NOTHING)));
}

/* The step that the console asks for, or jogs where it asks for none. */
void scenario_do_wish(scenario_t *self, rig_t *rig)
{
    self->wait_cycles = 20U + scenario_random_below(self, 120U);
    if ((self->adversary.wish < FOE_ASKS_JOGS) || !is_free(&rig->outputs.snapshot)) {
        scenario_do_next_step(self, rig);
    } else if (rig->outputs.snapshot.workphase != (uint32_t)WORKPHASE_MANUAL) {
        scenario_send_phase(self, rig, WORKPHASE_MANUAL);
    } else {
        rig_box(rig, "pedal release");
        scenario_send(self, rig, adversary_jog(&self->adversary, rig));
    }
}

/* In some cases the needle goes in before a sweep, which must then be refused, and out again. */
static bool moves_needle(scenario_t *self, rig_t *rig)
{
    const uint32_t needle = self->robot->needle_axis;
    const axis_config_t *const axis = &self->robot->axes[needle];
    const int32_t far_ticks = (axis->maximum_ticks - axis->minimum_ticks) / NEEDLE_PARTS;
    const bool is_in = rig->outputs.snapshot.axes[needle].position_ticks > (far_ticks / 2);
    const bool is_due =
        (self->play == PLAY_SWEEPS) && scenario_has_whim(self, is_in ? 2U : OTHER_PARTS);
    if (is_due && is_in) {
        scenario_send(self, rig, (command_t){.kind = (uint32_t)COMMAND_RETRACT});
    } else if (is_due) {
        scenario_send(self, rig,
                      (command_t){.kind = (uint32_t)COMMAND_JOG_BY,
                                  .as.jog_by = {.axis = needle, .by_ticks = far_ticks}});
    } else {
        /* It stays. */
    }
    return is_due;
}

/* The next order of a play without a theme: mostly in `phase`, or where targets are. */
static void wish_for(scenario_t *self, workphase_t phase, uint32_t parts)
{
    if (play_theme(self->play) == COMMAND_NONE) {
        self->wish = scenario_has_whim(self, parts) ? 0U : (uint32_t)phase;
    }
}

/* In TARGETING, or once a move has ended: an order there, or another target and its entry point. */
static void do_aiming_order(scenario_t *self, rig_t *rig)
{
    const snapshot_t *const shown = &rig->outputs.snapshot;
    const bool is_targeting = shown->workphase == (uint32_t)WORKPHASE_TARGETING;
    if (is_targeting && ((shown->has_entry == 0U) || scenario_has_whim(self, 4U))) {
        scenario_send_target(self, rig);
    } else if (is_targeting && scenario_has_whim(self, 4U)) {
        scenario_send_phase(self, rig, WORKPHASE_MOVE_TO_TARGET);
    } else if ((self->play == PLAY_PROGRAMS) && scenario_has_whim(self, OTHER_PARTS)) {
        scenario_send_phase(self, rig, WORKPHASE_TARGETING);
    } else {
        scenario_send_order(self, rig, (workphase_t)shown->workphase);
        wish_for(self, WORKPHASE_MANUAL, 3U);
    }
}

/* Towards the workphase of the next order, and that. */
static void do_order(scenario_t *self, rig_t *rig)
{
    const snapshot_t *const shown = &rig->outputs.snapshot;
    const bool is_manual = self->wish == (uint32_t)WORKPHASE_MANUAL;
    const bool is_aiming = (shown->workphase == (uint32_t)WORKPHASE_TARGETING) ||
                           (shown->workphase == (uint32_t)WORKPHASE_MOVE_TO_TARGET);
    rig_box(rig, "pedal release");
    if (is_manual && (shown->workphase == (uint32_t)WORKPHASE_MANUAL)) {
        if (!moves_needle(self, rig)) {
            scenario_send_order(self, rig, WORKPHASE_MANUAL);
        }
        wish_for(self, WORKPHASE_MANUAL, 6U);
    } else if (is_manual && (shown->is_homed != 0U)) {
        scenario_send_phase(self, rig, WORKPHASE_MANUAL);
    } else if (!is_manual && is_aiming && (shown->is_homed != 0U)) {
        do_aiming_order(self, rig);
    } else {
        scenario_do_next_step(self, rig);
    }
}

/* One order of any mode after the other; some give way to another one, and some to a stop. */
void scenario_do_mode(scenario_t *self, rig_t *rig)
{
    const snapshot_t *const shown = &rig->outputs.snapshot;
    const uint32_t rarer = (self->play == PLAY_SWEEPS) ? SWEEP_FACTOR : 1U;
    if (self->orders.rows != 0U) {
        return;
    }
    if (shown->order == (uint32_t)ARMING_STATE_NONE) {
        do_order(self, rig);
    } else if ((shown->workphase == (uint32_t)WORKPHASE_MOVE_TO_TARGET) &&
               scenario_has_whim(self, 40U)) {
        scenario_send_order(self, rig, WORKPHASE_MOVE_TO_TARGET);
    } else if (shown->order == (uint32_t)ARMING_STATE_WAITING) {
        rig_box(rig, scenario_has_whim(self, 8U) ? "pedal release" : "pedal press");
    } else if (scenario_has_whim(self, 24U * rarer)) {
        rig_box(rig, "pedal release");
    } else if (scenario_has_whim(self, 80U * rarer)) {
        scenario_send_order(self, rig, WORKPHASE_COUNT);
    } else if (scenario_has_whim(self, 160U * rarer)) {
        scenario_send_phase(self, rig, WORKPHASE_STOP);
    } else {
        /* It goes on. */
    }
}

/* Now and then what the console asks for; in a play with a theme once nothing is armed. */
bool scenario_does_next_step(scenario_t *self, const snapshot_t *shown)
{
    return ((play_theme(self->play) == COMMAND_NONE) ||
            (shown->order == (uint32_t)ARMING_STATE_NONE)) &&
           (scenario_random_below(self, 12U) == 0U);
}
