/* SPDX-License-Identifier: Apache-2.0 */
#include "recording/read/recording_reader.h"

#include "recording/read/recording_block.h"
#include "recording/read/recording_verify.h"

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
    recording_block_begin(self, fields.raw_size, fields.cycle);
    return size == fields.raw_size;
}

bool recording_reader_next(recording_reader_t *self, cycle_record_t *record, cycle_known_t *known)
{
    if ((self->raw_next == self->raw_size) && !load_block(self)) {
        return false;
    }
    return recording_block_take(self, record, known);
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
