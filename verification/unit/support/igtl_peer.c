/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl_peer.h"

#include <stdio.h>
#include <string.h>

#define POINT_POSITION 100U
#define TRANSFORM_POSITION 36U

static char line[512];

igtl_message_t igtl_peer_string(const char *name, const char *text)
{
    igtl_message_t message = {.kind = IGTL_KIND_STRING, .text = text, .text_bytes = (uint32_t)strlen(text)};

    (void)snprintf(message.name, sizeof message.name, "%s", name);
    return message;
}

static uint32_t bits_of(float number)
{
    uint32_t bits;

    (void)memcpy(&bits, &number, sizeof bits);
    return bits;
}

igtl_message_t igtl_peer_transform(const char *name, float x, float y, float z)
{
    igtl_message_t message = {.kind = IGTL_KIND_TRANSFORM};

    (void)snprintf(message.name, sizeof message.name, "%s", name);
    message.numbers[0] = bits_of(1.0F);
    message.numbers[4] = bits_of(1.0F);
    message.numbers[8] = bits_of(1.0F);
    message.numbers[9] = bits_of(x);
    message.numbers[10] = bits_of(y);
    message.numbers[11] = bits_of(z);
    return message;
}

igtl_message_t igtl_peer_query(igtl_kind_t kind, const char *name)
{
    igtl_message_t message = {.kind = kind};

    (void)snprintf(message.name, sizeof message.name, "%s", name);
    return message;
}

static double number_at(const uint8_t *bytes)
{
    const uint32_t bits = ((uint32_t)bytes[0] << 24U) | ((uint32_t)bytes[1] << 16U) |
                          ((uint32_t)bytes[2] << 8U) | bytes[3];
    float number;

    (void)memcpy(&number, &bits, sizeof number);
    return (double)number;
}

static void say_position(const char *type, const char *name, const uint8_t *bytes)
{
    (void)snprintf(line, sizeof line, "%s %s %.3f %.3f %.3f", type, name, number_at(bytes),
                   number_at(&bytes[4]), number_at(&bytes[8]));
}

static void say(const uint8_t *bytes, uint32_t length)
{
    const uint8_t *body = &bytes[IGTL_HEADER_BYTES];
    char type[IGTL_TYPE_SIZE] = "";
    char name[IGTL_NAME_SIZE] = "";

    (void)memcpy(type, &bytes[2], IGTL_TYPE_SIZE - 1U);
    (void)memcpy(name, &bytes[14], IGTL_NAME_SIZE - 1U);
    if (strcmp(type, "STATUS") == 0) {
        (void)snprintf(line, sizeof line, "STATUS %s %u %.20s|%s", name,
                       (unsigned)(((uint32_t)body[0] << 8U) | body[1]), (const char *)&body[10],
                       (const char *)&body[IGTL_STATUS_BYTES]);
    } else if (strcmp(type, "STRING") == 0) {
        (void)snprintf(line, sizeof line, "STRING %s %.*s", name, (int)(length - IGTL_HEADER_BYTES - 4U),
                       (const char *)&body[4]);
    } else if (strcmp(type, "POINT") == 0) {
        say_position(type, name, &body[POINT_POSITION]);
    } else {
        say_position(type, name, &body[TRANSFORM_POSITION]);
    }
}

const char *igtl_peer_next(igtl_outbox_t *outbox)
{
    uint32_t length;
    const uint8_t *bytes = igtl_outbox_next(outbox, &length);

    line[0] = '\0';
    if (bytes != NULL) {
        say(bytes, length);
        igtl_outbox_advance(outbox, length);
    }
    return line;
}
