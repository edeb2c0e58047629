/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Logins, and whether the session of a request is enough for its route. Two listeners are
 * distinguished: the plain one, and the one on the loopback address that is fed by a TLS program.
 */
#ifndef BORESIGHT_HTTP_LOGIN_GATE_H
#define BORESIGHT_HTTP_LOGIN_GATE_H

#include "http/call/http_call.h"
#include "http/call/http_context.h"

#define HTTP_LOGIN_GATE_TOKEN "X-Boresight-Token"

/** The request came through the TLS program. */
bool http_login_gate_is_tls(const http_server_t *server, const struct mg_connection *connection);

/**
 * Judges session, token and role. At the plain loopback listener a GET that is for everyone with an
 * account needs none of them.
 *
 * @return 0, or the status of the refusal that was sent
 *
 * @satisfies SWR-SESS-016
 * @satisfies SWR-SESS-017
 */
int http_login_gate_judge(http_server_t *server, const http_call_t *call);

/** Copies the session of a request to `session`. False: it has none. */
bool http_login_gate_find(http_server_t *server, const struct mg_connection *connection,
                          session_t *session);

/** Whether a stream that was let in may go on. */
bool http_login_gate_is_open(http_server_t *server, const struct mg_connection *connection);

#endif
