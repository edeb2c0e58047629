/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/membranes/membrane_report.h"

#include "replay/membranes/force_csv.h"
#include "sensor/membrane_detector.h"
#include "sensor/membrane_noise.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#define UM_PER_MM 1000.0
#define MN_PER_N 1000.0
#define UN_PER_MN 1000.0
#define MOST_NOISE_MN 10000.0
#define MOST_FILE_BYTES (INT64_C(256) * 1024 * 1024)

/* A decimal number, up to `*end`. */
static bool read_number(const char *text, double least, double most, const char **end)
{
    char *stopped = NULL;
    const double value = strtod(text, &stopped);

    *end = &text[strspn(text, "+.0123456789eE")];
    return (*end != text) && (stopped == *end) && (value >= least) && (value <= most);
}

bool membrane_report_expect(membrane_report_t *self, const char *text)
{
    membrane_list_t list;
    const char *at = text;

    self->expected = 0U;
    for (bool more = true; more; self->expected++) {
        const char *end = NULL;
        if ((self->expected >= LIMIT_MEMBRANES_MOST) ||
            !read_number(at, 0.0, (double)LIMIT_MEMBRANE_DEEPEST_UM / UM_PER_MM, &end)) {
            return false;
        }
        self->depths_um[self->expected] = (int32_t)lrint(strtod(at, NULL) * UM_PER_MM);
        more = *end == ',';
        at = &end[more ? 1 : 0];
    }
    return (*at == '\0') &&
           (membrane_list_set(&list, self->depths_um, self->expected) == STATUS_OK);
}

bool membrane_report_take_noise(membrane_report_t *self, const char *text)
{
    const char *end = NULL;

    self->has_noise = read_number(text, 0.0, MOST_NOISE_MN, &end) && (*end == '\0');
    self->noise_un = self->has_noise ? (uint32_t)lrint(strtod(text, NULL) * UN_PER_MN) : 0U;
    return self->has_noise;
}

/* Size of a regular file that is not too large; -1 after a sentence. */
static int64_t size_of(FILE *file, const char *path)
{
    struct stat found;

    if (fstat(fileno(file), &found) != 0) {
        (void)fprintf(stderr, "%s: %s.\n", path, strerror(errno));
        return -1;
    }
    if (!S_ISREG(found.st_mode)) {
        (void)fprintf(stderr, "%s is no regular file.\n", path);
        return -1;
    }
    if ((int64_t)found.st_size > MOST_FILE_BYTES) {
        (void)fprintf(stderr, "%s is larger than %" PRId64 " bytes.\n", path, MOST_FILE_BYTES);
        return -1;
    }
    return (int64_t)found.st_size;
}

/* Nothing of it would be read behind a byte of 0. */
static bool is_text(const char *text, size_t count, const char *path)
{
    uint32_t line = 1U;

    if (strlen(text) == count) {
        return true;
    }
    for (const char *at = strchr(text, '\n'); at != NULL; at = strchr(&at[1], '\n')) {
        line++;
    }
    (void)fprintf(stderr, "%s, line %" PRIu32 ": it has a byte of 0, which is no text.\n", path,
                  line);
    return false;
}

static char *read_open(FILE *file, const char *path)
{
    const int64_t size = size_of(file, path);
    char *text = (size >= 0) ? malloc((size_t)size + 1U) : NULL;

    if (text != NULL) {
        const size_t count = fread(text, 1U, (size_t)size, file);
        text[count] = '\0';
        if (!is_text(text, count, path)) {
            free(text);
            text = NULL;
        }
    } else if (size >= 0) {
        (void)fprintf(stderr, "%s: there is no memory for it.\n", path);
    }
    return text;
}

/* All of a file, to be freed; NULL after a sentence. */
static char *read_all(const char *path)
{
    FILE *const file = fopen(path, "rb");

    if (file == NULL) {
        (void)fprintf(stderr, "%s: %s.\n", path, strerror(errno));
        return NULL;
    }
    char *const text = read_open(file, path);
    (void)fclose(file);
    return text;
}

static int32_t force_mn(const force_row_t *sample)
{
    return (int32_t)lrint(sample->force_n * MN_PER_N);
}

static int32_t depth_um(const force_row_t *sample)
{
    return (int32_t)lrint(sample->depth_mm * UM_PER_MM);
}

/* Noise of the beginning, while the needle rests. */
static bool measure_noise(const force_csv_t *csv, const char *path, uint32_t *noise_un)
{
    force_samples_t samples = {.csv = csv};
    force_row_t sample;
    membrane_noise_t noise;

    (void)memset(&noise, 0, sizeof noise);
    while (!membrane_noise_is_done(&noise)) {
        if (!force_samples_next(&samples, &sample) ||
            (abs(depth_um(&sample) - depth_um(&csv->rows[0])) >
             (int32_t)LIMIT_MEMBRANE_CSV_REST_UM)) {
            (void)fprintf(stderr,
                          "%s, line %" PRIu32 ": the needle has not rested for %u ms, in which the "
                          "noise is measured; give it by --noise.\n",
                          path, force_csv_line(samples.row + 1U),
                          LIMIT_MEMBRANE_SETTLE_MS + LIMIT_MEMBRANE_NOISE_MS);
            return false;
        }
        membrane_noise_step(&noise, force_mn(&sample));
    }
    *noise_un = membrane_noise_un(&noise);
    return true;
}

static bool is_in_window(const membrane_report_t *self, int32_t at_um)
{
    for (uint32_t i = 0U; i < self->expected; i++) {
        if (abs(at_um - self->depths_um[i]) <= (int32_t)LIMIT_MEMBRANE_WINDOW_UM) {
            return true;
        }
    }
    return false;
}

