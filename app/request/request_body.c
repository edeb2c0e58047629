/* SPDX-License-Identifier: Apache-2.0 */
#include "request/request_body.h"

#include "request/json_text.h"
#include "request/request_expected.h"
#include "request/request_names.h"
#include "request/request_value.h"

#include <stdio.h>
#include <string.h>

/* An object that is being read. The tables say how deep objects go, not the input. */
typedef struct {
    const request_message_t *message;
    char *structure;
    uint32_t seen;
    bool is_begun;                /* Something has been read of it. */
    const request_field_t *field; /* The member that is being read; NULL between two. */
    bool is_in_list;
    uint32_t elements; /* Elements of the list, the one that is being read included. */
} level_t;

typedef struct {
    json_text_t text;
    level_t levels[REQUEST_DEPTH];
    uint32_t depth;
    request_fault_t fault;
    request_asked_t
        asked; /* The field that is missing or has another value; NULL: another fault. */
    char name[REQUEST_NAME_SIZE]; /* Beside the present object's pointer, where the fault is. */
} reader_t;

static void fail(reader_t *self, request_fault_t fault)
{
    self->fault = fault;
}

/* The byte that must come next, or else it is not JSON. */
static bool expect(reader_t *self, char byte)
{
    const bool is_there = json_text_take(&self->text, byte);
    if (!is_there) {
        fail(self, REQUEST_NOT_JSON);
    }
    return is_there;
}

static void fail_with(reader_t *self, request_fault_t fault, const request_field_t *field)
{
    const level_t *level = (self->depth > 0U) ? &self->levels[self->depth - 1U] : NULL;
    self->asked.field = field;
    self->asked.is_element = (level != NULL) && (level->elements > 0U) && (level->field == field);
    fail(self, fault);
}

/* The value that comes next is not of the type of `field`, or it is no JSON. */
static void fail_type(reader_t *self, const request_field_t *field)
{
    const char first = json_text_peek(&self->text);
    const char *text = NULL;
    const size_t size = json_text_scalar(&self->text, &text);
    const bool is_begun = (first == '"') || (first == '{') || (first == '[');
    if (!is_begun && !request_value_is_json(text, size)) {
        fail(self, REQUEST_NOT_JSON);
    } else {
        const bool is_whole = (field->kind == REQUEST_UINT32) || (field->kind == REQUEST_INT32);
        fail_with(self, REQUEST_WRONG_TYPE, field);
        self->asked.found = request_expected_type(first, is_whole);
    }
}

/* The first byte of a value of the right type. */
static bool expect_type(reader_t *self, char byte, const request_field_t *field)
{
    const bool is_there = json_text_take(&self->text, byte);
    if (!is_there) {
        fail_type(self, field);
    }
    return is_there;
}

static void enter(reader_t *self, const request_field_t *field, char *structure)
{
    if (self->depth == REQUEST_DEPTH) {
        fail(self, REQUEST_WRONG_TYPE);
    } else if (expect_type(self, '{', field)) {
        const level_t level = {.message = field->message, .structure = structure};
        self->levels[self->depth] = level;
        self->depth++;
    } else {
        /* Refused. */
    }
}

static void read_text(reader_t *self, const request_field_t *field, char *value)
{
    char word[REQUEST_NAME_SIZE];
    const bool is_word = field->kind == REQUEST_WORD;
    if (json_text_peek(&self->text) != '"') {
        fail_type(self, field);
        return;
    }
    request_fault_t fault =
        json_text_string(&self->text, is_word ? word : value, is_word ? sizeof word : field->size);
    if (is_word && (fault == REQUEST_OK)) {
        fault = request_value_word(field, word, value);
    }
    if ((fault == REQUEST_OUT_OF_RANGE) || (fault == REQUEST_TOO_LONG)) {
        fail_with(self, fault, field);
    } else {
        fail(self, fault);
    }
}

static void read_scalar(reader_t *self, const request_field_t *field, char *value)
{
    json_text_t ahead = self->text;
    const char *text = NULL;
    const size_t size = json_text_scalar(&ahead, &text);
    const request_fault_t fault = request_value_is_json(text, size)
                                      ? request_value_read(field, text, size, value)
                                      : REQUEST_WRONG_TYPE;
    if (fault == REQUEST_WRONG_TYPE) {
        fail_type(self, field);
    } else if (fault != REQUEST_OK) {
        fail_with(self, fault, field);
    } else {
        self->text = ahead;
    }
}

/* Reads one value, or goes into an object. */
static void read_value(reader_t *self, const request_field_t *field, char *value)
{
    switch (field->kind) {
    case REQUEST_OBJECT:
        enter(self, field, value);
        break;
    case REQUEST_TEXT:
    case REQUEST_WORD:
        read_text(self, field, value);
        break;
    case REQUEST_FLAG:
    case REQUEST_UINT32:
    case REQUEST_INT32:
    case REQUEST_NUMBER:
    default:
        read_scalar(self, field, value);
        break;
    }
}

static void end_member(level_t *level, uint32_t count)
{
    request_names_report(level->field, count, level->structure);
    level->field = NULL;
    level->is_in_list = false;
    level->elements = 0U;
}

static void end_list(reader_t *self, level_t *level)
{
    if (level->elements < level->field->least) {
        level->elements = 0U; /* The list is at fault, none of its values. */
        fail_with(self, REQUEST_COUNT, level->field);
    } else {
        end_member(level, level->elements);
    }
}

