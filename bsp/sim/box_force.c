/* SPDX-License-Identifier: Apache-2.0 */
#include "sim/box_force.h"

/* In the order of sim_cell_t. */
static const double at_rest[SIM_CELLS] = {BOX_HAND_AT_REST, BOX_NEEDLE_AT_REST};

static void init_cells(box_force_t *self, const uint32_t seeds[SIM_CELLS])
{
    for (uint32_t i = 0U; i < SIM_CELLS; i++) {
        sim_load_cell_init(&self->cells[i], &self->phantom.cells[i], at_rest[i], seeds[i]);
    }
}

void box_force_init(box_force_t *self, const sim_phantom_file_t *phantom, double depth_mm,
                    double turn_rad, sim_random_t *random)
{
    uint32_t seeds[SIM_CELLS];

    for (uint32_t i = 0U; i < SIM_CELLS; i++) {
        seeds[i] = sim_random_next(random);
    }
    self->phantom = *phantom;
    self->grip_mn = BOX_GRIP_MN;
    sim_hand_init(&self->hand);
    sim_tissue_init(&self->tissue, &self->phantom.tissue, depth_mm);
    sim_bevel_init(&self->bevel, &self->phantom.tissue, depth_mm, turn_rad);
    init_cells(self, seeds);
}

void box_force_lay(box_force_t *self, const sim_phantom_file_t *phantom)
{
    uint32_t seeds[SIM_CELLS];

    for (uint32_t i = 0U; i < SIM_CELLS; i++) {
        seeds[i] = sim_random_next(&self->cells[i].random);
    }
    self->phantom = *phantom;
    sim_tissue_init(&self->tissue, &self->phantom.tissue, self->tissue.depth_mm);
    sim_bevel_init(&self->bevel, &self->phantom.tissue, self->tissue.depth_mm,
                   self->bevel.tip_rad + self->bevel.lag_rad);
    init_cells(self, seeds);
}

void box_force_heal(box_force_t *self)
{
    sim_tissue_init(&self->tissue, &self->phantom.tissue, self->tissue.depth_mm);
    sim_bevel_heal(&self->bevel, &self->phantom.tissue);
}

void box_force_step(box_force_t *self, uint32_t step_us, double depth_mm, double turn_rad)
{
    const double step_s = (double)step_us / 1e6;
    const double speed_mm_per_s = (depth_mm - self->tissue.depth_mm) / step_s;

    sim_hand_step(&self->hand, step_s, depth_mm);
    sim_tissue_step(&self->tissue, &self->phantom.tissue, step_s, depth_mm, speed_mm_per_s);
    sim_bevel_step(&self->bevel, &self->phantom.needle, &self->phantom.tissue, depth_mm, turn_rad);
    sim_load_cell_step(&self->cells[SIM_CELL_HAND], step_us, self->hand.force_n);
    sim_load_cell_step(&self->cells[SIM_CELL_NEEDLE], step_us, self->tissue.force_n);
}
