/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: no connection keeps the server from the others, by what it sends, by sending
 * nothing or by taking nothing.
 */
#include "base/fixed.h"
#include "base/rigid.h"
#include "igtl/dialect/igtl_units.h"
#include "igtl/wire/igtl_codec.h"
#include "igtl/wire/igtl_crc64.h"
#include "igtl/wire/igtl_packet.h"
#include "igtl/server/igtl_caller.h"
#include "igtl/server/igtl_connection.h"
#include "igtl/server/igtl_listener.h"
#include "igtl/server/igtl_slots.h"
#include "igtl/server/igtl_ports.h"
#include "igtl/server/igtl_ports_values.h"
#include "igtl/server/igtl_show.h"
#include "igtl/server/igtl_troubles.h"
#include "igtl/dialect/igtl_dialect.h"
#include "igtl/wire/igtl_inbox.h"
#include "igtl/dialect/igtl_requests.h"
#include "exchange/exchange.h"
#include "exchange/exchange_peers.h"
#include "exchange/exchange_segment.h"
#include "igtl/wire/igtl_outbox.h"
#include "igtl/server/igtl_server.h"
#include "interface/app/names.h"
#include "interface/snapshot.h"
#include "limits/requirement_limits.h"
#include "robot/robot.h"
#include "unity.h"

#include <arpa/inet.h>
#include <errno.h>
#include <linux/sockios.h>
#include <netinet/in.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#define CONTROLLING 2U
#define ORDERING 5U
#define CLIENTS (IGTL_CONNECTIONS + 1U)

static igtl_server_t server;
static igtl_port_t settings;
static igtl_moment_t moment;
static uint32_t messages[IGTL_PEERS];
static uint32_t numbers[IGTL_PEERS];
static uint32_t seated;
static bool is_connected[IGTL_PEERS];
static bool has_orders;
static igtl_outbox_t *outboxes[IGTL_PEERS];
static int clients[CLIENTS];
static uint16_t port;
static char error[200];