/* Where an element of the present field goes; a message without members has no structure. */
static char *place_of(const level_t *level)
{
    const request_field_t *const field = level->field;
    const size_t offset = field->offset + ((size_t)level->elements * field->size);
    return (level->structure != NULL) ? (level->structure + offset) : NULL;
}

static void read_element(reader_t *self, level_t *level)
{
    const request_field_t *field = level->field;
    if (json_text_take(&self->text, ']')) {
        end_list(self, level);
    } else if ((level->elements > 0U) && !expect(self, ',')) {
        /* Refused. */
    } else if (level->elements == field->most) {
        level->elements = 0U;
        fail_with(self, REQUEST_COUNT, field);
    } else {
        char *value = place_of(level);
        level->elements++;
        read_value(self, field, value);
    }
}

static bool read_name(reader_t *self, level_t *level)
{
    char name[REQUEST_NAME_SIZE];
    request_fault_t fault = json_text_string(&self->text, name, sizeof name);
    if (fault == REQUEST_OK) {
        fault = request_names_find(level->message, name, &level->seen, &level->field);
        if (fault == REQUEST_UNKNOWN) {
            (void)memcpy(self->name, name, sizeof name);
        }
    } else if (fault == REQUEST_TOO_LONG) {
        fault = REQUEST_UNKNOWN;
    } else {
        /* It is no text. */
    }
    fail(self, fault);
    return (fault == REQUEST_OK) && expect(self, ':');
}

/* Reads one member up to its value, and the value if it is a single one. */
static void read_member(reader_t *self, level_t *level)
{
    if (!read_name(self, level)) {
        return;
    }
    const request_field_t *field = level->field;
    if (field->most > 0U) {
        level->is_in_list = expect_type(self, '[', field);
    } else {
        read_value(self, field, place_of(level));
        if ((self->fault == REQUEST_OK) && (field->kind != REQUEST_OBJECT)) {
            end_member(level, 1U);
        }
    }
}

static void leave(reader_t *self, const level_t *level)
{
    const request_field_t *missing = request_names_missing(level->message, level->seen);
    if (missing != NULL) {
        (void)snprintf(self->name, sizeof self->name, "%s", missing->name);
        fail_with(self, REQUEST_MISSING, missing);
        return;
    }
    self->depth--;
    if (self->depth > 0U) {
        level_t *outer = &self->levels[self->depth - 1U];
        if (!outer->is_in_list) {
            end_member(outer, 1U);
        }
    }
}

static void step(reader_t *self)
{
    level_t *level = &self->levels[self->depth - 1U];
    if (level->is_in_list) {
        read_element(self, level);
    } else if (!level->is_begun && json_text_take(&self->text, '}')) {
        leave(self, level);
    } else if (!level->is_begun || json_text_take(&self->text, ',')) {
        level->is_begun = true;
        read_member(self, level);
    } else if (expect(self, '}')) {
        leave(self, level);
    } else {
        /* Refused. */
    }
}

/* Adds a name to a pointer, if there is room for all of it. */
static void add_name(char place[REQUEST_PLACE_SIZE], const char *name)
{
    char escaped[(2U * REQUEST_NAME_SIZE) + 1U] = "/";
    size_t length = 1U;
    for (const char *byte = name; *byte != '\0'; byte++) {
        const bool is_special = (*byte == '~') || (*byte == '/');
        if (is_special) {
            escaped[length] = '~';
            length++;
        }
        escaped[length] = *byte;
        if (is_special) {
            escaped[length] = (*byte == '~') ? '0' : '1';
        }
        length++;
    }
    escaped[length] = '\0';
    if ((strlen(place) + length) < REQUEST_PLACE_SIZE) {
        (void)strcat(place, escaped);
    }
}

static void write_place(const reader_t *self, char place[REQUEST_PLACE_SIZE])
{
    place[0] = '\0';
    for (uint32_t i = 0U; i < self->depth; i++) {
        const level_t *level = &self->levels[i];
        if (level->field != NULL) {
            add_name(place, level->field->name);
        }
        if (level->elements > 0U) {
            char number[16];
            (void)snprintf(number, sizeof number, "%u", (unsigned)(level->elements - 1U));
            add_name(place, number);
        }
    }
    if (self->name[0] != '\0') {
        add_name(place, self->name);
    }
}

request_result_t request_read_body(const request_message_t *message, const char *bytes, size_t size,
                                   void *structure)
{
    request_result_t result = {.fault = REQUEST_OK};
    reader_t reader = {
        .text = {.bytes = (size > 0U) ? bytes : "{}", .size = (size > 0U) ? size : 2U}};
    const request_field_t whole = {.kind = REQUEST_OBJECT, .message = message};
    enter(&reader, &whole, structure);
    while ((reader.fault == REQUEST_OK) && (reader.depth > 0U)) {
        step(&reader);
    }
    if ((reader.fault == REQUEST_OK) && !json_text_is_at_end(&reader.text)) {
        fail(&reader, REQUEST_NOT_JSON);
    }
    if (reader.fault != REQUEST_OK) {
        const uint32_t innermost = (reader.depth > 0U) ? (reader.depth - 1U) : 0U;
        const request_message_t *at =
            (reader.depth > 0U) ? reader.levels[innermost].message : message;
        request_fault_set(&result, reader.fault, at);
        if (reader.asked.field != NULL) {
            request_expected_add(&result, &reader.asked);
        }
        write_place(&reader, result.place);
    }
    return result;
}
