/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/wire/igtl_codec.h"

#include "limits/requirement_limits.h"
#include "igtl/wire/big_endian.h"
#include "igtl/wire/igtl_crc64.h"
#include "igtl/wire/printable.h"

#include <stdbool.h>
#include <string.h>

#define METADATA_ENTRY_BYTES 8U
#define TYPE_BYTES (IGTL_TYPE_SIZE - 1U)
#define NAME_BYTES (IGTL_NAME_SIZE - 1U)
#define ARRAY_HEADER_BYTES 6U /* Header of two dimensions. */
#define ARRAY_FLOAT32 10U
#define ARRAY_FLOAT64 11U
#define TRAJECTORY_TYPE 96U    /* Behind name and group. */
#define TRAJECTORY_POINTS 102U /* Behind type and colour. */

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
    case IGTL_MARKED_INVALID:
        return "MARKED_INVALID: Its sender says that it is not valid.";
    case IGTL_NOT_ONE:
        return "NOT_ONE: It must have one trajectory, no more and no less.";
    case IGTL_NOT_TABLE:
        return "NOT_TABLE: The array is none of rows and columns of 32 or 64 bit floating point.";
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
    case IGTL_MARKED_INVALID:
    case IGTL_NOT_ONE:
    case IGTL_NOT_TABLE:
    default:
        return IGTL_STATUS_CONFIG_ERROR;
    }
}

/* Up to the first NUL, with `?` for what is not printable; true when there is none of that. */
static bool mend_text(char *text, const uint8_t *bytes, uint32_t size)
{
    bool is_fine = true;
    uint32_t length = 0U;

    for (; (length < size) && (bytes[length] != 0U); length++) {
        const bool is_good = is_printable(&bytes[length], 1U);

        text[length] = is_good ? (char)bytes[length] : '?';
        is_fine = is_fine && is_good;
    }
    (void)memset(&text[length], 0, size - length);
    return is_fine;
}

static bool read_type(const uint8_t *bytes, char type[IGTL_TYPE_SIZE])
{
    uint64_t nuls = 0U;
    uint64_t strays = stray_bytes(get_u64(bytes), &nuls);

    strays |= stray_bytes((uint64_t)get_u32(&bytes[8]) << 32U, &nuls);
    (void)memcpy(type, bytes, TYPE_BYTES);
    type[TYPE_BYTES] = '\0';
    return ((strays == 0U) || mend_text(type, bytes, TYPE_BYTES)) && (type[0] != '\0');
}

static bool read_name(const uint8_t *bytes, char name[IGTL_NAME_SIZE])
{
    uint64_t nuls = 0U;
    uint64_t strays = stray_bytes(get_u64(bytes), &nuls);

    strays |= stray_bytes(get_u64(&bytes[8]), &nuls);
    strays |= stray_bytes((uint64_t)get_u32(&bytes[16]) << 32U, &nuls);
    (void)memcpy(name, bytes, NAME_BYTES);
    name[NAME_BYTES] = '\0';
    return (strays == 0U) || mend_text(name, bytes, NAME_BYTES);
}

static igtl_kind_t kind_of(const char *type)
{
    static const struct {
        char type[TYPE_BYTES];
        igtl_kind_t kind;
    } known[] = {{"TRANSFORM", IGTL_KIND_TRANSFORM},
                 {"STRING", IGTL_KIND_STRING},
                 {"STATUS", IGTL_KIND_STATUS},
                 {"POINT", IGTL_KIND_POINT},
                 {"GET_TRANS", IGTL_KIND_GET_TRANSFORM},
                 {"GET_TRANSFOR", IGTL_KIND_GET_TRANSFORM},
                 {"GET_STATUS", IGTL_KIND_GET_STATUS},
                 {"GET_POINT", IGTL_KIND_GET_POINT},
                 {"GET_CAPABIL", IGTL_KIND_GET_CAPABILITY},
                 {"GET_SENSOR", IGTL_KIND_GET_SENSOR},
                 {"STT_TDATA", IGTL_KIND_STT_TDATA},
                 {"STP_TDATA", IGTL_KIND_STP_TDATA},
                 {"COMMAND", IGTL_KIND_COMMAND},
                 {"TRAJ", IGTL_KIND_TRAJECTORY},
                 {"NDARRAY", IGTL_KIND_ARRAY}};

    for (size_t i = 0U; i < (sizeof known / sizeof known[0]); i++) {
        if (memcmp(type, known[i].type, TYPE_BYTES) == 0) {
            return known[i].kind;
        }
    }
    if (memcmp(type, "GET_", 4U) == 0) {
        return IGTL_KIND_GET_OTHER;
    }
    if (memcmp(type, "STT_", 4U) == 0) {
        return IGTL_KIND_STT_OTHER;
    }
    return (memcmp(type, "STP_", 4U) == 0) ? IGTL_KIND_STP_OTHER : IGTL_KIND_OTHER;
}

