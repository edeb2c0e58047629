/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Requests of a page, in the place of the library of HTTP: a request as its text and a reply as its
 * bytes, both as they would pass at a port. The handlers of app/http see no difference.
 */
#ifndef BORESIGHT_SITE_CONNECTION_H
#define BORESIGHT_SITE_CONNECTION_H

#include <civetweb.h>
#include <stdbool.h>
#include <stddef.h>

struct mg_connection {
    struct mg_request_info info;
    void *user_data;
    void *own_data; /**< Data of the connection. */
    const char *body;
    size_t body_size;
    char *reported; /**< The reply so far. */
    size_t room;
    size_t size;
};

/**
 * Reads the `size` bytes of `text`, a head with its empty line, and a body; they are changed and
 * must outlive `self`, whose reply goes to the `room` bytes of `reported`.
 *
 * @return false: it is no request
 */
bool connection_read(struct mg_connection *self, char *text, size_t size, char *reported,
                     size_t room);

#endif
