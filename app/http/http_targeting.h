/* SPDX-License-Identifier: Apache-2.0 */
/** @file The routes of probe, registration, entry point and target. Each returns the status sent.
 */
#ifndef BORESIGHT_HTTP_TARGETING_H
#define BORESIGHT_HTTP_TARGETING_H

#include "http/http_call.h"
#include "http/http_server.h"

/** @satisfies SWR-HTTP-031 */
int http_targeting_register(http_server_t *server, const http_call_t *call);

/**
 * Lengths count by their names.
 *
 * @satisfies SWR-PROBE-008
 * @satisfies SWR-PROBE-010
 */
int http_targeting_set_probe(http_server_t *server, const http_call_t *call);

/** @satisfies SWR-HTTP-031 */
int http_targeting_enter(http_server_t *server, const http_call_t *call);

/** @satisfies SWR-HTTP-031 */
int http_targeting_aim(http_server_t *server, const http_call_t *call);

int http_targeting_withdraw(http_server_t *server, const http_call_t *call);

/** What would come of a target. */
int http_targeting_preview(http_server_t *server, const http_call_t *call);

#endif
