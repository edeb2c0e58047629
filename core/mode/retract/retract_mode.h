/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A retraction: the needle goes outwards, all other axes rest. One that is homed goes to where a
 * needle that is out is taken (safety/needle.h); any other one to its switch, or a whole stroke.
 * Without state but the leg.
 */
#ifndef BORESIGHT_RETRACT_MODE_H
#define BORESIGHT_RETRACT_MODE_H

#include "mode/leg/leg.h"
#include "mode/leg/mode_asked.h"
#include "mode/leg/mode_frame.h"

#include <stdbool.h>
#include <stdint.h>

/**
 * The needle is there, or farther out, or not homed and at its switch: then nothing has to move.
 *
 * @satisfies SWR-MODE-005
 */
bool retract_mode_is_done(int32_t end_ticks, const mode_frame_t *frame);

/**
 * One cycle on the way; called only while retract_mode_is_done() is false. The needle is never
 * asked to go inwards: a servo does not turn before its set-point stands, and where that stands the
 * retraction is done. The cap of an axis that is not homed is the speed of homing.
 *
 * @satisfies SWR-MOTION-023
 * @satisfies SWR-MODE-005
 */
void retract_mode_step(int32_t end_ticks, leg_t *leg, const mode_frame_t *frame,
                       mode_result_t *result);

/**
 * `way` of the needle to where a retraction that is armed now ends. Without a reference that is the
 * travel of the axis from where it stands.
 *
 * @satisfies SWR-MODE-005
 */
uint32_t retract_mode_ask(const mode_asked_t *asked, mode_way_t *way);

#endif
