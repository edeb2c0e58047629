/* SPDX-License-Identifier: Apache-2.0 */
#include "recording/recording_reader.h"

#include "common/little_endian.h"
#include "recording/recording_verify.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zstd.h>

static bool is_file(int file, struct stat *status)
{
    if (fstat(file, status) != 0) {
        return false;
    }
    errno = S_ISDIR(status->st_mode) ? EISDIR : EINVAL;
    return S_ISREG(status->st_mode);
}

static recording_verdict_t map_file(recording_reader_t *self, const char *path,
                                    recording_finding_t *finding)
{
    struct stat status;
    const int file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);

    if ((file < 0) || !is_file(file, &status)) {
        const int reason = errno;
        if (file >= 0) {
            (void)close(file);
        }
        return recording_find(finding, RECORDING_UNREADABLE, "%s cannot be read (%s).", path,
                              strerror(reason));
    }
    self->size = (uint64_t)status.st_size;
    if ((self->size >= RECORDING_HEADER_SIZE) && (self->size <= SIZE_MAX)) {
        void *address = mmap(NULL, (size_t)self->size, PROT_READ, MAP_PRIVATE, file, 0);
        self->bytes = (address == MAP_FAILED) ? NULL : address;
    }
    (void)close(file);
    if (self->bytes != NULL) {
        return RECORDING_WHOLE;
    }
    return recording_find(finding, RECORDING_UNREADABLE,
                          (self->size < RECORDING_HEADER_SIZE)
                              ? "%s is too short to be a recording."
                              : "%s is larger than this computer can read; use a larger one.",
                          path);
}

recording_verdict_t recording_reader_open(recording_reader_t *self, const char *path,
                                          recording_finding_t *finding)
{
    (void)memset(self, 0, sizeof *self);
    (void)memset(finding, 0, sizeof *finding);
    if (map_file(self, path, finding) != RECORDING_WHOLE) {
        return finding->verdict;
    }
    (void)recording_verify(self, finding);
    self->next = RECORDING_HEADER_SIZE;
    if ((finding->verdict == RECORDING_DAMAGED) || (finding->verdict == RECORDING_OTHER_VERSION)) {
        recording_reader_close(self);
    }
    return finding->verdict;
}

bool recording_reader_fits(const recording_reader_t *self, uint64_t layout,
                           uint32_t controller_size)
{
    return (self->header.layout == layout) &&
           (self->header.inputs_size == sizeof(controller_inputs_t)) &&
           (self->header.outputs_size == sizeof(controller_outputs_t)) &&
           (self->header.controller_size == controller_size) &&
           (controller_size <= CONTROLLER_CHECKPOINT_BYTES);
}

static bool load_block(recording_reader_t *self)
{
    recording_fields_t fields;
    const uint8_t *block = &self->bytes[self->next];

    if (self->next >= self->end) {
        return false;
    }
    (void)recording_decode_fields(block, &fields);
    const size_t checksums_size = recording_checksums_size(fields.compressed_size);
    self->next += RECORDING_PREFIX_SIZE + checksums_size + fields.compressed_size;
    if (self->raw == NULL) {
        self->raw = malloc(RECORDING_RAW_MAX);
    }
    if ((self->raw == NULL) || (fields.raw_size > RECORDING_RAW_MAX)) {
        return false;
    }
    const size_t size =
        ZSTD_decompress(self->raw, RECORDING_RAW_MAX,
                        &block[RECORDING_PREFIX_SIZE + checksums_size], fields.compressed_size);
    self->raw_size = fields.raw_size;
    self->raw_next = 0U;
    self->cycle = fields.cycle;
    cycle_code_begin(&self->code);
    return size == fields.raw_size;
}

/* Their bytes, NULL when they are not there. */
static const uint8_t *find_rows(const recording_reader_t *self, uint32_t *count)
{
    const uint32_t size = self->header.controller_size;
    const size_t left = self->raw_size - self->raw_next - 1U;
    const uint8_t *bytes = &self->raw[self->raw_next + 1U];

    if ((size > CONTROLLER_CHECKPOINT_BYTES) || (left < (size + sizeof *count))) {
        return NULL;
    }
    *count = get32(&bytes[size]);
    const bool are_there = (*count <= LIMIT_TRAJECTORY_ROWS) &&
                           ((left - size - sizeof *count) >= (*count * sizeof(trajectory_row_t)));
    return are_there ? &bytes[size + sizeof *count] : NULL;
}

static bool take_checkpoint(recording_reader_t *self, cycle_record_t *record, cycle_known_t *known)
{
    const uint32_t size = self->header.controller_size;
    uint32_t count = 0U;
    const uint8_t *rows = find_rows(self, &count);

    if (rows == NULL) {
        return false;
    }
    record->kind = (uint32_t)CYCLE_RECORD_CHECKPOINT;
    record->rows = count;
    (void)memcpy(record->body.checkpoint, &self->raw[self->raw_next + 1U], size);
    known->rows = rows;
    self->raw_next = (uint32_t)(&rows[count * sizeof(trajectory_row_t)] - self->raw);
    return true;
}

static bool take_cycle(recording_reader_t *self, cycle_record_t *record, cycle_known_t *known)
{
    const size_t size =
        cycle_code_decode(&self->code, &self->raw[self->raw_next], self->raw_size - self->raw_next,
                          &record->body.cycle, known);

    record->kind = (uint32_t)CYCLE_RECORD_CYCLE;
    self->raw_next += (uint32_t)size;
    self->cycle++;
    return size != 0U;
}

bool recording_reader_next(recording_reader_t *self, cycle_record_t *record, cycle_known_t *known)
{
    if ((self->raw_next == self->raw_size) && !load_block(self)) {
        return false;
    }
    if (self->raw_next == self->raw_size) {
        return false;
    }
    record->cycle = self->cycle;
    return (self->raw[self->raw_next] == RECORDING_CHECKPOINT)
               ? take_checkpoint(self, record, known)
               : take_cycle(self, record, known);
}

void recording_reader_close(recording_reader_t *self)
{
    if (self->bytes != NULL) {
        (void)munmap((void *)(uintptr_t)self->bytes, (size_t)self->size);
    }
    free(self->raw);
    self->bytes = NULL;
    self->raw = NULL;
}
