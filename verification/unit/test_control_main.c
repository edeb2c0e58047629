/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Rule under test: however the loop of control ends, its own main sends "off" to every card, with a
 * sequence that they have not seen, whatever was about to be sent. Each case runs main in a child.
 */
#include "unity.h"

#include "card/card_frame.h"
#include "common/clock.h"
#include "common/command_line.h"
#include "control/drives_off.h"
#include "control/figures.h"
#include "control/sources.h"
#include "exchange/exchange.h"
#include "exchange/exchange_rows.h"
#include "exchange/exchange_segment.h"
#include "mock_bsp.h"
#include "mock_controller.h"
#include "mock_list_file.h"
#include "mock_realtime.h"
#include "positions/position_record.h"
#include "robot/robot_neuro.h"

#include <sys/mman.h>
#include <sys/wait.h>

#define main control_main
#include "control_main.c"
#undef main

TEST_SOURCE_FILE("crc.c")
TEST_SOURCE_FILE("robot_cards.c")
TEST_SOURCE_FILE("position_store.c")
TEST_SOURCE_FILE("position_record.c")
TEST_SOURCE_FILE("sources.c")

#define ALL_SLOTS 0x0FEU
#define LAST_CYCLE 20U
#define MOST_EXCHANGES 64U
#define TEXT_SIZE 1024U

/* What happens in the last cycle. */
typedef enum { BY_CONTRACT = 0, BY_SIGNAL = 1 } end_t;

/* What the cards heard in one exchange. */
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
} record_t;

static char name[48];
static exchange_t *segment;
static record_t *record;
static end_t end;
static int end_signal;
static bool is_box_lost;
static uint64_t now_ns;
static card_command_t before[CARD_SLOT_COUNT];
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
static uint32_t exchange_all(uint32_t send, const uint8_t frames[CARD_SLOT_COUNT][CARD_FRAME_BYTES],
                             uint8_t received[CARD_SLOT_COUNT][CARD_FRAME_BYTES],
                             uint32_t timeout_us, int calls)
{
    heard_t *const heard = &record->heard[record->count % MOST_EXCHANGES];
    (void)timeout_us;
    (void)calls;
    *heard = (heard_t){.lowest_sequence = UINT32_MAX};
    for (uint32_t slot = 0U; slot < CARD_SLOT_COUNT; slot++) {
        card_command_t command;
        report(slot, received[slot]);
        if (((send & (1U << slot)) == 0U) ||
            (card_frame_decode_command(frames[slot], slot, &command) != CARD_FRAME_OK)) {
            continue;
        }
        before[slot] = command;
        heard->slots |= 1U << slot;
        heard->driving |= (command.drive.mode != (uint32_t)CARD_DRIVE_OFF) ? (1U << slot) : 0U;
        if (command.sequence < heard->lowest_sequence) {
            heard->lowest_sequence = command.sequence;
        }
        if (command.sequence > heard->highest_sequence) {
            heard->highest_sequence = command.sequence;
        }
    }
    record->count++;
    return is_box_lost ? 0U : send;
}

/* A controller that drives everything, and in whose last cycle something happens. */
static void step(controller_t *self, const robot_t *robot, const controller_inputs_t *given,
                 controller_outputs_t *made, int calls)
{
    (void)calls;
    made->frames_to_send = 0U;
    if ((self->cycle == LAST_CYCLE) && (end == BY_CONTRACT)) {
        contract_broken("controller", 100U);
    }
    if (self->cycle == LAST_CYCLE) {
        record->frames_received = given->frames_received;
        (void)raise(end_signal);
    }
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const card_command_t command = {.slot = robot->axes[i].slot,
                                        .sequence = self->sequence,
                                        .drive.mode = (uint32_t)CARD_DRIVE_NON_PWM};
        card_frame_encode_command(&command, made->frames[command.slot]);
        made->frames_to_send |= 1U << command.slot;
    }
    self->sequence++;
    self->cycle++;
}

static bsp_power_on_t tell_power_on(int calls)
{
    (void)calls;
    return (bsp_power_on_t){.id = 1U, .was_used = false};
}

static uint32_t board_robot_crc; /* 0: the board cannot tell. */

static uint32_t tell_robot(int calls)
{
    (void)calls;
    return board_robot_crc;
}

