/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: a message is understood exactly when every byte of it fits, whichever header
 * version it has.
 */
#include "igtl/wire/igtl_codec.h"
#include "igtl/wire/igtl_crc64.h"
#include "igtl/wire/igtl_packet.h"
#include "limits/requirement_limits.h"
#include "unity.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#define ONE 0x3F800000U

/* Messages of a client that follows the call request of 3D Slicer, header version 2. */
static const char slicer_status[] = "00025354415455530000000000000000000000000000000000000000000000"
                                    "0000000000000000000000000000000000"
                                    "003f6cf69307e59e5ee9000c000a0000000a00000000000000000000000000"
                                    "0000000000000000000000000000000000"
                                    "00000000000001000500030000000564756d6d7964756d6d79";
static const char slicer_string[] = "0002535452494e47000000000000434d445f31323030303031323334353600"
                                    "0000000000000000000000000000000000"
                                    "004210848a6e764d059e000c00120000001800000000000300085354415254"
                                    "5f55500002000c00030000000400060003"
                                    "000000024d524d4c4e6f64654e616d65546578745374617475734f4b";
static const char slicer_transform[] =
    "00025452414e53464f524d000000434c425f3132303030323132333435360000000000000000000000000000000000"
    "00"
    "00a4572786ba7972dfd9000c002200000046000000003f8000000000000000000000000000003f8000000000000000"
    "00"
    "0000000000003f8000003f80000040000000404000000004000c00030000000f000e000300000000000c0003000000"
    "00"
    "000f0003000000024d524d4c4e6f64654e616d654c696e6561725472616e73666f726d53545245414d5f49445f4652"
    "4f"
    "4d53545245414d5f49445f544f5472616e73666f726d5374617475734f4b";

static uint8_t bytes[IGTL_HEADER_BYTES + LIMIT_IGTL_BODY_MAX];
static igtl_header_t header;
static igtl_message_t message;
static igtl_packet_t packet;

void setUp(void)
{
    (void)memset(bytes, 0, sizeof bytes);
    (void)memset(&message, 0, sizeof message);
}

void tearDown(void)
{
}

static uint32_t unhex(const char *text)
{
    uint32_t length = 0U;

    while (text[2U * length] != '\0') {
        unsigned value = 0U;

        TEST_ASSERT_EQUAL_INT(1, sscanf(&text[2U * length], "%2x", &value));
        bytes[length] = (uint8_t)value;
        length++;
    }
    return length;
}

static void put(uint32_t at, uint64_t value, uint32_t count)
{
    for (uint32_t i = 0U; i < count; i++) {
        bytes[at + i] = (uint8_t)(value >> (8U * (count - 1U - i)));
    }
}

/* A header in front of `body_bytes` that are in place, with their checksum. */
static void frame(uint32_t version, const char *type, uint32_t body_bytes)
{
    put(0U, version, 2U);
    (void)memset(&bytes[2], 0, 40U);
    (void)memcpy(&bytes[2], type, strlen(type));
    put(42U, body_bytes, 8U);
    put(50U, igtl_crc64(0U, &bytes[IGTL_HEADER_BYTES], body_bytes), 8U);
}

static igtl_result_t decode(void)
{
    const igtl_result_t result = igtl_decode_header(bytes, &header);

    return (result == IGTL_OK) ? igtl_decode_body(&header, &bytes[IGTL_HEADER_BYTES], &message)
                               : result;
}

void test_SWR_IGTL_001_first_message_of_slicer_is_understood(void)
{
    TEST_ASSERT_EQUAL_UINT32(121U, unhex(slicer_status));
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode());
    TEST_ASSERT_EQUAL_INT(IGTL_KIND_STATUS, message.kind);
    TEST_ASSERT_EQUAL_STRING("", message.name);
    TEST_ASSERT_EQUAL_UINT32(0U, message.code);
}

void test_SWR_IGTL_001_string_of_slicer_is_understood(void)
{
    TEST_ASSERT_EQUAL_UINT32(124U, unhex(slicer_string));
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode());
    TEST_ASSERT_EQUAL_STRING("CMD_120000123456", message.name);
    TEST_ASSERT_EQUAL_UINT32(8U, message.text_bytes);
    TEST_ASSERT_EQUAL_MEMORY("START_UP", message.text, 8U);
}

