/* SPDX-License-Identifier: Apache-2.0 */
/** @file boresight-box: the simulated control box as a process, at the box's end of the wire. */
#include "base/contract.h"
#include "common/command_line.h"
#include "limits/requirement_limits.h"
#include "robot/app/robot_names.h"
#include "robot/app/robots.h"
#include "sim/box.h"
#include "sim/box_clock.h"
#include "sim/box_grip.h"
#include "sim/wire.h"

#include <errno.h>
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <unistd.h>

#define EXIT_CANNOT_START 3
#define PRIORITY 70
#define SHOW_US UINT64_C(100000)

void contract_broken(const char *module, uint32_t id)
{
    (void)fprintf(stderr, "boresight-box: contract %s/%u is broken\n", module, (unsigned)id);
    abort();
}

enum { ROBOT = 0, BOX, SEED, SLOW, FAST, REAL_TIME, TISSUE, OPTIONS };

static const command_option_t options[OPTIONS] = {
    [ROBOT] = {"robot", "NAME", .says = "whose cards it has; default " ROBOT_NAMES_DEFAULT},
    [BOX] = {"box", "NAME",
             .says = "its name; default $" WIRE_NAME_VARIABLE ", or " WIRE_DEFAULT_NAME},
    [SEED] = {"seed", "NUMBER", .says = "of what it does by chance; default 1", .most = UINT32_MAX},
    [SLOW] = {"slow", "NUMBER", .says = "its time passes so many times slower; default 1",
              .least = 1U, .most = LIMIT_BOX_SLOWEST},
    [FAST] = {"fast", "NUMBER", .says = "its time passes up to so many times faster; default 1",
              .least = 1U, .most = LIMIT_BOX_FASTEST},
    [REAL_TIME] = {"real-time", NULL, .says = "it waits for nobody, as a real one"},
    [TISSUE] = {"tissue", "FILE", .says = "none, usual, auto or a phantom's file; default auto"},
};
static const command_line_t command_line = {
    .program = "boresight-box",
    .says = "Simulates the control box of a robot; boresight starts it, or it runs by itself.",
    .usage = "[OPTION...]",
    .options = options,
    .count = OPTIONS};

static volatile sig_atomic_t must_end;
static box_t box;

static void end(int signal_number)
{
    (void)signal_number;
    must_end = 1;
}

/* The number that was given, which was checked. */
static uint32_t number_of(const char *value, uint32_t otherwise)
{
    return (value != NULL) ? (uint32_t)strtoul(value, NULL, 10) : otherwise;
}

static const char *name_of(const char *value)
{
    const char *const otherwise = getenv(WIRE_NAME_VARIABLE);
    const char *const known = (otherwise != NULL) ? otherwise : WIRE_DEFAULT_NAME;

    return (value != NULL) ? value : known;
}

/*
 * On the core of the control process: when a virtual machine pauses that core, the simulated world
 * pauses with the controller, as it would not on another core, and no watchdog trips that would not
 * trip on hardware.
 */
static void share_core_with_control(void)
{
    const long cores = sysconf(_SC_NPROCESSORS_ONLN);
    cpu_set_t set;

    CPU_ZERO(&set);
    CPU_SET((cores > 1) ? ((size_t)cores - 1U) : 0U, &set);
    (void)sched_setaffinity(0, sizeof set, &set);
}

/*
 * Fast time leaves no core idle, so it takes none from other programs.
 *
 * @satisfies SWR-BOX-043
 */
static bool ask_for_real_time(box_time_t time)
{
    const struct sched_param parameters = {.sched_priority = PRIORITY};

    share_core_with_control();
    (void)prctl(PR_SET_TIMERSLACK, 1000UL, 0UL, 0UL, 0UL);
    (void)mlockall(MCL_CURRENT | MCL_FUTURE);
    return (time.speedup == 1U) && (sched_setscheduler(0, SCHED_FIFO, &parameters) == 0);
}

static void publish_inputs(wire_t *wire)
{
    const bsp_inputs_t inputs = box_sample(&box);

    wire_latch(&wire->dropped, inputs.dropped);
    wire_store(&wire->inputs, inputs.levels);
    wire_store(&wire->beat, wire_load(&wire->beat) + 1U);
}

static void publish_bench(wire_t *wire)
{
    bsp_bench_t seen;

    box_show(&box, &seen);
    wire_show_bench(wire, &seen);
}

