/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: queries, commands, metadata, trajectories and arrays are decoded within their
 * bodies; other contents are refused.
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

void test_SWR_IGTL_018_each_question_and_stream_is_known(void)
{
    static const struct {
        const char *type;
        igtl_kind_t kind;
    } known[] = {{"GET_POINT", IGTL_KIND_GET_POINT},     {"GET_CAPABIL", IGTL_KIND_GET_CAPABILITY},
                 {"GET_IMAGE", IGTL_KIND_GET_OTHER},     {"GET_", IGTL_KIND_GET_OTHER},
                 {"STP_TDATA", IGTL_KIND_STP_TDATA},     {"STT_QTDATA", IGTL_KIND_STT_OTHER},
                 {"STP_QTDATA", IGTL_KIND_STP_OTHER},    {"STT_POLYDATA", IGTL_KIND_STT_OTHER},
                 {"GET_TRANS", IGTL_KIND_GET_TRANSFORM}, {"GET_SENSOR", IGTL_KIND_GET_SENSOR}};

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
    static const char *const types[] = {"GET_POINT", "GET_CAPABIL", "GET_SENSOR", "STP_TDATA"};

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
