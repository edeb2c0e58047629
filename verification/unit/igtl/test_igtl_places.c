/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: a connection keeps its place while it speaks, commands or has an order; a silent
 * or hung one leaves its place to a connection that waits.
 */
#include "igtl/wire/igtl_codec.h"
#include "igtl/server/igtl_server.h"
#include "unity.h"
#include "igtl/server/igtl_connection.h"
#include "limits/requirement_limits.h"
#include "unit/support/igtl_server_world.inc"

void setUp(void)
{
    begin_server();
}

void tearDown(void)
{
    end_server();
}

static void ask(uint32_t client)
{
    igtl_packet_t packet;

    igtl_encode_string(&packet, "CMD_1", "CURRENT_STATUS", 0U);
    send_packet(client, &packet);
}

/* Messages that Slicer sends when it connects. */
static void announce(uint32_t client)
{
    static const igtl_status_t nothing = {0U, "", ""};
    igtl_packet_t packet;

    igtl_encode_status(&packet, "", &nothing, 0U);
    send_packet(client, &packet);
}

void test_SWR_IGTL_026_silent_connections_leave_each_other_their_places(void)
{
    fill();
    moment.now_us += 10U * LIMIT_IGTL_SILENT_US;
    enter(IGTL_PEERS);
    announce(IGTL_PEERS);
    for (uint32_t i = 0U; i < 100U; i++) {
        moment.now_us += LIMIT_IGTL_SILENT_US;
        igtl_server_receive(&server, &moment);
    }
    TEST_ASSERT_EQUAL_UINT32(IGTL_PEERS, seated);
    for (uint32_t i = 0U; i <= IGTL_PEERS; i++) {
        TEST_ASSERT_FALSE(is_dropped(i));
    }
}

void test_SWR_IGTL_026_connection_that_speaks_gets_the_place_of_the_longest_silent(void)
{
    fill();
    enter(IGTL_PEERS);
    enter(IGTL_PEERS + 1U);
    moment.now_us += LIMIT_IGTL_SILENT_US;
    say(0U);
    say(IGTL_PEERS + 1U);
    igtl_server_receive(&server, &moment);
    TEST_ASSERT_TRUE(is_dropped(1U));
    TEST_ASSERT_FALSE(is_dropped(IGTL_PEERS));
    TEST_ASSERT_EQUAL_UINT32(11U + ((IGTL_PEERS + 1U) * IGTL_NUMBER_STEP), numbers[1]);
    TEST_ASSERT_EQUAL_UINT32(1U, messages[1]);
    TEST_ASSERT_EQUAL_UINT64(1U, troubles(IGTL_TROUBLE_SILENT));
}

void test_SWR_IGTL_026_waiting_connection_gets_a_place_that_becomes_free(void)
{
    fill();
    enter(IGTL_PEERS);
    enter(IGTL_PEERS + 1U);
    TEST_ASSERT_EQUAL_UINT32(IGTL_PEERS, seated);
    leave(3U);
    TEST_ASSERT_EQUAL_UINT32(11U + (IGTL_PEERS * IGTL_NUMBER_STEP), numbers[3]);
    leave(4U);
    TEST_ASSERT_EQUAL_UINT32(11U + ((IGTL_PEERS + 1U) * IGTL_NUMBER_STEP), numbers[4]);
}

void test_SWR_IGTL_026_nobody_who_has_spoken_lately_loses_its_place(void)
{
    uint8_t bytes[1000];

    fill();
    enter(IGTL_PEERS);
    moment.now_us += LIMIT_IGTL_SILENT_US;
    for (uint32_t i = 0U; i < IGTL_PEERS; i++) {
        say(i);
    }
    ask(IGTL_PEERS);
    igtl_server_receive(&server, &moment);
    igtl_server_send(&server, &moment);
    TEST_ASSERT_EQUAL_UINT32(IGTL_PEERS, seated);
    TEST_ASSERT_GREATER_THAN_INT(0, recv(clients[IGTL_PEERS], bytes, sizeof bytes, 0));
    TEST_ASSERT_EQUAL_STRING("STATUS", (const char *)&bytes[2]);
    TEST_ASSERT_EQUAL_STRING("CMD_1", (const char *)&bytes[14]);
    TEST_ASSERT_EQUAL_UINT8(IGTL_STATUS_BUSY, bytes[IGTL_HEADER_BYTES + 1U]);
    TEST_ASSERT_EQUAL_UINT64(0U, troubles(IGTL_TROUBLE_SILENT));
}

