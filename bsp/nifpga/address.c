/* SPDX-License-Identifier: Apache-2.0 */
#include "nifpga/address.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#define SCHEME "nifpga:"
#define ACCEPTED ",accepted="

static bool refuse(const char *why, char *error, uint32_t error_size)
{
    (void)snprintf(error, error_size,
                   "The box's address %s; expected nifpga:RIO0,/path/NAME.lvbitx.", why);
    return false;
}

/* From `text` to before `end`. */
static bool take(char *to, size_t size, const char *text, const char *end)
{
    const size_t length = (size_t)(end - text);
    const bool fits = (length > 0U) && (length < size);

    if (fits) {
        (void)memcpy(to, text, length);
        to[length] = '\0';
    }
    return fits;
}

/* Last place of `what` in `text`: a path in which it stands too names no file. */
static const char *last(const char *text, const char *what)
{
    const char *found = NULL;

    for (const char *at = strstr(text, what); at != NULL; at = strstr(at + 1, what)) {
        found = at;
    }
    return found;
}

/* Year, month and day, as 2026-11-23, somewhere in it. */
static bool has_date(const char *text)
{
    static const char pattern[] = "0000-00-00";
    size_t fits = 0U;

    for (const char *at = text; (*at != '\0') && (pattern[fits] != '\0'); at++) {
        fits = 0U;
        while ((pattern[fits] != '\0') &&
               ((pattern[fits] == '-') ? (at[fits] == '-')
                                       : (isdigit((unsigned char)at[fits]) != 0))) {
            fits++;
        }
    }
    return pattern[fits] == '\0';
}

/* "no" is no acceptance. Letters beyond ASCII are letters. */
static bool has_name_and_date(const char *text)
{
    bool has_letter = false;

    for (const char *at = text; *at != '\0'; at++) {
        has_letter = has_letter || (isalpha((unsigned char)*at) != 0) || ((*at & 0x80) != 0);
    }
    return has_letter && has_date(text);
}

static bool take_accepted(address_t *self, const char *text)
{
    return (*text == '\0') || (strcmp(text, "-") == 0) ||
           take(self->accepted, sizeof self->accepted, text, text + strlen(text));
}

bool address_read(address_t *self, const char *text, char *error, uint32_t error_size)
{
    const char *const resource = text + strlen(SCHEME);

    (void)memset(self, 0, sizeof *self);
    if (strncmp(text, SCHEME, strlen(SCHEME)) != 0) {
        return refuse("does not begin with nifpga:", error, error_size);
    }
    const char *const comma = strchr(resource, ',');
    if ((comma == NULL) || !take(self->resource, sizeof self->resource, resource, comma)) {
        return refuse("names no FPGA", error, error_size);
    }
    const char *const accepted = last(comma, ACCEPTED);
    const char *const end = (accepted != NULL) ? accepted : (comma + strlen(comma));
    if ((comma[1] != '/') || !take(self->bitfile, sizeof self->bitfile, comma + 1, end)) {
        return refuse("names no bitfile by its whole path", error, error_size);
    }
    if ((accepted != NULL) && !take_accepted(self, accepted + strlen(ACCEPTED))) {
        return refuse("says too long who accepts the cards (at most 63 letters)", error,
                      error_size);
    }
    if ((self->accepted[0] != '\0') && !has_name_and_date(self->accepted)) {
        return refuse("does not say who accepts the cards, and when (\"A. Engineer, 2026-11-23\")",
                      error, error_size);
    }
    return true;
}
