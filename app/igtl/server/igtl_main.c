/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The OpenIGTLink process: workphase protocol on some ports, bare transforms on others. One dialect
 * serves all ports that speak it, so one peer commands, whichever it came by. Waits for sockets,
 * passes commands to the controller and its answers back. It has no part in motion: it may end at
 * any time.
 */
#include "base/contract.h"
#include "common/clock.h"
#include "common/command_line.h"
#include "exchange/exchange.h"
#include "igtl/server/igtl_options.h"
#include "igtl/server/igtl_relay.h"
#include "igtl/server/igtl_server.h"
#include "igtl/server/igtl_show.h"
#include "igtl/server/igtl_timeout_clock.h"
#include "igtl/dialect/transform_dialect.h"
#include "igtl/workphase/workphase_dialect.h"
#include "igtl/workphase/workphase_receive.h"

#include <errno.h>
#include <poll.h>
#include <signal.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define EXIT_CANNOT_START 3
#define IDLE_WAIT_MS 50 /* No peer is connected. */
#define CONNECTED_WAIT_MS 10
#define ANSWER_WAIT_MS 1 /* A command is on its way. */
#define CONTROL_SILENT_US UINT64_C(1000000)
#define SHOW_US UINT64_C(100000)
#define ERROR_SIZE 400U

typedef struct {
    exchange_t *exchange;
    workphase_dialect_t workphase;
    transform_dialect_t transform;
    igtl_server_t servers[IGTL_PORTS];
    uint32_t count; /* Number of servers. */
    uint64_t next_show_us;
    uint32_t numbers; /**< Sum of the next numbers of connections when they were shown last. */
    snapshot_t snapshot;
    igtl_moment_t moment;
    char holder[EXCHANGE_TITLE_SIZE];
    igtl_timeout_clock_t timeouts;
    uint32_t control_beats;
    uint64_t control_seen_us;
    bool is_control_silent;
} process_t;

static process_t process;
static volatile sig_atomic_t must_end;

void contract_broken(const char *module, uint32_t id)
{
    (void)fprintf(stderr, "boresight-igtl: contract %s/%u is broken\n", module, (unsigned)id);
    abort();
}

static void on_end(int signal_number)
{
    (void)signal_number;
    must_end = 1;
}

static const igtl_dialect_calls_t workphase_calls = {
    workphase_dialect_connected,        workphase_dialect_disconnected, workphase_dialect_receive,
    workphase_dialect_is_controlled_by, workphase_dialect_has_order,    workphase_receive_is_stop};
static const igtl_dialect_calls_t transform_calls = {transform_dialect_connected,
                                                     transform_dialect_disconnected,
                                                     transform_dialect_receive,
                                                     NULL,
                                                     NULL,
                                                     NULL};

static uint64_t timestamp_now(void)
{
    struct timespec now;

    (void)clock_gettime(CLOCK_REALTIME, &now);
    return ((uint64_t)now.tv_sec << 32U) | (((uint64_t)now.tv_nsec << 32U) / 1000000000U);
}

static bool answer_workphase(const answer_t *answer)
{
    return workphase_dialect_answer(&process.workphase, answer, &process.moment);
}

static bool answer_transform(const answer_t *answer)
{
    return transform_dialect_answer(&process.transform, answer, &process.moment);
}

static void pass_commands(void)
{
    const uint32_t workphase = process.snapshot.workphase;

    igtl_relay_requests(process.exchange, &process.workphase.requests, workphase, answer_workphase);
    igtl_relay_requests(process.exchange, &process.transform.requests, workphase, answer_transform);
}

static void advance_timeouts(uint64_t elapsed_us)
{
    loop_figures_t loop;
    const uint32_t slowness = exchange_read_loop(process.exchange, &loop) ? loop.slowness : 1U;

    igtl_timeout_clock_step(&process.timeouts, elapsed_us, slowness,
                            exchange_beats(process.exchange, EXCHANGE_CONTROL),
                            process.is_control_silent);
    process.moment.answer_clock_us = igtl_timeout_clock_us(&process.timeouts);
}

