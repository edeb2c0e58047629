/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/export/mcap.h"

#include "common/little_endian.h"
#include "replay/export/mcap_record.h"

#include <stdlib.h>
#include <string.h>
#include <zstd.h>

#define CHUNK_BYTES ((size_t)768U * 1024U)
#define COMPRESSION "zstd"
#define LEVEL 3

static const uint8_t magic[8] = {0x89U, 'M', 'C', 'A', 'P', '0', '\r', '\n'};

static void emit(mcap_t *self, const void *bytes, size_t size)
{
    (void)fwrite(bytes, 1U, size, self->file);
    self->crc = mcap_crc_add(self->crc, bytes, size);
    self->offset += size;
}

static void emit_record(mcap_t *self)
{
    emit(self, self->record.at, self->record.used);
}

static void begin_record(mcap_t *self, uint8_t kind)
{
    bytes_clear(&self->record);
    (void)mcap_record_begin(&self->record, kind);
}

static void end_record(mcap_t *self)
{
    mcap_record_end(&self->record, 0U);
    emit_record(self);
}

bool mcap_begin(mcap_t *self, FILE *file, const char *library)
{
    (void)memset(self, 0, sizeof *self);
    self->file = file;
    self->crc = MCAP_CRC_START;
    self->indexes = tmpfile();
    emit(self, magic, sizeof magic);
    begin_record(self, MCAP_OP_HEADER);
    mcap_put_text(&self->record, "");
    mcap_put_text(&self->record, library);
    end_record(self);
    return self->indexes != NULL;
}

static void add_schema(mcap_t *self, uint16_t id, const char *name, const bytes_t *schema)
{
    begin_record(self, MCAP_OP_SCHEMA);
    bytes_put16(&self->record, id);
    mcap_put_text(&self->record, name);
    mcap_put_text(&self->record, "jsonschema");
    bytes_put32(&self->record, (uint32_t)schema->used);
    bytes_put(&self->record, schema->at, schema->used);
    end_record(self);
    bytes_put(&self->schemas, self->record.at, self->record.used);
}

/* Schemas are numbered from 1, channels from 0. */
uint16_t mcap_add_channel(mcap_t *self, const char *topic, const char *schema_name,
                          const bytes_t *schema)
{
    const uint16_t channel = self->channel_count;
    const uint16_t id = (uint16_t)(channel + 1U);

    if (channel == MCAP_CHANNELS) {
        abort();
    }
    add_schema(self, id, schema_name, schema);
    begin_record(self, MCAP_OP_CHANNEL);
    bytes_put16(&self->record, channel);
    bytes_put16(&self->record, id);
    mcap_put_text(&self->record, topic);
    mcap_put_text(&self->record, "json");
    bytes_put32(&self->record, 0U);
    end_record(self);
    bytes_put(&self->channels, self->record.at, self->record.used);
    self->channel_count = id;
    return channel;
}

static bool has_messages(const mcap_t *self, uint16_t channel)
{
    for (uint32_t i = 0U; i < self->place_count; i++) {
        if (self->places[i].channel == channel) {
            return true;
        }
    }
    return false;
}

static void write_message_index(mcap_t *self, uint16_t channel)
{
    begin_record(self, MCAP_OP_MESSAGE_INDEX);
    bytes_put16(&self->record, channel);
    const size_t list = mcap_list_begin(&self->record);
    for (uint32_t i = 0U; i < self->place_count; i++) {
        if (self->places[i].channel == channel) {
            bytes_put64(&self->record, self->places[i].time_ns);
            bytes_put64(&self->record, self->places[i].offset);
        }
    }
    mcap_list_end(&self->record, list);
    end_record(self);
}

static void put_times(bytes_t *to, uint64_t first_ns, uint64_t last_ns)
{
    bytes_put64(to, first_ns);
    bytes_put64(to, last_ns);
}

static void put_chunk_times(const mcap_t *self, bytes_t *to)
{
    put_times(to, self->places[0].time_ns, self->places[self->place_count - 1U].time_ns);
}

