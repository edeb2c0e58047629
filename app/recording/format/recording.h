/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The recording: what was running, then every cycle in compressed blocks, each bound to the one
 * before it by its hash. Every byte of the file is covered. Numbers are little endian.
 *
 *     header   256 bytes: magic, version, size, build, robot, sizes, time, layouts, run, SHA-256
 *     block    32 bytes of fields, SHA-256, a checksum of each RECORDING_CHUNK, payload (zstd)
 *     ...
 *     trailer  32 bytes of fields, SHA-256; missing when the recorder was cut short; its magic
 *              says whether the run ends with it
 *
 * Fields of a block: magic, number, first cycle, records, raw size, compressed size, cycles lost,
 * CRC-32C of the fields. Those of the trailer: magic, number of blocks, last cycle, records (64
 * bit), cycles lost, zero, CRC-32C. The SHA-256 of a block is over the hash before it, its own
 * fields, checksums and payload. The checksums only serve to say where in a block a byte was
 * changed.
 *
 * A record is a byte with its kind and its body: a cycle (cycle_code.h), or a checkpoint, with
 * which a block begins. That is the state of the controller, the number of rows of the trajectory
 * that it held, as 32 bits, and these rows. No cycle is missing in a block, its first one is whole,
 * and it holds no more than a second, so that it is read without any other. A cycle that no
 * checkpoint stands before is whole, as it cannot be computed again.
 */
#ifndef BORESIGHT_RECORDING_H
#define BORESIGHT_RECORDING_H

#include "limits/requirement_limits.h"
#include "recording/format/cycle_code.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define RECORDING_VERSION 5U
#define RECORDING_HASH_SIZE 32U
#define RECORDING_HEADER_SIZE 256U
#define RECORDING_FIELDS_SIZE 32U
/** Fields and hash. */
#define RECORDING_PREFIX_SIZE (RECORDING_FIELDS_SIZE + RECORDING_HASH_SIZE)
#define RECORDING_CHUNK 1024U /**< Payload bytes under one checksum. */
/** Most records of one block: a second of cycles. */
#define RECORDING_BLOCK_RECORDS (1000000U / LIMIT_CYCLE_US)
#define RECORDING_BLOCK_MAGIC 0x4B425342U   /**< "BSBK" */
#define RECORDING_TRAILER_MAGIC 0x4E455342U /**< "BSEN" */
#define RECORDING_RUN_END_MAGIC 0x45525342U /**< "BSRE", the trailer of a run's last recording. */

#define RECORDING_RUN_SIZE 32U /**< Size of the name of a run, with its end. */

/** The kind of a record that is no cycle (cycle_kind_t): the state of the controller. */
#define RECORDING_CHECKPOINT 3U

/** Largest size of a record, and of the records of a block. */
#define RECORDING_RECORD_MAX (1U + sizeof(controller_t) + sizeof(uint32_t) + CYCLE_CODE_MAX)
#define RECORDING_RAW_MAX ((size_t)768U * 1024U)

/**
 * The program that was running.
 *
 * @satisfies SWR-REC-003
 * @satisfies SWR-REC-008
 */
typedef struct {
    char build[64];           /**< Name of the build. */
    char robot[16];           /**< Name of the robot. */
    uint32_t robot_crc;       /**< CRC of its description. */
    uint32_t inputs_size;     /**< sizeof(controller_inputs_t). */
    uint32_t outputs_size;    /**< sizeof(controller_outputs_t). */
    uint32_t controller_size; /**< CONTROLLER_CHECKPOINT_BYTES. */
    uint64_t started_us;      /**< UTC since 1970. */
    uint64_t layout;          /**< INTERFACE_LAYOUT. */
    uint32_t frame_layout;    /**< cycle_words_frame_layout(), put in by the writer. */
    uint64_t run;             /**< As exchange_run() says; in all files of the run. */
} recording_header_t;

/** Fields of a block or of the trailer. */
typedef struct {
    uint32_t magic;
    uint32_t number; /**< Number of the block; of blocks in the trailer. */
    uint32_t cycle;  /**< Cycle of the first record; of the last one in the trailer. */
    uint32_t records;
    uint32_t raw_size;        /**< In the trailer the upper half of the number of records. */
    uint32_t compressed_size; /**< 0 in the trailer. */
    uint32_t cycles_lost;     /**< Before the block; altogether in the trailer. */
} recording_fields_t;

/** Writes `header` as RECORDING_HEADER_SIZE bytes; the last RECORDING_HASH_SIZE of them are their
 * hash. */
void recording_encode_header(const recording_header_t *header, uint8_t *bytes);

/** Writes the hash of a header. */
void recording_seal_header(uint8_t *bytes);

/**
 * Reads a header of recording_encode_header(). In each version only the meaning of the build is
 * certain.
 *
 * @return the version of the recording; 0: this is no header, or it was changed
 */
uint32_t recording_decode_header(const uint8_t *bytes, recording_header_t *header);

/** Writes the name of a run, such as 20261122T175000.123456Z. */
void recording_run_name(uint64_t run, char name[RECORDING_RUN_SIZE]);

/**
 * Writes `text` with \xNN for each byte that is no plain printable one.
 *
 * @satisfies SWR-REPLAY-008
 */
void recording_escape(const char *text, char *escaped, size_t size);

void recording_encode_fields(const recording_fields_t *fields, uint8_t *bytes);

/** False when the checksum of the fields is wrong. */
bool recording_decode_fields(const uint8_t *bytes, recording_fields_t *fields);

/** Bytes of the checksums of a payload. */
size_t recording_checksums_size(uint32_t compressed_size);

void recording_encode_checksums(const uint8_t *payload, uint32_t compressed_size, uint8_t *bytes);

/** Hash over the hash before it, RECORDING_FIELDS_SIZE bytes of fields, and `rest` (checksums and
 * payload). */
void recording_hash(const uint8_t *before, const uint8_t *fields, const uint8_t *rest,
                    size_t rest_size, uint8_t *hash);

#endif
