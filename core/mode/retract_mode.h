/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A retraction: the needle goes outwards to where one that is out is taken (safety/needle.h), all
 * other axes are held. Without state but the leg.
 */
#ifndef BORESIGHT_RETRACT_MODE_H
#define BORESIGHT_RETRACT_MODE_H

#include "mode/leg.h"
#include "mode/mode_frame.h"

#include <stdbool.h>

/** The needle is there, or farther out: then nothing has to move. */
bool retract_mode_is_done(const mode_frame_t *frame);

/**
 * One cycle on the way; called only while retract_mode_is_done() is false. The needle is never
 * asked to go inwards: a servo does not turn before its set-point stands, and where that stands the
 * retraction is done.
 *
 * @satisfies SWR-MOTION-023
 * @satisfies SWR-THESIS-002
 */
void retract_mode_step(leg_t *leg, const mode_frame_t *frame, mode_result_t *result);

#endif
