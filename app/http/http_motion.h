/* SPDX-License-Identifier: Apache-2.0 */
/** @file The routes that change the workphase and arm motions. Each returns the status sent. */
#ifndef BORESIGHT_HTTP_MOTION_H
#define BORESIGHT_HTTP_MOTION_H

#include "http/http_call.h"
#include "http/http_server.h"

int http_motion_workphase(http_server_t *server, const http_call_t *call);

/** @satisfies SWR-HTTP-029 */
int http_motion_jog(http_server_t *server, const http_call_t *call);

int http_motion_retract(http_server_t *server, const http_call_t *call);

#endif
