/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * boresight-replay: verifies a recording, or all of a run, and executes the controller on it again.
 *
 * Exit code 0: every output of what it was given is equal, of a folder all of the run. 1: a
 * difference. 2: damaged, unreadable, not holding the records it announces, of another format,
 * layout or robot, or nothing to replay. 3: what is there is equal, but something is missing: a
 * recording is cut short, cycles are not there or follow no checkpoint, or the run has no beginning
 * or no end there. Tables and files, which are of the motion as replayed, end alike; events and
 * intervals, which are in the recording, end with 0, 2 or 3. --membranes, which reads tables of
 * force and depth and no recording, ends with 0 or 2.
 */
#include "base/contract.h"
#include "common/command_line.h"
#include "replay/export/file_output.h"
#include "replay/membranes/membrane_report.h"
#include "replay/verify/printed.h"
#include "replay/verify/run.h"
#include "replay/verify/verdict.h"
#include "replay/what_if/what_if.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum {
    TABLE = 0,
    EVENTS,
    LOOP,
    BOARD,
    CSV,
    MCAP,
    HTML,
    WHAT_IF,
    MEMBRANES,
    EXCLUSIVE, /* Those before exclude each other. */
    RUN = EXCLUSIVE,
    EXPECTED,
    NOISE,
    OPTIONS
};

static const command_option_t options[OPTIONS] = {
    [TABLE] = {"table", NULL, .says = "write the motion as comma-separated values instead"},
    [EVENTS] = {"events", NULL, .says = "write the events, a line each, instead"},
    [LOOP] = {"loop", NULL, .says = "write the interval of each cycle instead"},
    [BOARD] = {"board", NULL, .says = "write what the board said, a row for each cycle, instead"},
    [CSV] = {"csv", "FILE", .says = "write all that is known of the motion to a new FILE"},
    [MCAP] = {"mcap", "FILE", .says = "the same for Foxglove and PlotJuggler, with the events"},
    [HTML] = {"html", "FILE", .says = "the same for people: one page that needs nothing else"},
    [WHAT_IF] = {"what-if", "CYCLES", .says = "say what differs if inputs had been others"},
    [MEMBRANES] = {"membranes", NULL, .says = "find membranes in FILEs of force and depth"},
    [EXPECTED] = {"expected", "DEPTHS", .says = "of --membranes: where they are, mm, as 30,55.5"},
    [NOISE] = {"noise", "MN", .says = "of --membranes: of the filtered force, not measured"},
    [RUN] = {"run", "NAME", .says = "of a FOLDER go through this run, not the newest"},
};
static const command_line_t command_line = {
    .program = "boresight-replay",
    .says = "Verifies a recording, or all of a run, and computes its motion again.",
    .usage = "[--table|--events|--loop|--board] [--run NAME] FOLDER\n"
             "[--table|--events|--loop|--board] RECORDING\n"
             "[--csv FILE|--mcap FILE|--html FILE] RECORDING\n"
             "--what-if CYCLE[-CYCLE] INPUT=VALUE... RECORDING\n"
             "--membranes [--expected DEPTHS] [--noise MN] FILE...",
    .options = options,
    .count = OPTIONS,
    .fewest_words = 1,
    .most_words = COMMAND_LINE_MANY,
    .more = "Of a FOLDER all recordings of one run are gone through in their order.\n"
            "FILE may be -, the standard output; those of --membranes are tables of text with\n"
            "the columns time_ms, depth_mm and force_n, of one insertion each.\n"
            "Exit code 0: every output of it is equal, of a FOLDER of the whole run. 1: there\n"
            "is a difference. 2: the command line is wrong, or a recording damaged,\n"
            "unreadable or not for this build. 3: what is there is equal, but something is\n"
            "missing.\n"};

static walk_t walk;
static run_t run;
static what_if_t what_if;
static membrane_report_t membranes;

void contract_broken(const char *module, uint32_t id)
{
    (void)printf("Cycle %u breaks contract %s/%u.\n", (unsigned)walk.record.cycle, module,
                 (unsigned)id);
    (void)fflush(stdout);
    _Exit(EXIT_DIFFERENT);
}

/* But which run. */
static uint32_t count_given(const char *const values[])
{
    uint32_t given = 0U;

    for (uint32_t i = 0U; i < (uint32_t)EXCLUSIVE; i++) {
        given += (values[i] != NULL) ? 1U : 0U;
    }
    return given;
}

static int report_what_if(void)
{
    what_if_begin(&what_if, walk.robot);
    while (walk_take(&walk)) {
        what_if_prepare(&what_if, &walk.replay, &walk.record);
        if (!walk_replay(&walk)) {
            return walk_report_difference(&walk, stderr);
        }
        (void)walk_count(&walk, walk_is_done(&walk));
        if (!walk.is_again) {
            what_if_take(&what_if, &walk.replay, &walk.record);
        }
    }
    return (walk_check_end(&walk) && what_if_end(&what_if)) ? walk_end(&walk) : EXIT_REFUSED;
}

/* Treats one recording: writes a file, or answers. */
static int treat_alone(const char *path, const char *const values[])
{
    int code = EXIT_REFUSED;

    if (!walk_open(&walk, path)) {
        code = EXIT_REFUSED;
    } else if (values[WHAT_IF] != NULL) {
        code = report_what_if();
    } else if (values[CSV] != NULL) {
        code = file_output_csv(&walk, values[CSV]);
    } else if (values[MCAP] != NULL) {
        code = file_output_mcap(&walk, values[MCAP]);
    } else {
        code = file_output_html(&walk, values[HTML]);
    }
    walk_close(&walk);
    return code;
}

