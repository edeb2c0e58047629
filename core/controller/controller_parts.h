/* SPDX-License-Identifier: Apache-2.0 */
/** @file The parts of controller_step(), in the order of a cycle. For the files of this folder
 * only. */
#ifndef BORESIGHT_CONTROLLER_PARTS_H
#define BORESIGHT_CONTROLLER_PARTS_H

#include "controller/controller.h"

#include <stdbool.h>

/** What the parts of one cycle share. */
typedef struct {
    const robot_t *robot;
    const controller_inputs_t *inputs;
    controller_outputs_t *outputs;
} cycle_t;

/**
 * Adds an event to this cycle's outputs; counts it as lost when they are full.
 *
 * @satisfies SWR-EVENT-001
 * @satisfies SWR-EVENT-002
 * @satisfies SWR-EVENT-004
 */
void controller_note(controller_t *self, const cycle_t *cycle, event_id_t id, uint32_t subject,
                     int32_t value);

/**
 * What is noted from now on happens because of this. `peer`: as event_t.
 *
 * @satisfies SWR-EVENT-005
 * @satisfies SWR-EVENT-006
 */
void controller_because(controller_t *self, event_cause_t cause, uint32_t peer);

/**
 * Compares the state with its seals, and the robot's table with its own, before anything is used.
 * A damaged section is forgotten and brought to its safe state; a damaged table forbids all motion
 * until the programs are restarted.
 *
 * @satisfies SWR-MEMORY-001
 * @satisfies SWR-MEMORY-002
 * @satisfies SWR-MEMORY-003
 * @satisfies SWR-MEMORY-004
 * @satisfies SWR-MEMORY-007
 */
void controller_check_memory(controller_t *self, const cycle_t *cycle);

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
    return self->links[index].slot % CARD_SLOT_COUNT;
}

/** The card of axis `index` was lost: so are the target, the order and, unless it is only
 * `is_in_doubt`, its reference. */
void controller_lose_card(controller_t *self, const cycle_t *cycle, uint32_t index,
                          bool is_in_doubt);

/**
 * Links, encoders, interlocks: what the world says in this cycle. A damaged chart is repaired here.
 *
 * @satisfies SWR-CORE-004
 * @satisfies SWR-CHART-012
 * @satisfies SWR-REF-006
 * @satisfies SWR-REF-009
 * @satisfies SWR-REF-010
 * @satisfies SWR-REF-011
 * @satisfies SWR-REF-007
 * @satisfies SWR-EVENT-003
 * @satisfies SWR-AXIS-023
 */
void controller_observe(controller_t *self, const cycle_t *cycle);

/**
 * At the first report of an axis of which a reading was kept: is it the same? Then what was known
 * is restored, otherwise the axis is lost.
 *
 * @satisfies SWR-STORE-005
 * @satisfies SWR-STORE-006
 */
void controller_compare(controller_t *self, const cycle_t *cycle, uint32_t index);

/** Axes with a kept position that have not reported yet. */
uint32_t controller_count_awaited(const controller_t *self);

/**
 * Commands of this cycle, each answered at once.
 *
 * @satisfies SWR-AXIS-020
 * @satisfies SWR-CMD-001
 * @satisfies SWR-CMD-004
 * @satisfies SWR-CMD-005
 */
void controller_obey(controller_t *self, const cycle_t *cycle);

/** The workphase chart was damaged and is back in its safe state: what was armed is given up. */
void controller_abandon_order(controller_t *self, const cycle_t *cycle);

/** What the workphase chart just did: answers and events. `fault`: status for an order given up. */
void controller_report_order(controller_t *self, const cycle_t *cycle, uint32_t actions,
                             status_t fault);

/** Sends an event to the workphase chart and reports. */
void controller_tell_order(controller_t *self, const cycle_t *cycle, workphases_event_t event,
                           status_t fault);

/** A fault ends the order; `cause` and `peer` say of what, as event_t. */
void controller_fail_order(controller_t *self, const cycle_t *cycle, event_cause_t cause,
                           uint32_t peer);

/** Every axis is homed. */
bool controller_is_homed(const controller_t *self);

/** A jog of axis `index` is armed. */
bool controller_is_jogged(const controller_t *self, uint32_t index);

/**
 * May the jog be armed, wherever the workphase stands? `answer` receives axis and limit.
 *
 * @return STATUS_OK; STATUS_UNKNOWN_COMMAND for no axis; STATUS_NEEDLE_IN; of a homed axis
 * STATUS_AXIS_LIMIT, STATUS_SWITCH_ZONE, STATUS_SEPARATION_LIMIT; STATUS_JOG_TOO_FAR while it or
 * one that shares a limit with it is not homed
 *
 * @satisfies SWR-AXIS-004
 * @satisfies SWR-JOG-002
 */
status_t controller_judge_jog(const controller_t *self, const robot_t *robot,
                              const command_t *command, answer_t *answer);

/** Facts for the guards of the workphase chart. */
workphases_inputs_t controller_guards(const controller_t *self, const cycle_t *cycle);

/**
 * The armed order: pedal edges, homing, move, jog, its end. Fills one drive request per axis.
 *
 * @satisfies SWR-DEMO-001
 * @satisfies SWR-JOG-004
 * @satisfies SWR-MOTION-005
 * @satisfies SWR-MOTION-006
 */
void controller_move(controller_t *self, const cycle_t *cycle,
                     card_drive_t requests[ROBOT_AXIS_MAX]);

/**
 * Permit and outgoing frames. Each frame tells its card to switch off by itself when no further
 * frame comes.
 *
 * @satisfies SWR-PERMIT-002
 * @satisfies SWR-PERMIT-003
 * @satisfies SWR-CMD-003
 * @satisfies SWR-CTRL-003
 * @satisfies SWR-CARD-005
 */
void controller_drive(controller_t *self, const cycle_t *cycle,
                      const card_drive_t requests[ROBOT_AXIS_MAX]);

/**
 * Fills the snapshot.
 *
 * @satisfies SWR-NEXT-001
 * @satisfies SWR-NEXT-002
 */
void controller_show(const controller_t *self, const cycle_t *cycle);

#endif
