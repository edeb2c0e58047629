/* SPDX-License-Identifier: Apache-2.0 */
/** @file What an MCAP file is made of: records of a kind, their texts, lists and checksums. */
#ifndef BORESIGHT_MCAP_RECORD_H
#define BORESIGHT_MCAP_RECORD_H

#include "replay/data/bytes.h"

#define MCAP_OP_HEADER 0x01U
#define MCAP_OP_FOOTER 0x02U
#define MCAP_OP_SCHEMA 0x03U
#define MCAP_OP_CHANNEL 0x04U
#define MCAP_OP_MESSAGE 0x05U
#define MCAP_OP_CHUNK 0x06U
#define MCAP_OP_MESSAGE_INDEX 0x07U
#define MCAP_OP_CHUNK_INDEX 0x08U
#define MCAP_OP_STATISTICS 0x0BU
#define MCAP_OP_METADATA 0x0CU
#define MCAP_OP_METADATA_INDEX 0x0DU
#define MCAP_OP_SUMMARY_OFFSET 0x0EU
#define MCAP_OP_DATA_END 0x0FU

#define MCAP_CRC_START 0xFFFFFFFFU

/** Adds to a CRC-32 of IEEE 802.3 that began with MCAP_CRC_START; in a file stands its complement.
 */
uint32_t mcap_crc_add(uint32_t crc, const uint8_t *bytes, size_t size);

/** Puts the length of `text` and its letters. */
void mcap_put_text(bytes_t *to, const char *text);

/** Begins a record; mcap_record_end() gets what this returns. */
size_t mcap_record_begin(bytes_t *to, uint8_t kind);
void mcap_record_end(bytes_t *to, size_t begin);

/** Begins a map or an array, whose length is in bytes; mcap_list_end() gets what this returns. */
size_t mcap_list_begin(bytes_t *to);
void mcap_list_end(bytes_t *to, size_t begin);

#endif
