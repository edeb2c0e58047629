/* SPDX-License-Identifier: Apache-2.0 */
/** @file Which function carries out a command, as its row of core/interface/commands.yml says. */
#ifndef BORESIGHT_CONTROLLER_DISPATCH_H
#define BORESIGHT_CONTROLLER_DISPATCH_H

#include "controller/orders/controller_authority.h"
#include "controller/orders/controller_axis.h"
#include "controller/controller_force.h"
#include "controller/controller_membranes.h"
#include "controller/orders/controller_motion.h"
#include "controller/orders/controller_plan.h"
#include "controller/orders/controller_program.h"
#include "controller/memory/controller_restore.h"
#include "controller/orders/controller_trajectory.h"
#include "controller/orders/controller_workphase.h"

/**
 * Carries out a command that its sender may send. Generated.
 *
 * @param answer  what the command adds to it
 * @return STATUS_OK; STATUS_UNKNOWN_COMMAND for a kind that there is not; or why the command is
 * refused
 */
status_t controller_dispatch(controller_t *self, const cycle_t *cycle, const command_t *command,
                             answer_t *answer);

#endif
