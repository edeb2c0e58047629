/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The OpenIGTLink process: workphase protocol on one port, bare transforms on another. Waits for
 * sockets, passes commands to the controller and its answers back. It has no part in motion: it may
 * end at any time.
 */
#include "base/contract.h"
#include "common/clock.h"
#include "exchange/exchange.h"
#include "igtl/igtl_server.h"
#include "dialect/transform_dialect.h"
#include "dialect/workphase_dialect.h"

#include <errno.h>
#include <getopt.h>
#include <poll.h>
#include <signal.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define EXIT_USAGE 2
#define EXIT_PORT 3
#define EXIT_EXCHANGE 4
#define DEFAULT_BRP_PORT 18936U
#define DEFAULT_IGTL_PORT 18944U
#define IDLE_WAIT_MS 50 /* Nobody is connected. */
#define CONNECTED_WAIT_MS 10
#define ANSWER_WAIT_MS 1 /* A command is on its way. */
#define CONTROL_SILENT_US UINT64_C(1000000)
#define LONGEST_TURN_US UINT64_C(20000)
#define ERROR_SIZE 200U

typedef struct {
    const char *exchange;
    const char *address;
    uint16_t brp_port;
    uint16_t igtl_port;
} options_t;

typedef struct {
    exchange_t *exchange;
    workphase_dialect_t workphase;
    transform_dialect_t transform;
    igtl_server_t brp;
    igtl_server_t igtl;
    snapshot_t snapshot;
    igtl_moment_t moment;
    uint64_t patience_ns;
    uint32_t control_beats;
    uint64_t control_seen_us;
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
    workphase_dialect_connected, workphase_dialect_disconnected, workphase_dialect_receive,
    workphase_dialect_is_controlled_by};
static const igtl_dialect_calls_t transform_calls = {
    transform_dialect_connected, transform_dialect_disconnected, transform_dialect_receive, NULL};

static uint64_t timestamp_now(void)
{
    struct timespec now;

    (void)clock_gettime(CLOCK_REALTIME, &now);
    return ((uint64_t)now.tv_sec << 32U) | (((uint64_t)now.tv_nsec << 32U) / 1000000000U);
}

static bool read_port(const char *text, uint16_t *port)
{
    char *end;
    unsigned long value;

    errno = 0;
    value = strtoul(text, &end, 10);
    if ((errno != 0) || (end == text) || (*end != '\0') || (value == 0U) || (value > UINT16_MAX)) {
        return false;
    }
    *port = (uint16_t)value;
    return true;
}

static bool read_options(int count, char **arguments, options_t *options)
{
    static const struct option names[] = {{"exchange", required_argument, NULL, 'e'},
                                          {"brp-port", required_argument, NULL, 'w'},
                                          {"igtl-port", required_argument, NULL, 't'},
                                          {"bind", required_argument, NULL, 'b'},
                                          {NULL, 0, NULL, 0}};
    bool is_good = true;
    int option = getopt_long(count, arguments, "", names, NULL);

    while (option != -1) {
        switch (option) {
        case 'e':
            options->exchange = optarg;
            break;
        case 'w':
            is_good = read_port(optarg, &options->brp_port) && is_good;
            break;
        case 't':
            is_good = read_port(optarg, &options->igtl_port) && is_good;
            break;
        case 'b':
            options->address = optarg;
            break;
        default:
            is_good = false;
            break;
        }
        option = getopt_long(count, arguments, "", names, NULL);
    }
    return is_good && (options->exchange != NULL) && (optind == count);
}

/* A command that was not passed on comes back as refused. */
static void refuse_command(const command_t *command, status_t status,
                           bool (*hand_in)(const answer_t *answer))
{
    const answer_t refusal = {.id = command->id,
                              .source = command->source,
                              .command = command->kind,
                              .argument = command->argument,
                              .kind = (uint32_t)ANSWER_REFUSED,
                              .status = (uint32_t)status,
                              .is_final = 1U,
                              .workphase = process.snapshot.workphase};

    (void)hand_in(&refusal);
}

/* A full lane: STOP and EMERGENCY wait for the next turn, and until they are through nothing that
 * was commanded after them goes ahead. */
static void pass_requests(igtl_requests_t *requests, bool (*hand_in)(const answer_t *answer))
{
    bool is_waiting = false;
    command_t command;

    for (uint32_t left = requests->queued; (left > 0U) && igtl_requests_take(requests, &command);
         left--) {
        const status_t status =
            is_waiting ? STATUS_BUSY : exchange_send_command(process.exchange, &command);

        if ((status == STATUS_BUSY) && igtl_requests_is_urgent(&command)) {
            igtl_requests_keep(requests, &command);
            is_waiting = true;
        } else if (status != STATUS_OK) {
            refuse_command(&command, status, hand_in);
        } else {
            /* It is on its way. */
        }
    }
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
    pass_requests(&process.workphase.requests, answer_workphase);
    pass_requests(&process.transform.requests, answer_transform);
}

/* Control owes an answer in its own time: the board may be slow, and in a pause of the machine
 * control could not answer. */
static void advance_patience(uint64_t elapsed_us)
{
    loop_figures_t loop;
    const uint64_t turn_us = (elapsed_us < LONGEST_TURN_US) ? elapsed_us : LONGEST_TURN_US;
    const uint32_t slowness = exchange_read_loop(process.exchange, &loop) ? loop.slowness : 1U;

    process.patience_ns += (turn_us * 1000U) / slowness;
    process.moment.patience_us = process.patience_ns / 1000U;
}

