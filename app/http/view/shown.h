/* SPDX-License-Identifier: Apache-2.0 */
/** @file What control has shown of itself, in the form in which its own judges look at it. */
#ifndef BORESIGHT_SHOWN_H
#define BORESIGHT_SHOWN_H

#include "axis/axis.h"
#include "interface/snapshot.h"
#include "mode/mode.h"
#include "procedure/guards.h"
#include "procedure/plan.h"
#include "procedure/procedure.h"
#include "robot/robot.h"

#include <stdint.h>

/** The axes as far as the judges of modes look at them: references and positions. */
void shown_axes(const snapshot_t *snapshot, axis_t axes[ROBOT_AXIS_MAX]);

/** The plan as far as its judges look at it: probe, target and entry point that there are, and
 * where the axes stand at the target. */
plan_t shown_plan(const snapshot_t *snapshot);

/** Inputs of the workphase chart for mode `kind`; `commanded`: for these axes, bit n: axis n. */
workphase_inputs_t shown_guards(const robot_t *robot, const snapshot_t *snapshot, mode_kind_t kind,
                                uint32_t commanded);

/** The workphase chart where control is, to be asked; nothing is armed in it. */
procedure_t shown_procedure(const snapshot_t *snapshot);

#endif
