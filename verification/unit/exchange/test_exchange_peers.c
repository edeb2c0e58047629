/* SPDX-License-Identifier: Apache-2.0 */
/*
 * Rule under test: ports and peers are shown as their process wrote them or not at all, and orders
 * about them are taken once.
 */
#include "unity.h"

#include "exchange/exchange_peers.h"
#include "exchange/exchange_segment.h"

#include "unit/support/exchange_world.h"

#include <stdio.h>
#include <string.h>

void setUp(void)
{
    exchange_world_init();
}

void tearDown(void)
{
    exchange_world_end();
}

void test_SWR_IGTL_028_ports_are_read_as_they_were_published(void)
{
    exchange_ports_t ports = {.count = 1U, .ports = {{.name = "slicer", .state = 2U}}};
    exchange_ports_t read;

    TEST_ASSERT_FALSE(exchange_read_ports(reader, &read));
    exchange_publish_ports(control, &ports);
    TEST_ASSERT_TRUE(exchange_read_ports(reader, &read));
    TEST_ASSERT_EQUAL_MEMORY(&ports, &read, sizeof ports);
}

void test_SWR_IGTL_028_damaged_ports_are_not_shown(void)
{
    exchange_ports_t ports = {.count = EXCHANGE_PORTS};
    exchange_ports_t read;

    (void)memset(ports.ports[1].name, 'x', sizeof ports.ports[1].name);
    (void)memset(ports.ports[1].trouble, 'x', sizeof ports.ports[1].trouble);
    exchange_publish_ports(control, &ports);
    TEST_ASSERT_TRUE(exchange_read_ports(reader, &read));
    TEST_ASSERT_EQUAL_UINT32(EXCHANGE_PORT_NAME_SIZE - 1U, strlen(read.ports[1].name));
    TEST_ASSERT_EQUAL_UINT32(EXCHANGE_PORT_TROUBLE_SIZE - 1U, strlen(read.ports[1].trouble));
    ports.ports[3].state = EXCHANGE_PORT_STATES;
    exchange_publish_ports(control, &ports);
    TEST_ASSERT_FALSE(exchange_read_ports(reader, &read));
    ports.ports[3].state = 0U;
    ports.ports[3].dialect = EXCHANGE_DIALECTS;
    exchange_publish_ports(control, &ports);
    TEST_ASSERT_FALSE(exchange_read_ports(reader, &read));
    ports.ports[3].dialect = 0U;
    ports.count = EXCHANGE_PORTS + 1U;
    exchange_publish_ports(control, &ports);
    TEST_ASSERT_FALSE(exchange_read_ports(reader, &read));
}

static exchange_peers_t peers;
static exchange_peers_t read_peers;

static void have_one_peer(uint32_t number, const char *port, const char *peer_name)
{
    (void)memset(&peers, 0, sizeof peers);
    peers.count = 1U;
    peers.peers[0].number = number;
    (void)snprintf(peers.peers[0].port, sizeof peers.peers[0].port, "%s", port);
    (void)snprintf(peers.peers[0].name, sizeof peers.peers[0].name, "%s", peer_name);
}

void test_SWR_EXCH_016_peers_are_read_as_their_process_wrote_them(void)
{
    TEST_ASSERT_FALSE(exchange_read_peers(reader, COMMAND_SOURCE_IGTL, &read_peers));
    have_one_peer(21U, "brp", "127.0.0.1:53212");
    exchange_publish_peers(control, COMMAND_SOURCE_IGTL, &peers);
    TEST_ASSERT_TRUE(exchange_read_peers(reader, COMMAND_SOURCE_IGTL, &read_peers));
    TEST_ASSERT_EQUAL_MEMORY(&peers, &read_peers, sizeof peers);
    TEST_ASSERT_FALSE(exchange_read_peers(reader, COMMAND_SOURCE_HTTP, &read_peers));
}

static void check_damaged(uint32_t *number, uint32_t value)
{
    const uint32_t good = *number;

    *number = value;
    exchange_publish_peers(control, COMMAND_SOURCE_HTTP, &peers);
    TEST_ASSERT_FALSE(exchange_read_peers(reader, COMMAND_SOURCE_HTTP, &read_peers));
    *number = good;
}

void test_SWR_EXCH_016_damaged_peers_are_not_shown(void)
{
    have_one_peer(1U, "", "anna");
    check_damaged(&peers.count, EXCHANGE_PEERS + 1U);
    check_damaged(&peers.peers[47].dialect, EXCHANGE_DIALECTS);
    check_damaged(&peers.peers[47].is_waiting, 2U);
    check_damaged(&peers.peers[47].is_kept_alive, 2U);
    (void)memset(peers.peers[0].name, 'x', sizeof peers.peers[0].name);
    (void)memset(peers.peers[0].port, 'x', sizeof peers.peers[0].port);
    (void)memset(peers.peers[0].message, 'x', sizeof peers.peers[0].message);
    exchange_publish_peers(control, COMMAND_SOURCE_HTTP, &peers);
    TEST_ASSERT_TRUE(exchange_read_peers(reader, COMMAND_SOURCE_HTTP, &read_peers));
    TEST_ASSERT_EQUAL_UINT32(EXCHANGE_PEER_NAME_SIZE - 1U, strlen(read_peers.peers[0].name));
    TEST_ASSERT_EQUAL_UINT32(EXCHANGE_PORT_NAME_SIZE - 1U, strlen(read_peers.peers[0].port));
    TEST_ASSERT_EQUAL_UINT32(EXCHANGE_PEER_MESSAGE_SIZE - 1U, strlen(read_peers.peers[0].message));
}

