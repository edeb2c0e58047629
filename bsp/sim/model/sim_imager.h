/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Images of the tip, as a scanner gives them: one in each period, noisy in place and direction,
 * and only after a delay. The same seed and the same course give the same images.
 */
#ifndef BORESIGHT_SIM_IMAGER_H
#define BORESIGHT_SIM_IMAGER_H

#include "sim/model/sim_random.h"
#include "sim/model/sim_space.h"

#include <stdbool.h>
#include <stdint.h>

#define SIM_IMAGE_MOST_MS 60000.0
#define SIM_IMAGE_NOISE_MOST_MM 10.0
#define SIM_IMAGE_NOISE_MOST_DEG 10.0
#define SIM_IMAGER_WAITING 8U /**< Images on their way; while there are so many, none is taken. */

/** All zero: no images are taken. Times are whole ms. */
typedef struct {
    double period_ms; /**< From image to image; 0: none is taken. */
    double delay_ms;  /**< From taking one to having it. */
    double noise_mm;  /**< Standard deviation of each coordinate, */
    double noise_deg; /**< and of each of two turns of the direction, at most 10. */
} sim_imager_config_t;

/** One image, in the frame of the scanner's world. */
typedef struct {
    uint32_t number;   /**< 1 is the first; 0: there is none yet. */
    uint64_t taken_us; /**< Time of the box. */
    sim_vector_t place_mm;
    sim_vector_t direction; /**< Of the length 1. */
} sim_image_t;

/** State; written by this module only. */
typedef struct {
    sim_random_t random;
    uint32_t taken;
    uint32_t waiting;                       /**< Images on their way, */
    sim_image_t on_way[SIM_IMAGER_WAITING]; /**< the oldest first. */
    sim_image_t last;                       /**< The newest that has come. */
} sim_imager_t;

void sim_imager_init(sim_imager_t *self, uint32_t seed);

/** Brings what has come by `now_us`, which meets each whole ms. True: an image is to be taken now.
 */
bool sim_imager_step(sim_imager_t *self, const sim_imager_config_t *config, uint64_t now_us);

/**
 * Takes an image of a tip at this place with this direction.
 *
 * @satisfies SWR-BOX-775
 */
void sim_imager_take(sim_imager_t *self, const sim_imager_config_t *config, uint64_t now_us,
                     sim_vector_t place_mm, sim_vector_t direction);

#endif
