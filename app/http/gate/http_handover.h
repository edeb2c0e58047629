/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Connections on their way to the library. It knows clients only by accepting them itself, and each
 * then waits for a worker. So what it listens at is taken from it, and it gets from here, in turn,
 * the connections that ask for something else than a stop.
 */
#ifndef BORESIGHT_HTTP_HANDOVER_H
#define BORESIGHT_HTTP_HANDOVER_H

#include <civetweb.h>
#include <stdbool.h>

/** The address that the library is given. No client reaches it: its socket is replaced before it
 * serves. */
#define HTTP_HANDOVER_ADDRESS "127.0.0.1:0"

/** All descriptors are below; fewer where the system grants fewer. */
#define HTTP_HANDOVER_DESCRIPTORS 2048U

/** The server refuses to start with fewer. */
#define HTTP_HANDOVER_LEAST 1024U

/** Before all others. False: the system grants too few descriptors. */
bool http_handover_open(void);

/** The library's callback before its threads begin: takes from it what it listens at. */
void http_handover_begin(const struct mg_context *context);

/**
 * Few enough wait for the library that more may come.
 *
 * @satisfies SWR-LOAD-006
 */
bool http_handover_has_room(void);

/** Gives a connection to the library, which closes it. */
void http_handover_give(int socket);

#endif
