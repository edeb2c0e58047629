/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Fifteen clients of the OpenIGTLink server that ask as fast as they are answered: seven and a
 * commander on the port of workphases, seven on that of bare transforms.
 *
 *     bench-clients BRP_PORT IGTL_PORT PHASE SECONDS
 *
 * The commander commands PHASE; once its order is armed "armed" is printed, and a line on the
 * standard input (the pedal is pressed, axes move) lets all begin. A round of a client is a pose
 * and a status by a name that was never used before, so that every answer is known for its
 * question. At last the commander says STOP; what was asked, answered and how long it took is one
 * line of JSON, times in us. Exits 1 with a sentence when an answer stays out.
 */
#include "base/contract.h"
#include "igtl/wire/igtl_codec.h"
#include "igtl/wire/igtl_inbox.h"
#include "igtl/wire/igtl_packet.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <time.h>
#include <unistd.h>

#define POLLERS 7U
#define CLIENTS ((2U * POLLERS) + 1U)
#define COMMANDER (CLIENTS - 1U)
#define COMMAND_PAUSE_US UINT64_C(20000)
#define ANSWER_CLOCK_US UINT64_C(60000000)
#define BUCKETS 1000000U /* Buckets of 1 us; the last holds all above. */

typedef struct {
    int descriptor;
    const char *pose; /* The pose that it asks for. */
    igtl_inbox_t inbox;
    char awaited[IGTL_NAME_SIZE]; /* Empty: nothing. */
    uint64_t asked_us;
    uint32_t poses; /* Heard since it asked. */
} client_t;

static client_t clients[CLIENTS];
static uint32_t histogram[BUCKETS];
static struct {
    uint32_t numbers; /* Count of names. */
    uint32_t questions;
    uint32_t answers;
    uint32_t commands;
    uint32_t acknowledgements;
    uint64_t worst_us;
    uint64_t worst_ack_us;
    uint64_t stop_ack_us;
    uint64_t stop_us;
} counts;

void contract_broken(const char *module, uint32_t id)
{
    (void)fprintf(stderr, "contract %s/%u is broken\n", module, (unsigned)id);
    abort();
}

static void fail(const char *says)
{
    (void)fprintf(stderr, "bench-clients: %s\n", says);
    exit(1);
}

static uint64_t now_us(void)
{
    struct timespec now;

    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return ((uint64_t)now.tv_sec * 1000000U) + ((uint64_t)now.tv_nsec / 1000U);
}

static void open_client(client_t *self, uint16_t port, const char *pose)
{
    struct sockaddr_in place = {.sin_family = AF_INET, .sin_port = htons(port)};
    const int on = 1;

    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    self->pose = pose;
    igtl_inbox_init(&self->inbox);
    self->descriptor = socket(AF_INET, SOCK_STREAM, 0);
    if ((self->descriptor < 0) || (connect(self->descriptor, (const struct sockaddr *)&place,
                                           (socklen_t)sizeof place) != 0)) {
        fail("a client cannot connect");
    }
    (void)setsockopt(self->descriptor, IPPROTO_TCP, TCP_NODELAY, &on, (socklen_t)sizeof on);
}

static void send_packets(const client_t *self, const igtl_packet_t *packets, uint32_t count)
{
    uint8_t bytes[2U * IGTL_PACKET_MAX];
    size_t length = 0U;

    for (uint32_t i = 0U; i < count; i++) {
        (void)memcpy(&bytes[length], packets[i].bytes, packets[i].length);
        length += packets[i].length;
    }
    if (send(self->descriptor, bytes, length, MSG_NOSIGNAL) != (ssize_t)length) {
        fail("a client was cut off");
    }
}

static void ask(client_t *self)
{
    igtl_packet_t questions[2];

    (void)snprintf(self->awaited, sizeof self->awaited, "ASKED_%u", (unsigned)counts.numbers);
    counts.numbers++;
    igtl_encode_empty(&questions[0], "GET_TRANS", self->pose, 0U);
    igtl_encode_empty(&questions[1], "GET_STATUS", self->awaited, 0U);
    self->poses = 0U;
    self->asked_us = now_us();
    counts.questions += 2U;
    send_packets(self, questions, 2U);
}