void test_SWR_IGTL_001_transform_of_slicer_is_understood(void)
{
    static const uint32_t expected[12] = {ONE, 0U, 0U,  0U,  ONE,         0U,
                                          0U,  0U, ONE, ONE, 0x40000000U, 0x40400000U};

    TEST_ASSERT_EQUAL_UINT32(222U, unhex(slicer_transform));
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode());
    TEST_ASSERT_EQUAL_STRING("CLB_120002123456", message.name);
    TEST_ASSERT_EQUAL_HEX32_ARRAY(expected, message.numbers, 12U);
}

void test_SWR_IGTL_001_version_1_is_understood(void)
{
    igtl_encode_string(&packet, "CMD_1", "STOP", 0U);
    (void)memcpy(bytes, packet.bytes, packet.length);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode());
    TEST_ASSERT_EQUAL_UINT32(1U, header.version);
    TEST_ASSERT_EQUAL_MEMORY("STOP", message.text, 4U);
}

void test_SWR_IGTL_001_other_versions_are_refused(void)
{
    frame(0U, "STATUS", 31U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_VERSION, decode());
    frame(3U, "STATUS", 31U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_VERSION, decode());
    frame(0x4745U, "STATUS", 31U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_VERSION, decode());
    TEST_ASSERT_TRUE(igtl_header_is_lost(&header));
}

void test_SWR_IGTL_001_longer_extended_header_is_skipped(void)
{
    put(58U, 14U, 2U);
    frame(2U, "GET_STATUS", 14U);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode());
    TEST_ASSERT_EQUAL_UINT32(0U, message.content_bytes);
}

void test_SWR_IGTL_001_version_2_may_have_no_body(void)
{
    frame(2U, "GET_TRANSFOR", 0U);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode());
    TEST_ASSERT_EQUAL_INT(IGTL_KIND_GET_TRANSFORM, message.kind);
}

void test_SWR_IGTL_002_every_flipped_bit_of_a_body_is_noticed(void)
{
    const uint32_t length = unhex(slicer_string);

    for (uint32_t bit = 8U * IGTL_HEADER_BYTES; bit < (8U * length); bit++) {
        bytes[bit / 8U] ^= (uint8_t)(1U << (bit % 8U));
        TEST_ASSERT_EQUAL_INT(IGTL_BAD_CRC, decode());
        bytes[bit / 8U] ^= (uint8_t)(1U << (bit % 8U));
    }
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode());
}

void test_SWR_IGTL_002_zero_checksum_is_wrong_too(void)
{
    (void)unhex(slicer_string);
    put(50U, 0U, 8U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_CRC, decode());
}

void test_SWR_IGTL_003_known_type_has_a_longest_body(void)
{
    frame(1U, "STRING", LIMIT_IGTL_BODY_MAX);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, igtl_decode_header(bytes, &header));
    put(42U, LIMIT_IGTL_BODY_MAX + 1U, 8U);
    TEST_ASSERT_EQUAL_INT(IGTL_TOO_LONG, igtl_decode_header(bytes, &header));
    TEST_ASSERT_FALSE(igtl_header_is_lost(&header));
    put(42U, LIMIT_IGTL_SKIP_MAX + 1U, 8U);
    TEST_ASSERT_EQUAL_INT(IGTL_TOO_LONG, igtl_decode_header(bytes, &header));
    TEST_ASSERT_TRUE(igtl_header_is_lost(&header));
}

void test_SWR_IGTL_003_huge_lengths_are_refused_without_arithmetic_on_them(void)
{
    static const uint64_t lengths[] = {UINT64_C(1) << 31U, UINT64_C(1) << 62U, UINT64_MAX,
                                       UINT64_MAX - 57U};

    for (uint32_t i = 0U; i < 4U; i++) {
        frame(1U, "TRANSFORM", 0U);
        put(42U, lengths[i], 8U);
        TEST_ASSERT_EQUAL_INT(IGTL_TOO_LONG, decode());
        frame(1U, "IMAGE", 0U);
        put(42U, lengths[i], 8U);
        TEST_ASSERT_EQUAL_INT(IGTL_TOO_LONG, decode());
    }
}

void test_SWR_IGTL_003_string_length_beyond_its_body_is_refused(void)
{
    put(58U, 3U, 2U);
    put(60U, 65535U, 2U);
    frame(1U, "STRING", 4U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_LENGTH, decode());
    frame(1U, "STRING", 3U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_LENGTH, decode());
}

