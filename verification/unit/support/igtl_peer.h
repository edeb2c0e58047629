/* SPDX-License-Identifier: Apache-2.0 */
/** @file A peer of the OpenIGTLink dialects in a test: makes messages, and reads an outbox as lines of text. */
#ifndef BORESIGHT_IGTL_PEER_H
#define BORESIGHT_IGTL_PEER_H

#include "igtl_codec.h"
#include "igtl_outbox.h"

#include <stdint.h>

/** A received STRING; `text` must outlive it. */
igtl_message_t igtl_peer_string(const char *name, const char *text);

/** A received TRANSFORM: no rotation, translated by (x, y, z) mm. */
igtl_message_t igtl_peer_transform(const char *name, float x, float y, float z);

/** A received message without content. */
igtl_message_t igtl_peer_query(igtl_kind_t kind, const char *name);

/**
 * The next message of the outbox as "TYPE name ...", or "" when there is none: STATUS with code, error name and text;
 * STRING with its text; TRANSFORM and POINT with their position in mm. Valid until the next call.
 */
const char *igtl_peer_next(igtl_outbox_t *outbox);

#endif
