/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * OpenIGTLink messages as bytes: reads header versions 1 and 2, writes version 1. No allocation, no
 * copy of a body; every length is checked in 64 bits before it is used. Numbers stay the bits of
 * the wire (igtl_border.h).
 */
#ifndef BORESIGHT_IGTL_CODEC_H
#define BORESIGHT_IGTL_CODEC_H

#include <stddef.h>
#include <stdint.h>

#define IGTL_HEADER_BYTES 58U
#define IGTL_TYPE_SIZE 13U /**< 12 characters and a NUL. */
#define IGTL_NAME_SIZE 21U /**< 20 characters and a NUL. */
#define IGTL_TRANSFORM_NUMBERS 12U
#define IGTL_TRANSFORM_BYTES 48U
#define IGTL_POINT_BYTES 136U
#define IGTL_STATUS_BYTES 30U /**< Before the text. */
#define IGTL_TEXT_MAX 255U    /**< Longest text that is sent. */
#define IGTL_PACKET_MAX (IGTL_HEADER_BYTES + IGTL_STATUS_BYTES + IGTL_TEXT_MAX + 1U)

/** What is understood; everything else is skipped by its length. */
typedef enum {
    IGTL_KIND_OTHER = 0,
    IGTL_KIND_TRANSFORM = 1,
    IGTL_KIND_STRING = 2,
    IGTL_KIND_STATUS = 3,
    IGTL_KIND_POINT = 4,
    IGTL_KIND_GET_TRANSFORM = 5,
    IGTL_KIND_GET_STATUS = 6
} igtl_kind_t;

/** What is wrong with a message. */
typedef enum {
    IGTL_OK = 0,            /**< Well formed. */
    IGTL_BAD_VERSION = 1,   /**< The header version is neither 1 nor 2. */
    IGTL_BAD_NAME = 2,      /**< The type or the device name is not printable ASCII. */
    IGTL_TOO_LONG = 3,      /**< The body is longer than is accepted. */
    IGTL_BAD_CRC = 4,       /**< The checksum of the body is wrong. */
    IGTL_BAD_EXTENSION = 5, /**< The extended header does not fit the body. */
    IGTL_BAD_METADATA = 6,  /**< The metadata does not fit its lengths. */
    IGTL_BAD_LENGTH = 7,    /**< The length is not that of the type. */
    IGTL_BAD_ENCODING = 8,  /**< The text is neither US-ASCII nor UTF-8. */
    IGTL_BAD_TEXT = 9,      /**< The text is not printable ASCII. */
    IGTL_INCOMPLETE = 10    /**< The rest of the message did not come in time. */
} igtl_result_t;

/** STATUS codes of the protocol that are used. */
typedef enum {
    IGTL_STATUS_OK = 1,
    IGTL_STATUS_ACCESS_DENIED = 5,
    IGTL_STATUS_NOT_FOUND = 4,
    IGTL_STATUS_BUSY = 6,
    IGTL_STATUS_TIME_OUT = 7,
    IGTL_STATUS_OVERFLOW = 8,
    IGTL_STATUS_CHECKSUM_ERROR = 9,
    IGTL_STATUS_CONFIG_ERROR = 10,
    IGTL_STATUS_UNKNOWN_INSTRUCTION = 12,
    IGTL_STATUS_NOT_READY = 13,
    IGTL_STATUS_UNKNOWN_VERSION = 17
} igtl_status_code_t;

typedef struct {
    uint32_t version;
    igtl_kind_t kind;
    char type[IGTL_TYPE_SIZE];
    char name[IGTL_NAME_SIZE];
    uint64_t body_bytes;
    uint64_t crc;
} igtl_header_t;

/** A received message. `content` and `text` point into the receive buffer and live as long as it is
 * not refilled. */
typedef struct {
    igtl_kind_t kind;
    char name[IGTL_NAME_SIZE];
    const uint8_t *content; /**< Without extended header and metadata. */
    uint32_t content_bytes;
    uint32_t numbers[IGTL_TRANSFORM_NUMBERS]; /**< TRANSFORM: float bits, column by column, then x y
                                                 z in mm. */
    const char *text;                         /**< STRING: not terminated. */
    uint32_t text_bytes;
    uint32_t code; /**< STATUS. */
} igtl_message_t;

/** A message to be sent, complete. */
typedef struct {
    uint32_t length;
    uint8_t bytes[IGTL_PACKET_MAX];
} igtl_packet_t;

/** Continues the CRC-64 (ECMA-182: not reflected, starts at 0) `crc` over `length` bytes.
 * "123456789" gives 0x6C40DF5F0B497347. */
uint64_t igtl_crc64(uint64_t crc, const uint8_t *bytes, size_t length);

/** Name and sentence, "BAD_CRC: The checksum of the body is wrong.". Lives for ever. */
const char *igtl_result_text(igtl_result_t result);

/** STATUS code that tells a peer of `result`. */
uint32_t igtl_result_code(igtl_result_t result);

/**
 * Reads a header. Says nothing about the body but its bound: LIMIT_IGTL_BODY_MAX for a known type,
 * LIMIT_IGTL_SKIP_MAX for an unknown one.
 *
 * @return IGTL_OK, IGTL_BAD_VERSION, IGTL_BAD_NAME or IGTL_TOO_LONG
 *
 * @satisfies SWR-IGTL-001
 * @satisfies SWR-IGTL-003
 */
igtl_result_t igtl_decode_header(const uint8_t bytes[IGTL_HEADER_BYTES], igtl_header_t *header);

/**
 * Reads the `header->body_bytes` of `body` (at most LIMIT_IGTL_BODY_MAX) of a known type.
 *
 * @return IGTL_OK, or the first thing that is wrong: IGTL_BAD_CRC, IGTL_BAD_EXTENSION,
 * IGTL_BAD_METADATA, IGTL_BAD_LENGTH, IGTL_BAD_ENCODING, IGTL_BAD_TEXT
 *
 * @satisfies SWR-IGTL-002
 * @satisfies SWR-IGTL-003
 */
igtl_result_t igtl_decode_body(const igtl_header_t *header, const uint8_t *body,
                               igtl_message_t *message);

/**
 * Writers. Names beyond 20 and texts beyond IGTL_TEXT_MAX characters are cut; `timestamp` is in
 * units of 2^-32 s since 1970, 0 for none.
 *
 * @satisfies SWR-IGTL-005
 */
void igtl_encode_transform(igtl_packet_t *packet, const char *name,
                           const uint32_t numbers[IGTL_TRANSFORM_NUMBERS], uint64_t timestamp);
void igtl_encode_string(igtl_packet_t *packet, const char *name, const char *text,
                        uint64_t timestamp);
void igtl_encode_point(igtl_packet_t *packet, const char *name, const uint32_t numbers[3],
                       uint64_t timestamp);

/** What a STATUS says. `error_name` is cut to 19 characters. */
typedef struct {
    uint32_t code;
    const char *error_name;
    const char *text;
} igtl_status_t;

void igtl_encode_status(igtl_packet_t *packet, const char *name, const igtl_status_t *status,
                        uint64_t timestamp);

#endif