void test_SWR_IGTL_026_silence_as_long_as_the_limit_costs_no_place(void)
{
    fill();
    enter(IGTL_PEERS);
    for (uint32_t i = 0U; i < IGTL_PEERS; i++) {
        say(i);
    }
    igtl_server_receive(&server, &moment);
    moment.now_us += LIMIT_IGTL_SILENT_US;
    ask(IGTL_PEERS);
    igtl_server_receive(&server, &moment);
    TEST_ASSERT_EQUAL_UINT64(0U, troubles(IGTL_TROUBLE_SILENT));
    moment.now_us++;
    ask(IGTL_PEERS);
    igtl_server_receive(&server, &moment);
    TEST_ASSERT_EQUAL_UINT64(1U, troubles(IGTL_TROUBLE_SILENT));
}

void test_SWR_IGTL_026_a_stop_waits_for_nobodys_silence(void)
{
    fill();
    enter(IGTL_PEERS);
    for (uint32_t i = 0U; i < IGTL_PEERS; i++) {
        ask(i);
        igtl_server_receive(&server, &moment);
        moment.now_us++;
    }
    say(IGTL_PEERS);
    igtl_server_receive(&server, &moment);
    TEST_ASSERT_TRUE(is_dropped(0U));
    TEST_ASSERT_EQUAL_UINT32(2U, messages[0]);
    TEST_ASSERT_TRUE(is_connected[CONTROLLING]);
}

void test_SWR_IGTL_026_who_commands_or_has_an_order_keeps_its_place(void)
{
    fill();
    enter(IGTL_PEERS);
    has_orders = true;
    moment.now_us += LIMIT_IGTL_SILENT_US;
    for (uint32_t i = 0U; i < IGTL_PEERS; i++) {
        if ((i != CONTROLLING) && (i != ORDERING)) {
            say(i);
        }
    }
    igtl_server_receive(&server, &moment);
    ask(IGTL_PEERS);
    igtl_server_receive(&server, &moment);
    TEST_ASSERT_TRUE(is_connected[CONTROLLING]);
    TEST_ASSERT_TRUE(is_connected[ORDERING]);
    TEST_ASSERT_EQUAL_UINT32(IGTL_PEERS, seated);
    has_orders = false;
    ask(IGTL_PEERS);
    igtl_server_receive(&server, &moment);
    TEST_ASSERT_TRUE(is_dropped(ORDERING));
}

void test_SWR_IGTL_026_of_too_many_that_wait_the_oldest_goes(void)
{
    fill();
    for (uint32_t i = IGTL_PEERS; i < CLIENTS; i++) {
        enter(i);
    }
    TEST_ASSERT_TRUE(is_dropped(IGTL_PEERS));
    for (uint32_t i = IGTL_PEERS + 1U; i < CLIENTS; i++) {
        TEST_ASSERT_FALSE(is_dropped(i));
    }
    TEST_ASSERT_EQUAL_UINT32(IGTL_PEERS, seated);
}

void test_SWR_IGTL_011_waiting_connection_that_sends_garbage_is_dropped(void)
{
    static const uint8_t garbage[200];

    fill();
    enter(IGTL_PEERS);
    TEST_ASSERT_EQUAL_INT(sizeof garbage, send(clients[IGTL_PEERS], garbage, sizeof garbage, 0));
    igtl_server_receive(&server, &moment);
    TEST_ASSERT_EQUAL_UINT64(1U, troubles(IGTL_TROUBLE_BROKEN));
    TEST_ASSERT_EQUAL_UINT32(IGTL_PEERS, seated);
}

void test_SWR_IGTL_024_who_is_not_allowed_is_closed_at_once(void)
{
    igtl_server_close(&server);
    settings.allowed[0] = (igtl_network_t){0x0A000000U, 0xFF000000U};
    settings.allowed_count = 1U;
    open_port();
    enter(0U);
    TEST_ASSERT_TRUE(is_dropped(0U));
    TEST_ASSERT_EQUAL_UINT32(0U, seated);
    TEST_ASSERT_EQUAL_UINT64(1U, troubles(IGTL_TROUBLE_STRANGER));
    settings.allowed[0] = (igtl_network_t){INADDR_LOOPBACK, 0xFFFFFFFFU};
    enter(1U);
    TEST_ASSERT_EQUAL_UINT32(1U, seated);
}

