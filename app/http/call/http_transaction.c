/* SPDX-License-Identifier: Apache-2.0 */
#include "http/call/http_transaction.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#define MARK_SIZE 32U

/* Text that is written as far as there is room. */
typedef struct {
    char *text;
    size_t room;
    size_t used; /* Size of that and of the text that had no room. */
} sheet_t;

/* JSON that is read. */
typedef struct {
    const char *bytes;
    size_t size;
    size_t at;
} source_t;

static void put(sheet_t *sheet, char byte)
{
    if ((sheet->used + 1U) < sheet->room) {
        sheet->text[sheet->used] = byte;
    }
    sheet->used++;
}

static void put_all(sheet_t *sheet, const char *text)
{
    for (const char *byte = text; *byte != '\0'; byte++) {
        put(sheet, *byte);
    }
}

static void finish(const sheet_t *sheet, size_t size)
{
    char mark[MARK_SIZE];
    const bool is_cut = sheet->used >= sheet->room;
    const size_t end = is_cut ? (sheet->room - 1U) : sheet->used;
    const int length = snprintf(mark, sizeof mark, "... (%zu bytes)", size);
    sheet->text[end] = '\0';
    if (is_cut && (end >= (size_t)length)) {
        (void)memcpy(&sheet->text[end - (size_t)length], mark, (size_t)length);
    }
}

/* The next byte; NUL behind the last one. */
static char peek(const source_t *source)
{
    return (source->at < source->size) ? source->bytes[source->at] : '\0';
}

static void skip_spaces(source_t *source)
{
    while ((source->at < source->size) && (strchr(" \t\r\n", peek(source)) != NULL)) {
        source->at++;
    }
}

/* A string with its quotes, of which the first is next. Returns its size. */
static size_t pass_string(source_t *source)
{
    const size_t from = source->at;
    source->at++;
    while ((source->at < source->size) && (peek(source) != '"')) {
        source->at += (peek(source) == '\\') ? 2U : 1U;
    }
    source->at += (source->at < source->size) ? 1U : 0U;
    source->at = (source->at < source->size) ? source->at : source->size;
    return source->at - from;
}

/* The name of a member is that of a secret. A name with escapes is taken for one. */
static bool is_secret(const char *name, size_t size)
{
    static const char *const secrets[] = {"\"password\"", "\"code\"", "\"token\"", "\"hmac\""};
    bool is_one = memchr(name, '\\', size) != NULL;
    for (size_t i = 0U; i < (sizeof secrets / sizeof secrets[0]); i++) {
        is_one = is_one || ((strlen(secrets[i]) == size) && (strncmp(secrets[i], name, size) == 0));
    }
    return is_one;
}

/* A value that is more than a string or a number takes the rest with it. */
static void hide_value(sheet_t *sheet, source_t *source)
{
    const char first = peek(source);
    if (first == '"') {
        (void)pass_string(source);
    } else if ((first == '{') || (first == '[')) {
        source->at = source->size;
    } else {
        while ((source->at < source->size) && (strchr(",}]", peek(source)) == NULL)) {
            source->at++;
        }
    }
    put_all(sheet, "\"***\"");
}

static void copy_string(sheet_t *sheet, source_t *source)
{
    const char *string = &source->bytes[source->at];
    const size_t size = pass_string(source);
    for (size_t i = 0U; i < size; i++) {
        put(sheet, string[i]);
    }
    skip_spaces(source);
    if (peek(source) == ':') {
        put(sheet, ':');
        source->at++;
        skip_spaces(source);
        if (is_secret(string, size)) {
            hide_value(sheet, source);
        }
    }
}

void http_transaction_write_request(char *text, size_t room, const char *json, size_t size)
{
    sheet_t sheet = {.text = text, .room = room};
    source_t source = {.bytes = json, .size = size};
    for (skip_spaces(&source); source.at < source.size; skip_spaces(&source)) {
        if (peek(&source) == '"') {
            copy_string(&sheet, &source);
        } else {
            put(&sheet, peek(&source));
            source.at++;
        }
    }
    finish(&sheet, size);
}

void http_transaction_write_answer(char *text, size_t room, const char *json, size_t size)
{
    sheet_t sheet = {.text = text, .room = room};
    for (size_t i = 0U; i < size; i++) {
        put(&sheet, json[i]);
    }
    finish(&sheet, size);
}

void http_transaction_begin(http_transaction_t *self, const struct mg_connection *connection)
{
    self->request[0] = '\0';
    self->answer[0] = '\0';
    mg_set_user_connection_data(connection, self);
}

void http_transaction_end(const struct mg_connection *connection)
{
    mg_set_user_connection_data(connection, NULL);
}

void http_transaction_keep_request(const struct mg_connection *connection, const char *json,
                                   size_t size)
{
    http_transaction_t *self = mg_get_user_connection_data(connection);
    if ((self != NULL) && (json != NULL)) {
        http_transaction_write_request(self->request, sizeof self->request, json, size);
    } else if ((self != NULL) && (size > 0U)) {
        (void)snprintf(self->request, sizeof self->request, "(%zu bytes)", size);
    } else {
        /* It is not kept, or none exists. */
    }
}

void http_transaction_keep_answer(const struct mg_connection *connection, const char *json,
                                  size_t size)
{
    http_transaction_t *self = mg_get_user_connection_data(connection);
    if (self != NULL) {
        http_transaction_write_answer(self->answer, sizeof self->answer, json, size);
    }
}
