/* SPDX-License-Identifier: Apache-2.0 */
#include "nifpga/address.h"

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
    const char *const accepted = strstr(comma, ACCEPTED);
    const char *const end = (accepted != NULL) ? accepted : (comma + strlen(comma));
    if ((comma[1] != '/') || !take(self->bitfile, sizeof self->bitfile, comma + 1, end)) {
        return refuse("names no bitfile by its whole path", error, error_size);
    }
    if ((accepted != NULL) && !take_accepted(self, accepted + strlen(ACCEPTED))) {
        return refuse("says too long who accepts the cards (at most 63 letters)", error,
                      error_size);
    }
    return true;
}
