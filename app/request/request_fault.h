/* SPDX-License-Identifier: Apache-2.0 */
/** @file Why what a client sent is refused. */
#ifndef BORESIGHT_REQUEST_FAULT_H
#define BORESIGHT_REQUEST_FAULT_H

#include "request/request_fields.h"

#define REQUEST_NAME_SIZE 48U   /**< A name's room, its end included. */
#define REQUEST_PLACE_SIZE 256U /**< A place's room, its end included. */
#define REQUEST_TEXT_SIZE 512U  /**< A text's room, its end included. */

typedef enum {
    REQUEST_OK = 0,
    REQUEST_NOT_JSON = 1,     /**< Not JSON as RFC 8259 has it, or something stands behind it. */
    REQUEST_UNKNOWN = 2,      /**< No field has this name. */
    REQUEST_TWICE = 3,        /**< The field stands there a second time. */
    REQUEST_MISSING = 4,      /**< A field that must be there is not. */
    REQUEST_WRONG_TYPE = 5,   /**< It is of another kind. */
    REQUEST_TOO_LONG = 6,     /**< A text, or a number with too many digits. */
    REQUEST_NOT_FINITE = 7,   /**< A number beyond all numbers. */
    REQUEST_OUT_OF_RANGE = 8, /**< A number outside its bounds, or none of the words. */
    REQUEST_COUNT = 9,        /**< Too few or too many values in a list. */
    REQUEST_NOT_ASCII = 10,   /**< A control character, or a byte beyond ASCII, in a query. */
    REQUEST_NOT_ENCODED = 11  /**< A percent sign that encodes nothing, in a query. */
} request_fault_t;

/** The result of reading. */
typedef struct {
    request_fault_t fault;
    /** Place of the fault: in a body a JSON pointer (RFC 6901), "" being all of it; in a query the
     * name of the parameter. Ends early if it is too long. UTF-8. */
    char place[REQUEST_PLACE_SIZE];
    char text[REQUEST_TEXT_SIZE]; /**< Text of the fault, one or two sentences. */
} request_result_t;

/**
 * `result` is of `fault`. For a name that is not expected it says which are, those of `message`
 * (NULL: it does not say).
 *
 * @satisfies SWR-HTTP-058
 */
void request_fault_set(request_result_t *result, request_fault_t fault,
                       const request_message_t *message);

/** A sentence. Lives as long as the process. */
const char *request_fault_text(request_fault_t fault);

#endif
