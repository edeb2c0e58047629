/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: messages come out whole however their bytes arrive, what is unknown passes, what
 * is wrong is named, and what stays incomplete is noticed.
 */
#include "igtl/wire/igtl_codec.h"
#include "igtl/wire/igtl_crc64.h"
#include "igtl/wire/igtl_packet.h"
#include "igtl/wire/igtl_inbox.h"
#include "limits/requirement_limits.h"
#include "unity.h"

#include <string.h>

static igtl_inbox_t inbox;
static igtl_packet_t packet;

void setUp(void)
{
    igtl_inbox_init(&inbox);
    igtl_encode_string(&packet, "CMD_1", "STOP", 0U);
}

void tearDown(void)
{
}

/* Hands in bytes, `piece` at a time; the last event. */
static igtl_inbox_event_t feed(const uint8_t *bytes, uint32_t length, uint32_t piece,
                               uint64_t now_us)
{
    igtl_inbox_event_t event = IGTL_INBOX_WAITING;
    uint32_t used = 0U;

    while ((used < length) && (event == IGTL_INBOX_WAITING)) {
        uint8_t *where;
        uint32_t room = igtl_inbox_room(&inbox, &where);

        room = (room < piece) ? room : piece;
        room = (room < (length - used)) ? room : (length - used);
        (void)memcpy(where, &bytes[used], room);
        event = igtl_inbox_advance(&inbox, room, now_us);
        used += room;
    }
    TEST_ASSERT_EQUAL_UINT32(length, used);
    return event;
}

static void retype(const char *type)
{
    (void)memset(&packet.bytes[2], 0, 12U);
    (void)memcpy(&packet.bytes[2], type, strlen(type));
}

void test_SWR_IGTL_003_message_in_single_bytes_is_whole(void)
{
    for (uint32_t piece = 1U; piece < 80U; piece++) {
        TEST_ASSERT_EQUAL_INT(IGTL_INBOX_MESSAGE, feed(packet.bytes, packet.length, piece, 0U));
        TEST_ASSERT_EQUAL_STRING("CMD_1", inbox.message.name);
        TEST_ASSERT_EQUAL_MEMORY("STOP", inbox.message.text, 4U);
    }
}

void test_SWR_IGTL_003_room_never_reaches_into_the_next_message(void)
{
    uint8_t *where;

    TEST_ASSERT_EQUAL_INT(IGTL_INBOX_WAITING, feed(packet.bytes, IGTL_HEADER_BYTES, 58U, 0U));
    TEST_ASSERT_EQUAL_UINT32(packet.length - IGTL_HEADER_BYTES, igtl_inbox_room(&inbox, &where));
}

void test_SWR_IGTL_002_wrong_checksum_is_refused_and_the_next_message_is_read(void)
{
    packet.bytes[60] ^= 1U;
    TEST_ASSERT_EQUAL_INT(IGTL_INBOX_REFUSED, feed(packet.bytes, packet.length, 100U, 0U));
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_CRC, inbox.reason);
    packet.bytes[60] ^= 1U;
    TEST_ASSERT_EQUAL_INT(IGTL_INBOX_MESSAGE, feed(packet.bytes, packet.length, 100U, 0U));
}

void test_SWR_IGTL_004_unknown_type_passes_and_the_next_message_is_read(void)
{
    retype("SENSOR");
    TEST_ASSERT_EQUAL_INT(IGTL_INBOX_SKIPPED, feed(packet.bytes, packet.length, 7U, 0U));
    retype("STRING");
    TEST_ASSERT_EQUAL_INT(IGTL_INBOX_MESSAGE, feed(packet.bytes, packet.length, 7U, 0U));
}

void test_SWR_IGTL_004_unknown_type_without_body_passes(void)
{
    retype("RTS_TDATA");
    (void)memset(&packet.bytes[42], 0, 16U);
    TEST_ASSERT_EQUAL_INT(IGTL_INBOX_SKIPPED, feed(packet.bytes, IGTL_HEADER_BYTES, 58U, 0U));
}

void test_SWR_IGTL_004_image_much_longer_than_the_buffer_passes(void)
{
    static uint8_t image[100000];
    uint8_t header[IGTL_HEADER_BYTES] = {0U, 1U, 'I', 'M', 'A', 'G', 'E'};
    uint64_t crc;

    (void)memset(image, 0x5A, sizeof image);
    crc = igtl_crc64(0U, image, sizeof image);
    header[47] = (uint8_t)(sizeof image >> 16U);
    header[48] = (uint8_t)(sizeof image >> 8U);
    header[49] = (uint8_t)(sizeof image & 0xFFU);
    for (uint32_t i = 0U; i < 8U; i++) {
        header[50U + i] = (uint8_t)(crc >> (56U - (8U * i)));
    }
    TEST_ASSERT_EQUAL_INT(IGTL_INBOX_WAITING, feed(header, sizeof header, 58U, 0U));
    TEST_ASSERT_EQUAL_INT(IGTL_INBOX_SKIPPED, feed(image, sizeof image, 5000U, 0U));
    TEST_ASSERT_EQUAL_INT(IGTL_INBOX_MESSAGE, feed(packet.bytes, packet.length, 58U, 0U));
}

