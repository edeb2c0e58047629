/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: what is written is what the standard's own library writes, with header version
 * 1, and is extended to version 2 without a change of its content.
 */
#include "igtl/wire/igtl_codec.h"
#include "igtl/wire/igtl_packet.h"
#include "unity.h"

#include <stdbool.h>
#include <string.h>

#define ONE 0x3F800000U

static igtl_header_t header;
static igtl_message_t message;
static igtl_packet_t packet;
static igtl_packet_t extended;

/* Nothing is written over what was there before but by the message itself. */
void setUp(void)
{
    (void)memset(&packet, 0xA5, sizeof packet);
    (void)memset(&extended, 0xA5, sizeof extended);
    (void)memset(&message, 0, sizeof message);
}

void tearDown(void)
{
}

static igtl_result_t decode(const igtl_packet_t *sent)
{
    const igtl_result_t result = igtl_decode_header(sent->bytes, &header);

    TEST_ASSERT_EQUAL_UINT64(sent->length, IGTL_HEADER_BYTES + header.body_bytes);
    return (result == IGTL_OK)
               ? igtl_decode_body(&header, &sent->bytes[IGTL_HEADER_BYTES], &message)
               : result;
}

void test_SWR_IGTL_005_string_has_the_bytes_of_the_standard(void)
{
    igtl_encode_string(&packet, "ACK_0001", "START_UP", 0U);
    TEST_ASSERT_EQUAL_UINT32(70U, packet.length);
    TEST_ASSERT_EQUAL_MEMORY("\x00\x01STRING\0\0\0\0\0\0ACK_0001\0\0\0\0\0\0\0\0\0\0\0\0",
                             packet.bytes, 34U);
    TEST_ASSERT_EQUAL_MEMORY("\0\0\0\0\0\0\0\x0C", &packet.bytes[42], 8U);
    TEST_ASSERT_EQUAL_MEMORY("\x00\x03\x00\x08START_UP", &packet.bytes[58], 12U);
}

void test_SWR_IGTL_005_status_ends_with_nul_and_cuts_its_error_name(void)
{
    const igtl_status_t status = {13U, "a name of twenty-two c", "text"};

    igtl_encode_status(&packet, "CURRENT_STATUS", &status, 0U);
    TEST_ASSERT_EQUAL_UINT32(58U + 30U + 5U, packet.length);
    TEST_ASSERT_EQUAL_MEMORY("\x00\x0D\0\0\0\0\0\0\0\0a name of twenty-tw\0text", &packet.bytes[58],
                             35U);
}

void test_SWR_IGTL_005_long_names_and_texts_are_cut(void)
{
    char text[1000];

    (void)memset(text, 'x', sizeof text - 1U);
    text[sizeof text - 1U] = '\0';
    igtl_encode_string(&packet, "a device name of thirty chars.", text, 0U);
    TEST_ASSERT_EQUAL_UINT32(58U + 4U + IGTL_TEXT_MAX, packet.length);
    TEST_ASSERT_EQUAL_MEMORY("a device name of thi\0", &packet.bytes[14], 21U);
}

void test_SWR_IGTL_005_point_has_136_bytes(void)
{
    static const uint32_t numbers[3] = {ONE, 0U, 0xBF800000U};
    uint8_t expected[136] = "entry_point";

    (void)memcpy(&expected[96], "\xFF\xFF\xFF\xFF\x3F\x80\0\0\0\0\0\0\xBF\x80\0\0", 16U);
    igtl_encode_point(&packet, "entry_point", numbers, 7U);
    TEST_ASSERT_EQUAL_UINT32(58U + 136U, packet.length);
    TEST_ASSERT_EQUAL_MEMORY(expected, &packet.bytes[58], sizeof expected);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode(&packet));
}

void test_SWR_IGTL_005_transform_is_read_back_bit_by_bit(void)
{
    uint32_t numbers[12];

    for (uint32_t i = 0U; i < 12U; i++) {
        numbers[i] = 0x7FC00001U * (i + 1U);
    }
    igtl_encode_transform(&packet, "ACK_1", numbers, UINT64_C(0x0102030405060708));
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode(&packet));
    TEST_ASSERT_EQUAL_HEX32_ARRAY(numbers, message.numbers, 12U);
    TEST_ASSERT_EQUAL_MEMORY("\1\2\3\4\5\6\7\x08", &packet.bytes[34], 8U);
}

void test_SWR_IGTL_019_empty_answer_is_a_header(void)
{
    igtl_encode_empty(&packet, "GET_TRANSFORM", "TARGET", 0U);
    TEST_ASSERT_EQUAL_UINT32(58U, packet.length);
    TEST_ASSERT_EQUAL_MEMORY("\x00\x01GET_TRANSFORTARGET\0", packet.bytes, 21U);
    TEST_ASSERT_EQUAL_MEMORY("\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0", &packet.bytes[42], 16U);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode(&packet));
}

