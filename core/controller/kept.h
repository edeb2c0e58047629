/* SPDX-License-Identifier: Apache-2.0 */
/** @file Positions kept over a restart of the programs. Fixed layout, no padding. */
#ifndef BORESIGHT_KEPT_H
#define BORESIGHT_KEPT_H

#include "interface/kept_verdict.h"
#include "robot/robot.h"

#include <stdint.h>

/** Trust in the position of an axis. Any other value counts as KEPT_LOST. */
typedef enum {
    KEPT_FRESH = 0, /**< Neither homed nor lost since the power-on. */
    KEPT_LOST = 1,  /**< Its position was not to be believed. */
    KEPT_KNOWN = 2  /**< Its position was believed. */
} kept_grade_t;

typedef struct {
    uint32_t grade;         /**< kept_grade_t. */
    int32_t position_ticks; /**< With KEPT_KNOWN. */
    int32_t
        reading_ticks; /**< Reading of the encoder's counter there; of no meaning with KEPT_LOST. */
} kept_axis_t;

typedef struct {
    uint32_t power_on; /**< The present one. */
    uint32_t verdict;  /**< kept_verdict_t. */
    kept_axis_t axes[ROBOT_AXIS_MAX];
} kept_positions_t;

#endif
