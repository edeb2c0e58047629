/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Positions that people save and restore: the file goes out with the seal of the box; one that
 * comes is first shown beside what is, and then restored as it was shown, within a while.
 */
#ifndef BORESIGHT_HTTP_POSITIONS_H
#define BORESIGHT_HTTP_POSITIONS_H

#include "http/http_call.h"
#include "http/http_server.h"

/**
 * Takes the key of the box from the file `path` (NULL: there is none), making it if need be.
 * Without it nothing is saved, and no sealed file is taken; why is said on standard error.
 */
void http_positions_begin(http_server_t *server, const char *path);

/**
 * Answers the positions as a file.
 *
 * @satisfies SWR-STORE-024
 */
int http_positions_save(http_server_t *server, struct mg_connection *connection);

/**
 * Answers what restoring positions would do, and a token for it. The token before is worth nothing
 * any more.
 *
 * @satisfies SWR-STORE-027
 */
int http_positions_preview(http_server_t *server, const http_call_t *call);

/**
 * Restores what was shown, if it still is so.
 *
 * @satisfies SWR-STORE-030
 */
int http_positions_restore(http_server_t *server, const http_call_t *call);

#endif
