/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: a message is understood exactly when every byte of it fits, whichever header
 * version it has.
 */
#include "igtl/wire/igtl_codec.h"
#include "unity.h"
#include "unit/support/igtl_codec_world.inc"

void setUp(void)
{
    begin_message();
}

void tearDown(void)
{
}

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

static igtl_packet_t packet;

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
