/* SPDX-License-Identifier: Apache-2.0 */
#include "exchange/exchange_cycles.h"

#include "exchange/exchange_lock.h"
#include "exchange/exchange_segment.h"
#include "limits/requirement_limits.h"

#include <string.h>

#define BYTES_PER_MB UINT64_C(1000000)
#define PART_BYTES sizeof(recorded_cycle_t)

/* The least lane of a board holds what a recorder leaves that is kept waiting, and what it has not
 * written in its last second. */
_Static_assert(((LIMIT_CYCLE_LANE_MB * BYTES_PER_MB) / sizeof(cycle_entry_t)) >=
                   ((LIMIT_RECORDER_PAUSE_US + UINT64_C(1000000)) / LIMIT_CYCLE_US),
               "the lane of cycles is too small");

uint32_t exchange_cycles_in(uint32_t mb)
{
    return (uint32_t)((mb * BYTES_PER_MB) / sizeof(cycle_entry_t));
}

uint32_t exchange_cycle_capacity(const exchange_t *self)
{
    return self->cycles;
}

static bool is_index(const exchange_t *self, uint32_t index)
{
    return index < (2U * self->cycles);
}

static uint32_t after(const exchange_t *self, uint32_t index)
{
    return ((index + 1U) < (2U * self->cycles)) ? (index + 1U) : 0U;
}

static cycle_entry_t *entry_at(const exchange_t *self, uint32_t index)
{
    return &self->segment->cycles[(index < self->cycles) ? index : (index - self->cycles)];
}

/* Entries between two indices; more than the lane has when one of them is damaged. */
static uint32_t between(const exchange_t *self, uint32_t tail, uint32_t head)
{
    if (!is_index(self, tail) || !is_index(self, head)) {
        return UINT32_MAX;
    }
    return (head >= tail) ? (head - tail) : ((head + (2U * self->cycles)) - tail);
}

static uint32_t reported_tail(const exchange_t *self)
{
    return __atomic_load_n(&self->segment->recorder.cycles_tail, __ATOMIC_ACQUIRE);
}

/*
 * Up to where the recorder has released, where that was last believable: a reader only comes
 * closer, and what leads anywhere else is damage.
 */
static uint32_t believable_tail(exchange_t *self)
{
    uint32_t *const seen = &self->segment->control.cycles_seen;
    const uint32_t before = __atomic_load_n(seen, __ATOMIC_RELAXED);
    const uint32_t tail = reported_tail(self);

    if (between(self, tail, self->cycles_put) > between(self, before, self->cycles_put)) {
        return before;
    }
    __atomic_store_n(seen, tail, __ATOMIC_RELEASE);
    return tail;
}

/* A reader that has followed a damaged index of control finds back. */
static void publish_put(exchange_t *self)
{
    __atomic_store_n(&self->segment->control.cycles_head, self->cycles_put, __ATOMIC_RELEASE);
}

uint32_t exchange_cycle_room(exchange_t *self)
{
    const uint32_t waiting = between(self, believable_tail(self), self->cycles_put);

    publish_put(self);
    return (waiting < self->cycles) ? (self->cycles - waiting) : 0U;
}

cycle_entry_t *exchange_reserve_cycle(exchange_t *self)
{
    return (exchange_cycle_room(self) > 0U) ? entry_at(self, self->cycles_put) : NULL;
}

void exchange_commit_cycle(exchange_t *self)
{
    self->cycles_put = after(self, self->cycles_put);
    publish_put(self);
}

/* All of its parts are handed over at once. */
bool exchange_push_checkpoint(exchange_t *self, const controller_t *controller)
{
    const uint8_t *const bytes = (const uint8_t *)controller;
    uint32_t put = self->cycles_put;
    size_t at = 0U;

    if (exchange_cycle_room(self) < EXCHANGE_CHECKPOINT_ENTRIES) {
        return false;
    }
    while (at < CONTROLLER_CHECKPOINT_BYTES) {
        cycle_entry_t *const entry = entry_at(self, put);
        const size_t left = CONTROLLER_CHECKPOINT_BYTES - at;
        const size_t size = (left < PART_BYTES) ? left : PART_BYTES;
        entry->kind = (at == 0U) ? (uint32_t)CYCLE_RECORD_CHECKPOINT : 0U;
        entry->cycle = controller->sealed.cycle;
        entry->rows = self->segment->control.row_count;
        entry->list = self->segment->control.list;
        (void)memcpy(entry->body.part, &bytes[at], size);
        at += size;
        put = after(self, put);
    }
    self->cycles_put = put;
    publish_put(self);
    return true;
}

