/* SPDX-License-Identifier: Apache-2.0 */
/** @file Commands of a kind that a test chooses: those that one number says, and those that a pose
 * says. */
#ifndef BORESIGHT_COMMANDS_H
#define BORESIGHT_COMMANDS_H

#include "base/rigid.h"
#include "interface/command.h"

/** A command that `number` says as far as its kind says a number: a workphase, an axis, a checksum,
 * a count ... */
static inline command_t commands_of_number(command_kind_t kind, uint32_t number)
{
    command_t command = {.kind = (uint32_t)kind};
    switch (command_traits[kind].form) {
    case (uint32_t)COMMAND_FORM_WORKPHASE:
        command.as.workphase.workphase = number;
        break;
    case (uint32_t)COMMAND_FORM_AXIS:
        command.as.axis.axis = number;
        break;
    case (uint32_t)COMMAND_FORM_JOG:
        command.as.jog.axis = number;
        break;
    case (uint32_t)COMMAND_FORM_JOG_BY:
        command.as.jog_by.axis = number;
        break;
    case (uint32_t)COMMAND_FORM_SWEEP:
        command.as.sweep.axis = number;
        break;
    case (uint32_t)COMMAND_FORM_LIST_BEGIN:
        command.as.list_begin.count = number;
        break;
    case (uint32_t)COMMAND_FORM_LIST:
        command.as.list.checksum = number;
        break;
    case (uint32_t)COMMAND_FORM_POSE_NAME:
        command.as.pose_name.pose = number;
        break;
    case (uint32_t)COMMAND_FORM_REQUEST:
        command.as.request.request = number;
        break;
    case (uint32_t)COMMAND_FORM_WITHDRAWAL:
        command.as.withdrawal.of = number;
        break;
    case (uint32_t)COMMAND_FORM_PROBE:
        command.as.probe.count = number;
        break;
    case (uint32_t)COMMAND_FORM_MEMBRANES:
        command.as.membranes.count = number;
        break;
    case (uint32_t)COMMAND_FORM_STEERING:
        command.as.steering.curvature_per_km = number;
        break;
    case (uint32_t)COMMAND_FORM_POSITIONS:
        command.as.positions.axes = number;
        break;
    case (uint32_t)COMMAND_FORM_VELOCITY:
        command.as.velocity.axes = number;
        break;
    case (uint32_t)COMMAND_FORM_NOTE:
        command.as.note.note = number;
        break;
    case (uint32_t)COMMAND_FORM_REGISTRATION:
        command.as.registration.use = number;
        rigid_set_identity(&command.as.registration.pose);
        break;
    case (uint32_t)COMMAND_FORM_POSE:
        rigid_set_identity(&command.as.pose.pose);
        break;
    case (uint32_t)COMMAND_FORM_SEEN_POSE:
        command.as.seen_pose.is_one_of_many = number;
        rigid_set_identity(&command.as.seen_pose.pose);
        break;
    default: /* No number says it. */
        break;
    }
    return command;
}

/** The number that `command` says first; 0: its kind says none. */
static inline uint32_t commands_number(const command_t *command)
{
    switch (command_traits[command->kind].form) {
    case (uint32_t)COMMAND_FORM_WORKPHASE:
        return command->as.workphase.workphase;
    case (uint32_t)COMMAND_FORM_AXIS:
        return command->as.axis.axis;
    case (uint32_t)COMMAND_FORM_JOG:
        return command->as.jog.axis;
    case (uint32_t)COMMAND_FORM_JOG_BY:
        return command->as.jog_by.axis;
    case (uint32_t)COMMAND_FORM_SWEEP:
        return command->as.sweep.axis;
    case (uint32_t)COMMAND_FORM_LIST_BEGIN:
        return command->as.list_begin.count;
    case (uint32_t)COMMAND_FORM_LIST:
        return command->as.list.checksum;
    case (uint32_t)COMMAND_FORM_POSE_NAME:
        return command->as.pose_name.pose;
    case (uint32_t)COMMAND_FORM_REQUEST:
        return command->as.request.request;
    case (uint32_t)COMMAND_FORM_WITHDRAWAL:
        return command->as.withdrawal.of;
    case (uint32_t)COMMAND_FORM_PROBE:
        return command->as.probe.count;
    case (uint32_t)COMMAND_FORM_MEMBRANES:
        return command->as.membranes.count;
    case (uint32_t)COMMAND_FORM_STEERING:
        return command->as.steering.curvature_per_km;
    case (uint32_t)COMMAND_FORM_POSITIONS:
        return command->as.positions.axes;
    case (uint32_t)COMMAND_FORM_VELOCITY:
        return command->as.velocity.axes;
    case (uint32_t)COMMAND_FORM_NOTE:
        return command->as.note.note;
    case (uint32_t)COMMAND_FORM_REGISTRATION:
        return command->as.registration.use;
    case (uint32_t)COMMAND_FORM_SEEN_POSE:
        return command->as.seen_pose.is_one_of_many;
    case (uint32_t)COMMAND_FORM_ROW:
        return command->as.row.index;
    case (uint32_t)COMMAND_FORM_STEP:
        return command->as.step.index;
    default: /* No number says it. */
        return 0U;
    }
}

/** A command that `pose` says; of a kind that a pose does not say, without one. */
static inline command_t commands_of_pose(command_kind_t kind, rigid_t pose)
{
    command_t command = {.kind = (uint32_t)kind};
    switch (command_traits[kind].form) {
    case (uint32_t)COMMAND_FORM_REGISTRATION:
        command.as.registration.pose = pose;
        break;
    case (uint32_t)COMMAND_FORM_POSE:
        command.as.pose.pose = pose;
        break;
    case (uint32_t)COMMAND_FORM_SEEN_POSE:
        command.as.seen_pose.pose = pose;
        break;
    default: /* No pose says it. */
        break;
    }
    return command;
}

/** The pose that says `command`; all zero: none does. */
static inline const rigid_t *commands_pose(const command_t *command)
{
    static const rigid_t none;
    switch (command_traits[command->kind].form) {
    case (uint32_t)COMMAND_FORM_REGISTRATION:
        return &command->as.registration.pose;
    case (uint32_t)COMMAND_FORM_POSE:
        return &command->as.pose.pose;
    case (uint32_t)COMMAND_FORM_SEEN_POSE:
        return &command->as.seen_pose.pose;
    default: /* No pose says it. */
        return &none;
    }
}

#endif
