/* SPDX-License-Identifier: Apache-2.0 */
#include "recorder/black_box.h"

#include "common/clock.h"
#include "common/directory.h"
#include "common/file_series.h"

#include <errno.h>
#include <inttypes.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

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
    self->directory = directory;
    self->exchange = exchange;
    self->header = *header;
    self->header.run = exchange_run(exchange);
    self->writer.file = -1;
    self->is_failing = exchange_is_recorder_failing(exchange); /* As the one before it was. */
    self->removed = exchange_cycles_removed(exchange);
    self->room.left_min = exchange_recording_left_min(exchange);
    request_checkpoint(self, 1U);
}

/* The cycle after the last one that is in the present file. */
static uint32_t written_until(const black_box_t *self)
{
    return (self->writer.block.records > 0U) ? self->writer.block.cycle : self->next_cycle;
}

/* What its last block held and did not reach the disk is still in the lane. A file without a block
 * would only take the place of one that has some. */
static void leave_file(black_box_t *self)
{
    const int reason = errno;

    if (self->writer.blocks > 0U) {
        self->kept_until = written_until(self);
        self->present.end_cycle = self->kept_until;
        self->present.size = self->writer.size;
        kept_files_add(&self->earlier, &self->present);
    } else {
        (void)unlink(self->path);
    }
    errno = reason;
}

static void tell(const black_box_t *self)
{
    exchange_note_recorder(self->exchange, self->is_failing, self->removed);
    exchange_note_recording_left(self->exchange, self->room.left_min);
}

/* Goes back to the first cycle that is in no file. */
static void go_back(black_box_t *self)
{
    exchange_retake_cycles(self->exchange);
    self->next_cycle = self->kept_until;
}

/*
 * What is in no file stays in the lane, and control hands over nothing more until it is.
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
            self->directory, strerror(errno));
    }
    self->is_failing = true;
    self->retry_us = now_us + BLACK_BOX_RETRY_US;
    go_back(self);
    tell(self);
}

/* A block has reached the disk. */
static void recover(black_box_t *self)
{
    if (self->is_failing && (self->writer.file >= 0) && (self->writer.blocks > 0U)) {
        (void)fprintf(stderr, "recorder: recording goes on in %s.\n", self->path);
        self->is_failing = false;
        tell(self);
    }
}

/* Goes on after the newest there is, whoever wrote it. */
static bool open_next(black_box_t *self)
{
    bool is_open;

    if (self->number == 0U) {
        self->number = file_series_newest(&file_series_recordings, self->directory);
    }
    do {
        self->number++;
        file_series_path(&file_series_recordings, self->directory, self->number,
                         self->header.started_us, self->path);
        is_open = recording_writer_open(&self->writer, self->path, &self->header);
    } while (!is_open && (errno == EEXIST));
    return is_open;
}

/* Returns the cycles of those that are gone. */
static uint32_t forget_gone(black_box_t *self)
{
    uint32_t *const kept_until = (self->writer.file < 0) ? &self->kept_until : NULL;

    return kept_files_forget_gone(&self->earlier, self->directory, kept_until);
}

/*
 * Also while nothing can be written: whoever makes room may remove them.
 *
 * @satisfies SWR-REC-033
 */
static void look_for_earlier(black_box_t *self, uint64_t now_us)
{
    const uint32_t cycles = forget_gone(self);

    if (cycles != 0U) {
        (void)fprintf(stderr,
                      "recorder: recordings of this run with %" PRIu32
                      " cycles were removed, moved or shortened.\n",
                      cycles);
        self->removed += cycles;
        tell(self);
    }
    self->looked_us = now_us;
}

static void note_present(black_box_t *self, uint32_t cycle)
{
    self->present = (kept_file_t){.started_us = self->header.started_us,
                                  .number = self->number,
                                  .first_cycle = cycle,
                                  .kept_before = self->kept_until};
    kept_file_identify(&self->present, self->writer.file);
}

/* Old recordings make room only for one that exists: a failed attempt costs none of them. Those
 * that make room are not counted. */
