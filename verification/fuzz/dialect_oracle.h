/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The sentences that hold whatever peers say: hears each message that a peer sends and is sent, and
 * sees each command.
 */
#ifndef BORESIGHT_FUZZ_DIALECT_ORACLE_H
#define BORESIGHT_FUZZ_DIALECT_ORACLE_H

#include "fuzz/world.h"

/** A new scene. */
void dialect_oracle_begin(world_t *world);

/** A place was taken or left by a peer. */
void dialect_oracle_connected(const world_t *world, uint32_t place);
void dialect_oracle_leaves(const world_t *world, uint32_t place);

/** Before a dialect is called: with what `place` says, or because of anything else. */
void dialect_oracle_hears(const world_t *world, uint32_t place, const igtl_message_t *message);
void dialect_oracle_before(const world_t *world);

/** After it; takes all messages that its peers read. */
void dialect_oracle_after(world_t *world);

/** A command leaves for control. */
void dialect_oracle_passed(const world_t *world, const command_t *command);

/** After the time has gone on. */
void dialect_oracle_stepped(world_t *world);

#endif
