/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * boresight: starts the programs, keeps those that may fail alive, and stops all in order.
 */
#include "check/checkup.h"
#include "common/build_id.h"
#include "common/card_protocol.h"
#include "common/clock.h"
#include "common/command_line.h"
#include "common/directory.h"
#include "common/rest.h"
#include "exchange/exchange_cycles.h"
#include "limits/requirement_limits.h"
#include "supervisor/at_rest.h"
#include "supervisor/board_text.h"
#include "supervisor/process_group.h"
#include "supervisor/options.h"
#include "supervisor/ports.h"
#include "supervisor/screen.h"
#include "supervisor/status_line.h"

#include <errno.h>
#include <inttypes.h>
#include <poll.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#define EXIT_STOPPED 0
#define EXIT_CANNOT_START 3
#define EXIT_LOST 4
#define RUNNING (-1)
#define TICK_MS 200
#define TITLE_WIDTH 12U
#define START_TIMEOUT_US UINT64_C(20000000)
#define ERROR_SIZE 1024U

static options_t options;
static screen_t screen;
static process_group_t group;
static exchange_t *exchange;
static int signals;
static char error[ERROR_SIZE];

/*
 * Leaves the last core to control, which takes it for itself; the programs inherit this.
 *
 * @satisfies SWR-ARM-005
 */
static void leave_a_core(void)
{
    const long cores = sysconf(_SC_NPROCESSORS_ONLN);
    cpu_set_t set;

    if ((cores > 1) && (sched_getaffinity(0, sizeof set, &set) == 0)) {
        CPU_CLR((size_t)cores - 1U, &set);
        (void)sched_setaffinity(0, sizeof set, &set);
    }
}

static bool catch_signals(void)
{
    sigset_t set;

    (void)sigemptyset(&set);
    (void)sigaddset(&set, SIGINT);
    (void)sigaddset(&set, SIGTERM);
    (void)sigaddset(&set, SIGHUP);
    (void)sigaddset(&set, SIGCHLD);
    (void)sigprocmask(SIG_BLOCK, &set, NULL);
    (void)signal(SIGPIPE, SIG_IGN);
    signals = signalfd(-1, &set, SFD_CLOEXEC | SFD_NONBLOCK);
    return signals >= 0;
}

/* Waits for a signal, a line or the next tick. True when asked to stop. */
static bool wait_for_news(int timeout_ms)
{
    struct pollfd sources[3] = {{.fd = signals, .events = POLLIN},
                                {.fd = screen.output[0], .events = POLLIN},
                                {.fd = screen.errors[0], .events = POLLIN}};
    struct signalfd_siginfo news;
    bool is_asked = false;

    (void)poll(sources, 3U, timeout_ms);
    while (read(signals, &news, sizeof news) == (ssize_t)sizeof news) {
        is_asked = is_asked || (news.ssi_signo != (uint32_t)SIGCHLD);
    }
    screen_relay(&screen);
    return is_asked;
}

/* Says so when a member ended while starting. */
static bool has_lost_one(void)
{
    char how[64];
    const int lost = process_group_reap(&group);

    if (lost < 0) {
        return false;
    }
    child_describe_end(&group.members[lost], how, sizeof how);
    screen_relay(&screen);
    screen_say(&screen, "Boresight did not start: %s ended (%s); the line above says what to do.",
               group.members[lost].name, how);
    return true;
}

static bool is_companion_ready(void)
{
    return screen.is_heard;
}

static bool is_control_running(void)
{
    snapshot_t snapshot;

    return exchange_read_snapshot(exchange, &snapshot);
}

static bool are_clients_running(void)
{
    return (exchange_beats(exchange, EXCHANGE_RECORDER) > 0U) &&
           (exchange_beats(exchange, EXCHANGE_IGTL) > 0U) &&
           (exchange_beats(exchange, EXCHANGE_HTTP) > 0U);
}

/* RUNNING once `is_ready`; otherwise the exit code. */
static int await(bool (*is_ready)(void), const char *who)
{
    const uint64_t timeout_us = START_TIMEOUT_US * options_slowness(&options);
    const uint64_t end_us = clock_monotonic_us() + timeout_us;

    while (!is_ready()) {
        if (wait_for_news(20)) {
            return EXIT_STOPPED;
        }
        if (has_lost_one()) {
            return EXIT_CANNOT_START;
        }
        if (clock_monotonic_us() >= end_us) {
            screen_say(
                &screen,
                "Boresight did not start: %s gave no sign of life in %u s; end other programs.",
                who, (unsigned)(timeout_us / UINT64_C(1000000)));
            return EXIT_CANNOT_START;
        }
    }
    return RUNNING;
}

