/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Writes an MCAP file (mcap.dev/spec), which Foxglove and PlotJuggler open: channels of JSON, their
 * messages in chunks compressed by zstd, each with its index and checksum. The file is written from
 * its beginning to its end, into a pipe as well; what grows with it, the index of the chunks, waits
 * in a file without a name until the end.
 */
#ifndef BORESIGHT_MCAP_H
#define BORESIGHT_MCAP_H

#include "replay/data/bytes.h"

#include <stdbool.h>
#include <stdio.h>

#define MCAP_CHANNELS 64U         /**< Most channels. */
#define MCAP_CHUNK_MESSAGES 4096U /**< Most messages of a chunk. */

/** Where a message of the present chunk is. */
typedef struct {
    uint64_t time_ns;
    uint64_t offset;
    uint16_t channel;
} mcap_place_t;

typedef struct {
    FILE *file;
    uint64_t offset; /**< Bytes written. */
    uint32_t crc;    /**< CRC of them, since the section began. */
    bytes_t record;  /**< The one being made. */
    bytes_t schemas; /**< All of them again, for the end. */
    bytes_t channels;
    uint16_t channel_count;
    uint32_t sequences[MCAP_CHANNELS]; /**< Messages of each. */
    bytes_t chunk;
    bytes_t packed;
    mcap_place_t places[MCAP_CHUNK_MESSAGES];
    uint32_t place_count;
    uint64_t first_ns; /**< Time of the first of all messages. */
    uint64_t last_ns;
    FILE *indexes; /**< Indexes of the chunks that are written. */
    uint32_t chunk_count;
    uint64_t note_offset; /**< Offset of the note. */
    uint64_t note_length;
    const char *note_name; /**< NULL: none. */
} mcap_t;

/** Begins a file. False: there is no room for the index. */
bool mcap_begin(mcap_t *self, FILE *file, const char *library);

/** Adds a channel of JSON before the first message; `schema` is a JSON Schema. Its number. */
uint16_t mcap_add_channel(mcap_t *self, const char *topic, const char *schema_name,
                          const bytes_t *schema);

/** Writes a message; times, in ns since 1970, never go back. */
void mcap_write(mcap_t *self, uint16_t channel, uint64_t time_ns, const bytes_t *message);

/** Ends the messages with a note of `count` names and their values; once. `name` lives until
 * mcap_end(). */
void mcap_note(mcap_t *self, const char *name, const char *const pairs[][2], uint32_t count);

/** Ends the file. False: there was no room for its index. */
bool mcap_end(mcap_t *self);

#endif
