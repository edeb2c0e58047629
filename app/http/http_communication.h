/* SPDX-License-Identifier: Apache-2.0 */
/** @file The routes that show who has come, and order something of a connection of OpenIGTLink.
 * Each returns the status sent. */
#ifndef BORESIGHT_HTTP_COMMUNICATION_H
#define BORESIGHT_HTTP_COMMUNICATION_H

#include "http/http_call.h"
#include "http/http_server.h"

/** @satisfies SWR-IGTL-059 */
int http_communication_show(http_server_t *server, const http_call_t *call);

/** @satisfies SWR-IGTL-060 */
int http_communication_disconnect(http_server_t *server, const http_call_t *call);

/** @satisfies SWR-IGTL-061 */
int http_communication_keep_alive(http_server_t *server, const http_call_t *call);

#endif