void test_SWR_IGTL_003_short_bodies_are_refused(void)
{
    frame(1U, "STATUS", 5U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_LENGTH, decode());
    frame(1U, "STATUS", 29U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_LENGTH, decode());
    frame(1U, "TRANSFORM", 10U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_LENGTH, decode());
    frame(1U, "TRANSFORM", 49U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_LENGTH, decode());
    frame(1U, "POINT", 100U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_LENGTH, decode());
    frame(1U, "GET_STATUS", 1U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_LENGTH, decode());
}

void test_SWR_IGTL_003_extended_header_beyond_its_body_is_refused(void)
{
    put(58U, 60000U, 2U);
    frame(2U, "STATUS", 43U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_EXTENSION, decode());
    put(58U, 11U, 2U);
    frame(2U, "STATUS", 43U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_EXTENSION, decode());
    frame(2U, "STATUS", 11U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_EXTENSION, decode());
}

void test_SWR_IGTL_003_metadata_beyond_its_body_is_refused(void)
{
    put(58U, 12U, 2U);
    put(60U, 2U, 2U);
    put(62U, UINT32_MAX, 4U);
    frame(2U, "STATUS", 45U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_EXTENSION, decode());
}

void test_SWR_IGTL_003_metadata_that_does_not_add_up_is_refused(void)
{
    (void)unhex(slicer_string);
    put(60U, 0x11U, 2U); /* One byte fewer than two entries need. */
    put(50U, igtl_crc64(0U, &bytes[58], 66U), 8U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_METADATA, decode());
    (void)unhex(slicer_string);
    put(86U - 2U, 0xFFFFU, 2U); /* Count of entries. */
    put(50U, igtl_crc64(0U, &bytes[58], 66U), 8U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_METADATA, decode());
}

void test_SWR_IGTL_003_metadata_without_header_is_refused(void)
{
    put(58U, 12U, 2U);
    put(62U, 4U, 4U);
    frame(2U, "GET_STATUS", 16U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_METADATA, decode());
    put(60U, 1U, 2U);
    put(62U, 0U, 4U);
    frame(2U, "GET_STATUS", 13U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_METADATA, decode());
}

void test_SWR_IGTL_003_content_of_three_bytes_is_no_transform(void)
{
    put(58U, 12U, 2U);
    put(60U, 2U, 2U);
    frame(2U, "TRANSFORM", 17U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_LENGTH, decode());
}

void test_SWR_IGTL_003_names_are_printable(void)
{
    frame(1U, "STATUS", 31U);
    bytes[14] = 0x07U;
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_NAME, decode());
    frame(1U, "ST\x80TUS", 31U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_NAME, decode());
    frame(1U, "", 31U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_NAME, decode());
}

void test_SWR_IGTL_020_name_of_other_letters_is_shown_without_them(void)
{
    frame(1U, "TRANSFORM", 48U);
    (void)memcpy(&bytes[14], "N\xC3\xA4hrohr\x07", 9U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_NAME, decode());
    TEST_ASSERT_EQUAL_STRING("N??hrohr?", header.name);
    TEST_ASSERT_EQUAL_UINT64(48U, header.body_bytes);
    TEST_ASSERT_FALSE(igtl_header_is_lost(&header));
    frame(1U, "TR\xFFNS", 48U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_NAME, decode());
    TEST_ASSERT_EQUAL_STRING("TR?NS", header.type);
}

void test_SWR_IGTL_003_texts_are_printable_ascii(void)
{
    put(58U, 3U, 2U);
    put(60U, 1U, 2U);
    bytes[62] = 0x1BU;
    frame(1U, "STRING", 5U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_TEXT, decode());
    put(58U, 4U, 2U);
    bytes[62] = (uint8_t)'A';
    frame(1U, "STRING", 5U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_ENCODING, decode());
    put(58U, 106U, 2U);
    frame(1U, "STRING", 5U);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode());
}

void test_SWR_IGTL_003_names_may_fill_their_field(void)
{
    frame(1U, "GET_TRANSFOR", 0U);
    (void)memcpy(&bytes[14], "CMD_1234567890123456", 20U);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode());
    TEST_ASSERT_EQUAL_STRING("CMD_1234567890123456", message.name);
}

