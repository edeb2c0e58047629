/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Peers, both dialects, the lane to control, and the real controller with the simulated box, in
 * simulated time: what boresight-igtl does between its sockets and the exchange, without either.
 * The oracle (oracle.h) hears everything.
 */
#ifndef BORESIGHT_FUZZ_WORLD_H
#define BORESIGHT_FUZZ_WORLD_H

#include "igtl/dialect/igtl_dialect.h"
#include "igtl/dialect/transform_dialect.h"
#include "igtl/workphase/workphase_dialect.h"
#include "integration/support/rig.h"
#include "supervise/watch/authority_oracle.h"
#include "igtl/wire/igtl_inbox.h"
#include "igtl/wire/igtl_outbox.h"

#include <stdbool.h>
#include <stdint.h>

#define WORLD_PEERS 8U
#define WORLD_LANE 16U                  /**< Commands on their way to control, */
#define WORLD_STOPS 16U                 /**< and so many more of STOP and EMERGENCY. */
#define WORLD_LOST_US UINT64_C(1000000) /**< Silence of control until it is lost. */

#define WORLD_TURN_US 4000U                /**< Turn of the process, when nothing happens. */
#define WORLD_NOTHING UINT32_C(0xA5A5A5A5) /**< In the outbox of an absent peer. */

typedef struct {
    bool is_connected;
    bool is_hung; /**< Reads nothing. */
    uint32_t number;
    uint32_t version;  /**< Version of the headers that it writes, */
    bool has_spoken_2; /**< and whether one of version 2 has come, damaged or not. */
    igtl_language_t language;
    igtl_inbox_t inbox;
    igtl_outbox_t outbox;
} world_peer_t;

typedef struct {
    rig_t rig;
    authority_oracle_t authority_oracle; /**< The holder of authority, as seen from outside. */
    workphase_dialect_t workphase;
    transform_dialect_t transform;
    world_peer_t peers[WORLD_PEERS];
    command_t lane[WORLD_LANE + WORLD_STOPS];
    uint32_t waiting;       /**< Commands in it. */
    uint64_t full_until_us; /**< It takes nothing. */
    uint64_t silent_us;     /**< Control has not run for so long. */
    uint32_t next_number;
    igtl_moment_t moment;
} world_t;

/** How a scene begins (fuzz_beginning_t); the same world each time. */
void world_begin(world_t *self, uint32_t beginning);

void world_connect(world_t *self, uint32_t place, igtl_language_t language, uint32_t version);
void world_disconnect(world_t *self, uint32_t place);

/** Bytes of a peer arrive; a peer that breaks the framing is disconnected. */
void world_receive(world_t *self, uint32_t place, const uint8_t *bytes, uint32_t length);

/** Control runs so many cycles; the dialects' time passes with them. */
void world_wait(world_t *self, uint32_t cycles);

/** The same time without control. */
void world_wait_in_silence(world_t *self, uint32_t cycles);

#endif
