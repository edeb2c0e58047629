/* SPDX-License-Identifier: Apache-2.0 */
#include "sim/model/sim_phantom.h"

#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define BLANKS " \t\r"
#define LINE_SIZE 96U
#define FIELDS_MOST 16U
#define COUNT_OF(array) ((uint32_t)(sizeof(array) / sizeof((array)[0])))

/* A key, the place of its number in its part, and its range. */
typedef struct {
    const char *key;
    size_t offset;
    double least;
    double most;
} field_t;

typedef enum {
    PART_WHOLE = 0,
    PART_LAYER = 1,
    PART_CELL = 2,
    PART_NEEDLE = 3,
    PART_TARGET = 4,
    PART_IMAGES = 5
} part_kind_t;

typedef struct {
    const char *name;
    const field_t *fields;
    uint32_t count;
} part_t;

#define WHOLE(member) offsetof(sim_phantom_t, member)
static const field_t whole_fields[] = {{"surface_mm", WHOLE(surface_mm), -1000.0, 1000.0},
                                       {"presliding_mm", WHOLE(presliding_mm), 0.01, 5.0},
                                       {"stick_mm_per_s", WHOLE(stick_mm_per_s), 0.0, 1.0}};

#define LAYER(member) offsetof(sim_layer_t, member)
static const field_t layer_fields[] = {
    {"thickness_mm", LAYER(thickness_mm), 0.1, 1000.0},
    {"rupture_n", LAYER(rupture_n), 0.0, 20.0},
    {"rupture_fast_share", LAYER(rupture_fast_share), 0.0, 1.0},
    {"rupture_half_speed_mm_per_s", LAYER(rupture_half_speed_mm_per_s), 0.01, 1000.0},
    {"stiffness_n_per_mm", LAYER(stiffness_n_per_mm), 0.0, 10.0},
    {"stiffening_n_per_mm2", LAYER(stiffening_n_per_mm2), 0.0, 10.0},
    {"cutting_n", LAYER(cutting_n), 0.0, 20.0},
    {"friction_in_n_per_mm", LAYER(friction_in_n_per_mm), 0.0, 1.0},
    {"friction_out_n_per_mm", LAYER(friction_out_n_per_mm), 0.0, 1.0},
    {"viscous_in_n_s_per_mm2", LAYER(viscous_in_n_s_per_mm2), 0.0, 1.0},
    {"viscous_out_n_s_per_mm2", LAYER(viscous_out_n_s_per_mm2), 0.0, 1.0},
    {"stick_in_n_per_mm", LAYER(stick_in_n_per_mm), 0.0, 1.0},
    {"stick_out_n_per_mm", LAYER(stick_out_n_per_mm), 0.0, 1.0},
    {"relaxing_share", LAYER(relaxing_share), 0.0, 0.9},
    {"relaxing_s", LAYER(relaxing_s), 0.01, 100.0}};

#define CELL(member) offsetof(sim_load_cell_config_t, member)
static const field_t cell_fields[] = {
    {"noise_n", CELL(noise_n), 0.0, 10.0},
    {"drift_n_per_s", CELL(drift_n_per_s), -10.0, 10.0},
    {"offset_n", CELL(offset_n), -20.0, 20.0},
    {"latency_ms", CELL(latency_ms), 0.0, SIM_LOAD_CELL_LATENCY_MOST}};

#define NEEDLE(member) offsetof(sim_bevel_config_t, member)
static const field_t needle_fields[] = {
    {"curvature_per_mm", NEEDLE(curvature_per_mm), 0.0, SIM_CURVATURE_MOST_PER_MM},
    {"torsion_deg_per_100_mm", NEEDLE(torsion_deg_per_100_mm), 0.0, SIM_TORSION_MOST_DEG}};

#define TARGET(member) offsetof(sim_target_t, member)
static const field_t target_fields[] = {{"x_mm", TARGET(x_mm), -100.0, 100.0},
                                        {"y_mm", TARGET(y_mm), -100.0, 100.0},
                                        {"depth_mm", TARGET(depth_mm), 0.0, 1000.0},
                                        {"push_share", TARGET(push_share), 0.0, 1.0},
                                        {"push_most_mm", TARGET(push_most_mm), 0.0, 10.0},
                                        {"shift_x_mm", TARGET(shift_x_mm), -10.0, 10.0},
                                        {"shift_y_mm", TARGET(shift_y_mm), -10.0, 10.0},
                                        {"shift_from_mm", TARGET(shift_from_mm), 0.0, 1000.0},
                                        {"shift_to_mm", TARGET(shift_to_mm), 0.0, 1000.0}};

