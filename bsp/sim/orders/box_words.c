/* SPDX-License-Identifier: Apache-2.0 */
#include "sim/orders/box_words.h"

#include <stddef.h>
#include <string.h>

static bool is_space(char character)
{
    return (character == ' ') || (character == '\t') || (character == '\n') || (character == '\r');
}

bool box_words_split(const char *line, box_words_t *words)
{
    const char *at = line;

    (void)memset(words, 0, sizeof *words);
    for (;;) {
        while (is_space(*at)) {
            at++;
        }
        if (*at == '\0') {
            return true;
        }
        uint32_t length = 0U;
        while ((at[length] != '\0') && !is_space(at[length])) {
            length++;
        }
        if ((words->count == BOX_WORD_COUNT) || (length >= BOX_WORD_SIZE)) {
            return false;
        }
        (void)memcpy(words->words[words->count], at, length);
        words->count++;
        at += length;
    }
}

bool box_words_is(const box_words_t *self, uint32_t index, const char *word)
{
    return strcmp(self->words[index], word) == 0;
}

int box_words_find(const char *const known[], const char *word)
{
    for (int i = 0; known[i] != NULL; i++) {
        if (strcmp(known[i], word) == 0) {
            return i;
        }
    }
    return -1;
}

const box_number_t *box_words_number(const box_words_t *self)
{
    return box_number_find(self->words[0], self->words[1], self->count);
}

bool box_words_take_number(const box_words_t *self, int64_t *number)
{
    const box_number_t *const taken = box_words_number(self);

    return (taken != NULL) && box_number_read(taken, self->words[self->count - 1U], number);
}
