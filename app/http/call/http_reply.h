/* SPDX-License-Identifier: Apache-2.0 */
/** @file Every answer of the library's workers leaves through here. */
#ifndef BORESIGHT_HTTP_REPLY_H
#define BORESIGHT_HTTP_REPLY_H

#include "http/gate/http_head.h"
#include "http/gate/http_problem.h"

#include <cjson/cJSON.h>
#include <civetweb.h>
#include <stdbool.h>

/** The request asks for the head of the answer only. */
bool http_reply_is_head_asked(const struct mg_connection *connection);

/**
 * Sends `reply`, of which HEAD and 304 get the head. The connection ends with it: a later request
 * comes through the gates, where a stop needs no worker.
 *
 * @return its status, or 0 when the client did not take it in time
 *
 * @satisfies SWR-HTTP-014
 * @satisfies SWR-HTTP-018
 */
int http_reply_send(struct mg_connection *connection, const http_reply_t *reply);

/** Sends JSON text. Returns as http_reply_send(). */
int http_reply_json(struct mg_connection *connection, int status, const char *json);

/** Sends `object` as JSON and frees it. Returns as http_reply_send(). */
int http_reply_object(struct mg_connection *connection, int status, cJSON *object);

/** Sends a refusal, with `allow` if it is not NULL. Returns as http_reply_send(). */
int http_reply_problem(struct mg_connection *connection, const http_problem_t *problem,
                       const char *allow);

/** Sends a refusal of which there is nothing more to say. */
int http_reply_refuse(struct mg_connection *connection, problem_t problem);

#endif
