/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/wire/igtl_packet.h"

#include "igtl/wire/big_endian.h"
#include "igtl/wire/igtl_crc64.h"

#include <string.h>

#define TYPE_OFFSET 2U
#define TYPE_BYTES (IGTL_TYPE_SIZE - 1U)
#define NAME_OFFSET 14U
#define NAME_BYTES (IGTL_NAME_SIZE - 1U)
#define TIME_OFFSET 34U
#define LENGTH_OFFSET 42U
#define CRC_OFFSET 50U
#define POINT_NAME_BYTES 64U
#define POINT_COLOUR 96U
#define POINT_POSITION 100U
#define TRACKED_BYTES 70U
#define TRACKED_NAME_BYTES 20U
#define TRACKED_NUMBERS 22U
#define TRACKED_OF_SIX 2U
#define SENSOR_BYTES 18U
#define SENSOR_UNIT 2U
#define SENSOR_VALUE 10U
#define UNIT_NEWTON                                                                                \
    UINT64_C(0x02C4000000000000) /* No prefix; the derived unit 11, to the power 1. */

/* The rest of the field is NUL. */
static void put_bytes(uint8_t *field, size_t size, const char *bytes, size_t count)
{
    (void)memcpy(field, bytes, count);
    (void)memset(&field[count], 0, size - count);
}

/* At most `most` characters of the text. */
static void put_text(uint8_t *field, size_t size, const char *text, size_t most)
{
    put_bytes(field, size, text, strnlen(text, most));
}

static void put_numbers(uint8_t *bytes, const uint32_t *numbers, uint32_t count)
{
    for (uint32_t i = 0U; i < count; i++) {
        put_u32(&bytes[4U * i], numbers[i]);
    }
}

/* The header; where the body goes. `type` fills its field with NULs. */
static uint8_t *begin(igtl_packet_t *packet, const char *type, const char *name, uint32_t bytes,
                      uint64_t timestamp)
{
    packet->length = IGTL_HEADER_BYTES + bytes;
    put_u16(packet->bytes, 1U);
    (void)memcpy(&packet->bytes[TYPE_OFFSET], type, TYPE_BYTES);
    put_text(&packet->bytes[NAME_OFFSET], NAME_BYTES, name, NAME_BYTES);
    put_u64(&packet->bytes[TIME_OFFSET], timestamp);
    put_u64(&packet->bytes[LENGTH_OFFSET], bytes);
    return &packet->bytes[IGTL_HEADER_BYTES];
}

/* The body is complete. */
static void seal(igtl_packet_t *packet)
{
    put_u64(&packet->bytes[CRC_OFFSET],
            igtl_crc64(0U, &packet->bytes[IGTL_HEADER_BYTES], packet->length - IGTL_HEADER_BYTES));
}

void igtl_encode_transform(igtl_packet_t *packet, const char *name,
                           const uint32_t numbers[IGTL_TRANSFORM_NUMBERS], uint64_t timestamp)
{
    static const char type[TYPE_BYTES] = "TRANSFORM";

    put_numbers(begin(packet, type, name, IGTL_TRANSFORM_BYTES, timestamp), numbers,
                IGTL_TRANSFORM_NUMBERS);
    seal(packet);
}

void igtl_encode_string(igtl_packet_t *packet, const char *name, const char *text,
                        uint64_t timestamp)
{
    static const char type[TYPE_BYTES] = "STRING";
    const uint32_t length = (uint32_t)strnlen(text, IGTL_TEXT_MAX);
    uint8_t *body = begin(packet, type, name, 4U + length, timestamp);

    put_u16(&body[0], IGTL_ENCODING_ASCII);
    put_u16(&body[2], length);
    (void)memcpy(&body[4], text, length);
    seal(packet);
}

