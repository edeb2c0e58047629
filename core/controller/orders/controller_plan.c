/* SPDX-License-Identifier: Apache-2.0 */
#include "controller/orders/controller_plan.h"

#include "controller/controller_facts.h"
#include "controller/controller_order.h"
#include "robot/probe.h"
#include "safety/needle.h"

#include <string.h>

/* The plan of a running move does not change. */
static status_t judge_targeting(const controller_t *self, const command_t *command)
{
    status_t status = STATUS_OK;
    if (procedure_is_armed(&self->procedure)) {
        status = STATUS_MOTION_ARMED;
    } else if (!controller_is_of_workphase(self, command)) {
        status = STATUS_WRONG_WORKPHASE;
    } else {
        status = STATUS_OK;
    }
    return status;
}

status_t controller_obey_registration(controller_t *self, const cycle_t *cycle,
                                      const command_t *command, answer_t *answer)
{
    (void)answer;
    if (!controller_is_of_workphase(self, command)) {
        return STATUS_WRONG_WORKPHASE;
    }
    const command_registration_t *const sent = command_as_registration(command);
    if (sent->use >= REGISTRATION_USE_COUNT) {
        return STATUS_UNKNOWN_COMMAND;
    }
    const plan_origin_t origin = {.source = command->source,
                                  .peer = command->peer,
                                  .cycle = self->sealed.cycle,
                                  .ignores_rotation =
                                      sent->use == (uint32_t)REGISTRATION_TRANSLATION};
    const status_t status = plan_register(&self->plan, cycle->robot, &sent->pose, &origin);
    if (status == STATUS_OK) {
        controller_note(self, cycle, EVENT_REGISTERED, 0U, 0);
    }
    if ((status == STATUS_OK) && origin.ignores_rotation) {
        controller_note(self, cycle, EVENT_ROTATION_IGNORED, 0U, 0);
    }
    return status;
}

/* A needle that is in was led there by the probe that was sent before. */
static status_t judge_probe(const controller_t *self, const cycle_t *cycle,
                            const command_t *command, const probe_t *probe)
{
    status_t status = STATUS_PROBE_LENGTH;
    if (command_as_probe(command)->count != cycle->robot->probe_length_count) {
        status = STATUS_PROBE_LENGTH;
    } else if (!controller_is_of_workphase(self, command)) {
        status = STATUS_WRONG_WORKPHASE;
    } else if (procedure_is_armed(&self->procedure)) {
        status = STATUS_NOT_AT_REST;
    } else if (!needle_is_out(cycle->robot, self->axes)) {
        status = STATUS_NEEDLE_IN;
    } else {
        status = probe_judge(cycle->robot, probe);
    }
    return status;
}

status_t controller_obey_probe(controller_t *self, const cycle_t *cycle, const command_t *command,
                               answer_t *answer)
{
    (void)answer;
    probe_t probe;
    const command_probe_t *const sent = command_as_probe(command);
    (void)memcpy(probe.length_nm, sent->lengths_nm, sizeof probe.length_nm);
    const status_t status = judge_probe(self, cycle, command, &probe);
    if (status == STATUS_OK) {
        plan_set_probe(&self->plan, &probe);
        controller_note(self, cycle, EVENT_PROBE_TAKEN, 0U, 0);
        for (uint32_t i = 0U; i < sent->count; i++) {
            controller_note(self, cycle, EVENT_PROBE_LENGTH, i, probe.length_nm[i]);
        }
    }
    return status;
}

status_t controller_obey_target(controller_t *self, const cycle_t *cycle, const command_t *command,
                                answer_t *answer)
{
    const status_t judged = judge_targeting(self, command);
    if (judged != STATUS_OK) {
        return judged;
    }
    int32_t ticks[ROBOT_AXIS_MAX];
    controller_positions(self, ticks);
    const solution_t result =
        plan_set_target(&self->plan, cycle->robot, ticks, &command_as_pose(command)->pose);
    controller_blame(answer, &result);
    if (result.status == STATUS_OK) {
        answer->as.pose.pose = self->plan.scanner_target;
        target_way_take(&self->way, cycle->robot, ticks, self->plan.target_ticks);
        controller_note(self, cycle, EVENT_TARGET_ACCEPTED, 0U, 0);
    }
    return result.status;
}

/* An entry point that is not refused is that of the targets to come. */
static status_t take_entry(controller_t *self, const cycle_t *cycle, status_t status,
                           answer_t *answer)
{
    if (status == STATUS_OK) {
        answer->as.point.point = self->plan.entry;
        controller_note(self, cycle, EVENT_ENTRY_TAKEN, 0U, 0);
    }
    return status;
}

status_t controller_obey_entry(controller_t *self, const cycle_t *cycle, const command_t *command,
                               answer_t *answer)
{
    const status_t judged = judge_targeting(self, command);
    return (judged == STATUS_OK)
               ? take_entry(self, cycle,
                            plan_set_entry(&self->plan, &command_as_pose(command)->pose), answer)
               : judged;
}

status_t controller_obey_accept_entry(controller_t *self, const cycle_t *cycle,
                                      const command_t *command, answer_t *answer)
{
    const status_t judged = judge_targeting(self, command);
    return (judged == STATUS_OK) ? take_entry(self, cycle, plan_accept_entry(&self->plan), answer)
                                 : judged;
}