void test_SWR_EXCH_016_peers_that_were_half_written_are_not_shown(void)
{
    have_one_peer(1U, "", "anna");
    exchange_publish_peers(control, COMMAND_SOURCE_HTTP, &peers);
    control->segment->others.peers[COMMAND_SOURCE_HTTP].seal.sequence++;
    TEST_ASSERT_FALSE(exchange_read_peers(reader, COMMAND_SOURCE_HTTP, &read_peers));
}

void test_SWR_EXCH_018_an_order_is_taken_once_and_its_answer_comes_back(void)
{
    const exchange_order_t order = {.kind = 1U, .number = 21U, .is_on = 1U};
    exchange_order_t taken;
    status_t status = STATUS_BUSY;

    TEST_ASSERT_FALSE(exchange_take_order(reader, &taken));
    const uint32_t first = exchange_give_order(control, &order);
    TEST_ASSERT_FALSE(exchange_read_order_answer(control, first, &status));
    TEST_ASSERT_TRUE(exchange_take_order(reader, &taken));
    TEST_ASSERT_EQUAL_UINT32(1U, taken.kind);
    TEST_ASSERT_EQUAL_UINT32(21U, taken.number);
    TEST_ASSERT_EQUAL_UINT32(1U, taken.is_on);
    exchange_answer_order(reader, &taken, STATUS_OK);
    TEST_ASSERT_FALSE(exchange_take_order(reader, &taken));
    TEST_ASSERT_TRUE(exchange_read_order_answer(control, first, &status));
    TEST_ASSERT_EQUAL_INT(STATUS_OK, status);
    const uint32_t second = exchange_give_order(control, &order);
    TEST_ASSERT_FALSE(exchange_read_order_answer(control, second, &status));
    TEST_ASSERT_TRUE(exchange_take_order(reader, &taken));
    TEST_ASSERT_EQUAL_UINT32(second, taken.id);
}

void test_SWR_EXCH_018_a_newer_order_is_answered_by_itself(void)
{
    const exchange_order_t order = {.number = 21U};
    exchange_order_t taken;
    status_t status;

    (void)exchange_give_order(control, &order);
    TEST_ASSERT_TRUE(exchange_take_order(reader, &taken));
    const uint32_t second = exchange_give_order(control, &order);
    exchange_answer_order(reader, &taken, STATUS_OK);
    TEST_ASSERT_FALSE(exchange_read_order_answer(control, second, &status));
    TEST_ASSERT_TRUE(exchange_take_order(reader, &taken));
}

void test_SWR_EXCH_018_a_damaged_order_is_not_taken(void)
{
    exchange_order_t order = {.kind = 2U};
    exchange_order_t taken;

    (void)exchange_give_order(control, &order);
    TEST_ASSERT_FALSE(exchange_take_order(reader, &taken));
    order = (exchange_order_t){.is_on = 2U};
    (void)exchange_give_order(control, &order);
    TEST_ASSERT_FALSE(exchange_take_order(reader, &taken));
}

static void check_title(const char *expected, command_source_t source, uint32_t number)
{
    char title[EXCHANGE_TITLE_SIZE];

    exchange_title(reader, source, number, title);
    TEST_ASSERT_EQUAL_STRING(expected, title);
}

void test_SWR_EXCH_017_a_peer_is_called_by_its_port_and_address_or_its_account(void)
{
    have_one_peer(21U, "brp", "127.0.0.1:53212");
    exchange_publish_peers(control, COMMAND_SOURCE_IGTL, &peers);
    have_one_peer(4000000000U, "", "anna");
    exchange_publish_peers(control, COMMAND_SOURCE_HTTP, &peers);
    check_title("brp 127.0.0.1:53212", COMMAND_SOURCE_IGTL, 21U);
    check_title("page of anna", COMMAND_SOURCE_HTTP, 4000000000U);
}

void test_SWR_EXCH_017_who_is_not_in_the_table_is_called_by_its_number(void)
{
    check_title("connection 21", COMMAND_SOURCE_IGTL, 21U);
    have_one_peer(31U, "brp", "127.0.0.1:53212");
    exchange_publish_peers(control, COMMAND_SOURCE_IGTL, &peers);
    check_title("connection 21", COMMAND_SOURCE_IGTL, 21U);
    check_title("page 7", COMMAND_SOURCE_HTTP, 7U);
}
