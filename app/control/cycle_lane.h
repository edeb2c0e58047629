/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Which cycles are recorded. A gap lasts while the recorder cannot write, and until half of the
 * lane is free, so that a recorder that is slow leaves few long gaps and not many short ones.
 * Control owns one.
 */
#ifndef BORESIGHT_CYCLE_LANE_H
#define BORESIGHT_CYCLE_LANE_H

#include "exchange/exchange.h"

#include <signal.h>
#include <stdbool.h>
#include <stdint.h>

/** At first all zero. */
typedef struct {
    bool is_gap;        /**< This cycle is not recorded. */
    bool is_failing;    /**< As the recorder cannot write. */
    bool has_waited;    /**< For a recorder that gave no sign of life */
    uint32_t heard;     /**< since this one. */
    uint32_t removed;   /**< Cycles that it had written and that were removed since the start, */
    uint32_t lost;      /**< and these and those that were not recorded. */
    uint32_t beats;     /**< Alive counter of the recorder, as last seen, */
    uint64_t beaten_ns; /**< and when it had changed, */
    uint64_t gap_ns;    /**< and when a cycle was last not recorded; 0: never. */
} cycle_lane_t;

/**
 * In elastic time, before the board's time goes on: waits until the next cycle can be recorded,
 * `*stop` is not 0, the recorder cannot write, or it has given no sign of life for
 * LIMIT_RECORDER_ANSWER_CLOCK_US: it gives one with each record. The board learns that control
 * lives.
 *
 * @satisfies SWR-REC-019
 */
void cycle_lane_wait(cycle_lane_t *self, exchange_t *exchange, const volatile sig_atomic_t *stop);

/**
 * Before each cycle: decides whether it is recorded, and counts what was removed.
 *
 * @return whether a gap ends with it, which a checkpoint is to follow
 *
 * @satisfies SWR-REC-022
 * @satisfies SWR-REC-033
 */
bool cycle_lane_look(cycle_lane_t *self, exchange_t *exchange);

/**
 * In each cycle, after cycle_lane_look().
 *
 * @return whether this cycle or one of the last LIMIT_RECORDER_PROOF_US is not recorded, or the
 * recorder has given no sign of life for LIMIT_RECORDER_SILENT_US, both in the world's time
 *
 * @satisfies SWR-REC-050
 */
bool cycle_lane_lacks_recorder(cycle_lane_t *self, const exchange_t *exchange);

#endif
