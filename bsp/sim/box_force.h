/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The needle of the simulated box, its hand and its tissue: the hand at the handle of the needle's
 * axis, the tissue in front of the needle, which bends it, and the two load cells that measure both
 * forces.
 */
#ifndef BORESIGHT_BOX_FORCE_H
#define BORESIGHT_BOX_FORCE_H

#include "sim/model/sim_phantom.h"
#include "sim/model/sim_hand.h"

#include <stdint.h>

#define BOX_HAND_AT_REST 1970U   /**< Reading of the hand's cell without force, */
#define BOX_NEEDLE_AT_REST 1780U /**< and of the needle's. */
#define BOX_GRIP_MN 3000         /**< Force of a hand that presses, until another is set. */

/** State of the forces; written by this module, and by orders to the box. */
typedef struct {
    sim_phantom_file_t phantom;
    sim_tissue_t tissue;
    sim_bevel_t bevel;
    sim_hand_t hand;
    int32_t grip_mn; /**< Force with which a hand presses, below 0 outwards. */
    sim_load_cell_t cells[SIM_CELLS];
} box_force_t;

/** No hand, and `phantom` in front of a needle that is `depth_mm` deep and turned by `turn_rad`.
 * The cells take their chance from `random`. */
void box_force_init(box_force_t *self, const sim_phantom_file_t *phantom, double depth_mm,
                    double turn_rad, sim_random_t *random);

/** Puts another phantom there, in which the needle is straight; the cells begin anew. The hand
 * stays. */
void box_force_lay(box_force_t *self, const sim_phantom_file_t *phantom);

/** Makes all tissue whole again, but for the hole in which the needle is. */
void box_force_heal(box_force_t *self);

/**
 * Advances by `step_us`, 1 to SIM_LOAD_CELL_PERIOD_US; the needle is at `depth_mm` then, turned by
 * `turn_rad` at its base.
 *
 * @satisfies SWR-BOX-533
 */
void box_force_step(box_force_t *self, uint32_t step_us, double depth_mm, double turn_rad);

#endif
