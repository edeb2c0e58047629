/* SPDX-License-Identifier: Apache-2.0 */
#include "recording/write/black_box.h"

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#define SECOND_US UINT64_C(1000000)

static void request_checkpoint(black_box_t *self, uint64_t now_us)
{
    exchange_request_checkpoint(self->exchange);
    self->requested_us = now_us;
}

void black_box_open(black_box_t *self, const char *directory, exchange_t *exchange,
                    const recording_header_t *header)
{
    (void)memset(self, 0, sizeof *self);
    self->exchange = exchange;
    run_files_init(&self->files, directory, header);
    self->files.header.run = exchange_run(exchange);
    self->is_failing = exchange_is_recorder_failing(exchange); /* As the one before it was. */
    self->removed = exchange_cycles_removed(exchange);
    self->room.left_min = exchange_recording_left_min(exchange);
    request_checkpoint(self, 1U);
}

static void report(const black_box_t *self)
{
    exchange_note_recorder(self->exchange, self->is_failing, self->removed);
    exchange_note_recording_left(self->exchange, self->room.left_min);
    if (run_files_is_open(&self->files)) {
        exchange_note_file(self->exchange, EXCHANGE_FILE_RECORDING, self->files.number);
    }
}

/* Goes back to the first cycle that is in no file. */
static void go_back(black_box_t *self)
{
    exchange_retake_cycles(self->exchange);
    run_files_go_back(&self->files);
}

/*
 * Records that are in no file stay in the lane, and control hands over nothing more until they are.
 *
 * @satisfies SWR-REC-032
 */
static void fail(black_box_t *self, uint64_t now_us)
{
    if (!self->is_failing) {
        (void)fprintf(
            stderr,
            "recorder: nothing can be recorded in %s (%s); free space there, or make it a "
            "folder that can be written.\n",
            self->files.directory, strerror(errno));
    }
    self->is_failing = true;
    self->retry_us = now_us + BLACK_BOX_RETRY_US;
    go_back(self);
    report(self);
}

/* A block has reached the disk. */
static void recover(black_box_t *self)
{
    const run_files_t *const files = &self->files;

    if (self->is_failing && run_files_is_open(files) && (files->writer.blocks > 0U)) {
        (void)fprintf(stderr, "recorder: recording goes on in %s.\n", files->path);
        self->is_failing = false;
        report(self);
    }
}

/*
 * Also while nothing can be written: they may be removed to make room.
 *
 * @satisfies SWR-REC-033
 */
static void look_for_earlier(black_box_t *self, uint64_t now_us)
{
    const uint32_t cycles = run_files_forget_gone(&self->files);

    if (cycles != 0U) {
        (void)fprintf(stderr,
                      "recorder: recordings of this run with %" PRIu32
                      " cycles were removed, moved or shortened.\n",
                      cycles);
        self->removed += cycles;
        report(self);
    }
    self->looked_us = now_us;
}

static void begin_file(black_box_t *self, uint32_t cycle, uint64_t now_us)
{
    look_for_earlier(self, now_us);
    if (!run_files_begin(&self->files, cycle, now_us)) {
        fail(self, now_us);
    }
}

static void end_file(black_box_t *self, uint64_t now_us)
{
    if (!run_files_end(&self->files)) {
        fail(self, now_us);
    }
}

/* Cycles missing before `record`; a checkpoint is of the cycle after it. */
static uint32_t missing_before(const black_box_t *self, const cycle_record_t *record)
{
    return self->files.has_cycle ? (record->cycle - self->files.next_cycle) : 0U;
}

