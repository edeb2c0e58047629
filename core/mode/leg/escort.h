/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Homing of one axis of a linkage: the others, of which the counts say where they are, travel with
 * it as far as the limits that they share need it. The place of the axis is unknown; so a limit
 * must hold wherever it may be between its end and its switch, or its value must stay what it is.
 * Its counts are believed for the way that it goes, and for nothing else.
 *
 * Each of the others rests, goes the same way, or twice of it. The escort tried first is that all
 * rest; one that holds is kept until the way ahead shows that it does not hold any more. While
 * another one is looked for, one in each cycle, all axes rest. Assumed is that the limits held
 * where homing began.
 */
#ifndef BORESIGHT_ESCORT_H
#define BORESIGHT_ESCORT_H

#include "axis/axis.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

typedef enum {
    ESCORT_GOES = 0,  /**< The axis may go on, with its escort. */
    ESCORT_RESTS = 1, /**< All rest in this cycle. */
    ESCORT_NONE = 2   /**< There is none with which the limits hold. */
} escort_verdict_t;

/** Search for an escort: first one that holds for the longer way ahead, and that no axis has to
 * wait for. */
typedef enum {
    ESCORT_SEARCH_DONE = 0,
    ESCORT_SEARCH_EVEN = 1,
    ESCORT_SEARCH_FAR = 2,
    ESCORT_SEARCH_NEAR = 3,
    ESCORT_SEARCH_IN_VAIN = 4
} escort_search_t;

/** At first all zero. */
typedef struct {
    uint32_t leader;      /**< 1 + index of the axis that homes with an escort; 0: none does. */
    uint32_t paces;       /**< Two bits of each axis: its ticks for each of the leader's, 0 to 2. */
    uint32_t search;      /**< escort_search_t. */
    uint32_t wait_cycles; /**< Until the way ahead is looked at again. */
} escort_t;

/** @return true when axis `index` is of a block, homes by its switch and is not homed, and the
 * counts of all that share a limit with it say where these are */
bool escort_is_for(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX], uint32_t index);

/** Axis `index` has begun to home. From its switch all leave together. */
void escort_begin(escort_t *self, const robot_t *robot, axis_t axes[ROBOT_AXIS_MAX],
                  uint32_t index);

/** No axis homes with an escort. */
void escort_end(escort_t *self);

/** @return how many ticks axis `index` goes for each of the leader's: 0, 1 or 2 */
uint32_t escort_pace(const escort_t *self, uint32_t index);

/** @return true when no escort was found for axis `index`, which homed last */
bool escort_was_missing(const escort_t *self, uint32_t index);

/** @return true when one goes twice the way: then the leader goes half as fast */
bool escort_is_slow(const escort_t *self);

/**
 * To be called once in each cycle in which the leader would be driven.
 *
 * @satisfies SWR-AXIS-051
 */
escort_verdict_t escort_step(escort_t *self, const robot_t *robot, axis_t axes[ROBOT_AXIS_MAX]);

/** @return the way from where the leader's counts have it to the middle of where it can be, as the
 * limits of two axes say, ticks */
int32_t escort_way_by_hand_ticks(const escort_t *self, const robot_t *robot,
                                 const axis_t axes[ROBOT_AXIS_MAX]);

#endif
