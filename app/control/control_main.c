/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The control process: wakes once per cycle, exchanges frames with the cards, steps the
 * controller and publishes. It waits for no other process, only for the clock and the cards, and in
 * elastic time for a lane of cycles that is full. All its state is here: this file is the RAM map.
 *
 * @satisfies SWR-CTRL-001
 */
#include "base/contract.h"
#include "bsp.h"
#include "common/clock.h"
#include "common/command_line.h"
#include "common/rest.h"
#include "control/board_inputs.h"
#include "control/computer.h"
#include "control/cycle_lane.h"
#include "control/drives_off.h"
#include "control/figures.h"
#include "control/lamps.h"
#include "control/list_file.h"
#include "check/realtime.h"
#include "control/sources.h"
#include "controller/controller.h"
#include "exchange/exchange.h"
#include "exchange/exchange_cycles.h"
#include "exchange/exchange_rows.h"
#include "limits/requirement_limits.h"
#include "positions/position_store.h"
#include "robot/app/robot_names.h"
#include "robot/app/robots.h"

#include <signal.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#define CYCLE_NS (UINT64_C(1000) * LIMIT_CYCLE_US)
#define FIGURES_NS UINT64_C(1000000000)
#define EXIT_CANNOT_START 3
#define EXIT_CONTRACT 5

enum { ROBOT = 0, INSTANCE, BOX, POSITIONS, TRAJECTORY, OPTIONS };

static const command_option_t options[OPTIONS] = {
    [ROBOT] = {"robot", "NAME", .says = "the robot to drive", .is_needed = true},
    [INSTANCE] = {"instance", "NAME", .says = "instance of Boresight that it belongs to",
                  .is_needed = true},
    [BOX] = {"box", "NAME", .says = "the control box", .is_needed = true},
    [POSITIONS] = {"positions", "FILE", .says = "where the axes stood when it ended",
                   .is_needed = true},
    [TRAJECTORY] = {"trajectory", "FILE", .says = "trajectory that is held from the start"},
};
static const command_line_t command_line = {
    .program = "boresight-control",
    .says = "Decides every millisecond what each axis may do; boresight starts it.",
    .usage = "OPTION...",
    .options = options,
    .count = OPTIONS};

static const robot_t *our_robot;
static controller_t controller;
static controller_inputs_t inputs;
static controller_outputs_t outputs;
static figures_t figures;
static loop_figures_t published;
static uint64_t board_ns_reported; /* When the figures were last published. */
static uint64_t world_ns_reported;
static exchange_t *exchange;
static uint64_t stage_ns[LOOP_STAGE_COUNT]; /* To wake up for this cycle, the others of the last. */
static sources_t sources;
static computer_t computer;
static cycle_lane_t lane;
static bsp_identity_t board;
static board_inputs_t board_inputs;
static bsp_inputs_t sampled;             /* In this cycle. */
static bsp_exchange_t exchanged;         /* Begun in the cycle before. */
static volatile sig_atomic_t stopped_by; /* Signal number. */
static uint8_t crash_stack[65536];

/* Signals that end control. The first ones end its loop, as do those without a name, and those that
 * would make it stand still with drives on; after the others nothing of it is believed. */
static const int stop_signals[] = {SIGHUP,  SIGINT,  SIGQUIT, SIGUSR1,   SIGUSR2, SIGPIPE,
                                   SIGALRM, SIGTERM, SIGXCPU, SIGVTALRM, SIGPROF, SIGIO,
                                   SIGXFSZ, SIGPWR,  SIGTSTP, SIGTTIN,   SIGTTOU, SIGSTKFLT};
static const int crash_signals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGSYS};

/**
 * The only way out once the board is open: `why` is printed after "off" was sent to every card, and
 * before that the board's own line, which needs no card, was set.
 *
 * @satisfies SWR-CTRL-010
 * @satisfies SWR-CTRL-011
 */