void test_SWR_IGTL_002_wrong_checksum_of_an_unknown_type_is_refused(void)
{
    retype("SENSOR");
    packet.bytes[57] ^= 1U;
    TEST_ASSERT_EQUAL_INT(IGTL_INBOX_REFUSED, feed(packet.bytes, packet.length, 7U, 0U));
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_CRC, inbox.reason);
}

/* A header of `length` bytes to come. */
static void announce(uint32_t length)
{
    packet.bytes[46] = (uint8_t)(length >> 24U);
    packet.bytes[47] = (uint8_t)(length >> 16U);
    packet.bytes[48] = (uint8_t)(length >> 8U);
    packet.bytes[49] = (uint8_t)length;
}

/* So many bytes in pieces that the buffer takes; the last event. */
static igtl_inbox_event_t feed_zeros(uint32_t length, uint64_t now_us)
{
    igtl_inbox_event_t event = IGTL_INBOX_WAITING;

    for (uint32_t used = 0U; used < length;) {
        uint8_t *where;
        uint32_t room = igtl_inbox_room(&inbox, &where);

        TEST_ASSERT_TRUE((where >= inbox.buffer) &&
                         ((where + room) <= (inbox.buffer + sizeof inbox.buffer)));
        room = (room < (length - used)) ? room : (length - used);
        (void)memset(where, 0, room);
        TEST_ASSERT_EQUAL_INT(IGTL_INBOX_WAITING, event);
        event = igtl_inbox_advance(&inbox, room, now_us);
        used += room;
    }
    return event;
}

static void expect_next_message(void)
{
    igtl_encode_string(&packet, "CMD_1", "STOP", 0U);
    TEST_ASSERT_EQUAL_INT(IGTL_INBOX_MESSAGE, feed(packet.bytes, packet.length, 100U, 0U));
}

void test_SWR_IGTL_004_longest_image_passes_and_a_longer_one_breaks_the_connection(void)
{
    retype("IMAGE");
    announce(LIMIT_IGTL_SKIP_MAX);
    (void)memset(&packet.bytes[50], 0, 8U);
    TEST_ASSERT_EQUAL_INT(IGTL_INBOX_WAITING, feed(packet.bytes, IGTL_HEADER_BYTES, 58U, 0U));
    TEST_ASSERT_EQUAL_INT(IGTL_INBOX_SKIPPED, feed_zeros(LIMIT_IGTL_SKIP_MAX, 0U));
    announce(LIMIT_IGTL_SKIP_MAX + 1U);
    TEST_ASSERT_EQUAL_INT(IGTL_INBOX_BROKEN, feed(packet.bytes, IGTL_HEADER_BYTES, 58U, 0U));
    TEST_ASSERT_EQUAL_INT(IGTL_TOO_LONG, inbox.reason);
}

void test_SWR_IGTL_003_known_type_that_is_too_long_is_refused_and_the_next_message_is_read(void)
{
    announce(LIMIT_IGTL_BODY_MAX + 1U);
    TEST_ASSERT_EQUAL_INT(IGTL_INBOX_WAITING, feed(packet.bytes, IGTL_HEADER_BYTES, 58U, 0U));
    TEST_ASSERT_EQUAL_INT(IGTL_INBOX_WAITING, feed_zeros(LIMIT_IGTL_BODY_MAX, 0U));
    TEST_ASSERT_EQUAL_INT(IGTL_INBOX_REFUSED, feed_zeros(1U, 0U));
    TEST_ASSERT_EQUAL_INT(IGTL_TOO_LONG, inbox.reason);
    TEST_ASSERT_EQUAL_STRING("CMD_1", inbox.header.name);
    expect_next_message();
}

void test_SWR_IGTL_020_name_of_other_letters_is_refused_and_the_next_message_is_read(void)
{
    packet.bytes[14] = 0xC3U;
    TEST_ASSERT_EQUAL_INT(IGTL_INBOX_REFUSED, feed(packet.bytes, packet.length, 7U, 0U));
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_NAME, inbox.reason);
    TEST_ASSERT_EQUAL_STRING("?MD_1", inbox.header.name);
    expect_next_message();
}

