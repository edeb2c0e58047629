/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A load cell with its amplifier and a converter of 12 bits that reads once a millisecond.
 *
 *     reading = zero + counts_per_n (force + offset + drift + noise), rounded, 0..4095
 *
 * The source that publishes slope and zeros of the platform's two cells gives no unit (F = 0.902478
 * adc - 1600.328, and the same with the other sign); SIM_LOAD_CELL_COUNTS_PER_N takes it for
 * gram-force, a choice of this project. As milliNewton the range would end at 2.1 N, below the
 * rupture of many membranes. Both readings grow with a push: of the hand inwards, of the tissue
 * outwards; that is why the signs differ if forces are counted inwards.
 */
#ifndef BORESIGHT_SIM_LOAD_CELL_H
#define BORESIGHT_SIM_LOAD_CELL_H

#include "sim/model/sim_random.h"

#include <stdint.h>

#define SIM_LOAD_CELL_MOST 4095U       /**< Greatest reading. */
#define SIM_LOAD_CELL_PERIOD_US 1000U  /**< From reading to reading. */
#define SIM_LOAD_CELL_LATENCY_MOST 16U /**< Longest latency, in readings. */
#define SIM_LOAD_CELL_COUNTS_PER_N (1000.0 / (0.902478 * 9.80665))
#define SIM_LOAD_CELL_STEP_N 6.0        /**< Shift of the fault "step". */
#define SIM_LOAD_CELL_DRIFT_N_PER_S 0.1 /**< Of the fault "drift". */
#define SIM_LOAD_CELL_NOISE_N 0.5       /**< Of the fault "noisy". */

typedef enum {
    SIM_LOAD_CELL_NORMAL = 0,
    SIM_LOAD_CELL_STUCK = 1,  /**< The reading does not change any more. */
    SIM_LOAD_CELL_BROKEN = 2, /**< A wire is broken: 0. */
    SIM_LOAD_CELL_FULL = 3,   /**< The other wire: the greatest reading. */
    SIM_LOAD_CELL_STEP = 4,   /**< Its zero has jumped. */
    SIM_LOAD_CELL_DRIFT = 5,  /**< Its zero wanders. */
    SIM_LOAD_CELL_NOISY = 6   /**< Its noise is large. */
} sim_load_cell_fault_t;

/** Properties of a cell in a phantom's file. */
typedef struct {
    double noise_n;       /**< Standard deviation of each reading, 0 or more. */
    double drift_n_per_s; /**< The zero wanders. */
    double offset_n;      /**< Force that it shows at rest, beside its zero. */
    double latency_ms;    /**< 0 to SIM_LOAD_CELL_LATENCY_MOST, in whole readings. */
} sim_load_cell_config_t;

/** State of one cell; the fault may be set from outside. */
typedef struct {
    sim_load_cell_config_t config;
    double zero_counts;
    sim_random_t random;
    sim_load_cell_fault_t fault;
    double wandered_n;                              /**< Drift so far. */
    double past_n[SIM_LOAD_CELL_LATENCY_MOST + 1U]; /**< Forces of the last readings. */
    uint32_t past_at;
    uint32_t since_us; /**< Since the last reading. */
    uint32_t reading;
} sim_load_cell_t;

/** A cell without force, and its first reading, which is without noise. */
void sim_load_cell_init(sim_load_cell_t *self, const sim_load_cell_config_t *config,
                        double zero_counts, uint32_t seed);

/** Sets the reading, at which the cell is stuck then. */
void sim_load_cell_set(sim_load_cell_t *self, uint32_t reading);

/**
 * Advances by `step_us`, at most SIM_LOAD_CELL_PERIOD_US, with this force on it.
 *
 * @satisfies SWR-BOX-526
 * @satisfies SWR-BOX-527
 */
void sim_load_cell_step(sim_load_cell_t *self, uint32_t step_us, double force_n);

#endif
