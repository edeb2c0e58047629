/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Bytes of one OpenIGTLink message in a test, and its decoding.
 */
#ifndef BORESIGHT_IGTL_CODEC_WORLD_H
#define BORESIGHT_IGTL_CODEC_WORLD_H

#include "igtl/wire/igtl_codec.h"
#include "igtl/wire/igtl_crc64.h"
#include "igtl/wire/igtl_packet.h"
#include "limits/requirement_limits.h"
#include "unity.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#define ONE 0x3F800000U

static uint8_t bytes[IGTL_HEADER_BYTES + LIMIT_IGTL_BODY_MAX];
static igtl_header_t header;
static igtl_message_t message;

static void begin_message(void)
{
    (void)memset(bytes, 0, sizeof bytes);
    (void)memset(&message, 0, sizeof message);
}

static void put(uint32_t at, uint64_t value, uint32_t count)
{
    for (uint32_t i = 0U; i < count; i++) {
        bytes[at + i] = (uint8_t)(value >> (8U * (count - 1U - i)));
    }
}

/* A header in front of `body_bytes` that are in place, with their checksum. */
static void frame(uint32_t version, const char *type, uint32_t body_bytes)
{
    put(0U, version, 2U);
    (void)memset(&bytes[2], 0, 40U);
    (void)memcpy(&bytes[2], type, strlen(type));
    put(42U, body_bytes, 8U);
    put(50U, igtl_crc64(0U, &bytes[IGTL_HEADER_BYTES], body_bytes), 8U);
}

static igtl_result_t decode(void)
{
    const igtl_result_t result = igtl_decode_header(bytes, &header);

    return (result == IGTL_OK) ? igtl_decode_body(&header, &bytes[IGTL_HEADER_BYTES], &message)
                               : result;
}

#endif
