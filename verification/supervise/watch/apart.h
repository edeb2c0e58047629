/* SPDX-License-Identifier: Apache-2.0 */
/** @file Jogs that take the axes of a coupled limit far out in it. */
#ifndef BORESIGHT_APART_H
#define BORESIGHT_APART_H

#include "integration/support/rig.h"
#include "sim/model/sim_random.h"

#include <stdbool.h>
#include <stdint.h>

/** Whose limit it is. */
typedef struct {
    const robot_t *robot;
    uint32_t limit;
} apart_t;

/** Any coupled limit of `robot`, which has one. */
void apart_begin(apart_t *self, const robot_t *robot, sim_random_t *random);

/** An axis of it, mostly the first one. */
uint32_t apart_some_axis(const apart_t *self, sim_random_t *random);

/** They have gone as far out as they shall before one of them is lost. */
bool apart_is_out(const apart_t *self, const rig_t *rig);

/** The next jog on their way. */
command_t apart_jog(const apart_t *self, const rig_t *rig, sim_random_t *random);

#endif
