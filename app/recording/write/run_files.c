/* SPDX-License-Identifier: Apache-2.0 */
#include "recording/write/run_files.h"

#include "common/clock.h"
#include "common/directory.h"

#include <errno.h>
#include <string.h>
#include <unistd.h>

void run_files_init(run_files_t *self, const char *directory, const recording_header_t *header)
{
    (void)memset(self, 0, sizeof *self);
    self->directory = directory;
    self->header = *header;
    self->writer.file = -1;
}

void run_files_expect(run_files_t *self, uint32_t cycle)
{
    if (!self->has_cycle) {
        self->kept_until = cycle;
        self->next_cycle = cycle;
        self->has_cycle = true;
    }
}

/* The cycle after the last one that is in the present file. */
static uint32_t written_until(const run_files_t *self)
{
    return (self->writer.block.records > 0U) ? self->writer.block.cycle : self->next_cycle;
}

/* Records of its last block that did not reach the disk are still in the lane. A file without a
 * block would only take the place of one that has some. */
static void leave(run_files_t *self)
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

/* Continues after the newest file, of any writer. */
static bool open_next(run_files_t *self)
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

static void note_present(run_files_t *self, uint32_t cycle)
{
    self->present = (kept_file_t){.started_us = self->header.started_us,
                                  .number = self->number,
                                  .first_cycle = cycle,
                                  .kept_before = self->kept_until};
    kept_file_identify(&self->present, self->writer.file);
}

bool run_files_begin(run_files_t *self, uint32_t cycle, uint64_t now_us)
{
    (void)directory_make(self->directory);
    self->header.started_us = clock_utc_us();
    if (!open_next(self)) {
        return false;
    }
    self->others_bytes =
        file_series_remove_oldest(&file_series_recordings, self->directory, self->path);
    (void)run_files_forget_gone(self);
    note_present(self, cycle);
    self->opened_us = now_us;
    self->flushed_us = now_us;
    recording_writer_note_loss(&self->writer, cycle - self->kept_until);
    return true;
}

bool run_files_store(run_files_t *self, const cycle_record_t *record, const trajectory_row_t *rows,
                     uint64_t now_us)
{
    const uint32_t blocks = self->writer.blocks;
    const bool is_checkpoint = record->kind == CYCLE_RECORD_CHECKPOINT;
    const bool is_stored = is_checkpoint
                               ? recording_writer_append_checkpoint(&self->writer, record, rows)
                               : recording_writer_append(&self->writer, record);

    if (!is_stored) {
        leave(self);
        return false;
    }
    if (self->writer.blocks != blocks) {
        self->flushed_us = now_us;
    }
    self->next_cycle = record->cycle + (is_checkpoint ? 0U : 1U);
    return true;
}

bool run_files_flush(run_files_t *self, uint64_t now_us)
{
    self->flushed_us = now_us;
    if (!recording_writer_flush(&self->writer)) {
        leave(self);
        return false;
    }
    return true;
}

bool run_files_end(run_files_t *self)
{
    if (!run_files_is_open(self)) {
        return true;
    }
    const bool is_closed = recording_writer_close(&self->writer);
    leave(self);
    return is_closed;
}

void run_files_go_back(run_files_t *self)
{
    self->next_cycle = self->kept_until;
}

bool run_files_is_present_gone(run_files_t *self)
{
    self->present.size = self->writer.size;
    return run_files_is_open(self) && kept_file_is_gone(&self->present, self->directory);
}

/* Closing it writes once more, where a shortened file would get a hole. */
static void close_gone(run_files_t *self)
{
    off_t size = 0;
    const bool is_there = kept_file_is_at(&self->present, self->path, &size);

    (void)recording_writer_close(&self->writer);
    if (is_there) {
        (void)!truncate(self->path, size);
    }
}

uint32_t run_files_give_up(run_files_t *self)
{
    self->next_cycle = written_until(self);
    close_gone(self);
    return self->next_cycle - self->present.first_cycle;
}

uint32_t run_files_forget_gone(run_files_t *self)
{
    uint32_t *const kept_until = run_files_is_open(self) ? NULL : &self->kept_until;

    return kept_files_forget_gone(&self->earlier, self->directory, kept_until);
}