static void look_around(void)
{
    const uint64_t before_us = process.moment.now_us;
    snapshot_t fresh;

    process.moment.now_us = clock_monotonic_us();
    advance_patience(process.moment.now_us - before_us);
    process.moment.timestamp = timestamp_now();
    if (exchange_read_snapshot(process.exchange, &fresh)) {
        process.snapshot = fresh;
        process.moment.snapshot = &process.snapshot;
    }
}

static void take_answers(void)
{
    answer_t answer;

    while (exchange_take_answer(process.exchange, &answer)) {
        look_around(); /* A snapshot that is not older than the answer. */
        if (!answer_workphase(&answer)) {
            (void)answer_transform(&answer);
        }
    }
}

static void watch_control(void)
{
    const uint32_t beats = exchange_beats(process.exchange, EXCHANGE_CONTROL);

    if (beats != process.control_beats) {
        process.control_beats = beats;
        process.control_seen_us = process.moment.patience_us;
    } else if ((process.moment.patience_us - process.control_seen_us) >= CONTROL_SILENT_US) {
        workphase_dialect_control_lost(&process.workphase, &process.moment);
        process.control_seen_us = process.moment.patience_us;
    } else {
        /* It may be a little late. */
    }
}

static bool awaits_answer(const igtl_requests_t *requests)
{
    for (uint32_t i = 0U; i < IGTL_REQUESTS; i++) {
        if ((requests->requests[i].id != 0U) && !requests->requests[i].is_accepted &&
            !requests->requests[i].is_overdue) {
            return true;
        }
    }
    return false;
}

static int wait_ms(void)
{
    if (awaits_answer(&process.workphase.requests) || awaits_answer(&process.transform.requests)) {
        return ANSWER_WAIT_MS;
    }
    if (igtl_server_has_peers(&process.brp) || igtl_server_has_peers(&process.igtl)) {
        return CONNECTED_WAIT_MS;
    }
    return IDLE_WAIT_MS;
}

static void turn(void)
{
    struct pollfd polls[2U * IGTL_SERVER_POLLS];
    uint32_t count = igtl_server_polls(&process.brp, polls);

    count += igtl_server_polls(&process.igtl, &polls[count]);
    (void)poll(polls, count, wait_ms());
    exchange_beat(process.exchange, EXCHANGE_IGTL);
    look_around();
    igtl_server_receive(&process.brp, &process.moment);
    igtl_server_receive(&process.igtl, &process.moment);
    igtl_server_send(&process.brp, &process.moment);
    pass_commands();
    take_answers();
    watch_control();
    workphase_dialect_step(&process.workphase, &process.moment);
    transform_dialect_step(&process.transform, &process.moment);
    igtl_server_send(&process.brp, &process.moment);
    igtl_server_send(&process.igtl, &process.moment);
}

static bool open_port(igtl_server_t *server, const char *address, uint16_t port,
                      const char *variable)
{
    char error[ERROR_SIZE];

    if (igtl_server_open(server, address, port, error, sizeof error)) {
        return true;
    }
    if (errno == EADDRINUSE) {
        (void)fprintf(stderr, "port %u is in use; stop the other program or set %s\n",
                      (unsigned)port, variable);
    } else {
        (void)fprintf(stderr, "%s\n", error);
    }
    return false;
}

/* Ids go on where no earlier run of this process can have left an answer behind. */
static void begin(void)
{
    const uint32_t first_id = ((uint32_t)clock_utc_us() | 2U) & ~1U;
    const robot_t *robot = exchange_robot(process.exchange);
    answer_t stale;

    workphase_dialect_init(&process.workphase, robot, first_id);
    transform_dialect_init(&process.transform, robot, first_id + 1U);
    process.brp.calls = &workphase_calls;
    process.brp.dialect = &process.workphase;
    process.brp.next_number = 1U;
    process.igtl.calls = &transform_calls;
    process.igtl.dialect = &process.transform;
    process.igtl.next_number = 2U;
    while (exchange_take_answer(process.exchange, &stale)) {
        /* Answers to an earlier run. */
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
    options_t options = {NULL, "127.0.0.1", DEFAULT_BRP_PORT, DEFAULT_IGTL_PORT};
    char error[ERROR_SIZE];

    if (!read_options(count, arguments, &options)) {
        (void)fprintf(stderr,
                      "usage: boresight-igtl --exchange NAME [--brp-port PORT] [--igtl-port PORT]"
                      " [--bind ADDRESS]\n");
        return EXIT_USAGE;
    }
    process.exchange = exchange_open(options.exchange, error, sizeof error);
    if (process.exchange == NULL) {
        (void)fprintf(stderr, "%s\n", error);
        return EXIT_EXCHANGE;
    }
    exchange_protect(process.exchange);
    begin();
    if (!open_port(&process.brp, options.address, options.brp_port, "BRP_PORT") ||
        !open_port(&process.igtl, options.address, options.igtl_port, "IGTL_PORT")) {
        return EXIT_PORT;
    }
    catch_signals();
    while (must_end == 0) {
        turn();
    }
    igtl_server_close(&process.brp);
    igtl_server_close(&process.igtl);
    exchange_close(process.exchange);
    return EXIT_SUCCESS;
}
