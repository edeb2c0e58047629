/* SPDX-License-Identifier: Apache-2.0 */
/** @file Whether this build may replay a recording. */
#ifndef BORESIGHT_BUILD_FIT_H
#define BORESIGHT_BUILD_FIT_H

#include "recording/read/recording_reader.h"
#include "robot/robot.h"

/** The robot of the recording that is open; NULL, after a sentence on the standard error, when
 * robot, layout or frames are not those of this build. */
const robot_t *build_fit(const recording_reader_t *reader);

/** Mentions there when another build has recorded it. */
void build_fit_mention(const recording_reader_t *reader);

#endif