static void compress(mcap_t *self)
{
    bytes_clear(&self->packed);
    while (self->packed.room < ZSTD_compressBound(self->chunk.used)) {
        bytes_put64(&self->packed, 0U);
    }
    self->packed.used =
        ZSTD_compress(self->packed.at, self->packed.room, self->chunk.at, self->chunk.used, LEVEL);
    if (ZSTD_isError(self->packed.used) != 0U) {
        abort(); /* There is room, so only memory can lack. */
    }
}

static void write_chunk(mcap_t *self)
{
    compress(self);
    begin_record(self, MCAP_OP_CHUNK);
    put_chunk_times(self, &self->record);
    bytes_put64(&self->record, self->chunk.used);
    bytes_put32(&self->record, ~mcap_crc_add(MCAP_CRC_START, self->chunk.at, self->chunk.used));
    mcap_put_text(&self->record, COMPRESSION);
    bytes_put64(&self->record, self->packed.used);
    bytes_put(&self->record, self->packed.at, self->packed.used);
    end_record(self);
}

/* Writes the indexes behind the chunk, and into `map` where they are. Returns their length. */
static uint64_t write_message_indexes(mcap_t *self, bytes_t *map)
{
    const uint64_t begin = self->offset;

    for (uint16_t channel = 0U; channel < self->channel_count; channel++) {
        if (has_messages(self, channel)) {
            bytes_put16(map, channel);
            bytes_put64(map, self->offset);
            write_message_index(self, channel);
        }
    }
    return self->offset - begin;
}

static void flush_chunk(mcap_t *self)
{
    bytes_t index = {NULL, 0U, 0U};
    const uint64_t offset = self->offset;

    if (self->place_count == 0U) {
        return;
    }
    write_chunk(self);
    const size_t begin = mcap_record_begin(&index, MCAP_OP_CHUNK_INDEX);
    put_chunk_times(self, &index);
    bytes_put64(&index, offset);
    bytes_put64(&index, self->offset - offset);
    const size_t list = mcap_list_begin(&index);
    const uint64_t length = write_message_indexes(self, &index);
    mcap_list_end(&index, list);
    bytes_put64(&index, length);
    mcap_put_text(&index, COMPRESSION);
    bytes_put64(&index, self->packed.used);
    bytes_put64(&index, self->chunk.used);
    mcap_record_end(&index, begin);
    (void)fwrite(index.at, 1U, index.used, self->indexes);
    bytes_free(&index);
    bytes_clear(&self->chunk);
    self->place_count = 0U;
    self->chunk_count++;
}

void mcap_write(mcap_t *self, uint16_t channel, uint64_t time_ns, const bytes_t *message)
{
    self->first_ns = (self->last_ns == 0U) ? time_ns : self->first_ns;
    self->last_ns = time_ns;
    self->places[self->place_count] = (mcap_place_t){time_ns, self->chunk.used, channel};
    self->place_count++;
    const size_t begin = mcap_record_begin(&self->chunk, MCAP_OP_MESSAGE);
    bytes_put16(&self->chunk, channel);
    bytes_put32(&self->chunk, self->sequences[channel]);
    put_times(&self->chunk, time_ns, time_ns);
    bytes_put(&self->chunk, message->at, message->used);
    mcap_record_end(&self->chunk, begin);
    self->sequences[channel]++;
    if ((self->place_count == MCAP_CHUNK_MESSAGES) || (self->chunk.used >= CHUNK_BYTES)) {
        flush_chunk(self);
    }
}

void mcap_note(mcap_t *self, const char *name, const char *const pairs[][2], uint32_t count)
{
    flush_chunk(self);
    self->note_name = name;
    self->note_offset = self->offset;
    begin_record(self, MCAP_OP_METADATA);
    mcap_put_text(&self->record, name);
    const size_t list = mcap_list_begin(&self->record);
    for (uint32_t i = 0U; i < count; i++) {
        mcap_put_text(&self->record, pairs[i][0]);
        mcap_put_text(&self->record, pairs[i][1]);
    }
    mcap_list_end(&self->record, list);
    end_record(self);
    self->note_length = self->offset - self->note_offset;
}

