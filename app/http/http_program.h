/* SPDX-License-Identifier: Apache-2.0 */
/** @file The treatment program that is held: shown, sent, emptied, run. */
#ifndef BORESIGHT_HTTP_PROGRAM_H
#define BORESIGHT_HTTP_PROGRAM_H

#include "http/http_call.h"
#include "http/http_server.h"

/** Each answers the request. @return the status that was sent */
int http_program_show(http_server_t *server, const http_call_t *call);

/**
 * Sends the steps of the body, some at once and the next ones when these were taken.
 *
 * @satisfies SWR-PROG-012
 */
int http_program_send(http_server_t *server, const http_call_t *call);

int http_program_empty(http_server_t *server, const http_call_t *call);

int http_program_run(http_server_t *server, const http_call_t *call);

#endif