/*
 * The needle moves without an order.
 *
 * @satisfies SWR-BOX-779
 */
static void show_needle(wire_t *wire)
{
    static uint64_t shown;

    if (box.time_us / SHOW_US != shown) {
        shown = box.time_us / SHOW_US;
        publish_bench(wire);
    }
}

static void serve_order(wire_t *wire)
{
    const uint32_t number = wire_load(&wire->order_request);

    if (number != wire_load(&wire->order_reply)) {
        char order[WIRE_ORDER_SIZE];
        (void)memcpy(order, wire->order, sizeof order);
        order[sizeof order - 1U] = '\0';
        wire->order_done = box_command(&box, order, wire->answer, sizeof wire->answer) ? 1U : 0U;
        publish_inputs(wire);
        publish_bench(wire);
        wire_announce(&wire->order_reply, number);
    }
}

/* The world goes on to where it is asked for, if it is. */
static void go_on(wire_t *wire, box_clock_t *clock, const uint64_t *wanted_us)
{
    box_advance(&box, box_clock_look(clock, wanted_us, wire_now_us()));
    wire_store_time(wire, clock->now_us);
}

static void serve_exchange(wire_t *wire, box_clock_t *clock)
{
    const uint32_t number = wire_load(&wire->request);

    if (number != wire_load(&wire->reply)) {
        const uint8_t(*frames)[CARD_FRAME_BYTES] = (const uint8_t(*)[CARD_FRAME_BYTES])wire->frames;
        go_on(wire, clock, &wire->wanted_us);
        wire->replied_us = clock->now_us;
        wire->received = box_exchange(&box, wire->send, frames, wire->replies);
        wire_announce(&wire->reply, number);
    }
}

/* A program takes longer to start than the cards' watchdogs wait, but elastic time stands still
 * meanwhile. */
static void let_control_start(const wire_t *wire, uint32_t *openings)
{
    const uint32_t now = wire_load(&wire->openings);

    if (now != *openings) {
        *openings = now;
        box_advance(&box, 2U * LIMIT_CARD_WATCHDOG_US);
    }
}

/* Control that waits for something else asks for nothing, and lives. */
static void hear_control(const wire_t *wire, box_clock_t *clock, uint32_t *waits)
{
    const uint32_t now = wire_load(&wire->waits);

    if (now != *waits) {
        *waits = now;
        box_clock_hear(clock);
    }
}

/* An input held from afar opens in the cycle in which its time is over. */
static void loosen(wire_t *wire, box_grip_t *grip)
{
    if (box_grip_look(grip, &box, wire_now_us())) {
        publish_bench(wire);
    }
}

/* The outputs of control that are no frames. */
static void take_outputs(const wire_t *wire)
{
    box.is_off = wire_load(&wire->is_off) != 0U;
    box.lamps = wire_load(&wire->lamps);
}

/* Requests of control come in this order: an exchange, then a call to a later time. */
static void look_around(wire_t *wire, box_clock_t *clock, box_grip_t *grip)
{
    const uint32_t call = wire_load(&wire->call);

    take_outputs(wire);
    serve_exchange(wire, clock);
    go_on(wire, clock, (call != wire_load(&wire->come)) ? &wire->called_us : NULL);
    loosen(wire, grip);
    show_needle(wire);
    publish_inputs(wire);
    if (call != wire_load(&wire->come)) {
        wire_announce(&wire->come, call);
    }
    serve_order(wire);
}

static void run(wire_t *wire, box_time_t time)
{
    const uint32_t pause_us =
        time.is_elastic ? BOX_CLOCK_LOOK_US : (BOX_CLOCK_SAMPLE_US * time.slowness);
    box_clock_t clock;
    box_grip_t grip = {{0U}, {0U}};
    uint32_t openings = wire_load(&wire->openings);
    uint32_t waits = wire_load(&wire->waits);

    box_clock_init(&clock, time, wire_load_time(wire), wire_now_us());
    while (must_end == 0) {
        const uint32_t seen = wire_load(&wire->wake);
        if (time.is_elastic) {
            let_control_start(wire, &openings);
            hear_control(wire, &clock, &waits);
        }
        look_around(wire, &clock, &grip);
        wire_sleep(&wire->wake, seen, pause_us);
    }
}

