/* SPDX-License-Identifier: Apache-2.0 */
/** @file What several parts of a cycle ask the state. */
#ifndef BORESIGHT_CONTROLLER_FACTS_H
#define BORESIGHT_CONTROLLER_FACTS_H

#include "controller/controller_events.h"
#include "procedure/guards.h"

#include <stdbool.h>
#include <stdint.h>

/** The robot's table was damaged: nothing of it may be used. */
static inline bool controller_is_table_invalid(const controller_t *self)
{
    return self->sealed.table_damage != 0U;
}

/** The link to the card of axis `index`. */
static inline const link_t *controller_link(const controller_t *self, uint32_t index)
{
    return &self->links[self->cards.slots[index]];
}

/** `command`, a known one, may be obeyed in the present workphase. */
static inline bool controller_is_of_workphase(const controller_t *self, const command_t *command)
{
    const uint32_t workphase = (uint32_t)procedure_workphase(&self->procedure);
    return ((command_traits[command->kind].workphases >> workphase) & 1U) != 0U;
}

/** Vain START_UPs have moved an axis too far.
 *
 * @satisfies SWR-NEXT-024
 */
static inline bool controller_is_spent(const controller_t *self)
{
    return self->sealed.account_state == (uint32_t)HOMING_ACCOUNT_SPENT;
}

/** Nothing is armed, the pedal is released, and no axis moves or counts. */
bool controller_is_at_rest(const controller_t *self);

/** Every axis is homed. */
bool controller_is_homed(const controller_t *self);

/** Positions of the axes; beyond those of the robot nothing is written. */
static inline void controller_positions(const controller_t *self, int32_t ticks[ROBOT_AXIS_MAX])
{
    for (uint32_t i = 0U; i < self->sealed.axis_count; i++) {
        ticks[i] = self->axes[i].sealed.encoder.position_ticks;
    }
}

/**
 * START_UP is refused, as nothing is recorded, none was accepted in this run, that is not accepted,
 * and the needle is known to be out.
 *
 * @satisfies SWR-NEXT-027
 * @satisfies SWR-NEXT-029
 */
bool controller_lacks_box(const controller_t *self, const cycle_t *cycle);

/** GUARD_BLIND, GUARD_UNFIT, GUARD_NO_BOX and GUARD_SPENT, as far as they stand. */
uint32_t controller_bars(const controller_t *self, const cycle_t *cycle);

/** GUARD_ facts, all that stand now. */
uint32_t controller_facts(const controller_t *self, const cycle_t *cycle);

/** Inputs for the guards of the workphase chart, for an order of mode `kind` that needs `axes` (bit
 * n: axis n). */
workphase_inputs_t controller_guards(const controller_t *self, const cycle_t *cycle,
                                     mode_kind_t kind, uint32_t axes);

#endif
