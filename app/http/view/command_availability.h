/* SPDX-License-Identifier: Apache-2.0 */
/** @file Whether control would obey a command that arms no motion, from what it shows. For people
 * and programs that choose; control judges each command anew. */
#ifndef BORESIGHT_COMMAND_AVAILABILITY_H
#define BORESIGHT_COMMAND_AVAILABILITY_H

#include "interface/command.h"
#include "interface/snapshot.h"
#include "interface/status.h"
#include "robot/robot.h"

/**
 * The workphase, what is armed, a pulled or latched e-stop, a pressed pedal, the needle and the
 * target are looked at, as far as the command asks for them; not what hangs on its axis or its
 * numbers, nor who sends it.
 *
 * @return STATUS_OK, or why any command of this kind would be refused
 *
 * @satisfies SWR-HTTP-055
 */
status_t command_availability(const robot_t *robot, const snapshot_t *snapshot,
                              command_kind_t kind);

#endif
