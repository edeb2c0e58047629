/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Two pages and two connections that all want to command, somebody at the button who gives it to
 * anyone, and processes that hang.
 */
#ifndef BORESIGHT_RIVALS_H
#define BORESIGHT_RIVALS_H

#include "integration/support/rig.h"

#include <stdbool.h>
#include <stdint.h>

typedef struct {
    uint32_t random;
    uint32_t wait_cycles;   /**< Until one of them does the next thing. */
    uint32_t press_cycles;  /**< The button stays pressed for so long. */
    uint32_t asleep_cycles; /**< No page renews for so long. */
    uint32_t hung_cycles;   /**< A process gives no sign of life for so long. */
} rivals_t;

/** By `seed`; nobody has authority when the scene begins but who had it before. */
void rivals_begin(rivals_t *self, rig_t *rig, uint32_t seed);

/** Before a cycle. @return true: `command` is to be sent */
bool rivals_play(rivals_t *self, rig_t *rig, command_t *command);

/** Whose `command` of the operator is: mostly of who has authority. */
void rivals_sign(rivals_t *self, const rig_t *rig, command_t *command);

#endif
