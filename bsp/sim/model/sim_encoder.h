/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * A relative quadrature encoder and the card's counter behind it: four states per cycle of unequal
 * width, a time stamp for each edge, and wrong edges while the scanner acquires. Times in box time.
 */
#ifndef BORESIGHT_SIM_ENCODER_H
#define BORESIGHT_SIM_ENCODER_H

#include "robot/robot.h"
#include "sim/model/sim_random.h"

#include <stdbool.h>
#include <stdint.h>

/** Root mean square of the states' width errors, in states. */
#define SIM_ENCODER_WIDTH_ERROR 0.1
#define SIM_ENCODER_BURSTS_PER_S 5U /**< Bursts of wrong edges while the scanner acquires. */
#define SIM_ENCODER_BURST_EDGES 20U /**< Longest burst. */
/** Wrong edges at which both lines change: not counted, but flagged. */
#define SIM_ENCODER_ILLEGAL_PERCENT 10U
/** Bursts that leave one count behind if they end beside the true count. */
#define SIM_ENCODER_DRIFT_PERCENT 5U

typedef enum {
    SIM_ENCODER_NORMAL = 0,
    SIM_ENCODER_STUCK = 1,    /**< Cable cut: no edges. */
    SIM_ENCODER_REVERSED = 2, /**< Lines swapped: counts the other way. */
    SIM_ENCODER_HALF = 3      /**< Every other edge is lost. */
} sim_encoder_fault_t;

/** State of one encoder. */
typedef struct {
    sim_random_t random;
    double edge_offsets[4]; /**< Offset of each state's edge from its nominal place, in states. */
    bool is_inverted;       /**< The position grows when the reading falls. */
    sim_encoder_fault_t fault;
    int32_t state;  /**< Number of the state the disc is in; its low two bits are the two lines. */
    uint32_t count; /**< The reading, wraps. */
    uint32_t stamps_us[5]; /**< Times of the newest five edges, newest first. */
    uint32_t edges;        /**< Since sim_encoder_take_edges(). */
    uint32_t illegal_edges;
    uint32_t burst_edges; /**< Wrong edges still to come in this burst. */
    int32_t displaced;    /**< Counts that the burst has added so far: -1, 0 or 1. */
} sim_encoder_t;

/** An encoder at `position_ticks` that reads `reading`. */
void sim_encoder_init(sim_encoder_t *self, const axis_config_t *axis, double position_ticks,
                      int32_t reading, uint32_t seed);

/**
 * Follows the shaft from `from_ticks` to `to_ticks` in the SIM_STEP_US that began at `start_us`;
 * with `is_scanning` the scanner disturbs the lines.
 *
 * @satisfies SWR-BOX-004
 */
void sim_encoder_step(sim_encoder_t *self, double from_ticks, double to_ticks, uint32_t start_us,
                      bool is_scanning);

/** True if a shaft that stands at `ticks` crosses no edge and no burst is under way: without a
 * scanner each step takes its share of chance alone. */
bool sim_encoder_is_quiet(const sim_encoder_t *self, double ticks);

/** As `steps` of sim_encoder_step() while it is quiet. */
void sim_encoder_rest(sim_encoder_t *self, uint32_t steps);

/** The reading. */
int32_t sim_encoder_count(const sim_encoder_t *self);

/** Forgets the edges counted since the last call. */
void sim_encoder_take_edges(sim_encoder_t *self);

#endif