static void write_statistics(mcap_t *self)
{
    uint64_t messages = 0U;

    for (uint16_t i = 0U; i < self->channel_count; i++) {
        messages += self->sequences[i];
    }
    begin_record(self, MCAP_OP_STATISTICS);
    bytes_put64(&self->record, messages);
    bytes_put16(&self->record, self->channel_count); /* Each has its own schema. */
    bytes_put32(&self->record, self->channel_count);
    bytes_put32(&self->record, 0U);
    bytes_put32(&self->record, (self->note_name != NULL) ? 1U : 0U);
    bytes_put32(&self->record, self->chunk_count);
    put_times(&self->record, self->first_ns, self->last_ns);
    const size_t list = mcap_list_begin(&self->record);
    for (uint16_t i = 0U; i < self->channel_count; i++) {
        bytes_put16(&self->record, i);
        bytes_put64(&self->record, self->sequences[i]);
    }
    mcap_list_end(&self->record, list);
    end_record(self);
}

static void write_chunk_indexes(mcap_t *self)
{
    uint8_t buffer[4096];
    size_t size;

    rewind(self->indexes);
    do {
        size = fread(buffer, 1U, sizeof buffer, self->indexes);
        emit(self, buffer, size);
    } while (size > 0U);
}

static void write_note_index(mcap_t *self)
{
    if (self->note_name == NULL) {
        return;
    }
    begin_record(self, MCAP_OP_METADATA_INDEX);
    bytes_put64(&self->record, self->note_offset);
    bytes_put64(&self->record, self->note_length);
    mcap_put_text(&self->record, self->note_name);
    end_record(self);
}

static void write_schemas(mcap_t *self)
{
    emit(self, self->schemas.at, self->schemas.used);
}

static void write_channels(mcap_t *self)
{
    emit(self, self->channels.at, self->channels.used);
}

static void write_footer(mcap_t *self, uint64_t summary, uint64_t offsets)
{
    begin_record(self, MCAP_OP_FOOTER);
    bytes_put64(&self->record, summary);
    bytes_put64(&self->record, offsets);
    bytes_put32(&self->record, 0U);
    mcap_record_end(&self->record, 0U);
    const size_t covered = self->record.used - sizeof(uint32_t);
    put32(&self->record.at[covered], ~mcap_crc_add(self->crc, self->record.at, covered));
    emit_record(self);
}

/* The records at the end, each kind together. */
static const struct {
    uint8_t kind;
    void (*write)(mcap_t *self);
} groups[] = {{MCAP_OP_SCHEMA, write_schemas},
              {MCAP_OP_CHANNEL, write_channels},
              {MCAP_OP_STATISTICS, write_statistics},
              {MCAP_OP_CHUNK_INDEX, write_chunk_indexes},
              {MCAP_OP_METADATA_INDEX, write_note_index}};

static void write_summary(mcap_t *self)
{
    bytes_t places = {NULL, 0U, 0U};
    const uint64_t begin = self->offset;

    self->crc = MCAP_CRC_START;
    for (size_t i = 0U; i < (sizeof groups / sizeof groups[0]); i++) {
        const uint64_t group = self->offset;
        groups[i].write(self);
        if (self->offset > group) {
            const size_t at = mcap_record_begin(&places, MCAP_OP_SUMMARY_OFFSET);
            bytes_put8(&places, groups[i].kind);
            bytes_put64(&places, group);
            bytes_put64(&places, self->offset - group);
            mcap_record_end(&places, at);
        }
    }
    const uint64_t offsets = self->offset;
    emit(self, places.at, places.used);
    bytes_free(&places);
    write_footer(self, begin, offsets);
}

bool mcap_end(mcap_t *self)
{
    flush_chunk(self);
    const uint32_t data_crc = ~self->crc;
    begin_record(self, MCAP_OP_DATA_END);
    bytes_put32(&self->record, data_crc);
    end_record(self);
    write_summary(self);
    emit(self, magic, sizeof magic);
    const bool is_good = ferror(self->indexes) == 0;
    (void)fclose(self->indexes);
    bytes_free(&self->record);
    bytes_free(&self->schemas);
    bytes_free(&self->channels);
    bytes_free(&self->chunk);
    bytes_free(&self->packed);
    return is_good;
}
