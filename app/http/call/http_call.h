/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * One request of a route, judged and read before anything is done for it: the head, where it comes
 * from, its method, body and query.
 */
#ifndef BORESIGHT_HTTP_CALL_H
#define BORESIGHT_HTTP_CALL_H

#include "http/gate/http_guard.h"
#include "interface/app/routes.h"

#include "robot/robot.h"

#include <civetweb.h>
#include <stdint.h>

#define HTTP_CALL_NAME_SIZE 65U /**< Size of {name}, with its end. */

/** A request to a route. */
typedef struct {
    struct mg_connection *connection;
    const route_t *route;
    uint32_t page; /**< Which page asks, of a route of pages. */
    struct {
        uint32_t axis;                  /**< Index of {axis}. */
        uint32_t number;                /**< {number}. */
        char name[HTTP_CALL_NAME_SIZE]; /**< {name}. */
    } path;
    request_query_t query; /**< Its member is that of the route. */
    request_body_t body;   /**< The same. */
} http_call_t;

/**
 * Judges the head of any request. Refuses one that two readers could read in two ways.
 *
 * @return 0, or the status of the refusal that was sent
 *
 * @satisfies SWR-HTTP-017
 */
int http_call_judge(struct mg_connection *connection, const http_guard_t *guard);

/**
 * Finds the route of a request.
 *
 * @param allowed  set to the methods of the path if it has others; NULL: there is no such path
 * @return NULL without a route
 */
const route_t *http_call_find(const struct mg_connection *connection, const char **allowed);

/**
 * Reads what the path holds, body and query into `self`, whose connection and route are set and
 * whose rest is zero.
 *
 * @return 0, or the status of the refusal that was sent
 *
 * @satisfies SWR-HTTP-020
 * @satisfies SWR-HTTP-027
 */
int http_call_read(http_call_t *self, const robot_t *robot);

/**
 * Reads the body of a request, whose length is judged, into `bytes`. While the rest of it is
 * awaited the connection may be dismissed.
 *
 * @return 0, or the status of the refusal that was sent
 *
 * @satisfies SWR-LOAD-008
 */
int http_call_receive(struct mg_connection *connection, char *bytes);

#endif
