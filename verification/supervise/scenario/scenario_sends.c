/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/scenario/scenario_sends.h"

#include "limits/requirement_limits.h"
#include "robot/kinematics.h"
#include "supervise/scenario/acts.h"
#include "supervise/scenario/prng.h"
#include "supervise/scenario/targets.h"

#include <math.h>

#define BEFORE_NM 20000000 /* Way before the target, on the needle's line. */
#define OTHER_PARTS 6U     /* One of so many orders is not of the theme of the play. */

void scenario_send(scenario_t *self, rig_t *rig, command_t command)
{
    command.id = 1000U + self->cycle;
    if (self->play == PLAY_RIVALS) {
        competing_peers_sign(&self->rivals, rig, &command);
    }
    rig->commands[rig->command_count] = command;
    rig->command_count++;
}

void scenario_send_phase(scenario_t *self, rig_t *rig, workphase_t phase)
{
    scenario_send(self, rig,
                  (command_t){.kind = (uint32_t)COMMAND_WORKPHASE,
                              .as.workphase = {.workphase = (uint32_t)phase}});
}

rigid_t scenario_some_target(scenario_t *self)
{
    const bool is_near = (self->play == PLAY_TAPS) && (self->adversary.wish == FOE_ASKS_NEAR);
    return is_near ? targets_near(self->robot, &self->random)
                   : targets_any(self->robot, &self->random);
}

/* An end of the way, or anywhere on it. */
static int32_t some_end(scenario_t *self, const axis_config_t *axis)
{
    const int32_t span = axis->target_maximum_ticks - axis->target_minimum_ticks;
    int32_t ticks = axis->target_minimum_ticks;
    switch (scenario_random_below(self, 4U)) {
    case 0:
        break;
    case 1:
        ticks = axis->target_maximum_ticks;
        break;
    case 2:
        ticks = axis->home_ticks + (int32_t)scenario_random_below(self, 21U) - 10;
        break;
    default:
        ticks += (int32_t)scenario_random_below(self, (uint32_t)span);
        break;
    }
    return ticks;
}

/* A target with some axes at an end of their way, and the entry point that decides its depth. */
static void send_corner(scenario_t *self, rig_t *rig)
{
    int32_t ticks[ROBOT_AXIS_MAX] = {0};
    joints_t joints;
    command_t target = {.kind = (uint32_t)COMMAND_TARGET};
    command_t entry = {.kind = (uint32_t)COMMAND_ENTRY};
    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        ticks[i] = some_end(self, &self->robot->axes[i]);
    }
    joints_from_ticks(self->robot, ticks, &joints);
    kinematics_forward(self->robot, &self->robot->probe, &joints, &target.as.pose.pose);
    rigid_set_identity(&entry.as.pose.pose);
    if (targets_entry(self->robot, &joints, &target.as.pose.pose,
                      &entry.as.pose.pose.translation)) {
        scenario_send(self, rig, entry);
    } else if ((self->play == PLAY_HANDS) || play_is_of_orders(self->play)) {
        const point_t before = {0, 0, -BEFORE_NM};
        entry.as.pose.pose.translation = rigid_apply(&target.as.pose.pose, &before);
        scenario_send(self, rig, entry);
    } else {
        /* It is asked for none. */
    }
    scenario_send(self, rig, target);
}

void scenario_send_target(scenario_t *self, rig_t *rig)
{
    if ((self->play == PLAY_CORNERS) || (self->play == PLAY_HANDS) ||
        play_is_of_orders(self->play)) {
        send_corner(self, rig);
    } else {
        scenario_send(self, rig,
                      (command_t){.kind = (uint32_t)COMMAND_TARGET,
                                  .as.pose = {.pose = scenario_some_target(self)}});
    }
}

