/* SPDX-License-Identifier: Apache-2.0 */
#include "http/server/asset.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PAGE "/index.html"
#define STOP_PORT "name=\"boresight-stop-port\" content=\""
#define TLS_STOP_PORT "name=\"boresight-tls-stop-port\" content=\""
#define DIGITS 5U

static asset_t page; /* With the port, once it is known. */
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

static bool write_port(unsigned char *bytes, size_t size, const char *name, uint32_t port)
{
    char digits[16];
    unsigned char *place = memmem(bytes, size, name, strlen(name));
    (void)snprintf(digits, sizeof digits, "%05u", (unsigned)port);
    if (place != NULL) {
        (void)memcpy(&place[strlen(name)], digits, DIGITS);
    }
    return place != NULL;
}

void asset_report_stop_ports(uint32_t port, uint32_t tls_port)
{
    const asset_t *original = find(PAGE);
    unsigned char *bytes = malloc(original->size);
    if (bytes == NULL) {
        return;
    }
    (void)memcpy(bytes, original->bytes, original->size);
    if (!write_port(bytes, original->size, STOP_PORT, port) ||
        !write_port(bytes, original->size, TLS_STOP_PORT, tls_port)) {
        free(bytes);
        return;
    }
    page = *original;
    (void)snprintf(page_tag, sizeof page_tag, "%s-%05u-%05u", original->tag, (unsigned)port,
                   (unsigned)tls_port);
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