static void command(client_t *self, const char *text)
{
    igtl_packet_t packet;
    char name[IGTL_NAME_SIZE];

    (void)snprintf(name, sizeof name, "CMD_%u", (unsigned)counts.numbers);
    (void)snprintf(self->awaited, sizeof self->awaited, "ACK_%u", (unsigned)counts.numbers);
    counts.numbers++;
    igtl_encode_string(&packet, name, text, 0U);
    self->asked_us = now_us();
    counts.commands++;
    send_packets(self, &packet, 1U);
}

/* The message, NULL while none is whole. */
static const igtl_message_t *next_message(client_t *self, int flags)
{
    for (;;) {
        uint8_t *where;
        const uint32_t room = igtl_inbox_room(&self->inbox, &where);
        const ssize_t count = recv(self->descriptor, where, room, flags);
        igtl_inbox_event_t event;

        if (count == 0) {
            fail("a client was dropped");
        }
        if (count < 0) {
            return NULL;
        }
        event = igtl_inbox_advance(&self->inbox, (uint32_t)count, now_us());
        if (event == IGTL_INBOX_MESSAGE) {
            return &self->inbox.message;
        }
        if ((event == IGTL_INBOX_REFUSED) || (event == IGTL_INBOX_BROKEN)) {
            fail("a message cannot be read");
        }
    }
}

static void note(uint64_t took_us)
{
    histogram[(took_us < BUCKETS) ? took_us : (BUCKETS - 1U)]++;
    counts.worst_us = (took_us > counts.worst_us) ? took_us : counts.worst_us;
}

/* True when its round is complete. */
static bool take_answer(client_t *self, const igtl_message_t *message)
{
    if (strcmp(message->name, self->pose) == 0) {
        self->poses++;
    }
    if ((message->kind != IGTL_KIND_STATUS) || (strcmp(message->name, self->awaited) != 0)) {
        return false;
    }
    if (self->poses == 0U) {
        fail("a question for a pose was not answered");
    }
    counts.answers += 2U;
    self->awaited[0] = '\0';
    note(now_us() - self->asked_us);
    return true;
}

static void hear_client(client_t *self, bool goes_on)
{
    for (const igtl_message_t *message = next_message(self, MSG_DONTWAIT); message != NULL;
         message = next_message(self, MSG_DONTWAIT)) {
        if (take_answer(self, message) && goes_on) {
            ask(self);
        }
    }
}

static void hear_commander(client_t *self)
{
    for (const igtl_message_t *message = next_message(self, MSG_DONTWAIT); message != NULL;
         message = next_message(self, MSG_DONTWAIT)) {
        if ((self->awaited[0] != '\0') && (strcmp(message->name, self->awaited) == 0)) {
            const uint64_t took_us = now_us() - self->asked_us;

            counts.acknowledgements++;
            counts.worst_ack_us = (took_us > counts.worst_ack_us) ? took_us : counts.worst_ack_us;
            self->awaited[0] = '\0';
        }
    }
}

static bool is_awaited(void)
{
    for (uint32_t i = 0U; i < CLIENTS; i++) {
        if (clients[i].awaited[0] != '\0') {
            return true;
        }
    }
    return false;
}

static void turn(bool goes_on)
{
    struct pollfd polls[CLIENTS];

    for (uint32_t i = 0U; i < CLIENTS; i++) {
        polls[i] = (struct pollfd){.fd = clients[i].descriptor, .events = POLLIN};
    }
    (void)poll(polls, CLIENTS, 1);
    for (uint32_t i = 0U; i < COMMANDER; i++) {
        if (polls[i].revents != 0) {
            hear_client(&clients[i], goes_on);
        }
    }
    if (polls[COMMANDER].revents != 0) {
        hear_commander(&clients[COMMANDER]);
    }
}

