/* SPDX-License-Identifier: Apache-2.0 */
/** @file What is shown of a cycle. */
#ifndef BORESIGHT_CONTROLLER_SHOW_H
#define BORESIGHT_CONTROLLER_SHOW_H

#include "controller/controller_events.h"

/**
 * Before controller_show(): while nothing moves, looks at the way to the target.
 *
 * @satisfies SWR-NEXT-003
 */
void controller_look_ahead(controller_t *self, const cycle_t *cycle, uint32_t guards);

/**
 * Fills the snapshot; `guards` as controller_drive().
 *
 * @satisfies SWR-CON-048
 * @satisfies SWR-NEXT-001
 * @satisfies SWR-NEXT-002
 * @satisfies SWR-NEXT-006
 * @satisfies SWR-NEXT-008
 * @satisfies SWR-NEXT-023
 * @satisfies SWR-MODE-011
 * @satisfies SWR-AUTH-014
 * @satisfies SWR-LINK-009
 * @satisfies SWR-DRIVE-013
 */
void controller_show(const controller_t *self, const cycle_t *cycle, uint32_t guards);

#endif
