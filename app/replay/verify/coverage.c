/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/verify/coverage.h"

#include <inttypes.h>
#include <string.h>

void coverage_begin(coverage_t *self, bool is_of_run)
{
    (void)memset(self, 0, sizeof *self);
    self->has_begun = is_of_run;
}

/* Those before `next`. */
static void report(FILE *notes, uint32_t from, uint32_t next, const char *what)
{
    (void)fprintf(notes, "Cycles %" PRIu32 " to %" PRIu32 " %s (%" PRIu32 ").\n", from, next - 1U,
                  what, next - from);
}

static void end_undone(coverage_t *self, FILE *notes)
{
    if (self->is_undone) {
        report(notes, self->undone_from, self->next, "follow no checkpoint and were not replayed");
    }
    self->is_undone = false;
}

static void note_gap(coverage_t *self, uint32_t cycle, FILE *notes)
{
    end_undone(self, notes);
    report(notes, self->next, cycle, "are missing");
    self->missing += cycle - self->next;
}

static void end_again(coverage_t *self, FILE *notes)
{
    if (self->is_again) {
        (void)fprintf(notes,
                      "Cycles %" PRIu32 " to %" PRIu32 " are there again in %s%s (%" PRIu32 ").\n",
                      self->again_from, self->again_next - 1U, self->path,
                      self->is_compared ? "" : ", follow no checkpoint there and were not compared",
                      self->again_next - self->again_from);
    }
    self->is_again = false;
}

static void note_again(coverage_t *self, uint32_t cycle, bool is_done, FILE *notes)
{
    if ((cycle != self->again_next) || (is_done != self->is_compared)) {
        end_again(self, notes);
    }
    if (!self->is_again) {
        self->again_from = cycle;
    }
    self->is_again = true;
    self->is_compared = is_done;
    self->again_next = cycle + 1U;
    self->uncompared += is_done ? 0U : 1U;
}

void coverage_open(coverage_t *self, const char *path, FILE *notes)
{
    end_again(self, notes);
    self->path = path;
}

bool coverage_take(coverage_t *self, uint32_t cycle, bool is_done, FILE *notes)
{
    if (!self->has_begun) {
        self->has_begun = true;
        self->first = cycle;
        self->next = cycle;
    }
    if (cycle < self->next) {
        note_again(self, cycle, is_done, notes);
        return false;
    }
    end_again(self, notes);
    if (cycle > self->next) {
        note_gap(self, cycle, notes);
    }
    if (is_done) {
        end_undone(self, notes);
        self->done++;
    } else {
        self->undone_from = self->is_undone ? self->undone_from : cycle;
        self->is_undone = true;
        self->undone++;
    }
    self->next = cycle + 1U;
    return true;
}

void coverage_end(coverage_t *self, FILE *notes)
{
    end_undone(self, notes);
    end_again(self, notes);
}

bool coverage_is_whole(const coverage_t *self)
{
    return (self->missing == 0U) && (self->undone == 0U) && (self->uncompared == 0U);
}
