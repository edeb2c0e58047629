/* SPDX-License-Identifier: Apache-2.0 */
/** @file Sweeps: commanded, and the curve that is kept shown. */
#ifndef BORESIGHT_HTTP_SWEEP_H
#define BORESIGHT_HTTP_SWEEP_H

#include "http/http_call.h"
#include "http/http_server.h"

/** Each answers the request. @return the status that was sent */

/** @satisfies SWR-SWEEP-012 */
int http_sweep_run(http_server_t *server, const http_call_t *call);

/** @satisfies SWR-SWEEP-014 */
int http_sweep_show(http_server_t *server, const http_call_t *call);

int http_sweep_csv(http_server_t *server, const http_call_t *call);

#endif
