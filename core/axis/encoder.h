/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Position and speed of one axis from its card's encoder counter. Relative: a position means
 * something only after encoder_set_position(). The axis owns one and steps it every cycle.
 */
#ifndef BORESIGHT_ENCODER_H
#define BORESIGHT_ENCODER_H

#include "card/card_frame.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

#define ENCODER_AGE_UNKNOWN UINT32_MAX /**< The card does not report when an edge came. */

typedef struct {
    int32_t reading; /**< Last believed counter value. */
    int32_t position_ticks;
    int32_t speed_ticks_per_s_q8;    /**< The measured one, less while ticks are late. */
    int32_t measured_ticks_per_s_q8; /**< Over at least 6 ms and whole cycles of four edges; 0 at
                                        rest. */
    int32_t anchor_ticks;            /**< Start of the present speed measurement. */
    uint32_t anchor_us;              /**< Card time of that edge. */
    uint32_t edge_age_us;            /**< Time since the newest edge, or ENCODER_AGE_UNKNOWN. */
    int32_t jump_ticks;              /**< The last unbelievable change, for the record. */
    uint32_t jumps;                  /**< Unbelievable readings in a row. */
    uint32_t missed_cycles;          /**< Since the last reading. */
    uint32_t has_reading;            /**< 0 or 1. */
    uint32_t is_at_rest;             /**< No edge since the timeout: 0 or 1. */
} encoder_t;

/** Starts at position 0 without a reading. */
void encoder_init(encoder_t *self);

/**
 * Takes this cycle's report; NULL when no valid one arrived. A change of more than
 * `config->jump_ticks` for each cycle since the last reading is not believed; the second in a row
 * makes the counter's new value the reference.
 *
 * @return true when the position can no longer be trusted
 *
 * @satisfies SWR-ENC-001
 * @satisfies SWR-ENC-002
 * @satisfies SWR-ENC-003
 * @satisfies SWR-ENC-004
 * @satisfies SWR-ENC-005
 * @satisfies SWR-ENC-010
 */
bool encoder_step(encoder_t *self, const axis_config_t *config, const card_report_t *report);

/** The way from one reading of the counter to another, which wraps, in ticks of the position. */
int32_t encoder_way(const axis_config_t *config, int32_t from_reading, int32_t to_reading);

/** No edge for so long that the speed counts as zero. */
bool encoder_is_at_rest(const encoder_t *self);

/** The axis now stands at `position_ticks`. */
void encoder_set_position(encoder_t *self, int32_t position_ticks);

#endif
