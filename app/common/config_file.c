/* SPDX-License-Identifier: Apache-2.0 */
#include "common/config_file.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <string.h>

#define BLANKS " \t\r\n"
#define PLACE_SIZE (PATH_MAX + 32)
/* A word has hyphens and an equals sign more. */
#define READ_SIZE (CONFIG_FILE_LINE_SIZE - sizeof "--=")

/* Its end too. */
static char *without_blanks(char *text)
{
    char *const start = &text[strspn(text, BLANKS)];
    size_t length = strlen(start);

    while ((length > 0U) && (strchr(BLANKS, start[length - 1U]) != NULL)) {
        length--;
    }
    start[length] = '\0';
    return start;
}

/* Place of the option `name`; the count of options where there is none that may stand in a file. */
static uint32_t find(const command_line_t *command_line, const char *name)
{
    uint32_t place = 0U;

    while ((place < command_line->count) &&
           ((strcmp(command_line->options[place].name, name) != 0) ||
            command_line->options[place].is_by_hand)) {
        place++;
    }
    return place;
}

static int take_option(config_file_t *self, const command_line_t *command_line, const char *name,
                       const char *value)
{
    const uint32_t place = find(command_line, name);
    int at = 0;

    if (place == command_line->count) {
        return command_line_refuse(command_line, "\"%s\" is no option of this file.", name);
    }
    if (self->values[place] != NULL) {
        return command_line_refuse(command_line, "\"%s\" stands there twice.", name);
    }
    (void)snprintf(self->words[place], CONFIG_FILE_LINE_SIZE, "--%s%s%s", name,
                   (value[0] != '\0') ? "=" : "", value);
    char *const words[] = {self->words[place], NULL};
    return command_line_take(command_line, words, &at, self->values);
}

static int take_line(config_file_t *self, const command_line_t *command_line, char *line)
{
    const bool is_whole = (strchr(line, '\n') != NULL) || (strlen(line) < (READ_SIZE - 1U));
    char *const name = without_blanks(line);
    char *value = &name[strcspn(name, BLANKS)];

    if ((name[0] == '\0') || (name[0] == '#')) {
        return COMMAND_LINE_GO_ON;
    }
    if (!is_whole) {
        return command_line_refuse(command_line, "It is too long.");
    }
    if (value[0] != '\0') {
        *value = '\0';
        value++;
    }
    return take_option(self, command_line, name, without_blanks(value));
}

static int read_lines(config_file_t *self, FILE *file, const char *path,
                      const command_line_t *command_line)
{
    char line[READ_SIZE];
    char place[PLACE_SIZE];
    command_line_t here = *command_line;
    int code = COMMAND_LINE_GO_ON;

    here.place = place;
    for (unsigned number = 1U;
         (code == COMMAND_LINE_GO_ON) && (fgets(line, (int)sizeof line, file) != NULL); number++) {
        (void)snprintf(place, sizeof place, "%s, line %u", path, number);
        code = take_line(self, &here, line);
    }
    return code;
}

int config_file_read(config_file_t *self, const char *path, const command_line_t *command_line,
                     const char *values[])
{
    FILE *const file = fopen(path, "r");

    (void)memset(self, 0, sizeof *self);
    if (file == NULL) {
        return command_line_refuse(command_line, "The file %s cannot be read (%s).", path,
                                   strerror(errno));
    }
    const int code = read_lines(self, file, path, command_line);
    (void)fclose(file);
    for (uint32_t i = 0U; i < command_line->count; i++) {
        values[i] = (values[i] != NULL) ? values[i] : self->values[i];
    }
    return code;
}