void igtl_encode_point(igtl_packet_t *packet, const char *name, const uint32_t numbers[3],
                       uint64_t timestamp)
{
    static const char type[TYPE_BYTES] = "POINT";
    uint8_t *body = begin(packet, type, name, IGTL_POINT_BYTES, timestamp);

    (void)memset(body, 0, IGTL_POINT_BYTES);
    put_text(body, POINT_NAME_BYTES, name, POINT_NAME_BYTES - 1U);
    (void)memset(&body[POINT_COLOUR], 0xFF, 4U);
    put_numbers(&body[POINT_POSITION], numbers, 3U);
    seal(packet);
}

void igtl_encode_status(igtl_packet_t *packet, const char *name, const igtl_status_t *status,
                        uint64_t timestamp)
{
    static const char type[TYPE_BYTES] = "STATUS";
    const uint32_t length = (uint32_t)strnlen(status->text, IGTL_TEXT_MAX);
    uint8_t *body = begin(packet, type, name, IGTL_STATUS_BYTES + length + 1U, timestamp);

    put_u16(&body[0], status->code);
    put_u64(&body[2], 0U);
    put_text(&body[IGTL_STATUS_NAME_OFFSET], IGTL_STATUS_NAME_BYTES, status->error_name,
             IGTL_STATUS_NAME_BYTES - 1U);
    put_text(&body[IGTL_STATUS_BYTES], length + 1U, status->text, length);
    seal(packet);
}

void igtl_encode_empty(igtl_packet_t *packet, const char *type, const char *name,
                       uint64_t timestamp)
{
    char field[TYPE_BYTES];

    put_text((uint8_t *)field, TYPE_BYTES, type, TYPE_BYTES);
    (void)begin(packet, field, name, 0U, timestamp);
    seal(packet);
}

void igtl_encode_capability(igtl_packet_t *packet, const char *name, const char *const *types,
                            uint32_t count, uint64_t timestamp)
{
    static const char type[TYPE_BYTES] = "CAPABILITY";
    const uint32_t most = (count < IGTL_CAPABILITIES_MAX) ? count : IGTL_CAPABILITIES_MAX;
    uint8_t *body = begin(packet, type, name, TYPE_BYTES * most, timestamp);

    for (uint32_t i = 0U; i < most; i++) {
        put_text(&body[TYPE_BYTES * i], TYPE_BYTES, types[i], TYPE_BYTES);
    }
    seal(packet);
}

void igtl_encode_return(igtl_packet_t *packet, const char *type, const char *name, bool is_refused,
                        uint64_t timestamp)
{
    char field[TYPE_BYTES];

    put_text((uint8_t *)field, TYPE_BYTES, type, TYPE_BYTES);
    *begin(packet, field, name, 1U, timestamp) = is_refused ? 1U : 0U;
    seal(packet);
}

void igtl_encode_tracking(igtl_packet_t *packet, const char *name, const igtl_tracked_t *elements,
                          uint32_t count, uint64_t timestamp)
{
    static const char type[TYPE_BYTES] = "TDATA";
    const uint32_t most = (count < IGTL_TRACKED_MAX) ? count : IGTL_TRACKED_MAX;
    uint8_t *body = begin(packet, type, name, TRACKED_BYTES * most, timestamp);

    for (uint32_t i = 0U; i < most; i++) {
        uint8_t *element = &body[TRACKED_BYTES * i];

        put_text(element, TRACKED_NAME_BYTES, elements[i].name, TRACKED_NAME_BYTES - 1U);
        element[TRACKED_NAME_BYTES] = TRACKED_OF_SIX;
        element[TRACKED_NAME_BYTES + 1U] = 0U;
        put_numbers(&element[TRACKED_NUMBERS], elements[i].numbers, IGTL_TRANSFORM_NUMBERS);
    }
    seal(packet);
}

void igtl_encode_force(igtl_packet_t *packet, const char *name, uint64_t newtons,
                       uint64_t timestamp)
{
    static const char type[TYPE_BYTES] = "SENSOR";
    uint8_t *body = begin(packet, type, name, SENSOR_BYTES, timestamp);

    body[0] = 1U; /* So many values. */
    body[1] = 0U; /* Reserved. */
    put_u64(&body[SENSOR_UNIT], UNIT_NEWTON);
    put_u64(&body[SENSOR_VALUE], newtons);
    seal(packet);
}

