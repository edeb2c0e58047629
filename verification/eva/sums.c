/* SPDX-License-Identifier: Apache-2.0 */
/* Functions of which Eva sees a contract elsewhere (instead/base), followed here as they are: sums
 * over every length up to twice the rounds of each loop, of bytes that end with their array, and
 * the trace of a chart. A longer sum is more of the same rounds. */
#include "../../core/base/chart.h"
#include "../../core/base/crc.h"
#include "../../core/base/seal.h"

#include "../../core/base/crc.c"

#include "sums.h"

#include <__fc_builtin.h>

#define MOST 152U
#define MOST_CRC 43U
#define FRAME 244U

void follow_sums(void)
{
    uint8_t bytes[MOST];
    Frama_C_make_unknown((char *)bytes, sizeof bytes);
    /*@ loop unroll MOST_CRC + 1; */
    for (uint32_t length = 0U; length <= MOST_CRC; length++) {
        (void)crc32c(&bytes[MOST - length], length);
    }
    /*@ loop unroll MOST + 1; */
    for (uint32_t length = 0U; length <= MOST; length += 4U) {
        (void)seal_of(SEAL_START, &bytes[MOST - length], length);
    }
}

void follow_frames(void)
{
    uint8_t bytes[FRAME];
    uint32_t crc = 0U;
    Frama_C_make_unknown((char *)bytes, sizeof bytes);
    Frama_C_make_unknown((char *)&crc, sizeof crc);
    (void)crc32c_over_132(crc, bytes);
    (void)crc32c_over_172(crc, bytes);
    (void)crc32c_over_28_and_132(crc, bytes);
    (void)crc32c_over_28_and_172(crc, bytes);
}

void follow_trace(void)
{
    chart_trace_t trace;
    Frama_C_make_unknown((char *)&trace, sizeof trace);
    chart_trace_add(&trace, trace.steps[0].now_us, trace.steps[0].transition);
}