static void switch_off(const char *why)
{
    bsp_drives_off();
    char text[DRIVES_OFF_TEXT_SIZE];
    char line[2U * DRIVES_OFF_TEXT_SIZE];
    const drives_off_t done =
        drives_off(our_robot, board.dialect, controller.sealed.sequence, controller.sealed.time_us);
    drives_off_report(&done, text);
    const int length = snprintf(line, sizeof line, "control: %s; %s", why, text);
    (void)!write(STDERR_FILENO, line, (size_t)length);
}

void contract_broken(const char *module, uint32_t id)
{
    char why[80];
    (void)snprintf(why, sizeof why, "contract %s/%u is broken, report this", module, (unsigned)id);
    switch_off(why);
    _Exit(EXIT_CONTRACT);
}

static void ask_to_stop(int signal_number)
{
    stopped_by = signal_number;
}

/* Ends by the same signal again, so that its parent and a core dump show the cause. */
static void crash(int signal_number)
{
    char why[40];
    (void)signal(signal_number, SIG_DFL);
    (void)snprintf(why, sizeof why, "crashed by signal %d, report this", signal_number);
    switch_off(why);
    (void)raise(signal_number);
}

static void handle_signals(void)
{
    const stack_t stack = {.ss_sp = crash_stack, .ss_size = sizeof crash_stack};
    const struct sigaction stop = {.sa_handler = ask_to_stop};
    const struct sigaction end = {.sa_handler = crash, .sa_flags = SA_ONSTACK | SA_NODEFER};
    (void)sigaltstack(&stack, NULL);
    for (uint32_t i = 0; i < sizeof stop_signals / sizeof stop_signals[0]; i++) {
        (void)sigaction(stop_signals[i], &stop, NULL);
    }
    for (int number = SIGRTMIN; number <= SIGRTMAX; number++) {
        (void)sigaction(number, &stop, NULL);
    }
    for (uint32_t i = 0; i < sizeof crash_signals / sizeof crash_signals[0]; i++) {
        (void)sigaction(crash_signals[i], &end, NULL);
    }
}

static uint32_t longest_stage(void)
{
    uint32_t longest = 0;
    for (uint32_t i = 1; i < LOOP_STAGE_COUNT; i++) {
        longest = (stage_ns[i] > stage_ns[longest]) ? i : longest;
    }
    return longest;
}

/*
 * The programs live in the world's time, at any pace of the board's.
 *
 * @satisfies SWR-BOX-042
 */
static uint32_t silent_sources(void)
{
    const uint32_t beats[COMMAND_SOURCE_COUNT] = {
        [COMMAND_SOURCE_IGTL] = exchange_beats(exchange, EXCHANGE_IGTL),
        [COMMAND_SOURCE_HTTP] = exchange_beats(exchange, EXCHANGE_HTTP)};
    return sources_listen(&sources, beats, inputs.elapsed_us / board.speedup);
}

/** @satisfies SWR-CHECK-008 */
static void gather_inputs(uint64_t elapsed_ns)
{
    (void)memset(&inputs, 0, sizeof inputs);
    const uint64_t elapsed_us = (elapsed_ns + 500U) / 1000U;
    inputs.elapsed_us = (elapsed_us < UINT32_MAX) ? (uint32_t)elapsed_us : UINT32_MAX;
    inputs.late_stage = longest_stage();
    bsp_sample_inputs(&sampled);
    board_inputs_take(&board_inputs, &sampled, &inputs);
    bsp_finish(bsp_now_ns() + (UINT64_C(1000) * LIMIT_EXCHANGE_TIMEOUT_US), inputs.frames,
               &exchanged);
    board_inputs_receive(&exchanged, &inputs);
    inputs.samples.error_us = board.sample_error_us;
    inputs.silent_sources = silent_sources();
    inputs.unfit = board.is_simulated ? 0U : computer.lacks;
    inputs.lacks_black_box = cycle_lane_lacks_recorder(&lane, exchange) ? 1U : 0U;
    inputs.cycles_lost = lane.lost;
    inputs.is_recorder_failing = lane.is_failing ? 1U : 0U;
    inputs.recording_left_min = exchange_recording_left_min(exchange);
    inputs.dialect = board.dialect;
    inputs.is_dialect_accepted = (board.accepted[0] != '\0') ? 1U : 0U;
    inputs.command_count = exchange_take_commands(exchange, inputs.commands, CONTROLLER_COMMANDS);
}