/* Words with and without the option of a trajectory. */
#define WITHOUT_LIST 9
#define WITH_LIST 11

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
    self->sequence = 100U;
}

static bool open_board(const char *box, char *error, uint32_t error_size, int calls)
{
    (void)box;
    (void)error;
    (void)error_size;
    (void)calls;
    return true;
}

static bsp_inputs_t sample(int calls)
{
    const bsp_inputs_t levels = {.pedal_a = true, .pedal_b = true};
    (void)calls;
    return levels;
}

static bsp_time_t tell_time(int calls)
{
    const bsp_time_t time = {.is_elastic = true, .slowness = 1U};
    (void)calls;
    return time;
}

static uint64_t tell_now(int calls)
{
    (void)calls;
    return now_ns;
}

static void sleep_until(uint64_t deadline_ns, int calls)
{
    (void)calls;
    now_ns = deadline_ns;
}

static void close_board(int calls)
{
    (void)calls;
}

static uint32_t acquire(int calls)
{
    (void)calls;
    return 0U;
}

void setUp(void)
{
    char error[200] = "";
    record = mmap(NULL, sizeof *record, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    TEST_ASSERT_NOT_EQUAL(MAP_FAILED, record);
    is_box_lost = false;
    (void)snprintf(name, sizeof name, "boresight-test-main-%d", (int)getpid());
    segment = exchange_create(name, error, sizeof error);
    TEST_ASSERT_NOT_NULL_MESSAGE(segment, error);
    bsp_open_Stub(open_board);
    bsp_exchange_Stub(exchange_all);
    bsp_sample_inputs_Stub(sample);
    bsp_time_Stub(tell_time);
    bsp_now_ns_Stub(tell_now);
    bsp_reached_ns_Stub(tell_now);
    bsp_sleep_until_ns_Stub(sleep_until);
    bsp_close_Stub(close_board);
    bsp_power_on_Stub(tell_power_on);
    bsp_robot_crc_Stub(tell_robot);
    board_robot_crc = 0U;
    controller_init_Stub(init);
    controller_restore_Stub(restore);
    controller_step_Stub(step);
    list_file_take_Stub(take_list);
    list_count = WITHOUT_LIST;
    realtime_acquire_Stub(acquire);
    realtime_now_ns_Stub(tell_now);
}

void tearDown(void)
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
static void expect_off(uint32_t count)
{
    TEST_ASSERT_GREATER_THAN_UINT32(count, record->count);
    TEST_ASSERT_LESS_OR_EQUAL_UINT32(MOST_EXCHANGES, record->count);
    const uint32_t first = record->count - count;
    TEST_ASSERT_EQUAL_HEX32(ALL_SLOTS, record->heard[first - 1U].driving); /* It mattered. */
    for (uint32_t i = first; i < record->count; i++) {
        TEST_ASSERT_EQUAL_HEX32(ALL_SLOTS, record->heard[i].slots);
        TEST_ASSERT_EQUAL_HEX32(0U, record->heard[i].driving);
        TEST_ASSERT_GREATER_THAN_UINT32(record->heard[i - 1U].highest_sequence,
                                        record->heard[i].lowest_sequence);
    }
}

void test_SWR_CTRL_010_a_contract_broken_inside_a_cycle_sends_off_to_every_card(void)
{
    const int status = control_ends(BY_CONTRACT, 0);
    TEST_ASSERT_TRUE(WIFEXITED(status));
    TEST_ASSERT_EQUAL_INT(EXIT_CONTRACT, WEXITSTATUS(status));
    expect_off(2U); /* The second one confirms. */
    TEST_ASSERT_EQUAL_STRING("control: contract controller/100 is broken, report this; all 7 cards "
                             "confirm that their drive is off.\n",
                             said);
}

void test_SWR_CTRL_010_every_signal_that_ends_the_loop_sends_off_to_every_card(void)
{
    static const int signals[] = {SIGUSR1, SIGUSR2, SIGHUP, SIGINT, SIGTERM, SIGPIPE, SIGALRM};
    for (size_t i = 0U; i < (sizeof signals / sizeof signals[0]); i++) {
        record->count = 0U;
        const int status = control_ends(BY_SIGNAL, signals[i]);
        TEST_ASSERT_TRUE(WIFEXITED(status));
        TEST_ASSERT_EQUAL_INT(0, WEXITSTATUS(status));
        expect_off(2U);
        TEST_ASSERT_NOT_NULL(strstr(said, "all 7 cards confirm"));
    }
}

void test_SWR_CTRL_010_a_crash_sends_off_to_every_card_and_stays_a_crash(void)
{
    static const int signals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};
    for (size_t i = 0U; i < (sizeof signals / sizeof signals[0]); i++) {
        record->count = 0U;
        const int status = control_ends(BY_SIGNAL, signals[i]);
        TEST_ASSERT_TRUE(WIFSIGNALED(status));
        TEST_ASSERT_EQUAL_INT(signals[i], WTERMSIG(status));
        expect_off(2U);
        TEST_ASSERT_NOT_NULL(strstr(said, "crashed by signal"));
    }
}

