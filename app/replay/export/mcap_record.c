/* SPDX-License-Identifier: Apache-2.0 */
#include "replay/export/mcap_record.h"

#include "common/little_endian.h"

#include <string.h>

#define LENGTH_AT 1U /* Place in a record: behind its kind. */

/* Four bits at a time. */
uint32_t mcap_crc_add(uint32_t crc, const uint8_t *bytes, size_t size)
{
    static const uint32_t table[16] = {0x00000000U, 0x1DB71064U, 0x3B6E20C8U, 0x26D930ACU,
                                       0x76DC4190U, 0x6B6B51F4U, 0x4DB26158U, 0x5005713CU,
                                       0xEDB88320U, 0xF00F9344U, 0xD6D6A3E8U, 0xCB61B38CU,
                                       0x9B64C2B0U, 0x86D3D2D4U, 0xA00AE278U, 0xBDBDF21CU};
    uint32_t sum = crc;

    for (size_t i = 0U; i < size; i++) {
        sum = (sum >> 4) ^ table[(sum ^ bytes[i]) & 0xFU];
        sum = (sum >> 4) ^ table[(sum ^ ((uint32_t)bytes[i] >> 4)) & 0xFU];
    }
    return sum;
}

void mcap_put_text(bytes_t *to, const char *text)
{
    bytes_put32(to, (uint32_t)strlen(text));
    bytes_put(to, text, strlen(text));
}

size_t mcap_record_begin(bytes_t *to, uint8_t kind)
{
    const size_t begin = to->used;

    bytes_put8(to, kind);
    bytes_put64(to, 0U);
    return begin;
}

void mcap_record_end(bytes_t *to, size_t begin)
{
    put64(&to->at[begin + LENGTH_AT], to->used - begin - LENGTH_AT - sizeof(uint64_t));
}

size_t mcap_list_begin(bytes_t *to)
{
    bytes_put32(to, 0U);
    return to->used;
}

void mcap_list_end(bytes_t *to, size_t begin)
{
    put32(&to->at[begin - sizeof(uint32_t)], (uint32_t)(to->used - begin));
}
