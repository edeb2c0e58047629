/* SPDX-License-Identifier: Apache-2.0 */
/** @file The questions of the workphase protocol: where is the needle, in which workphase are we,
 * has it arrived. */
#ifndef BORESIGHT_WORKPHASE_QUERIES_H
#define BORESIGHT_WORKPHASE_QUERIES_H

#include "igtl/dialect/igtl_dialect.h"
#include "igtl/workphase/workphase_state.h"

#include <stdbool.h>

/**
 * Answers a STRING that asks, by its text or its name: CURRENT_POSITION, CURRENT_STATUS,
 * IS_IN_TARGETING_POS, HAS_REACHED_TARGET, CURRENT_PROGRAM.
 *
 * @return false when it asks for none of them
 *
 * @satisfies SWR-IGTL-013
 * @satisfies SWR-IGTL-017
 */
bool workphase_queries_string(workphase_peer_t *peer, const igtl_message_t *message,
                              const igtl_moment_t *moment);

/** Answers GET_TRANS of CURRENT_POSITION (or no name) and TARGET; STATUS NOT_FOUND for any other
 * name. */
void workphase_queries_transform(workphase_peer_t *peer, const igtl_message_t *message,
                                 const igtl_moment_t *moment);

/** Answers GET_STATUS of CURRENT_STATUS (or no name) by the workphase; of any other name by a
 * STATUS of that name, 1: the server lives. */
void workphase_queries_status(workphase_peer_t *peer, const igtl_message_t *message,
                              const igtl_moment_t *moment);

#endif