/* The message once more, between an extended header and the metadata; none when `key` is empty. */
static void extend(igtl_packet_t *extended, const igtl_packet_t *packet, const char *key,
                   const char *value)
{
    const uint32_t content_bytes = packet->length - IGTL_HEADER_BYTES;
    const uint32_t key_bytes = (uint32_t)strlen(key);
    const uint32_t value_bytes = (uint32_t)strlen(value);
    const uint32_t entries = (key_bytes > 0U) ? 1U : 0U;
    const uint32_t metadata_bytes = 2U + (8U * entries);
    uint8_t *body = &extended->bytes[IGTL_HEADER_BYTES];
    uint8_t *metadata = &body[IGTL_EXTENSION_BYTES + content_bytes];

    (void)memcpy(extended->bytes, packet->bytes, LENGTH_OFFSET);
    (void)memcpy(&body[IGTL_EXTENSION_BYTES], &packet->bytes[IGTL_HEADER_BYTES], content_bytes);
    extended->length =
        packet->length + IGTL_EXTENSION_BYTES + metadata_bytes + key_bytes + value_bytes;
    put_u16(extended->bytes, 2U);
    put_u64(&extended->bytes[LENGTH_OFFSET], extended->length - IGTL_HEADER_BYTES);
    put_u16(&body[0], IGTL_EXTENSION_BYTES);
    put_u16(&body[2], metadata_bytes);
    put_u32(&body[4], key_bytes + value_bytes);
    put_u32(&body[8], 0U);
    put_u16(metadata, entries);
    if (entries > 0U) {
        put_u16(&metadata[2], key_bytes);
        put_u16(&metadata[4], IGTL_ENCODING_ASCII);
        put_u32(&metadata[6], value_bytes);
        (void)memcpy(&metadata[10], key, key_bytes);
        (void)memcpy(&metadata[10U + key_bytes], value, value_bytes);
    }
    seal(extended);
}

void igtl_encode_command_reply(igtl_packet_t *packet, const igtl_message_t *command,
                               bool is_refused, const char *text, uint64_t timestamp)
{
    static const char type[TYPE_BYTES] = "RTS_COMMAND";
    const uint32_t length = (uint32_t)strnlen(text, IGTL_TEXT_MAX);
    igtl_packet_t plain;
    uint8_t *body = begin(&plain, type, command->name, IGTL_COMMAND_BYTES + length, timestamp);

    put_u32(&body[0], command->code);
    put_bytes(&body[4], IGTL_COMMAND_NAME_BYTES, command->subject, command->subject_bytes);
    put_u16(&body[4U + IGTL_COMMAND_NAME_BYTES], IGTL_ENCODING_ASCII);
    put_u32(&body[6U + IGTL_COMMAND_NAME_BYTES], length);
    (void)memcpy(&body[IGTL_COMMAND_BYTES], text, length);
    extend(packet, &plain, "Status", is_refused ? "FAIL" : "SUCCESS");
}

void igtl_packet_extend(igtl_packet_t *extended, const igtl_packet_t *packet)
{
    static const char transform[TYPE_BYTES] = "TRANSFORM";
    static const char point[TYPE_BYTES] = "POINT";
    const uint8_t *const type = &packet->bytes[TYPE_OFFSET];
    const bool is_transform = memcmp(type, transform, TYPE_BYTES) == 0;
    const bool is_no_point =
        (memcmp(type, point, TYPE_BYTES) == 0) && (packet->length == IGTL_HEADER_BYTES);

    if (get_u16(packet->bytes) != 1U) {
        extended->length = packet->length;
        (void)memcpy(extended->bytes, packet->bytes, packet->length);
    } else if (is_transform) {
        extend(extended, packet, "TransformStatus", "OK");
    } else if (is_no_point) {
        /* libOpenIGTLink reads no body without metadata; its clients would keep the old point. */
        extend(extended, packet, "Status", "OK");
    } else {
        extend(extended, packet, "", "");
    }
}
