/* SPDX-License-Identifier: Apache-2.0 */
/** @file The commands that change the plan, and arm nothing. */
#ifndef BORESIGHT_CONTROLLER_PLAN_H
#define BORESIGHT_CONTROLLER_PLAN_H

#include "controller/controller_events.h"

#include <stdbool.h>

/**
 * Takes how the needle is steered.
 *
 * @return as plan_steer(), STATUS_WRONG_WORKPHASE, or STATUS_MOTION_ARMED
 *
 * @satisfies SWR-STEER-002
 * @satisfies SWR-STEER-009
 */
status_t controller_obey_steer(controller_t *self, const cycle_t *cycle, const command_t *command,
                               answer_t *answer);

/** Its sender states that it is not worth an event: a proposal or a needle of many. */
bool controller_is_unlogged(const command_t *command);

/**
 * Lengths of the probe.
 *
 * @return STATUS_OK; STATUS_PROBE_LENGTH, STATUS_WRONG_WORKPHASE, STATUS_NOT_AT_REST,
 * STATUS_NEEDLE_IN; or as probe_judge()
 *
 * @satisfies SWR-PROBE-003
 * @satisfies SWR-PROBE-004
 */
status_t controller_obey_probe(controller_t *self, const cycle_t *cycle, const command_t *command,
                               answer_t *answer);

/**
 * A registration.
 *
 * @return STATUS_OK; STATUS_WRONG_WORKPHASE; STATUS_UNKNOWN_COMMAND for an unknown use of it; or as
 * plan_register()
 *
 * @satisfies SWR-PLAN-023
 */
status_t controller_obey_registration(controller_t *self, const cycle_t *cycle,
                                      const command_t *command, answer_t *answer);

/**
 * A target; `answer` gets the pose that is reached, or the axis of a refusal.
 *
 * @return STATUS_OK; STATUS_MOTION_ARMED; STATUS_WRONG_WORKPHASE; or as plan_set_target()
 *
 * @satisfies SWR-ALIGN-006
 * @satisfies SWR-CTRL-023
 */
status_t controller_obey_target(controller_t *self, const cycle_t *cycle, const command_t *command,
                                answer_t *answer);

/**
 * An entry point that is sent, and one that was proposed; `answer` gets its place.
 *
 * @return STATUS_OK; STATUS_MOTION_ARMED; STATUS_WRONG_WORKPHASE; or as plan_set_entry() and
 * plan_accept_entry()
 *
 * @satisfies SWR-ALIGN-006
 * @satisfies SWR-PLAN-017
 */
status_t controller_obey_entry(controller_t *self, const cycle_t *cycle, const command_t *command,
                               answer_t *answer);
status_t controller_obey_accept_entry(controller_t *self, const cycle_t *cycle,
                                      const command_t *command, answer_t *answer);

/**
 * Proposals.
 *
 * @return STATUS_OK; or as the plan refuses
 */
status_t controller_obey_propose_registration(controller_t *self, const cycle_t *cycle,
                                              const command_t *command, answer_t *answer);
status_t controller_obey_propose_entry(controller_t *self, const cycle_t *cycle,
                                       const command_t *command, answer_t *answer);
status_t controller_obey_propose_target(controller_t *self, const cycle_t *cycle,
                                        const command_t *command, answer_t *answer);

/**
 * A proposal or the entry point is forgotten.
 *
 * @return STATUS_OK; STATUS_UNKNOWN_COMMAND for what cannot be withdrawn; STATUS_MOTION_ARMED;
 * STATUS_NOT_PROPOSED
 *
 * @satisfies SWR-ALIGN-006
 * @satisfies SWR-PLAN-021
 */
status_t controller_obey_withdraw(controller_t *self, const cycle_t *cycle,
                                  const command_t *command, answer_t *answer);

/**
 * The needle as an image shows it.
 *
 * @return STATUS_OK; STATUS_WRONG_WORKPHASE; or as plan_see_needle()
 *
 * @satisfies SWR-MOTION-024
 */
status_t controller_obey_needle(controller_t *self, const cycle_t *cycle, const command_t *command,
                                answer_t *answer);

#endif
