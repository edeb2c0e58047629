/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/verify/walk.h"

#include "replay/verify/build_fit.h"

#include <inttypes.h>
#include <string.h>

void walk_begin(walk_t *self, bool is_of_run, FILE *notes)
{
    (void)memset(self, 0, sizeof *self);
    self->is_of_run = is_of_run;
    self->notes = notes;
    coverage_begin(&self->coverage, is_of_run);
    replay_init(&self->replay);
}

/* Alone it has been named by who asks for it. */
static void report_finding(const walk_t *self, const char *path, const char *sentence)
{
    (void)fflush(stdout);
    if (self->is_of_run && (strstr(sentence, path) == NULL)) {
        (void)fprintf(stderr, "%s: ", path);
    }
    (void)fprintf(stderr, "%s\n", sentence);
}

/* A run has one robot. */
static bool take_robot(walk_t *self, const char *path)
{
    const robot_t *const robot = build_fit(&self->reader);
    const bool is_other = (self->robot != NULL) && (robot != NULL) && (robot != self->robot);

    if (is_other) {
        report_finding(self, path, "It is of another robot than what was recorded before it.");
    }
    self->robot = robot;
    return (robot != NULL) && !is_other;
}

bool walk_open(walk_t *self, const char *path)
{
    recording_finding_t finding;
    const recording_verdict_t verdict = recording_reader_open(&self->reader, path, &finding);

    if (verdict != RECORDING_WHOLE) {
        report_finding(self, path, finding.sentence);
    }
    if ((verdict != RECORDING_WHOLE) && (verdict != RECORDING_CUT_SHORT)) {
        return false;
    }
    self->path = path;
    coverage_open(&self->coverage, path, self->notes);
    again_begin(&self->again);
    self->had_end = self->has_run_end;
    if (self->recordings == 0U) {
        build_fit_mention(&self->reader);
    }
    self->is_cut_short = verdict == RECORDING_CUT_SHORT;
    self->has_run_end = self->has_run_end || self->reader.is_run_end;
    self->recordings++;
    self->taken = 0U;
    return take_robot(self, path);
}

void walk_close(walk_t *self)
{
    recording_reader_close(&self->reader);
}

bool walk_take(walk_t *self)
{
    const bool is_taken = recording_reader_next(&self->reader, &self->record, &self->known);

    self->taken += is_taken ? 1U : 0U;
    return is_taken;
}

bool walk_replay(walk_t *self)
{
    self->is_again = self->replay.is_running && (self->record.cycle < self->replay.next_cycle);
    if (self->is_again) {
        return again_take(&self->again, self->robot, &self->record, &self->known);
    }
    const bool is_equal = replay_take(&self->replay, self->robot, &self->record, &self->known);
    if (is_equal) {
        again_keep(&self->again, &self->replay, &self->record);
    }
    return is_equal;
}

bool walk_is_done(const walk_t *self)
{
    return self->is_again ? self->again.is_compared : self->replay.is_running;
}

bool walk_check_end(const walk_t *self)
{
    const recording_reader_t *const reader = &self->reader;

    if ((self->taken == reader->records) && (reader->raw_next == reader->raw_size) &&
        (reader->next == reader->end)) {
        return true;
    }
    (void)fflush(stdout);
    (void)fprintf(stderr,
                  "The blocks announce %" PRIu64 " records, %" PRIu64
                  " could be read; the recording cannot be trusted.\n",
                  reader->records, self->taken);
    return false;
}

static bool find_difference(const walk_t *self, char *difference)
{
    return self->is_again ? again_difference(&self->again, &self->record, &self->known, difference,
                                             WALK_SENTENCE)
                          : replay_difference(&self->replay, &self->record, &self->known,
                                              difference, WALK_SENTENCE);
}

/* After a difference of which only a hash was kept: what the next whole cycle shows, which comes
 * within a second. */
