/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * boresight-replay: verifies a recording and executes the controller on it again.
 *
 * Exit code 0: every output equal. 1: a difference. 2: damaged, unreadable, not holding the records
 * it announces, of another format, layout or robot, or nothing to replay. 3: every output equal,
 * but the recording is cut short. Tables and files, which are of the motion as replayed, end alike;
 * events and intervals, which are in the recording, end with 0, 2 or 3.
 */
#include "base/contract.h"
#include "common/command_line.h"
#include "recording/recording_reader.h"
#include "replay/board_table.h"
#include "replay/build_fit.h"
#include "replay/motion_csv.h"
#include "replay/motion_mcap.h"
#include "replay/new_file.h"
#include "replay/replay.h"
#include "replay/table.h"
#include "replay/what_if.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EXIT_EQUAL 0
#define EXIT_DIFFERENT 1
#define EXIT_REFUSED 2
#define EXIT_CUT_SHORT 3

enum { TABLE = 0, EVENTS, LOOP, BOARD, CSV, MCAP, WHAT_IF, OPTIONS };

static const command_option_t options[OPTIONS] = {
    [TABLE] = {"table", NULL, .says = "write the motion as comma-separated values instead"},
    [EVENTS] = {"events", NULL, .says = "write the events, a line each, instead"},
    [LOOP] = {"loop", NULL, .says = "write the interval of each cycle instead"},
    [BOARD] = {"board", NULL, .says = "write what the board said, a row for each cycle, instead"},
    [CSV] = {"csv", "FILE", .says = "write all that is known of the motion to a new FILE"},
    [MCAP] = {"mcap", "FILE", .says = "the same for Foxglove and PlotJuggler, with the events"},
    [WHAT_IF] = {"what-if", "CYCLES", .says = "say what differs if inputs had been others"},
};
static const command_line_t command_line = {
    .program = "boresight-replay",
    .says = "Verifies a recording and computes the motion of it again.",
    .usage = "[--table | --events | --loop | --board] RECORDING\n"
             "[--csv FILE | --mcap FILE] RECORDING\n"
             "--what-if CYCLE[-CYCLE] INPUT=VALUE... RECORDING",
    .options = options,
    .count = OPTIONS,
    .fewest_words = 1,
    .most_words = WHAT_IF_CHANGES + 1,
    .more = "FILE may be -, the standard output.\n"
            "Exit code 0: every output is equal. 1: there is a difference. 2: the command\n"
            "line is wrong, or the recording damaged, unreadable or not for this build. 3:\n"
            "every output is equal, but the recording is cut short.\n"};

static const robot_t *robot;
static recording_reader_t reader;
static replay_t replay;
static cycle_record_t record;
static cycle_known_t known;
static motion_csv_t csv;
static motion_mcap_t mcap;
static what_if_t what_if;
static uint64_t taken; /* Records read. */

void contract_broken(const char *module, uint32_t id)
{
    (void)printf("Cycle %u breaks contract %s/%u.\n", (unsigned)record.cycle, module, (unsigned)id);
    (void)fflush(stdout);
    _Exit(EXIT_DIFFERENT);
}

static recording_verdict_t verify(const char *path)
{
    recording_finding_t finding;
    const recording_verdict_t verdict = recording_reader_open(&reader, path, &finding);

    if (verdict != RECORDING_WHOLE) {
        (void)fprintf(stderr, "%s\n", finding.sentence);
    }
    return verdict;
}

static bool take_record(void)
{
    const bool is_taken = recording_reader_next(&reader, &record, &known);

    taken += is_taken ? 1U : 0U;
    return is_taken;
}

/* After the last record: says when the blocks do not hold what they announce. */
static bool check_end(void)
{
    if ((taken == reader.records) && (reader.raw_next == reader.raw_size) &&
        (reader.next == reader.end)) {
        return true;
    }
    (void)fflush(stdout);
    (void)fprintf(stderr,
                  "The blocks announce %" PRIu64 " records, %" PRIu64
                  " could be read; the recording cannot be trusted.\n",
                  reader.records, taken);
    return false;
}

/* After a difference of which only a hash was kept: what the next whole cycle shows, which comes
 * within a second. */
static void look_further(FILE *where)
{
    char difference[256];
    bool is_equal = true;

    known.is_whole = false;
    while (!known.is_whole && take_record() && (record.kind == (uint32_t)CYCLE_RECORD_CYCLE)) {
        is_equal = replay_take(&replay, robot, &record, &known);
    }
    if (!known.is_whole || !replay.is_running) {
        return; /* The recording ends before it, or has a gap or another state. */
    }
    if (is_equal) {
        (void)fprintf(where, "Cycle %" PRIu32 ", the next that was kept whole, is equal.\n",
                      record.cycle);
    } else {
        (void)replay_difference(&replay, &record, &known, difference, sizeof difference);
        (void)fprintf(where, "The next that was kept whole: %s\n", difference);
    }
}

