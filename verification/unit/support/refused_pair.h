/* SPDX-License-Identifier: Apache-2.0 */
/** @file Two legal places between which a way would leave a limit that axes share, by chance. */
#ifndef BORESIGHT_REFUSED_PAIR_H
#define BORESIGHT_REFUSED_PAIR_H

#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** A place to stand and a target, both legal. */
typedef struct {
    int32_t from_ticks[ROBOT_AXIS_MAX];
    int32_t to_ticks[ROBOT_AXIS_MAX];
} refused_pair_t;

/** Draws legal places, at most `tries` pairs. @return false: no way between them was refused */
bool refused_pair_draw(refused_pair_t *self, const robot_t *robot, uint32_t *random,
                       uint32_t tries);

#endif
