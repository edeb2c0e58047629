/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: the server shows each port and connection, obeys orders on connections, and
 * calls a peer with pauses that double up to a limit.
 */
#include "igtl/wire/igtl_codec.h"
#include "igtl/server/igtl_server.h"
#include "unity.h"
#include "igtl/server/igtl_caller.h"
#include "igtl/server/igtl_connection.h"
#include "igtl/server/igtl_listener.h"
#include "igtl/server/igtl_ports.h"
#include "igtl/server/igtl_show.h"
#include "exchange/exchange.h"
#include "exchange/exchange_peers.h"
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

static void send_status(uint32_t client, const char *error_name, const char *reported)
{
    const igtl_status_t status = {1U, error_name, reported};
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
    char reported[IGTL_TEXT_MAX + 1U] = "";

    enter(0U);
    (void)memset(reported, 'x', sizeof reported - 1U);
    send_status(0U, "OK", reported);
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
