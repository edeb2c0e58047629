/* SPDX-License-Identifier: Apache-2.0 */
/** @file Permit and outgoing frames. */
#ifndef BORESIGHT_CONTROLLER_DRIVE_H
#define BORESIGHT_CONTROLLER_DRIVE_H

#include "controller/controller_events.h"

/**
 * Permit and outgoing frames. Each frame has its card switch off by itself when no further frame
 * comes. `guards`: controller_facts() of the state as it is.
 *
 * @satisfies SWR-PERMIT-002
 * @satisfies SWR-PERMIT-200
 * @satisfies SWR-PERMIT-003
 * @satisfies SWR-CMD-003
 * @satisfies SWR-CTRL-003
 * @satisfies SWR-CARD-005
 * @satisfies SWR-LINK-010
 * @satisfies SWR-DRIVE-011
 */
void controller_drive(controller_t *self, const cycle_t *cycle, uint32_t guards,
                      const card_drive_t requests[ROBOT_AXIS_MAX]);

#endif
