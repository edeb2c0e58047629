/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * boresight-http: shows control's state to browsers and passes on what they command. Holds nothing
 * that has to be saved: killing it at any moment is its orderly end.
 */
#include "base/contract.h"
#include "common/command_line.h"
#include "exchange/exchange.h"
#include "http/gate/http_guard.h"
#include "http/gate/http_handover.h"
#include "http/server/http_server.h"

#include <arpa/inet.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#define EXIT_CANNOT_START 3
#define DEFAULT_PORT "8080"
#define DEFAULT_ADDRESS "127.0.0.1"
#define ERROR_SIZE 512U
#define TICK_NS 50000000L /* 20 Hz */

void contract_broken(const char *module, uint32_t id)
{
    (void)fprintf(stderr, "boresight-http: contract %s/%u is broken\n", module, (unsigned)id);
    abort();
}

enum { INSTANCE = 0, RECORDINGS, PORT, BIND, BOX, BOX_KEY, ACCOUNTS, TLS_FILE, STUNNEL, OPTIONS };

static const command_option_t options[OPTIONS] = {
    [INSTANCE] = {"instance", "NAME", .says = "instance of Boresight that it belongs to"},
    [RECORDINGS] = {"recordings", "FOLDER", .says = "where recordings and logs are"},
    [PORT] = {"port", "PORT", .says = "of the console; default 8080", .least = 1U,
              .most = UINT16_MAX},
    [BIND] = {"bind", "ADDRESS", .says = "IPv4 address to listen on; default 127.0.0.1"},
    [BOX] = {"box", "NAME", .says = "the simulated box; without it a robot is connected"},
    [BOX_KEY] = {"box-key", "FILE", .says = "key of the box, for saved positions"},
    [ACCOUNTS] = {"accounts", "FILE", .says = "who may log in; boresight-passwd makes it"},
    [TLS_FILE] = {"tls-file", "FILE", .says = "how TLS leads here"},
    [STUNNEL] = {"stunnel", NULL, .says = "write the configuration of stunnel, and end"},
};
static const command_line_t command_line = {
    .program = "boresight-http",
    .says = "Serves the console and the HTTP interface; boresight starts it.",
    .usage = "--instance NAME --recordings FOLDER [OPTION...]\n--tls-file FILE --stunnel",
    .options = options,
    .count = OPTIONS};

static http_server_t server;
static tls_front_t front;

static bool read_address(const char *text, char address[HTTP_GUARD_ADDRESS_SIZE])
{
    struct in_addr parsed;
    return (inet_pton(AF_INET, text, &parsed) == 1) &&
           (inet_ntop(AF_INET, &parsed, address, HTTP_GUARD_ADDRESS_SIZE) != NULL);
}

/* Checks beyond single options: which of them belong together, and whether there is such an
 * address. */
static int check(const char *const values[], http_guard_t *guard)
{
    const char *const address = (values[BIND] != NULL) ? values[BIND] : DEFAULT_ADDRESS;
    const char *const port = (values[PORT] != NULL) ? values[PORT] : DEFAULT_PORT;

    if (values[STUNNEL] != NULL) {
        return (values[TLS_FILE] != NULL)
                   ? COMMAND_LINE_GO_ON
                   : command_line_refuse(&command_line, "--tls-file FILE is missing.");
    }
    if ((values[INSTANCE] == NULL) || (values[RECORDINGS] == NULL)) {
        return command_line_refuse(&command_line, "--%s is missing.",
                                   (values[INSTANCE] == NULL) ? "instance NAME"
                                                              : "recordings FOLDER");
    }
    guard->port = (uint32_t)strtoul(port, NULL, 10);
    guard->page_port = guard->port;
    return read_address(address, guard->address)
               ? COMMAND_LINE_GO_ON
               : command_line_refuse(&command_line,
                                     "\"%s\" is no IPv4 address; give --bind one of this machine.",
                                     address);
}

static int complain_of_front(uint16_t port, const char *key)
{
    (void)fprintf(stderr,
                  "boresight-http: port %u, which TLS shall feed, is in use; change %s in the file "
                  "of TLS.\n",
                  (unsigned)port, key);
    return EXIT_CANNOT_START;
}

