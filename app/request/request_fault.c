/* SPDX-License-Identifier: Apache-2.0 */
#include "request/request_fault.h"

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
    case REQUEST_COUNT:
    default:
        return "There are too few or too many of these.";
    }
}