void test_SWR_IGTL_004_unknown_type_is_known_to_be_unknown(void)
{
    frame(1U, "IMAGE", 100U);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, igtl_decode_header(bytes, &header));
    TEST_ASSERT_EQUAL_INT(IGTL_KIND_OTHER, header.kind);
    put(42U, LIMIT_IGTL_SKIP_MAX, 8U);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, igtl_decode_header(bytes, &header));
    put(42U, LIMIT_IGTL_SKIP_MAX + 1U, 8U);
    TEST_ASSERT_EQUAL_INT(IGTL_TOO_LONG, igtl_decode_header(bytes, &header));
}

void test_SWR_IGTL_018_each_question_and_stream_is_known(void)
{
    static const struct {
        const char *type;
        igtl_kind_t kind;
    } known[] = {{"GET_POINT", IGTL_KIND_GET_POINT},    {"GET_CAPABIL", IGTL_KIND_GET_CAPABILITY},
                 {"GET_IMAGE", IGTL_KIND_GET_OTHER},    {"GET_", IGTL_KIND_GET_OTHER},
                 {"STP_TDATA", IGTL_KIND_STP_TDATA},    {"STT_QTDATA", IGTL_KIND_STT_OTHER},
                 {"STP_QTDATA", IGTL_KIND_STP_OTHER},   {"STT_POLYDATA", IGTL_KIND_STT_OTHER},
                 {"GET_TRANS", IGTL_KIND_GET_TRANSFORM}};

    for (size_t i = 0U; i < (sizeof known / sizeof known[0]); i++) {
        frame(1U, known[i].type, 0U);
        TEST_ASSERT_EQUAL_INT(IGTL_OK, decode());
        TEST_ASSERT_EQUAL_INT(known[i].kind, message.kind);
        TEST_ASSERT_EQUAL_STRING(known[i].type, message.type);
    }
    frame(1U, "GET", 0U);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode());
    TEST_ASSERT_EQUAL_INT(IGTL_KIND_OTHER, message.kind);
}

void test_SWR_IGTL_018_questions_without_content_have_none(void)
{
    static const char *const types[] = {"GET_POINT", "GET_CAPABIL", "STP_TDATA"};

    for (size_t i = 0U; i < (sizeof types / sizeof types[0]); i++) {
        frame(1U, types[i], 1U);
        TEST_ASSERT_EQUAL_INT(IGTL_BAD_LENGTH, decode());
    }
    frame(1U, "GET_BIND", 1U);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode());
}

void test_SWR_IGTL_018_start_of_tracking_says_how_often_and_where(void)
{
    put(58U, 50U, 4U);
    (void)memcpy(&bytes[62], "patient", 7U);
    frame(1U, "STT_TDATA", 36U);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode());
    TEST_ASSERT_EQUAL_INT(IGTL_KIND_STT_TDATA, message.kind);
    TEST_ASSERT_EQUAL_INT32(50, message.resolution_ms);
    TEST_ASSERT_EQUAL_UINT32(7U, message.subject_bytes);
    TEST_ASSERT_EQUAL_MEMORY("patient", message.subject, 7U);
    put(58U, 0xFFFFFFFFU, 4U);
    (void)memset(&bytes[62], 'x', 32U);
    frame(1U, "STT_TDATA", 36U);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode());
    TEST_ASSERT_EQUAL_INT32(-1, message.resolution_ms);
    TEST_ASSERT_EQUAL_UINT32(32U, message.subject_bytes);
}

void test_SWR_IGTL_018_start_of_tracking_has_36_bytes(void)
{
    frame(1U, "STT_TDATA", 35U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_LENGTH, decode());
    frame(1U, "STT_TDATA", 37U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_LENGTH, decode());
    bytes[62] = 0x1BU;
    frame(1U, "STT_TDATA", 36U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_TEXT, decode());
}

/* The content of a COMMAND at `at`. */
static void put_command(uint32_t at, uint32_t encoding, uint32_t length)
{
    put(at, 0xDEADBEEFU, 4U);
    (void)memcpy(&bytes[at + 4U], "status", 6U);
    put(at + 132U, encoding, 2U);
    put(at + 134U, length, 4U);
    (void)memcpy(&bytes[at + 138U], "<now/>", 6U);
}

static void expect_command(void)
{
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode());
    TEST_ASSERT_EQUAL_INT(IGTL_KIND_COMMAND, message.kind);
    TEST_ASSERT_EQUAL_HEX32(0xDEADBEEFU, message.code);
    TEST_ASSERT_EQUAL_UINT32(6U, message.subject_bytes);
    TEST_ASSERT_EQUAL_MEMORY("status", message.subject, 6U);
    TEST_ASSERT_EQUAL_UINT32(6U, message.text_bytes);
    TEST_ASSERT_EQUAL_MEMORY("<now/>", message.text, 6U);
}

