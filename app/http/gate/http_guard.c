/* SPDX-License-Identifier: Apache-2.0 */
#include "http/gate/http_guard.h"

#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

static bool is_host(const char *name, uint32_t port, const char *host)
{
    char expected[64];
    (void)snprintf(expected, sizeof expected, "%s:%u", name, (unsigned)port);
    bool is_default_port = (port == 80U) && (strcasecmp(host, name) == 0);
    return is_default_port || (strcasecmp(host, expected) == 0);
}

static bool is_served(const http_guard_t *self, uint32_t port, const char *host)
{
    return is_host(self->address, port, host) || is_host("127.0.0.1", port, host) ||
           is_host("localhost", port, host);
}

static bool is_own_origin(const http_guard_t *self, const char *origin)
{
    static const char scheme[] = "http://";
    size_t length = sizeof scheme - 1U;
    return (strncmp(origin, scheme, length) == 0) &&
           is_served(self, self->page_port, origin + length);
}

static bool is_page_of_front(const http_guard_t *self, const char *origin)
{
    static const char scheme[] = "https://";
    size_t length = sizeof scheme - 1U;
    return (self->front != NULL) && (strncmp(origin, scheme, length) == 0) &&
           tls_front_serves(self->front, self->front->console, origin + length);
}

static bool is_host_known(const http_guard_t *self, const char *host)
{
    return (!self->is_front_only && is_served(self, self->port, host)) ||
           ((self->front != NULL) && tls_front_serves(self->front, self->front_port, host));
}

static bool is_origin_known(const http_guard_t *self, const char *origin)
{
    return (!self->is_front_only && is_own_origin(self, origin)) || is_page_of_front(self, origin);
}

static bool is_own_site(const http_guard_t *self, const char *site)
{
    bool is_other_port = (self->page_port != self->port) && (strcmp(site, "same-site") == 0);
    return is_other_port || (strcmp(site, "same-origin") == 0) || (strcmp(site, "none") == 0);
}

http_guard_verdict_t http_guard_judge(const http_guard_t *self, const http_provenance_t *provenance)
{
    if (provenance->host == NULL) {
        return HTTP_GUARD_NO_HOST;
    }
    if (!is_host_known(self, provenance->host)) {
        return HTTP_GUARD_HOST;
    }
    if ((provenance->origin != NULL) && !is_origin_known(self, provenance->origin)) {
        return HTTP_GUARD_ORIGIN;
    }
    if ((provenance->fetch_site != NULL) && !is_own_site(self, provenance->fetch_site)) {
        return HTTP_GUARD_CROSS_SITE;
    }
    return HTTP_GUARD_PASS;
}
