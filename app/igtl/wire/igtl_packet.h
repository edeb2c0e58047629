/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * OpenIGTLink messages to be sent, complete and with header version 1; igtl_packet_extend() makes
 * version 2 of them. Numbers are the bits of the wire (igtl_units.h).
 */
#ifndef BORESIGHT_IGTL_PACKET_H
#define BORESIGHT_IGTL_PACKET_H

#include "igtl/wire/igtl_codec.h"

#include <stdbool.h>
#include <stdint.h>

#define IGTL_TEXT_MAX 255U        /**< Longest text that is sent. */
#define IGTL_CAPABILITIES_MAX 32U /**< Most types that are named at once. */
#define IGTL_TRACKED_MAX 4U       /**< Most elements of a TDATA. */
#define IGTL_METADATA_MAX 27U     /**< One entry, and its count. */
#define IGTL_PACKET_MAX                                                                            \
    (IGTL_HEADER_BYTES + IGTL_EXTENSION_BYTES + IGTL_COMMAND_BYTES + IGTL_TEXT_MAX +               \
     IGTL_METADATA_MAX)

typedef struct {
    uint32_t length;
    uint8_t bytes[IGTL_PACKET_MAX];
} igtl_packet_t;

/**
 * Writers. Names beyond 20 and texts beyond IGTL_TEXT_MAX characters are cut; `timestamp` is in
 * units of 2^-32 s since 1970, 0 for none.
 *
 * @satisfies SWR-IGTL-005
 * @satisfies SWR-IGTL-019
 * @satisfies SWR-IGTL-022
 */
void igtl_encode_transform(igtl_packet_t *packet, const char *name,
                           const uint32_t numbers[IGTL_TRANSFORM_NUMBERS], uint64_t timestamp);
void igtl_encode_string(igtl_packet_t *packet, const char *name, const char *text,
                        uint64_t timestamp);
void igtl_encode_point(igtl_packet_t *packet, const char *name, const uint32_t numbers[3],
                       uint64_t timestamp);

/** Content of a STATUS. `error_name` is cut to 19 characters. */
typedef struct {
    uint32_t code;
    const char *error_name;
    const char *text;
} igtl_status_t;

void igtl_encode_status(igtl_packet_t *packet, const char *name, const igtl_status_t *status,
                        uint64_t timestamp);

/** Nothing of a `type` (of up to 12 characters): the answer to a query when none exists. */
void igtl_encode_empty(igtl_packet_t *packet, const char *type, const char *name,
                       uint64_t timestamp);

/** CAPABILITY: `count` types, at most IGTL_CAPABILITIES_MAX. */
void igtl_encode_capability(igtl_packet_t *packet, const char *name, const char *const *types,
                            uint32_t count, uint64_t timestamp);

/** The answer of `type`, "RTS_...", to a start or stop of a stream. */
void igtl_encode_return(igtl_packet_t *packet, const char *type, const char *name, bool is_refused,
                        uint64_t timestamp);

/** One instrument of six degrees of freedom in a TDATA. `name` is cut to 19 characters. */
typedef struct {
    const char *name;
    uint32_t numbers[IGTL_TRANSFORM_NUMBERS];
} igtl_tracked_t;

/** TDATA of `count` elements, at most IGTL_TRACKED_MAX. */
void igtl_encode_tracking(igtl_packet_t *packet, const char *name, const igtl_tracked_t *elements,
                          uint32_t count, uint64_t timestamp);

/** SENSOR of one force: `newtons` are the bits of a double. */
void igtl_encode_force(igtl_packet_t *packet, const char *name, uint64_t newtons,
                       uint64_t timestamp);

/** RTS_COMMAND: the answer to the COMMAND `command`, with its id and names. Version 2 for each
 * peer: the metadata states whether it was carried out. */
void igtl_encode_command_reply(igtl_packet_t *packet, const igtl_message_t *command,
                               bool is_refused, const char *text, uint64_t timestamp);

/**
 * Writes `packet` to `extended` as version 2: a TRANSFORM with the metadata TransformStatus = OK,
 * a POINT without a point with Status = OK, others without any. One that is of version 2 already is
 * copied.
 *
 * @satisfies SWR-IGTL-005
 */
void igtl_packet_extend(igtl_packet_t *extended, const igtl_packet_t *packet);

#endif