/* Anywhere, or near where the axis stands, as one that is not homed is jogged. */
void scenario_send_jog(scenario_t *self, rig_t *rig)
{
    command_t command = {.kind = (uint32_t)COMMAND_JOG,
                         .as.jog = {.axis = scenario_random_below(self, self->robot->axis_count)}};
    const axis_config_t *const axis = &self->robot->axes[command.as.jog.axis];
    const int32_t span = axis->maximum_ticks - axis->minimum_ticks;
    if (scenario_random_below(self, 2U) == 0U) {
        command.as.jog.to_ticks =
            axis->minimum_ticks + (int32_t)scenario_random_below(self, (uint32_t)span);
    } else {
        command.as.jog.to_ticks = rig->outputs.snapshot.axes[command.as.jog.axis].position_ticks -
                                  (span / 20) +
                                  (int32_t)scenario_random_below(self, (uint32_t)span / 10U);
    }
    scenario_send(self, rig, command);
}

/* One of the acts for a single axis; its sender gives a requested press, if what is shown is true.
 */
void scenario_send_act(scenario_t *self, rig_t *rig)
{
    const command_t command = acts_choose(rig, &self->whim);
    scenario_send(self, rig, command);
    if ((command.kind == (uint32_t)COMMAND_CONFIRM_AXIS) && acts_is_shown_true(rig)) {
        rig_box(rig, "button press");
        self->wait_cycles = 2U * (LIMIT_CONFIRM_HOLD_US / LIMIT_CYCLE_US);
    }
}

/* Another probe, or lengths that none has: each up to a tenth of its range from the file's. */
void scenario_send_probe(scenario_t *self, rig_t *rig)
{
    const robot_t *const robot = self->robot;
    command_t command = {.kind = (uint32_t)COMMAND_PROBE,
                         .as.probe = {.count = robot->probe_length_count}};
    for (uint32_t i = 0U; i < robot->probe_length_count; i++) {
        const int32_t range_nm =
            robot->probe_maximum.length_nm[i] - robot->probe_minimum.length_nm[i];
        command.as.probe.lengths_nm[i] =
            robot->probe.length_nm[i] - (range_nm / 10) +
            (int32_t)prng_below(&self->whim, (uint32_t)(range_nm / 5) + 1U);
    }
    scenario_send(self, rig, command);
}

/* An order of any mode, mostly that of the play; WORKPHASE_COUNT: wherever it is. */
void scenario_send_order(scenario_t *self, rig_t *rig, workphase_t phase)
{
    const command_kind_t theme = play_theme(self->play);
    const bool is_of_theme = (theme != COMMAND_NONE) && !scenario_has_whim(self, OTHER_PARTS);
    const orders_wish_t wish = {phase, is_of_theme ? theme : COMMAND_NONE};
    command_t command;
    if (orders_choose(&self->orders, rig, wish, &self->whim, &command)) {
        scenario_send(self, rig, command);
    }
}

/* At the target, on the way there, or while it is drawn out already. */
bool scenario_wants_out(scenario_t *self, const snapshot_t *shown)
{
    const bool is_there = shown->next_step == (uint32_t)NEXT_STEP_NOTHING;
    return (shown->workphase == (uint32_t)WORKPHASE_MOVE_TO_TARGET) &&
           scenario_has_whim(self, is_there ? 3U : 40U);
}

/* Positions that an operator has saved: where the axes are, or anywhere. */
void scenario_send_saved(scenario_t *self, rig_t *rig)
{
    const bool is_true = !scenario_has_whim(self, 8U);
    const uint32_t axes = ((uint32_t)1U << self->robot->axis_count) - 1U;
    command_t command = {.kind = (uint32_t)COMMAND_RESTORE,
                         .as.positions = {.axes = 1U + prng_below(&self->whim, axes)}};
    double truth[ROBOT_AXIS_MAX];
    box_true_positions(&rig->box, truth);
    for (uint32_t i = 0U; i < self->robot->axis_count; i++) {
        const axis_config_t *const axis = &self->robot->axes[i];
        const uint32_t span = (uint32_t)(axis->maximum_ticks - axis->minimum_ticks);
        command.as.positions.ticks[i] =
            is_true ? (int32_t)lround(truth[i])
                    : (axis->minimum_ticks + (int32_t)prng_below(&self->whim, span));
    }
    self->has_fault = is_true ? self->has_fault : 1U;
    scenario_send(self, rig, command);
}
