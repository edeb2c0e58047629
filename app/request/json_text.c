/* SPDX-License-Identifier: Apache-2.0 */
#include "request/json_text.h"

#include <stdint.h>
#include <string.h>

#define HEX_DIGITS 4U
#define SEQUENCE_MOST 4U /* Bytes of a character in UTF-8. */

/* The characters whose UTF-8 begins with `first` to `last`. `least` and `most` bound the second
 * byte: no longer forms than needed, no surrogates, nothing beyond U+10FFFF. */
typedef struct {
    uint8_t first;
    uint8_t last;
    uint8_t length;
    uint8_t least;
    uint8_t most;
} sequence_t;

static const sequence_t sequences[] = {
    {0x20U, 0x7FU, 1U, 0U, 0U},       {0xC2U, 0xDFU, 2U, 0x80U, 0xBFU},
    {0xE0U, 0xE0U, 3U, 0xA0U, 0xBFU}, {0xE1U, 0xECU, 3U, 0x80U, 0xBFU},
    {0xEDU, 0xEDU, 3U, 0x80U, 0x9FU}, {0xEEU, 0xEFU, 3U, 0x80U, 0xBFU},
    {0xF0U, 0xF0U, 4U, 0x90U, 0xBFU}, {0xF1U, 0xF3U, 4U, 0x80U, 0xBFU},
    {0xF4U, 0xF4U, 4U, 0x80U, 0x8FU}};

/* A string that is being written. */
typedef struct {
    char *text;
    size_t size;
    size_t length;
} writer_t;

static bool is_space(char byte)
{
    return (byte == ' ') || (byte == '\t') || (byte == '\r') || (byte == '\n');
}

static char next(const json_text_t *self)
{
    return (self->place < self->size) ? self->bytes[self->place] : '\0';
}

char json_text_peek(json_text_t *self)
{
    while (is_space(next(self))) {
        self->place++;
    }
    return next(self);
}

bool json_text_take(json_text_t *self, char wanted)
{
    const bool is_there = json_text_peek(self) == wanted;
    self->place += is_there ? 1U : 0U;
    return is_there;
}

bool json_text_is_at_end(json_text_t *self)
{
    (void)json_text_peek(self);
    return self->place == self->size;
}

bool json_text_is_value(json_text_t *self)
{
    const char byte = json_text_peek(self);
    return (byte != '\0') && (strchr("{[\"-0123456789tfn", byte) != NULL);
}

size_t json_text_scalar(json_text_t *self, const char **start)
{
    static const char letters[] =
        "+-._0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
    (void)json_text_peek(self);
    const size_t from = self->place;
    while ((next(self) != '\0') && (strchr(letters, next(self)) != NULL)) {
        self->place++;
    }
    *start = &self->bytes[from];
    return self->place - from;
}

static request_fault_t put(writer_t *out, const char *bytes, size_t count)
{
    if (count >= (out->size - out->length)) {
        return REQUEST_TOO_LONG;
    }
    (void)memcpy(&out->text[out->length], bytes, count);
    out->length += count;
    return REQUEST_OK;
}

/* The length of the UTF-8 sequence at this place, 0 when it is none. */
static size_t sequence_length(const json_text_t *self)
{
    const uint8_t *bytes = (const uint8_t *)&self->bytes[self->place];
    const size_t left = self->size - self->place;
    for (size_t i = 0U; i < (sizeof sequences / sizeof sequences[0]); i++) {
        const sequence_t *one = &sequences[i];
        if ((bytes[0] < one->first) || (bytes[0] > one->last) || (left < one->length)) {
            continue;
        }
        bool is_good = (one->length == 1U) || ((bytes[1] >= one->least) && (bytes[1] <= one->most));
        for (size_t at = 2U; at < one->length; at++) {
            is_good = is_good && ((bytes[at] & 0xC0U) == 0x80U);
        }
        return is_good ? one->length : 0U;
    }
    return 0U;
}

