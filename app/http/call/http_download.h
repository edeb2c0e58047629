/* SPDX-License-Identifier: Apache-2.0 */
/** @file Sends files of the archive, in pieces; who does not take them is left. */
#ifndef BORESIGHT_HTTP_DOWNLOAD_H
#define BORESIGHT_HTTP_DOWNLOAD_H

#include "recording/archive/archive_folder.h"

#include <civetweb.h>

/**
 * Sends `file` of the media type `type`, and closes it. A client that has it already, or asks for
 * the head, gets the head.
 *
 * @return the status sent, or 0 when the client did not take all of it
 *
 * @satisfies SWR-HTTP-045
 * @satisfies SWR-HTTP-046
 * @satisfies SWR-HTTP-048
 */
int http_download_send(struct mg_connection *connection, archive_file_t *file, const char *type);

#endif
