/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A needle with a bevel in tissue. Its tip goes as a unicycle (Webster et al. 2006, IJRR 25(5)):
 *
 *     g' = g exp((V1 u1 + V2 u2) dt),  V1 = (e3; kappa e1),  V2 = (0; e3)
 *
 * It cuts along z of its own and is bent towards -y of its bevel, with the curvature kappa; the
 * shaft follows it. u1 is the insertion at the base. u2 is the turn of the tip, which the friction
 * of the tissue on the shaft keeps behind the base (Reed, Okamura, Cowan 2009, IEEE TBME 56(12)):
 * the tip stands until the base is ahead of it by the torsion of the length in the tissue, and
 * follows by so much behind; at a reversal the base turns by twice that before the tip does.
 *
 * A needle that is drawn back goes along its own way, and again along it as far as it was cut; out
 * of the tissue the way is forgotten. Before the tissue and beyond it the tip goes straight on.
 *
 * Places are mm on the line of a needle that is not bent: x and y are those of the tip at the
 * rotation 0, z is the depth. There is no chance in it and no mathematics library: the same steps
 * give the same bits everywhere.
 */
#ifndef BORESIGHT_SIM_BEVEL_H
#define BORESIGHT_SIM_BEVEL_H

#include "sim/model/sim_space.h"
#include "sim/model/sim_tissue.h"

#include <stdbool.h>
#include <stdint.h>

#define SIM_CURVATURE_MOST_PER_MM 0.02
#define SIM_TORSION_MOST_DEG 90.0 /**< Per 100 mm. */
#define SIM_BEVEL_NODES                                                                            \
    256U /**< Places of its way that are kept; beyond the last it is straight. */
#define SIM_BEVEL_NODE_MM 1.0 /**< From one to the next. */

/** Properties of the needle in its tissue; all zero: it is never bent. */
typedef struct {
    double curvature_per_mm;       /**< kappa of a needle that does not turn. */
    double torsion_deg_per_100_mm; /**< The tip is behind the base by so much. */
} sim_bevel_config_t;

/** Place and direction of the tip, and an x of a frame that does not turn about z on its way. */
typedef struct {
    sim_vector_t place_mm;
    sim_vector_t x;
    sim_vector_t z;
} sim_tip_t;

/** State of one needle; written by this module only. */
typedef struct {
    double depth_mm; /**< Of the last step. */
    double tip_rad;  /**< Angle of the bevel about the way. */
    double lag_rad;  /**< By so much the base is ahead of it; below 0 the other way. */
    double cut_mm;   /**< Length of the way, from the surface. */
    sim_tip_t end;   /**< Its end. */
    uint32_t nodes;
    sim_tip_t way[SIM_BEVEL_NODES]; /**< Each SIM_BEVEL_NODE_MM of it; the first at the surface. */
} sim_bevel_t;

/** A needle that is `depth_mm` deep already is straight and without torsion. */
void sim_bevel_init(sim_bevel_t *self, const sim_phantom_t *phantom, double depth_mm,
                    double base_rad);

/**
 * The base is at `depth_mm` and `base_rad` now.
 *
 * @satisfies SWR-BOX-770
 * @satisfies SWR-BOX-771
 * @satisfies SWR-BOX-772
 * @satisfies SWR-BOX-773
 */
void sim_bevel_step(sim_bevel_t *self, const sim_bevel_config_t *config,
                    const sim_phantom_t *phantom, double depth_mm, double base_rad);

/** The way beyond the tip is whole again. */
void sim_bevel_heal(sim_bevel_t *self, const sim_phantom_t *phantom);

/** The tip, or the place and direction of the shaft where it is `depth_mm` deep, at most as deep as
 * the tip. */
sim_tip_t sim_bevel_at(const sim_bevel_t *self, const sim_phantom_t *phantom, double depth_mm);

/** Direction, across the tip of sim_bevel_at(), to which it is bent. */
sim_vector_t sim_bevel_towards(const sim_bevel_t *self, const sim_tip_t *tip);

#endif