#define IMAGES(member) offsetof(sim_imager_config_t, member)
static const field_t images_fields[] = {
    {"period_ms", IMAGES(period_ms), 0.0, SIM_IMAGE_MOST_MS},
    {"delay_ms", IMAGES(delay_ms), 0.0, SIM_IMAGE_MOST_MS},
    {"noise_mm", IMAGES(noise_mm), 0.0, SIM_IMAGE_NOISE_MOST_MM},
    {"noise_deg", IMAGES(noise_deg), 0.0, SIM_IMAGE_NOISE_MOST_DEG}};

/* In the order of part_kind_t. */
static const part_t parts[] = {{"phantom", whole_fields, COUNT_OF(whole_fields)},
                               {"layer", layer_fields, COUNT_OF(layer_fields)},
                               {"cell", cell_fields, COUNT_OF(cell_fields)},
                               {"needle", needle_fields, COUNT_OF(needle_fields)},
                               {"target", target_fields, COUNT_OF(target_fields)},
                               {"images", images_fields, COUNT_OF(images_fields)}};

const char *const sim_cell_words[] = {"hand", "needle", NULL};

/* Skin and what is behind it; the prostate behind its capsule, as far as the needle goes. */
const sim_phantom_file_t sim_phantom_usual = {
    .tissue = {.surface_mm = 30.0,
               .presliding_mm = 0.2,
               .stick_mm_per_s = 0.05,
               .layer_count = 2U,
               .layers = {{.thickness_mm = 35.0,
                           .rupture_n = 2.0,
                           .rupture_fast_share = 0.7,
                           .rupture_half_speed_mm_per_s = 3.0,
                           .stiffness_n_per_mm = 0.12,
                           .stiffening_n_per_mm2 = 0.1,
                           .cutting_n = 0.25,
                           .friction_in_n_per_mm = 0.008,
                           .friction_out_n_per_mm = 0.008,
                           .viscous_in_n_s_per_mm2 = 0.0005,
                           .viscous_out_n_s_per_mm2 = 0.0005,
                           .stick_in_n_per_mm = 0.012,
                           .stick_out_n_per_mm = 0.012,
                           .relaxing_share = 0.45,
                           .relaxing_s = 0.5},
                          {.thickness_mm = 105.0,
                           .rupture_n = 1.2,
                           .rupture_fast_share = 0.7,
                           .rupture_half_speed_mm_per_s = 3.0,
                           .stiffness_n_per_mm = 0.1,
                           .stiffening_n_per_mm2 = 0.08,
                           .cutting_n = 0.35,
                           .friction_in_n_per_mm = 0.012,
                           .friction_out_n_per_mm = 0.012,
                           .viscous_in_n_s_per_mm2 = 0.0008,
                           .viscous_out_n_s_per_mm2 = 0.0008,
                           .stick_in_n_per_mm = 0.018,
                           .stick_out_n_per_mm = 0.018,
                           .relaxing_share = 0.45,
                           .relaxing_s = 0.5}}},
    .cells = {{.noise_n = 0.02, .drift_n_per_s = 0.00005, .latency_ms = 2.0},
              {.noise_n = 0.02, .drift_n_per_s = -0.00005, .latency_ms = 2.0}},
    .needle = {.curvature_per_mm = 0.0041, .torsion_deg_per_100_mm = 45.0},
    .images = {.period_ms = 2000.0, .delay_ms = 500.0, .noise_mm = 0.5, .noise_deg = 0.5}};

const sim_target_t sim_target_usual = {.depth_mm = 100.0,
                                       .push_share = 0.05,
                                       .push_most_mm = 3.0,
                                       .shift_x_mm = 3.2,
                                       .shift_y_mm = -2.4,
                                       .shift_from_mm = 10.0,
                                       .shift_to_mm = 50.0};

/* Reading of a text: the part under way, and where it began. */
typedef struct {
    sim_phantom_file_t *phantom;
    part_kind_t kind;
    void *place;             /* Of the part. */
    uint32_t begun_at;       /* Its line. */
    uint32_t reported;       /* Bit n: field n has its number. */
    uint32_t cells_reported; /* Bit n: cell n has its part. */
    uint32_t
        kinds_reported; /* Bit n: the part of this kind is there, if there is one of it only. */
    uint32_t line;
    char *reason;
    uint32_t reason_size;
} reader_t;

