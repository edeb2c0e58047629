/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * What an axis counts while its motor is off: it should stand, so each count is one of doubt. The
 * axis owns one.
 */
#ifndef BORESIGHT_DRIFT_AUDIT_H
#define BORESIGHT_DRIFT_AUDIT_H

#include "base/fixed.h"
#include "motion/motor_model.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** At first all zero. */
typedef struct {
    int32_t position_ticks; /**< Of the cycle before. */
    uint32_t off_us;        /**< Off for so long, saturates. */
    int32_t idle_ticks;     /**< Net counts while off since the last reference. */
    int32_t scan_ticks;     /**< Net counts while off since the scanner began to acquire. */
} drift_audit_t;

/** One cycle: the axis is at `position_ticks`; its drive was off up to there or not. */
static inline void drift_audit_step(drift_audit_t *self, int32_t position_ticks, bool is_off,
                                    uint32_t elapsed_us)
{
    const int64_t way = (int64_t)position_ticks - (int64_t)self->position_ticks;
    self->position_ticks = position_ticks;
    if (!is_off) {
        self->off_us = 0U;
    } else if (self->off_us < MOTOR_REST_US) {
        self->off_us += elapsed_us;
    } else if (way != 0) {
        self->idle_ticks = fixed_saturate((int64_t)self->idle_ticks + way);
        self->scan_ticks = fixed_saturate((int64_t)self->scan_ticks + way);
    } else {
        /* It stands. */
    }
}

/** The axis stands at `position_ticks`, that is sure: a new account begins. */
void drift_audit_settle(drift_audit_t *self, int32_t position_ticks);

/** A scan begins. */
void drift_audit_begin_scan(drift_audit_t *self);

/**
 * The account is beyond LIMIT_DRIFT_WAY_NM or LIMIT_DRIFT_WAY_BAM, and of an axis that turns the
 * needle about its line beyond LIMIT_DRIFT_FLOOR_TICKS.
 *
 * @satisfies SWR-AXIS-022
 */
bool drift_audit_is_beyond(const drift_audit_t *self, const axis_config_t *config);

/**
 * The account is beyond `config->drift_ticks`.
 *
 * @satisfies SWR-AXIS-045
 */
bool drift_audit_is_far(const drift_audit_t *self, const axis_config_t *config);

#endif