void test_SWR_IGTL_020_message_without_body_or_type_is_refused_at_once(void)
{
    (void)memset(&packet.bytes[2], 0, 12U);
    announce(0U);
    TEST_ASSERT_EQUAL_INT(IGTL_INBOX_REFUSED, feed(packet.bytes, IGTL_HEADER_BYTES, 58U, 0U));
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_NAME, inbox.reason);
    expect_next_message();
}

void test_SWR_IGTL_054_transform_marked_invalid_is_refused_and_the_next_message_is_read(void)
{
    static const uint32_t numbers[IGTL_TRANSFORM_NUMBERS] = {0U};
    igtl_packet_t marked;
    uint64_t crc;

    igtl_encode_transform(&packet, "TGT_1", numbers, 0U);
    igtl_packet_extend(&marked, &packet);
    (void)memcpy(&marked.bytes[marked.length - 2U], "NO", 2U);
    crc = igtl_crc64(0U, &marked.bytes[IGTL_HEADER_BYTES], marked.length - IGTL_HEADER_BYTES);
    for (uint32_t i = 0U; i < 8U; i++) {
        marked.bytes[50U + i] = (uint8_t)(crc >> (56U - (8U * i)));
    }
    TEST_ASSERT_EQUAL_INT(IGTL_INBOX_REFUSED, feed(marked.bytes, marked.length, 7U, 0U));
    TEST_ASSERT_EQUAL_INT(IGTL_MARKED_INVALID, inbox.reason);
    TEST_ASSERT_EQUAL_STRING("TGT_1", inbox.header.name);
    expect_next_message();
}

void test_SWR_IGTL_021_skipping_goes_on_while_something_arrives(void)
{
    const uint64_t step_us = LIMIT_IGTL_PARTIAL_TIMEOUT_US - 1U;

    retype("IMAGE");
    announce(100000U);
    (void)feed(packet.bytes, IGTL_HEADER_BYTES, 58U, 0U);
    for (uint64_t now_us = step_us; now_us < LIMIT_IGTL_SKIP_TIMEOUT_US; now_us += step_us) {
        TEST_ASSERT_FALSE(igtl_inbox_is_late(&inbox, now_us));
        (void)feed_zeros(100U, now_us);
    }
    TEST_ASSERT_FALSE(igtl_inbox_is_late(&inbox, LIMIT_IGTL_SKIP_TIMEOUT_US - 1U));
    TEST_ASSERT_TRUE(igtl_inbox_is_late(&inbox, LIMIT_IGTL_SKIP_TIMEOUT_US));
}

void test_SWR_IGTL_021_skipping_in_which_nothing_arrives_is_late(void)
{
    retype("IMAGE");
    announce(100000U);
    (void)feed(packet.bytes, IGTL_HEADER_BYTES, 58U, 0U);
    (void)feed_zeros(100U, 1000U);
    TEST_ASSERT_FALSE(igtl_inbox_is_late(&inbox, 1000U + LIMIT_IGTL_PARTIAL_TIMEOUT_US - 1U));
    TEST_ASSERT_TRUE(igtl_inbox_is_late(&inbox, 1000U + LIMIT_IGTL_PARTIAL_TIMEOUT_US));
}

void test_SWR_IGTL_011_garbage_breaks_the_connection(void)
{
    TEST_ASSERT_EQUAL_INT(
        IGTL_INBOX_BROKEN,
        feed((const uint8_t *)"GET / HTTP/1.1\r\nHost: robot\r\nUser-Agent: somebody else\r\n\r\n",
             58U, 58U, 0U));
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_VERSION, inbox.reason);
}

void test_SWR_IGTL_011_half_a_message_is_late_after_its_time(void)
{
    TEST_ASSERT_FALSE(igtl_inbox_is_late(&inbox, UINT64_C(1000000000)));
    (void)feed(packet.bytes, 60U, 30U, 1000U);
    TEST_ASSERT_FALSE(igtl_inbox_is_late(&inbox, 1000U + LIMIT_IGTL_PARTIAL_TIMEOUT_US - 1U));
    TEST_ASSERT_TRUE(igtl_inbox_is_late(&inbox, 1000U + LIMIT_IGTL_PARTIAL_TIMEOUT_US));
}

void test_SWR_IGTL_011_dripping_bytes_does_not_extend_the_time(void)
{
    (void)feed(packet.bytes, 1U, 1U, 0U);
    (void)feed(&packet.bytes[1], 1U, 1U, LIMIT_IGTL_PARTIAL_TIMEOUT_US - 1U);
    TEST_ASSERT_TRUE(igtl_inbox_is_late(&inbox, LIMIT_IGTL_PARTIAL_TIMEOUT_US));
}

