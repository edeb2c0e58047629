/* SPDX-License-Identifier: Apache-2.0 */
/** @file What a peer of the workphase protocol commands, and what it asks by a STRING. */
#ifndef BORESIGHT_WORKPHASE_RECEIVE_H
#define BORESIGHT_WORKPHASE_RECEIVE_H

#include "igtl/dialect/igtl_dialect.h"
#include "igtl/workphase/workphase_state.h"

#include <stdint.h>

/**
 * A STRING: a workphase named CMD_x, a question, a word of workphase_commands.h, NEEDLE_LENGTH.
 * Anything else is refused.
 *
 * @satisfies SWR-IGTL-006
 * @satisfies SWR-IGTL-008
 * @satisfies SWR-IGTL-035
 * @satisfies SWR-IGTL-036
 * @satisfies SWR-IGTL-091
 * @satisfies SWR-ALIGN-007
 */
void workphase_receive_string(workphase_dialect_t *self, uint32_t peer,
                              const igtl_message_t *message, const igtl_moment_t *moment);

/** `message` commands STOP or EMERGENCY. */
bool workphase_receive_is_stop(const igtl_message_t *message);

/**
 * A TRANSFORM: CLB_y, TGT_y, NPOS_y or an entry point by the prefix of the port. Anything else is
 * refused.
 *
 * @satisfies SWR-IGTL-008
 * @satisfies SWR-IGTL-034
 * @satisfies SWR-IGTL-035
 */
void workphase_receive_transform(workphase_dialect_t *self, uint32_t peer,
                                 const igtl_message_t *message, const igtl_moment_t *moment);

/**
 * An NDARRAY named TRAJECTORY. Anything else is refused.
 *
 * @satisfies SWR-TRAJ-022
 */
void workphase_receive_array(workphase_dialect_t *self, uint32_t peer,
                             const igtl_message_t *message, const igtl_moment_t *moment);

/**
 * Passes on more of the array that is on its way, unless another one commands since.
 *
 * @satisfies SWR-TRAJ-024
 */
void workphase_receive_go_on(workphase_dialect_t *self, const igtl_moment_t *moment);

/**
 * Passes on the tip of a connected peer that waits for its turn.
 *
 * @satisfies SWR-IGTL-034
 * @satisfies SWR-IGTL-050
 */
void workphase_receive_step(workphase_dialect_t *self, uint32_t peer, const igtl_moment_t *moment);

#endif
