/* SPDX-License-Identifier: Apache-2.0 */
#include "message/igtl_codec.h"

#include "limits/requirement_limits.h"

#include <stdbool.h>
#include <string.h>

#define EXTENSION_BYTES 12U
#define METADATA_ENTRY_BYTES 8U
#define STATUS_NAME_BYTES 20U
#define POINT_NAME_BYTES 64U
#define POINT_COLOUR 96U
#define POINT_POSITION 100U
#define ENCODING_ASCII 3U
#define ENCODING_UTF8 106U

uint64_t igtl_crc64(uint64_t crc, const uint8_t *bytes, size_t length)
{
    static const uint64_t table[16] = {
        UINT64_C(0x0000000000000000), UINT64_C(0x42F0E1EBA9EA3693), UINT64_C(0x85E1C3D753D46D26),
        UINT64_C(0xC711223CFA3E5BB5), UINT64_C(0x493366450E42ECDF), UINT64_C(0x0BC387AEA7A8DA4C),
        UINT64_C(0xCCD2A5925D9681F9), UINT64_C(0x8E224479F47CB76A), UINT64_C(0x9266CC8A1C85D9BE),
        UINT64_C(0xD0962D61B56FEF2D), UINT64_C(0x17870F5D4F51B498), UINT64_C(0x5577EEB6E6BB820B),
        UINT64_C(0xDB55AACF12C73561), UINT64_C(0x99A54B24BB2D03F2), UINT64_C(0x5EB4691841135847),
        UINT64_C(0x1C4488F3E8F96ED4)};

    for (size_t i = 0U; i < length; i++) {
        crc = (crc << 4U) ^ table[(crc >> 60U) ^ (uint64_t)(bytes[i] >> 4U)];
        crc = (crc << 4U) ^ table[(crc >> 60U) ^ (uint64_t)(bytes[i] & 15U)];
    }
    return crc;
}

const char *igtl_result_text(igtl_result_t result)
{
    switch (result) {
    case IGTL_OK:
        return "OK: Well formed.";
    case IGTL_BAD_VERSION:
        return "BAD_VERSION: The header version is neither 1 nor 2.";
    case IGTL_BAD_NAME:
        return "BAD_NAME: The type or the device name is not printable ASCII.";
    case IGTL_TOO_LONG:
        return "TOO_LONG: The body is longer than is accepted.";
    case IGTL_BAD_CRC:
        return "BAD_CRC: The checksum of the body is wrong.";
    case IGTL_BAD_EXTENSION:
        return "BAD_EXTENSION: The extended header does not fit the body.";
    case IGTL_BAD_METADATA:
        return "BAD_METADATA: The metadata does not fit its lengths.";
    case IGTL_BAD_LENGTH:
        return "BAD_LENGTH: The length is not that of the type.";
    case IGTL_BAD_ENCODING:
        return "BAD_ENCODING: The text is neither US-ASCII nor UTF-8.";
    case IGTL_BAD_TEXT:
        return "BAD_TEXT: The text is not printable ASCII.";
    case IGTL_INCOMPLETE:
        return "INCOMPLETE: The rest of the message did not come in time.";
    default:
        return "UNKNOWN";
    }
}

uint32_t igtl_result_code(igtl_result_t result)
{
    switch (result) {
    case IGTL_BAD_VERSION:
        return IGTL_STATUS_UNKNOWN_VERSION;
    case IGTL_TOO_LONG:
        return IGTL_STATUS_OVERFLOW;
    case IGTL_BAD_CRC:
        return IGTL_STATUS_CHECKSUM_ERROR;
    case IGTL_INCOMPLETE:
        return IGTL_STATUS_TIME_OUT;
    case IGTL_OK:
    case IGTL_BAD_NAME:
    case IGTL_BAD_EXTENSION:
    case IGTL_BAD_METADATA:
    case IGTL_BAD_LENGTH:
    case IGTL_BAD_ENCODING:
    case IGTL_BAD_TEXT:
    default:
        return IGTL_STATUS_CONFIG_ERROR;
    }
}

