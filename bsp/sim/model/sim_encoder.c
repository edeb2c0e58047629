/* SPDX-License-Identifier: Apache-2.0 */
#include "sim/model/sim_encoder.h"

#include "sim/model/sim_motor.h"

#include <math.h>
#include <string.h>

static const double edge_pattern[4] = {0.0, 0.0943, -0.0471, 0.0471};

static int32_t floor_ticks(double value)
{
    const int32_t truncated = (int32_t)value;

    return ((double)truncated > value) ? truncated - 1 : truncated;
}

/* Place where `state` begins. */
static double edge_of(const sim_encoder_t *self, int32_t state)
{
    return (double)state + self->edge_offsets[(uint32_t)state & 3U];
}

void sim_encoder_init(sim_encoder_t *self, const axis_config_t *axis, double position_ticks,
                      int32_t reading, uint32_t seed)
{
    *self = (sim_encoder_t){.random = {seed},
                            .is_inverted = axis->is_encoder_inverted != 0U,
                            .fault = SIM_ENCODER_NORMAL,
                            .state = floor_ticks(position_ticks),
                            .count = (uint32_t)reading};
    const uint32_t turn = sim_random_below(&self->random, 4U);
    for (uint32_t i = 0U; i < 4U; i++) {
        self->edge_offsets[i] = edge_pattern[(i + turn) & 3U];
    }
    if (position_ticks < edge_of(self, self->state)) {
        self->state--;
    }
    if (position_ticks >= edge_of(self, self->state + 1)) {
        self->state++;
    }
}

static void record_edge(sim_encoder_t *self, int32_t change, uint32_t time_us)
{
    self->count += (uint32_t)change;
    self->edges++;
    (void)memmove(&self->stamps_us[1], &self->stamps_us[0], 4U * sizeof self->stamps_us[0]);
    self->stamps_us[0] = time_us;
}

static void cross_edge(sim_encoder_t *self, int32_t change, uint32_t time_us)
{
    const bool is_reversed = self->is_inverted != (self->fault == SIM_ENCODER_REVERSED);

    self->state += change;
    const bool is_lost =
        (self->fault == SIM_ENCODER_STUCK) ||
        ((self->fault == SIM_ENCODER_HALF) && (((uint32_t)self->state & 1U) != 0U));
    if (!is_lost) {
        record_edge(self, is_reversed ? -change : change, time_us);
    }
}

/* A shaft that stands has been put there in this step. */
static uint32_t crossing_time(double edge, double from_ticks, double to_ticks, uint32_t start_us)
{
    const double way = to_ticks - from_ticks;
    const double share = (fabs(way) > 0.0) ? ((edge - from_ticks) / way) : 0.0;

    return start_us + (uint32_t)(share * (double)SIM_STEP_US);
}

static void follow_shaft(sim_encoder_t *self, double from_ticks, double to_ticks, uint32_t start_us)
{
    while (to_ticks >= edge_of(self, self->state + 1)) {
        const double edge = edge_of(self, self->state + 1);
        cross_edge(self, 1, crossing_time(edge, from_ticks, to_ticks, start_us));
    }
    while (to_ticks < edge_of(self, self->state)) {
        const double edge = edge_of(self, self->state);
        cross_edge(self, -1, crossing_time(edge, from_ticks, to_ticks, start_us));
    }
}

static void disturb(sim_encoder_t *self, uint32_t time_us)
{
    int32_t change = -self->displaced;

    self->burst_edges--;
    if (sim_random_below(&self->random, 100U) < SIM_ENCODER_ILLEGAL_PERCENT) {
        self->illegal_edges++;
        return;
    }
    if (change == 0) {
        change = ((sim_random_next(&self->random) & 1U) != 0U) ? 1 : -1;
    }
    self->displaced += change;
    record_edge(self, change, time_us);
}

static void end_burst(sim_encoder_t *self, uint32_t time_us)
{
    if (sim_random_below(&self->random, 100U) >= SIM_ENCODER_DRIFT_PERCENT) {
        record_edge(self, -self->displaced, time_us);
    }
    self->displaced = 0;
}

static void step_noise(sim_encoder_t *self, uint32_t start_us, bool is_scanning)
{
    const uint32_t time_us = start_us + sim_random_below(&self->random, SIM_STEP_US);

    if (self->burst_edges > 0U) {
        disturb(self, time_us);
    } else if (self->displaced != 0) {
        end_burst(self, time_us);
    } else if (is_scanning && (sim_random_below(&self->random, 1000000U / SIM_STEP_US) <
                               SIM_ENCODER_BURSTS_PER_S)) {
        self->burst_edges = 1U + sim_random_below(&self->random, SIM_ENCODER_BURST_EDGES);
    } else {
        /* quiet */
    }
}

void sim_encoder_step(sim_encoder_t *self, double from_ticks, double to_ticks, uint32_t start_us,
                      bool is_scanning)
{
    follow_shaft(self, from_ticks, to_ticks, start_us);
    if (self->fault != SIM_ENCODER_STUCK) {
        step_noise(self, start_us, is_scanning);
    }
}

bool sim_encoder_is_quiet(const sim_encoder_t *self, double ticks)
{
    return (self->burst_edges == 0U) && (self->displaced == 0) &&
           (ticks >= edge_of(self, self->state)) && (ticks < edge_of(self, self->state + 1));
}

void sim_encoder_rest(sim_encoder_t *self, uint32_t steps)
{
    if (self->fault != SIM_ENCODER_STUCK) {
        sim_random_pass(&self->random, steps);
    }
}

int32_t sim_encoder_count(const sim_encoder_t *self)
{
    int32_t reading;

    (void)memcpy(&reading, &self->count, sizeof reading);
    return reading;
}

void sim_encoder_take_edges(sim_encoder_t *self)
{
    self->edges = 0U;
    self->illegal_edges = 0U;
}
