/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A peer of the OpenIGTLink dialects in a test: makes messages, and reads an outbox as lines of
 * text. In the header alone, so that only the tests that include it need the outbox.
 */
#ifndef BORESIGHT_IGTL_PEER_H
#define BORESIGHT_IGTL_PEER_H

#include "igtl/wire/igtl_codec.h"
#include "igtl/wire/igtl_outbox.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

#define IGTL_PEER_POINT_POSITION 100U
#define IGTL_PEER_TRANSFORM_POSITION 36U
#define IGTL_PEER_TDATA_POSITION 58U
#define IGTL_PEER_SENSOR_VALUE 10U

static char igtl_peer_line[512];

/** A received STRING; `text` must outlive it. */
static inline igtl_message_t igtl_peer_string(const char *name, const char *text)
{
    igtl_message_t message = {
        .kind = IGTL_KIND_STRING, .text = text, .text_bytes = (uint32_t)strlen(text)};

    (void)snprintf(message.name, sizeof message.name, "%s", name);
    return message;
}

static inline uint32_t igtl_peer_bits_of(float number)
{
    uint32_t bits;

    (void)memcpy(&bits, &number, sizeof bits);
    return bits;
}

/** A received TRANSFORM: no rotation, translated by (x, y, z) mm. */
static inline igtl_message_t igtl_peer_transform(const char *name, float x, float y, float z)
{
    igtl_message_t message = {.kind = IGTL_KIND_TRANSFORM};

    (void)snprintf(message.name, sizeof message.name, "%s", name);
    message.numbers[0] = igtl_peer_bits_of(1.0F);
    message.numbers[4] = igtl_peer_bits_of(1.0F);
    message.numbers[8] = igtl_peer_bits_of(1.0F);
    message.numbers[9] = igtl_peer_bits_of(x);
    message.numbers[10] = igtl_peer_bits_of(y);
    message.numbers[11] = igtl_peer_bits_of(z);
    return message;
}

/** A received TRAJ of this type with its entry at (x, y, z) mm and its target 10 mm above. */
static inline igtl_message_t igtl_peer_trajectory(uint32_t type, float x, float y, float z)
{
    igtl_message_t message = {.kind = IGTL_KIND_TRAJECTORY, .name = "Path", .code = type};

    for (uint32_t i = 0U; i < IGTL_TRAJECTORY_NUMBERS; i += 3U) {
        message.numbers[i] = igtl_peer_bits_of(x);
        message.numbers[i + 1U] = igtl_peer_bits_of(y);
        message.numbers[i + 2U] = igtl_peer_bits_of((i == 0U) ? z : (z + 10.0F));
    }
    return message;
}

/** A received message without content. */
static inline igtl_message_t igtl_peer_query(igtl_kind_t kind, const char *name)
{
    igtl_message_t message = {.kind = kind};

    (void)snprintf(message.name, sizeof message.name, "%s", name);
    return message;
}

static inline double igtl_peer_number_at(const uint8_t *bytes)
{
    const uint32_t bits = ((uint32_t)bytes[0] << 24U) | ((uint32_t)bytes[1] << 16U) |
                          ((uint32_t)bytes[2] << 8U) | bytes[3];
    float number;

    (void)memcpy(&number, &bits, sizeof number);
    return (double)number;
}

static inline double igtl_peer_double_at(const uint8_t *bytes)
{
    uint64_t bits = 0U;
    double number;

    for (uint32_t i = 0U; i < 8U; i++) {
        bits = (bits << 8U) | bytes[i];
    }
    (void)memcpy(&number, &bits, sizeof number);
    return number;
}

static inline void igtl_peer_say_position(const char *type, const char *name, const uint8_t *bytes)
{
    (void)snprintf(igtl_peer_line, sizeof igtl_peer_line, "%s %s %.3f %.3f %.3f", type, name,
                   igtl_peer_number_at(bytes), igtl_peer_number_at(&bytes[4]),
                   igtl_peer_number_at(&bytes[8]));
}

/** CAPABILITY: its types; RTS_COMMAND (header version 2): id, name and text; another RTS_: its
 * status. */
