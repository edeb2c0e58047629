/* SPDX-License-Identifier: Apache-2.0 */
#include "sensor/membrane_noise.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"

#define MOST_MN_Q12 (INT64_C(4000) * MEMBRANE_MN_Q12)
#define UN_PER_MN 1000U
#define PERMILLE 1000U

bool membrane_noise_is_done(const membrane_noise_t *self)
{
    return self->count >= (LIMIT_MEMBRANE_SETTLE_MS + LIMIT_MEMBRANE_NOISE_MS);
}

static void add(membrane_sums_t *sums, int64_t value_mn_q12)
{
    const int64_t away_mn_q12 =
        fixed_within(value_mn_q12 - (int64_t)sums->first_mn_q12, -MOST_MN_Q12, MOST_MN_Q12);
    sums->sum_mn_q12 += away_mn_q12;
    sums->squares_mn2_q24 += away_mn_q12 * away_mn_q12;
}

void membrane_noise_step(membrane_noise_t *self, int32_t force_mn)
{
    const int32_t filtered_mn_q12 = membrane_filter_step(&self->filter, force_mn);
    const int32_t force_mn_q12 = self->filter.in_mn_q12[0];
    if (membrane_noise_is_done(self)) {
        return;
    }
    if (self->count < LIMIT_MEMBRANE_SETTLE_MS) {
        self->filtered.first_mn_q12 = filtered_mn_q12;
        self->forces.first_mn_q12 = force_mn_q12;
    } else {
        add(&self->filtered, (int64_t)filtered_mn_q12);
        add(&self->forces, (int64_t)force_mn_q12);
    }
    self->count++;
}

/* The mean is taken out first: n^2 times the variance would need more than 64 bits. */
static uint32_t deviation_un(const membrane_sums_t *sums)
{
    const int64_t mean_mn_q12 = sums->sum_mn_q12 / (int64_t)LIMIT_MEMBRANE_NOISE_MS;
    const int64_t mean_square = sums->squares_mn2_q24 / (int64_t)LIMIT_MEMBRANE_NOISE_MS;
    const int64_t variance = fixed_larger(mean_square - (mean_mn_q12 * mean_mn_q12), 0);
    const uint64_t root_mn_q12 = fixed_square_root((uint64_t)variance);
    return (uint32_t)((root_mn_q12 * UN_PER_MN) / (uint64_t)MEMBRANE_MN_Q12);
}

uint32_t membrane_noise_un(const membrane_noise_t *self)
{
    const uint32_t filtered_un = deviation_un(&self->filtered);
    const uint32_t white_un =
        (deviation_un(&self->forces) * LIMIT_MEMBRANE_WHITE_PERMILLE) / PERMILLE;
    if (!membrane_noise_is_done(self)) {
        return 0U;
    }
    return (filtered_un > white_un) ? filtered_un : white_un;
}
