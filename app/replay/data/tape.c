/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/data/tape.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A number that is not whole is given with seven digits: the tenth of a micrometre for people. */
#define FORMAT "%.7g"
#define WHOLE_FORMAT "%.0f"
#define NUMBER_SIZE 32U

/* A row as it is made. */
typedef struct {
    tape_t *tape;
    bytes_t *row;
    double cycles;
    uint32_t place;    /* Place of the value that is looked at. */
    uint32_t reported; /* The last value that was given. */
    bool with_numbers;
    bool is_reported;
    bool is_rebuilt;
} reporter_t;

static bool is_container(const cJSON *value)
{
    return cJSON_IsObject(value) || cJSON_IsArray(value);
}

static uint32_t count_places(const cJSON *value)
{
    uint32_t count = 1U;

    for (const cJSON *inner = value->child; inner != NULL; inner = inner->next) {
        count += count_places(inner);
    }
    return count;
}

/* Two of one kind that hold as many, by the same names. */
static bool have_same_parts(const cJSON *one, const cJSON *other)
{
    const cJSON *a = one->child;
    const cJSON *b = other->child;

    while ((a != NULL) && (b != NULL)) {
        if ((a->string != NULL) && (b->string != NULL) && (strcmp(a->string, b->string) != 0)) {
            return false;
        }
        a = a->next;
        b = b->next;
    }
    return (a == NULL) && (b == NULL) && (cJSON_IsObject(one) == cJSON_IsObject(other));
}

/* Two values that hold no others. */
static bool are_equal(const cJSON *one, const cJSON *other)
{
    if (cJSON_IsString(one) && cJSON_IsString(other)) {
        return strcmp(one->valuestring, other->valuestring) == 0;
    }
    return (cJSON_IsNull(one) && cJSON_IsNull(other)) ||
           (cJSON_IsTrue(one) && cJSON_IsTrue(other)) ||
           (cJSON_IsFalse(one) && cJSON_IsFalse(other));
}

static void report_place(reporter_t *self, uint32_t place)
{
    bytes_print(self->row, ",%u,", (unsigned)(place - self->reported));
    self->reported = place;
    self->is_reported = true;
}

/* As the reader has it then. */
static double write_number(double number, char text[NUMBER_SIZE])
{
    (void)snprintf(text, NUMBER_SIZE, (rint(number) == number) ? WHOLE_FORMAT : FORMAT, number);
    return strtod(text, NULL);
}

static void report_number(reporter_t *self, uint32_t place, cJSON *shown, double number)
{
    double *const rate = &self->tape->rates[place];
    const double before = shown->valuedouble;
    char text[NUMBER_SIZE];

    if (!self->with_numbers) {
        return;
    }
    shown->valuedouble = write_number(number, text);
    if (shown->valuedouble != (before + (*rate * self->cycles))) {
        const double change = (shown->valuedouble - before) / self->cycles;
        report_place(self, place);
        bytes_print(self->row, "%s", text);
        *rate = (rint(change) == change) ? change : 0.0;
    }
}

static void report_other(reporter_t *self, uint32_t place, cJSON *parent, cJSON *shown,
                         const cJSON *now)
{
    char *const text = cJSON_PrintUnformatted(now);
    cJSON *const copy = cJSON_Duplicate(now, true);

    if ((text == NULL) || (copy == NULL)) {
        abort();
    }
    report_place(self, place);
    bytes_print(self->row, "%s", text);
    self->is_rebuilt = self->is_rebuilt || is_container(shown) || is_container(now);
    self->tape->rates[place] = 0.0;
    if ((parent == NULL) || !cJSON_ReplaceItemViaPointer(parent, shown, copy)) {
        cJSON_Delete(shown);
        self->tape->shown = copy;
    }
    cJSON_free(text);
}

static void report(reporter_t *self, cJSON *parent, cJSON *shown, const cJSON *now)
{
    const uint32_t place = self->place;

    self->place++;
    if (cJSON_IsNumber(shown) && cJSON_IsNumber(now)) {
        report_number(self, place, shown, now->valuedouble);
    } else if (is_container(shown) && is_container(now) && have_same_parts(shown, now)) {
        const cJSON *inner = now->child;
        for (cJSON *part = shown->child; part != NULL; inner = inner->next) {
            cJSON *const next = part->next;
            report(self, shown, part, inner);
            part = next;
        }
    } else if (!are_equal(shown, now)) {
        self->place = place + count_places(shown);
        report_other(self, place, parent, shown, now);
    } else {
        /* It is as it was. */
    }
}

/* After what has other places: all numbers stand. */
static void rebuild(tape_t *self)
{
    self->places = count_places(self->shown);
    free(self->rates);
    self->rates = calloc(self->places, sizeof self->rates[0]);
    if (self->rates == NULL) {
        abort();
    }
}

bool tape_take(tape_t *self, uint32_t cycle, bool with_numbers, const cJSON *now, bytes_t *row)
{
    const size_t used = row->used;

    if (self->shown == NULL) {
        self->shown = cJSON_CreateNull();
        rebuild(self);
    }
    reporter_t reporter = {.tape = self,
                           .row = row,
                           .cycles = (double)(cycle - self->counted),
                           .with_numbers = with_numbers};
    bytes_print(row, "[%s%u", with_numbers ? "" : "-", (unsigned)(cycle - self->cycle));
    report(&reporter, NULL, self->shown, now);
    bytes_put8(row, (uint8_t)']');
    if (!with_numbers && !reporter.is_reported) {
        row->used = used;
        return false;
    }
    self->cycle = cycle;
    self->counted = with_numbers ? cycle : self->counted;
    if (reporter.is_rebuilt) {
        rebuild(self);
    }
    return true;
}

void tape_free(tape_t *self)
{
    cJSON_Delete(self->shown);
    free(self->rates);
    (void)memset(self, 0, sizeof *self);
}