static request_fault_t put_character(writer_t *out, uint32_t code)
{
    static const uint32_t firsts[] = {0x80U, 0x800U, 0x10000U};
    static const uint8_t marks[] = {0x00U, 0xC0U, 0xE0U, 0xF0U};
    char bytes[SEQUENCE_MOST];
    size_t more = 0U; /* Bytes behind the first one. */
    while ((more < 3U) && (code >= firsts[more])) {
        more++;
    }
    for (size_t at = more; at > 0U; at--) {
        bytes[at] = (char)(0x80U | (code & 0x3FU));
        code >>= 6U;
    }
    bytes[0] = (char)(marks[more] | code);
    return put(out, bytes, more + 1U);
}

/* Four hexadecimal digits; UINT32_MAX when they are none. */
static uint32_t take_hex(json_text_t *self)
{
    static const char digits[] = "0123456789abcdef0123456789ABCDEF";
    uint32_t code = 0U;
    for (size_t i = 0U; i < HEX_DIGITS; i++) {
        const char *digit = (next(self) != '\0') ? strchr(digits, next(self)) : NULL;
        if (digit == NULL) {
            return UINT32_MAX;
        }
        code = (code * 16U) + ((uint32_t)(digit - digits) % 16U);
        self->place++;
    }
    return code;
}

static bool is_within(uint32_t code, uint32_t first, uint32_t last)
{
    return (code >= first) && (code <= last);
}

/* The digits behind \u. A character beyond 16 bits is two of these. */
static request_fault_t take_code(json_text_t *self, writer_t *out)
{
    uint32_t code = take_hex(self);
    if (is_within(code, 0xD800U, 0xDBFFU)) {
        const size_t left = self->size - self->place;
        if ((left < 2U) || (memcmp(&self->bytes[self->place], "\\u", 2U) != 0)) {
            return REQUEST_NOT_JSON;
        }
        self->place += 2U;
        const uint32_t low = take_hex(self);
        if (!is_within(low, 0xDC00U, 0xDFFFU)) {
            return REQUEST_NOT_JSON;
        }
        code = 0x10000U + ((code - 0xD800U) << 10U) + (low - 0xDC00U);
    }
    const bool is_alone = is_within(code, 0xDC00U, 0xDFFFU);
    return ((code == 0U) || (code == UINT32_MAX) || is_alone) ? REQUEST_NOT_JSON
                                                              : put_character(out, code);
}

static request_fault_t take_escape(json_text_t *self, writer_t *out)
{
    static const char letters[] = "\"\\/bfnrt";
    static const char meanings[] = "\"\\/\b\f\n\r\t";
    const char letter = next(self);
    const char *found = (letter != '\0') ? strchr(letters, letter) : NULL;
    if ((found == NULL) && (letter != 'u')) {
        return REQUEST_NOT_JSON;
    }
    self->place++;
    return (found == NULL) ? take_code(self, out) : put(out, &meanings[found - letters], 1U);
}

static request_fault_t take_character(json_text_t *self, writer_t *out)
{
    if (next(self) == '\\') {
        self->place++;
        return take_escape(self, out);
    }
    const size_t length = (self->place < self->size) ? sequence_length(self) : 0U;
    if (length == 0U) {
        return REQUEST_NOT_JSON;
    }
    const char *bytes = &self->bytes[self->place];
    self->place += length;
    return put(out, bytes, length);
}

request_fault_t json_text_string(json_text_t *self, char *text, size_t size)
{
    writer_t out = {.text = text, .size = size, .length = 0U};
    if (!json_text_take(self, '"')) {
        return REQUEST_NOT_JSON;
    }
    request_fault_t fault = REQUEST_OK;
    while ((fault == REQUEST_OK) && (next(self) != '"')) {
        fault = take_character(self, &out);
    }
    self->place += (fault == REQUEST_OK) ? 1U : 0U;
    text[out.length] = '\0';
    return fault;
}
