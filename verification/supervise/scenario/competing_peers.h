/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Two pages and two connections that all want to command, a person at the button who gives it to
 * anyone, and processes that hang.
 */
#ifndef BORESIGHT_COMPETING_PEERS_H
#define BORESIGHT_COMPETING_PEERS_H

#include "integration/support/rig.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct {
    uint32_t random;
    uint32_t wait_cycles;   /**< Until one of them does the next thing. */
    uint32_t press_cycles;  /**< The button stays pressed for so long. */
    uint32_t asleep_cycles; /**< No page renews for so long. */
    uint32_t hung_cycles;   /**< A process gives no sign of life for so long. */
} competing_peers_t;

/** By `seed`; only an earlier holder has authority when the scene begins. */
void competing_peers_begin(competing_peers_t *self, rig_t *rig, uint32_t seed);

/** Before a cycle. @return true: `command` is to be sent */
bool competing_peers_play(competing_peers_t *self, rig_t *rig, command_t *command);

/** Sets the sender of the operator's `command`: mostly the holder of authority. */
void competing_peers_sign(competing_peers_t *self, const rig_t *rig, command_t *command);

#endif
