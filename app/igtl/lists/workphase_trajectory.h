/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Trajectories, each row as the thesis has it: `TRAJECTORY ROW <index> <ms> <ticks of each axis>
 * <ticks/s of each axis>`. An array has the columns ms, ticks of each axis, ticks/s of each axis.
 * All of them are whole numbers.
 */
#ifndef BORESIGHT_WORKPHASE_TRAJECTORY_H
#define BORESIGHT_WORKPHASE_TRAJECTORY_H

#include "igtl/lists/workphase_list_kind.h"

/** @satisfies SWR-TRAJ-023 */
extern const workphase_list_t workphase_trajectory;

#endif
