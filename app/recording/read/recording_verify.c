/* SPDX-License-Identifier: Apache-2.0 */
#include "recording/read/recording_verify.h"

#include <inttypes.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

recording_verdict_t recording_find(recording_finding_t *finding, recording_verdict_t verdict,
                                   const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    (void)vsnprintf(finding->sentence, sizeof finding->sentence, format, arguments);
    va_end(arguments);
    finding->verdict = verdict;
    return verdict;
}

static recording_verdict_t find_damage(recording_finding_t *finding, uint64_t first, uint64_t last,
                                       const char *what)
{
    finding->first_byte = first;
    finding->last_byte = last;
    return recording_find(finding, RECORDING_DAMAGED,
                          "Block %" PRIu32 ", bytes %" PRIu64 "..%" PRIu64
                          ": %s; the recording was changed or damaged there.",
                          finding->block, first, last, what);
}

static recording_verdict_t find_cut(const recording_reader_t *self, recording_finding_t *finding,
                                    uint64_t from)
{
    finding->first_byte = from;
    finding->last_byte = self->size;
    return recording_find(finding, RECORDING_CUT_SHORT,
                          "Cut short after %" PRIu32 " blocks at byte %" PRIu64
                          ", without trailer; what is there is intact.",
                          self->blocks, from);
}

/* Offset in the checksums of the first one that differs from the payload's; their size when none
 * does. */
static uint32_t first_difference(const uint8_t *stored, const uint8_t *computed, uint32_t size)
{
    uint32_t offset = 0U;

    while ((offset < size) && (memcmp(&stored[offset], &computed[offset], sizeof(uint32_t)) == 0)) {
        offset += (uint32_t)sizeof(uint32_t);
    }
    return offset;
}

/* The hash of the block if its checksums were those of its payload: then only a checksum was
 * changed. */
static bool is_payload_intact(const uint8_t *block, const recording_fields_t *fields,
                              const uint8_t *before, uint8_t *computed)
{
    const size_t checksums_size = recording_checksums_size(fields->compressed_size);
    uint8_t hash[RECORDING_HASH_SIZE];

    (void)memcpy(&computed[checksums_size], &block[RECORDING_PREFIX_SIZE + checksums_size],
                 fields->compressed_size);
    recording_hash(before, block, computed, checksums_size + fields->compressed_size, hash);
    return memcmp(hash, &block[RECORDING_FIELDS_SIZE], sizeof hash) == 0;
}

/* Where in a block of valid fields the hash went wrong: the hash itself, a checksum, or a chunk of
 * the payload. */
static recording_verdict_t locate(const recording_reader_t *self, uint64_t offset,
                                  const recording_fields_t *fields, const uint8_t *before,
                                  recording_finding_t *finding)
{
    const uint8_t *block = &self->bytes[offset];
    const uint32_t checksums_size = (uint32_t)recording_checksums_size(fields->compressed_size);
    const uint64_t checksums = offset + RECORDING_PREFIX_SIZE;
    uint8_t *computed = malloc((size_t)checksums_size + fields->compressed_size + 1U);
    uint64_t first = offset + RECORDING_FIELDS_SIZE;
    uint64_t last = first + RECORDING_HASH_SIZE - 1U;

    if (computed == NULL) {
        return find_damage(finding, first,
                           checksums + checksums_size + fields->compressed_size - 1U,
                           "the hash does not match");
    }
    recording_encode_checksums(&block[RECORDING_PREFIX_SIZE + checksums_size],
                               fields->compressed_size, computed);
    const uint32_t place =
        first_difference(&block[RECORDING_PREFIX_SIZE], computed, checksums_size);
    if ((place < checksums_size) && is_payload_intact(block, fields, before, computed)) {
        first = checksums + place;
        last = first + sizeof(uint32_t) - 1U;
    } else if (place < checksums_size) {
        const uint64_t chunk = (place / sizeof(uint32_t)) * RECORDING_CHUNK;
        first = checksums + checksums_size + chunk;
        last = ((fields->compressed_size - chunk) < RECORDING_CHUNK)
                   ? (checksums + checksums_size + fields->compressed_size - 1U)
                   : (first + RECORDING_CHUNK - 1U);
    } else {
        /* Payload and checksums agree: it is the hash. */
    }
    free(computed);
    return find_damage(finding, first, last, "the hash does not match");
}