static int tell_difference(FILE *where)
{
    char difference[256];
    const uint64_t equal = replay.replayed;
    const bool is_named =
        replay_difference(&replay, &record, &known, difference, sizeof difference);

    (void)fflush(stdout);
    (void)fprintf(where, "%s\n%" PRIu64 " cycles before it were equal.\n", difference, equal);
    if (!is_named) {
        look_further(where);
    }
    return EXIT_DIFFERENT;
}

static void tell_unreplayed(FILE *where)
{
    if (replay.unreplayed > 0U) {
        (void)fprintf(where,
                      "%" PRIu64 " cycles follow no checkpoint (%" PRIu32
                      " gaps) and were not replayed.\n",
                      replay.unreplayed, replay.gaps);
    }
}

static void tell_lost(FILE *where)
{
    if (reader.cycles_lost > 0U) {
        (void)fprintf(where, "%" PRIu32 " cycles before this file were lost.\n",
                      reader.cycles_lost);
    }
}

static int replay_all(bool is_cut_short)
{
    tell_lost(stdout);
    while (take_record()) {
        if (!replay_take(&replay, robot, &record, &known)) {
            return tell_difference(stdout);
        }
    }
    if (!check_end()) {
        return EXIT_REFUSED;
    }
    tell_unreplayed(stdout);
    if (replay.replayed == 0U) {
        (void)printf("There is nothing to replay: no cycle follows a checkpoint.\n");
        return EXIT_REFUSED;
    }
    (void)printf("%" PRIu64 " cycles replayed, every output equal\n", replay.replayed);
    if (is_cut_short) {
        (void)printf("The recording is cut short: only the %" PRIu64
                     " cycles before the cut were replayed.\n",
                     replay.replayed);
        return EXIT_CUT_SHORT;
    }
    return EXIT_EQUAL;
}

/* What a cycle said that was replayed, or at least kept whole; NULL: nobody knows. */
static const controller_outputs_t *find_shown(void)
{
    if (replay.is_running) {
        return &replay.outputs;
    }
    return known.is_whole ? &record.body.cycle.outputs : NULL;
}

static void tell_table(const controller_outputs_t *shown)
{
    if (shown != NULL) {
        table_print_row(robot, record.cycle, &shown->snapshot);
    }
}

static void tell_board(const controller_outputs_t *shown)
{
    if (shown != NULL) {
        board_table_print_row(&record, &shown->snapshot);
    }
}

static void tell_csv(const controller_outputs_t *shown)
{
    motion_csv_take(&csv, &reader.header, &record, (shown != NULL) ? &shown->snapshot : NULL);
}

static void tell_mcap(const controller_outputs_t *shown)
{
    motion_mcap_take(&mcap, &reader.header, &record, shown);
}

/* Tells each cycle as it is replayed. */
static int tell_motion(void (*tell)(const controller_outputs_t *shown), bool is_cut_short)
{
    tell_lost(stderr);
    while (take_record()) {
        if (!replay_take(&replay, robot, &record, &known)) {
            return tell_difference(stderr);
        }
        if (record.kind == (uint32_t)CYCLE_RECORD_CYCLE) {
            tell(find_shown());
        }
    }
    if (!check_end()) {
        return EXIT_REFUSED;
    }
    tell_unreplayed(stderr);
    return is_cut_short ? EXIT_CUT_SHORT : EXIT_EQUAL;
}

static int print_table(bool is_of_board, bool is_cut_short)
{
    if (is_of_board) {
        board_table_print_names();
    } else {
        table_print_names(robot);
    }
    return tell_motion(is_of_board ? tell_board : tell_table, is_cut_short);
}

static int end_file(FILE *file, const char *path, bool is_written, int code)
{
    if (!new_file_close(file, path, is_written)) {
        return EXIT_REFUSED;
    }
    if (code == EXIT_CUT_SHORT) {
        (void)fprintf(stderr, "The recording is cut short: %s has what is before the cut.\n", path);
    }
    return code;
}

static int write_csv(const char *path, bool is_cut_short)
{
    FILE *const file = new_file_open(path);

    if (file == NULL) {
        return EXIT_REFUSED;
    }
    motion_csv_begin(&csv, file, robot);
    const int code = tell_motion(tell_csv, is_cut_short);
    return end_file(file, path, motion_csv_end(&csv), code);
}