static int complain(http_server_result_t result, const http_guard_t *guard)
{
    switch (result) {
    case HTTP_SERVER_PORT_IN_USE:
        (void)fprintf(stderr,
                      "boresight-http: port %u of %s is in use; stop the program that has it, or "
                      "choose another port with HTTP_PORT.\n",
                      (unsigned)guard->port, guard->address);
        return EXIT_CANNOT_START;
    case HTTP_SERVER_BAD_ADDRESS:
        (void)fprintf(stderr,
                      "boresight-http: cannot listen on port %u of %s; give --bind an address of "
                      "this machine and --port a port you may use.\n",
                      (unsigned)guard->port, guard->address);
        return EXIT_CANNOT_START;
    case HTTP_SERVER_FRONT_IN_USE:
        return complain_of_front(front.console_from, "console-from");
    case HTTP_SERVER_FRONT_STOP_IN_USE:
        return complain_of_front(front.stop_from, "stop-from");
    case HTTP_SERVER_TOO_FEW_FILES:
        (void)fprintf(stderr,
                      "boresight-http: this user may have too few files open; let it have %u or "
                      "more (ulimit -n), then start again.\n",
                      HTTP_HANDOVER_LEAST);
        return EXIT_CANNOT_START;
    case HTTP_SERVER_STARTED:
    case HTTP_SERVER_FAILED:
    default:
        (void)fprintf(stderr,
                      "boresight-http: the server could not be started; free some memory.\n");
        return EXIT_CANNOT_START;
    }
}

/* Ticks need not be punctual; sleeping a whole one leaves nothing to catch up with. */
static void serve(exchange_t *exchange, const sigset_t *ends)
{
    const struct timespec tick = {.tv_sec = 0, .tv_nsec = TICK_NS};
    do {
        exchange_beat(exchange, EXCHANGE_HTTP);
        http_server_tick(&server);
    } while (sigtimedwait(ends, NULL, &tick) < 0);
}

static exchange_t *open_exchange(const char *const values[])
{
    char error[ERROR_SIZE];
    exchange_t *const exchange = exchange_open(values[INSTANCE], error, (uint32_t)sizeof error);

    if (exchange == NULL) {
        (void)fprintf(stderr, "boresight-http: %s\n", error);
    } else {
        exchange_protect(exchange, EXCHANGE_HTTP);
    }
    return exchange;
}

static int run(const char *const values[], const http_guard_t *guard)
{
    char error[ERROR_SIZE];
    exchange_t *const exchange = open_exchange(values);
    sigset_t ends;

    if (exchange == NULL) {
        return EXIT_CANNOT_START;
    }
    (void)sigemptyset(&ends);
    (void)sigaddset(&ends, SIGTERM);
    (void)sigaddset(&ends, SIGINT);
    (void)sigprocmask(SIG_BLOCK, &ends, NULL);
    const http_server_config_t config = {.exchange = exchange,
                                         .guard = *guard,
                                         .instance = values[INSTANCE],
                                         .box = values[BOX],
                                         .accounts = values[ACCOUNTS],
                                         .recordings = values[RECORDINGS],
                                         .box_key = values[BOX_KEY],
                                         .front = (values[TLS_FILE] != NULL) ? &front : NULL};
    http_server_init(&server, &config);
    if (!http_server_prepare_logins(&server, error, sizeof error)) {
        (void)fprintf(stderr, "boresight-http: %s\n", error);
        return EXIT_CANNOT_START;
    }
    const http_server_result_t result = http_server_start(&server);
    if (result != HTTP_SERVER_STARTED) {
        return complain(result, guard);
    }
    (void)printf("boresight-http: http://%s:%u/\n", guard->address, (unsigned)guard->port);
    (void)fflush(stdout);
    serve(exchange, &ends);
    _exit(EXIT_SUCCESS);
}

int main(int count, char **arguments)
{
    const char *values[OPTIONS];
    char error[ERROR_SIZE];
    http_guard_t guard = {0};
    int code = command_line_read(&command_line, count, arguments, values, NULL);

    code = (code == COMMAND_LINE_GO_ON) ? check(values, &guard) : code;
    if (code != COMMAND_LINE_GO_ON) {
        return code;
    }
    if ((values[TLS_FILE] != NULL) &&
        !tls_front_read(&front, values[TLS_FILE], error, sizeof error)) {
        (void)fprintf(stderr, "boresight-http: %s\n", error);
        return EXIT_CANNOT_START;
    }
    if (values[STUNNEL] != NULL) {
        tls_front_write_stunnel(&front, stdout);
        return EXIT_SUCCESS;
    }
    return run(values, &guard);
}
