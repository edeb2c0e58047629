/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/scenario/lateness.h"

#include <stdbool.h>
#include <stdio.h>

#define LEAST_LATE_US 500U /* 1.5 ms from one to the next. */
#define CYCLE_US 1000U
#define BRIEFEST_US 30U /* From one exchange to the next, as seen in real time. */

static bool happens(lateness_t *self, uint32_t parts)
{
    return (parts != 0U) && (sim_random_below(&self->random, parts) == 0U);
}

/* One of `count` words. */
static uint32_t pick(lateness_t *self, const uint32_t *words, uint32_t count)
{
    return words[sim_random_below(&self->random, count)];
}

/* The card of an axis refuses one command of fifty. */
static void make_noise(lateness_t *self, rig_t *rig)
{
    char order[64];
    const uint32_t axis = sim_random_below(&self->random, rig->box.robot->axis_count);
    (void)snprintf(order, sizeof order, "card %s noisy", rig->box.robot->axes[axis].name);
    rig_box(rig, order);
}

void lateness_begin(lateness_t *self, rig_t *rig, uint32_t seed)
{
    static const uint32_t late_parts[] = {0U, 0U, 2000U, 400U, 150U};
    static const uint32_t late_us[] = {600U, 3000U, 9000U, 19000U};
    static const uint32_t late_bursts[] = {1U, 1U, 3U, 6U};
    static const uint32_t jitters_us[] = {0U, 50U, 100U, 200U, 400U};
    static const uint32_t hold_parts[] = {0U, 0U, 3000U, 500U, 200U};
    static const uint32_t hold_cycles[] = {1U, 2U, 4U, 8U};
    static const uint32_t refuse_parts[] = {0U, 0U, 200U, 50U};
    *self = (lateness_t){.random = {.state = seed}};
    self->late_parts = pick(self, late_parts, 5U);
    self->late_us = pick(self, late_us, 4U);
    self->late_burst = pick(self, late_bursts, 4U);
    rig->jitter_us = pick(self, jitters_us, 5U);
    rig->random.state = seed;
    self->hold_parts = pick(self, hold_parts, 5U);
    self->hold_cycles = pick(self, hold_cycles, 4U);
    self->refuse_parts = pick(self, refuse_parts, 4U);
    if (happens(self, 2U)) {
        make_noise(self, rig);
    }
}

/* A loop that was late makes good for it: the next cycle ends when it was meant to. */
static uint32_t catch_up_us(lateness_t *self, const rig_t *rig)
{
    const uint32_t late_us = rig->late_us % CYCLE_US;
    const uint32_t most_us = CYCLE_US - BRIEFEST_US - rig->jitter_us;
    if (!happens(self, 2U)) {
        return 0U;
    }
    return (late_us < most_us) ? late_us : most_us;
}

static void come_late(lateness_t *self, rig_t *rig)
{
    if ((self->late_left == 0U) && happens(self, self->late_parts)) {
        self->late_left = 1U + sim_random_below(&self->random, self->late_burst);
    }
    rig->early_us = (self->late_left == 0U) ? catch_up_us(self, rig) : 0U;
    rig->late_us = 0U;
    if (self->late_left > 0U) {
        self->late_left--;
        rig->late_us = LEAST_LATE_US + sim_random_below(&self->random, self->late_us);
    }
}

void lateness_play(lateness_t *self, rig_t *rig)
{
    come_late(self, rig);
    if ((rig->held_cycles == 0U) && happens(self, self->hold_parts)) {
        rig->held_cycles = 1U + sim_random_below(&self->random, self->hold_cycles);
    }
    rig->frames_failed = 0U;
    if (happens(self, self->refuse_parts)) {
        const uint32_t axis = sim_random_below(&self->random, rig->box.robot->axis_count);
        rig->frames_failed = (uint32_t)1U << rig->box.robot->axes[axis].slot;
    }
}
