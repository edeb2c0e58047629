/* SPDX-License-Identifier: Apache-2.0 */
/** @file The commands that change the plan, and arm nothing. */
#ifndef BORESIGHT_CONTROLLER_PLAN_H
#define BORESIGHT_CONTROLLER_PLAN_H

#include "controller/controller_events.h"

#include <stdbool.h>

/** Its sender states that it is not worth an event: a proposal or a needle of many. */
bool controller_is_unlogged(const command_t *command);

/**
 * Probe, registration, target, entry point, proposals and the needle that an image shows; fills
 * what `answer` says of a target.
 *
 * @return STATUS_OK; STATUS_UNKNOWN_COMMAND for any other kind, and for what cannot be withdrawn;
 * STATUS_MOTION_ARMED of a target and an entry point; STATUS_WRONG_WORKPHASE; as the plan refuses;
 * of a probe also STATUS_NOT_AT_REST, STATUS_NEEDLE_IN, or as probe_judge()
 *
 * @satisfies SWR-ALIGN-006
 * @satisfies SWR-PLAN-017
 * @satisfies SWR-PLAN-021
 * @satisfies SWR-CTRL-023
 * @satisfies SWR-MOTION-024
 * @satisfies SWR-PROBE-003
 * @satisfies SWR-PROBE-004
 * @satisfies SWR-PLAN-023
 */
status_t controller_obey_plan(controller_t *self, const cycle_t *cycle, const command_t *command,
                              answer_t *answer);

#endif