static int start_one(member_t member)
{
    if (!process_group_start(&group, member, error, sizeof error)) {
        screen_say(&screen, "Boresight did not start: %s", error);
        return EXIT_CANNOT_START;
    }
    return RUNNING;
}

/** @satisfies SWR-STORE-008 */
static int start_companions(void)
{
    int result = RUNNING;

    for (uint32_t i = 0U; (i < BOARD_COMPANIONS) && (result == RUNNING); i++) {
        if ((board.companions[i].program != NULL) && !group.runs_already[i]) {
            screen_await(&screen, board.companions[i].ready);
            result = start_one((member_t)i);
            result = (result == RUNNING) ? await(is_companion_ready, board.companions[i].program)
                                         : result;
        }
    }
    return result;
}

/* A box that ran before has a slowness that only control knows. */
static int start_control(void)
{
    loop_figures_t loop;
    int result = start_one(MEMBER_CONTROL);

    result = (result == RUNNING) ? await(is_control_running, "control") : result;
    if ((result == RUNNING) && exchange_read_loop(exchange, &loop)) {
        group.slowness = loop.slowness;
    }
    return result;
}

static int start_all(void)
{
    int result = start_companions();

    result = (result == RUNNING) ? start_control() : result;
    result = (result == RUNNING) ? start_one(MEMBER_RECORDER) : result;
    result = (result == RUNNING) ? start_one(MEMBER_IGTL) : result;
    result = (result == RUNNING) ? start_one(MEMBER_HTTP) : result;
    return (result == RUNNING) ? await(are_clients_running, "recorder, igtl or http") : result;
}

static void say_ports(void)
{
    if (options.igtl_file == NULL) {
        screen_say(&screen, "OpenIGTLink: workphases %s:%s, transforms %s:%s", options.bind,
                   options.brp_port, options.bind, options.igtl_port);
    }
    for (uint32_t i = 0U; i < options.ports.count; i++) {
        const igtl_port_t *port = &options.ports.ports[i];
        char place[IGTL_PLACE_SIZE];

        igtl_port_place(port->address, port->number, place);
        screen_say(&screen, "OpenIGTLink: %s %s %s", port->name,
                   port->is_calling ? "calls" : "listens on", place);
    }
}

/** @satisfies SWR-PACK-003 */
static void say_versions(void)
{
    const robot_t *const robot = exchange_robot(exchange);
    char protocol[CARD_PROTOCOL_SIZE];

    card_protocol_write(exchange_cards(exchange)->dialect, protocol);
    screen_say(&screen,
               "Version:     " BUILD_VERSION " (build " BUILD_ID "), robot %s (file %08" PRIx32
               "), card protocol %s",
               robot->name, robot->crc, protocol);
}

static void say_where(void)
{
    char text[SCREEN_LINE_SIZE];

    say_versions();
    screen_say(&screen, "Console:     http://%s:%s/", options.bind, options.http_port);
    say_ports();
    screen_say(&screen, "Recordings:  %s", options.recordings);
    for (uint32_t i = 0U; (i < BOARD_SAYINGS) && (board.says[i].title != NULL); i++) {
        (void)board_text_write(text, sizeof text, board.says[i].text, &options);
        screen_say(&screen, "%s:%*s%s", board.says[i].title,
                   (int)(TITLE_WIDTH - strlen(board.says[i].title)), "", text);
    }
    screen_say(&screen, "Stop:        Ctrl-C");
}

/* Consequence of the end of a member: RUNNING or the exit code. */
static int judge_end(const child_t *child)
{
    char how[64];

    child_describe_end(child, how, sizeof how);
    screen_relay(&screen);
    if ((child == &group.members[MEMBER_CONTROL]) && WIFEXITED(child->status) &&
        (WEXITSTATUS(child->status) == REST_EXIT)) {
        return EXIT_STOPPED;
    }
    if (!child->may_restart) {
        screen_say(&screen,
                   "%s ended (%s), everything stops. Cards stop their motors by their own "
                   "watchdog; where they have none, pull the e-stop now. Find the cause, then "
                   "start boresight again.",
                   child->name, how);
        return EXIT_LOST;
    }
    screen_say(&screen, "%s ended (%s); what others command goes on, it starts again in %u ms.",
               child->name, how, (unsigned)(child->backoff_us / 1000U));
    return RUNNING;
}

