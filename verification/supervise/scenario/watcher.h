/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A watcher that may propose and nothing else: registrations and points at any time, most of them
 * on the needle's line of the present target, and now and then withdraws one.
 */
#ifndef BORESIGHT_WATCHER_H
#define BORESIGHT_WATCHER_H

#include "integration/support/rig.h"

#include <stdbool.h>
#include <stdint.h>

/** A chance of its own: who watches changes nothing of what the others do. */
typedef struct {
    uint32_t random;
    uint32_t wait_cycles; /**< Until the next proposal. */
} watcher_t;

/** Begins scene `seed`. */
void watcher_begin(watcher_t *self, uint32_t seed);

/** Once a cycle; true: `command` is to be sent. */
bool watcher_play(watcher_t *self, const rig_t *rig, command_t *command);

#endif
