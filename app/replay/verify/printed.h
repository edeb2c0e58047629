/* SPDX-License-Identifier: Apache-2.0 */
/** @file What the replay prints of each cycle: of the recording that is open, WALK_GOES_ON at its
 * end, or the exit code. The names of the columns stand before the first recording. */
#ifndef BORESIGHT_PRINTED_H
#define BORESIGHT_PRINTED_H

#include "replay/verify/walk.h"

/** As replayed. */
int printed_motion(walk_t *walk);
int printed_board(walk_t *walk);

/** As recorded. */
int printed_events(walk_t *walk);
int printed_intervals(walk_t *walk);

#endif
