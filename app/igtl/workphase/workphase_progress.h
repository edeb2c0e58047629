/* SPDX-License-Identifier: Apache-2.0 */
/** @file Progress of the treatment program, on request of a peer or by notification. */
#ifndef BORESIGHT_WORKPHASE_PROGRESS_H
#define BORESIGHT_WORKPHASE_PROGRESS_H

#include "igtl/dialect/igtl_dialect.h"
#include "igtl/workphase/workphase_state.h"

#define WORKPHASE_PROGRESS "CURRENT_PROGRAM"

/** Sends STRING(CURRENT_PROGRAM, "<steps> <checksum> <steps done> <dwell of the next one in s>") of
 * the program that is held, "0" without one; or a STATUS of that name while control is silent.
 *
 * @satisfies SWR-PROG-016
 */
void workphase_progress_send(workphase_peer_t *peer, const igtl_moment_t *moment);

/** The program that `peer` has armed runs: reports to it each step that is done.
 *
 * @satisfies SWR-PROG-016
 */
void workphase_progress_follow(workphase_peer_t *peer, const igtl_moment_t *moment);

#endif
