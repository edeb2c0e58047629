/* SPDX-License-Identifier: Apache-2.0 */
/** @file The exchange of a module that is one process: its segment is memory like any other, and
 * has no lane of cycles, as nothing records. */
#include "exchange/exchange.h"
#include "exchange/exchange_segment.h"

#include "interface/interface_layout.h"

#include <string.h>

static segment_t segment;
static exchange_t exchange;

uint64_t segment_layout(void)
{
    return INTERFACE_LAYOUT ^ (uint64_t)segment_bytes(1U);
}

exchange_t *exchange_create(const char *name, uint32_t cycles, char *error, uint32_t error_size)
{
    (void)name;
    (void)cycles;
    (void)error;
    (void)error_size;
    (void)memset(&segment, 0, sizeof segment);
    (void)memset(&exchange, 0, sizeof exchange);
    segment.header.magic = SEGMENT_MAGIC;
    segment.header.layout = segment_layout();
    exchange.segment = &segment;
    return &exchange;
}
