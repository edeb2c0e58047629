/* SPDX-License-Identifier: Apache-2.0 */
/** @file What a jog may do. */
#ifndef BORESIGHT_CONTROLLER_JOG_H
#define BORESIGHT_CONTROLLER_JOG_H

#include "controller/controller.h"

#include <stdbool.h>
#include <stdint.h>

/** A jog of axis `index` is armed. */
static inline bool controller_is_jogged(const controller_t *self, uint32_t index)
{
    return (procedure_workphase(&self->procedure) == WORKPHASE_MANUAL) &&
           procedure_is_armed(&self->procedure) && (self->jog_axis == index);
}

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

#endif