static void record_cycle(uint32_t cycle)
{
    cycle_entry_t *const entry = lane.is_gap ? NULL : exchange_reserve_cycle(exchange);
    if (entry != NULL) {
        entry->kind = (uint32_t)CYCLE_RECORD_CYCLE;
        entry->cycle = cycle;
        entry->body.cycle.inputs = inputs;
        entry->body.cycle.outputs = outputs;
        board_inputs_note(&sampled, &exchanged, &entry->body.cycle.board);
        exchange_commit_cycle(exchange);
    }
}

static void publish(uint32_t cycle)
{
    exchange_publish_snapshot(exchange, &outputs.snapshot);
    exchange_publish_rows(exchange, &controller, &outputs);
    const uint64_t utc_us = (outputs.event_count > 0U) ? clock_utc_us() : 0U;
    for (uint32_t i = 0; i < outputs.event_count; i++) {
        exchange_push_event(exchange, &outputs.events[i], utc_us);
    }
    /* A source that has an answer finds its event in the log. */
    for (uint32_t i = 0; i < outputs.answer_count; i++) {
        (void)exchange_push_answer(exchange, &outputs.answers[i]);
    }
    record_cycle(cycle);
    exchange_beat(exchange, EXCHANGE_CONTROL);
}

/* Once a second of the world's time, which is looked at for nothing else. */
static void publish_figures(void)
{
    const uint64_t world_ns = realtime_now_ns();
    const uint64_t elapsed_ns = world_ns - world_ns_reported;
    if (elapsed_ns >= FIGURES_NS) {
        const uint64_t board_ns = bsp_reached_ns();
        figures_publish(&figures, &published);
        published.overruns = controller.loop.sealed.overruns;
        published.cycles_lost = lane.lost;
        published.speed_permille =
            (uint32_t)(((board_ns - board_ns_reported) * 1000U) / elapsed_ns);
        computer_look(&computer, &published);
        computer_report_wake_up(&computer, &published);
        exchange_publish_loop(exchange, &published);
        board_ns_reported = board_ns;
        world_ns_reported = world_ns;
    }
}

/* The state before this cycle, for a recorder that begins or has lost cycles. */
static void record_checkpoint(bool is_resuming)
{
    const bool is_requested = exchange_take_checkpoint_request(exchange);
    if ((is_requested || is_resuming || (controller.sealed.cycle == 0U)) && !lane.is_gap) {
        (void)exchange_push_checkpoint(exchange, &controller);
    }
}

/*
 * The outputs for the inputs of a cycle leave in the same cycle.
 *
 * @satisfies SWR-CTRL-012
 * @satisfies SWR-CTRL-013
 */
static void run_cycle(uint64_t deadline_ns, uint64_t woken_ns, uint64_t elapsed_ns)
{
    const uint32_t cycle = controller.sealed.cycle;
    const bool is_resuming = cycle_lane_look(&lane, exchange);
    stage_ns[LOOP_STAGE_WAKE] = woken_ns - deadline_ns; /* It is part of what has elapsed. */
    gather_inputs(elapsed_ns);
    record_checkpoint(is_resuming);
    const uint64_t gathered_ns = bsp_now_ns();
    controller_step(&controller, our_robot, &inputs, &outputs);
    const uint64_t stepped_ns = bsp_now_ns();
    /* C99 adds no const through an array pointer by itself. */
    bsp_start(outputs.frames_to_send, (const uint8_t(*)[CARD_FRAME_BYTES])outputs.frames);
    const uint64_t sent_ns = bsp_now_ns();
    bsp_set_lamps(lamps_of(&outputs.snapshot));
    publish(cycle);
    publish_figures();
    stage_ns[LOOP_STAGE_CARDS] = (gathered_ns - woken_ns) + (sent_ns - stepped_ns);
    stage_ns[LOOP_STAGE_STEP] = stepped_ns - gathered_ns;
    stage_ns[LOOP_STAGE_PUBLISH] = bsp_now_ns() - sent_ns;
    figures_add(&figures, stage_ns);
}

