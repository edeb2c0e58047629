/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * boresight-http: shows control's state to browsers and passes on what they command. Holds nothing
 * that has to be saved: killing it at any moment is its orderly end.
 *
 *     boresight-http --exchange NAME --recordings DIRECTORY [--port 8080] [--bind 127.0.0.1]
 *                    [--box NAME] [--accounts FILE] [--tls-file FILE] [--box-key FILE]
 *     boresight-http --tls-file FILE --stunnel        prints the configuration of stunnel
 */
#include "base/contract.h"
#include "exchange/exchange.h"
#include "http/http_guard.h"
#include "http/http_server.h"

#include <arpa/inet.h>
#include <getopt.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#define EXIT_USAGE 2
#define EXIT_PORT_IN_USE 3
#define DEFAULT_PORT 8080U
#define TICK_NS 50000000L /* 20 Hz */

void contract_broken(const char *module, uint32_t id)
{
    (void)fprintf(stderr, "boresight-http: contract %s/%u is broken\n", module, (unsigned)id);
    abort();
}

typedef struct {
    const char *exchange;
    const char *box;
    const char *accounts;
    const char *recordings;
    const char *tls_file;
    const char *box_key;
    bool is_help_asked;
    bool is_stunnel_asked;
    http_guard_t guard;
} options_t;

static http_server_t server;
static tls_front_t front;

static bool read_port(const char *text, uint32_t *port)
{
    char *end = NULL;
    unsigned long number = strtoul(text, &end, 10);
    *port = (uint32_t)number;
    return (text[0] >= '0') && (text[0] <= '9') && (*end == '\0') && (number > 0U) &&
           (number <= 65535U);
}

static bool read_address(const char *text, char address[HTTP_GUARD_ADDRESS_SIZE])
{
    struct in_addr parsed;
    return (inet_pton(AF_INET, text, &parsed) == 1) &&
           (inet_ntop(AF_INET, &parsed, address, HTTP_GUARD_ADDRESS_SIZE) != NULL);
}

static bool read_option(int option, const char *value, options_t *options)
{
    switch (option) {
    case 'e':
        options->exchange = value;
        return true;
    case 'x':
        options->box = value;
        return true;
    case 't':
        options->tls_file = value;
        return true;
    case 'k':
        options->box_key = value;
        return true;
    case 's':
        options->is_stunnel_asked = true;
        return true;
    case 'h':
        options->is_help_asked = true;
        return true;
    case 'd':
        options->recordings = value;
        return true;
    case 'a':
        options->accounts = value;
        return true;
    case 'p':
        return read_port(value, &options->guard.port);
    case 'b':
        return read_address(value, options->guard.address);
    default:
        return false;
    }
}

static bool read_options(int count, char **arguments, options_t *options)
{
    static const struct option known[] = {{"exchange", required_argument, NULL, 'e'},
                                          {"port", required_argument, NULL, 'p'},
                                          {"bind", required_argument, NULL, 'b'},
                                          {"accounts", required_argument, NULL, 'a'},
                                          {"box", required_argument, NULL, 'x'},
                                          {"tls-file", required_argument, NULL, 't'},
                                          {"stunnel", no_argument, NULL, 's'},
                                          {"recordings", required_argument, NULL, 'd'},
                                          {"box-key", required_argument, NULL, 'k'},
                                          {"help", no_argument, NULL, 'h'},
                                          {NULL, 0, NULL, 0}};
    (void)memset(options, 0, sizeof *options);
    options->guard.port = DEFAULT_PORT;
    (void)read_address("127.0.0.1", options->guard.address);
    int option = getopt_long(count, arguments, "", known, NULL);
    while (option != -1) {
        if (!read_option(option, optarg, options)) {
            return false;
        }
        option = getopt_long(count, arguments, "", known, NULL);
    }
    options->guard.page_port = options->guard.port;
    const bool is_asked = options->is_stunnel_asked && (options->tls_file != NULL);
    const bool is_served = (options->exchange != NULL) && (options->recordings != NULL);
    return (is_served || is_asked || options->is_help_asked) && (optind == count);
}