void test_SWR_IGTL_019_capability_names_types_of_12_bytes(void)
{
    static const char *const types[] = {"TRANSFORM", "GET_CAPABIL", "GET_TRANSFORM"};

    igtl_encode_capability(&packet, "", types, 3U, 0U);
    TEST_ASSERT_EQUAL_UINT32(58U + 36U, packet.length);
    TEST_ASSERT_EQUAL_MEMORY("TRANSFORM\0\0\0GET_CAPABIL\0GET_TRANSFOR", &packet.bytes[58], 36U);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode(&packet));
}

void test_SWR_IGTL_019_capability_is_bounded(void)
{
    const char *types[IGTL_CAPABILITIES_MAX + 1U];

    for (uint32_t i = 0U; i <= IGTL_CAPABILITIES_MAX; i++) {
        types[i] = "STATUS";
    }
    igtl_encode_capability(&packet, "", types, IGTL_CAPABILITIES_MAX + 1U, 0U);
    TEST_ASSERT_EQUAL_UINT32(58U + (12U * IGTL_CAPABILITIES_MAX), packet.length);
    igtl_packet_extend(&extended, &packet);
    TEST_ASSERT_LESS_OR_EQUAL_UINT32(IGTL_PACKET_MAX, extended.length);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode(&extended));
}

void test_SWR_IGTL_019_return_says_0_or_1(void)
{
    igtl_encode_return(&packet, "RTS_TDATA", "robot", false, 0U);
    TEST_ASSERT_EQUAL_UINT32(59U, packet.length);
    TEST_ASSERT_EQUAL_HEX8(0U, packet.bytes[58]);
    igtl_encode_return(&packet, "RTS_TDATA", "robot", true, 0U);
    TEST_ASSERT_EQUAL_HEX8(1U, packet.bytes[58]);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode(&packet));
    TEST_ASSERT_EQUAL_STRING("RTS_TDATA", message.type);
    TEST_ASSERT_EQUAL_STRING("robot", message.name);
}

void test_SWR_IGTL_019_tracking_has_70_bytes_for_each_instrument(void)
{
    igtl_tracked_t elements[IGTL_TRACKED_MAX + 1U] = {{"needle", {ONE}},
                                                      {"a name of twenty-two c", {0U}}};

    for (uint32_t i = 2U; i <= IGTL_TRACKED_MAX; i++) {
        elements[i].name = "";
    }
    elements[0].numbers[11] = 0xBF800000U;
    igtl_encode_tracking(&packet, "robot", elements, 2U, 0U);
    TEST_ASSERT_EQUAL_UINT32(58U + 140U, packet.length);
    TEST_ASSERT_EQUAL_MEMORY("needle\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x02\0\x3F\x80\0\0",
                             &packet.bytes[58], 26U);
    TEST_ASSERT_EQUAL_MEMORY("\xBF\x80\0\0a name of twenty-tw\0\x02\0", &packet.bytes[58 + 66],
                             26U);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode(&packet));
    igtl_encode_tracking(&packet, "robot", elements, IGTL_TRACKED_MAX + 1U, 0U);
    TEST_ASSERT_EQUAL_UINT32(58U + (70U * IGTL_TRACKED_MAX), packet.length);
}

/* One value, reserved byte, newton as the library packs it, 1.5 as a double. */
void test_SWR_IGTL_610_sensor_is_one_value_in_newton(void)
{
    igtl_encode_force(&packet, "FORCE_HAND", UINT64_C(0x3FF8000000000000), 7U);
    TEST_ASSERT_EQUAL_UINT32(58U + 18U, packet.length);
    TEST_ASSERT_EQUAL_MEMORY("\0\1SENSOR\0\0\0\0\0\0FORCE_HAND\0", packet.bytes, 25U);
    TEST_ASSERT_EQUAL_MEMORY("\1\0\x02\xC4\0\0\0\0\0\0\x3F\xF8\0\0\0\0\0\0", &packet.bytes[58],
                             18U);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode(&packet));
}

static void reply_to_command(bool is_refused)
{
    const igtl_message_t command = {.kind = IGTL_KIND_COMMAND,
                                    .name = "command",
                                    .code = 0x01020304U,
                                    .subject = "statusXXX",
                                    .subject_bytes = 6U};

    igtl_encode_command_reply(&packet, &command, is_refused, "ready", 9U);
}

