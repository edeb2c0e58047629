/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/data/series.h"

#include "base/rigid.h"
#include "common/axis_terms.h"

#include <stdint.h>
#include <stdio.h>
#include <string.h>

#define NM_PER_MM 1e6
#define ONE_Q8 256.0
#define ONE_Q30 1073741824.0
#define DECIMALS_NM 6
#define DECIMALS_Q8 8
#define DECIMALS_Q30 10
#define DECIMALS_UNIT 6
#define HASH_START 2166136261U
#define HASH_FACTOR 16777619U

/* Where the series of one field go. */
typedef struct {
    const field_t *field;
    const axis_config_t *axis;
    char stem[SERIES_NAME_SIZE / 2U]; /* The name without what comes behind. */
    series_sink_t *sink;
    void *to;
} reporter_t;

static uint32_t word_of(const void *from)
{
    uint32_t word;

    (void)memcpy(&word, from, sizeof word);
    return word;
}

static int32_t number_of(const void *from)
{
    int32_t number;

    (void)memcpy(&number, from, sizeof number);
    return number;
}

static void report_number(const reporter_t *self, const char *unit, double number, int decimals)
{
    series_t series = {.says = self->field->says, .number = number, .decimals = decimals};

    (void)snprintf(series.name, sizeof series.name, "%s%s", self->stem, unit);
    self->sink(self->to, &series);
}

static void report_flag(const reporter_t *self, bool is_set)
{
    series_t series = {
        .says = self->field->says, .kind = SERIES_FLAG, .number = is_set ? 1.0 : 0.0};

    (void)snprintf(series.name, sizeof series.name, "%s", self->stem);
    self->sink(self->to, &series);
}

static void add_word(series_t *series, const char *word)
{
    const size_t used = strlen(series->word);

    (void)snprintf(&series->word[used], sizeof series->word - used, "%s%s", (used > 0U) ? " " : "",
                   word);
}

static void report_words(const reporter_t *self, uint32_t value)
{
    series_t series = {.says = self->field->says, .kind = SERIES_WORD};

    (void)snprintf(series.name, sizeof series.name, "%s", self->stem);
    if (self->field->kind == FIELD_WORD) {
        add_word(&series, self->field->word((int32_t)value));
    }
    for (uint32_t i = 0U; (self->field->kind == FIELD_SET) && (i < 32U); i++) {
        if (((value >> i) & 1U) != 0U) {
            add_word(&series, self->field->word((int32_t)i));
        }
    }
    self->sink(self->to, &series);
}

static void report_point(const reporter_t *self, const point_t *point)
{
    report_number(self, "_x_mm", (double)point->x_nm / NM_PER_MM, DECIMALS_NM);
    report_number(self, "_y_mm", (double)point->y_nm / NM_PER_MM, DECIMALS_NM);
    report_number(self, "_z_mm", (double)point->z_nm / NM_PER_MM, DECIMALS_NM);
}

static void report_rigid(const reporter_t *self, const rigid_t *rigid)
{
    report_point(self, &rigid->translation);
    for (uint32_t i = 0U; i < 9U; i++) {
        char place[8];
        (void)snprintf(place, sizeof place, "_r%u%u", (unsigned)((i / 3U) + 1U),
                       (unsigned)((i % 3U) + 1U));
        report_number(self, place, (double)rigid->rotation_q30[i / 3U][i % 3U] / ONE_Q30,
                      DECIMALS_Q30);
    }
}

/* In the axis' unit, instead of the last `dropped` letters of the name. */
static void report_in_unit(const reporter_t *self, size_t dropped, double ticks, const char *behind)
{
    reporter_t other = *self;
    char unit[16];

    if (self->axis == NULL) {
        return;
    }
    other.stem[strlen(other.stem) - dropped] = '\0';
    (void)snprintf(unit, sizeof unit, "_%s%s",
                   (self->axis->unit == (uint8_t)AXIS_UNIT_MM) ? "mm" : "deg", behind);
    report_number(&other, unit, ticks * axis_terms_unit(self->axis), DECIMALS_UNIT);
}

