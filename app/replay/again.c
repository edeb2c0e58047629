/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/again.h"

#include "base/crc.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#define FIRST_ROOM 4096U

static uint32_t digest_of(const replay_t *replay)
{
    return crc32c((const uint8_t *)replay->controller.seals, sizeof replay->controller.seals);
}

static void make_room(again_t *self)
{
    if (self->count < self->room) {
        return;
    }
    self->room = (self->room > 0U) ? (2U * self->room) : FIRST_ROOM;
    self->states = realloc(self->states, self->room * sizeof self->states[0]);
    if (self->states == NULL) {
        abort();
    }
}

void again_keep(again_t *self, const replay_t *first)
{
    const bool is_later =
        (self->count == 0U) || (first->next_cycle > self->states[self->count - 1U].cycle);

    if (first->is_running && is_later) {
        make_room(self);
        self->states[self->count] = (again_state_t){first->next_cycle, digest_of(first)};
        self->count++;
    }
}

void again_begin(again_t *self)
{
    self->replay.is_running = false;
}

static int by_cycle(const void *one, const void *other)
{
    const again_state_t *const a = one;
    const again_state_t *const b = other;

    return (a->cycle > b->cycle) - (a->cycle < b->cycle);
}

/* One that was not computed first differs from nothing. */
static bool is_state_equal(const again_t *self)
{
    const again_state_t key = {.cycle = self->replay.next_cycle};
    const again_state_t *const state =
        (self->count > 0U)
            ? bsearch(&key, self->states, self->count, sizeof self->states[0], by_cycle)
            : NULL;

    return (state == NULL) || (state->digest == digest_of(&self->replay));
}

bool again_take(again_t *self, const robot_t *robot, const cycle_record_t *record,
                const cycle_known_t *known)
{
    self->is_other = false;
    if (record->kind == (uint32_t)CYCLE_RECORD_CHECKPOINT) {
        self->replay.is_running =
            self->replay.is_running && (record->cycle == self->replay.next_cycle);
    }
    if (!replay_take(&self->replay, robot, record, known)) {
        return false;
    }
    self->is_other = self->replay.is_running && !is_state_equal(self);
    return !self->is_other;
}

bool again_difference(const again_t *self, const cycle_record_t *record, const cycle_known_t *known,
                      char *text, size_t size)
{
    if (!self->is_other) {
        return replay_difference(&self->replay, record, known, text, size);
    }
    (void)snprintf(text, size,
                   "Cycle %" PRIu32
                   " is there again, %s another state than the one that was computed for cycle "
                   "%" PRIu32 ".",
                   record->cycle,
                   (record->kind == (uint32_t)CYCLE_RECORD_CHECKPOINT) ? "with a checkpoint of"
                                                                       : "and leads to",
                   self->replay.next_cycle);
    return true;
}
