/* SPDX-License-Identifier: Apache-2.0 */
#include "request/request_names.h"

#include <string.h>

request_fault_t request_names_find(const request_message_t *message, const char *name,
                                   uint32_t *seen, const request_field_t **field)
{
    for (uint32_t i = 0U; i < message->count; i++) {
        if (strcmp(message->fields[i].name, name) == 0) {
            const uint32_t bit = UINT32_C(1) << i;
            const request_fault_t fault = ((*seen & bit) != 0U) ? REQUEST_TWICE : REQUEST_OK;
            *seen |= bit;
            *field = &message->fields[i];
            return fault;
        }
    }
    return REQUEST_UNKNOWN;
}

const request_field_t *request_names_missing(const request_message_t *message, uint32_t seen)
{
    for (uint32_t i = 0U; i < message->count; i++) {
        const bool is_seen = (seen & (UINT32_C(1) << i)) != 0U;
        if (!is_seen && !message->fields[i].is_optional) {
            return &message->fields[i];
        }
    }
    return NULL;
}

void request_names_report(const request_field_t *field, uint32_t count, void *structure)
{
    char *place = (char *)structure + field->given_offset;
    if (field->most > 0U) {
        (void)memcpy(place, &count, sizeof count);
    } else if (field->is_optional) {
        const bool is_there = count > 0U;
        (void)memcpy(place, &is_there, sizeof is_there);
    } else {
        /* It must be there. */
    }
}