static void add_packets(void)
{
    igtl_packet_t packet;

    igtl_encode_string(&packet, "CURRENT_POSITION", "1", 0U);
    for (uint32_t i = 0U; i < IGTL_OUTBOX_PACKETS; i++) {
        igtl_outbox_add(outboxes[ORDERING], &packet);
    }
    igtl_server_send(&server, &moment);
    TEST_ASSERT_TRUE(is_connected[ORDERING]);
    TEST_ASSERT_EQUAL_UINT32(0U, outboxes[ORDERING]->count);
}

/* Peer ORDERING does not read, and its machine has no room for all that it is sent. */
static void stuff(void)
{
    fill();
    for (uint32_t round = 0U; round < 3U; round++) {
        add_packets();
    }
}

static int queued_bytes(void)
{
    int queued = 0;

    TEST_ASSERT_EQUAL_INT(0, ioctl(server.connections[ORDERING].descriptor, SIOCOUTQ, &queued));
    return queued;
}

/* Reads until its machine has acknowledged more, which may take a moment. */
static void read_some(void)
{
    const int before = queued_bytes();
    uint8_t bytes[100];

    while (queued_bytes() == before) {
        (void)recv(clients[ORDERING], bytes, sizeof bytes, MSG_DONTWAIT);
    }
}

static void unstuff(void)
{
    while (queued_bytes() > 0) {
        read_some();
    }
}

void test_SWR_IGTL_027_hung_client_is_dropped_while_its_order_runs(void)
{
    const igtl_connection_t *connection = &server.connections[ORDERING];
    uint64_t moved_us = 0U;

    stuff();
    has_orders = true;
    moment.now_us += LIMIT_IGTL_UNREAD_US;
    moment.answer_clock_us += LIMIT_IGTL_UNREAD_US;
    igtl_server_send(&server, &moment); /* Watched from here on. */
    while (is_connected[ORDERING]) {    /* Its machine may find room for a little more. */
        moved_us = connection->moved_us;
        TEST_ASSERT_LESS_THAN_UINT64(LIMIT_IGTL_UNREAD_US, moment.answer_clock_us - moved_us);
        moment.answer_clock_us += LIMIT_IGTL_UNREAD_US / 2U;
        igtl_server_send(&server, &moment);
    }
    TEST_ASSERT_EQUAL_UINT64(LIMIT_IGTL_UNREAD_US, moment.answer_clock_us - moved_us);
    TEST_ASSERT_EQUAL_UINT64(1U, troubles(IGTL_TROUBLE_HUNG));
}

void test_SWR_IGTL_027_hung_client_without_an_order_is_left_alone(void)
{
    stuff();
    has_orders = true;
    igtl_server_send(&server, &moment);
    has_orders = false;
    moment.answer_clock_us += LIMIT_IGTL_UNREAD_US;
    igtl_server_send(&server, &moment);
    has_orders = true;
    igtl_server_send(&server, &moment);
    TEST_ASSERT_TRUE(is_connected[ORDERING]);
}

void test_SWR_IGTL_027_slow_client_keeps_its_order(void)
{
    stuff();
    has_orders = true;
    for (uint32_t i = 0U; i < 10U; i++) {
        add_packets();
        TEST_ASSERT_GREATER_THAN_INT(0, queued_bytes());
        moment.answer_clock_us += LIMIT_IGTL_UNREAD_US - 1U;
        read_some();
    }
}

void test_SWR_IGTL_027_client_that_has_read_all_keeps_its_order(void)
{
    stuff();
    has_orders = true;
    igtl_server_send(&server, &moment);
    moment.answer_clock_us += LIMIT_IGTL_UNREAD_US - 1U;
    unstuff();
    for (uint32_t i = 0U; i < 10U; i++) {
        igtl_server_send(&server, &moment);
        TEST_ASSERT_TRUE(is_connected[ORDERING]);
        moment.answer_clock_us += LIMIT_IGTL_UNREAD_US;
    }
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
    for (uint32_t i = 0U; i < IGTL_PEERS; i++) {
        TEST_ASSERT_EQUAL_UINT32(11U + (i * IGTL_NUMBER_STEP), numbers[i]);
    }
    leave(0U);
    enter(IGTL_PEERS);
    TEST_ASSERT_EQUAL_UINT32(11U + (IGTL_PEERS * IGTL_NUMBER_STEP), numbers[0]);
}
