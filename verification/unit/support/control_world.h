/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Main of control in a child process, on a mocked board and controller whose calls are recorded in
 * shared memory.
 */
#ifndef BORESIGHT_CONTROL_WORLD_H
#define BORESIGHT_CONTROL_WORLD_H

#include "unity.h"
#include "card/aim32_frame.h"
#include "card/card_frame.h"
#include "exchange/exchange.h"
#include "exchange/exchange_cycles.h"
#include "exchange/exchange_segment.h"
#include "robot/robot_neuro.h"

#include <sys/mman.h>
#include <sys/wait.h>

#define main control_main
#include "control_main.c"
#undef main

#define ALL_SLOTS 0x0FEU
#define LAST_CYCLE 20U
#define MOST_EXCHANGES 64U
#define TEXT_SIZE 1024U

/* End of the last cycle. */
typedef enum { BY_CONTRACT = 0, BY_SIGNAL = 1, BY_REQUEST = 2 } end_t;

/* Frames that the cards received in one exchange. */
typedef struct {
    uint32_t slots;
    uint32_t driving;
    uint32_t lowest_sequence;
    uint32_t highest_sequence;
} heard_t;

/* Shared with the child. */
typedef struct {
    uint32_t count;
    heard_t heard[MOST_EXCHANGES];
    uint32_t frames_received; /* By the controller, in the last cycle. */
    uint32_t lines;           /* How often the amplifier-off line was set, */
    uint32_t before_line;     /* and how many exchanges were begun before. */
    uint32_t under_way;       /* Exchanges that were begun and not ended. */
    uint32_t most_under_way;
    uint32_t kicks;
    uint32_t lamps;      /* That were lit last. */
    uint32_t awake;      /* How often control has asked for no deep sleep. */
    uint32_t last_cycle; /* While it is asked to end at rest. */
    uint32_t unfit;      /* Input of the controller in the last cycle. */
    uint32_t dialect;
    uint32_t is_dialect_accepted;
    uint32_t is_recorder_failing;
    uint32_t lacks_black_box;
    uint32_t recording_left_min;
    uint32_t cycles_lost;   /* Input of the controller in the last cycle. */
    uint32_t late_stage[2]; /* Its input in the last two cycles, */
    uint32_t elapsed_us[2]; /* the same. */
    uint32_t silent_us;     /* For which it has not heard http, in the last cycle. */
    uint32_t ways_given;    /* How often it gave its real-time priority back. */
    uint64_t stood_ns;      /* The world's time in which control let the board stand still. */
} record_t;

static char name[48];
static exchange_t *segment;
static record_t *record;
static end_t end;
static int end_signal;
static bsp_slot_result_t fate; /* Result of all frames. */
static bool is_board_there;
static bool is_wire_good;
static bool is_simulated;
static bool is_elastic;
static uint32_t speedup;
static uint32_t read_in; /* The cycle in which the recorder reads all that waits. */
static card_dialect_t dialect;
static const char *accepted;
static uint64_t late_ns;      /* How much later than asked for each cycle wakes up, */
static bool is_late_at_times; /* or only every other one. */
static uint64_t cards_ns;     /* How long its inputs take. */
static uint64_t now_ns;
static card_command_t before[CARD_SLOT_COUNT];
static uint8_t reports[CARD_SLOT_COUNT][CARD_FRAME_BYTES]; /* On their way back. */
static uint32_t asked;
static char said[TEXT_SIZE];

const robot_t *robots_find(const char *wanted)
{
    return (strcmp(wanted, robot_neuro.name) == 0) ? &robot_neuro : NULL;
}

const char *robot_names_list(void)
{
    return "neuro";
}

static void report(uint32_t slot, uint8_t bytes[CARD_FRAME_BYTES])
{
    const card_report_t made = {
        .slot = slot, .accepted_sequence = before[slot].sequence, .applied = before[slot].drive};
    card_frame_encode_report(&made, bytes);
}

/* A report is from before the frame is heard. */
static void hear(heard_t *heard, uint32_t slot, const uint8_t frame[CARD_FRAME_BYTES])
{
    card_command_t command;
    if (card_frame_decode_command(frame, slot, &command) != CARD_FRAME_OK) {
        return;
    }
    before[slot] = command;
    heard->slots |= 1U << slot;
    heard->driving |= (command.drive.mode != (uint32_t)CARD_DRIVE_OFF) ? (1U << slot) : 0U;
    heard->lowest_sequence =
        (command.sequence < heard->lowest_sequence) ? command.sequence : heard->lowest_sequence;
    heard->highest_sequence =
        (command.sequence > heard->highest_sequence) ? command.sequence : heard->highest_sequence;
}

