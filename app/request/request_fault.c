/* SPDX-License-Identifier: Apache-2.0 */
#include "request/request_fault.h"

#include <stdio.h>
#include <string.h>

const char *request_fault_text(request_fault_t fault)
{
    switch (fault) {
    case REQUEST_OK:
        return "Nothing is wrong.";
    case REQUEST_NOT_JSON:
        return "This is not JSON.";
    case REQUEST_UNKNOWN:
        return "Nothing of this name is expected.";
    case REQUEST_TWICE:
        return "This stands there twice.";
    case REQUEST_MISSING:
        return "This is missing.";
    case REQUEST_WRONG_TYPE:
        return "This is of another type than expected.";
    case REQUEST_TOO_LONG:
        return "This is too long.";
    case REQUEST_NOT_FINITE:
        return "A number is not finite.";
    case REQUEST_OUT_OF_RANGE:
        return "This is outside its range.";
    case REQUEST_NOT_ASCII:
        return "A byte of this is no printable ASCII character.";
    case REQUEST_NOT_ENCODED:
        return "A percent sign of this is not followed by two hexadecimal digits.";
    case REQUEST_COUNT:
    default:
        return "There are too few or too many of these.";
    }
}

/* Appends as much as there is room for. */
static void add(char text[REQUEST_TEXT_SIZE], const char *more)
{
    const size_t length = strlen(text);
    (void)snprintf(&text[length], REQUEST_TEXT_SIZE - length, "%s", more);
}

void request_fault_set(request_result_t *result, request_fault_t fault,
                       const request_message_t *message)
{
    result->fault = fault;
    result->text[0] = '\0';
    add(result->text, request_fault_text(fault));
    if ((fault == REQUEST_UNKNOWN) && (message != NULL) && (message->count > 0U)) {
        add(result->text, " Expected are ");
        for (uint32_t i = 0U; i < message->count; i++) {
            add(result->text, (i > 0U) ? ", " : "");
            add(result->text, message->fields[i].name);
        }
        add(result->text, ".");
    }
}