void test_SWR_IGTL_011_whole_message_ends_the_wait(void)
{
    (void)feed(packet.bytes, packet.length, 30U, 0U);
    TEST_ASSERT_FALSE(igtl_inbox_is_late(&inbox, LIMIT_IGTL_PARTIAL_TIMEOUT_US));
}

/* The longest list of the longest robot, and a STRING behind it. */
static uint32_t long_array(uint8_t *bytes, uint32_t body_bytes)
{
    (void)memset(bytes, 0, IGTL_HEADER_BYTES + body_bytes);
    bytes[1] = 1U;
    (void)memcpy(&bytes[2], "NDARRAY", 7U);
    bytes[IGTL_HEADER_BYTES] = 10U;
    bytes[IGTL_HEADER_BYTES + 1U] = 2U;
    bytes[IGTL_HEADER_BYTES + 2U] = 0x10U;
    bytes[IGTL_HEADER_BYTES + 5U] = (uint8_t)((body_bytes - 6U) / 16384U);
    const uint64_t crc = igtl_crc64(0U, &bytes[IGTL_HEADER_BYTES], body_bytes);
    for (uint32_t i = 0U; i < 8U; i++) {
        bytes[42U + i] = (uint8_t)((uint64_t)body_bytes >> (56U - (8U * i)));
        bytes[50U + i] = (uint8_t)(crc >> (56U - (8U * i)));
    }
    return IGTL_HEADER_BYTES + body_bytes;
}

void test_SWR_IGTL_069_a_long_array_comes_whole_and_what_follows_is_read(void)
{
    static uint8_t bytes[IGTL_HEADER_BYTES + LIMIT_IGTL_ARRAY_MAX];
    static uint8_t large[LIMIT_IGTL_ARRAY_MAX];
    const uint32_t length = long_array(bytes, 6U + (4096U * 21U * 4U));

    igtl_inbox_lend(&inbox, large);
    for (uint32_t piece = 997U; piece <= length; piece += 100000U) {
        TEST_ASSERT_EQUAL_INT(IGTL_INBOX_MESSAGE, feed(bytes, length, piece, 0U));
        TEST_ASSERT_EQUAL_UINT32(4096U, inbox.message.rows);
        TEST_ASSERT_EQUAL_UINT32(21U, inbox.message.columns);
        TEST_ASSERT_EQUAL_INT(IGTL_INBOX_MESSAGE, feed(packet.bytes, packet.length, 100U, 0U));
        TEST_ASSERT_EQUAL_MEMORY("STOP", inbox.message.text, 4U);
    }
    bytes[length - 1U] ^= 1U;
    TEST_ASSERT_EQUAL_INT(IGTL_INBOX_REFUSED, feed(bytes, length, length, 0U));
    TEST_ASSERT_EQUAL_INT(IGTL_BAD_CRC, inbox.reason);
}

void test_SWR_IGTL_069_where_no_room_is_lent_a_long_array_is_refused(void)
{
    static uint8_t bytes[IGTL_HEADER_BYTES + LIMIT_IGTL_ARRAY_MAX];
    const uint32_t length = long_array(bytes, 6U + (4096U * 4U));

    TEST_ASSERT_EQUAL_INT(IGTL_INBOX_REFUSED, feed(bytes, length, 1000U, 0U));
    TEST_ASSERT_EQUAL_INT(IGTL_TOO_LONG, inbox.reason);
    TEST_ASSERT_EQUAL_INT(IGTL_INBOX_MESSAGE, feed(packet.bytes, packet.length, 100U, 0U));
}

void test_SWR_IGTL_011_random_bytes_never_leave_the_buffer(void)
{
    uint32_t seed = 1U;

    for (uint32_t round = 0U; round < 20000U; round++) {
        uint8_t bytes[200];
        uint32_t length;
        uint8_t *where;

        igtl_encode_string(&packet, "CMD_1", "TARGETING", 0U);
        length = packet.length;
        (void)memcpy(bytes, packet.bytes, length);
        for (uint32_t flips = 0U; flips < 3U; flips++) {
            seed = (seed * 1664525U) + 1013904223U;
            bytes[(seed >> 8U) % length] = (uint8_t)(seed >> 24U);
        }
        igtl_inbox_init(&inbox);
        for (uint32_t i = 0U; i < length; i++) {
            const uint32_t room = igtl_inbox_room(&inbox, &where);

            TEST_ASSERT_TRUE((room >= 1U) && (where >= inbox.buffer) &&
                             ((where + room) <= (inbox.buffer + sizeof inbox.buffer)));
            *where = bytes[i];
            if (igtl_inbox_advance(&inbox, 1U, 0U) == IGTL_INBOX_BROKEN) {
                break;
            }
        }
    }
}