/* Missed wake-ups are skipped, never caught up. */
static uint64_t next_deadline(uint64_t deadline_ns)
{
    const uint64_t now_ns = bsp_now_ns();
    uint64_t next_ns = deadline_ns + CYCLE_NS;
    if (next_ns < now_ns) {
        next_ns += ((now_ns - next_ns) / CYCLE_NS + 1U) * CYCLE_NS;
    }
    return next_ns;
}

static void begin_figures(uint32_t rights)
{
    if (!board.is_simulated) {
        (void)realtime_stay_awake("");
    }
    computer_begin(&computer, "", rights);
    published.rights = rights;
    published.computer = computer.lacks;
    published.is_elastic = board.is_elastic ? 1U : 0U;
    published.slowness = board.slowness;
    published.speedup = board.speedup;
    published.speed_permille = 1000U / board.slowness;
    board_ns_reported = bsp_reached_ns();
    world_ns_reported = realtime_now_ns();
    exchange_publish_loop(exchange, &published);
}

/*
 * The cycle that ends now was whole, as it came here.
 *
 * @satisfies SWR-BSP-006
 */
static void kick(uint64_t deadline_ns)
{
    const bool was_punctual = inputs.elapsed_us <= LIMIT_OVERRUN_US;
    if (was_punctual && (bsp_now_ns() < (deadline_ns + CYCLE_NS))) {
        bsp_kick();
    }
}

/*
 * Asked between two cycles: nothing begins before it ends.
 *
 * @satisfies SWR-PACK-014
 */
static bool ends_at_rest(void)
{
    return exchange_take_end_request(exchange) && rest_is_it(&outputs.snapshot);
}

/* @return whether it ends because it was at rest when it was asked to */
static bool run(void)
{
    bool is_at_rest = false;
    uint64_t deadline_ns = bsp_now_ns() + CYCLE_NS;
    uint64_t before_ns = deadline_ns - CYCLE_NS;
    while ((stopped_by == 0) && !is_at_rest) {
        if (board.is_elastic) {
            cycle_lane_wait(&lane, exchange, &stopped_by);
        }
        bsp_sleep_until_ns(deadline_ns);
        const uint64_t woken_ns = bsp_now_ns();
        run_cycle(deadline_ns, woken_ns, woken_ns - before_ns);
        kick(deadline_ns);
        is_at_rest = ends_at_rest();
        before_ns = woken_ns;
        deadline_ns = next_deadline(deadline_ns);
    }
    return is_at_rest;
}

/*
 * The cards of two robots may look alike.
 *
 * @satisfies SWR-ROBOT-019
 */
static bool is_box_of_robot(const char *box)
{
    const bool is_of_it = (board.robot_crc == 0U) || (board.robot_crc == our_robot->crc);
    if (!is_of_it) {
        (void)fprintf(stderr,
                      "control: the box \"%s\" is not that of this robot %s; start the box with "
                      "--robot %s, or choose its robot.\n",
                      box, our_robot->name, our_robot->name);
    }
    return is_of_it;
}

