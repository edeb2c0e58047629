/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Margins of joints inside their limits. Values that a mechanism limits besides its axes, such as
 * the height of a linkage, count as further joints behind the axes. A margin is the distance to the
 * nearer limit as a fraction of the range between the limits, negative outside.
 */
#ifndef BORESIGHT_MARGIN_H
#define BORESIGHT_MARGIN_H

#include "interface/status.h"
#include "robot/joints.h"
#include "robot/robot.h"

#include <stdint.h>

/** Joints that are no axis come behind all axes that a robot may have: its coupled limits, and two
 * more. */
#define JOINT_LIMIT_FURTHER ROBOT_AXIS_MAX
#define JOINT_LIMIT_COUNT (ROBOT_AXIS_MAX + ROBOT_COUPLED_LIMITS + 2U)

/** A margin of the whole range. */
#define MARGIN_ONE_Q56 INT64_C(0x100000000000000)

/** One range, both ends inclusive. */
typedef struct {
    int64_t minimum;
    int64_t maximum;
    int64_t farthest;       /**< Distance outside from which on all is equally far; below 0. */
    int64_t reciprocal_q56; /**< 1 / (maximum - minimum): a margin costs no division. */
} joint_limit_t;

/** The limits in joint values: nm, or bam counted over more than one turn. */
typedef struct {
    joint_limit_t limit[JOINT_LIMIT_COUNT];
    status_t status[JOINT_LIMIT_COUNT]; /**< Says that it is missed. */
} joint_limits_t;

/** The smallest margin of those looked at, and the limit it belongs to. */
typedef struct {
    int64_t margin_q56;
    uint32_t nearest;   /**< The joint of that limit. */
    uint8_t is_maximum; /**< 1: its upper limit. */
} margin_t;

/** Takes a range for joint `index` (below JOINT_LIMIT_COUNT); `status` says that it is missed.
 * Requires (contract 100) the lower end below the upper. */
void margin_set_limit(joint_limits_t *self, uint32_t index, status_t status, int64_t minimum,
                      int64_t maximum);

/** Takes the limits of the axes of `robot`. */
void margin_set_axes(joint_limits_t *self, const robot_t *robot);

/** The limit of the smallest margin, as if it were missed; at least one margin was taken. */
solution_t margin_limit(const margin_t *self, const joint_limits_t *limits);

/** A margin larger than every other. */
void margin_init(margin_t *self);

/** Takes the margin of `value` of joint `index` (below JOINT_LIMIT_COUNT) into `self` if it is
 * smaller. */
void margin_add(margin_t *self, const joint_limits_t *limits, uint32_t index, int64_t value);

/** The same, but only if `value` is outside its limits. */
void margin_add_missed(margin_t *self, const joint_limits_t *limits, uint32_t index, int64_t value);

#endif
