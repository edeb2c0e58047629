/* SPDX-License-Identifier: Apache-2.0 */
/** @file Whether control would arm a mode for single axes for one of them now, from what it shows.
 * For people and programs that choose; control judges each command anew. */
#ifndef BORESIGHT_AXIS_AVAILABILITY_H
#define BORESIGHT_AXIS_AVAILABILITY_H

#include "interface/command.h"
#include "interface/mode_list.h"
#include "interface/snapshot.h"
#include "interface/status.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** The mildest command that arms `kind`, whose axes are commanded, for `axis`: the shortest jog
 * that ends where a target may lie, the slowest and shortest speed, a sweep of a free axis.
 * `is_upwards` matters for jogs and speeds alone. */
command_t axis_availability_command(const robot_t *robot, const snapshot_t *snapshot,
                                    mode_kind_t kind, uint32_t axis, bool is_upwards);

/**
 * The answer to that command. The mode's own judge and the workphase chart are asked, in copies
 * that are where control is.
 *
 * @return STATUS_OK, or why it would be refused
 *
 * @satisfies SWR-MODE-013
 */
status_t axis_availability(const robot_t *robot, const snapshot_t *snapshot, mode_kind_t kind,
                           uint32_t axis, bool is_upwards);

/**
 * The answer to such a command for any axis, either way.
 *
 * @return STATUS_OK for one that would be armed; otherwise what the workphase chart says where it
 * alone stands against one, and after that what a judge says of an axis that the mode is for
 *
 * @satisfies SWR-MODE-004
 */
status_t axis_availability_of_any(const robot_t *robot, const snapshot_t *snapshot,
                                  mode_kind_t kind);

#endif
