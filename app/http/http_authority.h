/* SPDX-License-Identifier: Apache-2.0 */
/** @file The routes by which a page takes authority, keeps it and gives it up. */
#ifndef BORESIGHT_HTTP_AUTHORITY_H
#define BORESIGHT_HTTP_AUTHORITY_H

#include "http/http_call.h"
#include "http/http_server.h"

/** Answers who may command. Each returns the status sent. */
int http_authority_show(http_server_t *server, const http_call_t *call);

/** Takes what nobody has. */
int http_authority_take(http_server_t *server, const http_call_t *call);

/** Keeps it; it is not waited for. */
int http_authority_renew(http_server_t *server, const http_call_t *call);

/** Gives it up, and answers once it is gone. */
int http_authority_release(http_server_t *server, const http_call_t *call);

/** Asks for the button at the box. */
int http_authority_request(http_server_t *server, const http_call_t *call);

#endif