static bool is_known_version(uint32_t version)
{
    return (version == 1U) || (version == 2U);
}

static uint64_t longest_of(igtl_kind_t kind)
{
    if (kind == IGTL_KIND_OTHER) {
        return LIMIT_IGTL_SKIP_MAX;
    }
    return (kind == IGTL_KIND_ARRAY) ? LIMIT_IGTL_ARRAY_MAX : LIMIT_IGTL_BODY_MAX;
}

igtl_result_t igtl_decode_header(const uint8_t bytes[IGTL_HEADER_BYTES], igtl_header_t *header)
{
    const bool is_type_fine = read_type(&bytes[2], header->type);
    const bool is_name_fine = read_name(&bytes[14], header->name);

    header->version = get_u16(bytes);
    header->body_bytes = get_u64(&bytes[42]);
    header->crc = get_u64(&bytes[50]);
    header->kind = kind_of(header->type);
    if (!is_known_version(header->version)) {
        return IGTL_BAD_VERSION;
    }
    if (header->body_bytes > LIMIT_IGTL_SKIP_MAX) {
        return IGTL_TOO_LONG;
    }
    if (!is_type_fine || !is_name_fine) {
        return IGTL_BAD_NAME;
    }
    return (header->body_bytes > longest_of(header->kind)) ? IGTL_TOO_LONG : IGTL_OK;
}

bool igtl_header_is_lost(const igtl_header_t *header)
{
    return !is_known_version(header->version) || (header->body_bytes > LIMIT_IGTL_SKIP_MAX);
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
    entries = get_u16(metadata);
    if (header_bytes != (2U + (entries * METADATA_ENTRY_BYTES))) {
        return IGTL_BAD_METADATA;
    }
    for (uint64_t i = 0U; i < entries; i++) {
        const uint8_t *entry = &metadata[2U + (i * METADATA_ENTRY_BYTES)];

        sum += (uint64_t)get_u16(entry) + get_u32(&entry[4]);
    }
    return (sum == data_bytes) ? IGTL_OK : IGTL_BAD_METADATA;
}

static bool is_word(const uint8_t *bytes, uint32_t length, const char *word)
{
    return (length == strlen(word)) && (memcmp(bytes, word, length) == 0);
}

/* Whether the sender calls its transform valid, in metadata that fit their lengths. */
static igtl_result_t read_mark(const uint8_t *metadata)
{
    const uint32_t entries = get_u16(metadata);
    const uint8_t *key = &metadata[2U + (entries * METADATA_ENTRY_BYTES)];

    for (uint32_t i = 0U; i < entries; i++) {
        const uint8_t *entry = &metadata[2U + (i * METADATA_ENTRY_BYTES)];
        const uint32_t key_bytes = get_u16(entry);
        const uint32_t value_bytes = get_u32(&entry[4]);
        const uint8_t *value = &key[key_bytes];

        if (is_word(key, key_bytes, "TransformStatus") && !is_word(value, value_bytes, "OK")) {
            return IGTL_MARKED_INVALID;
        }
        key = &value[value_bytes];
    }
    return IGTL_OK;
}