/* The state that the first checkpoint holds: what was kept is part of it. */
static void begin_controller(const char *path)
{
    const position_asker_t asker = {.utc_us = clock_utc_us(),
                                    .robot_crc = our_robot->crc,
                                    .power_on = board.power_on,
                                    .was_used = board.was_used};
    kept_positions_t kept;
    position_store_ask(path, &asker, &kept);
    if (kept.verdict >= (uint32_t)KEPT_MISSING) {
        (void)fprintf(
            stderr,
            "control: the kept positions (%s) %s; compare every axis with the robot, home "
            "it, or confirm its position.\n",
            path, position_store_why(kept.verdict));
    }
    controller_init(&controller, our_robot);
    controller_restore(&controller, &kept);
}

static bool hold_trajectory(const char *path)
{
    char error[512] = "";
    const bool is_held =
        (path == NULL) || list_file_take(&controller, our_robot, path, error, sizeof error);
    if (!is_held) {
        (void)fprintf(stderr, "control: %s.\n", error);
    }
    return is_held;
}

/*
 * The log names the person who has accepted such cards.
 *
 * @satisfies SWR-NI-012
 */
static void report_dialect(void)
{
    if (board.dialect != (uint32_t)CARD_DIALECT_OWN) {
        (void)fprintf(stderr,
                      "control: the cards have no watchdog, echo, sequence or CRC; accepted by: "
                      "%s.\n",
                      (board.accepted[0] != '\0') ? board.accepted : "nobody, and nothing moves");
    }
}

/* A process that shows them does not ask the board. */
static void publish_cards(void)
{
    exchange_cards_t cards = {.dialect = board.dialect};

    (void)snprintf(cards.accepted, sizeof cards.accepted, "%s", board.accepted);
    exchange_publish_cards(exchange, &cards);
}

/*
 * With drives off, before the first cycle.
 *
 * @satisfies SWR-BSP-003
 */
static bool test_board(void)
{
    char error[256] = "";
    const bool is_good = bsp_self_test(error, sizeof error);
    if (!is_good) {
        (void)fprintf(stderr, "control: %s\n", error);
        switch_off("the self test of the board has failed");
    }
    return is_good;
}

/* Runs with its options until a signal or a request ends it. @return the exit code */
static int control(const char *const values[])
{
    char error[256] = "";
    char why[40];
    exchange = exchange_open(values[INSTANCE], error, sizeof error);
    if ((exchange == NULL) || !bsp_open(values[BOX], &board, error, sizeof error)) {
        (void)fprintf(stderr, "control: %s\n", error);
        return EXIT_CANNOT_START;
    }
    if (!is_box_of_robot(values[BOX])) {
        bsp_close();
        return EXIT_CANNOT_START;
    }
    report_dialect();
    handle_signals();
    publish_cards();
    exchange_publish_robot(exchange, our_robot);
    begin_controller(values[POSITIONS]);
    if (!hold_trajectory(values[TRAJECTORY])) {
        bsp_close();
        return EXIT_CANNOT_START;
    }
    exchange_publish_rows(exchange, &controller, &outputs);
    int code = EXIT_CANNOT_START;
    if (test_board()) {
        const uint32_t rights = realtime_acquire();
        exchange_touch(exchange);
        begin_figures(rights);
        if (board.speedup > 1U) {
            realtime_give_way();
        }
        code = run() ? REST_EXIT : EXIT_SUCCESS;
        if (code == REST_EXIT) {
            (void)snprintf(why, sizeof why, "asked to end at rest");
        } else {
            (void)snprintf(why, sizeof why, "asked to end by signal %d", (int)stopped_by);
        }
        switch_off(why);
    }
    bsp_close();
    exchange_close(exchange);
    return code;
}

int main(int argc, char *argv[])
{
    const char *values[OPTIONS];
    const int code = command_line_read(&command_line, argc, argv, values, NULL);
    if (code != COMMAND_LINE_GO_ON) {
        return code;
    }
    our_robot = robots_find(values[ROBOT]);
    if (our_robot == NULL) {
        return command_line_refuse(&command_line,
                                   "There is no robot \"%s\"; choose %s with --robot.",
                                   values[ROBOT], robot_names_list());
    }
    return control(values);
}
