/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Questions about the requests that wait in a dialect, for the sentences of dialect_oracle.c.
 */
#ifndef BORESIGHT_FUZZ_DIALECT_REQUESTS_H
#define BORESIGHT_FUZZ_DIALECT_REQUESTS_H

#include "fuzz/world.h"

#include <stdbool.h>
#include <stdint.h>

/** A command for the workphase waits for control. */
bool request_is_queued(const world_t *world, workphase_t phase);

/** The peer has a request that is neither accepted nor overdue. */
bool request_waits(const world_t *world, uint32_t place);

/** The request with this id, or NULL. */
const igtl_request_t *request_find(const igtl_requests_t *requests, uint32_t id);

/** It asks for a stop. */
bool request_is_urgent(const igtl_request_t *request);

/** The same peer asks for the same once more; one answer serves several stops. */
bool request_has_newer(const world_t *world, const igtl_request_t *request);

/** The pose was asked for by the word DRAPING. */
bool request_is_draping(const world_t *world, const igtl_request_t *pose);

/** MANUAL was entered for DRAPING, of which only the answer to its pose is sent. */
bool request_goes_on_draping(const world_t *world, const igtl_request_t *was);

/** It is a row of an array, which is passed on when the row before was taken. */
bool request_is_of_array(const world_t *world, uint32_t place, const command_t *command);

/** A connection has authority that is not there any more. */
bool authority_is_held_by_lost(const world_t *world);

/** Authority is being given up. */
bool request_is_releasing(const world_t *world);

#endif
