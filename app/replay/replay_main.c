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
#include "replay/board_table.h"
#include "replay/build_fit.h"
#include "replay/file_output.h"
#include "replay/table.h"
#include "replay/what_if.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TABLE = 0, EVENTS, LOOP, BOARD, CSV, MCAP, HTML, WHAT_IF, OPTIONS };

static const command_option_t options[OPTIONS] = {
    [TABLE] = {"table", NULL, .says = "write the motion as comma-separated values instead"},
    [EVENTS] = {"events", NULL, .says = "write the events, a line each, instead"},
    [LOOP] = {"loop", NULL, .says = "write the interval of each cycle instead"},
    [BOARD] = {"board", NULL, .says = "write what the board said, a row for each cycle, instead"},
    [CSV] = {"csv", "FILE", .says = "write all that is known of the motion to a new FILE"},
    [MCAP] = {"mcap", "FILE", .says = "the same for Foxglove and PlotJuggler, with the events"},
    [HTML] = {"html", "FILE", .says = "the same for people: one page that needs nothing else"},
    [WHAT_IF] = {"what-if", "CYCLES", .says = "say what differs if inputs had been others"},
};
static const command_line_t command_line = {
    .program = "boresight-replay",
    .says = "Verifies a recording and computes the motion of it again.",
    .usage = "[--table | --events | --loop | --board] RECORDING\n"
             "[--csv FILE | --mcap FILE | --html FILE] RECORDING\n"
             "--what-if CYCLE[-CYCLE] INPUT=VALUE... RECORDING",
    .options = options,
    .count = OPTIONS,
    .fewest_words = 1,
    .most_words = WHAT_IF_CHANGES + 1,
    .more = "FILE may be -, the standard output.\n"
            "Exit code 0: every output is equal. 1: there is a difference. 2: the command\n"
            "line is wrong, or the recording damaged, unreadable or not for this build. 3:\n"
            "every output is equal, but the recording is cut short.\n"};

static walk_t walk;
static what_if_t what_if;

void contract_broken(const char *module, uint32_t id)
{
    (void)printf("Cycle %u breaks contract %s/%u.\n", (unsigned)walk.record.cycle, module,
                 (unsigned)id);
    (void)fflush(stdout);
    _Exit(EXIT_DIFFERENT);
}

static recording_verdict_t verify(const char *path)
{
    recording_finding_t finding;
    const recording_verdict_t verdict = recording_reader_open(&walk.reader, path, &finding);

    if (verdict != RECORDING_WHOLE) {
        (void)fprintf(stderr, "%s\n", finding.sentence);
    }
    return verdict;
}

static int replay_all(void)
{
    walk_tell_lost(&walk, stdout);
    while (walk_take(&walk)) {
        if (!walk_replay(&walk)) {
            return walk_tell_difference(&walk, stdout);
        }
    }
    if (!walk_check_end(&walk)) {
        return EXIT_REFUSED;
    }
    walk_tell_unreplayed(&walk, stdout);
    const uint64_t replayed = walk.replay.replayed;
    if (replayed == 0U) {
        (void)printf("There is nothing to replay: no cycle follows a checkpoint.\n");
        return EXIT_REFUSED;
    }
    (void)printf("%" PRIu64 " cycles replayed, every output equal\n", replayed);
    if (walk.is_cut_short) {
        (void)printf("The recording is cut short: only the %" PRIu64
                     " cycles before the cut were replayed.\n",
                     replayed);
        return EXIT_CUT_SHORT;
    }
    return EXIT_EQUAL;
}

static void tell_table(walk_t *self, void *to, const controller_outputs_t *shown)
{
    (void)to;
    if (shown != NULL) {
        table_print_row(self->robot, self->record.cycle, &shown->snapshot);
    }
}

static void tell_board(walk_t *self, void *to, const controller_outputs_t *shown)
{
    (void)to;
    if (shown != NULL) {
        board_table_print_row(&self->record, &shown->snapshot);
    }
}

static int print_table(bool is_of_board)
{
    if (is_of_board) {
        board_table_print_names();
    } else {
        table_print_names(walk.robot);
    }
    return walk_tell(&walk, is_of_board ? tell_board : tell_table, NULL);
}

static int tell_what_if(void)
{
    what_if_begin(&what_if, walk.robot);
    while (walk_take(&walk)) {
        what_if_prepare(&what_if, &walk.replay, &walk.record);
        if (!walk_replay(&walk)) {
            return walk_tell_difference(&walk, stderr);
        }
        what_if_take(&what_if, &walk.replay, &walk.record);
    }
    if (!walk_check_end(&walk) || !what_if_end(&what_if)) {
        return EXIT_REFUSED;
    }
    return walk.is_cut_short ? EXIT_CUT_SHORT : EXIT_EQUAL;
}

/* What is in the recording itself. */
static int print_kept(bool are_events)
{
    walk_tell_lost(&walk, stderr);
    if (!are_events) {
        table_print_interval_names();
    }
    while (walk_take(&walk)) {
        if (are_events) {
            table_print_events(walk.robot, &walk.record);
        } else {
            table_print_interval(&walk.record);
        }
    }
    if (!walk_check_end(&walk)) {
        return EXIT_REFUSED;
    }
    return walk.is_cut_short ? EXIT_CUT_SHORT : EXIT_EQUAL;
}

/* Does with the recording what was asked for. */
static int treat(const char *path, const char *const values[])
{
    const recording_verdict_t verdict = verify(path);
    if ((verdict != RECORDING_WHOLE) && (verdict != RECORDING_CUT_SHORT)) {
        return EXIT_REFUSED;
    }
    int code = EXIT_REFUSED;
    walk.is_cut_short = verdict == RECORDING_CUT_SHORT;
    walk.robot = build_fit(&walk.reader);
    if (walk.robot == NULL) {
        code = EXIT_REFUSED;
    } else if (values[WHAT_IF] != NULL) {
        code = tell_what_if();
    } else if (values[CSV] != NULL) {
        code = file_output_csv(&walk, values[CSV]);
    } else if (values[MCAP] != NULL) {
        code = file_output_mcap(&walk, values[MCAP]);
    } else if (values[HTML] != NULL) {
        code = file_output_html(&walk, values[HTML]);
    } else if ((values[TABLE] != NULL) || (values[BOARD] != NULL)) {
        code = print_table(values[BOARD] != NULL);
    } else if ((values[EVENTS] != NULL) || (values[LOOP] != NULL)) {
        code = print_kept(values[EVENTS] != NULL);
    } else {
        code = replay_all();
    }
    recording_reader_close(&walk.reader);
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
