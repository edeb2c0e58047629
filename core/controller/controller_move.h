/* SPDX-License-Identifier: Apache-2.0 */
/** @file The armed order in a cycle. */
#ifndef BORESIGHT_CONTROLLER_MOVE_H
#define BORESIGHT_CONTROLLER_MOVE_H

#include "controller/controller_events.h"

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

#endif