/* A new file begins at a checkpoint that was due, and after a loss. */
static void change_file(black_box_t *self, const cycle_record_t *record, uint32_t missing,
                        uint64_t now_us)
{
    const bool is_due = (record->kind == CYCLE_RECORD_CHECKPOINT) &&
                        ((now_us - self->files.opened_us) >= BLACK_BOX_FILE_US);

    if ((missing != 0U) || is_due) {
        end_file(self, now_us);
    }
    if (!run_files_is_open(&self->files) && (now_us >= self->retry_us)) {
        begin_file(self, record->cycle, now_us);
    }
    if ((missing != 0U) && run_files_is_open(&self->files)) {
        (void)fprintf(stderr, "recorder: %" PRIu32 " cycles were lost before cycle %" PRIu32 ".\n",
                      missing, record->cycle);
        if (record->kind != (uint32_t)CYCLE_RECORD_CHECKPOINT) {
            request_checkpoint(self, now_us);
        }
    }
}

/* Stores a record in a file that was begun. */
static void store(black_box_t *self, const cycle_record_t *record, uint64_t now_us)
{
    if (!run_files_store(&self->files, record, self->rows, now_us)) {
        fail(self, now_us);
        return;
    }
    if (record->kind == CYCLE_RECORD_CHECKPOINT) {
        self->requested_us = 0U;
    }
    recover(self);
}

/* A checkpoint whose rows are gone is of no use: another one is asked for. */
static bool has_rows(black_box_t *self, const cycle_record_t *record, uint64_t now_us)
{
    if ((record->kind != CYCLE_RECORD_CHECKPOINT) ||
        exchange_read_rows(self->exchange, record, self->rows)) {
        return true;
    }
    request_checkpoint(self, now_us);
    return false;
}

/*
 * The record was passed already, in a lane that was damaged.
 *
 * @satisfies SWR-REC-024
 */
static bool is_passed(const black_box_t *self, const cycle_record_t *record)
{
    return self->files.has_cycle &&
           ((record->cycle - self->files.next_cycle) > (uint32_t)INT32_MAX);
}

static void record_one(black_box_t *self, const cycle_record_t *record, uint64_t now_us)
{
    if (is_passed(self, record) || !has_rows(self, record, now_us)) {
        return;
    }
    const uint32_t missing = missing_before(self, record);

    run_files_expect(&self->files, record->cycle);
    change_file(self, record, missing, now_us);
    if (run_files_is_open(&self->files)) {
        store(self, record, now_us);
    }
}

static void look_for_file(black_box_t *self, uint64_t now_us)
{
    if (run_files_is_present_gone(&self->files)) {
        (void)fprintf(stderr,
                      "recorder: %s was removed, moved or shortened; a new recording is begun.\n",
                      self->files.path);
        self->removed += run_files_give_up(&self->files);
        exchange_retake_cycles(self->exchange);
        request_checkpoint(self, now_us);
    }
}

/* Waiting records reach the file within a second, and at once where it is not known whether they
 * can; a checkpoint is asked for until it comes. */
static void keep_up(black_box_t *self, uint64_t now_us)
{
    run_files_t *const files = &self->files;
    const bool is_due = self->is_failing || ((now_us - files->flushed_us) >= SECOND_US);

    if (run_files_is_open(files) && is_due) {
        if (!run_files_flush(files, now_us)) {
            fail(self, now_us);
        }
        recover(self);
    }
    const bool is_file_old =
        run_files_is_open(files) && ((now_us - files->opened_us) >= BLACK_BOX_FILE_US);
    const bool is_awaited =
        (self->requested_us != 0U) && ((now_us - self->requested_us) >= SECOND_US);
    if (is_awaited || (is_file_old && (self->requested_us == 0U))) {
        request_checkpoint(self, now_us);
    }
}

/* Said once, until a second has passed without damage. */
static void repair_lane(black_box_t *self, uint64_t now_us)
{
    uint32_t dropped = 0U;

    if (!exchange_repair_cycles(self->exchange, &dropped)) {
        return;
    }
    if ((self->damaged_us == 0U) || ((now_us - self->damaged_us) >= SECOND_US)) {
        (void)fprintf(stderr,
                      "recorder: another program has damaged the lane of cycles; it is set right, "
                      "%" PRIu32 " records were dropped.\n",
                      dropped);
    }
    self->damaged_us = now_us;
}

