/* SPDX-License-Identifier: Apache-2.0 */
#include "nifpga/bitfile.h"

#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define MOST_BYTES (64L * 1024L * 1024L)
#define TAG_SIZE 40U

/* A part of the text. */
typedef struct {
    const char *begin;
    const char *end;
} span_t;

static const char *find(span_t within, const char *what)
{
    const size_t length = strlen(what);

    for (const char *at = within.begin; (size_t)(within.end - at) >= length; at++) {
        if (memcmp(at, what, length) == 0) {
            return at;
        }
    }
    return NULL;
}

/* Content of the first element `tag`. */
static bool element(span_t within, const char *tag, span_t *inside)
{
    char mark[TAG_SIZE];

    (void)snprintf(mark, sizeof mark, "<%s>", tag);
    const char *const begin = find(within, mark);
    if (begin == NULL) {
        return false;
    }
    inside->begin = begin + strlen(mark);
    (void)snprintf(mark, sizeof mark, "</%s>", tag);
    inside->end = find((span_t){inside->begin, within.end}, mark);
    return inside->end != NULL;
}

static span_t trimmed(span_t span)
{
    while ((span.begin < span.end) && (isspace((unsigned char)*span.begin) != 0)) {
        span.begin++;
    }
    while ((span.begin < span.end) && (isspace((unsigned char)span.end[-1]) != 0)) {
        span.end--;
    }
    return span;
}

static bool says(span_t span, const char *text)
{
    const span_t said = trimmed(span);
    const size_t length = strlen(text);

    return ((size_t)(said.end - said.begin) == length) && (memcmp(said.begin, text, length) == 0);
}

static bool has(span_t within, const char *tag, const char *text)
{
    span_t inside;

    return element(within, tag, &inside) && says(inside, text);
}

static bool number(span_t within, const char *tag, uint32_t *value)
{
    span_t inside;

    if (!element(within, tag, &inside)) {
        return false;
    }
    const span_t digits = trimmed(inside);
    char *end = NULL;
    errno = 0;
    const unsigned long read = strtoul(digits.begin, &end, 10);
    *value = (uint32_t)read;
    return (digits.begin < digits.end) && (isdigit((unsigned char)*digits.begin) != 0) &&
           (end == digits.end) && (errno == 0) && (read <= UINT32_MAX);
}

/* The next register from `rest` on, which is moved behind it. */
static bool next_register(span_t *rest, span_t *one)
{
    const bool is_there = element(*rest, "Register", one);

    if (is_there) {
        rest->begin = one->end;
    }
    return is_there;
}

static bool find_list(const bitfile_t *self, span_t *list)
{
    return element((span_t){self->text, self->text + strlen(self->text)}, "RegisterList", list);
}

/* The next register of this name. */
static bool next_named(span_t *rest, const char *name, span_t *found)
{
    while (next_register(rest, found)) {
        if (has(*found, "Name", name)) {
            return true;
        }
    }
    return false;
}

/* Is `tag` the first thing in it? A cluster holds what it is made of too. */
static bool begins(span_t within, const char *tag)
{
    const span_t first = trimmed(within);
    const size_t length = strlen(tag);

    return ((size_t)(first.end - first.begin) > (length + 1U)) && (*first.begin == '<') &&
           (memcmp(first.begin + 1, tag, length) == 0) &&
           (strchr("> /\t\r\n", first.begin[length + 1U]) != NULL);
}

static bool is_of_type(span_t datatype, bitfile_type_t type)
{
    span_t inside;

    if (type == BITFILE_PACKET) {
        return begins(datatype, "Array") && element(datatype, "Array", &inside) &&
               has(inside, "Size", "32") && element(inside, "Type", &inside) &&
               begins(inside, "U32");
    }
    return begins(datatype, (type == BITFILE_STATE) ? "EnumU16" : "Boolean");
}

bitfile_answer_t bitfile_find(const bitfile_t *self, const bitfile_query_t *query,
                              uint32_t *address)
{
    span_t rest;
    span_t found;
    span_t other;
    span_t datatype;
    uint32_t offset = 0U;

    if (!find_list(self, &rest) || !next_named(&rest, query->name, &found)) {
        return BITFILE_MISSING;
    }
    if (next_named(&rest, query->name, &other)) {
        return BITFILE_TWICE;
    }
    if (!has(found, "Indicator", query->is_indicator ? "true" : "false") ||
        !element(found, "Datatype", &datatype) || !is_of_type(datatype, query->type) ||
        !number(found, "Offset", &offset)) {
        return BITFILE_OTHERWISE;
    }
    *address = (self->base + offset) |
               (has(found, "AccessMayTimeout", "true") ? BITFILE_MAY_TIME_OUT : 0U);
    return BITFILE_FOUND;
}

bool bitfile_number(const bitfile_t *self, const char *name, const char *label, uint16_t *found)
{
    span_t rest;
    span_t one;

    if (!find_list(self, &rest) || !next_named(&rest, name, &one) ||
        !element(one, "StringList", &rest)) {
        return false;
    }
    for (uint16_t i = 0U; element(rest, "String", &one); i++) {
        if (says(one, label)) {
            *found = i;
            return true;
        }
        rest.begin = one.end;
    }
    return false;
}

/* Opening a pipe for reading waits for its other end. */
static FILE *open_regular(const char *path)
{
    const int descriptor = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    struct stat about;

    if (descriptor < 0) {
        return NULL;
    }
    FILE *const file = ((fstat(descriptor, &about) == 0) && S_ISREG(about.st_mode))
                           ? fdopen(descriptor, "r")
                           : NULL;
    if (file == NULL) {
        (void)close(descriptor);
    }
    return file;
}

static char *load(const char *path)
{
    FILE *const file = open_regular(path);
    char *text = NULL;
    long size = -1;

    if (file == NULL) {
        return NULL;
    }
    if (fseek(file, 0L, SEEK_END) == 0) {
        size = ftell(file);
        rewind(file);
    }
    if ((size >= 0) && (size < MOST_BYTES)) {
        text = calloc((size_t)size + 1U, 1U);
    }
    if ((text != NULL) && (fread(text, 1U, (size_t)size, file) != (size_t)size)) {
        free(text);
        text = NULL;
    }
    (void)fclose(file);
    return text;
}

static bool read_head(bitfile_t *self)
{
    const span_t whole = {self->text, self->text + strlen(self->text)};
    span_t inside;

    if (!element(whole, "SignatureRegister", &inside)) {
        return false;
    }
    inside = trimmed(inside);
    const size_t length = (size_t)(inside.end - inside.begin);
    if ((length == 0U) || (length >= sizeof self->signature)) {
        return false;
    }
    for (size_t i = 0U; i < length; i++) {
        self->signature[i] = (char)toupper((unsigned char)inside.begin[i]);
    }
    return number(whole, "BaseAddressOnDevice", &self->base);
}

bool bitfile_open(bitfile_t *self, const char *path, char *error, uint32_t error_size)
{
    *self = (bitfile_t){.text = load(path)};
    if (self->text == NULL) {
        (void)snprintf(error, error_size,
                       "The bitfile \"%s\" cannot be read; give the .lvbitx of the box.", path);
        return false;
    }
    if (!read_head(self)) {
        (void)snprintf(
            error, error_size,
            "The bitfile \"%s\" lacks SignatureRegister or BaseAddressOnDevice; give the "
            ".lvbitx that LabVIEW FPGA has made.",
            path);
        bitfile_close(self);
        return false;
    }
    return true;
}

void bitfile_close(bitfile_t *self)
{
    free(self->text);
    self->text = NULL;
}