/* Time until something is due, at most one tick. */
static int next_tick_ms(void)
{
    const uint64_t now_us = clock_monotonic_us();
    uint64_t wait_us = (uint64_t)TICK_MS * 1000U;

    for (uint32_t i = 0U; i < FAMILY_SIZE; i++) {
        const child_t *child = &group.members[i];
        if ((child->pid == 0) && (child->restart_us > now_us) &&
            ((child->restart_us - now_us) < wait_us)) {
            wait_us = child->restart_us - now_us;
        }
    }
    return (int)(wait_us / 1000U) + 1;
}

/* Control is not replaced: it alone knows where the robot is. The cycles that the recorder has not
 * written stay in their lane for the next one. */
static void end_hanging(void)
{
    static const member_t replaced[] = {MEMBER_RECORDER, MEMBER_IGTL, MEMBER_HTTP};

    for (uint32_t i = 0U; i < (sizeof replaced / sizeof replaced[0]); i++) {
        if (process_group_end_hanging(&group, exchange, replaced[i])) {
            screen_say(&screen, "%s has given no sign of life for %u s; it is ended.",
                       group.members[replaced[i]].name,
                       (unsigned)(LIMIT_HANG_US / UINT64_C(1000000)));
        }
    }
}

static int supervise(void)
{
    static status_parts_t parts;
    int result = RUNNING;

    while (result == RUNNING) {
        status_line_take(&parts, exchange, &group);
        screen_show_status(&screen, &parts, clock_monotonic_us());
        exchange_beat(exchange, EXCHANGE_SUPERVISOR);
        if (wait_for_news(next_tick_ms())) {
            return EXIT_STOPPED;
        }
        for (int ended = process_group_reap(&group); (ended >= 0) && (result == RUNNING);
             ended = process_group_reap(&group)) {
            result = judge_end(&group.members[ended]);
        }
        end_hanging();
        process_group_restart(&group);
    }
    return result;
}

/* Everything that can go wrong before the first program runs. */
static bool prepare(void)
{
    if (!screen_open(&screen) || !catch_signals()) {
        (void)snprintf(error, sizeof error, "No pipe can be made (%s); end other programs.",
                       strerror(errno));
        return false;
    }
    if (!directory_make(options.recordings) || (access(options.recordings, W_OK) != 0)) {
        (void)snprintf(error, sizeof error,
                       "Nothing can be recorded in %s (%s); choose another with --recordings.",
                       options.recordings, strerror(errno));
        return false;
    }
    if (!process_group_init(&group, &options, screen.output[1], screen.errors[1], error,
                            sizeof error) ||
        !ports_check(&options, error, sizeof error)) {
        return false;
    }
    exchange = exchange_create(options.instance, exchange_cycles_in(board.cycle_lane_mb), error,
                               sizeof error);
    return exchange != NULL;
}

static int run(void)
{
    leave_a_core();
    int result = start_all();
    if (result == RUNNING) {
        say_where();
        result = supervise();
    }
    screen_end_status(&screen);
    process_group_stop(&group, exchange);
    screen_relay(&screen);
    exchange_close(exchange);
    screen_say(&screen, (result == EXIT_CANNOT_START) ? "Nothing is left running."
                                                      : "Boresight has stopped.");
    return result;
}

/* In place of everything else. */
static int check_computer(void)
{
    static check_facts_t facts = {.root = ""};

    facts.is_simulated = board.is_simulated;
    facts.board = board.cycle;
    (void)printf("The computer is checked for the control loop; that takes %u s.\n",
                 (LIMIT_CHECK_CYCLES * LIMIT_CYCLE_US) / 1000000U);
    (void)fflush(stdout);
    checkup_measure(&facts, LIMIT_CHECK_CYCLES);
    return checkup_report(&facts, stdout);
}

int main(int count, char **arguments)
{
    const int code = options_read(&options, count, arguments);

    if (code != COMMAND_LINE_GO_ON) {
        return code;
    }
    if (options.is_check) {
        return check_computer();
    }
    if (options.asks_for_rest) {
        return at_rest_report(options.instance, options.stops_at_rest);
    }
    if (!prepare()) {
        (void)fprintf(stderr, "Boresight did not start: %s\n", error);
        return EXIT_CANNOT_START;
    }
    return run();
}
