/* SPDX-License-Identifier: Apache-2.0 */
#include "request/request_value.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static size_t skip_digits(const char *text, size_t size, size_t place)
{
    while ((place < size) && (text[place] >= '0') && (text[place] <= '9')) {
        place++;
    }
    return place;
}

/* The end of a JSON number's whole part at the start of `text`, 0 when none exists. */
static size_t whole_part(const char *text, size_t size)
{
    const size_t start = ((size > 0U) && (text[0] == '-')) ? 1U : 0U;
    const size_t end = skip_digits(text, size, start);
    const bool has_zero_in_front = (end > (start + 1U)) && (text[start] == '0');
    return ((end > start) && !has_zero_in_front) ? end : 0U;
}

/* The same with fraction and exponent. */
static size_t number_part(const char *text, size_t size)
{
    size_t end = whole_part(text, size);
    if ((end > 0U) && (end < size) && (text[end] == '.')) {
        const size_t digits = end + 1U;
        end = skip_digits(text, size, digits);
        if (end == digits) {
            return 0U;
        }
    }
    if ((end > 0U) && (end < size) && ((text[end] == 'e') || (text[end] == 'E'))) {
        const char sign = ((end + 1U) < size) ? text[end + 1U] : '\0';
        const bool is_signed = (sign == '+') || (sign == '-');
        const size_t digits = end + (is_signed ? 2U : 1U);
        end = skip_digits(text, size, digits);
        if (end == digits) {
            return 0U;
        }
    }
    return end;
}

static request_fault_t read_number(const request_field_t *field, const char *text, size_t size,
                                   double *number)
{
    char copy[REQUEST_NUMBER_SIZE];
    if (size >= sizeof copy) {
        return REQUEST_TOO_LONG;
    }
    (void)memcpy(copy, text, size);
    copy[size] = '\0';
    *number = strtod(copy, NULL);
    if (!isfinite(*number)) {
        return REQUEST_NOT_FINITE;
    }
    return ((*number < field->minimum) || (*number > field->maximum)) ? REQUEST_OUT_OF_RANGE
                                                                      : REQUEST_OK;
}

/* Doubles hold all numbers of 32 bits; the bounds of the field keep others out. */
static void store(const request_field_t *field, double number, void *value)
{
    if (field->kind == REQUEST_UINT32) {
        const uint32_t whole = (uint32_t)number;
        (void)memcpy(value, &whole, sizeof whole);
    } else if (field->kind == REQUEST_INT32) {
        const int32_t whole = (int32_t)number;
        (void)memcpy(value, &whole, sizeof whole);
    } else {
        (void)memcpy(value, &number, sizeof number);
    }
}

static request_fault_t read_flag(const char *text, size_t size, void *value)
{
    const bool is_true = (size == 4U) && (memcmp(text, "true", 4U) == 0);
    const bool is_false = (size == 5U) && (memcmp(text, "false", 5U) == 0);
    (void)memcpy(value, &is_true, sizeof is_true);
    return (is_true || is_false) ? REQUEST_OK : REQUEST_WRONG_TYPE;
}

bool request_value_is_json(const char *text, size_t size)
{
    bool is_flag = false;
    const bool is_null = (size == 4U) && (memcmp(text, "null", 4U) == 0);
    return is_null || (read_flag(text, size, &is_flag) == REQUEST_OK) ||
           ((size > 0U) && (number_part(text, size) == size));
}

request_fault_t request_value_read(const request_field_t *field, const char *text, size_t size,
                                   void *value)
{
    if (field->kind == REQUEST_FLAG) {
        return read_flag(text, size, value);
    }
    const bool is_fractional = field->kind == REQUEST_NUMBER;
    const size_t end = is_fractional ? number_part(text, size) : whole_part(text, size);
    double number = 0.0;
    if ((end == 0U) || (end != size)) {
        return REQUEST_WRONG_TYPE;
    }
    const request_fault_t fault = read_number(field, text, size, &number);
    if (fault == REQUEST_OK) {
        store(field, number, value);
    }
    return fault;
}

request_fault_t request_value_word(const request_field_t *field, const char *text, void *value)
{
    for (uint32_t i = 0U; i < field->word_count; i++) {
        if (strcmp(field->words[i].word, text) == 0) {
            (void)memcpy(value, &field->words[i].value, sizeof field->words[i].value);
            return REQUEST_OK;
        }
    }
    return REQUEST_OUT_OF_RANGE;
}