/* Each recording in its turn. */
static int go_through(walk_part_t *treat)
{
    int code = WALK_GOES_ON;

    for (uint32_t i = 0U; (i < run.count) && (code == WALK_GOES_ON); i++) {
        code = walk_open(&walk, run.files[i].path) ? treat(&walk) : EXIT_REFUSED;
        walk_close(&walk);
    }
    return code;
}

static int replay_all(void)
{
    const int code = go_through(verdict_take);

    return (code == WALK_GOES_ON) ? verdict_report(&walk) : code;
}

static int print_all(walk_part_t *print)
{
    const int code = go_through(print);

    return (code == WALK_GOES_ON) ? walk_end(&walk) : code;
}

static int treat_each(const char *const values[])
{
    static walk_part_t *const prints[] = {[TABLE] = printed_motion,
                                          [EVENTS] = printed_events,
                                          [LOOP] = printed_intervals,
                                          [BOARD] = printed_board};
    for (uint32_t i = 0U; i < (sizeof prints / sizeof prints[0]); i++) {
        if (values[i] != NULL) {
            return print_all(prints[i]);
        }
    }
    return replay_all();
}

static bool is_folder(const char *path)
{
    struct stat status;

    return (stat(path, &status) == 0) && S_ISDIR(status.st_mode);
}

/* The option for one recording alone; NULL: none is given. */
static const char *find_lone(const char *const values[])
{
    static const uint32_t lone[] = {CSV, MCAP, HTML, WHAT_IF};

    for (uint32_t i = 0U; i < (sizeof lone / sizeof lone[0]); i++) {
        if (values[lone[i]] != NULL) {
            return options[lone[i]].name;
        }
    }
    return NULL;
}

static int treat_run(const char *folder, const char *const values[])
{
    FILE *const notes = (count_given(values) == 0U) ? stdout : stderr;

    walk_begin(&walk, true, notes);
    const int code = run_find(&run, folder, values[RUN], notes) ? treat_each(values) : EXIT_REFUSED;
    run_free(&run);
    return code;
}

static int treat_file(char *path, const char *const values[])
{
    run_file_t file = {.path = path};

    run = (run_t){.files = &file, .count = 1U};
    walk_begin(&walk, false, (count_given(values) == 0U) ? stdout : stderr);
    return (find_lone(values) != NULL) ? treat_alone(path, values) : treat_each(values);
}

/**
 * Carries out the request for `path`.
 *
 * @satisfies SWR-REPLAY-035
 */
static int treat(char *path, const char *const values[])
{
    const char *const lone = find_lone(values);

    if (!is_folder(path)) {
        return (values[RUN] == NULL)
                   ? treat_file(path, values)
                   : command_line_refuse(&command_line, "--run needs a folder; %s is none.", path);
    }
    return (lone == NULL)
               ? treat_run(path, values)
               : command_line_refuse(&command_line, "--%s takes one recording; %s is a folder.",
                                     lone, path);
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

/* Finds membranes in each of `files`. */
static int find_membranes(const char *const values[], int count, char *const files[])
{
    const char *const depths = values[EXPECTED];
    const char *const noise = values[NOISE];

    if ((depths != NULL) && !membrane_report_expect(&membranes, depths)) {
        return command_line_refuse(&command_line, "\"%s\" is no list of depths in mm.", depths);
    }
    if ((noise != NULL) && !membrane_report_take_noise(&membranes, noise)) {
        return command_line_refuse(&command_line, "\"%s\" is no noise in mN.", noise);
    }
    for (int i = 0; i < count; i++) {
        if (!membrane_report_file(&membranes, files[i])) {
            return EXIT_REFUSED;
        }
    }
    membrane_report_end(&membranes);
    return EXIT_SUCCESS;
}

/* Carries out the request of `words`, which are one or more. */
static int answer(const char *const values[], int count, char *const words[])
{
    if (count_given(values) > 1U) {
        return command_line_refuse(&command_line, "All its options exclude each other.");
    }
    if (values[MEMBRANES] != NULL) {
        return (values[RUN] == NULL)
                   ? find_membranes(values, count, words)
                   : command_line_refuse(&command_line, "--run needs a folder of recordings.");
    }
    if ((values[EXPECTED] != NULL) || (values[NOISE] != NULL)) {
        return command_line_refuse(&command_line, "--expected and --noise need --membranes.");
    }
    if (values[WHAT_IF] == NULL) {
        return (count == 1)
                   ? treat(words[0], values)
                   : command_line_refuse(&command_line, "\"%s\" is not expected here.", words[1]);
    }
    const int wrong = read_what_if(values[WHAT_IF], count, words);
    return (wrong == COMMAND_LINE_GO_ON) ? treat(words[count - 1], values) : wrong;
}

int main(int count, char **arguments)
{
    const char *values[OPTIONS];
    int first;
    const int code = command_line_read(&command_line, count, arguments, values, &first);

    return (code == COMMAND_LINE_GO_ON) ? answer(values, count - first, &arguments[first]) : code;
}
