/* SPDX-License-Identifier: Apache-2.0 */
#include "http_guard.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

static bool is_host(const http_guard_t *self, const char *name, const char *host)
{
    char expected[64];
    (void)snprintf(expected, sizeof(expected), "%s:%u", name, (unsigned)self->port);
    bool is_default_port = (self->port == 80U) && (strcasecmp(host, name) == 0);
    return is_default_port || (strcasecmp(host, expected) == 0);
}

static bool is_served(const http_guard_t *self, const char *host)
{
    return is_host(self, self->address, host) || is_host(self, "127.0.0.1", host) ||
           is_host(self, "localhost", host);
}

static bool is_own_origin(const http_guard_t *self, const char *origin)
{
    static const char scheme[] = "http://";
    size_t length = sizeof(scheme) - 1U;
    return (strncmp(origin, scheme, length) == 0) && is_served(self, origin + length);
}

http_guard_verdict_t http_guard_judge(const http_guard_t *self, const http_provenance_t *provenance)
{
    if (provenance->host == NULL) {
        return HTTP_GUARD_NO_HOST;
    }
    if (!is_served(self, provenance->host)) {
        return HTTP_GUARD_HOST;
    }
    if ((provenance->origin != NULL) && !is_own_origin(self, provenance->origin)) {
        return HTTP_GUARD_ORIGIN;
    }
    const char *site = provenance->fetch_site;
    if ((site != NULL) && (strcmp(site, "same-origin") != 0) && (strcmp(site, "none") != 0)) {
        return HTTP_GUARD_CROSS_SITE;
    }
    return HTTP_GUARD_PASS;
}
