/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/verify/again.h"

#include "base/crc.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#define FIRST_ROOM 4096U

static uint32_t digest_of(const replay_t *replay)
{
    return crc32c((const uint8_t *)replay->controller.seals, sizeof replay->controller.seals);
}

/* As if it had been kept whole: `outputs` are its outputs. */
static uint32_t digest_of_record(const recorded_cycle_t *cycle, const controller_outputs_t *outputs)
{
    const uint32_t parts[] = {crc32c((const uint8_t *)&cycle->inputs, sizeof cycle->inputs),
                              crc32c((const uint8_t *)outputs, sizeof *outputs),
                              crc32c((const uint8_t *)&cycle->board, sizeof cycle->board)};

    return crc32c((const uint8_t *)parts, sizeof parts);
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

void again_keep(again_t *self, const replay_t *first, const cycle_record_t *record)
{
    again_state_t *const last = (self->count > 0U) ? &self->states[self->count - 1U] : NULL;

    if (!first->is_running || ((last != NULL) && (first->next_cycle <= last->cycle))) {
        return;
    }
    if ((last != NULL) && (record->kind == (uint32_t)CYCLE_RECORD_CYCLE) &&
        (record->cycle == last->cycle)) {
        last->record = digest_of_record(&record->body.cycle, &first->outputs);
    }
    make_room(self);
    self->states[self->count] =
        (again_state_t){.cycle = first->next_cycle, .digest = digest_of(first)};
    self->count++;
}

void again_end(again_t *self)
{
    free(self->states);
    *self = (again_t){.states = NULL};
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

/* NULL: it was not computed first. */
static const again_state_t *find_state(const again_t *self, uint32_t cycle)
{
    const again_state_t key = {.cycle = cycle};

    return (self->count > 0U)
               ? bsearch(&key, self->states, self->count, sizeof self->states[0], by_cycle)
               : NULL;
}

/* One that was not computed first differs from nothing. */
static void compare_state(again_t *self)
{
    const again_state_t *const state = find_state(self, self->replay.next_cycle);

    self->is_compared = true;
    self->is_other = (state != NULL) && (state->digest != digest_of(&self->replay));
}

/* Compares a cycle before a checkpoint. */
static void compare_record(again_t *self, const cycle_record_t *record, const cycle_known_t *known)
{
    const again_state_t *const state = find_state(self, record->cycle);
    const recorded_cycle_t *const cycle = &record->body.cycle;

    self->is_compared = known->is_whole && (state != NULL) && (state->record != 0U);
    self->is_other =
        self->is_compared && (state->record != digest_of_record(cycle, &cycle->outputs));
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
    if (self->replay.is_running) {
        compare_state(self);
    } else {
        compare_record(self, record, known);
    }
    return !self->is_other;
}

bool again_difference(const again_t *self, const cycle_record_t *record, const cycle_known_t *known,
                      char *text, size_t size)
{
    if (!self->is_other) {
        return replay_difference(&self->replay, record, known, text, size);
    }
    if (!self->replay.is_running) {
        (void)snprintf(text, size,
                       "Cycle %" PRIu32 " is there again with another record than the first.",
                       record->cycle);
        return true;
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