void test_SWR_IGTL_018_command_of_either_version_is_understood(void)
{
    put_command(58U, 3U, 6U);
    frame(1U, "COMMAND", 144U);
    expect_command();
    (void)memset(bytes, 0, sizeof bytes);
    put(58U, 12U, 2U);
    put(60U, 2U, 2U);
    put_command(70U, 106U, 6U);
    frame(2U, "COMMAND", 158U);
    expect_command();
    TEST_ASSERT_EQUAL_UINT32(2U, message.version);
}

void test_SWR_IGTL_018_command_without_text_may_have_a_name_that_fills_its_field(void)
{
    put_command(58U, 3U, 0U);
    (void)memset(&bytes[62], 'n', 128U);
    frame(1U, "COMMAND", 138U);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode());
    TEST_ASSERT_EQUAL_UINT32(128U, message.subject_bytes);
    TEST_ASSERT_EQUAL_UINT32(0U, message.text_bytes);
}

void test_SWR_IGTL_018_command_whose_length_does_not_fit_is_refused(void)
{
    put_command(58U, 3U, 7U);
    frame(1U, "COMMAND", 144U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_LENGTH, decode());
    put_command(58U, 3U, UINT32_MAX);
    frame(1U, "COMMAND", 137U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_LENGTH, decode());
    frame(1U, "COMMAND", 138U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_LENGTH, decode());
    put_command(58U, 4U, 6U);
    frame(1U, "COMMAND", 144U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_ENCODING, decode());
    put_command(58U, 3U, 6U);
    bytes[63] = 0x80U;
    frame(1U, "COMMAND", 144U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_TEXT, decode());
}

void test_SWR_IGTL_003_what_stands_behind_the_end_of_a_name_is_nothing(void)
{
    static const char filled[20] = "12345678901234567890";
    static const char strange[20] = "CURRENT\0\x80 \x01rubbish";
    char expected[IGTL_NAME_SIZE] = "CURRENT";

    frame(1U, "GET_STATUS", 0U);
    (void)memcpy(&bytes[14], strange, sizeof strange);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode());
    TEST_ASSERT_EQUAL_MEMORY(expected, message.name, IGTL_NAME_SIZE);
    for (uint32_t end = 0U; end < sizeof filled; end++) {
        (void)memset(expected, 0, sizeof expected);
        (void)memcpy(expected, filled, end);
        (void)memcpy(&bytes[14], filled, sizeof filled);
        bytes[14U + end] = 0U;
        TEST_ASSERT_EQUAL_INT(IGTL_OK, decode());
        TEST_ASSERT_EQUAL_MEMORY(expected, message.name, IGTL_NAME_SIZE);
    }
}

void test_SWR_IGTL_003_each_byte_of_a_name_is_judged(void)
{
    for (uint32_t at = 2U; at < 34U; at++) {
        const bool is_first_of_type = at == 2U;

        for (uint32_t value = 0U; value < 256U; value++) {
            const bool is_fine =
                (value == 0U) ? !is_first_of_type : ((value >= 0x20U) && (value <= 0x7EU));

            frame(1U, "ABCDEFGHIJKL", 0U);
            (void)memcpy(&bytes[14], "12345678901234567890", 20U);
            bytes[at] = (uint8_t)value;
            TEST_ASSERT_EQUAL_INT(is_fine ? IGTL_OK : IGTL_BAD_NAME,
                                  igtl_decode_header(bytes, &header));
        }
    }
}

void test_SWR_IGTL_003_each_byte_of_a_text_is_judged(void)
{
    for (uint32_t length = 1U; length < 20U; length++) {
        for (uint32_t at = 0U; at < length; at++) {
            for (uint32_t value = 0U; value < 256U; value++) {
                const bool is_fine = (value >= 0x20U) && (value <= 0x7EU);

                put(58U, 3U, 2U);
                put(60U, length, 2U);
                (void)memset(&bytes[62], '~', length);
                bytes[62U + at] = (uint8_t)value;
                frame(1U, "STRING", 4U + length);
                TEST_ASSERT_EQUAL_INT(is_fine ? IGTL_OK : IGTL_BAD_TEXT, decode());
            }
        }
    }
}

