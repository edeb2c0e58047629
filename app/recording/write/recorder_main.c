/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * boresight-recorder: takes every cycle and every event out of the exchange and keeps them in
 * files. It may die at any moment; control does not notice.
 */
#include "base/contract.h"
#include "common/build_id.h"
#include "common/clock.h"
#include "common/command_line.h"
#include "common/directory.h"
#include "controller/controller.h"
#include "interface/interface_layout.h"
#include "recording/write/black_box.h"
#include "recording/write/card_counts.h"
#include "recording/write/event_log.h"
#include "recording/write/position_keeper.h"
#include "recording/write/sweep_keeper.h"
#include "robot/robot.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define EXIT_CANNOT_START 3
#define TICK_NS 50000000L

enum { INSTANCE = 0, DIRECTORY, POSITIONS, OPTIONS };

static const command_option_t options[OPTIONS] = {
    [INSTANCE] = {"instance", "NAME", .says = "instance of Boresight that it belongs to",
                  .is_needed = true},
    [DIRECTORY] = {"directory", "FOLDER", .says = "where recordings and logs go",
                   .is_needed = true},
    [POSITIONS] = {"positions", "FILE", .says = "where the axes stand, for the next start",
                   .is_needed = true},
};
static const command_line_t command_line = {
    .program = "boresight-recorder",
    .says = "Keeps every cycle and every event in files; boresight starts it.",
    .usage = "OPTION...",
    .options = options,
    .count = OPTIONS};

void contract_broken(const char *module, uint32_t id)
{
    (void)fprintf(stderr, "boresight-recorder: contract %s/%u is broken\n", module, (unsigned)id);
    abort();
}

static black_box_t black_box;
static event_log_t event_log;
static position_keeper_t position_keeper;
static card_counts_t card_counts[CARD_SLOT_COUNT];
static sweep_keeper_t sweep_keeper;

/* A recorder before this one may not have written what has changed in this run. */
static void begin_counts(const exchange_t *exchange)
{
    const bool is_again = exchange_file(exchange, EXCHANGE_FILE_LOG) != 0U;

    for (uint32_t i = 0U; i < CARD_SLOT_COUNT; i++) {
        card_counts[i].is_settled = is_again;
    }
}

static void log_counts(const snapshot_t *snapshot, uint64_t now_us)
{
    char text[CARD_COUNTS_SIZE];

    for (uint32_t i = 0U; i < CARD_SLOT_COUNT; i++) {
        if (card_counts_look(&card_counts[i], i, &snapshot->cards[i], now_us, text)) {
            event_log_remark(&event_log, text);
        }
    }
}

static void look_at_snapshot(const exchange_t *exchange, bool is_end)
{
    snapshot_t snapshot;

    if (!exchange_read_snapshot(exchange, &snapshot)) {
        return;
    }
    log_counts(&snapshot, is_end ? CARD_COUNTS_END : clock_monotonic_us());
    if (is_end) {
        position_keeper_close(&position_keeper, &snapshot, clock_utc_us());
    } else {
        position_keeper_look(&position_keeper, &snapshot, clock_monotonic_us(), clock_utc_us());
    }
}

static void drain(exchange_t *exchange)
{
    black_box_drain(&black_box, clock_monotonic_us());
    event_log_drain(&event_log);
    sweep_keeper_drain(&sweep_keeper, exchange);
    exchange_beat(exchange, EXCHANGE_RECORDER);
}

/* A recording begins with its robot. NULL: a signal came before control has published it. */
static const robot_t *await_robot(exchange_t *exchange, const sigset_t *ends)
{
    const struct timespec tick = {.tv_sec = 0, .tv_nsec = TICK_NS};
    const robot_t *robot = exchange_robot(exchange);

    while (robot->axis_count == 0U) {
        if (sigtimedwait(ends, NULL, &tick) >= 0) {
            return NULL;
        }
        exchange_beat(exchange, EXCHANGE_RECORDER);
    }
    return robot;
}

static void record(exchange_t *exchange, const sigset_t *ends)
{
    const struct timespec tick = {.tv_sec = 0, .tv_nsec = TICK_NS};
    uint64_t synced_us = clock_monotonic_us();

    while (sigtimedwait(ends, NULL, &tick) < 0) {
        drain(exchange);
        look_at_snapshot(exchange, false);
        if ((clock_monotonic_us() - synced_us) >= UINT64_C(1000000)) {
            event_log_sync(&event_log);
            synced_us = clock_monotonic_us();
        }
    }
    drain(exchange);
    look_at_snapshot(exchange, true);
}

/* Runs with its options until a signal ends it. @return the exit code */
static int keep(const char *const values[])
{
    char error[256] = "";
    sigset_t ends;

    (void)sigemptyset(&ends);
    (void)sigaddset(&ends, SIGTERM);
    (void)sigaddset(&ends, SIGINT);
    (void)sigprocmask(SIG_BLOCK, &ends, NULL);
    (void)signal(SIGXFSZ, SIG_IGN);
    exchange_t *exchange = exchange_open(values[INSTANCE], error, sizeof error);
    if (exchange == NULL) {
        (void)fprintf(stderr, "recorder: %s\n", error);
        return EXIT_CANNOT_START;
    }
    exchange_protect(exchange, EXCHANGE_RECORDER);
    if (!directory_make(values[DIRECTORY])) {
        (void)fprintf(
            stderr,
            "recorder: the directory %s cannot be made (%s); choose another with --recordings.\n",
            values[DIRECTORY], strerror(errno));
        return EXIT_CANNOT_START;
    }
    const robot_t *robot = await_robot(exchange, &ends);
    if (robot == NULL) {
        exchange_close(exchange);
        return 0;
    }
    recording_header_t header = {.robot_crc = robot->crc,
                                 .inputs_size = sizeof(controller_inputs_t),
                                 .outputs_size = sizeof(controller_outputs_t),
                                 .controller_size = CONTROLLER_CHECKPOINT_BYTES,
                                 .layout = INTERFACE_LAYOUT};
    (void)snprintf(header.build, sizeof header.build, "%s", BUILD_ID);
    (void)snprintf(header.robot, sizeof header.robot, "%s", robot->name);
    begin_counts(exchange);
    event_log_open(&event_log, values[DIRECTORY], exchange);
    position_keeper_open(&position_keeper, values[POSITIONS]);
    sweep_keeper = (sweep_keeper_t){.directory = values[DIRECTORY], .robot = robot};
    black_box_open(&black_box, values[DIRECTORY], exchange, &header);
    record(exchange, &ends);
    const uint32_t unrecorded = black_box_close(&black_box);
    if (unrecorded != 0U) {
        event_log_note_unrecorded(&event_log, unrecorded);
    }
    event_log_close(&event_log);
    exchange_close(exchange);
    return 0;
}

int main(int count, char **arguments)
{
    const char *values[OPTIONS];
    const int code = command_line_read(&command_line, count, arguments, values, NULL);

    return (code == COMMAND_LINE_GO_ON) ? keep(values) : code;
}
