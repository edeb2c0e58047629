/* SPDX-License-Identifier: Apache-2.0 */
/** @file The trajectory that is held: shown, sent as a table, emptied, run. */
#ifndef BORESIGHT_HTTP_TRAJECTORY_H
#define BORESIGHT_HTTP_TRAJECTORY_H

#include "http/http_call.h"
#include "http/http_server.h"

/** Each answers the request. @return the status that was sent */
int http_trajectory_show(http_server_t *server, const http_call_t *call);

/**
 * Sends the rows of the body, some at once and the next ones when these were taken.
 *
 * @satisfies SWR-TRAJ-015
 * @satisfies SWR-TRAJ-021
 */
int http_trajectory_send(http_server_t *server, const http_call_t *call);

int http_trajectory_empty(http_server_t *server, const http_call_t *call);

int http_trajectory_run(http_server_t *server, const http_call_t *call);

#endif
