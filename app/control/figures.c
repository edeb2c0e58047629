/* SPDX-License-Identifier: Apache-2.0 */
#include "control/figures.h"

#include "limits/requirement_limits.h"

#include <string.h>

#define NS_PER_US 1000U

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

void figures_add(figures_t *self, const uint64_t stage_ns[LOOP_STAGE_COUNT])
{
    const uint64_t wake_us = stage_ns[LOOP_STAGE_WAKE] / NS_PER_US;
    for (uint32_t i = 0; i < LOOP_STAGE_COUNT; i++) {
        histogram_add(&self->stages[i], stage_ns[i] / NS_PER_US);
    }
    if (wake_us > self->second_worst_us) {
        self->second_worst_us = (uint32_t)wake_us;
    }
}

/* Bars from 0, 1, 2, 4 us on, each twice as wide as the one before. */
static void publish_stage(const histogram_t *histogram, stage_figures_t *published)
{
    uint32_t bar = 0;
    (void)memset(published->counts, 0, sizeof published->counts);
    for (uint32_t i = 0; (i < FIGURES_BUCKETS) && (i <= histogram->worst_us); i++) {
        if (((i >> bar) > 0U) && (bar < (LIMIT_LOOP_BARS - 1U))) {
            bar++;
        }
        published->counts[bar] += histogram->count[i];
    }
    published->worst_us = histogram->worst_us;
}

void figures_publish(figures_t *self, loop_figures_t *published)
{
    const histogram_t *wake = &self->stages[LOOP_STAGE_WAKE];
    const histogram_t *step = &self->stages[LOOP_STAGE_STEP];
    published->cycles = wake->total;
    published->wake_p50_us = histogram_quantile_us(wake, 500);
    published->wake_p99_us = histogram_quantile_us(wake, 990);
    published->wake_p999_us = histogram_quantile_us(wake, 999);
    published->wake_worst_us = wake->worst_us;
    published->step_p99_us = histogram_quantile_us(step, 990);
    published->step_worst_us = step->worst_us;
    published->second_worst_us = self->second_worst_us;
    for (uint32_t i = 0; i < LOOP_STAGE_COUNT; i++) {
        publish_stage(&self->stages[i], &published->stages[i]);
    }
    self->second_worst_us = 0;
}
