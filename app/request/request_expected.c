/* SPDX-License-Identifier: Apache-2.0 */
#include "request/request_expected.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* A bound is written with all digits that one of the interface may have. */
#define BOUND_DIGITS 15

static void add(char text[REQUEST_TEXT_SIZE], const char *format, ...)
    __attribute__((format(printf, 2, 3)));

/* Appends as much as there is room for. */
static void add(char text[REQUEST_TEXT_SIZE], const char *format, ...)
{
    const size_t length = strlen(text);
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(&text[length], REQUEST_TEXT_SIZE - length, format, arguments);
    va_end(arguments);
}

const char *request_expected_type(char first, bool is_whole)
{
    switch (first) {
    case '"':
        return "a string";
    case '{':
        return "an object";
    case '[':
        return "a list";
    case 'n':
        return "null";
    case 't':
        return "true";
    case 'f':
        return "false";
    default:
        return is_whole ? "a number with a fraction or an exponent" : "a number";
    }
}

static void add_words(char text[REQUEST_TEXT_SIZE], const request_field_t *field)
{
    add(text, "one of ");
    for (uint32_t i = 0U; i < field->word_count; i++) {
        add(text, "%s%s", (i > 0U) ? ", " : "", field->words[i].word);
    }
}

static void add_number(char text[REQUEST_TEXT_SIZE], const request_field_t *field)
{
    add(text, "a %snumber", (field->kind == REQUEST_NUMBER) ? "" : "whole ");
    if (field->unit != NULL) {
        add(text, " in %s", field->unit);
    }
    add(text, " from %.*g to %.*g", BOUND_DIGITS, field->minimum, BOUND_DIGITS, field->maximum);
}

/* One value, or one of a list. */
static void add_value(char text[REQUEST_TEXT_SIZE], const request_field_t *field)
{
    switch (field->kind) {
    case REQUEST_OBJECT:
        add(text, "an object");
        break;
    case REQUEST_WORD:
        add_words(text, field);
        break;
    case REQUEST_TEXT:
        add(text, "a string of at most %zu bytes", field->size - 1U);
        break;
    case REQUEST_FLAG:
        add(text, "true or false");
        break;
    case REQUEST_UINT32:
    case REQUEST_INT32:
    case REQUEST_NUMBER:
    default:
        add_number(text, field);
        break;
    }
}

static void add_list(char text[REQUEST_TEXT_SIZE], const request_field_t *field)
{
    add(text, "a list of ");
    if (field->least != field->most) {
        add(text, "%u to ", (unsigned)field->least);
    }
    add(text, "%u values, each ", (unsigned)field->most);
    add_value(text, field);
}

void request_expected_add(request_result_t *result, const request_asked_t *asked)
{
    const request_field_t *field = asked->field;
    if (asked->found != NULL) {
        result->text[0] = '\0';
    }
    add(result->text, "%s", (asked->found != NULL) ? "This must be " : " Expected is ");
    if ((field->most > 0U) && !asked->is_element) {
        add_list(result->text, field);
    } else {
        add_value(result->text, field);
    }
    if (asked->found != NULL) {
        add(result->text, ", and is %s", asked->found);
    }
    add(result->text, ".");
}
