/* SPDX-License-Identifier: Apache-2.0 */
#include "site/watch.h"

#include "base/contract.h"
#include "card/card_frame.h"
#include "interface/app/fields.h"
#include "interface/app/names.h"
#include "replay/what_if/difference.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#define NAME_SIZE 128U

static const char contract_module[] = "site";

static char words[WATCH_WORDS_SIZE];
static size_t used;
static controller_outputs_t other;
static difference_t difference;

/* Field that is looked for, and whether it was found. */
typedef struct {
    const char *field;
    bool is_found;
} search_t;

const char *watch_words(void)
{
    return words;
}

static void begin(void)
{
    used = 0U;
    words[0] = '\0';
}

__attribute__((format(printf, 1, 2))) static void say(const char *format, ...)
{
    va_list values;

    va_start(values, format);
    const int count = vsnprintf(&words[used], sizeof words - used, format, values);
    va_end(values);
    if ((count > 0) && ((size_t)count < (sizeof words - used))) {
        used += (size_t)count;
    } else {
        words[used] = '\0';
    }
}

static void say_orders(void)
{
    const char *at = box_orders();

    while (*at != '\0') {
        const size_t length = strcspn(at, "\n");
        say("order %.*s\n", (int)length, at);
        at += length + 1U;
    }
}

/* A field of what every command says, or of what `kind` says, `base` bytes behind the command's
 * begin. */
static void say_field(const char *kind, const field_t *field, size_t base)
{
    say("field %s%s%s %zu %zu\n", kind, (kind[0] == '\0') ? "" : ".", field->name,
        base + field->offset, field->size / sizeof(uint32_t));
    for (int32_t value = 0;
         (field->kind == FIELD_WORD) && (strcmp(field->word(value), "UNKNOWN") != 0); value++) {
        say("word %s%s%s %s %ld\n", kind, (kind[0] == '\0') ? "" : ".", field->name,
            field->word(value), (long)value);
    }
}

static void say_command(uint32_t kind)
{
    const char *const name = command_kind_name((int32_t)kind);
    const field_t *field = fields_of_command(kind);

    say("command %s %lu\n", name, (unsigned long)kind);
    while ((field != NULL) && (field->name != NULL)) {
        say_field(name, field, offsetof(command_t, as));
        field++;
    }
}

void watch_vocabulary(void)
{
    begin();
    say_orders();
    for (const field_t *field = fields_command; field->name != NULL; field++) {
        if (field->offset != offsetof(command_t, kind)) {
            say_field("", field, 0U);
        }
    }
    for (uint32_t kind = 1U; kind < COMMAND_KIND_COUNT; kind++) {
        say_command(kind);
    }
}

void watch_happened(void)
{
    const controller_outputs_t *const outputs = &watch_loop()->outputs;

    REQUIRE(320U, watch_loop()->robot != NULL);
    begin();
    for (uint32_t i = 0U; i < outputs->event_count; i++) {
        say("event %s %lu\n", event_id_name((int32_t)outputs->events[i].id),
            (unsigned long)outputs->events[i].subject);
    }
    for (uint32_t i = 0U; i < outputs->answer_count; i++) {
        const answer_t *const answer = &outputs->answers[i];
        say("answer %lu %s %s\n", (unsigned long)answer->id,
            answer_kind_name((int32_t)answer->kind), status_name((int32_t)answer->status));
    }
}

uint32_t watch_driven(void)
{
    const snapshot_t *const snapshot = &watch_loop()->outputs.snapshot;
    uint32_t driven = 0U;

    for (uint32_t axis = 0U; axis < ROBOT_AXIS_MAX; axis++) {
        if (snapshot->axes[axis].drive_mode != (uint32_t)CARD_DRIVE_OFF) {
            driven |= 1U << axis;
        }
    }
    return driven;
}

static void find(void *to, const series_t *series)
{
    search_t *const search = to;

    if (!search->is_found && (strcmp(series->name, search->field) == 0)) {
        search->is_found = true;
        begin();
        series_write(series, words, sizeof words);
        used = strlen(words);
    }
}

bool watch_look(void)
{
    char topic[NAME_SIZE];
    source_t sources[SOURCES];

    REQUIRE(320U, watch_loop()->robot != NULL);
    (void)snprintf(topic, sizeof topic, "%.*s", (int)sizeof topic - 1, words);
    char *const space = strchr(topic, ' ');
    if (space == NULL) {
        return false;
    }
    *space = '\0';
    search_t search = {.field = &space[1]};
    const uint32_t count = source_find(watch_loop()->robot, sources);
    for (uint32_t i = 0U; i < count; i++) {
        if (strcmp(&sources[i].topic[1], topic) == 0) {
            source_report(&sources[i], &watch_loop()->outputs.snapshot, find, &search);
        }
    }
    return search.is_found;
}

const controller_outputs_t *watch_outputs(void)
{
    return &watch_loop()->outputs;
}

uint32_t watch_outputs_size(void)
{
    return (uint32_t)sizeof watch_loop()->outputs;
}

controller_outputs_t *watch_other(void)
{
    return &other;
}

static void add_line(void *to, const char *line)
{
    (void)to;
    say("%s\n", line);
}

void watch_compare_begin(void)
{
    REQUIRE(320U, watch_loop()->robot != NULL);
    difference_init(&difference, watch_loop()->robot, add_line, NULL);
}

void watch_compare(void)
{
    const controller_outputs_t *const outputs = &watch_loop()->outputs;

    REQUIRE(321U, difference.robot != NULL);
    begin();
    difference_report(&difference, outputs->snapshot.cycle, &other, outputs);
}