static plan_proposer_t proposer_of(const controller_t *self, const command_t *command)
{
    const plan_proposer_t proposer = {.peer = command->peer, .cycle = self->sealed.cycle};
    return proposer;
}

static status_t note_proposal(controller_t *self, const cycle_t *cycle, const command_t *command,
                              status_t status)
{
    if ((status == STATUS_OK) && !controller_is_unlogged(command)) {
        controller_note(self, cycle, EVENT_PROPOSAL, command->kind, 0);
    }
    return status;
}

status_t controller_obey_propose_registration(controller_t *self, const cycle_t *cycle,
                                              const command_t *command, answer_t *answer)
{
    (void)answer;
    const plan_proposer_t proposer = proposer_of(self, command);
    const rigid_t *const pose = &command_as_seen_pose(command)->pose;
    return note_proposal(self, cycle, command,
                         plan_propose_registration(&self->plan, cycle->robot, pose, &proposer));
}

status_t controller_obey_propose_entry(controller_t *self, const cycle_t *cycle,
                                       const command_t *command, answer_t *answer)
{
    (void)answer;
    const plan_proposer_t proposer = proposer_of(self, command);
    const rigid_t *const pose = &command_as_seen_pose(command)->pose;
    return note_proposal(self, cycle, command,
                         plan_propose_entry(&self->plan, cycle->robot, pose, &proposer));
}

status_t controller_obey_propose_target(controller_t *self, const cycle_t *cycle,
                                        const command_t *command, answer_t *answer)
{
    (void)answer;
    const plan_proposer_t proposer = proposer_of(self, command);
    const rigid_t *const pose = &command_as_seen_pose(command)->pose;
    return note_proposal(self, cycle, command,
                         plan_propose_target(&self->plan, cycle->robot, pose, &proposer));
}

status_t controller_obey_withdraw(controller_t *self, const cycle_t *cycle,
                                  const command_t *command, answer_t *answer)
{
    (void)answer;
    const uint32_t withdrawn = command_as_withdrawal(command)->of;
    plan_part_t part = PLAN_ENTRY;
    bool is_known = true;
    switch (withdrawn) {
    case (uint32_t)COMMAND_ENTRY:
        break;
    case (uint32_t)COMMAND_PROPOSE_REGISTRATION:
        part = PLAN_PROPOSED_REGISTRATION;
        break;
    case (uint32_t)COMMAND_PROPOSE_ENTRY:
        part = PLAN_PROPOSED_ENTRY;
        break;
    case (uint32_t)COMMAND_PROPOSE_TARGET:
        part = PLAN_PROPOSED_TARGET;
        break;
    default:
        is_known = false;
        break;
    }
    if (is_known && (part == PLAN_ENTRY) && procedure_is_armed(&self->procedure)) {
        return STATUS_MOTION_ARMED;
    }
    const status_t status =
        is_known ? plan_withdraw(&self->plan, cycle->robot, part) : STATUS_UNKNOWN_COMMAND;
    if ((status == STATUS_OK) && !controller_is_unlogged(command)) {
        controller_note(self, cycle, EVENT_WITHDRAWN, withdrawn, 0);
    }
    return status;
}

status_t controller_obey_steer(controller_t *self, const cycle_t *cycle, const command_t *command,
                               answer_t *answer)
{
    (void)answer;
    const command_steering_t *const sent = command_as_steering(command);
    status_t status = STATUS_OK;
    if (!controller_is_of_workphase(self, command)) {
        status = STATUS_WRONG_WORKPHASE;
    } else if (procedure_is_armed(&self->procedure)) {
        status = STATUS_MOTION_ARMED;
    } else {
        status = plan_steer(&self->plan, cycle->robot, sent->method, sent->curvature_per_km,
                            sent->direction_deg);
    }
    if (status == STATUS_OK) {
        self->sealed.is_steered = 0U;  /* What it was before is not forgotten, but replaced. */
        self->sealed.has_arrived = 0U; /* What has been steered otherwise stands elsewhere. */
        controller_note(self, cycle, EVENT_STEERING_TAKEN, self->plan.steering.method,
                        (int32_t)self->plan.steering.curvature_per_km);
        controller_note(self, cycle, EVENT_STEERING_DIRECTION, 0U,
                        self->plan.steering.direction_deg);
    }
    return status;
}

status_t controller_obey_needle(controller_t *self, const cycle_t *cycle, const command_t *command,
                                answer_t *answer)
{
    (void)cycle;
    (void)answer;
    return controller_is_of_workphase(self, command)
               ? plan_see_needle(&self->plan, &command_as_seen_pose(command)->pose)
               : STATUS_WRONG_WORKPHASE;
}

bool controller_is_unlogged(const command_t *command)
{
    bool is_unlogged = false;
    switch (command->kind) {
    case (uint32_t)COMMAND_PROPOSE_REGISTRATION:
    case (uint32_t)COMMAND_PROPOSE_ENTRY:
    case (uint32_t)COMMAND_PROPOSE_TARGET:
    case (uint32_t)COMMAND_NEEDLE:
        is_unlogged = command_as_seen_pose(command)->is_one_of_many != 0U;
        break;
    case (uint32_t)COMMAND_WITHDRAW:
        is_unlogged = command_as_withdrawal(command)->is_one_of_many != 0U;
        break;
    case (uint32_t)COMMAND_RENEW:
        is_unlogged = true;
        break;
    default:
        break;
    }
    return is_unlogged;
}
