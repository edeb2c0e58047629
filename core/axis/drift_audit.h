/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Counts of an axis while its motor is off: it should stand, so each count is one of doubt. The
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
    uint32_t off_us;         /**< Off for so long, saturates. */
    int32_t idle_ticks;      /**< Net counts while off since the last reference. */
    int32_t confirmed_ticks; /**< The part of them that the operator has confirmed. */
    int32_t scan_ticks;      /**< Net counts while off since the scanner began to acquire. */
} drift_audit_t;

/** One cycle, in which the axis has counted `way` ticks; its drive was off meanwhile or not. */
static inline void drift_audit_step(drift_audit_t *self, int64_t way, bool is_off,
                                    uint32_t elapsed_us)
{
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

/** The position of the axis is sure: a new account begins. */
void drift_audit_settle(drift_audit_t *self);

/**
 * The operator has confirmed where the axis stands. An account that is not far,
 * drift_audit_is_far(), stays until the next reference.
 *
 * @satisfies SWR-AXIS-054
 */
void drift_audit_confirm(drift_audit_t *self, const axis_config_t *config);

/** A scan begins. */
void drift_audit_begin_scan(drift_audit_t *self);

/**
 * The unconfirmed counts are beyond LIMIT_DRIFT_WAY_NM or LIMIT_DRIFT_WAY_BAM, and on an axis that
 * turns the needle about its line also beyond LIMIT_DRIFT_FLOOR_TICKS.
 *
 * @satisfies SWR-AXIS-022
 */
bool drift_audit_is_beyond(const drift_audit_t *self, const axis_config_t *config);

/**
 * All of the account is beyond `config->drift_ticks`.
 *
 * @satisfies SWR-AXIS-045
 */
bool drift_audit_is_far(const drift_audit_t *self, const axis_config_t *config);

#endif