static void start(uint32_t send, const uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES], int calls)
{
    heard_t *const heard = &record->heard[record->count % MOST_EXCHANGES];
    (void)calls;
    *heard = (heard_t){.lowest_sequence = UINT32_MAX};
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        report(slot, reports[slot]);
        if ((send & (1U << slot)) != 0U) {
            hear(heard, slot, frames[slot]);
        }
    }
    asked = send;
    record->count++;
    record->under_way++;
    record->most_under_way =
        (record->under_way > record->most_under_way) ? record->under_way : record->most_under_way;
}

static void finish(uint64_t deadline_ns, uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES],
                   bsp_exchange_t *result, int calls)
{
    (void)calls;
    TEST_ASSERT_EQUAL_UINT64(now_ns + (UINT64_C(1000) * LIMIT_EXCHANGE_TIMEOUT_US), deadline_ns);
    *result = (bsp_exchange_t){.received = (fate == BSP_SLOT_OK) ? asked : 0U};
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        if ((result->received & (1U << slot)) != 0U) {
            (void)memcpy(received[slot], reports[slot], CARD_FRAME_BYTES);
        }
        result->results[slot] =
            (uint8_t)(((asked & (1U << slot)) != 0U) ? fate : BSP_SLOT_NOT_SENT);
    }
    asked = 0U;
    record->under_way = 0U;
}

static void switch_line_off(int calls)
{
    (void)calls;
    record->lines++;
    record->before_line = record->count;
}

static bool try_wires(char *error, uint32_t error_size, int calls)
{
    (void)calls;
    if (!is_wire_good) {
        (void)snprintf(error, error_size, "the wire of slot 3 is shifted by a bit; slow it down.");
    }
    return is_wire_good;
}

static void kick_watchdog(int calls)
{
    (void)calls;
    record->kicks++;
}

static void light(uint32_t lamps, int calls)
{
    (void)calls;
    record->lamps = lamps;
}

/* Reasons for which control goes on. */
typedef enum { BUSY_DRIVE = 0, BUSY_ORDER = 1, BUSY_WORKPHASE = 2, BUSY_KINDS = 3 } busy_t;

#define BUSY_CYCLES 5U

static busy_t busy;

/* Asked to end while something is under way, and again when nothing is. */
static void ask_to_end(uint32_t cycle, snapshot_t *snapshot)
{
    const bool is_busy = cycle < (LAST_CYCLE + BUSY_CYCLES);
    record->last_cycle = cycle;
    snapshot->axis_count = 2U;
    snapshot->axes[1].drive_mode =
        (is_busy && (busy == BUSY_DRIVE)) ? (uint32_t)CARD_DRIVE_PWM : (uint32_t)CARD_DRIVE_OFF;
    snapshot->order = (is_busy && (busy == BUSY_ORDER)) ? (uint32_t)ARMING_STATE_WAITING
                                                        : (uint32_t)ARMING_STATE_NONE;
    snapshot->workphase = (is_busy && (busy == BUSY_WORKPHASE)) ? (uint32_t)WORKPHASE_PLANNING
                                                                : (uint32_t)WORKPHASE_START_UP;
    if ((cycle == LAST_CYCLE) || (cycle == (LAST_CYCLE + (2U * BUSY_CYCLES)))) {
        exchange_request_end(segment);
    }
    if (cycle == (LAST_CYCLE + (3U * BUSY_CYCLES))) {
        (void)raise(SIGTERM);
    }
}

#define LANE 8U /* Entries, */
#define NEVER (LAST_CYCLE + 1U)

static void read_all(uint32_t cycle)
{
    static cycle_record_t taken;
    if (cycle == read_in) {
        while (exchange_take_cycle(segment, &taken)) {
        }
        exchange_release_cycles(segment, exchange_cycles_taken(segment));
    }
}

