/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A target in tissue that moves as the needle goes in: the needle takes it along by a share of its
 * way, as far as the tissue gives, and between two lengths of the needle in the tissue it gives way
 * to the side. Once the needle is drawn back, the target is where it was. Stateless.
 *
 * The law is a design of this project; shifts of 1 to 10 mm are those of Wartenberg et al. 2018
 * (PMC6319385).
 */
#ifndef BORESIGHT_SIM_TARGET_H
#define BORESIGHT_SIM_TARGET_H

#include "sim/model/sim_space.h"

#include <stdbool.h>

/** Places are those of sim_bevel.h. */
typedef struct {
    double x_mm;          /**< At rest. */
    double y_mm;          /**< At rest. */
    double depth_mm;      /**< At rest, as a depth of the needle; 0: there is no target. */
    double push_share;    /**< Of the length of the needle in the tissue, */
    double push_most_mm;  /**< and at most this far it is pushed along the line. */
    double shift_x_mm;    /**< All of its shift to the side, */
    double shift_y_mm;    /**< across the other way, */
    double shift_from_mm; /**< which begins at this length of the needle in the tissue */
    double shift_to_mm;   /**< and is whole at that; between them it grows evenly. */
} sim_target_t;

static inline bool sim_target_is_there(const sim_target_t *self)
{
    return self->depth_mm > 0.0;
}

/**
 * Its place while the needle is `in_mm` long in the tissue.
 *
 * @satisfies SWR-BOX-774
 */
sim_vector_t sim_target_place(const sim_target_t *self, double in_mm);

#endif