void test_SWR_TRAJ_020_a_trajectory_that_is_refused_is_told_and_nothing_starts(void)
{
    list_count = WITH_LIST;
    const int status = control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_TRUE(WIFEXITED(status));
    TEST_ASSERT_EQUAL_INT(EXIT_CANNOT_START, WEXITSTATUS(status));
    TEST_ASSERT_NOT_NULL_MESSAGE(strstr(said, "control: the trajectory list, line 3: no.\n"), said);
    TEST_ASSERT_EQUAL_UINT32(0U, record->count);
}

void test_SWR_ROBOT_019_the_box_of_this_robot_is_taken(void)
{
    board_robot_crc = robot_neuro.crc;
    const int status = control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_EQUAL_INT(0, WEXITSTATUS(status));
    expect_off(2U);
}

void test_SWR_ROBOT_019_the_box_of_another_robot_hears_nothing(void)
{
    board_robot_crc = robot_neuro.crc ^ 1U;
    const int status = control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_TRUE(WIFEXITED(status));
    TEST_ASSERT_EQUAL_INT(EXIT_CANNOT_START, WEXITSTATUS(status));
    TEST_ASSERT_EQUAL_UINT32(0U, record->count);
    TEST_ASSERT_NOT_NULL(strstr(said, "the box \"y\" is not that of this robot neuro"));
}

void test_SWR_CTRL_010_a_box_that_answers_nothing_is_told_off_and_nothing_is_claimed(void)
{
    is_box_lost = true;
    const int status = control_ends(BY_SIGNAL, SIGTERM);
    TEST_ASSERT_TRUE(WIFEXITED(status));
    TEST_ASSERT_EQUAL_UINT32(0U, record->frames_received); /* The controller was told nothing. */
    expect_off(LIMIT_OFF_EXCHANGES);
    TEST_ASSERT_NOT_NULL(strstr(said, "\"off\" was sent to all 7 cards, 0 confirm it"));
}

void test_SWR_LOOP_005_cycles_are_counted_by_how_long_each_stage_took(void)
{
    static figures_t counted;
    static const uint64_t steps_us[] = {0U, 1U, 2U, 3U, 4U, 2047U, 2048U, 5000U};
    static const uint32_t bars[] = {0U, 1U, 2U, 2U, 3U, 11U, 12U, 12U};
    loop_figures_t told = {0};
    uint32_t expected[LIMIT_LOOP_BARS] = {0};
    (void)memset(&counted, 0, sizeof counted);
    for (uint32_t i = 0U; i < (sizeof bars / sizeof bars[0]); i++) {
        const uint64_t took_ns[LOOP_STAGE_COUNT] = {[LOOP_STAGE_STEP] = steps_us[i] * 1000U};
        expected[bars[i]]++;
        figures_add(&counted, took_ns);
        figures_publish(&counted, &told);
    }
    TEST_ASSERT_EQUAL_UINT32_ARRAY(expected, told.stages[LOOP_STAGE_STEP].counts, LIMIT_LOOP_BARS);
    TEST_ASSERT_EQUAL_UINT32(5000U, told.stages[LOOP_STAGE_STEP].worst_us);
    TEST_ASSERT_EQUAL_UINT32(8U, told.stages[LOOP_STAGE_WAKE].counts[0]);
    TEST_ASSERT_EQUAL_UINT32(0U, told.stages[LOOP_STAGE_PUBLISH].worst_us);
}