static void count(membrane_report_t *self, const membrane_event_t *event)
{
    if (event->kind == (uint32_t)MEMBRANE_EVENT_EXPECTED) {
        self->found++;
    } else if (event->kind == (uint32_t)MEMBRANE_EVENT_UNEXPECTED) {
        self->false_alarms++;
        self->false_in_window += is_in_window(self, event->depth_um) ? 1U : 0U;
    } else {
        /* It is not there. */
    }
}

/* One line. */
static void write_event(const membrane_report_t *self, const membrane_event_t *event,
                        double time_ms)
{
    const double at_mm = event->depth_um / UM_PER_MM;

    if (event->kind == (uint32_t)MEMBRANE_EVENT_MISSED) {
        (void)printf("%.0f ms: missed the membrane at %.3f mm\n", time_ms, at_mm);
        return;
    }
    (void)printf("%.0f ms: puncture at %.3f mm, a fall of %.3f N or more", time_ms, at_mm,
                 event->fall_mn / MN_PER_N);
    if (event->kind == (uint32_t)MEMBRANE_EVENT_EXPECTED) {
        (void)printf(", expected at %.3f mm", self->depths_um[event->place] / UM_PER_MM);
    } else if (self->expected > 0U) {
        (void)printf(", unexpected");
    } else {
        /* Nothing was expected. */
    }
    (void)printf("\n");
}

/* A membrane that the needle has passed by less than its window is missed, too; one that it has not
 * reached is not. */
static void end_insertion(membrane_report_t *self, membrane_list_t *list, int32_t deepest_um,
                          double time_ms)
{
    const int32_t behind_um = deepest_um + (int32_t)LIMIT_MEMBRANE_WINDOW_UM;

    for (uint32_t i = 0U; i < LIMIT_MEMBRANES_MOST; i++) {
        const uint32_t place = membrane_list_pass(list, behind_um);
        if (place != MEMBRANE_NONE) {
            const membrane_event_t event = {.kind = (uint32_t)MEMBRANE_EVENT_MISSED,
                                            .place = place,
                                            .depth_um = self->depths_um[place]};
            write_event(self, &event, time_ms);
        }
    }
    const uint32_t left = membrane_list_left(list);
    if (left > 0U) {
        (void)printf("the recording ends before %" PRIu32 " of the expected membranes\n", left);
    }
    self->passed += self->expected - left;
    self->insertions++;
}

static void write_insertion(membrane_report_t *self, const force_csv_t *csv, uint32_t noise_un)
{
    int32_t deepest_um = 0;
    force_samples_t samples = {.csv = csv};
    force_row_t sample = {.time_ms = 0.0};
    membrane_detector_t detector;
    membrane_list_t list = {.count = 0U};

    membrane_detector_init(&detector, noise_un);
    (void)membrane_list_set(&list, self->depths_um, self->expected);
    (void)printf("noise %.4f N behind the filter: no fall below %.3f N is found\n",
                 noise_un / UN_PER_MN / MN_PER_N,
                 membrane_detector_floor_un(&detector) / UN_PER_MN / MN_PER_N);
    while (force_samples_next(&samples, &sample)) {
        deepest_um = (depth_um(&sample) > deepest_um) ? depth_um(&sample) : deepest_um;
        const membrane_view_t view = {.force_mn = force_mn(&sample),
                                      .depth_um = depth_um(&sample),
                                      .is_inserting = true,
                                      .is_blind = false};
        const membrane_event_t event = membrane_detector_step(&detector, &list, &view);
        if (event.kind != (uint32_t)MEMBRANE_EVENT_NONE) {
            write_event(self, &event, sample.time_ms);
            count(self, &event);
        }
    }
    end_insertion(self, &list, deepest_um, sample.time_ms);
}

bool membrane_report_file(membrane_report_t *self, const char *path)
{
    force_csv_t csv;
    uint32_t noise_un = self->noise_un;
    char *const text = read_all(path);

    if (text == NULL) {
        return false;
    }
    const uint32_t line = force_csv_read(&csv, text);
    free(text);
    if (line != 0U) {
        (void)fprintf(stderr, "%s, line %" PRIu32 ": %s.\n", path, line, csv.refused);
        return false;
    }
    const bool is_known = self->has_noise || measure_noise(&csv, path, &noise_un);
    if (is_known) {
        (void)printf("%s: ", path);
        write_insertion(self, &csv, noise_un);
    }
    force_csv_free(&csv);
    return is_known;
}

/* `whole` is not 0. */
static double share(uint32_t part, uint32_t whole)
{
    return (double)part / (double)whole;
}

void membrane_report_end(const membrane_report_t *self)
{
    const uint32_t punctures = self->found + self->false_alarms;

    if (self->expected == 0U) {
        return;
    }
    if (self->passed == 0U) {
        (void)printf("no expected membrane was passed");
    } else {
        (void)printf("found %" PRIu32 " of %" PRIu32 " membranes, recall %.1f %%", self->found,
                     self->passed, 100.0 * share(self->found, self->passed));
    }
    (void)printf("; insertions: %" PRIu32 "\n", self->insertions);
    (void)printf("false alarms per insertion: %.2f with the window, %.2f without\n",
                 share(self->false_in_window, self->insertions),
                 share(self->false_alarms, self->insertions));
    if (punctures > 0U) {
        (void)printf("precision without the window: %.1f %%\n",
                     100.0 * share(self->found, punctures));
    }
}