static bool is_hash_right(const uint8_t *block, const uint8_t *before, size_t rest_size)
{
    uint8_t hash[RECORDING_HASH_SIZE];

    recording_hash(before, block, &block[RECORDING_PREFIX_SIZE], rest_size, hash);
    return memcmp(hash, &block[RECORDING_FIELDS_SIZE], sizeof hash) == 0;
}

static recording_verdict_t verify_trailer(const recording_reader_t *self, uint64_t offset,
                                          const uint8_t *before, recording_finding_t *finding)
{
    const uint64_t end = offset + RECORDING_PREFIX_SIZE;

    if (!is_hash_right(&self->bytes[offset], before, 0U)) {
        return find_damage(finding, offset, end - 1U, "the hash of the trailer does not match");
    }
    if (end != self->size) {
        return find_damage(finding, end, self->size - 1U, "bytes follow the trailer");
    }
    return recording_find(finding, RECORDING_WHOLE,
                          "Whole: %" PRIu32 " blocks, %" PRIu64 " records.", self->blocks,
                          self->records);
}

static recording_verdict_t verify_blocks(recording_reader_t *self, recording_finding_t *finding)
{
    const uint8_t *before = &self->bytes[RECORDING_HEADER_SIZE - RECORDING_HASH_SIZE];

    while ((self->size - self->end) >= RECORDING_PREFIX_SIZE) {
        const uint64_t offset = self->end;
        recording_fields_t fields;
        finding->block = self->blocks;
        if (!recording_decode_fields(&self->bytes[offset], &fields)) {
            return find_damage(finding, offset, offset + RECORDING_FIELDS_SIZE - 1U,
                               "its fields do not match");
        }
        if ((fields.magic == RECORDING_TRAILER_MAGIC) ||
            (fields.magic == RECORDING_RUN_END_MAGIC)) {
            self->is_run_end = fields.magic == RECORDING_RUN_END_MAGIC;
            return verify_trailer(self, offset, before, finding);
        }
        if ((fields.magic != RECORDING_BLOCK_MAGIC) || (fields.number != self->blocks)) {
            return find_damage(finding, offset, offset + RECORDING_FIELDS_SIZE - 1U,
                               "another block belongs here");
        }
        const uint64_t rest =
            (uint64_t)recording_checksums_size(fields.compressed_size) + fields.compressed_size;
        if ((self->size - offset - RECORDING_PREFIX_SIZE) < rest) {
            return find_cut(self, finding, offset);
        }
        if (!is_hash_right(&self->bytes[offset], before, (size_t)rest)) {
            return locate(self, offset, &fields, before, finding);
        }
        before = &self->bytes[offset + RECORDING_FIELDS_SIZE];
        self->end = offset + RECORDING_PREFIX_SIZE + rest;
        self->blocks++;
        self->records += fields.records;
        self->cycles_lost += fields.cycles_lost;
    }
    return find_cut(self, finding, self->end);
}

static recording_verdict_t refuse_header(const recording_reader_t *self, uint32_t version,
                                         recording_finding_t *finding)
{
    char build[4U * sizeof self->header.build];

    finding->last_byte = RECORDING_HEADER_SIZE - 1U;
    if (version == 0U) {
        return recording_find(
            finding, RECORDING_DAMAGED,
            "Header, bytes 0..%u: this is no recording, or it was changed or damaged there.",
            RECORDING_HEADER_SIZE - 1U);
    }
    recording_escape(self->header.build, build, sizeof build);
    return recording_find(
        finding, RECORDING_OTHER_VERSION,
        "The recording is of format version %" PRIu32
        ", this build reads version %u; replay it with the build that recorded it, \"%s\".",
        version, RECORDING_VERSION, build);
}

recording_verdict_t recording_verify(recording_reader_t *self, recording_finding_t *finding)
{
    const uint32_t version = recording_decode_header(self->bytes, &self->header);

    if (version != RECORDING_VERSION) {
        return refuse_header(self, version, finding);
    }
    self->end = RECORDING_HEADER_SIZE;
    return verify_blocks(self, finding);
}
