/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The clients that may talk to the server: only requests that name it by an address it serves, and
 * no page of another site. This stops name rebinding and cross-site requests; it is not a login.
 */
#ifndef BORESIGHT_HTTP_GUARD_H
#define BORESIGHT_HTTP_GUARD_H

#include "http/login/tls_front.h"

#include <stdbool.h>
#include <stdint.h>

#define HTTP_GUARD_ADDRESS_SIZE 16U /**< Room for an IPv4 address in digits. */

typedef struct {
    char address[HTTP_GUARD_ADDRESS_SIZE]; /**< The address listened on. */
    uint32_t port;                         /**< The port listened on. */
    uint32_t page_port;                    /**< The port from which the console's page comes. */
    const tls_front_t *front;              /**< How TLS leads here; NULL: it does not. */
    uint32_t front_port;                   /**< The port of TLS that leads here. */
    bool is_front_only;                    /**< No client comes here but by TLS. */
} http_guard_t;

/** The origin that a request states in its headers; NULL for a header that it has not. */
typedef struct {
    const char *host;       /**< Host. */
    const char *origin;     /**< Origin. */
    const char *fetch_site; /**< Sec-Fetch-Site. */
} http_provenance_t;

typedef enum {
    HTTP_GUARD_PASS = 0,
    HTTP_GUARD_NO_HOST = 1,   /**< No host is named. */
    HTTP_GUARD_HOST = 2,      /**< Another host than those served is named. */
    HTTP_GUARD_ORIGIN = 3,    /**< Sent by a page from elsewhere. */
    HTTP_GUARD_CROSS_SITE = 4 /**< The browser says that another site sent it. */
} http_guard_verdict_t;

/**
 * Judges a request. The hosts served are the address listened on, 127.0.0.1 and localhost, each
 * with the port; by TLS those of its file. A browser always names the origin when it writes; where
 * no origin is named the sender is no page. Another port is the same site to a browser, and another
 * origin.
 *
 * @satisfies SWR-HTTP-004
 * @satisfies SWR-SESS-019
 */
http_guard_verdict_t http_guard_judge(const http_guard_t *self,
                                      const http_provenance_t *provenance);

#endif