static void report_speed(reporter_t *self, double ticks_per_s)
{
    self->stem[strlen(self->stem) - strlen("_q8")] = '\0';
    report_number(self, "", ticks_per_s, DECIMALS_Q8);
    report_in_unit(self, strlen("_ticks_per_s"), ticks_per_s, "_per_s");
}

static void report_inside(const reporter_t *self, const uint8_t *from);

static void report_element(reporter_t *self, const uint8_t *from)
{
    point_t point;
    rigid_t rigid;

    switch (self->field->kind) {
    case FIELD_SIGNED:
        report_number(self, "", (double)number_of(from), 0);
        break;
    case FIELD_POSITION:
        report_number(self, "", (double)number_of(from), 0);
        report_in_unit(self, strlen("_ticks"), (double)number_of(from), "");
        break;
    case FIELD_SPEED:
        report_speed(self, (double)number_of(from) / ONE_Q8);
        break;
    case FIELD_FLAG:
        report_flag(self, word_of(from) != 0U);
        break;
    case FIELD_WORD:
    case FIELD_SET:
        report_words(self, word_of(from));
        break;
    case FIELD_POINT:
        (void)memcpy(&point, from, sizeof point);
        report_point(self, &point);
        break;
    case FIELD_RIGID:
        (void)memcpy(&rigid, from, sizeof rigid);
        report_rigid(self, &rigid);
        break;
    case FIELD_INSIDE:
        report_inside(self, from);
        break;
    case FIELD_WIDE: /* No structure that is given has one. */
    case FIELD_UNSIGNED:
    default:
        report_number(self, "", (double)word_of(from), 0);
        break;
    }
}

/* A structure in a structure: its name stands before those of its fields. */
static void report_inside(const reporter_t *self, const uint8_t *from)
{
    reporter_t inner = *self;

    for (inner.field = self->field->inside; inner.field->name != NULL; inner.field++) {
        (void)snprintf(inner.stem, sizeof inner.stem, "%s_%s", self->field->name,
                       inner.field->name);
        report_element(&inner, &from[inner.field->offset]);
    }
}

static void report_array(reporter_t *self, const uint8_t *from)
{
    const field_t *const field = self->field;

    for (size_t i = 0U; i < (field->size / field->element_size); i++) {
        (void)snprintf(self->stem, sizeof self->stem, "%s_%zu", field->name, i);
        report_element(self, &from[i * field->element_size]);
    }
}

void series_report(const field_t *fields, const void *from, const axis_config_t *axis,
                   series_sink_t *sink, void *to)
{
    reporter_t self = {.axis = axis, .sink = sink, .to = to};

    for (self.field = fields; self.field->name != NULL; self.field++) {
        const uint8_t *const at = (const uint8_t *)from + self.field->offset;
        const bool is_array = self.field->element_size < self.field->size;
        if (is_array && (self.field->inside == NULL)) {
            report_array(&self, at);
        } else if (!is_array) {
            (void)snprintf(self.stem, sizeof self.stem, "%s", self.field->name);
            report_element(&self, at);
        } else {
            /* Each element is given by itself. */
        }
    }
}

static bool is_state(const field_t *field)
{
    return (field->kind == FIELD_FLAG) || (field->kind == FIELD_WORD) || (field->kind == FIELD_SET);
}

uint32_t series_states(const field_t *fields, const void *from)
{
    uint32_t hash = HASH_START;

    for (const field_t *field = fields; field->name != NULL; field++) {
        const uint8_t *const at = (const uint8_t *)from + field->offset;
        for (size_t i = 0U; i < field->size; i += field->element_size) {
            if (is_state(field)) {
                hash = (hash ^ word_of(&at[i])) * HASH_FACTOR;
            } else if (field->inside != NULL) {
                hash = (hash ^ series_states(field->inside, &at[i])) * HASH_FACTOR;
            } else {
                /* A number. */
            }
        }
    }
    return hash;
}

void series_write(const series_t *self, char *text, size_t size)
{
    if (self->kind == SERIES_NUMBER) {
        (void)snprintf(text, size, "%.*f", self->decimals, self->number);
    } else if (self->kind == SERIES_FLAG) {
        (void)snprintf(text, size, "%s", (self->number != 0.0) ? "true" : "false");
    } else {
        (void)snprintf(text, size, "%s", (self->word[0] != '\0') ? self->word : "none");
    }
}
