/* SPDX-License-Identifier: Apache-2.0 */
#include "common/command_line.h"

#include "common/build_id.h"

#include <errno.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LEFT_COLUMN 22 /* Width: "--recordings FOLDER", or it has a line of its own. */
#define LEFT_SIZE 64U

static void print_line(const char *left, const char *says, const char *more)
{
    const bool is_wide = strlen(left) > LEFT_COLUMN;

    (void)printf("%-*s%s", LEFT_COLUMN, left, is_wide ? "\n" : "");
    (void)printf("%*s  %s%s\n", is_wide ? LEFT_COLUMN : 0, "", says, more);
}

static void print_option(const command_option_t *option)
{
    const char *const value = (option->value != NULL) ? option->value : "";
    char left[LEFT_SIZE];

    (void)snprintf(left, sizeof left, "  --%s%s%s", option->name, (value[0] != '\0') ? " " : "",
                   value);
    print_line(left, option->says, option->is_needed ? " (needed)" : "");
}

static void print_usage(const command_line_t *self)
{
    const char *line = self->usage;
    const char *title = "usage:";

    while (line != NULL) {
        const char *const end = strchr(line, '\n');
        const size_t length = (end != NULL) ? (size_t)(end - line) : strlen(line);
        (void)printf("%-6s %s %.*s\n", title, self->program, (int)length, line);
        line = (end != NULL) ? (end + 1) : NULL;
        title = "";
    }
}

static void print_help(const command_line_t *self)
{
    (void)printf("%s\n\n", self->says);
    print_usage(self);
    (void)putchar('\n');
    for (uint32_t i = 0U; i < self->count; i++) {
        print_option(&self->options[i]);
    }
    print_line("  -h, --help", "say this", "");
    print_line("  --version", "say which version and build this is", "");
    if (self->more != NULL) {
        (void)printf("\n%s", self->more);
    }
}

int command_line_refuse(const command_line_t *self, const char *format, ...)
{
    va_list arguments;

    (void)fprintf(stderr, "%s: ", self->program);
    if (self->place != NULL) {
        (void)fprintf(stderr, "%s: ", self->place);
    }
    va_start(arguments, format);
    (void)vfprintf(stderr, format, arguments);
    va_end(arguments);
    (void)fprintf(stderr, " See %s --help.\n", self->program);
    return COMMAND_LINE_WRONG;
}

bool command_line_is_number(const char *text, uint32_t least, uint32_t most)
{
    char *end = NULL;

    errno = 0;
    const unsigned long number = strtoul(text, &end, 10);
    return (text[0] >= '0') && (text[0] <= '9') && (*end == '\0') && (errno == 0) &&
           (number >= least) && (number <= most);
}

/* Length of the name that follows the hyphens. */
static size_t name_length(const char *word)
{
    return strcspn(word, "=") - 2U;
}

/* The place of the option that `word` names; the count of options where none exists. */
static uint32_t find(const command_line_t *self, const char *word)
{
    uint32_t place = 0U;

    if ((strncmp(word, "--", 2U) != 0) || (strcspn(word, "=") < 2U)) {
        return self->count;
    }
    while ((place < self->count) &&
           ((strlen(self->options[place].name) != name_length(word)) ||
            (strncmp(self->options[place].name, &word[2], name_length(word)) != 0))) {
        place++;
    }
    return place;
}

static int check_value(const command_line_t *self, const command_option_t *option,
                       const char *value)
{
    if (value == NULL) {
        return command_line_refuse(self, "--%s lacks its value, %s.", option->name, option->value);
    }
    if ((option->most != 0U) && !command_line_is_number(value, option->least, option->most)) {
        return command_line_refuse(self, "\"%s\" is no number for --%s; give one from %u to %u.",
                                   value, option->name, (unsigned)option->least,
                                   (unsigned)option->most);
    }
    return COMMAND_LINE_GO_ON;
}

int command_line_take(const command_line_t *self, char *const words[], int *at,
                      const char *values[])
{
    const char *const word = words[*at];
    const char *const equals = strchr(word, '=');
    const uint32_t place = find(self, word);

    if (place == self->count) {
        return command_line_refuse(self, "\"%s\" is no option.", word);
    }
    const command_option_t *const option = &self->options[place];
    (*at)++;
    if ((option->value == NULL) && (equals != NULL)) {
        return command_line_refuse(self, "--%s takes no value.", option->name);
    }
    if (option->value == NULL) {
        values[place] = word;
        return COMMAND_LINE_GO_ON;
    }
    values[place] = (equals != NULL) ? (equals + 1) : words[*at];
    *at += (equals == NULL) ? 1 : 0;
    return check_value(self, option, values[place]);
}

/* Options and words that must be there, and no others. */
static int check(const command_line_t *self, int count, char *const words[],
                 const char *const values[], int first)
{
    for (uint32_t i = 0U; i < self->count; i++) {
        if (self->options[i].is_needed && (values[i] == NULL)) {
            return command_line_refuse(self, "--%s %s is missing.", self->options[i].name,
                                       self->options[i].value);
        }
    }
    if ((count - first) > self->most_words) {
        return command_line_refuse(self, "\"%s\" is not expected here.",
                                   words[first + self->most_words]);
    }
    if ((count - first) < self->fewest_words) {
        return command_line_refuse(self, "Something is missing.");
    }
    return COMMAND_LINE_GO_ON;
}

/* Answers the questions to every program; false when none is asked. */
static bool answers(const command_line_t *self, const char *word)
{
    const bool is_help = (strcmp(word, "-h") == 0) || (strcmp(word, "--help") == 0);
    const bool is_version = strcmp(word, "--version") == 0;

    if (is_help) {
        print_help(self);
    }
    if (is_version) {
        (void)printf("%s %s (build %s)\n", self->program, BUILD_VERSION, BUILD_ID);
    }
    return is_help || is_version;
}

int command_line_read(const command_line_t *self, int count, char *const words[],
                      const char *values[], int *first)
{
    int at = 1;

    for (uint32_t i = 0U; i < self->count; i++) {
        values[i] = NULL;
    }
    while ((at < count) && (words[at][0] == '-') && (words[at][1] != '\0')) {
        if (answers(self, words[at])) {
            return EXIT_SUCCESS;
        }
        const int code = command_line_take(self, words, &at, values);
        if (code != COMMAND_LINE_GO_ON) {
            return code;
        }
    }
    if (first != NULL) {
        *first = at;
    }
    return check(self, count, words, values, at);
}