static void connected(void *dialect, uint32_t peer, const igtl_introduction_t *introduction)
{
    (void)dialect;
    numbers[peer] = introduction->number;
    outboxes[peer] = introduction->outbox;
    is_connected[peer] = true;
    seated++;
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

static bool has_order(const void *dialect, uint32_t peer)
{
    (void)dialect;
    return has_orders && (peer == ORDERING);
}

static bool is_stop(const igtl_message_t *message)
{
    return (message->text_bytes == 4U) && (memcmp(message->text, "STOP", 4U) == 0);
}

static const igtl_dialect_calls_t calls = {connected,        disconnected, receive,
                                           is_controlled_by, has_order,    is_stop};

static uint64_t troubles(igtl_trouble_t kind)
{
    return server.troubles.counts[kind].count;
}

static void open_port(void)
{
    struct sockaddr_in place;
    socklen_t size = (socklen_t)sizeof place;

    TEST_ASSERT_TRUE_MESSAGE(igtl_server_open(&server, &settings, error, sizeof error), error);
    TEST_ASSERT_EQUAL_INT(0, getsockname(server.listener, (struct sockaddr *)&place, &size));
    port = ntohs(place.sin_port);
}

void setUp(void)
{
    (void)memset(messages, 0, sizeof messages);
    (void)memset(is_connected, 0, sizeof is_connected);
    seated = 0U;
    has_orders = false;
    moment = (igtl_moment_t){.now_us = 1000000U, .answer_clock_us = 1000000U};
    settings = (igtl_port_t){.name = "test", .address = INADDR_LOOPBACK, .entry_prefix = "ENTRY_"};
    server.calls = &calls;
    server.next_number = 11U;
    open_port();
    for (uint32_t i = 0U; i < CLIENTS; i++) {
        clients[i] = -1;
    }
}

void tearDown(void)
{
    igtl_server_close(&server);
    for (uint32_t i = 0U; i < CLIENTS; i++) {
        if (clients[i] >= 0) {
            (void)close(clients[i]);
        }
    }
}

/* A client that the server has looked at. Its machine takes little for it. */
static void enter(uint32_t client)
{
    const int least = 1;
    struct sockaddr_in place = {.sin_family = AF_INET, .sin_port = htons(port)};

    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    clients[client] = socket(AF_INET, SOCK_STREAM, 0);
    TEST_ASSERT_EQUAL_INT(
        0, setsockopt(clients[client], SOL_SOCKET, SO_RCVBUF, &least, (socklen_t)sizeof least));
    TEST_ASSERT_EQUAL_INT(
        0, connect(clients[client], (const struct sockaddr *)&place, (socklen_t)sizeof place));
    igtl_server_receive(&server, &moment);
}

static void leave(uint32_t client)
{
    TEST_ASSERT_EQUAL_INT(0, close(clients[client]));
    clients[client] = -1;
    igtl_server_receive(&server, &moment);
}

/* The server has closed its end. */
static bool is_dropped(uint32_t client)
{
    uint8_t byte;
    const ssize_t count = recv(clients[client], &byte, 1U, MSG_DONTWAIT | MSG_PEEK);

    return count == 0;
}

static void send_packet(uint32_t client, const igtl_packet_t *packet)
{
    TEST_ASSERT_EQUAL_INT(packet->length,
                          send(clients[client], packet->bytes, packet->length, MSG_NOSIGNAL));
}

static void say(uint32_t client)
{
    igtl_packet_t packet;

    igtl_encode_string(&packet, "CMD_1", "STOP", 0U);
    send_packet(client, &packet);
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

/* One after the other, a second apart. */
static void fill(void)
{
    for (uint32_t i = 0U; i < IGTL_PEERS; i++) {
        enter(i);
        moment.now_us += 1000000U;
    }
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

/* The first four of a port's row. */
static void shows(exchange_port_state_t state, uint32_t peers, uint32_t waiting, uint32_t again_ms)
{
    exchange_port_t row;

    igtl_show_port(&server, moment.now_us, &row);
    TEST_ASSERT_EQUAL_UINT32(state, row.state);
    TEST_ASSERT_EQUAL_UINT32(peers, row.peers);
    TEST_ASSERT_EQUAL_UINT32(waiting, row.waiting);
    TEST_ASSERT_EQUAL_UINT32(again_ms, row.again_ms);
}

void test_SWR_IGTL_028_row_of_a_port_that_listens(void)
{
    exchange_port_t row;

    shows(EXCHANGE_PORT_LISTENING, 0U, 0U, 0U);
    fill();
    enter(IGTL_PEERS);
    shows(EXCHANGE_PORT_LISTENING, IGTL_PEERS, 1U, 0U);
    igtl_show_port(&server, moment.now_us, &row);
    TEST_ASSERT_EQUAL_STRING("test", row.name);
    TEST_ASSERT_EQUAL_HEX32(0x7F000001U, row.address);
    TEST_ASSERT_EQUAL_UINT32(1U, row.troubles);
    TEST_ASSERT_EQUAL_STRING("has no place for a connection: all are taken", row.trouble);
}

static const exchange_peer_t *row_of(uint32_t connection)
{
    static exchange_peer_t row;

    igtl_show_peer(&server, &server.connections[connection], &row);
    return &row;
}

static void send_damaged(uint32_t client)
{
    igtl_packet_t packet;

    igtl_encode_string(&packet, "CMD_1", "STOP", 0U);
    packet.bytes[packet.length - 1U] ^= 1U;
    send_packet(client, &packet);
}

void test_SWR_IGTL_056_row_of_a_connection_says_who_it_is_and_what_it_sent(void)
{
    struct sockaddr_in place;
    socklen_t size = (socklen_t)sizeof place;
    char name[IGTL_PLACE_SIZE];

    enter(0U);
    TEST_ASSERT_EQUAL_INT(0, getsockname(clients[0], (struct sockaddr *)&place, &size));
    igtl_port_place(INADDR_LOOPBACK, ntohs(place.sin_port), name);
    TEST_ASSERT_EQUAL_STRING(name, row_of(0U)->name);
    TEST_ASSERT_EQUAL_STRING("test", row_of(0U)->port);
    TEST_ASSERT_EQUAL_UINT32(11U, row_of(0U)->number);
    TEST_ASSERT_EQUAL_UINT64(1000000U, row_of(0U)->since_us);
    TEST_ASSERT_EQUAL_UINT64(0U, row_of(0U)->heard_us);
    TEST_ASSERT_EQUAL_STRING("", row_of(0U)->message);
    TEST_ASSERT_EQUAL_UINT32(1U, row_of(0U)->is_kept_alive);
    moment.now_us += 5U;
    say(0U);
    send_damaged(0U);
    igtl_server_receive(&server, &moment);
    igtl_server_send(&server, &moment);
    TEST_ASSERT_EQUAL_UINT64(1000005U, row_of(0U)->heard_us);
    TEST_ASSERT_EQUAL_STRING("CMD_1", row_of(0U)->message);
    TEST_ASSERT_EQUAL_UINT64(1U, row_of(0U)->messages_in);
    TEST_ASSERT_EQUAL_UINT64(2U * (58U + 8U), row_of(0U)->bytes_in);
    TEST_ASSERT_EQUAL_UINT32(1U, row_of(0U)->errors);
    TEST_ASSERT_EQUAL_UINT64(1U, row_of(0U)->messages_out); /* Why it was refused. */
    TEST_ASSERT_EQUAL_UINT64(server.connections[0].sent, row_of(0U)->bytes_out);
    TEST_ASSERT_TRUE(row_of(0U)->bytes_out > 58U);
}

static void send_status(uint32_t client, const char *error_name, const char *told)
{
    const igtl_status_t status = {1U, error_name, told};
    igtl_packet_t packet;

    igtl_encode_status(&packet, "IMAGER", &status, 0U);
    send_packet(client, &packet);
    igtl_server_receive(&server, &moment);
}

void test_SWR_IGTL_092_the_last_status_of_a_client_is_shown_with_the_count_of_its_changes(void)
{
    enter(0U);
    TEST_ASSERT_EQUAL_STRING("", row_of(0U)->status);
    send_status(0U, "OK", "Valid Target");
    send_status(0U, "OK", "Valid Target");
    TEST_ASSERT_EQUAL_STRING("IMAGER 1 OK Valid Target", row_of(0U)->status);
    TEST_ASSERT_EQUAL_UINT32(1U, row_of(0U)->statuses);
    send_status(0U, "", "Scan\n");
    TEST_ASSERT_EQUAL_STRING("IMAGER 1 Scan?", row_of(0U)->status);
    TEST_ASSERT_EQUAL_UINT32(2U, row_of(0U)->statuses);
}

void test_SWR_IGTL_092_a_long_status_is_cut(void)
{
    char told[IGTL_TEXT_MAX + 1U] = "";

    enter(0U);
    (void)memset(told, 'x', sizeof told - 1U);
    send_status(0U, "OK", told);
    TEST_ASSERT_EQUAL_size_t(EXCHANGE_PEER_STATUS_SIZE - 1U, strlen(row_of(0U)->status));
}

void test_SWR_IGTL_093_the_last_refusal_is_kept_with_the_number_of_its_changes(void)
{
    enter(0U);
    TEST_ASSERT_EQUAL_STRING("", row_of(0U)->refusal);
    send_damaged(0U);
    igtl_server_receive(&server, &moment);
    send_damaged(0U);
    igtl_server_receive(&server, &moment);
    TEST_ASSERT_EQUAL_STRING_LEN("CMD_", row_of(0U)->refusal, 4U);
    TEST_ASSERT_EQUAL_UINT32(1U, row_of(0U)->refusals);
}

void test_SWR_IGTL_093_what_the_dialect_refuses_of_a_message_is_kept(void)
{
    enter(0U);
    igtl_outbox_note_refusal(&server.connections[0].outbox, "STREAM", "NOT_HOMED");
    say(0U);
    igtl_server_receive(&server, &moment);
    TEST_ASSERT_EQUAL_STRING("", row_of(0U)->refusal);
    igtl_outbox_note_refusal(&server.connections[0].outbox, "PRO\nBE",
                             "WRONG_UNIT: Give the unit.");
    igtl_connection_keep_refusal(&server.connections[0]);
    TEST_ASSERT_EQUAL_STRING("PRO?BE WRONG_UNIT: Give the unit.", row_of(0U)->refusal);
    TEST_ASSERT_EQUAL_UINT32(1U, row_of(0U)->refusals);
}

void test_SWR_IGTL_056_a_connection_that_waits_says_so(void)
{
    fill();
    enter(IGTL_PEERS);
    TEST_ASSERT_EQUAL_UINT32(0U, row_of(0U)->is_waiting);
    TEST_ASSERT_EQUAL_UINT32(1U, row_of(IGTL_PEERS)->is_waiting);
}

void test_SWR_IGTL_056_the_table_has_all_connections_that_are_there(void)
{
    static exchange_peers_t read;
    char name[32];
    exchange_t *exchange;

    (void)snprintf(name, sizeof name, "test-server-%d", (int)getpid());
    exchange = exchange_create(name, 64U, error, sizeof error);
    TEST_ASSERT_NOT_NULL_MESSAGE(exchange, error);
    fill();
    enter(IGTL_PEERS);
    leave(0U);
    igtl_show_peers(exchange, &server, 1U);
    TEST_ASSERT_TRUE(exchange_read_peers(exchange, COMMAND_SOURCE_IGTL, &read));
    TEST_ASSERT_EQUAL_UINT32(IGTL_PEERS, read.count);
    TEST_ASSERT_EQUAL_UINT32(21U, read.peers[0].number);
    exchange_close(exchange);
}

static bool is_asked_if_alive(uint32_t connection)
{
    int value = 0;
    socklen_t size = (socklen_t)sizeof value;

    (void)getsockopt(server.connections[connection].descriptor, SOL_SOCKET, SO_KEEPALIVE, &value,
                     &size);
    return value != 0;
}

static status_t obey(exchange_order_kind_t kind, uint32_t client, uint32_t is_on)
{
    const exchange_order_t order = {
        .kind = (uint32_t)kind, .number = 11U + (client * IGTL_NUMBER_STEP), .is_on = is_on};

    return igtl_server_obey(&server, &order, moment.now_us);
}

void test_SWR_IGTL_057_keep_alive_is_switched_by_order(void)
{
    enter(0U);
    enter(1U);
    TEST_ASSERT_TRUE(is_asked_if_alive(1U));
    TEST_ASSERT_EQUAL_INT(STATUS_OK, obey(EXCHANGE_ORDER_KEEP_ALIVE, 1U, 0U));
    TEST_ASSERT_FALSE(is_asked_if_alive(1U));
    TEST_ASSERT_EQUAL_UINT32(0U, row_of(1U)->is_kept_alive);
    TEST_ASSERT_TRUE(is_asked_if_alive(0U));
    TEST_ASSERT_EQUAL_INT(STATUS_OK, obey(EXCHANGE_ORDER_KEEP_ALIVE, 1U, 1U));
    TEST_ASSERT_TRUE(is_asked_if_alive(1U));
    TEST_ASSERT_FALSE(is_dropped(1U));
}

void test_SWR_IGTL_058_a_connection_is_ended_by_order(void)
{
    enter(0U);
    enter(1U);
    TEST_ASSERT_EQUAL_INT(STATUS_OK, obey(EXCHANGE_ORDER_DISCONNECT, 1U, 0U));
    TEST_ASSERT_TRUE(is_dropped(1U));
    TEST_ASSERT_FALSE(is_connected[1]);
    TEST_ASSERT_FALSE(is_dropped(0U));
    TEST_ASSERT_EQUAL_INT(STATUS_UNKNOWN_COMMAND, obey(EXCHANGE_ORDER_DISCONNECT, 1U, 0U));
    TEST_ASSERT_EQUAL_INT(STATUS_UNKNOWN_COMMAND, obey(EXCHANGE_ORDER_KEEP_ALIVE, 7U, 0U));
}

void test_SWR_IGTL_058_one_that_has_authority_is_not_ended(void)
{
    for (uint32_t i = 0U; i <= CONTROLLING; i++) {
        enter(i);
    }
    TEST_ASSERT_EQUAL_INT(STATUS_HOLDS_AUTHORITY, obey(EXCHANGE_ORDER_DISCONNECT, CONTROLLING, 0U));
    TEST_ASSERT_FALSE(is_dropped(CONTROLLING));
}

/* From here on the server calls a port of this test. */
static int begin_calling(void)
{
    struct sockaddr_in place;
    socklen_t size = (socklen_t)sizeof place;
    const int slicer = igtl_listener_open(INADDR_LOOPBACK, 0U, error, sizeof error);

    TEST_ASSERT_EQUAL_INT(0, getsockname(slicer, (struct sockaddr *)&place, &size));
    igtl_server_close(&server);
    settings.is_calling = true;
    settings.number = ntohs(place.sin_port);
    TEST_ASSERT_TRUE(igtl_server_open(&server, &settings, error, sizeof error));
    return slicer;
}

/* Calls, and looks what has come of it. */
static void call(void)
{
    igtl_server_receive(&server, &moment);
    igtl_server_receive(&server, &moment);
}

void test_SWR_IGTL_025_peer_that_answers_a_call_is_like_any_other(void)
{
    const int slicer = begin_calling();
    uint32_t address;
    uint16_t number;

    igtl_server_receive(&server, &moment);
    clients[0] = igtl_listener_accept(slicer, &address, &number);
    igtl_server_receive(&server, &moment);
    TEST_ASSERT_EQUAL_UINT32(1U, seated);
    TEST_ASSERT_EQUAL_UINT32(0U, messages[0]);
    shows(EXCHANGE_PORT_CONNECTED, 1U, 0U, 0U);
    say(0U);
    igtl_server_receive(&server, &moment);
    TEST_ASSERT_EQUAL_UINT32(1U, messages[0]);
    leave(0U);
    TEST_ASSERT_FALSE(is_connected[0]);
    shows(EXCHANGE_PORT_WAITING, 0U, 0U, 1000U);
    moment.now_us += LIMIT_IGTL_CALL_LEAST_US;
    igtl_server_receive(&server, &moment);
    clients[0] = igtl_listener_accept(slicer, &address, &number);
    TEST_ASSERT_GREATER_OR_EQUAL_INT(0, clients[0]);
    TEST_ASSERT_EQUAL_INT(0, close(slicer));
}

void test_SWR_IGTL_025_pause_between_vain_calls_doubles_up_to_its_limit(void)
{
    uint64_t pause_us = LIMIT_IGTL_CALL_LEAST_US;

    TEST_ASSERT_EQUAL_INT(0, close(begin_calling()));
    for (uint32_t i = 0U; i < 10U; i++) {
        call();
        TEST_ASSERT_EQUAL_UINT64(i + 1U, troubles(IGTL_TROUBLE_CALL));
        shows(EXCHANGE_PORT_WAITING, 0U, 0U, (uint32_t)(pause_us / 1000U));
        moment.now_us += pause_us - 1U;
        call();
        TEST_ASSERT_EQUAL_UINT64(i + 1U, troubles(IGTL_TROUBLE_CALL));
        moment.now_us += 1U;
        pause_us =
            ((2U * pause_us) < LIMIT_IGTL_CALL_MOST_US) ? (2U * pause_us) : LIMIT_IGTL_CALL_MOST_US;
    }
    TEST_ASSERT_EQUAL_STRING("called in vain: Connection refused", server.troubles.last);
}

void test_SWR_IGTL_025_call_that_nobody_answers_ends(void)
{
    const int slicer = begin_calling();
    igtl_caller_t *caller = &server.caller;
    igtl_caller_t others[3];
    int descriptor;

    /* Its queue is full: no more calls get through. */
    TEST_ASSERT_EQUAL_INT(0, listen(slicer, 0));
    for (uint32_t i = 0U; i < 3U; i++) {
        igtl_caller_init(&others[i], INADDR_LOOPBACK, settings.number);
        (void)igtl_caller_step(&others[i], 0U, &descriptor);
    }
    TEST_ASSERT_EQUAL_INT(IGTL_CALL_NOTHING, igtl_caller_step(caller, 0U, &descriptor));
    TEST_ASSERT_EQUAL_INT(IGTL_CALL_NOTHING,
                          igtl_caller_step(caller, IGTL_CALL_TIMEOUT_US - 1U, &descriptor));
    shows(EXCHANGE_PORT_CALLING, 0U, 0U, 0U);
    TEST_ASSERT_EQUAL_INT(IGTL_CALL_FAILED,
                          igtl_caller_step(caller, IGTL_CALL_TIMEOUT_US, &descriptor));
    TEST_ASSERT_EQUAL_INT(ETIMEDOUT, caller->error);
    for (uint32_t i = 0U; i < 3U; i++) {
        igtl_caller_close(&others[i]);
    }
    TEST_ASSERT_EQUAL_INT(0, close(slicer));
}

void test_SWR_IGTL_025_connection_that_lasted_sets_the_pause_back(void)
{
    igtl_caller_t caller = {.descriptor = -1,
                            .pause_us = LIMIT_IGTL_CALL_MOST_US,
                            .since_us = 5U,
                            .is_connected = true};

    igtl_caller_lost(&caller, false, 5U + LIMIT_IGTL_CALL_MOST_US);
    TEST_ASSERT_EQUAL_UINT64(5U + (2U * LIMIT_IGTL_CALL_MOST_US), caller.next_us);
    igtl_caller_lost(&caller, false, 6U + LIMIT_IGTL_CALL_MOST_US);
    TEST_ASSERT_EQUAL_UINT64(6U + LIMIT_IGTL_CALL_MOST_US + LIMIT_IGTL_CALL_LEAST_US,
                             caller.next_us);
}

/* Answers the call that is due, and hangs up, with a message before or without. */
static void hang_up_at_once(int slicer, bool is_heard)
{
    uint32_t address;
    uint16_t number;

    igtl_server_receive(&server, &moment);
    clients[0] = igtl_listener_accept(slicer, &address, &number);
    TEST_ASSERT_GREATER_OR_EQUAL_INT(0, clients[0]);
    igtl_server_receive(&server, &moment);
    if (is_heard) {
        say(0U);
        igtl_server_receive(&server, &moment);
    }
    leave(0U);
}

void test_SWR_IGTL_025_peer_that_said_something_is_called_after_the_first_pause(void)
{
    const int slicer = begin_calling();

    server.caller.pause_us = LIMIT_IGTL_CALL_MOST_US;
    for (uint32_t i = 0U; i < 3U; i++) {
        hang_up_at_once(slicer, true);
        shows(EXCHANGE_PORT_WAITING, 0U, 0U, LIMIT_IGTL_CALL_LEAST_US / 1000U);
        moment.now_us += LIMIT_IGTL_CALL_LEAST_US;
    }
    TEST_ASSERT_EQUAL_INT(0, close(slicer));
}

void test_SWR_IGTL_025_peer_that_hangs_up_without_a_message_was_called_in_vain(void)
{
    const int slicer = begin_calling();

    for (uint32_t i = 0U; i < 3U; i++) {
        const uint32_t pause_us = (uint32_t)LIMIT_IGTL_CALL_LEAST_US << i;

        hang_up_at_once(slicer, false);
        shows(EXCHANGE_PORT_WAITING, 0U, 0U, pause_us / 1000U);
        moment.now_us += pause_us;
    }
    TEST_ASSERT_EQUAL_INT(0, close(slicer));
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
