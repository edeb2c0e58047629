/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * How far the joints of the NeuroRobot are inside their limits. The separation of the axial
 * carriages and the height of the linkage count as two more joints. A margin is the distance to the
 * nearer limit as a fraction of the range between the limits, negative outside.
 */
#ifndef BORESIGHT_NEURO_LIMITS_H
#define BORESIGHT_NEURO_LIMITS_H

#include "robot.h"
#include "status.h"

#include <stdint.h>

#define NEURO_LIMIT_SEPARATION ROBOT_AXIS_MAX
#define NEURO_LIMIT_HEIGHT (ROBOT_AXIS_MAX + 1U)
#define NEURO_LIMIT_COUNT (ROBOT_AXIS_MAX + 2U)

/** A margin of the whole range. */
#define NEURO_ONE_Q56 INT64_C(0x100000000000000)

/** What stands in the way of a pose: the limit that is missed, the one missed by most if there are
 * several. */
typedef struct {
    status_t status;    /**< STATUS_OK, or the reason. */
    uint8_t axis;       /**< axis_index_t of STATUS_AXIS_LIMIT; 0 otherwise. */
    uint8_t is_maximum; /**< 1: the upper limit (or the largest separation, the highest carriage),
                           0: the lower. */
} neuro_result_t;

/** One range, both ends inclusive. */
typedef struct {
    int64_t minimum;
    int64_t maximum;
    int64_t farthest;       /**< Distance outside from which on all is equally far; below 0. */
    int64_t reciprocal_q56; /**< 1 / (maximum - minimum): a margin costs no division. */
} neuro_limit_t;

/** The limits in joint values: nm, or bam counted over more than one turn. */
typedef struct {
    neuro_limit_t limit[NEURO_LIMIT_COUNT];
} neuro_limits_t;

/** The smallest margin of those looked at, and the limit it belongs to. */
typedef struct {
    int64_t margin_q56;
    neuro_result_t nearest; /**< `status` names the kind of limit, also when it is kept. */
} neuro_margin_t;

/** Joint value (nm, or bam counted over more than one turn) of `ticks` counts of `axis`. */
int64_t neuro_limits_value(const axis_config_t *axis, int32_t ticks);

/** Takes the limits of `robot`. Requires (contract 100) the lower below the upper for each. */
void neuro_limits_init(neuro_limits_t *self, const robot_t *robot);

/** A margin larger than every other. */
void neuro_margin_init(neuro_margin_t *self);

/** Takes the margin of `value` of joint `index` (below NEURO_LIMIT_COUNT) into `self` if it is
 * smaller. */
void neuro_margin_add(neuro_margin_t *self, const neuro_limits_t *limits, uint32_t index,
                      int64_t value);

/** The same, but only if `value` is outside its limits. */
void neuro_margin_add_missed(neuro_margin_t *self, const neuro_limits_t *limits, uint32_t index,
                             int64_t value);

#endif