static int complain_of_front(uint16_t port, const char *key)
{
    (void)fprintf(stderr,
                  "boresight-http: port %u, which TLS shall feed, is in use; change %s in the file "
                  "of TLS.\n",
                  (unsigned)port, key);
    return EXIT_PORT_IN_USE;
}

static int complain(http_server_result_t result, const http_guard_t *guard)
{
    switch (result) {
    case HTTP_SERVER_PORT_IN_USE:
        (void)fprintf(stderr,
                      "boresight-http: port %u of %s is in use; stop the program that has it, or "
                      "choose another port with HTTP_PORT.\n",
                      (unsigned)guard->port, guard->address);
        return EXIT_PORT_IN_USE;
    case HTTP_SERVER_BAD_ADDRESS:
        (void)fprintf(stderr,
                      "boresight-http: cannot listen on port %u of %s; give --bind an address of "
                      "this machine and --port a port you may use.\n",
                      (unsigned)guard->port, guard->address);
        return EXIT_FAILURE;
    case HTTP_SERVER_FRONT_IN_USE:
        return complain_of_front(front.console_from, "console-from");
    case HTTP_SERVER_FRONT_STOP_IN_USE:
        return complain_of_front(front.stop_from, "stop-from");
    case HTTP_SERVER_STARTED:
    case HTTP_SERVER_FAILED:
    default:
        (void)fprintf(stderr,
                      "boresight-http: the server could not be started; free some memory.\n");
        return EXIT_FAILURE;
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

int main(int count, char **arguments)
{
    options_t options;
    const bool is_good = read_options(count, arguments, &options);
    if (!is_good || options.is_help_asked) {
        (void)fputs("usage: boresight-http --exchange NAME --recordings DIRECTORY [--port 8080] "
                    "[--bind 127.0.0.1] [--box NAME] [--accounts FILE] [--tls-file FILE] "
                    "[--box-key FILE]\n"
                    "       boresight-http --tls-file FILE --stunnel\n",
                    is_good ? stdout : stderr);
        return is_good ? EXIT_SUCCESS : EXIT_USAGE;
    }
    char error[512];
    if ((options.tls_file != NULL) &&
        !tls_front_read(&front, options.tls_file, error, sizeof error)) {
        (void)fprintf(stderr, "boresight-http: %s\n", error);
        return EXIT_FAILURE;
    }
    if (options.is_stunnel_asked) {
        tls_front_write_stunnel(&front, stdout);
        return EXIT_SUCCESS;
    }
    exchange_t *exchange = exchange_open(options.exchange, error, (uint32_t)sizeof error);
    if (exchange == NULL) {
        (void)fprintf(stderr, "boresight-http: %s\n", error);
        return EXIT_FAILURE;
    }
    exchange_protect(exchange);
    sigset_t ends;
    (void)sigemptyset(&ends);
    (void)sigaddset(&ends, SIGTERM);
    (void)sigaddset(&ends, SIGINT);
    (void)sigprocmask(SIG_BLOCK, &ends, NULL);
    const http_server_config_t config = {.exchange = exchange,
                                         .guard = options.guard,
                                         .instance = options.exchange,
                                         .box = options.box,
                                         .accounts = options.accounts,
                                         .recordings = options.recordings,
                                         .box_key = options.box_key,
                                         .front = (options.tls_file != NULL) ? &front : NULL};
    http_server_init(&server, &config);
    if (!http_server_prepare_logins(&server, error, sizeof error)) {
        (void)fprintf(stderr, "boresight-http: %s\n", error);
        return EXIT_FAILURE;
    }
    http_server_result_t result = http_server_start(&server);
    if (result != HTTP_SERVER_STARTED) {
        return complain(result, &options.guard);
    }
    (void)printf("boresight-http: http://%s:%u/\n", options.guard.address,
                 (unsigned)options.guard.port);
    (void)fflush(stdout);
    serve(exchange, &ends);
    _exit(EXIT_SUCCESS);
}
