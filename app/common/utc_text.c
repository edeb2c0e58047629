/* SPDX-License-Identifier: Apache-2.0 */
#include "common/utc_text.h"

#include <stdio.h>
#include <string.h>
#include <time.h>

#define SECOND_US UINT64_C(1000000)
#define SECONDS_LENGTH 19U

void utc_text_write(uint64_t utc_us, char text[UTC_TEXT_SIZE])
{
    const time_t seconds = (time_t)(utc_us / SECOND_US);
    struct tm utc;

    (void)gmtime_r(&seconds, &utc);
    (void)strftime(text, UTC_TEXT_SIZE, "%Y-%m-%dT%H:%M:%S", &utc);
    (void)snprintf(&text[SECONDS_LENGTH], UTC_TEXT_SIZE - SECONDS_LENGTH, ".%03uZ",
                   (unsigned)((utc_us % SECOND_US) / 1000U));
}

/* "0" stands for a digit. */
static bool has_form(const char *text, const char *form)
{
    for (; *form != '\0'; form++, text++) {
        const bool is_digit = (*text >= '0') && (*text <= '9');
        if ((*form == '0') ? !is_digit : (*text != *form)) {
            return false;
        }
    }
    return true;
}

/* From the point to the Z; NULL: not so. */
static const char *read_fraction(const char *text, uint64_t *fraction_us)
{
    uint64_t worth_us = SECOND_US;

    *fraction_us = 0U;
    if (*text != '.') {
        return text;
    }
    for (text++; (*text >= '0') && (*text <= '9'); text++) {
        worth_us /= 10U;
        *fraction_us += worth_us * (uint64_t)(*text - '0');
        if (worth_us == 0U) {
            return NULL;
        }
    }
    return (worth_us < SECOND_US) ? text : NULL;
}

/* A date that does not exist becomes another one. */
static bool is_same(const struct tm *one, const struct tm *other)
{
    return (one->tm_mday == other->tm_mday) && (one->tm_mon == other->tm_mon) &&
           (one->tm_hour == other->tm_hour) && (one->tm_min == other->tm_min) &&
           (one->tm_sec == other->tm_sec);
}

bool utc_text_read(const char *text, uint64_t *utc_us)
{
    struct tm said = {.tm_year = 0};
    struct tm meant;
    uint64_t fraction_us;

    if (!has_form(text, "0000-00-00T00:00:00")) {
        return false;
    }
    (void)sscanf(text, "%4d-%2d-%2dT%2d:%2d:%2d", &said.tm_year, &said.tm_mon, &said.tm_mday,
                 &said.tm_hour, &said.tm_min, &said.tm_sec);
    said.tm_year -= 1900;
    said.tm_mon -= 1;
    meant = said;
    const time_t seconds = timegm(&meant);
    const char *end = read_fraction(&text[SECONDS_LENGTH], &fraction_us);
    *utc_us = ((uint64_t)seconds * SECOND_US) + fraction_us;
    return (seconds >= 0) && is_same(&said, &meant) && (end != NULL) && (strcmp(end, "Z") == 0);
}
