/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The speed cap of one axis: how far it may still move. Each cycle adds the way that the cap allows
 * in its time and takes away what the axis has moved; while nothing is left, nothing drives it. The
 * controller owns one per axis and steps it every cycle.
 */
#ifndef BORESIGHT_SPEED_CAP_H
#define BORESIGHT_SPEED_CAP_H

#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** At first all zero. */
typedef struct {
    int64_t left; /**< In ticks, times 100 percent, times 1000000 us. */
    int32_t position_ticks;
    uint32_t reserved;
} speed_cap_t;

/**
 * One cycle, `elapsed_us` after the one before, with the axis at `position_ticks`. Way that is not
 * used is kept for LIMIT_SPEED_CAP_US.
 *
 * @return the axis has moved further than `percent` of its speed and the tolerance allow
 *
 * @satisfies SWR-PERMIT-005
 */
bool speed_cap_step(speed_cap_t *self, const axis_config_t *config, uint32_t percent,
                    int32_t position_ticks, uint32_t elapsed_us);

#endif
