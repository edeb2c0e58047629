/* SPDX-License-Identifier: Apache-2.0 */
/** @file Whether control would arm a mode or enter a workphase now, from what it shows. For people
 * and programs that choose; control judges each command anew. */
#ifndef BORESIGHT_MODE_AVAILABILITY_H
#define BORESIGHT_MODE_AVAILABILITY_H

#include "interface/mode_list.h"
#include "interface/snapshot.h"
#include "interface/status.h"
#include "interface/workphase_list.h"
#include "robot/robot.h"

/**
 * The workphase chart is asked, in a copy that is where control is. A mode for single axes: whether
 * any can be commanded, by axis_availability.h. The conditions of the mode itself are checked as
 * far as they do not depend on the command: that there is a trajectory, and that it can be driven
 * from where the axes stand, a program for the target, a target with its entry point and the way
 * there, a pose that can be gone to, that the needle is out for it, and that the base is aligned.
 *
 * @param start_ticks where the trajectory begins that is held; NULL: it is unknown, and not judged
 * @return STATUS_OK, or why a command for it would be refused
 *
 * @satisfies SWR-MODE-004
 */
status_t mode_availability(const robot_t *robot, const snapshot_t *snapshot,
                           const int32_t start_ticks[ROBOT_AXIS_MAX], mode_kind_t kind);

/**
 * The same of a command for `workphase`.
 *
 * @satisfies SWR-MODE-010
 */
status_t workphase_availability(const robot_t *robot, const snapshot_t *snapshot,
                                workphase_t workphase);

#endif
