/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * DRAPING, a workphase of a later server for the NeuroRobot: here MANUAL, and in it the pose
 * DRAPING.
 */
#ifndef BORESIGHT_WORKPHASE_DRAPING_H
#define BORESIGHT_WORKPHASE_DRAPING_H

#include "igtl/dialect/igtl_dialect.h"
#include "igtl/workphase/workphase_state.h"
#include "igtl/workphase/workphase_commands.h"
#include "interface/status.h"

#include <stdbool.h>
#include <stdint.h>

/** `word` is DRAPING, and MANUAL has to be entered before its pose. */
bool workphase_draping_is_ahead(const workphase_command_t *word, const igtl_moment_t *moment);

/**
 * Asks for MANUAL.
 *
 * @return STATUS_OK, or STATUS_BUSY when too much is on its way
 */
status_t workphase_draping_begin(workphase_dialect_t *self, uint32_t peer,
                                 const igtl_moment_t *moment);

/**
 * MANUAL was entered: asks for the pose.
 *
 * @satisfies SWR-IGTL-090
 */
void workphase_draping_go_on(workphase_dialect_t *self, uint32_t peer, const igtl_moment_t *moment);

#endif
