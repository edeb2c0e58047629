/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/verify/field_name.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

#define ELEMENT_SIZE 64U

static const field_t *find(const field_t *fields, size_t offset)
{
    const field_t *field = fields;

    while ((field->name != NULL) && (offset >= (field->offset + field->size))) {
        field++;
    }
    return field;
}

/* The meant part of the field: the element of an array, or the word of a part without fields. */
static void name_element(const field_t *field, size_t inside, char *text)
{
    if (field->element_size < field->size) {
        (void)snprintf(text, ELEMENT_SIZE, "%s[%zu]", field->name, inside / field->element_size);
    } else if ((field->inside == NULL) && (field->size > sizeof(uint32_t))) {
        (void)snprintf(text, ELEMENT_SIZE, "%s, word %zu", field->name, inside / sizeof(uint32_t));
    } else {
        (void)snprintf(text, ELEMENT_SIZE, "%s", field->name);
    }
}

void field_name(const field_t *fields, size_t offset, char *text, size_t size)
{
    const field_t *field = find(fields, offset);
    size_t inside = offset;
    size_t used = 0U;
    const char *dot = "";

    text[0] = '\0';
    while (field->name != NULL) {
        char element[ELEMENT_SIZE];
        inside -= field->offset;
        name_element(field, inside, element);
        (void)snprintf(&text[used], size - used, "%s%s", dot, element);
        used = strlen(text);
        if (field->inside == NULL) {
            return;
        }
        dot = ".";
        inside %= field->element_size;
        field = find(field->inside, inside);
    }
}
