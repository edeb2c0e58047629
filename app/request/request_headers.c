/* SPDX-License-Identifier: Apache-2.0 */
#include "request/request_headers.h"

#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#define SPACE " \t"
#define DIGITS_MOST 10U /* Digits of 32 bits. */

/* The word at the start of `text`, which ends before one of `ends`, is `word`. */
static bool is_word(const char *text, const char *ends, const char *word)
{
    const size_t length = strcspn(text, ends);
    return (length == strlen(word)) && (strncasecmp(text, word, length) == 0);
}

/* The text behind a coding: a weight of zero means that it is not taken. */
static bool has_weight(const char *item)
{
    const char *rest = &item[strcspn(item, ",;")];
    if (*rest != ';') {
        return true;
    }
    rest = &rest[1U + strspn(&rest[1], SPACE)];
    return (strncasecmp(rest, "q=", 2U) != 0) || (strtod(&rest[2], NULL) > 0.0);
}

/* The next item of a list between commas; NULL: none exists. */
static const char *next_item(const char *item)
{
    const char *comma = strchr(item, ',');
    return (comma != NULL) ? &comma[1U + strspn(&comma[1], SPACE)] : NULL;
}

bool request_headers_expect(const char *version, const char *expect)
{
    bool is_held = false;
    for (const char *item = expect; item != NULL; item = next_item(item)) {
        is_held = is_held || is_word(item, " \t,", "100-continue");
    }
    return is_held && (strcmp(version, "1.0") != 0);
}

bool request_headers_take_gzip(const char *accept_encoding)
{
    bool takes_others = false;
    for (const char *item = accept_encoding; item != NULL; item = next_item(item)) {
        if (is_word(item, " \t,;", "gzip")) {
            return has_weight(item);
        }
        takes_others = takes_others || (is_word(item, " \t,;", "*") && has_weight(item));
    }
    return takes_others;
}

bool request_headers_know(const char *if_none_match, const char *etag)
{
    for (const char *item = if_none_match; item != NULL; item = next_item(item)) {
        const char *tag = (strncmp(item, "W/", 2U) == 0) ? &item[2] : item;
        const size_t length = strlen(etag);
        const bool is_end = (strncmp(tag, etag, length) == 0) &&
                            ((tag[length] == '\0') || (strchr(" \t,", tag[length]) != NULL));
        if (is_end || is_word(tag, " \t,", "*")) {
            return true;
        }
    }
    return false;
}

bool request_headers_are_json(const char *content_type)
{
    return (content_type == NULL) || is_word(content_type, " \t;", "application/json");
}

bool request_headers_are(const char *content_type, const char *media)
{
    return (content_type != NULL) && is_word(content_type, " \t;", media);
}

bool request_headers_cookie(const char *cookie, const char *name, char *value, size_t size)
{
    const size_t length = strlen(name);
    unsigned found = 0U;
    for (const char *pair = cookie; pair != NULL; pair = strchr(pair, ';')) {
        pair = &pair[strspn(pair, "; \t")];
        const char *said = &pair[length + 1U];
        if ((strncmp(pair, name, length) == 0) && (pair[length] == '=')) {
            const size_t bytes = strcspn(said, "; \t");
            found += (bytes < size) ? 1U : 2U;
            (void)snprintf(value, size, "%.*s", (int)bytes, said);
        }
    }
    return found == 1U;
}

bool request_headers_number(const char *header, uint32_t *number)
{
    const size_t length = (header != NULL) ? strlen(header) : 0U;
    if ((length == 0U) || (length > DIGITS_MOST) || (strspn(header, "0123456789") != length) ||
        ((header[0] == '0') && (length > 1U))) {
        return false;
    }
    const unsigned long long value = strtoull(header, NULL, 10);
    *number = (uint32_t)value;
    return value <= UINT32_MAX;
}
