/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Assigns the limited slots of a port to connections. A connection that finds no free slot is
 * queued without a reply. Its first message beyond a greeting gives it the slot of the connection
 * that has been silent for longest; a connection that sends nothing only gets a slot that has
 * become free.
 */
#ifndef BORESIGHT_IGTL_SLOTS_H
#define BORESIGHT_IGTL_SLOTS_H

#include "igtl/server/igtl_seats.h"

#include <stdbool.h>
#include <stdint.h>

/** Takes over a connected socket to `address` and `port`: seated, or waiting. When IGTL_WAITING
 * wait already, the one that has waited for longest is dropped. */
void igtl_slots_enter(igtl_server_t *self, int descriptor, uint32_t address, uint16_t port,
                      uint64_t now_us);

/**
 * A waiting connection has sent `message`: whether it has a place now. A stop takes even the place
 * of a peer that has just spoken. If no place can be taken, it is informed (STATUS of the message's
 * name, 6) and continues to wait.
 *
 * @satisfies SWR-IGTL-026
 */
bool igtl_slots_admit(igtl_server_t *self, igtl_connection_t *connection,
                      const igtl_message_t *message, const igtl_moment_t *moment);

/** Gives free places to waiting connections, the longest waiting first. */
void igtl_slots_fill(igtl_server_t *self);

#endif
