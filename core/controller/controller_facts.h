/* SPDX-License-Identifier: Apache-2.0 */
/** @file What several parts of a cycle ask the state. */
#ifndef BORESIGHT_CONTROLLER_FACTS_H
#define BORESIGHT_CONTROLLER_FACTS_H

#include "controller/controller_events.h"

#include <stdbool.h>
#include <stdint.h>

/** The robot's table was damaged: nothing of it may be used. */
static inline bool controller_is_blind(const controller_t *self)
{
    return self->table_damage != 0U;
}

/**
 * Slot of the card of axis `index`, bounded: an index of frames, whatever the memory says.
 *
 * @satisfies SWR-MEMORY-006
 */
static inline uint32_t controller_slot(const controller_t *self, uint32_t index)
{
    const uint32_t slot = self->links[index].slot;
    return (slot < CARD_SLOT_COUNT) ? slot : 0U;
}

/** Every axis is homed. */
bool controller_is_homed(const controller_t *self);

/** Facts for the guards of the workphase chart. */
workphase_inputs_t controller_guards(const controller_t *self, const cycle_t *cycle);

#endif