/* A controller that drives everything, and in whose last cycle something happens. */
static void step(controller_t *self, const robot_t *robot, const controller_inputs_t *given,
                 controller_outputs_t *made, int calls)
{
    (void)calls;
    made->frames_to_send = 0U;
    record->late_stage[self->sealed.cycle % 2U] = given->late_stage;
    record->elapsed_us[self->sealed.cycle % 2U] = given->elapsed_us;
    read_all(self->sealed.cycle);
    if ((self->sealed.cycle == LAST_CYCLE) && (end == BY_CONTRACT)) {
        contract_broken("controller", 100U);
    }
    if (end == BY_REQUEST) {
        ask_to_end(self->sealed.cycle, &made->snapshot);
    } else if (self->sealed.cycle == LAST_CYCLE) {
        record->frames_received = given->frames_received;
        record->unfit = given->unfit;
        record->silent_us = sources.silent_us[COMMAND_SOURCE_HTTP];
        record->is_recorder_failing = given->is_recorder_failing;
        record->lacks_black_box = given->lacks_black_box;
        record->recording_left_min = given->recording_left_min;
        record->cycles_lost = given->cycles_lost;
        record->dialect = given->dialect;
        record->is_dialect_accepted = given->is_dialect_accepted;
        (void)raise(end_signal);
    } else {
        /* It goes on. */
    }
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const card_command_t command = {.slot = robot->axes[i].slot,
                                        .sequence = self->sealed.sequence,
                                        .drive.mode = (uint32_t)CARD_DRIVE_NON_PWM};
        card_frame_encode_command(&command, made->frames[command.slot]);
        made->frames_to_send |= 1U << command.slot;
    }
    self->sealed.sequence++;
    self->sealed.cycle++;
}

static uint32_t board_robot_crc; /* 0: the board does not know it. */

/* Words with and without the option of a trajectory. */
#define WITHOUT_LIST 9

static int list_count;

static bool take_list(controller_t *self, const robot_t *robot, const char *path, char *text,
                      uint32_t size, int calls)
{
    (void)self;
    (void)robot;
    (void)calls;
    (void)snprintf(text, size, "the trajectory %s, line 3: no", path);
    return false;
}

static void restore(controller_t *self, const kept_positions_t *kept, int calls)
{
    (void)self;
    (void)kept;
    (void)calls;
}

static void init(controller_t *self, const robot_t *robot, int calls)
{
    (void)robot;
    (void)calls;
    self->sealed.sequence = 100U;
}

static bool open_board(const char *box, bsp_identity_t *identity, char *error, uint32_t error_size,
                       int calls)
{
    (void)box;
    (void)calls;
    *identity = (bsp_identity_t){.power_on = 1U,
                                 .robot_crc = board_robot_crc,
                                 .is_elastic = is_elastic,
                                 .is_simulated = is_simulated,
                                 .slowness = 1U,
                                 .speedup = speedup,
                                 .dialect = (uint32_t)dialect};
    (void)snprintf(identity->accepted, sizeof identity->accepted, "%s", accepted);
    if (!is_board_there) {
        (void)snprintf(error, error_size, "switch the box on");
    }
    return is_board_there;
}

static void sample(bsp_inputs_t *levels, int calls)
{
    (void)calls;
    *levels = (bsp_inputs_t){.levels = BSP_IN_ALL, .valid = BSP_IN_ALL};
    now_ns += cards_ns;
}

static uint64_t tell_now(int calls)
{
    (void)calls;
    return now_ns;
}

static uint64_t tell_world(int calls)
{
    (void)calls;
    return now_ns + record->stood_ns;
}

static void stand_still(uint64_t world_ns, int calls)
{
    (void)calls;
    record->stood_ns += world_ns;
}

static void sleep_until(uint64_t deadline_ns, int calls)
{
    now_ns = deadline_ns + ((is_late_at_times && ((calls % 2) == 0)) ? 0U : late_ns);
}

static void close_board(int calls)
{
    (void)calls;
}

#define RIGHTS 5U
#define LACKS 3U

static uint32_t acquire(int calls)
{
    (void)calls;
    return RIGHTS;
}

static void give_way(int calls)
{
    (void)calls;
    record->ways_given++;
}

static bool stay_awake(const char *root, int calls)
{
    (void)calls;
    record->awake += (root[0] == '\0') ? 1U : 0U;
    return true;
}

static void begin_computer(computer_t *self, const char *root, uint32_t rights, int calls)
{
    (void)calls;
    self->lacks = ((rights == RIGHTS) && (root[0] == '\0')) ? LACKS : 0U;
}

static void look_at_computer(computer_t *self, loop_figures_t *figures_told, int calls)
{
    (void)calls;
    figures_told->computer = self->lacks;
}

static void tell_wake_up(computer_t *self, const loop_figures_t *figures_told, int calls)
{
    (void)self;
    (void)figures_told;
    (void)calls;
}

