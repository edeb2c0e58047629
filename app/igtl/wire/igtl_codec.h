/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * OpenIGTLink messages as they arrive, with header version 1 or 2; igtl_packet.h writes them. No
 * allocation, no copy of a body; every length is checked in 64 bits before it is used. Numbers stay
 * the bits of the wire (igtl_units.h).
 */
#ifndef BORESIGHT_IGTL_CODEC_H
#define BORESIGHT_IGTL_CODEC_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define IGTL_HEADER_BYTES 58U
#define IGTL_TYPE_SIZE 13U /**< 12 characters and a NUL. */
#define IGTL_NAME_SIZE 21U /**< 20 characters and a NUL. */
#define IGTL_TRANSFORM_NUMBERS 12U
#define IGTL_TRANSFORM_BYTES 48U
#define IGTL_POINT_BYTES 136U
#define IGTL_TRAJECTORY_BYTES 150U /**< One element of a TRAJ. */
#define IGTL_TRAJECTORY_NUMBERS 6U
#define IGTL_STATUS_NAME_OFFSET 10U  /**< Offset of the error name, behind code and subcode. */
#define IGTL_STATUS_NAME_BYTES 20U   /**< Size of the error name. */
#define IGTL_STATUS_BYTES 30U        /**< Before the text. */
#define IGTL_STREAM_BYTES 36U        /**< STT_TDATA. */
#define IGTL_COMMAND_BYTES 138U      /**< Before the text. */
#define IGTL_COMMAND_NAME_BYTES 128U /**< Size of the name of a COMMAND. */
#define IGTL_EXTENSION_BYTES 12U     /**< The extended header of version 2. */
#define IGTL_ENCODING_ASCII 3U
#define IGTL_ENCODING_UTF8 106U

/** The known types; each other one is skipped by its length. */
typedef enum {
    IGTL_KIND_OTHER = 0,
    IGTL_KIND_TRANSFORM = 1,
    IGTL_KIND_STRING = 2,
    IGTL_KIND_STATUS = 3,
    IGTL_KIND_POINT = 4,
    IGTL_KIND_GET_TRANSFORM = 5,
    IGTL_KIND_GET_STATUS = 6,
    IGTL_KIND_GET_POINT = 7,
    IGTL_KIND_GET_CAPABILITY = 8,
    IGTL_KIND_GET_OTHER = 9, /**< GET_ of anything else, with any content. */
    IGTL_KIND_STT_TDATA = 10,
    IGTL_KIND_STP_TDATA = 11,
    IGTL_KIND_STT_OTHER = 12,
    IGTL_KIND_STP_OTHER = 13,
    IGTL_KIND_COMMAND = 14,
    IGTL_KIND_TRAJECTORY = 15,
    IGTL_KIND_ARRAY = 16,
    IGTL_KIND_GET_SENSOR = 17
} igtl_kind_t;

/** The fault of a message. */
typedef enum {
    IGTL_OK = 0,              /**< Well formed. */
    IGTL_BAD_VERSION = 1,     /**< The header version is neither 1 nor 2. */
    IGTL_BAD_NAME = 2,        /**< The type or the device name is not printable ASCII. */
    IGTL_TOO_LONG = 3,        /**< The body is longer than is accepted. */
    IGTL_BAD_CRC = 4,         /**< The checksum of the body is wrong. */
    IGTL_BAD_EXTENSION = 5,   /**< The extended header does not fit the body. */
    IGTL_BAD_METADATA = 6,    /**< The metadata does not fit its lengths. */
    IGTL_BAD_LENGTH = 7,      /**< The length is not that of the type. */
    IGTL_BAD_ENCODING = 8,    /**< The text is neither US-ASCII nor UTF-8. */
    IGTL_BAD_TEXT = 9,        /**< The text is not printable ASCII. */
    IGTL_INCOMPLETE = 10,     /**< The rest of the message did not come in time. */
    IGTL_MARKED_INVALID = 11, /**< Its sender says that it is not valid. */
    IGTL_NOT_ONE = 12,        /**< Not exactly one trajectory stands in it. */
    IGTL_NOT_TABLE = 13       /**< An array, but none of rows and columns of floating point. */
} igtl_result_t;

/** The points of an element of a TRAJ. */
typedef enum {
    IGTL_TRAJECTORY_ENTRY = 1,
    IGTL_TRAJECTORY_TARGET = 2,
    IGTL_TRAJECTORY_BOTH = 3
} igtl_trajectory_t;

