/* SPDX-License-Identifier: Apache-2.0 */
#include "recording/write/recording_writer.h"

#include "common/little_endian.h"
#include "recording/format/cycle_words.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <zstd.h>

#define FILE_MODE 0640
#define COMPRESSION_LEVEL 3

static void release(recording_writer_t *self)
{
    const int reason = errno;

    if (self->file >= 0) {
        (void)close(self->file);
    }
    (void)ZSTD_freeCCtx(self->compressor);
    free(self->output);
    self->file = -1;
    self->compressor = NULL;
    self->output = NULL;
    errno = reason;
}

/* All or nothing: a block that does not fit is taken back. */
static bool write_all(recording_writer_t *self, const uint8_t *bytes, size_t size)
{
    size_t written = 0U;

    while (written < size) {
        const ssize_t count = write(self->file, &bytes[written], size - written);
        if (count > 0) {
            written += (size_t)count;
        } else if ((count == 0) || (errno != EINTR)) {
            const int reason = (count == 0) ? ENOSPC : errno;
            (void)!ftruncate(self->file, (off_t)self->size);
            errno = reason;
            return false;
        } else {
            /* Interrupted: again. */
        }
    }
    self->size += size;
    return true;
}

static void begin_block(recording_writer_t *self)
{
    (void)memset(&self->block, 0, sizeof self->block);
    self->has_whole = false;
    cycle_code_begin(&self->code);
}

static bool write_header(recording_writer_t *self)
{
    uint8_t bytes[RECORDING_HEADER_SIZE];

    recording_encode_header(&self->header, bytes);
    (void)memcpy(self->hash, &bytes[RECORDING_HEADER_SIZE - RECORDING_HASH_SIZE],
                 sizeof self->hash);
    return write_all(self, bytes, sizeof bytes);
}

/* A file without header is no recording, and would count as one. */
static void remove_again(const char *path)
{
    const int reason = errno;

    (void)unlink(path);
    errno = reason;
}

bool recording_writer_open(recording_writer_t *self, const char *path,
                           const recording_header_t *header)
{
    const size_t bound = ZSTD_compressBound(RECORDING_RAW_MAX);

    (void)memset(self, 0, offsetof(recording_writer_t, raw));
    self->header = *header;
    self->header.frame_layout = cycle_words_frame_layout();
    self->output_size = RECORDING_PREFIX_SIZE + recording_checksums_size((uint32_t)bound) + bound;
    self->output = malloc(self->output_size);
    self->compressor = ZSTD_createCCtx();
    self->file = open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, FILE_MODE);
    begin_block(self);
    if (self->file < 0) {
        release(self);
        return false;
    }
    if ((self->output == NULL) || (self->compressor == NULL) || !write_header(self)) {
        release(self);
        remove_again(path);
        return false;
    }
    return true;
}

void recording_writer_note_loss(recording_writer_t *self, uint32_t cycles)
{
    self->lost_before += cycles;
    self->cycles_lost += cycles;
}

void recording_writer_note_run_end(recording_writer_t *self)
{
    self->is_run_end = true;
}

static void append_cycle(recording_writer_t *self, const cycle_record_t *record)
{
    const bool is_whole = !self->has_whole || !self->has_checkpoint;

    self->block.raw_size +=
        (uint32_t)cycle_code_encode(&self->code, &self->prover, is_whole, &record->body.cycle,
                                    &self->raw[self->block.raw_size]);
    self->has_whole = true;
    self->next_cycle = record->cycle + 1U;
}

static void append_checkpoint(recording_writer_t *self, const cycle_record_t *record,
                              const trajectory_row_t *rows, uint32_t row_count)
{
    const uint32_t size = self->header.controller_size;
    const size_t rows_size = row_count * sizeof *rows;
    uint8_t *to = &self->raw[self->block.raw_size];

    to[0] = RECORDING_CHECKPOINT;
    (void)memcpy(&to[1], record->body.checkpoint, size);
    put32(&to[1U + size], row_count);
    if (row_count > 0U) {
        (void)memcpy(&to[1U + size + sizeof row_count], rows, rows_size);
    }
    self->block.raw_size += (uint32_t)(1U + size + sizeof row_count + rows_size);
    self->next_cycle = record->cycle;
    self->has_checkpoint = true;
}