static void look_who_commands(void)
{
    const snapshot_t *shown = process.moment.snapshot;

    process.moment.holder = NULL;
    if ((shown != NULL) && (shown->holder_peer != 0U)) {
        exchange_title(process.exchange, (command_source_t)shown->holder, shown->holder_peer,
                       process.holder);
        process.moment.holder = process.holder;
    }
}

/* The last snapshot of a silent controller is not true any more. */
static void look_around(void)
{
    const uint64_t before_us = process.moment.now_us;
    snapshot_t fresh;

    process.moment.now_us = clock_monotonic_us();
    advance_timeouts(process.moment.now_us - before_us);
    process.moment.timestamp = timestamp_now();
    if (exchange_read_snapshot(process.exchange, &fresh)) {
        process.snapshot = fresh;
        process.moment.snapshot = process.is_control_silent ? NULL : &process.snapshot;
    }
    look_who_commands();
}

static void take_answers(void)
{
    answer_t answer;

    while (exchange_take_answer(process.exchange, COMMAND_SOURCE_IGTL, &answer)) {
        look_around(); /* A snapshot that is not older than the answer. */
        if (!answer_workphase(&answer)) {
            (void)answer_transform(&answer);
        }
    }
}

static void watch_control(void)
{
    const uint32_t beats = exchange_beats(process.exchange, EXCHANGE_CONTROL);
    const uint64_t listened_us = igtl_timeout_clock_listened_us(&process.timeouts);

    if (beats != process.control_beats) {
        process.control_beats = beats;
        process.control_seen_us = listened_us;
        process.is_control_silent = false;
    } else if ((listened_us - process.control_seen_us) >= CONTROL_SILENT_US) {
        workphase_dialect_control_lost(&process.workphase, &process.moment);
        process.control_seen_us = listened_us;
        process.is_control_silent = true;
    } else {
        /* It may be a little late. */
    }
}

static int wait_ms(void)
{
    if (igtl_relay_awaits_answer(&process.workphase.requests) ||
        igtl_relay_awaits_answer(&process.transform.requests)) {
        return ANSWER_WAIT_MS;
    }
    for (uint32_t i = 0U; i < process.count; i++) {
        if (igtl_server_has_peers(&process.servers[i])) {
            return CONNECTED_WAIT_MS;
        }
    }
    return IDLE_WAIT_MS;
}

static void wait_for_news(void)
{
    struct pollfd polls[IGTL_PORTS * IGTL_SERVER_POLLS];
    uint32_t count = 0U;

    for (uint32_t i = 0U; i < process.count; i++) {
        count += igtl_server_polls(&process.servers[i], &polls[count]);
    }
    (void)poll(polls, count, wait_ms());
}

static void send_all(void)
{
    for (uint32_t i = 0U; i < process.count; i++) {
        igtl_server_send(&process.servers[i], &process.moment);
    }
}

static void show(void)
{
    if (process.moment.now_us >= process.next_show_us) {
        process.next_show_us = process.moment.now_us + SHOW_US;
        igtl_show_ports(process.exchange, process.servers, process.count, process.moment.now_us);
        igtl_show_peers(process.exchange, process.servers, process.count);
    }
}

/* A new connection is in the table before its first message is read. */
static void show_newcomers(void)
{
    uint32_t numbers = 0U;

    for (uint32_t i = 0U; i < process.count; i++) {
        numbers += process.servers[i].next_number;
    }
    if (numbers != process.numbers) {
        process.numbers = numbers;
        process.next_show_us = 0U;
        show();
    }
}

/* Orders of the operator for a connection. Its number contains its port. */
static void obey_orders(void)
{
    exchange_order_t order;

    while (exchange_take_order(process.exchange, &order)) {
        const uint32_t port = order.number % IGTL_NUMBER_STEP;
        status_t status = STATUS_UNKNOWN_COMMAND;

        if ((port > 0U) && (port <= process.count)) {
            status = igtl_server_obey(&process.servers[port - 1U], &order, process.moment.now_us);
        }
        process.next_show_us = 0U;
        show(); /* The client that gets the answer looks at the rows. */
        exchange_answer_order(process.exchange, &order, status);
    }
}