static void handle_signals(void)
{
    struct sigaction action;

    (void)memset(&action, 0, sizeof action);
    action.sa_handler = end;
    (void)sigaction(SIGTERM, &action, NULL);
    (void)sigaction(SIGINT, &action, NULL);
}

/* False: the file cannot be read, and the standard error says why. */
static bool read_phantom(const char *path, sim_phantom_file_t *phantom)
{
    static char text[SIM_PHANTOM_SIZE];
    char reason[256];
    FILE *const file = fopen(path, "r");

    if (file == NULL) {
        (void)fprintf(stderr, "boresight-box: the phantom %s cannot be read (%s)\n", path,
                      strerror(errno));
        return false;
    }
    const size_t length = fread(text, 1U, sizeof text, file);
    const bool is_whole = (ferror(file) == 0) && (length < sizeof text);
    (void)fclose(file);
    if (!is_whole) {
        (void)fprintf(stderr, "boresight-box: the phantom %s is no file, or longer than %u bytes\n",
                      path, (unsigned)sizeof text - 1U);
        return false;
    }
    text[length] = '\0';
    if (!sim_phantom_read(phantom, text, reason, sizeof reason)) {
        (void)fprintf(stderr, "boresight-box: the phantom %s, %s\n", path, reason);
        return false;
    }
    return true;
}

/* Nothing is to do for "auto". */
static bool lay_tissue(const char *tissue)
{
    sim_phantom_file_t phantom = {.tissue = {.layer_count = 0U}};

    if (strcmp(tissue, "auto") == 0) {
        return true;
    }
    if (strcmp(tissue, "usual") == 0) {
        phantom = sim_phantom_usual;
    } else if ((strcmp(tissue, "none") != 0) && !read_phantom(tissue, &phantom)) {
        return false;
    } else {
        /* It is there. */
    }
    box_force_lay(&box.force, &phantom);
    box_read_cells(&box);
    return true;
}

static int serve(const char *name, const robot_t *robot, uint32_t seed, box_time_t time)
{
    wire_port_t port;
    char error[256];

    handle_signals();
    if (!wire_serve(&port, name, time, error, sizeof error)) {
        (void)fprintf(stderr, "boresight-box: %s\n", error);
        return EXIT_CANNOT_START;
    }
    wire_store(&port.wire->robot_crc, robot->crc);
    publish_bench(port.wire);
    const bool is_real_time = ask_for_real_time(time);
    (void)printf("boresight-box: ready as \"%s\", robot %s, seed %u, %s\n", name, robot->name,
                 (unsigned)seed, is_real_time ? "SCHED_FIFO 70" : "without real-time scheduling");
    (void)fflush(stdout);
    run(port.wire, time);
    wire_close(&port, WIRE_END_BOX);
    return EXIT_SUCCESS;
}

/** @satisfies SWR-BOX-041 */
static bool is_one_pace(box_time_t time)
{
    return (time.speedup == 1U) || (time.is_elastic && (time.slowness == 1U));
}

int main(int count, char **words)
{
    const char *values[OPTIONS];
    const int code = command_line_read(&command_line, count, words, values, NULL);

    if (code != COMMAND_LINE_GO_ON) {
        return code;
    }
    const char *const wanted = (values[ROBOT] != NULL) ? values[ROBOT] : ROBOT_NAMES_DEFAULT;
    const robot_t *const robot = robots_find(wanted);
    if (robot == NULL) {
        return command_line_refuse(&command_line,
                                   "There is no robot \"%s\"; choose %s with --robot.", wanted,
                                   robot_names_list());
    }
    const box_time_t time = {.is_elastic = values[REAL_TIME] == NULL,
                             .slowness = number_of(values[SLOW], 1U),
                             .speedup = number_of(values[FAST], 1U)};
    if (!is_one_pace(time)) {
        return command_line_refuse(&command_line,
                                   "--fast is of no use with --real-time, where the box keeps the "
                                   "world's time, nor with --slow; give one of them.");
    }
    const uint32_t seed = number_of(values[SEED], 1U);
    box_init(&box, robot, seed);
    if (!lay_tissue((values[TISSUE] != NULL) ? values[TISSUE] : "auto")) {
        return EXIT_CANNOT_START;
    }
    return serve(name_of(values[BOX]), robot, seed, time);
}