/* Finds the content inside a body of version 2. */
static igtl_result_t open_extension(const uint8_t *body, uint64_t body_bytes,
                                    igtl_message_t *message)
{
    uint64_t extension;
    uint64_t metadata_header;
    uint64_t metadata;
    uint64_t around;
    igtl_result_t result;

    if (body_bytes < IGTL_EXTENSION_BYTES) {
        return IGTL_BAD_EXTENSION;
    }
    extension = get_u16(&body[0]);
    metadata_header = get_u16(&body[2]);
    metadata = get_u32(&body[4]);
    around = extension + metadata_header + metadata;
    if ((extension < IGTL_EXTENSION_BYTES) || (around > body_bytes)) {
        return IGTL_BAD_EXTENSION;
    }
    message->content = &body[extension];
    message->content_bytes = (uint32_t)(body_bytes - around);
    result = check_metadata(&message->content[message->content_bytes], metadata_header, metadata);
    return ((result == IGTL_OK) && (message->kind == IGTL_KIND_TRANSFORM) && (metadata_header > 0U))
               ? read_mark(&message->content[message->content_bytes])
               : result;
}

static igtl_result_t read_transform(igtl_message_t *message)
{
    if (message->content_bytes != IGTL_TRANSFORM_BYTES) {
        return IGTL_BAD_LENGTH;
    }
    for (uint32_t i = 0U; i < IGTL_TRANSFORM_NUMBERS; i++) {
        message->numbers[i] = get_u32(&message->content[4U * i]);
    }
    return IGTL_OK;
}

static bool is_known_encoding(uint32_t encoding)
{
    return (encoding == IGTL_ENCODING_ASCII) || (encoding == IGTL_ENCODING_UTF8);
}

static igtl_result_t read_string(igtl_message_t *message)
{
    if (message->content_bytes < 4U) {
        return IGTL_BAD_LENGTH;
    }
    message->text_bytes = get_u16(&message->content[2]);
    if (message->content_bytes != (4U + message->text_bytes)) {
        return IGTL_BAD_LENGTH;
    }
    if (!is_known_encoding(get_u16(message->content))) {
        return IGTL_BAD_ENCODING;
    }
    message->text = (const char *)&message->content[4];
    return is_printable(&message->content[4], message->text_bytes) ? IGTL_OK : IGTL_BAD_TEXT;
}

static igtl_result_t read_status(igtl_message_t *message)
{
    if (message->content_bytes < IGTL_STATUS_BYTES) {
        return IGTL_BAD_LENGTH;
    }
    message->code = get_u16(message->content);
    return IGTL_OK;
}

/* The field of `size` bytes, up to its first NUL. */
static igtl_result_t read_subject(igtl_message_t *message, const uint8_t *field, uint32_t size)
{
    message->subject = (const char *)field;
    message->subject_bytes = (uint32_t)strnlen(message->subject, size);
    return is_printable(field, message->subject_bytes) ? IGTL_OK : IGTL_BAD_TEXT;
}

static igtl_result_t read_stream(igtl_message_t *message)
{
    uint32_t resolution;

    if (message->content_bytes != IGTL_STREAM_BYTES) {
        return IGTL_BAD_LENGTH;
    }
    resolution = get_u32(message->content);
    (void)memcpy(&message->resolution_ms, &resolution, sizeof resolution);
    return read_subject(message, &message->content[4], IGTL_STREAM_BYTES - 4U);
}

static igtl_result_t read_command(igtl_message_t *message)
{
    const uint8_t *behind_name;

    if (message->content_bytes < IGTL_COMMAND_BYTES) {
        return IGTL_BAD_LENGTH;
    }
    behind_name = &message->content[4U + IGTL_COMMAND_NAME_BYTES];
    message->code = get_u32(message->content);
    message->text_bytes = message->content_bytes - IGTL_COMMAND_BYTES;
    if (get_u32(&behind_name[2]) != message->text_bytes) {
        return IGTL_BAD_LENGTH;
    }
    if (!is_known_encoding(get_u16(behind_name))) {
        return IGTL_BAD_ENCODING;
    }
    message->text = (const char *)&message->content[IGTL_COMMAND_BYTES];
    return read_subject(message, &message->content[4], IGTL_COMMAND_NAME_BYTES);
}

/* Names, colour, radius and owner say nothing of where it is. */
static igtl_result_t read_trajectory(igtl_message_t *message)
{
    if ((message->content_bytes % IGTL_TRAJECTORY_BYTES) != 0U) {
        return IGTL_BAD_LENGTH;
    }
    if (message->content_bytes != IGTL_TRAJECTORY_BYTES) {
        return IGTL_NOT_ONE;
    }
    message->code = message->content[TRAJECTORY_TYPE];
    for (uint32_t i = 0U; i < IGTL_TRAJECTORY_NUMBERS; i++) {
        message->numbers[i] = get_u32(&message->content[TRAJECTORY_POINTS + (4U * i)]);
    }
    return IGTL_OK;
}

