/* SPDX-License-Identifier: Apache-2.0 */
/** @file The goal of a motion whose command does not state it itself: the target, a pose, or the
 * list of a trajectory. */
#ifndef BORESIGHT_CONTROLLER_AIM_H
#define BORESIGHT_CONTROLLER_AIM_H

#include "controller/controller_events.h"
#include "mode/mode.h"

/**
 * May the axes go to the target in step from where they are? A target that is not proved is
 * forgotten.
 *
 * @return STATUS_MEMORY_DAMAGED, or as plan_judge_way()
 *
 * @satisfies SWR-MEMORY-005
 */
solution_t controller_judge_way(controller_t *self, const cycle_t *cycle);

/**
 * Fills what `request` of the mode `kind` has to say of the target or of the pose
 * the checksum that it names; of any other mode nothing.
 *
 * @return STATUS_OK; of a mode with a place at the target as plan_judge_entry() and
 * controller_judge_way(), of MODE_PROGRAM also as controller_judge_program() of list
 * the checksum that it names; of MODE_POSE as pose_mode_find(); of MODE_TRAJECTORY as
 * controller_judge_trajectory() of list the checksum that it names
 *
 * @satisfies SWR-ALIGN-003
 * @satisfies SWR-STEER-014
 */
solution_t controller_aim(controller_t *self, const cycle_t *cycle, const command_t *command,
                          mode_kind_t kind, mode_request_t *request);

#endif
