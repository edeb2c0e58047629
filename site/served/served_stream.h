/* SPDX-License-Identifier: Apache-2.0 */
/** @file The stream of the page, of which there is one: http_stream_serve() opens it anew. */
#ifndef BORESIGHT_SERVED_STREAM_H
#define BORESIGHT_SERVED_STREAM_H

#include "http/call/http_context.h"

#include <stddef.h>

#define SERVED_STREAM_BYTES (4U * HTTP_STREAM_FRAME_SIZE)

/** Sends what is new. A page that takes it slowly misses states; one that lets events fill the room
 * loses the stream. */
void served_stream_go_on(http_server_t *server);

/** Moves what was sent to the SERVED_STREAM_BYTES of `bytes`. Returns how many, 0 without a stream.
 */
size_t served_stream_take(char *bytes);

#endif