static bool refuse(const reader_t *self, uint32_t line, const char *says, const char *word)
{
    (void)snprintf(self->reason, self->reason_size, "line %u: %s \"%.40s\".", (unsigned)line, says,
                   word);
    return false;
}

static double *number_at(const void *place, const field_t *field)
{
    return (double *)((uintptr_t)place + field->offset);
}

/* All keys of the part under way have come. */
static bool end_part(const reader_t *self)
{
    const part_t *const part = &parts[self->kind];

    for (uint32_t i = 0U; i < part->count; i++) {
        if (((self->reported >> i) & 1U) == 0U) {
            return refuse(self, self->begun_at,
                          (self->kind == PART_WHOLE) ? "the phantom has no"
                                                     : "the part that begins here has no",
                          part->fields[i].key);
        }
    }
    return true;
}

static bool begin_part(reader_t *self, part_kind_t kind, void *place)
{
    const bool is_ended = end_part(self);

    self->kind = kind;
    self->place = place;
    self->begun_at = self->line;
    self->reported = 0U;
    return is_ended;
}

static bool begin_layer(reader_t *self, const char *more)
{
    sim_phantom_t *const tissue = &self->phantom->tissue;

    if (more[0] != '\0') {
        return refuse(self, self->line, "nothing may stand behind layer, as does", more);
    }
    if (tissue->layer_count == SIM_LAYERS) {
        return refuse(self, self->line, "there are too many parts called", "layer");
    }
    tissue->layer_count++;
    return begin_part(self, PART_LAYER, &tissue->layers[tissue->layer_count - 1U]);
}

static bool begin_cell(reader_t *self, const char *name)
{
    for (uint32_t i = 0U; i < SIM_CELLS; i++) {
        const uint32_t bit = 1U << i;
        if (strcmp(name, sim_cell_words[i]) == 0) {
            if ((self->cells_reported & bit) != 0U) {
                return refuse(self, self->line, "there is a second part of the cell", name);
            }
            self->cells_reported |= bit;
            return begin_part(self, PART_CELL, &self->phantom->cells[i]);
        }
    }
    return refuse(self, self->line, "a cell is \"hand\" or \"needle\", not", name);
}

/* False: it begins no part of which there is one. */
static bool begins_single(const char *name, part_kind_t *kind)
{
    bool is_found = false;

    for (uint32_t i = (uint32_t)PART_NEEDLE; i < COUNT_OF(parts); i++) {
        if (strcmp(name, parts[i].name) == 0) {
            *kind = (part_kind_t)i;
            is_found = true;
        }
    }
    return is_found;
}

static bool begin_single(reader_t *self, part_kind_t kind, const char *more)
{
    sim_phantom_file_t *const phantom = self->phantom;
    const uint32_t bit = 1U << (uint32_t)kind;
    void *const place = (kind == PART_NEEDLE)   ? (void *)&phantom->needle
                        : (kind == PART_TARGET) ? (void *)&phantom->target
                                                : (void *)&phantom->images;

    if (more[0] != '\0') {
        char says[LINE_SIZE];
        (void)snprintf(says, sizeof says, "nothing may stand behind %s, as does", parts[kind].name);
        return refuse(self, self->line, says, more);
    }
    if ((self->kinds_reported & bit) != 0U) {
        return refuse(self, self->line, "there is a second part called", parts[kind].name);
    }
    self->kinds_reported |= bit;
    return begin_part(self, kind, place);
}

static bool take_number(const reader_t *self, const field_t *field, const char *word)
{
    char *end = NULL;
    const double value = strtod(word, &end);

    if ((end == word) || (*end != '\0') || !(value >= field->least) || !(value <= field->most)) {
        char says[LINE_SIZE];
        (void)snprintf(says, sizeof says, "%s is a number from %.10g to %.10g, not", field->key,
                       field->least, field->most);
        return refuse(self, self->line, says, word);
    }
    *number_at(self->place, field) = value;
    return true;
}

