/* SPDX-License-Identifier: Apache-2.0 */
#include "supervisor/board_text.h"

#include <string.h>

static bool is_word(const char *word, const char *text, size_t length)
{
    return (word != NULL) && (strlen(word) == length) && (strncmp(word, text, length) == 0);
}

static const char *value_of(const options_t *options, const char *name, size_t length)
{
    const struct {
        const char *name;
        const char *value;
    } known[] = {{"instance", options->instance},
                 {"robot", options->robot},
                 {"programs", options->programs},
                 {"recordings", options->recordings}};
    const char *value = "";

    for (size_t i = 0U; i < (sizeof known / sizeof known[0]); i++) {
        value = is_word(known[i].name, name, length) ? known[i].value : value;
    }
    for (size_t i = 0U; i < BOARD_OPTIONS; i++) {
        value = is_word(board.options[i].name, name, length) ? options->board[i] : value;
    }
    return value;
}

bool board_text_write(char *text, size_t size, const char *pattern, const options_t *options)
{
    size_t used = 0U;
    bool has_room = true;

    for (const char *at = pattern; (*at != '\0') && has_room;) {
        const char *const end = (*at == '{') ? strchr(at, '}') : NULL;
        const char *part = at;
        size_t length = 1U;
        if (end != NULL) {
            part = value_of(options, at + 1, (size_t)(end - at) - 1U);
            length = strlen(part);
            at = end;
        }
        at++;
        has_room = (used + length) < size;
        length = has_room ? length : (size - used - 1U);
        (void)memcpy(&text[used], part, length);
        used += length;
    }
    text[used] = '\0';
    return has_room;
}
