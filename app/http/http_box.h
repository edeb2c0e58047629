/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The simulated box over HTTP: a page stands for the person at it. It needs a session, and no
 * authority, which nobody needs who works a real one.
 */
#ifndef BORESIGHT_HTTP_BOX_H
#define BORESIGHT_HTTP_BOX_H

#include "http/http_call.h"
#include "http/http_server.h"

/** Answers what there is to see. Returns the status sent. */
int http_box_show(http_server_t *server, const http_call_t *call);

/**
 * Gives an order, and answers what there is to see then. Returns the status sent.
 *
 * @satisfies SWR-HTTP-039
 * @satisfies SWR-HTTP-057
 */
int http_box_order(http_server_t *server, const http_call_t *call);

/** Renews what the page of `call` holds. Returns the status sent. */
int http_box_keep(http_server_t *server, const http_call_t *call);

/** Releases it. Returns the status sent. */
int http_box_drop(http_server_t *server, const http_call_t *call);

#endif
