/* SPDX-License-Identifier: Apache-2.0 */
/** @file The body of every refusal: a problem as RFC 9457 has it, with the name of our code. */
#ifndef BORESIGHT_HTTP_PROBLEM_H
#define BORESIGHT_HTTP_PROBLEM_H

#include "interface/app/routes.h"
#include "request/request_fault.h"

#include <stddef.h>
#include <stdint.h>

#define HTTP_PROBLEM_SIZE 2560 /**< Room for what http_problem_write() writes. */

/** The content of one refusal. */
typedef struct {
    int http;               /**< The status. */
    const char *code;       /**< To be compared. */
    const char *detail;     /**< A sentence. */
    const char *pointer;    /**< To what is wrong in the body, or NULL. UTF-8. */
    const char *parameter;  /**< The wrong parameter of the query, or NULL. UTF-8. */
    const char *axis;       /**< The axis that is why, or NULL. */
    const char *limit;      /**< Its limit that would be left, or NULL. */
    uint32_t retry_after_s; /**< When to ask again; 0: nothing is said. */
} http_problem_t;

/** `problem` as routes.yml has it. */
http_problem_t http_problem_of(problem_t problem);

/** A refusal by control, with `status`, and the names of statuses that routes.yml has. */
http_problem_t http_problem_of_status(uint32_t status);

/** Why a body is refused. `result` outlives the problem. */
http_problem_t http_problem_of_body(const request_result_t *result);

/** Why a query is refused. `result` outlives the problem. */
http_problem_t http_problem_of_query(const request_result_t *result);

/** The words of a status; the library misspells those of 422. */
const char *http_problem_title(int http);

/**
 * Writes `problem` as JSON. Returns its length.
 *
 * @satisfies SWR-HTTP-013
 */
size_t http_problem_write(const http_problem_t *problem, char json[HTTP_PROBLEM_SIZE]);

#endif