static void turn(void)
{
    wait_for_news();
    look_around();
    for (uint32_t i = 0U; i < process.count; i++) {
        igtl_server_receive(&process.servers[i], &process.moment);
    }
    send_all(); /* Acknowledgements do not wait for control. */
    show_newcomers();
    pass_commands();
    take_answers();
    watch_control();
    obey_orders();
    workphase_dialect_step(&process.workphase, &process.moment);
    transform_dialect_step(&process.transform, &process.moment);
    send_all();
    show();
    exchange_beat(process.exchange, EXCHANGE_IGTL);
}

static void explain(const igtl_options_t *options, uint32_t index, const char *error)
{
    static const char *const variables[] = {"BRP_PORT", "IGTL_PORT"};
    const unsigned number = options->ports.ports[index].number;

    if (errno != EADDRINUSE) {
        (void)fprintf(stderr, "igtl: %s\n", error);
    } else if (options->file != NULL) {
        (void)fprintf(stderr,
                      "igtl: port %u is in use; stop the other program or change it in %s.\n",
                      number, options->file);
    } else {
        (void)fprintf(stderr, "igtl: port %u is in use; stop the other program or set %s.\n",
                      number, variables[index]);
    }
}

/* The last digit of a connection's number is the place of its port. */
static bool open_ports(const igtl_options_t *options)
{
    char error[ERROR_SIZE];

    for (uint32_t i = 0U; i < options->ports.count; i++) {
        const igtl_port_t *port = &options->ports.ports[i];
        const bool is_crtk = port->language == IGTL_LANGUAGE_CRTK;
        igtl_server_t *server = &process.servers[i];

        server->calls = is_crtk ? &transform_calls : &workphase_calls;
        server->dialect = is_crtk ? (void *)&process.transform : (void *)&process.workphase;
        server->first_place = i * IGTL_PEERS;
        server->next_number = IGTL_NUMBER_STEP + i + 1U;
        if (!igtl_server_open(server, port, error, sizeof error)) {
            explain(options, i, error);
            return false;
        }
        process.count++;
    }
    return true;
}

/* Ids go on where no earlier run of this process can have left an answer behind. */
static void begin(void)
{
    const uint32_t first_id = ((uint32_t)clock_utc_us() | 2U) & ~1U;
    const robot_t *robot = exchange_robot(process.exchange);
    answer_t stale;
    exchange_order_t old;

    workphase_dialect_init(&process.workphase, robot, first_id);
    transform_dialect_init(&process.transform, robot, first_id + 1U);
    while (exchange_take_answer(process.exchange, COMMAND_SOURCE_IGTL, &stale)) {
        /* Answers to an earlier run. */
    }
    while (exchange_take_order(process.exchange, &old)) {
        exchange_answer_order(process.exchange, &old,
                              STATUS_NO_ANSWER); /* Its connection has gone. */
    }
}

static void catch_signals(void)
{
    struct sigaction action = {.sa_handler = on_end};

    (void)sigaction(SIGTERM, &action, NULL);
    (void)sigaction(SIGINT, &action, NULL);
}

int main(int count, char **arguments)
{
    static igtl_options_t options;
    char error[ERROR_SIZE];

    const int code = igtl_options_read(&options, count, arguments);
    if (code != COMMAND_LINE_GO_ON) {
        return code;
    }
    process.exchange = exchange_open(options.instance, error, sizeof error);
    if (process.exchange == NULL) {
        (void)fprintf(stderr, "igtl: %s\n", error);
        return EXIT_CANNOT_START;
    }
    exchange_protect(process.exchange, EXCHANGE_IGTL);
    begin();
    if (!open_ports(&options)) {
        return EXIT_CANNOT_START;
    }
    catch_signals();
    while (must_end == 0) {
        turn();
    }
    for (uint32_t i = 0U; i < process.count; i++) {
        igtl_server_close(&process.servers[i]);
    }
    exchange_close(process.exchange);
    return EXIT_SUCCESS;
}
