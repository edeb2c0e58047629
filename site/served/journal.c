/* SPDX-License-Identifier: Apache-2.0 */
#include "site/served/journal.h"

#include "interface/app/fields.h"
#include "interface/app/names.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

static char lines[JOURNAL_SIZE];
static size_t used;
static bool is_taken;
static bool is_whole;

void journal_begin(void)
{
    is_taken = false;
    is_whole = true;
    used = 0U;
    lines[0] = '\0';
}

__attribute__((format(printf, 1, 2))) static void add(const char *format, ...)
{
    va_list values;

    va_start(values, format);
    const int count = vsnprintf(&lines[used], sizeof lines - used, format, values);
    va_end(values);
    is_whole = is_whole && (count >= 0) && ((size_t)count < (sizeof lines - used));
    used += is_whole ? (size_t)count : 0U;
}

static void begin_line(uint32_t cycle)
{
    if (is_taken) {
        is_taken = false;
        used = 0U;
    }
    add("%lu:", (unsigned long)cycle);
}

void journal_note_order(uint32_t cycle, const char *order)
{
    begin_line(cycle);
    const size_t begin = used;
    add("%s\n", order);
    for (size_t i = begin; i < used; i++) {
        lines[i] = (lines[i] == ' ') ? ',' : lines[i];
    }
}

/* Numbers behind the last one that is not 0 need not be said, but `least` of them. */
static uint32_t said_of(const int32_t *numbers, const field_t *field, uint32_t least)
{
    uint32_t count = (uint32_t)(field->size / sizeof numbers[0]);

    while ((count > least) && (numbers[count - 1U] == 0)) {
        count--;
    }
    return count;
}

static void add_number(const field_t *field, int32_t number)
{
    if (field->word != NULL) {
        add("%s", field->word(number));
    } else if (field->kind == FIELD_UNSIGNED) {
        add("%lu", (unsigned long)(uint32_t)number);
    } else {
        add("%ld", (long)number);
    }
}

/* A field of the structure at `begin`. */
static void add_field(const void *begin, const field_t *field, uint32_t least)
{
    const int32_t *const numbers =
        (const int32_t *)(const void *)((const uint8_t *)begin + field->offset);
    const uint32_t count = said_of(numbers, field, least);

    for (uint32_t i = 0U; i < count; i++) {
        if (i == 0U) {
            add(",%s=", field->name);
        } else {
            add("/");
        }
        add_number(field, numbers[i]);
    }
}

/* Fields of every command. Id and peer must be stated: a scene has its own. */
static void add_head(const command_t *command)
{
    for (const field_t *field = fields_command; field->name != NULL; field++) {
        const bool is_always = (field->offset == offsetof(command_t, id)) ||
                               (field->offset == offsetof(command_t, peer));

        if (field->offset != offsetof(command_t, kind)) {
            add_field(command, field, is_always ? 1U : 0U);
        }
    }
}

/* Fields of a command of its kind. */
static void add_payload(const command_t *command)
{
    const field_t *field = fields_of_command(command->kind);

    while ((field != NULL) && (field->name != NULL)) {
        add_field(&command->as, field, 0U);
        field++;
    }
}

void journal_note_command(uint32_t cycle, const command_t *command)
{
    if (command->kind == (uint32_t)COMMAND_NOTE) {
        return;
    }
    begin_line(cycle);
    add("%s", command_kind_name((int32_t)command->kind));
    add_head(command);
    add_payload(command);
    add("\n");
}

const char *journal_take(void)
{
    if (is_taken) {
        used = 0U;
        lines[0] = '\0';
    }
    is_taken = true;
    return is_whole ? lines : NULL;
}