static void begin_control(void)
{
    char error[200] = "";
    record = mmap(NULL, sizeof *record, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    TEST_ASSERT_NOT_EQUAL(MAP_FAILED, record);
    fate = BSP_SLOT_OK;
    is_board_there = true;
    is_wire_good = true;
    is_simulated = true;
    is_elastic = true;
    speedup = 1U;
    read_in = NEVER;
    dialect = CARD_DIALECT_OWN;
    accepted = "";
    late_ns = 0U;
    is_late_at_times = false;
    cards_ns = 0U;
    (void)snprintf(name, sizeof name, "boresight-test-main-%d", (int)getpid());
    segment = exchange_create(name, LANE, error, sizeof error);
    TEST_ASSERT_NOT_NULL_MESSAGE(segment, error);
    bsp_open_Stub(open_board);
    bsp_self_test_Stub(try_wires);
    bsp_start_Stub(start);
    bsp_finish_Stub(finish);
    bsp_sample_inputs_Stub(sample);
    bsp_set_lamps_Stub(light);
    bsp_drives_off_Stub(switch_line_off);
    bsp_kick_Stub(kick_watchdog);
    bsp_now_ns_Stub(tell_now);
    bsp_reached_ns_Stub(tell_now);
    bsp_sleep_until_ns_Stub(sleep_until);
    bsp_stand_still_ns_Stub(stand_still);
    bsp_close_Stub(close_board);
    board_robot_crc = 0U;
    controller_init_Stub(init);
    controller_restore_Stub(restore);
    controller_step_Stub(step);
    list_file_take_Stub(take_list);
    list_count = WITHOUT_LIST;
    realtime_acquire_Stub(acquire);
    realtime_stay_awake_Stub(stay_awake);
    realtime_give_way_Stub(give_way);
    computer_begin_Stub(begin_computer);
    computer_look_Stub(look_at_computer);
    computer_tell_wake_up_Stub(tell_wake_up);
    realtime_now_ns_Stub(tell_world);
}

static void end_control(void)
{
    exchange_close(segment);
    (void)munmap(record, sizeof *record);
}

/* Runs control until `how` and `signal_number` end it. @return as waitpid() gives it */
static int control_ends(end_t how, int signal_number)
{
    char *arguments[] = {"control", "--robot",     "neuro",   "--instance",   name,  "--box",
                         "y",       "--positions", "no-file", "--trajectory", "list"};
    int ends[2];
    int status = 0;
    end = how;
    end_signal = signal_number;
    TEST_ASSERT_EQUAL_INT(0, pipe(ends));
    const pid_t child = fork();
    if (child == 0) {
        (void)dup2(ends[1], STDERR_FILENO);
        _Exit(control_main(list_count, arguments));
    }
    (void)close(ends[1]);
    size_t length = 0U;
    ssize_t more = 1;
    while ((more > 0) && (length < (TEXT_SIZE - 1U))) {
        more = read(ends[0], &said[length], TEXT_SIZE - 1U - length);
        length += (more > 0) ? (size_t)more : 0U;
    }
    said[length] = '\0';
    (void)close(ends[0]);
    TEST_ASSERT_EQUAL_INT(child, waitpid(child, &status, 0));
    return status;
}

/* The first of `count` exchanges at the end that were "off" for all, each with a new sequence. */
static void expect_off_frames(uint32_t count)
{
    TEST_ASSERT_GREATER_OR_EQUAL_UINT32(count, record->count);
    TEST_ASSERT_LESS_OR_EQUAL_UINT32(MOST_EXCHANGES, record->count);
    const uint32_t first = record->count - count;
    for (uint32_t i = first; i < record->count; i++) {
        TEST_ASSERT_EQUAL_HEX32(ALL_SLOTS, record->heard[i].slots);
        TEST_ASSERT_EQUAL_HEX32(0U, record->heard[i].driving);
        TEST_ASSERT_TRUE((i == 0U) || (record->heard[i].lowest_sequence >
                                       record->heard[i - 1U].highest_sequence));
    }
    TEST_ASSERT_EQUAL_UINT32(1U, record->lines);
    TEST_ASSERT_EQUAL_UINT32(first, record->before_line); /* It comes first. */
    TEST_ASSERT_EQUAL_UINT32(1U, record->most_under_way);
}

static void expect_off(uint32_t count)
{
    TEST_ASSERT_GREATER_THAN_UINT32(count, record->count);
    TEST_ASSERT_EQUAL_HEX32(ALL_SLOTS,
                            record->heard[record->count - count - 1U].driving); /* It mattered. */
    expect_off_frames(count);
}

#endif
