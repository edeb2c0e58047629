/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Joint values of any robot, in the order of its axes: nm of a linear axis, bam of a turning one.
 */
#ifndef BORESIGHT_JOINTS_H
#define BORESIGHT_JOINTS_H

#include "base/rigid.h"
#include "interface/status.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** Joint values, nm or bam; 0 beyond the robot's axes. */
typedef struct {
    int32_t value[ROBOT_AXIS_MAX];
} joints_t;

/** Line on which a needle shall enter and end, in the z-frame. */
typedef struct {
    point_t entry;
    point_t target;
    int32_t roll_bam; /**< About its line. */
} needle_line_t;

/** Obstacle to a pose: the limit that is missed, the one missed by most if there are several. */
typedef struct {
    status_t status;     /**< STATUS_OK, or the reason. */
    uint8_t axis;        /**< Index of the axis of STATUS_AXIS_LIMIT; 0 otherwise. */
    uint8_t is_maximum;  /**< 1: the upper end of the limit, 0: the lower. */
    uint8_t is_by_entry; /**< For a solved pose: 1 when an entry point decided what would
                              otherwise have been free, and without it the answer may be another. */
} solution_t;

/** 2^17 - 1. The product of at most as many ticks and a unit_per_tick_q16 below 2^46 fits in 63
 * bits; the coarsest scale of a robot's file, one tick a radian, is below 2^46. */
#define JOINTS_PRODUCT_TICKS INT64_C(131071)

/** The whole ticks of `axis` within `way_nm`, or of a turning axis within `way_bam`. */
static inline int64_t joints_ticks_within(const axis_config_t *axis, uint32_t way_nm,
                                          uint32_t way_bam)
{
    const int64_t way = (int64_t)((axis->unit == (uint8_t)AXIS_UNIT_MM) ? way_nm : way_bam);
    return (way * 65536) / axis->unit_per_tick_q16;
}

/**
 * `ticks` of `axis`, of any sign and size, are more than `way_nm`, or of a turning axis than
 * `way_bam`; never if they are negative. Few ticks cost no division.
 *
 * @satisfies SWR-FIX-004
 */
static inline bool joints_is_beyond(const axis_config_t *axis, int64_t ticks, uint32_t way_nm,
                                    uint32_t way_bam)
{
    const int64_t way = (int64_t)((axis->unit == (uint8_t)AXIS_UNIT_MM) ? way_nm : way_bam);
    if (ticks > JOINTS_PRODUCT_TICKS) {
        return ticks > joints_ticks_within(axis, way_nm, way_bam);
    }
    return (ticks > 0) && ((ticks * axis->unit_per_tick_q16) > (way * 65536));
}

/** `ticks` of `axis` are more than what is taken for noise where it moves no tip: `floor_ticks`, of
 * an axis that turns the needle about its line. */
static inline bool joints_is_above(const axis_config_t *axis, int64_t ticks, uint32_t floor_ticks)
{
    return (axis->needle_motion != (uint32_t)NEEDLE_ABOUT) || (ticks > (int64_t)floor_ticks);
}

/** Joint value (nm, or bam counted over more than one turn) of `ticks` counts of `axis`. */
int64_t joints_value(const axis_config_t *axis, int32_t ticks);

/** The same as a joint value, within 32 bits. An angle of more than half a turn is given as the one
 * that looks the same. */
int32_t joints_of(const axis_config_t *axis, int32_t ticks);

/** Joint values of the positions `ticks`, as joints_of(). */
void joints_from_ticks(const robot_t *robot, const int32_t ticks[ROBOT_AXIS_MAX], joints_t *joints);

/** Positions in ticks nearest to `joints`, half away from zero; beyond the robot's axes nothing is
 * written. */
void joints_to_ticks(const robot_t *robot, const joints_t *joints, int32_t ticks[ROBOT_AXIS_MAX]);

#endif
