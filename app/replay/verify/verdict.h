/* SPDX-License-Identifier: Apache-2.0 */
/** @file What the replay says: whether a run was computed again as it was, and which share of it.
 */
#ifndef BORESIGHT_VERDICT_H
#define BORESIGHT_VERDICT_H

#include "replay/verify/walk.h"

/** Replays the recording that is open. WALK_GOES_ON at its end, or the exit code. */
int verdict_take(walk_t *walk);

/**
 * After the last recording: says which run it is of, which cycles of it there are, and how many
 * were equal. The exit code.
 *
 * @satisfies SWR-REPLAY-031
 * @satisfies SWR-REPLAY-032
 */
int verdict_report(walk_t *walk);

#endif