static igtl_result_t read_array(igtl_message_t *message)
{
    const uint8_t *content = message->content;
    uint64_t data_bytes;

    if (message->content_bytes < ARRAY_HEADER_BYTES) {
        return IGTL_BAD_LENGTH;
    }
    if (((content[0] != ARRAY_FLOAT32) && (content[0] != ARRAY_FLOAT64)) || (content[1] != 2U)) {
        return IGTL_NOT_TABLE;
    }
    message->number_bytes = (content[0] == ARRAY_FLOAT32) ? 4U : 8U;
    message->rows = get_u16(&content[2]);
    message->columns = get_u16(&content[4]);
    data_bytes = (uint64_t)message->rows * message->columns * message->number_bytes;
    return (message->content_bytes == (ARRAY_HEADER_BYTES + data_bytes)) ? IGTL_OK
                                                                         : IGTL_BAD_LENGTH;
}

uint64_t igtl_array_bits(const igtl_message_t *message, uint32_t index)
{
    const uint8_t *numbers = &message->content[ARRAY_HEADER_BYTES];

    return (message->number_bytes == 4U) ? get_u32(&numbers[4U * (size_t)index])
                                         : get_u64(&numbers[8U * (size_t)index]);
}

/* A request that says nothing but its type. */
static igtl_result_t read_nothing(igtl_message_t *message)
{
    return (message->content_bytes == 0U) ? IGTL_OK : IGTL_BAD_LENGTH;
}

static igtl_result_t read_points(igtl_message_t *message)
{
    return ((message->content_bytes % IGTL_POINT_BYTES) == 0U) ? IGTL_OK : IGTL_BAD_LENGTH;
}

/* By kind; of one without a reader any content is taken. */
static igtl_result_t (*const readers[])(igtl_message_t *message) = {
    [IGTL_KIND_TRANSFORM] = read_transform,   [IGTL_KIND_STRING] = read_string,
    [IGTL_KIND_STATUS] = read_status,         [IGTL_KIND_POINT] = read_points,
    [IGTL_KIND_GET_TRANSFORM] = read_nothing, [IGTL_KIND_GET_STATUS] = read_nothing,
    [IGTL_KIND_GET_POINT] = read_nothing,     [IGTL_KIND_GET_CAPABILITY] = read_nothing,
    [IGTL_KIND_STT_TDATA] = read_stream,      [IGTL_KIND_STP_TDATA] = read_nothing,
    [IGTL_KIND_COMMAND] = read_command,       [IGTL_KIND_TRAJECTORY] = read_trajectory,
    [IGTL_KIND_ARRAY] = read_array,           [IGTL_KIND_GET_SENSOR] = read_nothing,
};

static igtl_result_t read_content(igtl_message_t *message)
{
    const bool is_read = ((size_t)message->kind < (sizeof readers / sizeof readers[0])) &&
                         (readers[message->kind] != NULL);
    return is_read ? readers[message->kind](message) : IGTL_OK;
}

static void begin(igtl_message_t *message, const igtl_header_t *header, const uint8_t *body)
{
    message->version = header->version;
    message->kind = header->kind;
    (void)memcpy(message->type, header->type, sizeof message->type);
    (void)memcpy(message->name, header->name, sizeof message->name);
    message->content = body;
    message->content_bytes = (uint32_t)header->body_bytes;
    message->text = NULL;
    message->text_bytes = 0U;
    message->code = 0U;
    message->resolution_ms = 0;
    message->subject = NULL;
    message->subject_bytes = 0U;
    message->rows = 0U;
    message->columns = 0U;
    message->number_bytes = 0U;
}

igtl_result_t igtl_decode_body(const igtl_header_t *header, const uint8_t *body,
                               igtl_message_t *message)
{
    igtl_result_t result = IGTL_OK;

    begin(message, header, body);
    if (igtl_crc64(0U, body, (size_t)header->body_bytes) != header->crc) {
        return IGTL_BAD_CRC;
    }
    if ((header->version == 2U) && (header->body_bytes > 0U)) {
        result = open_extension(body, header->body_bytes, message);
    }
    return (result == IGTL_OK) ? read_content(message) : result;
}
