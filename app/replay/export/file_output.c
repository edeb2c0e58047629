/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/export/file_output.h"

#include "replay/export/motion_csv.h"
#include "replay/export/motion_json.h"
#include "replay/export/motion_mcap.h"
#include "replay/export/new_file.h"
#include "replay/export/replay_page.h"

#include <string.h>

static motion_csv_t csv;
static motion_mcap_t mcap;
static motion_json_t html;

static void report_csv(walk_t *walk, void *to, const controller_outputs_t *shown)
{
    motion_csv_take(to, &walk->reader.header, &walk->record,
                    (shown != NULL) ? &shown->snapshot : NULL);
}

static void report_mcap(walk_t *walk, void *to, const controller_outputs_t *shown)
{
    motion_mcap_take(to, &walk->reader.header, &walk->record, shown);
}

static int end_file(const walk_t *walk, FILE *file, const char *path, bool is_made, int code)
{
    if (!new_file_close(file, path, is_made)) {
        return EXIT_REFUSED;
    }
    if ((code == EXIT_PART) && walk->is_cut_short) {
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
    const int code = walk_report(walk, report_csv, &csv);
    motion_csv_end(&csv);
    return end_file(walk, file, path, true, code);
}

int file_output_mcap(walk_t *walk, const char *path)
{
    FILE *const file = new_file_open(path);

    if (file == NULL) {
        return EXIT_REFUSED;
    }
    if (!motion_mcap_begin(&mcap, file, walk->robot)) {
        return end_file(walk, file, path, false, EXIT_REFUSED);
    }
    const int code = walk_report(walk, report_mcap, &mcap);
    const recording_reader_t *const reader = &walk->reader;
    const bool is_made =
        motion_mcap_end(&mcap, &reader->header, walk->is_cut_short, reader->cycles_lost);
    return end_file(walk, file, path, is_made, code);
}

int file_output_html(walk_t *walk, const char *path)
{
    FILE *const file = new_file_open(path);

    if (file == NULL) {
        return EXIT_REFUSED;
    }
    const char *const page = (const char *)replay_page;
    const char *const rest = &strstr(page, REPLAY_PAGE_MARK)[strlen(REPLAY_PAGE_MARK)];
    (void)fwrite(page, 1U, (size_t)(rest - page), file);
    motion_json_begin(&html, file, walk);
    const int code = walk_report(walk, motion_json_take, &html);
    motion_json_end(&html, walk, code);
    (void)fputs(rest, file);
    return end_file(walk, file, path, true, code);
}
