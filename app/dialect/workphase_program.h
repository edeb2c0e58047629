/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Treatment programs: `PROGRAM STEP <index> <depth> mm <angle> deg <dwell> s GATE`, without the
 * angle where the robot turns no needle, without GATE where the dose does not end the step. An
 * array has the columns depth, angle where there is one, dwell, gate (0 or 1).
 */
#ifndef BORESIGHT_WORKPHASE_PROGRAM_H
#define BORESIGHT_WORKPHASE_PROGRAM_H

#include "dialect/igtl_dialect.h"
#include "dialect/workphase_dialect.h"
#include "dialect/workphase_lists.h"

#define WORKPHASE_PROGRESS "CURRENT_PROGRAM"

/**
 * @satisfies SWR-PROG-013
 * @satisfies SWR-PROG-014
 */
extern const workphase_list_t workphase_program;

/** Sends STRING(CURRENT_PROGRAM, "<steps> <checksum> <steps done> <dwell of the next one in s>") of
 * the program that is held, "0" without one; or a STATUS of that name while control is silent.
 *
 * @satisfies SWR-PROG-016
 */
void workphase_program_tell(workphase_peer_t *peer, const igtl_moment_t *moment);

/** The program that `peer` has armed runs: tells it each step that is done.
 *
 * @satisfies SWR-PROG-016
 */
void workphase_program_follow(workphase_peer_t *peer, const igtl_moment_t *moment);

#endif
