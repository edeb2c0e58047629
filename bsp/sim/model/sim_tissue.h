/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Tissue along the line of a needle, and the force of it on the needle: layers, the membrane in
 * front of each, and the friction on the shaft. The needle is moved from outside (a motor that
 * holds by friction); depth and speed are those of its tip along its own line.
 *
 * The force is the sum of three parts (Okamura, Simone, O'Leary 2004, IEEE TBME 51(10) 1707), each
 * 0 outside of the tissue:
 *
 * 1. The membrane in front of the tip, indented by d: F = a1 d + a2 d^2 + q, where q is the branch
 * that relaxes (Mahvash, Dupont 2010, IEEE TBME 57(4) 934): dq/dt = r / (1 - r) d(a1 d + a2 d^2)/dt
 * - q / tau. It ruptures while the needle advances, as soon as F reaches rupture (fast + (1 - fast)
 * half / (half + |v|)): a faster needle deforms it less. The part is 0 from there on, and the
 * tissue springs back, so that the tip is by d farther in it. A membrane that was ruptured stays
 * so.
 * 2. Cutting: up to the constant of the layer, where the tip meets tissue that was not cut yet.
 * 3. Friction (modified Karnopp): for each mm of shaft in a layer at most C + b |v| against the
 * motion, and while |v| is below `stick_mm_per_s` at most D.
 *
 * Cutting and friction build up over `presliding_mm` of travel. The share r of them relaxes with
 * the time constant tau, so a needle that stops shows a force that falls without any travel.
 *
 * There is no chance in it, no mathematics library and no state but that of the caller: the same
 * steps give the same bits everywhere.
 */
#ifndef BORESIGHT_SIM_TISSUE_H
#define BORESIGHT_SIM_TISSUE_H

#include <stdbool.h>
#include <stdint.h>

#define SIM_LAYERS 8U /**< The most layers of a phantom. */

/** A layer, and the membrane at its front. Ranges: docs/phantom.md. */
typedef struct {
    double thickness_mm;
    double
        rupture_n; /**< Force at which the membrane of a slow needle ruptures; 0: none is there. */
    double rupture_fast_share;          /**< 0..1: what is left of it for a fast one. */
    double rupture_half_speed_mm_per_s; /**< Speed at which half of the loss has come; above 0. */
    double stiffness_n_per_mm;          /**< a1 of the membrane. */
    double stiffening_n_per_mm2;        /**< a2 of the membrane. */
    double cutting_n;                   /**< Force that cuts the layer. */
    double friction_in_n_per_mm;        /**< C while the needle goes in, for each mm of shaft. */
    double friction_out_n_per_mm;       /**< The same while it goes out. */
    double viscous_in_n_s_per_mm2;      /**< b while it goes in. */
    double viscous_out_n_s_per_mm2;     /**< The same while it goes out. */
    double stick_in_n_per_mm;           /**< D against going in, C or more. */
    double stick_out_n_per_mm;          /**< The same against going out. */
    double relaxing_share;              /**< r, 0..0.9. */
    double relaxing_s;                  /**< tau, above 0. */
} sim_layer_t;

/** A phantom: layers from the surface inwards; beyond the last one there is nothing. */
typedef struct {
    double surface_mm;     /**< Depth of the needle at which its tip touches the first layer. */
    double presliding_mm;  /**< Travel over which friction and cutting build up; above 0. */
    double stick_mm_per_s; /**< Below this speed friction sticks. */
    uint32_t layer_count;  /**< 0..SIM_LAYERS; 0: no tissue. */
    sim_layer_t layers[SIM_LAYERS];
} sim_phantom_t;

/** A force that builds up with travel; in two parts, of which one relaxes. */
typedef struct {
    double held_n;
    double relaxing_n;
} sim_bristle_t;

/** State of one needle in one phantom; written by this module only. All forces are positive against
 * the insertion. */
typedef struct {
    double depth_mm;  /**< Depth of the last step. */
    double front_mm;  /**< Up to here the tissue was cut. */
    double elastic_n; /**< a1 d + a2 d^2 of the last step. */
    double branch_n;  /**< q. */
    sim_bristle_t cutting;
    sim_bristle_t friction;
    double indentation_mm; /**< Of the membrane in front of the tip; 0: none is touched. */
    double membrane_n;     /**< The three parts of the force, */
    double cutting_n;
    double friction_n;
    double force_n;  /**< and their sum: the force on the needle. */
    uint32_t next;   /**< Number of the layer whose membrane is the next one; layer_count: none. */
    uint32_t popped; /**< Membranes that were ruptured. */
    double popped_at_mm[SIM_LAYERS]; /**< Depth at which each of them was, in their order. */
    double recoil_mm; /**< By so much was the tip farther in the tissue after the last of them. */
} sim_tissue_t;

/** Whole tissue, and the needle at `depth_mm`, which is taken to be outside or in a hole that is
 * there. */
void sim_tissue_init(sim_tissue_t *self, const sim_phantom_t *phantom, double depth_mm);

/**
 * Advances by `step_s`, 0 or more, at most 0.01: the needle is at `depth_mm` then, with
 * `speed_mm_per_s`, positive inwards. `phantom` is that of sim_tissue_init().
 *
 * @satisfies SWR-BOX-520
 * @satisfies SWR-BOX-521
 * @satisfies SWR-BOX-522
 * @satisfies SWR-BOX-523
 * @satisfies SWR-BOX-524
 */
void sim_tissue_step(sim_tissue_t *self, const sim_phantom_t *phantom, double step_s,
                     double depth_mm, double speed_mm_per_s);

/** Depth at which the tip touches the front of this layer, 0..layer_count; that of layer_count is
 * where the tissue ends. */
double sim_tissue_front_mm(const sim_phantom_t *phantom, uint32_t layer);

/** Force at which the membrane of `layer` ruptures at this speed, 0 or more. */
double sim_tissue_rupture_n(const sim_layer_t *layer, double speed_mm_per_s);

#endif
