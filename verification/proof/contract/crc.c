/* SPDX-License-Identifier: Apache-2.0 */
/* Contract of core/base/crc.h: the bytes can be read, and the checksum is any. */
#include "base/crc.h"

#include "prove.h"

uint32_t crc32c(const uint8_t *bytes, size_t length)
{
    uint32_t crc;
    PROVE(__CPROVER_r_ok(bytes, length), "contract of crc32c: bytes that can be read");
    return crc;
}

static uint32_t any(const uint8_t *bytes)
{
    uint32_t crc;
    PROVE(__CPROVER_r_ok(bytes, 244U), "contract of crc32c: a frame behind its header");
    return crc;
}

uint32_t crc32c_over_132(uint32_t crc, const uint8_t *bytes)
{
    (void)crc;
    return any(bytes);
}

uint32_t crc32c_over_172(uint32_t crc, const uint8_t *bytes)
{
    (void)crc;
    return any(bytes);
}

uint32_t crc32c_over_28_and_132(uint32_t crc, const uint8_t *bytes)
{
    (void)crc;
    return any(bytes);
}

uint32_t crc32c_over_28_and_172(uint32_t crc, const uint8_t *bytes)
{
    (void)crc;
    return any(bytes);
}
