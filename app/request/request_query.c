/* SPDX-License-Identifier: Apache-2.0 */
#include "request/request_query.h"

#include "request/request_expected.h"
#include "request/request_names.h"
#include "request/request_value.h"

#include <stdio.h>
#include <string.h>

#define VALUE_SIZE 128U

/* The value of a hexadecimal digit, 16 when it is none. */
static unsigned hex_of(char digit)
{
    static const char digits[] = "0123456789abcdef0123456789ABCDEF";
    const char *found = (digit != '\0') ? strchr(digits, digit) : NULL;
    return (found != NULL) ? ((unsigned)(found - digits) % 16U) : 16U;
}

/* Undoes the percent signs of `length` bytes. Control characters and what is beyond ASCII are
 * expected nowhere.
 *
 * @satisfies SWR-HTTP-320
 */
static request_fault_t decode(const char *bytes, size_t length, char *text, size_t size)
{
    size_t written = 0U;
    for (size_t i = 0U; i < length; i++) {
        unsigned byte = (unsigned char)bytes[i];
        if (byte == (unsigned)'%') {
            const unsigned high = ((length - i) > 2U) ? hex_of(bytes[i + 1U]) : 16U;
            const unsigned low = (high < 16U) ? hex_of(bytes[i + 2U]) : 16U;
            if (low > 15U) {
                return REQUEST_NOT_ENCODED;
            }
            byte = (high * 16U) + low;
            i += 2U;
        }
        if ((byte < 0x20U) || (byte > 0x7EU)) {
            return REQUEST_NOT_ASCII;
        }
        if ((written + 1U) >= size) {
            return REQUEST_TOO_LONG;
        }
        text[written] = (char)byte;
        written++;
    }
    text[written] = '\0';
    return REQUEST_OK;
}

static request_fault_t take_value(const request_field_t *field, const char *text, char *value)
{
    switch (field->kind) {
    case REQUEST_WORD:
        return request_value_word(field, text, value);
    case REQUEST_TEXT:
        if (strlen(text) >= field->size) {
            return REQUEST_TOO_LONG;
        }
        (void)memcpy(value, text, strlen(text) + 1U);
        return REQUEST_OK;
    case REQUEST_FLAG:
    case REQUEST_UINT32:
    case REQUEST_INT32:
    case REQUEST_NUMBER:
    case REQUEST_OBJECT:
    default:
        return request_value_read(field, text, strlen(text), value);
    }
}

/* Reads one parameter, `length` bytes. Its name is noted first, for each fault. */
static request_fault_t take_parameter(const request_message_t *message, const char *bytes,
                                      size_t length, uint32_t *seen, char *structure,
                                      char place[REQUEST_PLACE_SIZE], const request_field_t **asked)
{
    char name[REQUEST_NAME_SIZE] = "";
    char value[VALUE_SIZE] = "";
    const request_field_t *field = NULL;
    *asked = NULL;
    const char *equals = memchr(bytes, '=', length);
    const size_t name_length = (equals != NULL) ? (size_t)(equals - bytes) : length;
    request_fault_t fault = decode(bytes, name_length, name, sizeof name);
    if (fault != REQUEST_OK) {
        return REQUEST_UNKNOWN;
    }
    (void)snprintf(place, REQUEST_PLACE_SIZE, "%s", name);
    fault = request_names_find(message, name, seen, &field);
    if (fault != REQUEST_OK) {
        return fault;
    }
    *asked = field;
    if (equals == NULL) {
        return REQUEST_WRONG_TYPE;
    }
    fault = decode(equals + 1, length - name_length - 1U, value, sizeof value);
    if (fault == REQUEST_OK) {
        fault = take_value(field, value, structure + field->offset);
    }
    if (fault == REQUEST_OK) {
        request_names_report(field, 1U, structure);
    }
    return fault;
}

request_result_t request_read_query(const request_message_t *message, const char *query,
                                    void *structure)
{
    request_result_t result = {.fault = REQUEST_OK};
    uint32_t seen = 0U;
    request_asked_t asked = {.field = NULL};
    const char *rest = ((query != NULL) && (query[0] != '\0')) ? query : NULL;
    while ((rest != NULL) && (result.fault == REQUEST_OK)) {
        const size_t length = strcspn(rest, "&");
        result.fault =
            take_parameter(message, rest, length, &seen, structure, result.place, &asked.field);
        rest = (rest[length] == '&') ? &rest[length + 1U] : NULL;
    }
    const request_field_t *missing = request_names_missing(message, seen);
    if ((result.fault == REQUEST_OK) && (missing != NULL)) {
        result.fault = REQUEST_MISSING;
        asked.field = missing;
        (void)snprintf(result.place, sizeof result.place, "%s", missing->name);
    }
    request_fault_set(&result, result.fault, message);
    if ((result.fault != REQUEST_OK) && (asked.field != NULL)) {
        request_expected_add(&result, &asked);
    }
    return result;
}