/* A body of version 2 at 58, as large as is stated: `content_bytes` of zeros, then the metadata of
 * keys and values in turn. */
static uint32_t put_with_metadata(uint32_t content_bytes, const char *const *words, uint32_t count)
{
    const uint32_t metadata = 70U + content_bytes;
    uint32_t at = metadata + 2U + (8U * count);
    const uint32_t data = at;

    (void)memset(bytes, 0, sizeof bytes);
    for (uint32_t i = 0U; i < count; i++) {
        const uint32_t key_bytes = (uint32_t)strlen(words[2U * i]);
        const uint32_t value_bytes = (uint32_t)strlen(words[(2U * i) + 1U]);

        put(metadata + 2U + (8U * i), key_bytes, 2U);
        put(metadata + 4U + (8U * i), IGTL_ENCODING_ASCII, 2U);
        put(metadata + 6U + (8U * i), value_bytes, 4U);
        (void)memcpy(&bytes[at], words[2U * i], key_bytes);
        (void)memcpy(&bytes[at + key_bytes], words[(2U * i) + 1U], value_bytes);
        at += key_bytes + value_bytes;
    }
    put(metadata, count, 2U);
    put(58U, 12U, 2U);
    put(60U, 2U + (8U * count), 2U);
    put(62U, at - data, 4U);
    return at - IGTL_HEADER_BYTES;
}

static igtl_result_t decode_transform_that_says(const char *key, const char *value)
{
    const char *words[2] = {key, value};

    frame(2U, "TRANSFORM", put_with_metadata(IGTL_TRANSFORM_BYTES, words, 1U));
    return decode();
}

void test_SWR_IGTL_054_transform_that_is_valid_is_taken(void)
{
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode_transform_that_says("TransformStatus", "OK"));
    TEST_ASSERT_EQUAL_UINT32(IGTL_TRANSFORM_BYTES, message.content_bytes);
    frame(2U, "TRANSFORM", put_with_metadata(IGTL_TRANSFORM_BYTES, NULL, 0U));
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode());
}

void test_SWR_IGTL_054_transform_without_metadata_is_taken(void)
{
    put(58U, 12U, 2U);
    (void)memset(&bytes[118], 0xFF, 64U); /* Bytes behind the message. */
    frame(2U, "TRANSFORM", 12U + IGTL_TRANSFORM_BYTES);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode());
}

void test_SWR_IGTL_054_transform_that_says_anything_but_ok_is_refused(void)
{
    static const char *const values[] = {"INVALID", "MISSING", "OUT_OF_RANGE", "",  "O",
                                         "OK ",     "OK2",     "ok",           "KO"};

    for (size_t i = 0U; i < (sizeof values / sizeof values[0]); i++) {
        TEST_ASSERT_EQUAL_INT(IGTL_MARKED_INVALID,
                              decode_transform_that_says("TransformStatus", values[i]));
    }
}

void test_SWR_IGTL_054_value_with_a_byte_behind_ok_is_another_one(void)
{
    (void)decode_transform_that_says("TransformStatus", "OK.");
    bytes[58U + header.body_bytes - 1U] = 0U;
    frame(2U, "TRANSFORM", (uint32_t)header.body_bytes);
    TEST_ASSERT_EQUAL_INT(IGTL_MARKED_INVALID, decode());
}

void test_SWR_IGTL_054_other_keys_say_nothing_of_it(void)
{
    static const char *const keys[] = {"Status",           "TransformStatu", "TransformStatuS",
                                       "TransformStatus2", "ransformStatus", ""};

    for (size_t i = 0U; i < (sizeof keys / sizeof keys[0]); i++) {
        TEST_ASSERT_EQUAL_INT(IGTL_OK, decode_transform_that_says(keys[i], "INVALID"));
    }
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode_transform_that_says("", "TransformStatusINVALID"));
}

