/* SPDX-License-Identifier: Apache-2.0 */
#include "recording/archive/log_csv.h"

#include "common/event_text.h"
#include "common/utc_text.h"
#include "interface/app/names.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char header[] = "number,utc,cycle,severity,name,subject,value,cause,peer,text\r\n";

/* In quotes. Spreadsheets take what begins with one of these characters for a formula, but not
 * behind an apostrophe. */
static void write_cell(FILE *file, const char *text)
{
    const bool is_formula = (text[0] != '\0') && (strchr("=+-@\t\r", text[0]) != NULL);

    (void)fputs(is_formula ? "\"'" : "\"", file);
    for (; *text != '\0'; text++) {
        (void)fputs((*text == '"') ? "\"" : "", file);
        (void)fputc(*text, file);
    }
    (void)fputc('"', file);
}

static void write_row(FILE *file, const robot_t *robot, const log_entry_t *entry)
{
    const event_t *event = &entry->event;
    char utc[UTC_TEXT_SIZE];
    char subject[EVENT_TEXT_SIZE];

    utc_text_write(entry->utc_us, utc);
    event_text_subject(robot, event, subject, sizeof subject);
    (void)fprintf(file, "%u,%s,%u,%s,%s,", (unsigned)event->number, utc, (unsigned)event->cycle,
                  event_severity_name((int32_t)event->severity), event_id_name((int32_t)event->id));
    write_cell(file, subject);
    (void)fprintf(file, ",%d,%s,%u,", (int)event->value, event_cause_name((int32_t)event->cause),
                  (unsigned)event->peer);
    write_cell(file, entry->text);
    (void)fputs("\r\n", file);
}

char *log_csv_write(const log_search_t *found, const robot_t *robot, size_t *size)
{
    char *text = NULL;
    FILE *const file = open_memstream(&text, size);

    if (file == NULL) {
        return NULL;
    }
    (void)fputs(header, file);
    for (uint32_t i = 0U; i < found->count; i++) {
        write_row(file, robot, log_search_entry(found, i));
    }
    const bool is_whole = ferror(file) == 0;
    if ((fclose(file) != 0) || !is_whole) {
        free(text);
        return NULL;
    }
    return text;
}
