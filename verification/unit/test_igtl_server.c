/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: no connection keeps the server from the others, by what it sends or by sending
 * nothing.
 */
#include "base/fixed.h"
#include "base/rigid.h"
#include "dialect/igtl_border.h"
#include "message/igtl_codec.h"
#include "message/igtl_crc64.h"
#include "message/igtl_packet.h"
#include "igtl/igtl_connection.h"
#include "dialect/igtl_dialect.h"
#include "message/igtl_inbox.h"
#include "dialect/igtl_requests.h"
#include "message/igtl_outbox.h"
#include "igtl/igtl_server.h"
#include "interface/app/names.h"
#include "interface/snapshot.h"
#include "limits/requirement_limits.h"
#include "robot/robot.h"
#include "unity.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#define CONTROLLING 2U

static igtl_server_t server;
static igtl_moment_t moment;
static uint32_t messages[IGTL_PEERS];
static uint32_t numbers[IGTL_PEERS];
static bool is_connected[IGTL_PEERS];
static int clients[IGTL_PEERS + 1U];
static uint16_t port;

static void connected(void *dialect, uint32_t peer, const igtl_introduction_t *introduction)
{
    (void)dialect;
    numbers[peer] = introduction->number;
    is_connected[peer] = true;
}

static void disconnected(void *dialect, uint32_t peer)
{
    (void)dialect;
    is_connected[peer] = false;
}

static void receive(void *dialect, uint32_t peer, const igtl_message_t *message,
                    const igtl_moment_t *now)
{
    (void)dialect;
    (void)message;
    (void)now;
    messages[peer]++;
}

static bool is_controlled_by(const void *dialect, uint32_t peer)
{
    (void)dialect;
    return peer == CONTROLLING;
}

static const igtl_dialect_calls_t calls = {connected, disconnected, receive, is_controlled_by};

void setUp(void)
{
    struct sockaddr_in place;
    socklen_t size = (socklen_t)sizeof place;
    char error[200];

    (void)memset(messages, 0, sizeof messages);
    (void)memset(is_connected, 0, sizeof is_connected);
    moment = (igtl_moment_t){.now_us = 1000000U};
    server.calls = &calls;
    server.next_number = 1U;
    TEST_ASSERT_TRUE(igtl_server_open(&server, "127.0.0.1", 0U, error, sizeof error));
    TEST_ASSERT_EQUAL_INT(0, getsockname(server.listener, (struct sockaddr *)&place, &size));
    port = ntohs(place.sin_port);
    for (uint32_t i = 0U; i <= IGTL_PEERS; i++) {
        clients[i] = -1;
    }
}

void tearDown(void)
{
    igtl_server_close(&server);
    for (uint32_t i = 0U; i <= IGTL_PEERS; i++) {
        if (clients[i] >= 0) {
            (void)close(clients[i]);
        }
    }
}

/* A client that the server has looked at. */
static void enter(uint32_t client)
{
    struct sockaddr_in place = {.sin_family = AF_INET, .sin_port = htons(port)};

    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    clients[client] = socket(AF_INET, SOCK_STREAM, 0);
    TEST_ASSERT_EQUAL_INT(
        0, connect(clients[client], (const struct sockaddr *)&place, (socklen_t)sizeof place));
    igtl_server_receive(&server, &moment);
}

static void say(uint32_t client)
{
    igtl_packet_t packet;

    igtl_encode_string(&packet, "CMD_1", "STOP", 0U);
    TEST_ASSERT_EQUAL_INT(packet.length,
                          send(clients[client], packet.bytes, packet.length, MSG_NOSIGNAL));
}

/* One after the other, a second apart. */
static void fill(void)
{
    for (uint32_t i = 0U; i < IGTL_PEERS; i++) {
        enter(i);
        moment.now_us += 1000000U;
    }
}

void test_SWR_IGTL_011_silent_connections_make_room_for_a_new_one(void)
{
    fill();
    moment.now_us += IGTL_SILENT_US;
    say(0U);
    igtl_server_receive(&server, &moment);
    enter(IGTL_PEERS);
    TEST_ASSERT_EQUAL_UINT64(1U, server.troubles[IGTL_TROUBLE_SILENT].count);
    TEST_ASSERT_EQUAL_UINT64(0U, server.troubles[IGTL_TROUBLE_FULL].count);
    TEST_ASSERT_EQUAL_UINT64(moment.now_us, server.connections[1].heard_us); /* The new one. */
}

void test_SWR_IGTL_011_connection_is_refused_when_nobody_has_been_silent_for_long(void)
{
    fill();
    enter(IGTL_PEERS);
    TEST_ASSERT_EQUAL_UINT64(0U, server.troubles[IGTL_TROUBLE_SILENT].count);
    TEST_ASSERT_EQUAL_UINT64(1U, server.troubles[IGTL_TROUBLE_FULL].count);
}

void test_SWR_IGTL_011_controlling_peer_keeps_its_place(void)
{
    fill();
    moment.now_us += IGTL_SILENT_US;
    for (uint32_t i = 0U; i < IGTL_PEERS; i++) {
        if (i != CONTROLLING) {
            say(i);
        }
    }
    igtl_server_receive(&server, &moment);
    enter(IGTL_PEERS);
    TEST_ASSERT_TRUE(is_connected[CONTROLLING]);
    TEST_ASSERT_EQUAL_UINT64(1U, server.troubles[IGTL_TROUBLE_FULL].count);
}

void test_SWR_IGTL_004_long_unknown_body_leaves_the_others_their_turn(void)
{
    static uint8_t image[IGTL_HEADER_BYTES + (3U * IGTL_BYTES_PER_TURN)] = {0U,  1U,  'I', 'M',
                                                                            'A', 'G', 'E'};
    ssize_t sent;

    image[46] = (uint8_t)(LIMIT_IGTL_SKIP_MAX >> 24U);
    enter(0U);
    enter(1U);
    sent = send(clients[0], image, sizeof image, MSG_DONTWAIT | MSG_NOSIGNAL);
    TEST_ASSERT_GREATER_THAN_INT((int)IGTL_BYTES_PER_TURN, (int)sent);
    say(1U);
    igtl_server_receive(&server, &moment);
    TEST_ASSERT_EQUAL_UINT64(IGTL_BYTES_PER_TURN - IGTL_HEADER_BYTES,
                             server.connections[0].inbox.passed);
    TEST_ASSERT_EQUAL_UINT32(1U, messages[1]);
    igtl_server_receive(&server, &moment);
    TEST_ASSERT_GREATER_THAN_UINT64(IGTL_BYTES_PER_TURN, server.connections[0].inbox.passed);
}

void test_SWR_EVENT_005_no_connection_gets_the_number_of_another(void)
{
    fill();
    moment.now_us += IGTL_SILENT_US;
    for (uint32_t i = 0U; i < IGTL_PEERS; i++) {
        TEST_ASSERT_EQUAL_UINT32(1U + (i * IGTL_NUMBER_STEP), numbers[i]);
    }
    enter(IGTL_PEERS);
    TEST_ASSERT_EQUAL_UINT32(1U + (IGTL_PEERS * IGTL_NUMBER_STEP), numbers[0]);
}
