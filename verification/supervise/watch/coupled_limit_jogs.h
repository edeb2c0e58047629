/* SPDX-License-Identifier: Apache-2.0 */
/** @file Jogs that take the axes of a coupled limit far out in it. */
#ifndef BORESIGHT_COUPLED_LIMIT_JOGS_H
#define BORESIGHT_COUPLED_LIMIT_JOGS_H

#include "integration/support/rig.h"
#include "sim/model/sim_random.h"

#include <stdbool.h>
#include <stdint.h>

/** Robot and coupled limit of the jogs. */
typedef struct {
    const robot_t *robot;
    uint32_t limit;
} coupled_limit_jogs_t;

/** Any coupled limit of `robot`, which has one. */
void coupled_limit_jogs_begin(coupled_limit_jogs_t *self, const robot_t *robot,
                              sim_random_t *random);

/** An axis of it, mostly the first one. */
uint32_t coupled_limit_jogs_some_axis(const coupled_limit_jogs_t *self, sim_random_t *random);

/** They have gone as far out as they shall before one of them is lost. */
bool coupled_limit_jogs_is_out(const coupled_limit_jogs_t *self, const rig_t *rig);

/** The next jog on their way. */
command_t coupled_limit_jogs_jog(const coupled_limit_jogs_t *self, const rig_t *rig,
                                 sim_random_t *random);

#endif
