/* SPDX-License-Identifier: Apache-2.0 */
/** @file What some headers of a request say. A missing header is NULL, and says nothing. */
#ifndef BORESIGHT_REQUEST_HEADERS_H
#define BORESIGHT_REQUEST_HEADERS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** Accept-Encoding: the client takes gzip (RFC 9110, 12.5.3). */
bool request_headers_take_gzip(const char *accept_encoding);

/**
 * If-None-Match: the client has what `etag`, with its quotes, stands for. Weak comparison
 * (RFC 9110, 13.1.2).
 */
bool request_headers_know(const char *if_none_match, const char *etag);

/** Content-Type: JSON, with any parameters; or the header is missing. */
bool request_headers_are_json(const char *content_type);

/** Content-Type: `media`, in lower case, with any parameters. */
bool request_headers_are(const char *content_type, const char *media);

/**
 * Cookie: the value of the cookie `name`, to `value` with its end. False when it is not there, or
 * there twice, or longer.
 */
bool request_headers_cookie(const char *cookie, const char *name, char *value, size_t size);

/**
 * Expect: the client, of HTTP `version` ("1.1"), holds back the body until it is asked to continue
 * (RFC 9110, 10.1.1).
 *
 * @satisfies SWR-HTTP-077
 */
bool request_headers_expect(const char *version, const char *expect);

/** A header that is a number, in decimal digits without zeros before them. False when it is none.
 */
bool request_headers_number(const char *header, uint32_t *number);

#endif