void test_SWR_IGTL_019_command_is_answered_with_its_id_and_names(void)
{
    uint8_t expected[4U + IGTL_COMMAND_NAME_BYTES] = {0U};

    reply_to_command(false);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode(&packet));
    TEST_ASSERT_EQUAL_UINT32(2U, header.version);
    TEST_ASSERT_EQUAL_STRING("RTS_COMMAND", message.type);
    TEST_ASSERT_EQUAL_STRING("command", message.name);
    TEST_ASSERT_EQUAL_UINT32(138U + 5U, message.content_bytes);
    (void)memcpy(expected, "\1\2\3\4status", 10U);
    TEST_ASSERT_EQUAL_MEMORY(expected, message.content, sizeof expected);
    TEST_ASSERT_EQUAL_MEMORY("\0\3\0\0\0\5ready", &message.content[132], 11U);
}

void test_SWR_IGTL_019_metadata_of_a_reply_says_how_it_went(void)
{
    reply_to_command(false);
    TEST_ASSERT_EQUAL_MEMORY("\0\1\0\6\0\3\0\0\0\7StatusSUCCESS",
                             &packet.bytes[packet.length - 23U], 23U);
    reply_to_command(true);
    TEST_ASSERT_EQUAL_MEMORY("\0\1\0\6\0\3\0\0\0\4StatusFAIL", &packet.bytes[packet.length - 20U],
                             20U);
}

void test_SWR_IGTL_019_longest_reply_has_room(void)
{
    char name[IGTL_COMMAND_NAME_BYTES];
    char text[IGTL_TEXT_MAX + 2U];
    const igtl_message_t command = {
        .name = "12345678901234567890", .subject = name, .subject_bytes = sizeof name};

    (void)memset(name, 'n', sizeof name);
    (void)memset(text, 't', sizeof text - 1U);
    text[sizeof text - 1U] = '\0';
    igtl_encode_command_reply(&packet, &command, false, text, 0U);
    TEST_ASSERT_LESS_OR_EQUAL_UINT32(IGTL_PACKET_MAX, packet.length);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode(&packet));
    TEST_ASSERT_EQUAL_UINT32(138U + IGTL_TEXT_MAX, message.content_bytes);
}

void test_SWR_IGTL_005_extended_message_has_the_content_and_no_metadata(void)
{
    igtl_encode_string(&packet, "ACK_0001", "START_UP", 0x0102030405060708U);
    igtl_packet_extend(&extended, &packet);
    TEST_ASSERT_EQUAL_UINT32(70U + 12U + 2U, extended.length);
    TEST_ASSERT_EQUAL_MEMORY("\0\2STRING", extended.bytes, 8U);
    TEST_ASSERT_EQUAL_MEMORY(&packet.bytes[2], &extended.bytes[2], 40U);
    TEST_ASSERT_EQUAL_MEMORY("\0\x0C\0\2\0\0\0\0\0\0\0\0\0\3\0\x08START_UP\0\0",
                             &extended.bytes[58], 26U);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode(&extended));
    TEST_ASSERT_EQUAL_MEMORY("START_UP", message.text, 8U);
}

void test_SWR_IGTL_005_extended_transform_says_that_it_is_valid(void)
{
    const uint32_t numbers[12] = {ONE, 0U, 0U, 0U, ONE, 0U, 0U, 0U, ONE, ONE, 2U, 3U};

    igtl_encode_transform(&packet, "CURRENT_POSITION", numbers, 0U);
    igtl_packet_extend(&extended, &packet);
    TEST_ASSERT_EQUAL_UINT32(106U + 12U + 10U + 17U, extended.length);
    TEST_ASSERT_EQUAL_MEMORY("\0\1\0\x0F\0\3\0\0\0\2TransformStatusOK", &extended.bytes[118], 27U);
    TEST_ASSERT_EQUAL_INT(IGTL_OK, decode(&extended));
    TEST_ASSERT_EQUAL_HEX32_ARRAY(numbers, message.numbers, 12U);
}

void test_SWR_IGTL_045_a_point_without_a_point_has_metadata_so_that_its_reader_looks_at_it(void)
{
    igtl_encode_empty(&packet, "POINT", "entry_point", 0U);
    igtl_packet_extend(&extended, &packet);
    TEST_ASSERT_EQUAL_UINT32(58U + 12U + 10U + 8U, extended.length);
    TEST_ASSERT_EQUAL_MEMORY("\0\x0C\0\x0A\0\0\0\x08\0\0\0\0\0\1\0\6\0\3\0\0\0\2StatusOK",
                             &extended.bytes[58], 30U);
    igtl_encode_empty(&packet, "IMAGE", "entry_point", 0U);
    igtl_packet_extend(&extended, &packet);
    TEST_ASSERT_EQUAL_UINT32(58U + 12U + 2U, extended.length);
}

void test_SWR_IGTL_005_extended_message_stays_as_it_is(void)
{
    reply_to_command(false);
    igtl_packet_extend(&extended, &packet);
    TEST_ASSERT_EQUAL_UINT32(packet.length, extended.length);
    TEST_ASSERT_EQUAL_MEMORY(packet.bytes, extended.bytes, packet.length);
}
