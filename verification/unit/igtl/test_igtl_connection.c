/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: a connection sends each message in one write, never waits for its peer, and
 * notices its end.
 */
#include "igtl/wire/igtl_packet.h"
#include "igtl/server/igtl_connection.h"
#include "igtl/wire/igtl_inbox.h"
#include "igtl/wire/igtl_outbox.h"
#include "unity.h"

#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

static igtl_connection_t connection;
static int peer;
static igtl_packet_t packet;
static igtl_inbox_event_t event;
static uint32_t bytes_left;

/* Message boundaries are kept: what one write sends, one read gets. */
static void connect_by(int type)
{
    int ends[2];

    TEST_ASSERT_EQUAL_INT(0, socketpair(AF_UNIX, type, 0, ends));
    igtl_connection_open(&connection, ends[0], 0U);
    peer = ends[1];
}

void setUp(void)
{
    igtl_connection_init(&connection);
    igtl_encode_string(&packet, "CMD_1", "STOP", 0U);
    peer = -1;
    bytes_left = 65536U;
}

void tearDown(void)
{
    if (connection.descriptor >= 0) {
        igtl_connection_close(&connection);
    }
    if (peer >= 0) {
        (void)close(peer);
    }
}

void test_SWR_IGTL_005_each_message_is_one_write(void)
{
    uint8_t bytes[1000];

    connect_by(SOCK_SEQPACKET);
    igtl_outbox_add(&connection.outbox, &packet);
    igtl_outbox_add(&connection.outbox, &packet);
    TEST_ASSERT_TRUE(igtl_connection_flush(&connection));
    TEST_ASSERT_EQUAL_INT(packet.length, recv(peer, bytes, sizeof bytes, 0));
    TEST_ASSERT_EQUAL_INT(packet.length, recv(peer, bytes, sizeof bytes, 0));
}

void test_SWR_IGTL_003_messages_are_read_one_by_one(void)
{
    connect_by(SOCK_STREAM);
    TEST_ASSERT_EQUAL_INT(packet.length, send(peer, packet.bytes, packet.length, 0));
    TEST_ASSERT_EQUAL_INT(packet.length, send(peer, packet.bytes, packet.length, 0));
    for (uint32_t i = 0U; i < 2U; i++) {
        TEST_ASSERT_EQUAL_INT(IGTL_RECEIVED_EVENT,
                              igtl_connection_receive(&connection, 0U, &bytes_left, &event));
        TEST_ASSERT_EQUAL_INT(IGTL_INBOX_MESSAGE, event);
    }
    TEST_ASSERT_EQUAL_INT(IGTL_RECEIVED_NOTHING,
                          igtl_connection_receive(&connection, 0U, &bytes_left, &event));
}

void test_SWR_IGTL_011_end_of_the_peer_is_noticed(void)
{
    connect_by(SOCK_STREAM);
    TEST_ASSERT_EQUAL_INT(0, close(peer));
    peer = -1;
    TEST_ASSERT_EQUAL_INT(IGTL_RECEIVED_END,
                          igtl_connection_receive(&connection, 0U, &bytes_left, &event));
    igtl_outbox_add(&connection.outbox, &packet);
    TEST_ASSERT_FALSE(igtl_connection_flush(&connection));
}

void test_SWR_IGTL_011_peer_that_does_not_read_is_given_up_without_waiting(void)
{
    bool is_served = true;
    uint32_t added = 0U;

    connect_by(SOCK_STREAM);
    while (is_served && (added < 1000000U)) {
        igtl_outbox_add(&connection.outbox, &packet);
        is_served = igtl_connection_flush(&connection);
        added++;
    }
    TEST_ASSERT_FALSE(is_served);
    TEST_ASSERT_TRUE(connection.outbox.has_overflowed);
}

void test_SWR_IGTL_011_no_more_is_read_than_its_share(void)
{
    connect_by(SOCK_STREAM);
    TEST_ASSERT_EQUAL_INT(packet.length, send(peer, packet.bytes, packet.length, 0));
    bytes_left = packet.length - 1U;
    TEST_ASSERT_EQUAL_INT(IGTL_RECEIVED_NOTHING,
                          igtl_connection_receive(&connection, 7U, &bytes_left, &event));
    TEST_ASSERT_EQUAL_UINT32(0U, bytes_left);
    TEST_ASSERT_EQUAL_UINT64(0U, connection.heard_us);
    bytes_left = 10U;
    TEST_ASSERT_EQUAL_INT(IGTL_RECEIVED_EVENT,
                          igtl_connection_receive(&connection, 7U, &bytes_left, &event));
    TEST_ASSERT_EQUAL_INT(IGTL_INBOX_MESSAGE, event);
    TEST_ASSERT_EQUAL_UINT32(9U, bytes_left);
    TEST_ASSERT_EQUAL_UINT64(7U, connection.heard_us);
}

void test_SWR_IGTL_026_message_that_is_skipped_is_heard_and_garbage_is_not(void)
{
    igtl_packet_t strange = packet;

    connect_by(SOCK_STREAM);
    (void)memcpy(&strange.bytes[2], "ANYTHING", 8U);
    TEST_ASSERT_EQUAL_INT(strange.length, send(peer, strange.bytes, strange.length, 0));
    TEST_ASSERT_EQUAL_INT(IGTL_RECEIVED_EVENT,
                          igtl_connection_receive(&connection, 7U, &bytes_left, &event));
    TEST_ASSERT_EQUAL_INT(IGTL_INBOX_SKIPPED, event);
    TEST_ASSERT_EQUAL_UINT64(7U, connection.heard_us);
    packet.bytes[packet.length - 1U] ^= 1U;
    TEST_ASSERT_EQUAL_INT(packet.length, send(peer, packet.bytes, packet.length, 0));
    TEST_ASSERT_EQUAL_INT(IGTL_RECEIVED_EVENT,
                          igtl_connection_receive(&connection, 9U, &bytes_left, &event));
    TEST_ASSERT_EQUAL_INT(IGTL_INBOX_REFUSED, event);
    TEST_ASSERT_EQUAL_UINT64(7U, connection.heard_us);
}

void test_SWR_IGTL_005_peer_of_version_2_is_answered_in_version_2(void)
{
    igtl_packet_t extended;
    uint8_t bytes[IGTL_PACKET_MAX];

    connect_by(SOCK_STREAM);
    igtl_packet_extend(&extended, &packet);
    TEST_ASSERT_EQUAL_INT(extended.length, send(peer, extended.bytes, extended.length, 0));
    igtl_outbox_add(&connection.outbox, &packet);
    TEST_ASSERT_EQUAL_INT(IGTL_RECEIVED_EVENT,
                          igtl_connection_receive(&connection, 0U, &bytes_left, &event));
    igtl_outbox_add(&connection.outbox, &packet);
    TEST_ASSERT_TRUE(igtl_connection_flush(&connection));
    TEST_ASSERT_EQUAL_INT(packet.length, recv(peer, bytes, packet.length, 0));
    TEST_ASSERT_EQUAL_MEMORY(packet.bytes, bytes, packet.length);
    TEST_ASSERT_EQUAL_INT(extended.length, recv(peer, bytes, sizeof bytes, 0));
    TEST_ASSERT_EQUAL_MEMORY(extended.bytes, bytes, extended.length);
}
