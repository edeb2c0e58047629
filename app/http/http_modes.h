/* SPDX-License-Identifier: Apache-2.0 */
/** @file The route that shows what motions there are, and which may be commanded now. */
#ifndef BORESIGHT_HTTP_MODES_H
#define BORESIGHT_HTTP_MODES_H

#include "http/http_call.h"
#include "http/http_server.h"

/**
 * Returns the status sent.
 *
 * @satisfies SWR-HTTP-056
 * @satisfies SWR-MODE-004
 */
int http_modes_show(http_server_t *server, const http_call_t *call);

#endif
