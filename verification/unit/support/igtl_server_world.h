/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The OpenIGTLink server in a test, with clients on sockets and a dialect that records its calls.
 */
#ifndef BORESIGHT_IGTL_SERVER_WORLD_H
#define BORESIGHT_IGTL_SERVER_WORLD_H

#include "igtl/wire/igtl_codec.h"
#include "igtl/wire/igtl_packet.h"
#include "igtl/server/igtl_troubles.h"
#include "igtl/dialect/igtl_dialect.h"
#include "igtl/wire/igtl_outbox.h"
#include "igtl/server/igtl_server.h"
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

static void begin_server(void)
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

static void end_server(void)
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

/* One after the other, a second apart. */
static void fill(void)
{
    for (uint32_t i = 0U; i < IGTL_PEERS; i++) {
        enter(i);
        moment.now_us += 1000000U;
    }
}

#endif