static void begin_file(black_box_t *self, uint32_t cycle, uint64_t now_us)
{
    look_for_earlier(self, now_us);
    (void)directory_make(self->directory);
    self->header.started_us = clock_utc_us();
    if (!open_next(self)) {
        fail(self, now_us);
        return;
    }
    exchange_note_file(self->exchange, EXCHANGE_FILE_RECORDING, self->number);
    self->others_bytes =
        file_series_remove_oldest(&file_series_recordings, self->directory, self->path);
    (void)forget_gone(self);
    note_present(self, cycle);
    self->opened_us = now_us;
    self->flushed_us = now_us;
    recording_writer_note_loss(&self->writer, cycle - self->kept_until);
}

static void end_file(black_box_t *self, uint64_t now_us)
{
    if (self->writer.file < 0) {
        return;
    }
    const bool is_closed = recording_writer_close(&self->writer);
    leave_file(self);
    if (!is_closed) {
        fail(self, now_us);
    }
}

/* Cycles missing before `record`; a checkpoint is of the cycle after it. */
static uint32_t missing_before(const black_box_t *self, const cycle_record_t *record)
{
    return self->has_cycle ? (record->cycle - self->next_cycle) : 0U;
}

/* A new file begins at a checkpoint that was due, and after a loss. */
static void change_file(black_box_t *self, const cycle_record_t *record, uint32_t missing,
                        uint64_t now_us)
{
    const bool is_due = (record->kind == CYCLE_RECORD_CHECKPOINT) &&
                        ((now_us - self->opened_us) >= BLACK_BOX_FILE_US);

    if ((missing != 0U) || is_due) {
        end_file(self, now_us);
    }
    if ((self->writer.file < 0) && (now_us >= self->retry_us)) {
        begin_file(self, record->cycle, now_us);
    }
    if ((missing != 0U) && (self->writer.file >= 0)) {
        (void)fprintf(stderr, "recorder: %" PRIu32 " cycles were lost before cycle %" PRIu32 ".\n",
                      missing, record->cycle);
        if (record->kind != (uint32_t)CYCLE_RECORD_CHECKPOINT) {
            request_checkpoint(self, now_us);
        }
    }
}

/* Of a file that was begun. */
static void store(black_box_t *self, const cycle_record_t *record, uint64_t now_us)
{
    const uint32_t blocks = self->writer.blocks;
    const bool is_stored =
        (record->kind == CYCLE_RECORD_CHECKPOINT)
            ? recording_writer_append_checkpoint(&self->writer, record, self->rows)
            : recording_writer_append(&self->writer, record);
    if (!is_stored) {
        leave_file(self);
        fail(self, now_us);
        return;
    }
    if (self->writer.blocks != blocks) {
        self->flushed_us = now_us;
    }
    if (record->kind == CYCLE_RECORD_CHECKPOINT) {
        self->requested_us = 0U;
        self->next_cycle = record->cycle;
    } else {
        self->next_cycle = record->cycle + 1U;
    }
    recover(self);
}

/* Of a checkpoint whose rows are gone nothing can be computed: another one is asked for. */
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
 * Of a lane that was damaged.
 *
 * @satisfies SWR-REC-024
 */
static bool is_passed(const black_box_t *self, const cycle_record_t *record)
{
    return self->has_cycle && ((record->cycle - self->next_cycle) > (uint32_t)INT32_MAX);
}

static void record_one(black_box_t *self, const cycle_record_t *record, uint64_t now_us)
{
    if (is_passed(self, record) || !has_rows(self, record, now_us)) {
        return;
    }
    const uint32_t missing = missing_before(self, record);

    if (!self->has_cycle) {
        self->kept_until = record->cycle; /* What came before was another's. */
        self->next_cycle = record->cycle;
        self->has_cycle = true;
    }
    change_file(self, record, missing, now_us);
    if (self->writer.file >= 0) {
        store(self, record, now_us);
    }
}