static uint64_t read_big_endian(const uint8_t *bytes, uint32_t count)
{
    uint64_t value = 0U;

    for (uint32_t i = 0U; i < count; i++) {
        value = (value << 8U) | bytes[i];
    }
    return value;
}

static uint32_t read_u16(const uint8_t *bytes)
{
    return (uint32_t)read_big_endian(bytes, 2U);
}

static uint32_t read_u32(const uint8_t *bytes)
{
    return (uint32_t)read_big_endian(bytes, 4U);
}

static bool is_printable(uint8_t byte)
{
    return (byte >= 0x20U) && (byte <= 0x7EU);
}

/* Copies up to the first NUL; false when something before it is not printable. */
static bool read_name(const uint8_t *bytes, uint32_t size, char *name)
{
    uint32_t length = 0U;

    while ((length < size) && (bytes[length] != 0U)) {
        if (!is_printable(bytes[length])) {
            return false;
        }
        name[length] = (char)bytes[length];
        length++;
    }
    name[length] = '\0';
    return true;
}

static igtl_kind_t kind_of(const char *type)
{
    static const struct {
        char type[IGTL_TYPE_SIZE];
        igtl_kind_t kind;
    } known[] = {{"TRANSFORM", IGTL_KIND_TRANSFORM},     {"STRING", IGTL_KIND_STRING},
                 {"STATUS", IGTL_KIND_STATUS},           {"POINT", IGTL_KIND_POINT},
                 {"GET_TRANS", IGTL_KIND_GET_TRANSFORM}, {"GET_TRANSFOR", IGTL_KIND_GET_TRANSFORM},
                 {"GET_STATUS", IGTL_KIND_GET_STATUS}};

    for (size_t i = 0U; i < (sizeof known / sizeof known[0]); i++) {
        if (strcmp(type, known[i].type) == 0) {
            return known[i].kind;
        }
    }
    return IGTL_KIND_OTHER;
}

igtl_result_t igtl_decode_header(const uint8_t bytes[IGTL_HEADER_BYTES], igtl_header_t *header)
{
    uint64_t longest;

    (void)memset(header, 0, sizeof *header);
    header->version = read_u16(&bytes[0]);
    header->body_bytes = read_big_endian(&bytes[42], 8U);
    header->crc = read_big_endian(&bytes[50], 8U);
    if ((header->version != 1U) && (header->version != 2U)) {
        return IGTL_BAD_VERSION;
    }
    if (!read_name(&bytes[2], IGTL_TYPE_SIZE - 1U, header->type) || (header->type[0] == '\0') ||
        !read_name(&bytes[14], IGTL_NAME_SIZE - 1U, header->name)) {
        return IGTL_BAD_NAME;
    }
    header->kind = kind_of(header->type);
    longest = (header->kind == IGTL_KIND_OTHER) ? LIMIT_IGTL_SKIP_MAX : LIMIT_IGTL_BODY_MAX;
    return (header->body_bytes > longest) ? IGTL_TOO_LONG : IGTL_OK;
}

/* The metadata of `bytes` bytes: a count, the lengths, then keys and values that fill the rest
 * exactly. */
static igtl_result_t check_metadata(const uint8_t *metadata, uint64_t header_bytes,
                                    uint64_t data_bytes)
{
    uint64_t entries;
    uint64_t sum = 0U;

    if (header_bytes == 0U) {
        return (data_bytes == 0U) ? IGTL_OK : IGTL_BAD_METADATA;
    }
    if (header_bytes < 2U) {
        return IGTL_BAD_METADATA;
    }
    entries = read_u16(metadata);
    if (header_bytes != (2U + (entries * METADATA_ENTRY_BYTES))) {
        return IGTL_BAD_METADATA;
    }
    for (uint64_t i = 0U; i < entries; i++) {
        const uint8_t *entry = &metadata[2U + (i * METADATA_ENTRY_BYTES)];

        sum += (uint64_t)read_u16(entry) + read_u32(&entry[4]);
    }
    return (sum == data_bytes) ? IGTL_OK : IGTL_BAD_METADATA;
}

