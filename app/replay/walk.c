/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/walk.h"

#include <inttypes.h>

bool walk_take(walk_t *self)
{
    const bool is_taken = recording_reader_next(&self->reader, &self->record, &self->known);

    self->taken += is_taken ? 1U : 0U;
    return is_taken;
}

bool walk_replay(walk_t *self)
{
    return replay_take(&self->replay, self->robot, &self->record, &self->known);
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
    return replay_difference(&self->replay, &self->record, &self->known, difference, WALK_SENTENCE);
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

int walk_tell_difference(walk_t *self, FILE *where)
{
    const uint64_t equal = self->replay.replayed;
    const bool is_named = find_difference(self, self->difference);

    (void)fflush(stdout);
    (void)fprintf(where, "%s\n%" PRIu64 " cycles before it were equal.\n", self->difference, equal);
    if (!is_named) {
        look_further(self, where);
    }
    return EXIT_DIFFERENT;
}

void walk_tell_unreplayed(const walk_t *self, FILE *where)
{
    if (self->replay.unreplayed > 0U) {
        (void)fprintf(where,
                      "%" PRIu64 " cycles follow no checkpoint (%" PRIu32
                      " gaps) and were not replayed.\n",
                      self->replay.unreplayed, self->replay.gaps);
    }
}

void walk_tell_lost(const walk_t *self, FILE *where)
{
    if (self->reader.cycles_lost > 0U) {
        (void)fprintf(where, "%" PRIu32 " cycles before this file were lost.\n",
                      self->reader.cycles_lost);
    }
}

static const controller_outputs_t *find_shown(const walk_t *self)
{
    if (self->replay.is_running) {
        return &self->replay.outputs;
    }
    return self->known.is_whole ? &self->record.body.cycle.outputs : NULL;
}

int walk_tell_next(walk_t *self, walk_teller_t *tell, void *to)
{
    if (!walk_take(self)) {
        if (!walk_check_end(self)) {
            return EXIT_REFUSED;
        }
        walk_tell_unreplayed(self, stderr);
        return self->is_cut_short ? EXIT_CUT_SHORT : EXIT_EQUAL;
    }
    if (!walk_replay(self)) {
        return walk_tell_difference(self, stderr);
    }
    if (self->record.kind == (uint32_t)CYCLE_RECORD_CYCLE) {
        tell(self, to, find_shown(self));
    }
    return WALK_GOES_ON;
}

int walk_tell(walk_t *self, walk_teller_t *tell, void *to)
{
    int code = WALK_GOES_ON;

    walk_tell_lost(self, stderr);
    while (code == WALK_GOES_ON) {
        code = walk_tell_next(self, tell, to);
    }
    return code;
}