/** STATUS codes of the protocol that are used. */
typedef enum {
    IGTL_STATUS_OK = 1,
    IGTL_STATUS_PANIC_MODE = 3,
    IGTL_STATUS_ACCESS_DENIED = 5,
    IGTL_STATUS_NOT_FOUND = 4,
    IGTL_STATUS_BUSY = 6,
    IGTL_STATUS_TIME_OUT = 7,
    IGTL_STATUS_OVERFLOW = 8,
    IGTL_STATUS_CHECKSUM_ERROR = 9,
    IGTL_STATUS_CONFIG_ERROR = 10,
    IGTL_STATUS_UNKNOWN_INSTRUCTION = 12,
    IGTL_STATUS_NOT_READY = 13,
    IGTL_STATUS_UNKNOWN_VERSION = 17,
    IGTL_STATUS_HARDWARE_FAILURE = 18
} igtl_status_code_t;

typedef struct {
    uint32_t version;
    igtl_kind_t kind;
    char type[IGTL_TYPE_SIZE];
    char name[IGTL_NAME_SIZE];
    uint64_t body_bytes;
    uint64_t crc;
} igtl_header_t;

/** A received message. Its pointers lead into the receive buffer, not terminated, and are valid as
 * long as that is not refilled; a field that its type does not have is 0 or NULL (`numbers`:
 * undefined). */
typedef struct {
    uint32_t version; /**< Version of the header, 1 or 2. */
    igtl_kind_t kind;
    char type[IGTL_TYPE_SIZE];
    char name[IGTL_NAME_SIZE];
    const uint8_t *content; /**< Without extended header and metadata. */
    uint32_t content_bytes;
    uint32_t numbers[IGTL_TRANSFORM_NUMBERS]; /**< TRANSFORM: float bits, column by column, then x y
                                                 z in mm. TRAJ: entry, then target, x y z in mm. */
    const char *text;                         /**< STRING: printable ASCII. COMMAND: any bytes. */
    uint32_t text_bytes;
    uint32_t code;          /**< STATUS: its code. COMMAND: its id. TRAJ: what it has, any value. */
    int32_t resolution_ms;  /**< STT_TDATA: least time between two poses, any value. */
    const char *subject;    /**< STT_TDATA: coordinate system. COMMAND: name. Printable ASCII. */
    uint32_t subject_bytes; /**< Up to 32 and up to IGTL_COMMAND_NAME_BYTES. */
    uint32_t rows;          /**< NDARRAY. */
    uint32_t columns;       /**< NDARRAY. */
    uint32_t number_bytes;  /**< NDARRAY: 4 or 8 of each number. */
} igtl_message_t;

/** Name and sentence, "BAD_CRC: The checksum of the body is wrong.". Lives as long as the process.
 */
const char *igtl_result_text(igtl_result_t result);

/** STATUS code that reports `result` to a peer. */
uint32_t igtl_result_code(igtl_result_t result);

/**
 * Reads a header, and judges the length that it states. Where the next message begins is known
 * unless igtl_header_is_lost().
 *
 * @return IGTL_OK, or the first thing that is wrong: IGTL_BAD_VERSION; IGTL_TOO_LONG, with more
 * than LIMIT_IGTL_SKIP_MAX; IGTL_BAD_NAME, with `?` for each byte that is not printable;
 * IGTL_TOO_LONG, of a known type with more than LIMIT_IGTL_BODY_MAX, of an NDARRAY with more than
 * LIMIT_IGTL_ARRAY_MAX
 *
 * @satisfies SWR-IGTL-001
 * @satisfies SWR-IGTL-003
 */
igtl_result_t igtl_decode_header(const uint8_t bytes[IGTL_HEADER_BYTES], igtl_header_t *header);

/** The header has another version, or a body so long that it is not waited for. */
bool igtl_header_is_lost(const igtl_header_t *header);

/**
 * Reads the `header->body_bytes` of `body` of a known type, no more than igtl_decode_header()
 * passes.
 *
 * @return IGTL_OK, or the first thing that is wrong: IGTL_BAD_CRC, IGTL_BAD_EXTENSION,
 * IGTL_BAD_METADATA; IGTL_MARKED_INVALID, of a TRANSFORM with metadata TransformStatus other than
 * OK; IGTL_BAD_LENGTH, IGTL_NOT_ONE, IGTL_NOT_TABLE, IGTL_BAD_ENCODING, IGTL_BAD_TEXT
 *
 * @satisfies SWR-IGTL-002
 * @satisfies SWR-IGTL-003
 * @satisfies SWR-IGTL-018
 * @satisfies SWR-IGTL-022
 * @satisfies SWR-IGTL-054
 */
igtl_result_t igtl_decode_body(const igtl_header_t *header, const uint8_t *body,
                               igtl_message_t *message);

/** Number `index` of an NDARRAY, row by row from 0 on: its bits, the lower 32 of a shorter one. */
uint64_t igtl_array_bits(const igtl_message_t *message, uint32_t index);

#endif