void test_SWR_IGTL_054_every_one_of_many_keys_counts(void)
{
    static const char *const last[] = {"Status", "OK", "TransformStatus", "INVALID"};
    static const char *const first[] = {"TransformStatus", "INVALID", "TransformStatus", "OK"};
    static const char *const second[] = {"TransformStatus", "OK", "TransformStatus", "INVALID"};
    static const char *const both[] = {"TransformStatus", "OK", "TransformStatus", "OK"};

    frame(2U, "TRANSFORM", put_with_metadata(IGTL_TRANSFORM_BYTES, last, 2U));
    TEST_ASSERT_EQUAL_INT(IGTL_MARKED_INVALID, decode());
    frame(2U, "TRANSFORM", put_with_metadata(IGTL_TRANSFORM_BYTES, first, 2U));
    TEST_ASSERT_EQUAL_INT(IGTL_MARKED_INVALID, decode());
    frame(2U, "TRANSFORM", put_with_metadata(IGTL_TRANSFORM_BYTES, second, 2U));
    TEST_ASSERT_EQUAL_INT(IGTL_MARKED_INVALID, decode());
    frame(2U, "TRANSFORM", put_with_metadata(IGTL_TRANSFORM_BYTES, both, 2U));
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode());
}

void test_SWR_IGTL_054_other_types_have_no_such_mark(void)
{
    static const struct {
        const char *type;
        uint32_t content_bytes;
    } others[] = {{"STATUS", 31U}, {"POINT", 136U}, {"GET_TRANS", 0U}, {"STT_TDATA", 36U}};
    static const char *const words[] = {"TransformStatus", "INVALID"};

    for (size_t i = 0U; i < (sizeof others / sizeof others[0]); i++) {
        frame(2U, others[i].type, put_with_metadata(others[i].content_bytes, words, 1U));
        TEST_ASSERT_EQUAL_INT(IGTL_OK, decode());
    }
}

void test_SWR_IGTL_054_metadata_that_does_not_add_up_is_judged_before_it_is_read(void)
{
    TEST_ASSERT_EQUAL_INT(IGTL_MARKED_INVALID,
                          decode_transform_that_says("TransformStatus", "INVALID"));
    put(70U + IGTL_TRANSFORM_BYTES + 6U, UINT32_MAX, 4U); /* The value's length. */
    frame(2U, "TRANSFORM", (uint32_t)header.body_bytes);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_METADATA, decode());
}

/* TRAJ elements that begin at byte 58, the first of type 3 at (1, 2, 3), its target at (4, 5, 6).
 */
static void put_trajectories(uint32_t count)
{
    static const float places[IGTL_TRAJECTORY_NUMBERS] = {1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F};
    uint32_t bits;

    put(IGTL_HEADER_BYTES + 96U, 3U, 1U);
    for (uint32_t i = 0U; i < IGTL_TRAJECTORY_NUMBERS; i++) {
        (void)memcpy(&bits, &places[i], sizeof bits);
        put(IGTL_HEADER_BYTES + 102U + (4U * i), bits, 4U);
    }
    frame(1U, "TRAJ", count * IGTL_TRAJECTORY_BYTES);
}

void test_SWR_IGTL_067_a_trajectory_is_understood(void)
{
    static const uint32_t expected[IGTL_TRAJECTORY_NUMBERS] = {
        ONE, 0x40000000U, 0x40400000U, 0x40800000U, 0x40A00000U, 0x40C00000U};

    put_trajectories(1U);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode());
    TEST_ASSERT_EQUAL_INT(IGTL_KIND_TRAJECTORY, message.kind);
    TEST_ASSERT_EQUAL_UINT32(3U, message.code);
    TEST_ASSERT_EQUAL_HEX32_ARRAY(expected, message.numbers, IGTL_TRAJECTORY_NUMBERS);
}

void test_SWR_IGTL_068_a_trajectory_comes_alone(void)
{
    put_trajectories(0U);
    TEST_ASSERT_EQUAL_INT(IGTL_NOT_ONE, decode());
    put_trajectories(2U);
    TEST_ASSERT_EQUAL_INT(IGTL_NOT_ONE, decode());
    put_trajectories(1U);
    frame(1U, "TRAJ", IGTL_TRAJECTORY_BYTES - 1U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_LENGTH, decode());
    frame(1U, "TRAJ", IGTL_TRAJECTORY_BYTES + 1U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_LENGTH, decode());
    put_trajectories(1U);
    bytes[IGTL_HEADER_BYTES] ^= 1U;
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_CRC, decode());
    TEST_ASSERT_EQUAL_UINT32(IGTL_STATUS_CONFIG_ERROR, igtl_result_code(IGTL_NOT_ONE));
}