/* Copies a record of `count` entries from `tail` on. */
static void copy_record(const exchange_t *self, uint32_t tail, uint32_t count,
                        cycle_record_t *record)
{
    const cycle_entry_t *entry = entry_at(self, tail);
    uint32_t next = tail;
    size_t at = 0U;

    record->kind = entry->kind;
    record->cycle = entry->cycle;
    record->rows = entry->rows;
    record->list = entry->list;
    for (uint32_t i = 0U; i < count; i++) {
        const size_t left = sizeof record->body - at;
        const size_t size = (left < PART_BYTES) ? left : PART_BYTES;
        (void)memcpy(&record->body.checkpoint[at], entry_at(self, next)->body.part, size);
        at += size;
        next = after(self, next);
    }
}

bool exchange_take_cycle(exchange_t *self, cycle_record_t *record)
{
    const uint32_t head = __atomic_load_n(&self->segment->control.cycles_head, __ATOMIC_ACQUIRE);
    uint32_t waiting = between(self, self->cycles_taken, head);
    bool is_taken = false;

    while (!is_taken && (waiting > 0U) && (waiting <= self->cycles)) {
        const bool is_checkpoint =
            entry_at(self, self->cycles_taken)->kind == (uint32_t)CYCLE_RECORD_CHECKPOINT;
        const uint32_t wanted = is_checkpoint ? (uint32_t)EXCHANGE_CHECKPOINT_ENTRIES : 1U;
        const uint32_t count = (wanted < waiting) ? wanted : waiting;
        copy_record(self, self->cycles_taken, count, record);
        for (uint32_t i = 0U; i < count; i++) {
            self->cycles_taken = after(self, self->cycles_taken);
        }
        waiting -= count;
        is_taken = (record->kind != 0U) && (count == wanted);
    }
    return is_taken;
}

uint32_t exchange_cycles_taken(const exchange_t *self)
{
    return self->cycles_taken;
}

void exchange_release_cycles(exchange_t *self, uint32_t taken)
{
    self->cycles_tail = taken;
    __atomic_store_n(&self->segment->recorder.cycles_tail, taken, __ATOMIC_RELEASE);
}

void exchange_retake_cycles(exchange_t *self)
{
    self->cycles_taken = self->cycles_tail;
}

void exchange_note_recorder(exchange_t *self, bool is_failing, uint32_t removed)
{
    segment_recorder_t *const recorder = &self->segment->recorder;

    __atomic_store_n(&recorder->is_failing, is_failing ? 1U : 0U, __ATOMIC_RELAXED);
    __atomic_store_n(&recorder->cycles_removed, removed, __ATOMIC_RELAXED);
}

bool exchange_is_recorder_failing(const exchange_t *self)
{
    return __atomic_load_n(&self->segment->recorder.is_failing, __ATOMIC_RELAXED) == 1U;
}

uint32_t exchange_cycles_removed(const exchange_t *self)
{
    return __atomic_load_n(&self->segment->recorder.cycles_removed, __ATOMIC_RELAXED);
}

void exchange_note_recording_left(exchange_t *self, uint32_t left_min)
{
    __atomic_store_n(&self->segment->recorder.left_min, left_min, __ATOMIC_RELAXED);
}

uint32_t exchange_recording_left_min(const exchange_t *self)
{
    return __atomic_load_n(&self->segment->recorder.left_min, __ATOMIC_RELAXED);
}

/* Goes on where the recorder before has ended or, if that is damaged, where control last saw it. */
static void begin_taking(exchange_t *self, uint32_t head)
{
    const uint32_t seen = __atomic_load_n(&self->segment->control.cycles_seen, __ATOMIC_ACQUIRE);
    const uint32_t tail = reported_tail(self);

    if (!self->is_taking) {
        self->is_taking = true;
        self->cycles_tail = (between(self, tail, head) <= between(self, seen, head)) ? tail : seen;
        self->cycles_taken = self->cycles_tail;
    }
}

bool exchange_repair_cycles(exchange_t *self, uint32_t *dropped)
{
    const uint32_t head = __atomic_load_n(&self->segment->control.cycles_head, __ATOMIC_ACQUIRE);

    begin_taking(self, head);
    const bool is_overrun = between(self, self->cycles_tail, head) > self->cycles;
    const bool is_damaged = is_overrun || (reported_tail(self) != self->cycles_tail);
    if (is_overrun && is_index(self, head)) {
        *dropped += self->cycles;
        self->cycles_taken = head;
        self->cycles_tail = head;
    }
    if (is_damaged) {
        exchange_release_cycles(self, self->cycles_tail);
    }
    return is_damaged;
}