/* Finds the content inside a body of version 2. */
static igtl_result_t open_extension(const uint8_t *body, uint64_t body_bytes,
                                    igtl_message_t *message)
{
    uint64_t extension;
    uint64_t metadata_header;
    uint64_t metadata;
    uint64_t around;

    if (body_bytes < EXTENSION_BYTES) {
        return IGTL_BAD_EXTENSION;
    }
    extension = read_u16(&body[0]);
    metadata_header = read_u16(&body[2]);
    metadata = read_u32(&body[4]);
    around = extension + metadata_header + metadata;
    if ((extension < EXTENSION_BYTES) || (around > body_bytes)) {
        return IGTL_BAD_EXTENSION;
    }
    message->content = &body[extension];
    message->content_bytes = (uint32_t)(body_bytes - around);
    return check_metadata(&body[extension + message->content_bytes], metadata_header, metadata);
}

static igtl_result_t read_transform(igtl_message_t *message)
{
    if (message->content_bytes != IGTL_TRANSFORM_BYTES) {
        return IGTL_BAD_LENGTH;
    }
    for (uint32_t i = 0U; i < IGTL_TRANSFORM_NUMBERS; i++) {
        message->numbers[i] = read_u32(&message->content[4U * i]);
    }
    return IGTL_OK;
}

static igtl_result_t read_string(igtl_message_t *message)
{
    uint32_t encoding;

    if (message->content_bytes < 4U) {
        return IGTL_BAD_LENGTH;
    }
    encoding = read_u16(&message->content[0]);
    message->text_bytes = read_u16(&message->content[2]);
    if (message->content_bytes != (4U + message->text_bytes)) {
        return IGTL_BAD_LENGTH;
    }
    if ((encoding != ENCODING_ASCII) && (encoding != ENCODING_UTF8)) {
        return IGTL_BAD_ENCODING;
    }
    message->text = (const char *)&message->content[4];
    for (uint32_t i = 0U; i < message->text_bytes; i++) {
        if (!is_printable(message->content[4U + i])) {
            return IGTL_BAD_TEXT;
        }
    }
    return IGTL_OK;
}

static igtl_result_t read_status(igtl_message_t *message)
{
    if (message->content_bytes < IGTL_STATUS_BYTES) {
        return IGTL_BAD_LENGTH;
    }
    message->code = read_u16(message->content);
    return IGTL_OK;
}

igtl_result_t igtl_decode_body(const igtl_header_t *header, const uint8_t *body,
                               igtl_message_t *message)
{
    igtl_result_t result = IGTL_OK;

    (void)memset(message, 0, sizeof *message);
    message->kind = header->kind;
    (void)memcpy(message->name, header->name, sizeof message->name);
    message->content = body;
    message->content_bytes = (uint32_t)header->body_bytes;
    if (igtl_crc64(0U, body, (size_t)header->body_bytes) != header->crc) {
        return IGTL_BAD_CRC;
    }
    if ((header->version == 2U) && (header->body_bytes > 0U)) {
        result = open_extension(body, header->body_bytes, message);
    }
    if (result != IGTL_OK) {
        return result;
    }
    switch (header->kind) {
    case IGTL_KIND_TRANSFORM:
        return read_transform(message);
    case IGTL_KIND_STRING:
        return read_string(message);
    case IGTL_KIND_STATUS:
        return read_status(message);
    case IGTL_KIND_POINT:
        return ((message->content_bytes % IGTL_POINT_BYTES) == 0U) ? IGTL_OK : IGTL_BAD_LENGTH;
    case IGTL_KIND_GET_TRANSFORM:
    case IGTL_KIND_GET_STATUS:
        return (message->content_bytes == 0U) ? IGTL_OK : IGTL_BAD_LENGTH;
    case IGTL_KIND_OTHER:
    default:
        return IGTL_OK;
    }
}