static void begin_records(recording_writer_t *self, const cycle_record_t *record)
{
    self->block.cycle = record->cycle;
    self->block.cycles_lost = self->lost_before;
    self->lost_before = 0U;
}

static bool is_full(const recording_writer_t *self)
{
    return (self->block.records >= RECORDING_BLOCK_RECORDS) ||
           ((RECORDING_RAW_MAX - self->block.raw_size) < RECORDING_RECORD_MAX);
}

static bool append(recording_writer_t *self, const cycle_record_t *record,
                   const trajectory_row_t *rows, uint32_t row_count)
{
    const bool is_checkpoint = record->kind == (uint32_t)CYCLE_RECORD_CHECKPOINT;

    if (!is_checkpoint && (record->kind != (uint32_t)CYCLE_RECORD_CYCLE)) {
        return true;
    }
    if ((is_checkpoint || (record->cycle != self->next_cycle)) && !recording_writer_flush(self)) {
        return false;
    }
    self->has_checkpoint = self->has_checkpoint && (record->cycle == self->next_cycle);
    if (self->block.records == 0U) {
        begin_records(self, record);
    }
    if (is_checkpoint) {
        append_checkpoint(self, record, rows, row_count);
    } else {
        append_cycle(self, record);
    }
    self->block.records++;
    self->records++;
    self->cycle = record->cycle;
    return !is_full(self) || recording_writer_flush(self);
}

bool recording_writer_append(recording_writer_t *self, const cycle_record_t *record)
{
    return append(self, record, NULL, 0U);
}

bool recording_writer_append_checkpoint(recording_writer_t *self, const cycle_record_t *record,
                                        const trajectory_row_t *rows)
{
    return append(self, record, rows, record->rows);
}

/* Payload first, at the end of the room for its checksums; those are then moved up to it. */
static size_t compress_block(recording_writer_t *self)
{
    const size_t bound = ZSTD_compressBound(self->block.raw_size);
    uint8_t *room = &self->output[self->output_size - bound];
    uint8_t *checksums = &self->output[RECORDING_PREFIX_SIZE];
    const size_t size = ZSTD_compressCCtx(self->compressor, room, bound, self->raw,
                                          self->block.raw_size, COMPRESSION_LEVEL);

    if (ZSTD_isError(size) != 0U) {
        return 0U;
    }
    self->block.compressed_size = (uint32_t)size;
    recording_encode_checksums(room, (uint32_t)size, checksums);
    (void)memmove(&checksums[recording_checksums_size((uint32_t)size)], room, size);
    return recording_checksums_size((uint32_t)size) + size;
}

bool recording_writer_flush(recording_writer_t *self)
{
    if (self->block.records == 0U) {
        return true;
    }
    const size_t rest = compress_block(self);
    self->block.magic = RECORDING_BLOCK_MAGIC;
    self->block.number = self->blocks;
    recording_encode_fields(&self->block, self->output);
    recording_hash(self->hash, self->output, &self->output[RECORDING_PREFIX_SIZE], rest,
                   &self->output[RECORDING_FIELDS_SIZE]);
    if (rest == 0U) {
        errno = ENOMEM;
    }
    if ((rest == 0U) || !write_all(self, self->output, RECORDING_PREFIX_SIZE + rest)) {
        release(self);
        return false;
    }
    (void)memcpy(self->hash, &self->output[RECORDING_FIELDS_SIZE], sizeof self->hash);
    self->blocks++;
    begin_block(self);
    return true;
}

bool recording_writer_close(recording_writer_t *self)
{
    uint8_t bytes[RECORDING_PREFIX_SIZE];

    if (!recording_writer_flush(self)) {
        return false;
    }
    const recording_fields_t trailer = {.magic = self->is_run_end ? RECORDING_RUN_END_MAGIC
                                                                  : RECORDING_TRAILER_MAGIC,
                                        .number = self->blocks,
                                        .cycle = self->cycle,
                                        .records = (uint32_t)self->records,
                                        .raw_size = (uint32_t)(self->records >> 32),
                                        .cycles_lost = self->cycles_lost};
    recording_encode_fields(&trailer, bytes);
    recording_hash(self->hash, bytes, bytes, 0U, &bytes[RECORDING_FIELDS_SIZE]);
    const bool is_written = write_all(self, bytes, sizeof bytes);
    release(self);
    return is_written;
}
