/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/file_output.h"

#include "replay/motion_csv.h"
#include "replay/motion_html.h"
#include "replay/motion_mcap.h"
#include "replay/new_file.h"

static motion_csv_t csv;
static motion_mcap_t mcap;
static motion_html_t html;

static void tell_csv(walk_t *walk, void *to, const controller_outputs_t *shown)
{
    motion_csv_take(to, &walk->reader.header, &walk->record,
                    (shown != NULL) ? &shown->snapshot : NULL);
}

static void tell_mcap(walk_t *walk, void *to, const controller_outputs_t *shown)
{
    motion_mcap_take(to, &walk->reader.header, &walk->record, shown);
}

static void tell_html(walk_t *walk, void *to, const controller_outputs_t *shown)
{
    motion_html_take(to, &walk->reader.header, &walk->record, shown);
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

int file_output_csv(walk_t *walk, const char *path)
{
    FILE *const file = new_file_open(path);

    if (file == NULL) {
        return EXIT_REFUSED;
    }
    motion_csv_begin(&csv, file, walk->robot);
    const int code = walk_tell(walk, tell_csv, &csv);
    return end_file(file, path, motion_csv_end(&csv), code);
}

int file_output_mcap(walk_t *walk, const char *path)
{
    FILE *const file = new_file_open(path);

    if (file == NULL) {
        return EXIT_REFUSED;
    }
    if (!motion_mcap_begin(&mcap, file, walk->robot)) {
        return end_file(file, path, false, EXIT_REFUSED);
    }
    const int code = walk_tell(walk, tell_mcap, &mcap);
    const recording_reader_t *const reader = &walk->reader;
    const bool is_written =
        motion_mcap_end(&mcap, &reader->header, walk->is_cut_short, reader->cycles_lost);
    return end_file(file, path, is_written, code);
}

int file_output_html(walk_t *walk, const char *path)
{
    FILE *const file = new_file_open(path);

    if (file == NULL) {
        return EXIT_REFUSED;
    }
    motion_html_begin(&html, file, walk->robot, &walk->reader.header);
    const int code = walk_tell(walk, tell_html, &html);
    const motion_html_proof_t proof = {.replayed = walk->replay.replayed,
                                       .unreplayed = walk->replay.unreplayed,
                                       .cycles_lost = walk->reader.cycles_lost,
                                       .is_cut_short = walk->is_cut_short,
                                       .is_trusted = code != EXIT_REFUSED,
                                       .difference = walk->difference};
    return end_file(file, path, motion_html_end(&html, &proof), code);
}