/*
 * Control may overwrite what is in the file, or belongs in none.
 *
 * @satisfies SWR-REC-023
 */
static void release_written(black_box_t *self)
{
    const bool is_written = run_files_is_open(&self->files)
                                ? (self->files.writer.block.records == 0U)
                                : !self->is_failing;

    if (is_written) {
        exchange_release_cycles(self->exchange, exchange_cycles_taken(self->exchange));
    }
}

/* False when none exists, or it cannot be written. The one that ends a block may be in it or
 * behind it. */
static bool take_one(black_box_t *self, uint64_t now_us)
{
    const uint32_t before = exchange_cycles_taken(self->exchange);
    const uint32_t blocks = self->files.writer.blocks;

    if (!exchange_take_cycle(self->exchange, &self->record)) {
        return false;
    }
    record_one(self, &self->record, now_us);
    exchange_beat(self->exchange, EXCHANGE_RECORDER);
    if (now_us < self->retry_us) {
        return false;
    }
    if (self->files.writer.blocks != blocks) {
        exchange_release_cycles(self->exchange, before);
    }
    release_written(self);
    return true;
}

/* An empty lane does not show whether a file could be written: control hands over more. */
static void try_anew(black_box_t *self, uint64_t now_us)
{
    if (self->is_failing && !run_files_is_open(&self->files) && (now_us >= self->retry_us)) {
        self->is_failing = false;
    }
}

static void take_all(black_box_t *self, uint64_t now_us)
{
    const uint32_t most = exchange_cycle_capacity(self->exchange);
    bool is_more = true;

    for (uint32_t i = 0U; is_more && (i < most); i++) {
        is_more = take_one(self, now_us);
    }
    keep_up(self, now_us);
    try_anew(self, now_us);
    release_written(self);
}

void black_box_drain(black_box_t *self, uint64_t now_us)
{
    repair_lane(self, now_us);
    look_for_file(self, now_us);
    if ((now_us - self->looked_us) >= SECOND_US) {
        look_for_earlier(self, now_us);
    }
    if (now_us >= self->retry_us) {
        take_all(self, now_us);
    }
    if (run_files_is_open(&self->files)) {
        recording_room_look(&self->room, self->files.directory, self->files.others_bytes,
                            self->files.writer.size, now_us);
    }
    report(self); /* Again: a neighbour may have damaged it. */
}

/* The last cycle of control may not have found room in the lane. */
static bool has_last_cycle(const black_box_t *self)
{
    snapshot_t snapshot;

    return exchange_has_control_ended(self->exchange) && self->files.has_cycle &&
           exchange_read_snapshot(self->exchange, &snapshot) &&
           ((snapshot.cycle + 1U) == self->files.next_cycle);
}

/* Cycles that a control that still runs has handed over are the next recorder's. */
static uint32_t count_unrecorded(const black_box_t *self)
{
    const bool is_end = self->is_failing || exchange_has_control_ended(self->exchange);
    snapshot_t snapshot;

    if (!is_end || !exchange_read_snapshot(self->exchange, &snapshot)) {
        return 0U;
    }
    const uint32_t count = (snapshot.cycle + 1U) - self->files.kept_until;
    return (count <= (uint32_t)INT32_MAX) ? count : 0U;
}

uint32_t black_box_close(black_box_t *self)
{
    if (has_last_cycle(self)) {
        recording_writer_note_run_end(&self->files.writer);
    }
    end_file(self, 0U);
    release_written(self);
    const uint32_t unrecorded = count_unrecorded(self);
    if (unrecorded != 0U) {
        (void)fprintf(stderr,
                      "recorder: the last %" PRIu32 " cycles of the run are in no recording.\n",
                      unrecorded);
    }
    return unrecorded;
}