static inline void igtl_peer_say_reply(const char *type, const char *name, const uint8_t *body,
                                       uint32_t length)
{
    const uint8_t *reply = &body[IGTL_EXTENSION_BYTES];
    size_t used = (size_t)snprintf(igtl_peer_line, sizeof igtl_peer_line, "%s %s", type, name);

    if (strcmp(type, "CAPABILITY") == 0) {
        for (uint32_t i = 0U; i < length; i += IGTL_TYPE_SIZE - 1U) {
            used += (size_t)snprintf(&igtl_peer_line[used], sizeof igtl_peer_line - used, " %.12s",
                                     (const char *)&body[i]);
        }
    } else if (strcmp(type, "RTS_COMMAND") == 0) {
        (void)snprintf(&igtl_peer_line[used], sizeof igtl_peer_line - used, " %u %s %.*s",
                       (unsigned)reply[3], (const char *)&reply[4], (int)reply[137],
                       (const char *)&reply[IGTL_COMMAND_BYTES]);
    } else {
        (void)snprintf(&igtl_peer_line[used], sizeof igtl_peer_line - used, " %d", (int)body[0]);
    }
}

static inline void igtl_peer_say(const uint8_t *bytes, uint32_t length)
{
    const uint8_t *body = &bytes[IGTL_HEADER_BYTES];
    char type[IGTL_TYPE_SIZE] = "";
    char name[IGTL_NAME_SIZE] = "";

    (void)memcpy(type, &bytes[2], IGTL_TYPE_SIZE - 1U);
    (void)memcpy(name, &bytes[14], IGTL_NAME_SIZE - 1U);
    if (strcmp(type, "STATUS") == 0) {
        (void)snprintf(igtl_peer_line, sizeof igtl_peer_line, "STATUS %s %u %.20s|%s", name,
                       (unsigned)(((uint32_t)body[0] << 8U) | body[1]), (const char *)&body[10],
                       (const char *)&body[IGTL_STATUS_BYTES]);
    } else if (strcmp(type, "STRING") == 0) {
        (void)snprintf(igtl_peer_line, sizeof igtl_peer_line, "STRING %s %.*s", name,
                       (int)(length - IGTL_HEADER_BYTES - 4U), (const char *)&body[4]);
    } else if (length == IGTL_HEADER_BYTES) {
        (void)snprintf(igtl_peer_line, sizeof igtl_peer_line, "%s %s nothing", type, name);
    } else if (strcmp(type, "POINT") == 0) {
        igtl_peer_say_position(type, name, &body[IGTL_PEER_POINT_POSITION]);
    } else if (strcmp(type, "TDATA") == 0) {
        igtl_peer_say_position(type, name, &body[IGTL_PEER_TDATA_POSITION]);
    } else if (strcmp(type, "SENSOR") == 0) {
        (void)snprintf(igtl_peer_line, sizeof igtl_peer_line, "SENSOR %s %u x %.3f", name,
                       (unsigned)body[0], igtl_peer_double_at(&body[IGTL_PEER_SENSOR_VALUE]));
    } else if ((strncmp(type, "RTS_", 4U) == 0) || (strcmp(type, "CAPABILITY") == 0)) {
        igtl_peer_say_reply(type, name, body, length - IGTL_HEADER_BYTES);
    } else {
        igtl_peer_say_position(type, name, &body[IGTL_PEER_TRANSFORM_POSITION]);
    }
}

/**
 * The next message of the outbox as "TYPE name ...", or "" when there is none: STATUS with code,
 * error name and text; STRING with its text; TRANSFORM, POINT and TDATA with their position in mm;
 * SENSOR with the number of its values and the first;
 * what has no body with "nothing". Valid until the next call.
 */
static inline const char *igtl_peer_next(igtl_outbox_t *outbox)
{
    uint32_t length;
    const uint8_t *bytes = igtl_outbox_next(outbox, &length);

    igtl_peer_line[0] = '\0';
    if (bytes != NULL) {
        igtl_peer_say(bytes, length);
        igtl_outbox_advance(outbox, length);
    }
    return igtl_peer_line;
}

#endif
