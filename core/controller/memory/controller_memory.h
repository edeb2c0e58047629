/* SPDX-License-Identifier: Apache-2.0 */
/** @file The state and the robot's table under their seals. */
#ifndef BORESIGHT_CONTROLLER_MEMORY_H
#define BORESIGHT_CONTROLLER_MEMORY_H

#include "controller/controller_events.h"

/**
 * Compares the state with its seals, and the robot's table with its own, before anything is used.
 * A damaged section is forgotten and brought to its safe state; a damaged table forbids all motion
 * until the programs are restarted. Finds the cards.
 *
 * @satisfies SWR-MEMORY-001
 * @satisfies SWR-MEMORY-002
 * @satisfies SWR-MEMORY-003
 * @satisfies SWR-MEMORY-004
 * @satisfies SWR-MEMORY-006
 * @satisfies SWR-MEMORY-007
 * @satisfies SWR-MEMORY-260
 * @satisfies SWR-FORCE-576
 */
void controller_check_memory(controller_t *self, const cycle_t *cycle);

#endif
