/* SPDX-License-Identifier: Apache-2.0 */
#include "control/figures.h"

void histogram_add(histogram_t *self, uint64_t value_us)
{
    const uint32_t bucket =
        (value_us < FIGURES_BUCKETS) ? (uint32_t)value_us : (FIGURES_BUCKETS - 1U);
    self->count[bucket]++;
    self->total++;
    if (value_us > self->worst_us) {
        self->worst_us = (uint32_t)value_us;
    }
}

uint32_t histogram_quantile_us(const histogram_t *self, uint32_t per_mille)
{
    const uint64_t wanted = ((self->total * per_mille) + 999U) / 1000U;
    uint64_t seen = 0;
    for (uint32_t i = 0; i < FIGURES_BUCKETS; i++) {
        seen += self->count[i];
        if ((seen >= wanted) && (seen > 0U)) {
            return i;
        }
    }
    return 0;
}

void figures_add(figures_t *self, uint64_t wake_us, uint64_t step_us)
{
    histogram_add(&self->wake, wake_us);
    histogram_add(&self->step, step_us);
    if (wake_us > self->second_worst_us) {
        self->second_worst_us = (uint32_t)wake_us;
    }
}

void figures_publish(figures_t *self, loop_figures_t *published)
{
    published->cycles = self->wake.total;
    published->wake_p50_us = histogram_quantile_us(&self->wake, 500);
    published->wake_p99_us = histogram_quantile_us(&self->wake, 990);
    published->wake_p999_us = histogram_quantile_us(&self->wake, 999);
    published->wake_worst_us = self->wake.worst_us;
    published->step_p99_us = histogram_quantile_us(&self->step, 990);
    published->step_worst_us = self->step.worst_us;
    published->second_worst_us = self->second_worst_us;
    self->second_worst_us = 0;
}