/* Closing it writes once more, where a shortened file would get a hole. */
static void close_gone(black_box_t *self)
{
    off_t size = 0;
    const bool is_there = kept_file_is_at(&self->present, self->path, &size);

    (void)recording_writer_close(&self->writer);
    if (is_there) {
        (void)!truncate(self->path, size);
    }
}

/* What was written into a removed file is nowhere; what was not yet is in the lane. */
static void give_up_file(black_box_t *self)
{
    const uint32_t next_cycle = written_until(self);

    close_gone(self);
    exchange_retake_cycles(self->exchange);
    self->removed += next_cycle - self->present.first_cycle;
    self->next_cycle = next_cycle;
}

static void look_for_file(black_box_t *self, uint64_t now_us)
{
    self->present.size = self->writer.size;
    if ((self->writer.file >= 0) && kept_file_is_gone(&self->present, self->directory)) {
        (void)fprintf(stderr,
                      "recorder: %s was removed, moved or shortened; a new recording is begun.\n",
                      self->path);
        give_up_file(self);
        request_checkpoint(self, now_us);
    }
}

/* Waiting records reach the file within a second, and at once where it is not known whether they
 * can; a checkpoint is asked for until it comes. */
static void keep_up(black_box_t *self, uint64_t now_us)
{
    const bool is_due = self->is_failing || ((now_us - self->flushed_us) >= SECOND_US);
    if ((self->writer.file >= 0) && is_due) {
        self->flushed_us = now_us;
        if (!recording_writer_flush(&self->writer)) {
            leave_file(self);
            fail(self, now_us);
        }
        recover(self);
    }
    const bool is_file_old =
        (self->writer.file >= 0) && ((now_us - self->opened_us) >= BLACK_BOX_FILE_US);
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
    const bool is_written =
        (self->writer.file >= 0) ? (self->writer.block.records == 0U) : !self->is_failing;

    if (is_written) {
        exchange_release_cycles(self->exchange, exchange_cycles_taken(self->exchange));
    }
}

/* False when there is none, or it cannot be written. The one that ends a block may be in it or
 * behind it. */
static bool take_one(black_box_t *self, uint64_t now_us)
{
    const uint32_t before = exchange_cycles_taken(self->exchange);
    const uint32_t blocks = self->writer.blocks;

    if (!exchange_take_cycle(self->exchange, &self->record)) {
        return false;
    }
    record_one(self, &self->record, now_us);
    exchange_beat(self->exchange, EXCHANGE_RECORDER);
    if (now_us < self->retry_us) {
        return false;
    }
    if (self->writer.blocks != blocks) {
        exchange_release_cycles(self->exchange, before);
    }
    release_written(self);
    return true;
}

/* With nothing in the lane nobody knows whether it could be written: control hands over more. */
static void try_anew(black_box_t *self, uint64_t now_us)
{
    if (self->is_failing && (self->writer.file < 0) && (now_us >= self->retry_us)) {
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
    if (self->writer.file >= 0) {
        recording_room_look(&self->room, self->directory, self->others_bytes, self->writer.size,
                            now_us);
    }
    tell(self); /* Again: a neighbour may have damaged it. */
}

/* What control did last may not have found room in the lane. */
static bool has_last_cycle(const black_box_t *self)
{
    snapshot_t snapshot;

    return exchange_has_control_ended(self->exchange) && self->has_cycle &&
           exchange_read_snapshot(self->exchange, &snapshot) &&
           ((snapshot.cycle + 1U) == self->next_cycle);
}

/* What a control that still runs has handed over is the next recorder's. */
static uint32_t count_unrecorded(const black_box_t *self)
{
    const bool is_end = self->is_failing || exchange_has_control_ended(self->exchange);
    snapshot_t snapshot;

    if (!is_end || !exchange_read_snapshot(self->exchange, &snapshot)) {
        return 0U;
    }
    const uint32_t count = (snapshot.cycle + 1U) - self->kept_until;
    return (count <= (uint32_t)INT32_MAX) ? count : 0U;
}

uint32_t black_box_close(black_box_t *self)
{
    if (has_last_cycle(self)) {
        recording_writer_note_run_end(&self->writer);
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