static void play(uint64_t duration_us)
{
    const uint64_t end_us = now_us() + duration_us;
    client_t *commander = &clients[COMMANDER];

    for (uint32_t i = 0U; i < COMMANDER; i++) {
        ask(&clients[i]);
    }
    while (now_us() < end_us) {
        turn(true);
        if ((commander->awaited[0] == '\0') &&
            (now_us() >= (commander->asked_us + COMMAND_PAUSE_US))) {
            command(commander, "CURRENT_STATUS");
        }
    }
}

/* Waits for STATUS(`name`); in the meantime all others are heard. */
static uint64_t await_status(const char *name)
{
    client_t *self = &clients[COMMANDER];
    const uint64_t deadline_us = now_us() + ANSWER_CLOCK_US;

    while (now_us() < deadline_us) {
        const igtl_message_t *message = next_message(self, MSG_DONTWAIT);

        if (message == NULL) {
            for (uint32_t i = 0U; i < COMMANDER; i++) {
                hear_client(&clients[i], self->awaited[0] != '\0');
            }
        } else if (strcmp(message->name, self->awaited) == 0) {
            counts.acknowledgements++;
            counts.stop_ack_us = now_us() - self->asked_us;
            self->awaited[0] = '\0';
        } else if ((message->kind == IGTL_KIND_STATUS) && (strcmp(message->name, name) == 0)) {
            if (message->code != (uint32_t)IGTL_STATUS_OK) {
                fail("the commander was refused");
            }
            return now_us() - self->asked_us;
        } else {
            /* The message is another one. */
        }
    }
    fail("the commander was not answered");
    return 0U;
}

static uint32_t quantile(uint32_t share_permille)
{
    uint64_t all = 0U;
    uint64_t seen = 0U;
    uint32_t at = 0U;

    for (uint32_t i = 0U; i < BUCKETS; i++) {
        all += histogram[i];
    }
    while ((at < (BUCKETS - 1U)) && (((seen + histogram[at]) * 1000U) < (all * share_permille))) {
        seen += histogram[at];
        at++;
    }
    return at;
}

static void finish(void)
{
    const uint64_t deadline_us = now_us() + ANSWER_CLOCK_US;

    while (is_awaited()) {
        if (now_us() >= deadline_us) {
            fail("a question was not answered");
        }
        turn(false);
    }
}

int main(int count, char **arguments)
{
    char line[16];

    if (count != 5) {
        fail("usage: bench-clients BRP_PORT IGTL_PORT PHASE SECONDS");
    }
    for (uint32_t i = 0U; i < CLIENTS; i++) {
        const bool is_planner = (i >= POLLERS) && (i < COMMANDER);

        open_client(&clients[i], (uint16_t)atoi(arguments[is_planner ? 2 : 1]),
                    is_planner ? "measured_cp" : "CURRENT_POSITION");
    }
    command(&clients[COMMANDER], arguments[3]);
    (void)await_status("CURRENT_STATUS");
    (void)printf("armed\n");
    (void)fflush(stdout);
    if (fgets(line, sizeof line, stdin) == NULL) {
        fail("nobody said that it may begin");
    }
    play((uint64_t)(atof(arguments[4]) * 1e6));
    finish();
    command(&clients[COMMANDER], "STOP");
    for (uint32_t i = 0U; i < COMMANDER; i++) {
        ask(&clients[i]);
    }
    counts.stop_us = await_status("STOP");
    finish();
    (void)printf(
        "{\"questions\": %u, \"answers\": %u, \"p50_us\": %u, \"p99_us\": %u, \"worst_us\": %u, "
        "\"commands\": %u, \"acknowledgements\": %u, \"worst_ack_us\": %u, "
        "\"stop_ack_us\": %u, \"stop_us\": %u}\n",
        counts.questions, counts.answers, quantile(500U), quantile(990U), (unsigned)counts.worst_us,
        counts.commands, counts.acknowledgements, (unsigned)counts.worst_ack_us,
        (unsigned)counts.stop_ack_us, (unsigned)counts.stop_us);
    return 0;
}
