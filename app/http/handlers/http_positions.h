/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Positions that people save and restore: the file goes out with the seal of the box; one that
 * comes is first shown beside what is, and then restored as it was shown, within a while.
 */
#ifndef BORESIGHT_HTTP_POSITIONS_H
#define BORESIGHT_HTTP_POSITIONS_H

#include "http/call/http_call.h"
#include "http/call/http_context.h"

/**
 * Takes the key of the box from the file `path` (NULL: none exists), making it if need be.
 * Without it nothing is saved, and no sealed file is taken; why is said on standard error.
 */
void http_positions_begin(http_server_t *server, const char *path);

#endif
