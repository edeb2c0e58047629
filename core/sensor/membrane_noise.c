/* SPDX-License-Identifier: Apache-2.0 */
#include "sensor/membrane_noise.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"

#define MOST_MN_Q12 (4000 * (int64_t)MEMBRANE_MN_Q12)
#define UN_PER_MN 1000U

static int64_t bounded(int64_t away_mn_q12)
{
    if (away_mn_q12 > MOST_MN_Q12) {
        return MOST_MN_Q12;
    }
    return (away_mn_q12 < -MOST_MN_Q12) ? -MOST_MN_Q12 : away_mn_q12;
}

bool membrane_noise_is_done(const membrane_noise_t *self)
{
    return self->count >= (LIMIT_MEMBRANE_SETTLE_MS + LIMIT_MEMBRANE_NOISE_MS);
}

void membrane_noise_step(membrane_noise_t *self, int32_t force_mn)
{
    const int32_t now_mn_q12 = membrane_filter_step(&self->filter, force_mn);
    if (membrane_noise_is_done(self)) {
        return;
    }
    if (self->count < LIMIT_MEMBRANE_SETTLE_MS) {
        self->first_mn_q12 = now_mn_q12;
    } else {
        const int64_t away_mn_q12 = bounded((int64_t)now_mn_q12 - (int64_t)self->first_mn_q12);
        self->sum_mn_q12 += away_mn_q12;
        self->squares_mn2_q24 += (uint64_t)(away_mn_q12 * away_mn_q12);
    }
    self->count++;
}

uint32_t membrane_noise_un(const membrane_noise_t *self)
{
    if (!membrane_noise_is_done(self)) {
        return 0U;
    }
    /* n^2 times the variance would need more than 64 bits: the mean is taken out first. */
    const int64_t mean_mn_q12 = self->sum_mn_q12 / (int64_t)LIMIT_MEMBRANE_NOISE_MS;
    const uint64_t mean_square = self->squares_mn2_q24 / LIMIT_MEMBRANE_NOISE_MS;
    const uint64_t of_the_mean = (uint64_t)(mean_mn_q12 * mean_mn_q12);
    const uint64_t variance = (mean_square > of_the_mean) ? (mean_square - of_the_mean) : 0U;
    return (uint32_t)(((uint64_t)fixed_square_root(variance) * UN_PER_MN) /
                      (uint64_t)MEMBRANE_MN_Q12);
}
