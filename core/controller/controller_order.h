/* SPDX-License-Identifier: Apache-2.0 */
/** @file The order: the one motion that is armed, from the command for it to its last answer. */
#ifndef BORESIGHT_CONTROLLER_ORDER_H
#define BORESIGHT_CONTROLLER_ORDER_H

#include "controller/controller_events.h"

/** Adds an answer to this cycle's outputs. */
answer_t *controller_add_answer(const controller_t *self, const cycle_t *cycle);

/** Adds the axis and the end of the limit to the answer to a command that is refused as `judged`
 * says, as far as its status names them.
 *
 * @satisfies SWR-CMD-481
 */
void controller_blame(answer_t *answer, const solution_t *judged);

/**
 * The chart has armed a motion: `kind`, with `request`. `command` is to be answered for good later.
 *
 * @satisfies SWR-FLOW-001
 * @satisfies SWR-MODE-012
 */
void controller_arm(controller_t *self, const cycle_t *cycle, const command_t *command,
                    mode_kind_t kind, const mode_request_t *request);

/** The workphase or the order was damaged, and both are in their safe states: what was armed is
 * given up. */
void controller_abandon_order(controller_t *self, const cycle_t *cycle);

/**
 * Reports the outcome of the order, in ARMING_ACTION_ bits, by answers and events. `fault`: status
 * for one given up.
 *
 * @satisfies SWR-FLOW-001
 * @satisfies SWR-MODE-012
 */
void controller_report_order(controller_t *self, const cycle_t *cycle, uint32_t actions,
                             status_t fault);

/** Sends the order an event and reports. */
void controller_notify_order(controller_t *self, const cycle_t *cycle, arming_event_t event,
                             status_t fault);

/**
 * The operator has said or confirmed where an axis is: a spent account of vain homing begins anew.
 *
 * @satisfies SWR-NEXT-025
 */
void controller_renew_account(controller_t *self);

/**
 * The operator has said that what ended START_UPs or moves again and again is mended: they are
 * counted anew.
 *
 * @satisfies SWR-AXIS-080
 */
void controller_be_mended(controller_t *self, const cycle_t *cycle);

/** The e-stop was pulled. */
void controller_enter_emergency(controller_t *self, const cycle_t *cycle);

/** A fault ends the order; `cause` and `peer` say of what, as event_t. */
void controller_fail_order(controller_t *self, const cycle_t *cycle, event_cause_t cause,
                           uint32_t peer);

#endif
