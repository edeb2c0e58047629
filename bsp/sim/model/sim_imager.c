/* SPDX-License-Identifier: Apache-2.0 */
#include "sim/model/sim_imager.h"

#include <string.h>

#define US_PER_MS UINT64_C(1000)

void sim_imager_init(sim_imager_t *self, uint32_t seed)
{
    (void)memset(self, 0, sizeof *self);
    self->random.state = seed;
}

static void bring(sim_imager_t *self, uint64_t delay_us, uint64_t now_us)
{
    while ((self->waiting > 0U) && (now_us >= self->on_way[0].taken_us + delay_us)) {
        self->last = self->on_way[0];
        self->waiting--;
        (void)memmove(&self->on_way[0], &self->on_way[1], self->waiting * sizeof self->on_way[0]);
    }
}

bool sim_imager_step(sim_imager_t *self, const sim_imager_config_t *config, uint64_t now_us)
{
    const uint64_t period_us = (uint64_t)config->period_ms * US_PER_MS;

    bring(self, (uint64_t)config->delay_ms * US_PER_MS, now_us);
    return (period_us > 0U) && ((now_us % period_us) == 0U) && (self->waiting < SIM_IMAGER_WAITING);
}

static sim_vector_t noise(sim_random_t *random, double deviation)
{
    const double x = sim_random_normal(random);
    const double y = sim_random_normal(random);
    const double z = sim_random_normal(random);

    return (sim_vector_t){deviation * x, deviation * y, deviation * z};
}

void sim_imager_take(sim_imager_t *self, const sim_imager_config_t *config, uint64_t now_us,
                     sim_vector_t place_mm, sim_vector_t direction)
{
    sim_image_t *const image = &self->on_way[self->waiting];
    const sim_vector_t off_mm = noise(&self->random, config->noise_mm);
    const sim_vector_t tilt = noise(&self->random, config->noise_deg * SIM_RAD_PER_DEG);
    /* What of it is along the direction turns nothing. */
    const sim_vector_t across = sim_space_cross(tilt, direction);

    self->taken++;
    self->waiting++;
    *image = (sim_image_t){.number = self->taken,
                           .taken_us = now_us,
                           .place_mm = sim_space_add(place_mm, 1.0, off_mm),
                           .direction = sim_space_unit(sim_space_add(direction, 1.0, across))};
}