static void write_big_endian(uint8_t *bytes, uint64_t value, uint32_t count)
{
    for (uint32_t i = 0U; i < count; i++) {
        bytes[i] = (uint8_t)(value >> (8U * (count - 1U - i)));
    }
}

static uint32_t bounded_length(const char *text, uint32_t most)
{
    uint32_t length = 0U;

    while ((length < most) && (text[length] != '\0')) {
        length++;
    }
    return length;
}

static void write_name(uint8_t *bytes, const char *name, uint32_t most)
{
    (void)memcpy(bytes, name, bounded_length(name, most));
}

/* The body stands behind the header's place already. */
static void finish(igtl_packet_t *packet, const char *type, const char *name, uint64_t timestamp)
{
    const uint32_t body_bytes = packet->length - IGTL_HEADER_BYTES;

    write_big_endian(&packet->bytes[0], 1U, 2U);
    write_name(&packet->bytes[2], type, IGTL_TYPE_SIZE - 1U);
    write_name(&packet->bytes[14], name, IGTL_NAME_SIZE - 1U);
    write_big_endian(&packet->bytes[34], timestamp, 8U);
    write_big_endian(&packet->bytes[42], body_bytes, 8U);
    write_big_endian(&packet->bytes[50],
                     igtl_crc64(0U, &packet->bytes[IGTL_HEADER_BYTES], body_bytes), 8U);
}

static uint8_t *begin(igtl_packet_t *packet, uint32_t body_bytes)
{
    (void)memset(packet, 0, sizeof *packet);
    packet->length = IGTL_HEADER_BYTES + body_bytes;
    return &packet->bytes[IGTL_HEADER_BYTES];
}

void igtl_encode_transform(igtl_packet_t *packet, const char *name,
                           const uint32_t numbers[IGTL_TRANSFORM_NUMBERS], uint64_t timestamp)
{
    uint8_t *body = begin(packet, IGTL_TRANSFORM_BYTES);

    for (uint32_t i = 0U; i < IGTL_TRANSFORM_NUMBERS; i++) {
        write_big_endian(&body[4U * i], numbers[i], 4U);
    }
    finish(packet, "TRANSFORM", name, timestamp);
}

void igtl_encode_string(igtl_packet_t *packet, const char *name, const char *text,
                        uint64_t timestamp)
{
    const uint32_t length = bounded_length(text, IGTL_TEXT_MAX);
    uint8_t *body = begin(packet, 4U + length);

    write_big_endian(&body[0], ENCODING_ASCII, 2U);
    write_big_endian(&body[2], length, 2U);
    (void)memcpy(&body[4], text, length);
    finish(packet, "STRING", name, timestamp);
}

void igtl_encode_point(igtl_packet_t *packet, const char *name, const uint32_t numbers[3],
                       uint64_t timestamp)
{
    uint8_t *body = begin(packet, IGTL_POINT_BYTES);

    write_name(body, name, POINT_NAME_BYTES - 1U);
    (void)memset(&body[POINT_COLOUR], 0xFF, 4U);
    for (uint32_t i = 0U; i < 3U; i++) {
        write_big_endian(&body[POINT_POSITION + (4U * i)], numbers[i], 4U);
    }
    finish(packet, "POINT", name, timestamp);
}

void igtl_encode_status(igtl_packet_t *packet, const char *name, const igtl_status_t *status,
                        uint64_t timestamp)
{
    const uint32_t length = bounded_length(status->text, IGTL_TEXT_MAX);
    uint8_t *body = begin(packet, IGTL_STATUS_BYTES + length + 1U);

    write_big_endian(&body[0], status->code, 2U);
    write_name(&body[10], status->error_name, STATUS_NAME_BYTES - 1U);
    (void)memcpy(&body[IGTL_STATUS_BYTES], status->text, length);
    finish(packet, "STATUS", name, timestamp);
}
