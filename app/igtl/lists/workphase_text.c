/* SPDX-License-Identifier: Apache-2.0 */
#include "igtl/lists/workphase_text.h"

#include "common/axis_terms.h"

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

char *workphase_text_next(char **text)
{
    char *word = &(*text)[strspn(*text, " ")];
    char *end = &word[strcspn(word, " ")];

    *text = (*end == '\0') ? end : &end[1];
    *end = '\0';
    return (word == end) ? NULL : word;
}

bool workphase_text_is(const char *word, const char *expected)
{
    return (word != NULL) && (strcmp(word, expected) == 0);
}

/* These characters alone: strtod() knows more, and no text makes what is not finite. */
bool workphase_text_number(const char *word, double most, double *number)
{
    char *end = NULL;

    *number = 0.0;
    if ((word == NULL) || (word[strspn(word, "+-.0123456789eE")] != '\0')) {
        return false;
    }
    *number = strtod(word, &end);
    return (end != word) && (*end == '\0') && (fabs(*number) <= most);
}

static bool read_whole(const char *word, const char *characters, int64_t most, int64_t *number)
{
    char *end = NULL;

    *number = 0;
    if ((word == NULL) || (word[strspn(word, characters)] != '\0')) {
        return false;
    }
    *number = (int64_t)strtoll(word, &end, 10);
    return (end != word) && (*end == '\0') && (*number <= most) && (*number >= (-most - 1));
}

bool workphase_text_whole(const char *word, int32_t *number)
{
    int64_t value;
    const bool is_one = read_whole(word, "+-0123456789", INT32_MAX, &value);

    *number = (int32_t)value;
    return is_one;
}

bool workphase_text_natural(const char *word, uint32_t *number)
{
    int64_t value;
    const bool is_one = read_whole(word, "0123456789", UINT32_MAX, &value);

    *number = (uint32_t)value;
    return is_one;
}

bool workphase_text_ticks(const char *word, const axis_config_t *axis, int32_t *ticks)
{
    double number;

    return workphase_text_number(word, DBL_MAX, &number) && axis_terms_ticks(axis, number, ticks);
}
