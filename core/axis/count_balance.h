/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Counts against drive words, added up. The shortfall of an axis' counts against its motor's way,
 * or their excess, is kept until its next reference or fault, so that no pause and no slowness
 * hides it. The supervision of an axis owns one.
 */
#ifndef BORESIGHT_COUNT_BALANCE_H
#define BORESIGHT_COUNT_BALANCE_H

#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** Regime of the motor: gaining speed, for a model knows less of that, or steady. */
typedef enum { COUNT_REGIME_RISING = 0, COUNT_REGIME_STEADY = 1, COUNT_REGIMES = 2 } count_regime_t;

/** Speed that the motor has shown in a regime. */
typedef struct {
    int64_t model_q16;     /**< Way of the model, until it has been compared. */
    int32_t counted_ticks; /**< In the direction of the drive. */
    uint32_t time_us;
    uint32_t least_percent; /**< Least share of the model's way to be counted. */
    uint32_t most_percent;  /**< Largest share that may be counted. */
} count_calibration_t;

typedef struct {
    int64_t model_q16;     /**< Way of the model in this window, without sign. */
    uint32_t window_us;    /**< Driven time of the window. */
    int32_t counted_ticks; /**< In the direction of the drive. */
    int64_t least_e2_q16;  /**< The least of it that must be counted, times 100. */
    int64_t most_e2_q16;   /**< The most, times 100. */
    int64_t short_e2_q16;  /**< Sum of missing counts, times 100. */
    int64_t over_e2_q16;   /**< Sum of surplus counts, times 100. */
    int32_t direction;     /**< 1, or -1, of the last drive; 0: none yet. */
    uint32_t run_us;       /**< Driven this way for so long without a pause, saturates. */
    uint32_t rest_us;      /**< Not driven for so long, saturates. */
    uint16_t regime;       /**< count_regime_t of the last drive. */
    uint16_t has_count;    /**< 0 or 1: a way has ended since it runs steadily. */
    uint32_t unsure_us;    /**< Driven time until the model knows its speed again. */
    int32_t percent;       /**< Counts of the last window against the model, for the record. */
    count_calibration_t calibrations[COUNT_REGIMES];
} count_balance_t;

/** Motion of the axis in a cycle. */
typedef struct {
    int64_t model_q16; /**< Way that the model made with the applied drive, in ticks. */
    int64_t counted_ticks;
    uint32_t due_q16; /**< Way of the model from the count before these to the newest of them,
                         without sign; 0: none came, or that is unknown. */
    uint32_t elapsed_us;
} count_cycle_t;

/** Nothing is known of the motor. */
void count_balance_init(count_balance_t *self);

/** The position is sure: both sums are empty. The speeds that the motor has shown stay. */
void count_balance_settle(count_balance_t *self);

/** The speed of the motor is unknown: nothing is compared for LIMIT_RISING_TIME_US of drive, or
 * until it is off. */
void count_balance_doubt(count_balance_t *self);

/**
 * One cycle.
 *
 * @return true when a sum is beyond LIMIT_REST_WAY_NM or LIMIT_REST_WAY_BAM and LIMIT_ACCOUNT_TICKS
 *
 * @satisfies SWR-AXIS-019
 * @satisfies SWR-AXIS-024
 */
bool count_balance_step(count_balance_t *self, const axis_config_t *config,
                        const count_cycle_t *cycle);

#endif
