/* SPDX-License-Identifier: Apache-2.0 */
#include "sensor/membrane_filter.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"

#define COEFFICIENT_BITS 28U
/* b, a1 and a2; 4 b = 1 + a1 + a2 in whole numbers, so that a force at rest passes as it is. */
#define INPUT_Q28 INT64_C(972188)
#define OUTPUT_1_Q28 INT64_C(-489275943)
#define OUTPUT_2_Q28 INT64_C(224729239)

static void begin(membrane_filter_t *self, int32_t in_mn_q12)
{
    for (uint32_t i = 0U; i < 2U; i++) {
        self->in_mn_q12[i] = in_mn_q12;
        self->out_mn_q12[i] = in_mn_q12;
    }
    self->is_running = 1U;
}

int32_t membrane_filter_step(membrane_filter_t *self, int32_t force_mn)
{
    const int64_t most_mn = (int64_t)LIMIT_MEMBRANE_MOST_MN;
    const int64_t bounded_mn = fixed_within((int64_t)force_mn, -most_mn, most_mn);
    const int32_t in_mn_q12 = (int32_t)bounded_mn * MEMBRANE_MN_Q12;
    if (self->is_running == 0U) {
        begin(self, in_mn_q12);
    }
    const int64_t in_sum =
        (int64_t)in_mn_q12 + (2 * (int64_t)self->in_mn_q12[0]) + (int64_t)self->in_mn_q12[1];
    const int64_t sum = (INPUT_Q28 * in_sum) - (OUTPUT_1_Q28 * self->out_mn_q12[0]) -
                        (OUTPUT_2_Q28 * self->out_mn_q12[1]);
    const int32_t out_mn_q12 = fixed_saturate(fixed_shift_rounded(sum, COEFFICIENT_BITS));
    self->in_mn_q12[1] = self->in_mn_q12[0];
    self->in_mn_q12[0] = in_mn_q12;
    self->out_mn_q12[1] = self->out_mn_q12[0];
    self->out_mn_q12[0] = out_mn_q12;
    return out_mn_q12;
}