static void look_further(walk_t *self, FILE *where)
{
    char difference[WALK_SENTENCE];
    bool is_equal = true;

    self->known.is_whole = false;
    while (!self->known.is_whole && walk_take(self) &&
           (self->record.kind == (uint32_t)CYCLE_RECORD_CYCLE)) {
        is_equal = walk_replay(self);
    }
    if (!self->known.is_whole || !self->replay.is_running) {
        return; /* The recording ends before it, or has a gap or another state. */
    }
    if (is_equal) {
        (void)fprintf(where, "Cycle %" PRIu32 ", the next that was kept whole, is equal.\n",
                      self->record.cycle);
    } else {
        (void)find_difference(self, difference);
        (void)fprintf(where, "The next that was kept whole: %s\n", difference);
    }
}

int walk_report_difference(walk_t *self, FILE *where)
{
    const uint64_t equal = self->replay.replayed;
    const bool is_named = find_difference(self, self->difference);

    (void)fflush(stdout);
    if (self->is_of_run) {
        (void)fprintf(where, "%s: ", self->path);
    }
    (void)fprintf(where, "%s\n%" PRIu64 " cycles before it were equal.\n", self->difference, equal);
    if (!is_named) {
        look_further(self, where);
    }
    return EXIT_DIFFERENT;
}

void walk_report_lost(const walk_t *self)
{
    if (self->reader.cycles_lost > 0U) {
        (void)fprintf(self->notes, "%" PRIu32 " cycles before this file were lost.\n",
                      self->reader.cycles_lost);
    }
}

/* A recording behind the end of a run is of another run, or the one that states the end is. */
static void note_behind_end(walk_t *self)
{
    if (self->had_end && !self->is_behind_end) {
        (void)fprintf(self->notes,
                      "%s goes on with cycle %" PRIu32
                      ", although a recording before it says that the run ends with it.\n",
                      self->path, self->record.cycle);
        self->is_behind_end = true;
    }
}

bool walk_count(walk_t *self, bool is_done)
{
    const bool is_new = (self->record.kind == (uint32_t)CYCLE_RECORD_CYCLE) &&
                        coverage_take(&self->coverage, self->record.cycle, is_done, self->notes);

    if (is_new) {
        note_behind_end(self);
    }
    return is_new;
}

bool walk_is_whole_run(const walk_t *self)
{
    return (self->coverage.first == 0U) && coverage_is_whole(&self->coverage) &&
           self->has_run_end && !self->is_behind_end;
}

int walk_end(walk_t *self)
{
    const coverage_t *const coverage = &self->coverage;
    const bool is_whole = self->is_of_run ? walk_is_whole_run(self)
                                          : (!self->is_cut_short && coverage_is_whole(coverage));

    again_end(&self->again);
    coverage_end(&self->coverage, self->notes);
    if (self->is_of_run && !self->has_run_end) {
        (void)fprintf(self->notes,
                      "The end of the run is missing; the last cycle is %" PRIu32 ".\n",
                      coverage->next - 1U);
    }
    return is_whole ? EXIT_EQUAL : EXIT_PART;
}

static const controller_outputs_t *find_shown(const walk_t *self)
{
    if (self->replay.is_running) {
        return &self->replay.outputs;
    }
    return self->known.is_whole ? &self->record.body.cycle.outputs : NULL;
}

static int report_record(walk_t *self, walk_reporter_t *report, void *to)
{
    if (!walk_replay(self)) {
        return walk_report_difference(self, stderr);
    }
    if (walk_count(self, walk_is_done(self))) {
        report(self, to, find_shown(self));
    }
    return WALK_GOES_ON;
}

int walk_report_next(walk_t *self, walk_reporter_t *report, void *to)
{
    if (walk_take(self)) {
        return report_record(self, report, to);
    }
    return walk_check_end(self) ? walk_end(self) : EXIT_REFUSED;
}

int walk_report_part(walk_t *self, walk_reporter_t *report, void *to)
{
    int code = WALK_GOES_ON;

    while ((code == WALK_GOES_ON) && walk_take(self)) {
        code = report_record(self, report, to);
    }
    return ((code == WALK_GOES_ON) && !walk_check_end(self)) ? EXIT_REFUSED : code;
}

int walk_report(walk_t *self, walk_reporter_t *report, void *to)
{
    walk_report_lost(self);
    const int code = walk_report_part(self, report, to);
    return (code == WALK_GOES_ON) ? walk_end(self) : code;
}