static bool take_field(reader_t *self, const char *key, const char *word)
{
    const part_t *const part = &parts[self->kind];

    for (uint32_t i = 0U; i < part->count; i++) {
        const uint32_t bit = 1U << i;
        if (strcmp(key, part->fields[i].key) == 0) {
            if ((self->reported & bit) != 0U) {
                return refuse(self, self->line, "a second time there is", key);
            }
            self->reported |= bit;
            return take_number(self, &part->fields[i], word);
        }
    }
    char says[LINE_SIZE];
    (void)snprintf(says, sizeof says, "a %s has no", part->name);
    return refuse(self, self->line, says, key);
}

/* Its end and its start. */
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

static bool take_line(reader_t *self, char *line)
{
    char *const key = without_blanks(line);
    char *word = &key[strcspn(key, BLANKS)];

    if ((key[0] == '\0') || (key[0] == '#')) {
        return true;
    }
    if (word[0] != '\0') {
        *word = '\0';
        word = without_blanks(&word[1]);
    }
    part_kind_t single;
    if (strcmp(key, parts[PART_LAYER].name) == 0) {
        return begin_layer(self, word);
    }
    if (begins_single(key, &single)) {
        return begin_single(self, single, word);
    }
    return (strcmp(key, parts[PART_CELL].name) == 0) ? begin_cell(self, word)
                                                     : take_field(self, key, word);
}

static bool read_lines(reader_t *self, const char *text)
{
    const char *at = text;
    bool is_good = true;

    while (is_good && (*at != '\0')) {
        char line[LINE_SIZE];
        const size_t length = strcspn(at, "\n");
        self->line++;
        if (length >= sizeof line) {
            return refuse(self, self->line, "too long is", at);
        }
        (void)memcpy(line, at, length);
        line[length] = '\0';
        is_good = take_line(self, line);
        at += length + ((at[length] == '\n') ? 1U : 0U);
    }
    return is_good;
}

bool sim_phantom_read(sim_phantom_file_t *self, const char *text, char *reason,
                      uint32_t reason_size)
{
    reader_t reader = {.phantom = self,
                       .kind = PART_WHOLE,
                       .place = &self->tissue,
                       .begun_at = 1U,
                       .reason = reason,
                       .reason_size = reason_size};

    (void)memset(self, 0, sizeof *self);
    if (!read_lines(&reader, text) || !end_part(&reader)) {
        return false;
    }
    for (uint32_t i = 0U; i < SIM_CELLS; i++) {
        if (((reader.cells_reported >> i) & 1U) == 0U) {
            return refuse(&reader, reader.line, "there is no part of the cell", sim_cell_words[i]);
        }
    }
    return true;
}

static uint32_t write_fields(part_kind_t kind, const void *place, char *text, uint32_t size,
                             uint32_t length)
{
    const part_t *const part = &parts[kind];
    uint32_t end = length;

    for (uint32_t i = 0U; (i < part->count) && (end < size); i++) {
        end += (uint32_t)snprintf(&text[end], size - end, "%s %.10g\n", part->fields[i].key,
                                  *number_at(place, &part->fields[i]));
    }
    return end;
}

static uint32_t write_title(char *text, uint32_t size, uint32_t length, const char *title,
                            const char *name)
{
    return (length < size) ? (length + (uint32_t)snprintf(&text[length], size - length, "\n%s%s\n",
                                                          title, name))
                           : length;
}

void sim_phantom_write(const sim_phantom_file_t *self, char *text, uint32_t size)
{
    uint32_t length = write_fields(PART_WHOLE, &self->tissue, text, size, 0U);

    for (uint32_t i = 0U; i < self->tissue.layer_count; i++) {
        length = write_title(text, size, length, "layer", "");
        length = write_fields(PART_LAYER, &self->tissue.layers[i], text, size, length);
    }
    for (uint32_t i = 0U; i < SIM_CELLS; i++) {
        length = write_title(text, size, length, "cell ", sim_cell_words[i]);
        length = write_fields(PART_CELL, &self->cells[i], text, size, length);
    }
    length = write_title(text, size, length, parts[PART_NEEDLE].name, "");
    length = write_fields(PART_NEEDLE, &self->needle, text, size, length);
    length = write_title(text, size, length, parts[PART_TARGET].name, "");
    length = write_fields(PART_TARGET, &self->target, text, size, length);
    length = write_title(text, size, length, parts[PART_IMAGES].name, "");
    (void)write_fields(PART_IMAGES, &self->images, text, size, length);
}
