/* SPDX-License-Identifier: Apache-2.0 */
#include "sim/model/sim_hand.h"

#include <stdbool.h>

static double bounded(double force_n)
{
    const double most = (force_n > SIM_HAND_MOST_N) ? SIM_HAND_MOST_N : force_n;

    return (most < -SIM_HAND_MOST_N) ? -SIM_HAND_MOST_N : most;
}

void sim_hand_init(sim_hand_t *self)
{
    *self = (sim_hand_t){.act = SIM_HAND_OFF, .stiffness_n_per_mm = SIM_HAND_STIFFNESS_N_PER_MM};
}

void sim_hand_release(sim_hand_t *self)
{
    self->act = SIM_HAND_OFF;
}

void sim_hand_press(sim_hand_t *self, double force_n)
{
    self->act = SIM_HAND_PRESS;
    self->press_n = bounded(force_n);
}

void sim_hand_wish(sim_hand_t *self, double handle_mm, double by_mm, double mm_per_s)
{
    const bool is_new = (self->act != SIM_HAND_SPRING) || (by_mm * by_mm > 0.0);

    self->wish_mm = is_new ? (handle_mm + by_mm) : self->wish_mm;
    self->wish_mm_per_s = mm_per_s;
    self->act = SIM_HAND_SPRING;
}

void sim_hand_step(sim_hand_t *self, double step_s, double handle_mm)
{
    self->wish_mm += self->wish_mm_per_s * step_s;
    switch (self->act) {
    case SIM_HAND_PRESS:
        self->force_n = self->press_n;
        break;
    case SIM_HAND_SPRING:
        self->force_n = bounded(self->stiffness_n_per_mm * (self->wish_mm - handle_mm));
        break;
    case SIM_HAND_OFF:
    default:
        self->force_n = 0.0;
        break;
    }
}
