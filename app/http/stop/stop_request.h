/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The one request of the port for stops: POST /api/v1/stop with an empty body or object, or one
 * that asks for EMERGENCY. Each other request is refused.
 */
#ifndef BORESIGHT_STOP_REQUEST_H
#define BORESIGHT_STOP_REQUEST_H

#include "http/gate/http_guard.h"
#include "interface/app/routes.h"
#include "interface/workphase_list.h"
#include "request/request_fault.h"

#include <stdbool.h>
#include <stddef.h>

#define STOP_REQUEST_SIZE 4096U      /**< Most bytes of a request, its body included. */
#define STOP_REQUEST_ORIGIN_SIZE 96U /**< Longer origins are none of ours. */

/** The result of reading. */
typedef struct {
    bool is_whole;         /**< False: more bytes are needed, and is_held alone says something. */
    bool is_held;          /**< The client holds back the body until it is asked for. */
    bool is_refused;       /**< False: it is a stop. */
    workphase_t workphase; /**< STOP or EMERGENCY. */
    problem_t problem;     /**< Why it is refused. */
    request_result_t body; /**< Where, with PROBLEM_BAD_BODY. */
    char origin[STOP_REQUEST_ORIGIN_SIZE]; /**< The console's page that sent it; "" if no page. */
} stop_request_t;

/** The workphase that a body asks for. */
workphase_t stop_request_workphase(const request_stop_t *body);

/**
 * Reads the `size` bytes that have come so far, at most STOP_REQUEST_SIZE. `bytes` has room for one
 * more and is changed. Bytes behind a stop are ignored: its answer ends the connection.
 *
 * @satisfies SWR-HTTP-009
 * @satisfies SWR-HTTP-059
 * @satisfies SWR-HTTP-076
 */
stop_request_t stop_request_read(const http_guard_t *guard, char *bytes, size_t size);

#endif
