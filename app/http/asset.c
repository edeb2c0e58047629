/* SPDX-License-Identifier: Apache-2.0 */
#include "http/asset.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PAGE "/index.html"
#define STOP_PORT "name=\"boresight-stop-port\" content=\""
#define DIGITS 5U

static asset_t page; /* Once it has been told the port. */
static char page_tag[ASSET_ETAG_SIZE - 8U];

static const asset_t *find(const char *path)
{
    for (size_t i = 0; i < asset_count; i++) {
        if (strcmp(assets[i].path, path) == 0) {
            return &assets[i];
        }
    }
    return NULL;
}

void asset_tell_stop_port(uint32_t port)
{
    const asset_t *original = find(PAGE);
    unsigned char *bytes = malloc(original->size);
    if (bytes == NULL) {
        return;
    }
    (void)memcpy(bytes, original->bytes, original->size);
    unsigned char *place = memmem(bytes, original->size, STOP_PORT, sizeof STOP_PORT - 1U);
    if (place == NULL) {
        free(bytes);
        return;
    }
    char digits[16];
    (void)snprintf(digits, sizeof digits, "%05u", (unsigned)port);
    (void)memcpy(&place[sizeof STOP_PORT - 1U], digits, DIGITS);
    page = *original;
    (void)snprintf(page_tag, sizeof page_tag, "%s-%s", original->tag, digits);
    page.tag = page_tag;
    page.bytes = bytes;
    page.packed = NULL; /* It is short. */
    page.packed_size = 0U;
}

const asset_t *asset_find(const char *path)
{
    bool is_page = (strcmp(path, "/") == 0) || (strcmp(path, PAGE) == 0);
    if (!is_page) {
        return find(path);
    }
    return (page.bytes != NULL) ? &page : find(PAGE);
}

void asset_write_etag(const asset_t *asset, bool is_packed, char etag[ASSET_ETAG_SIZE])
{
    (void)snprintf(etag, ASSET_ETAG_SIZE, "\"%s%s\"", asset->tag, is_packed ? "-gzip" : "");
}
