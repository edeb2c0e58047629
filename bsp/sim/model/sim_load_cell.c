/* SPDX-License-Identifier: Apache-2.0 */
#include "sim/model/sim_load_cell.h"

#include <stdbool.h>

#define PAST (SIM_LOAD_CELL_LATENCY_MOST + 1U)
#define PERIOD_S 0.001

static uint32_t counts_of(const sim_load_cell_t *self, double force_n)
{
    const double counts = self->zero_counts + SIM_LOAD_CELL_COUNTS_PER_N * force_n;

    if (counts <= 0.0) {
        return 0U;
    }
    return (counts >= (double)SIM_LOAD_CELL_MOST) ? SIM_LOAD_CELL_MOST : (uint32_t)(counts + 0.5);
}

void sim_load_cell_init(sim_load_cell_t *self, const sim_load_cell_config_t *config,
                        double zero_counts, uint32_t seed)
{
    *self =
        (sim_load_cell_t){.config = *config, .zero_counts = zero_counts, .random = {.state = seed}};
    self->reading = counts_of(self, config->offset_n);
}

void sim_load_cell_set(sim_load_cell_t *self, uint32_t reading)
{
    self->fault = SIM_LOAD_CELL_STUCK;
    self->reading = reading;
}

static double delayed(sim_load_cell_t *self, double force_n)
{
    const uint32_t latency = (uint32_t)self->config.latency_ms;

    self->past_at = (self->past_at + 1U) % PAST;
    self->past_n[self->past_at] = force_n;
    return self->past_n[(self->past_at + PAST - latency) % PAST];
}

/* Each reading takes its share of chance, whatever becomes of it. */
static uint32_t read_cell(sim_load_cell_t *self, double force_n)
{
    const bool is_noisy = self->fault == SIM_LOAD_CELL_NOISY;
    const bool is_drifting = self->fault == SIM_LOAD_CELL_DRIFT;
    const double noise_n = is_noisy ? SIM_LOAD_CELL_NOISE_N : self->config.noise_n;
    const double step_n = (self->fault == SIM_LOAD_CELL_STEP) ? SIM_LOAD_CELL_STEP_N : 0.0;

    self->wandered_n +=
        (self->config.drift_n_per_s + (is_drifting ? SIM_LOAD_CELL_DRIFT_N_PER_S : 0.0)) * PERIOD_S;
    return counts_of(self, delayed(self, force_n) + self->config.offset_n + self->wandered_n +
                               step_n + noise_n * sim_random_normal(&self->random));
}

static void take_reading(sim_load_cell_t *self, double force_n)
{
    const uint32_t reading = read_cell(self, force_n);

    switch (self->fault) {
    case SIM_LOAD_CELL_STUCK:
        break;
    case SIM_LOAD_CELL_BROKEN:
        self->reading = 0U;
        break;
    case SIM_LOAD_CELL_FULL:
        self->reading = SIM_LOAD_CELL_MOST;
        break;
    case SIM_LOAD_CELL_NORMAL:
    case SIM_LOAD_CELL_STEP:
    case SIM_LOAD_CELL_DRIFT:
    case SIM_LOAD_CELL_NOISY:
    default:
        self->reading = reading;
        break;
    }
}

void sim_load_cell_step(sim_load_cell_t *self, uint32_t step_us, double force_n)
{
    self->since_us += step_us;
    if (self->since_us >= SIM_LOAD_CELL_PERIOD_US) {
        self->since_us -= SIM_LOAD_CELL_PERIOD_US;
        take_reading(self, force_n);
    }
}
