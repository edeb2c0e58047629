/* SPDX-License-Identifier: Apache-2.0 */
/** @file The routes of what was recorded: the log of events, its files, and the recordings. */
#ifndef BORESIGHT_HTTP_ARCHIVE_H
#define BORESIGHT_HTTP_ARCHIVE_H

#include "http/http_call.h"
#include "http/http_server.h"

/**
 * Each answers its route.
 *
 * @return the status sent
 *
 * @satisfies SWR-HTTP-041
 */
int http_archive_log(http_server_t *server, const http_call_t *call);
/** @satisfies SWR-HTTP-042 */
int http_archive_log_csv(http_server_t *server, const http_call_t *call);
/** @satisfies SWR-HTTP-043 */
int http_archive_logs(http_server_t *server, const http_call_t *call);
int http_archive_log_file(http_server_t *server, const http_call_t *call);
/** @satisfies SWR-HTTP-044 */
int http_archive_recordings(http_server_t *server, const http_call_t *call);
int http_archive_recording(http_server_t *server, const http_call_t *call);
/** @satisfies SWR-HTTP-049 */
int http_archive_log_level(http_server_t *server, const http_call_t *call);
int http_archive_set_log_level(http_server_t *server, const http_call_t *call);

#endif