static void frame_array(uint32_t type, uint32_t dimensions, uint32_t rows, uint32_t body_bytes)
{
    put(IGTL_HEADER_BYTES, type, 1U);
    put(IGTL_HEADER_BYTES + 1U, dimensions, 1U);
    put(IGTL_HEADER_BYTES + 2U, rows, 2U);
    put(IGTL_HEADER_BYTES + 4U, 3U, 2U);
    frame(1U, "NDARRAY", body_bytes);
}

void test_SWR_TRAJ_022_an_array_is_understood_row_by_row(void)
{
    put(IGTL_HEADER_BYTES + 6U + (8U * 5U), 0x4008000000000000U, 8U);
    frame_array(11U, 2U, 2U, 6U + (2U * 3U * 8U));
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode());
    TEST_ASSERT_EQUAL_INT(IGTL_KIND_ARRAY, message.kind);
    TEST_ASSERT_EQUAL_UINT32(2U, message.rows);
    TEST_ASSERT_EQUAL_UINT32(3U, message.columns);
    TEST_ASSERT_EQUAL_HEX64(0x4008000000000000U, igtl_array_bits(&message, 5U));
    setUp();
    put(IGTL_HEADER_BYTES + 6U + (4U * 2U), ONE, 4U);
    frame_array(10U, 2U, 2U, 6U + (2U * 3U * 4U));
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode());
    TEST_ASSERT_EQUAL_HEX64(ONE, igtl_array_bits(&message, 2U));
}

void test_SWR_TRAJ_023_other_arrays_are_refused(void)
{
    frame_array(6U, 2U, 2U, 6U + (2U * 3U * 4U));
    TEST_ASSERT_EQUAL_INT(IGTL_NOT_TABLE, decode());
    frame_array(11U, 3U, 2U, 6U + (2U * 3U * 8U));
    TEST_ASSERT_EQUAL_INT(IGTL_NOT_TABLE, decode());
    frame_array(11U, 1U, 2U, 6U + (2U * 3U * 8U));
    TEST_ASSERT_EQUAL_INT(IGTL_NOT_TABLE, decode());
    frame_array(11U, 2U, 2U, 5U);
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_LENGTH, decode());
    frame_array(11U, 2U, 2U, 5U + (2U * 3U * 8U));
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_LENGTH, decode());
    frame_array(11U, 2U, 65535U, 6U + (2U * 3U * 8U));
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_LENGTH, decode());
    TEST_ASSERT_EQUAL_UINT32(IGTL_STATUS_CONFIG_ERROR, igtl_result_code(IGTL_NOT_TABLE));
}

void test_SWR_IGTL_003_an_array_may_be_longer_up_to_its_own_limit(void)
{
    frame(1U, "NDARRAY", 0U);
    put(42U, LIMIT_IGTL_ARRAY_MAX, 8U);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, igtl_decode_header(bytes, &header));
    put(42U, LIMIT_IGTL_ARRAY_MAX + 1U, 8U);
    TEST_ASSERT_EQUAL_INT(IGTL_TOO_LONG, igtl_decode_header(bytes, &header));
    TEST_ASSERT_FALSE(igtl_header_is_lost(&header));
}

void test_SWR_IGTL_002_each_refusal_has_a_name_and_a_code(void)
{
    for (int32_t i = (int32_t)IGTL_OK; i <= (int32_t)IGTL_MARKED_INVALID; i++) {
        TEST_ASSERT_NOT_NULL(strstr(igtl_result_text((igtl_result_t)i), ": "));
    }
    TEST_ASSERT_EQUAL_UINT32(IGTL_STATUS_CHECKSUM_ERROR, igtl_result_code(IGTL_BAD_CRC));
    TEST_ASSERT_EQUAL_UINT32(IGTL_STATUS_OVERFLOW, igtl_result_code(IGTL_TOO_LONG));
    TEST_ASSERT_EQUAL_UINT32(IGTL_STATUS_UNKNOWN_VERSION, igtl_result_code(IGTL_BAD_VERSION));
    TEST_ASSERT_EQUAL_UINT32(IGTL_STATUS_TIME_OUT, igtl_result_code(IGTL_INCOMPLETE));
    TEST_ASSERT_EQUAL_UINT32(IGTL_STATUS_CONFIG_ERROR, igtl_result_code(IGTL_BAD_LENGTH));
    TEST_ASSERT_EQUAL_UINT32(IGTL_STATUS_CONFIG_ERROR, igtl_result_code(IGTL_MARKED_INVALID));
}