static int write_mcap(const char *path, bool is_cut_short)
{
    FILE *const file = new_file_open(path);

    if (file == NULL) {
        return EXIT_REFUSED;
    }
    if (!motion_mcap_begin(&mcap, file, robot)) {
        return end_file(file, path, false, EXIT_REFUSED);
    }
    const int code = tell_motion(tell_mcap, is_cut_short);
    const bool is_written =
        motion_mcap_end(&mcap, &reader.header, is_cut_short, reader.cycles_lost);
    return end_file(file, path, is_written, code);
}

static int tell_what_if(bool is_cut_short)
{
    what_if_begin(&what_if, robot);
    while (take_record()) {
        what_if_prepare(&what_if, &replay, &record);
        if (!replay_take(&replay, robot, &record, &known)) {
            return tell_difference(stderr);
        }
        what_if_take(&what_if, &replay, &record);
    }
    if (!check_end() || !what_if_end(&what_if)) {
        return EXIT_REFUSED;
    }
    return is_cut_short ? EXIT_CUT_SHORT : EXIT_EQUAL;
}

/* What is in the recording itself. */
static int print_kept(bool is_cut_short, bool are_events)
{
    tell_lost(stderr);
    if (!are_events) {
        table_print_interval_names();
    }
    while (take_record()) {
        if (are_events) {
            table_print_events(robot, &record);
        } else {
            table_print_interval(&record);
        }
    }
    if (!check_end()) {
        return EXIT_REFUSED;
    }
    return is_cut_short ? EXIT_CUT_SHORT : EXIT_EQUAL;
}

/* Does with the recording what was asked for. */
static int treat(const char *path, const char *const values[])
{
    const recording_verdict_t verdict = verify(path);
    if ((verdict != RECORDING_WHOLE) && (verdict != RECORDING_CUT_SHORT)) {
        return EXIT_REFUSED;
    }
    const bool is_cut_short = verdict == RECORDING_CUT_SHORT;
    int code = EXIT_REFUSED;
    robot = build_fit(&reader);
    if (robot == NULL) {
        code = EXIT_REFUSED;
    } else if (values[WHAT_IF] != NULL) {
        code = tell_what_if(is_cut_short);
    } else if (values[CSV] != NULL) {
        code = write_csv(values[CSV], is_cut_short);
    } else if (values[MCAP] != NULL) {
        code = write_mcap(values[MCAP], is_cut_short);
    } else if ((values[TABLE] != NULL) || (values[BOARD] != NULL)) {
        code = print_table(values[BOARD] != NULL, is_cut_short);
    } else if ((values[EVENTS] != NULL) || (values[LOOP] != NULL)) {
        code = print_kept(is_cut_short, values[EVENTS] != NULL);
    } else {
        code = replay_all(is_cut_short);
    }
    recording_reader_close(&reader);
    return code;
}

static uint32_t count_given(const char *const values[])
{
    uint32_t given = 0U;

    for (uint32_t i = 0U; i < OPTIONS; i++) {
        given += (values[i] != NULL) ? 1U : 0U;
    }
    return given;
}

/* Reads what is changed; the last word is the recording. */
static int read_what_if(const char *cycles, int words, char *const word[])
{
    char error[512];

    if (!what_if_read_cycles(&what_if, cycles)) {
        return command_line_refuse(&command_line, "\"%s\" is no CYCLE and no CYCLE-CYCLE.", cycles);
    }
    if (words < 2) {
        return command_line_refuse(&command_line, "--what-if lacks INPUT=VALUE.");
    }
    for (int i = 0; i < (words - 1); i++) {
        if (!what_if_add(&what_if, word[i], error, sizeof error)) {
            return command_line_refuse(&command_line, "%s", error);
        }
    }
    return COMMAND_LINE_GO_ON;
}

int main(int count, char **arguments)
{
    const char *values[OPTIONS];
    int first;
    const int code = command_line_read(&command_line, count, arguments, values, &first);

    if (code != COMMAND_LINE_GO_ON) {
        return code;
    }
    if (count_given(values) > 1U) {
        return command_line_refuse(&command_line, "All its options exclude each other.");
    }
    if (values[WHAT_IF] == NULL) {
        return ((count - first) == 1)
                   ? treat(arguments[first], values)
                   : command_line_refuse(&command_line, "\"%s\" is not expected here.",
                                         arguments[first + 1]);
    }
    const int wrong = read_what_if(values[WHAT_IF], count - first, &arguments[first]);
    return (wrong == COMMAND_LINE_GO_ON) ? treat(arguments[count - 1], values) : wrong;
}
