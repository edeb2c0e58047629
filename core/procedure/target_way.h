/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * The way of the axes from where they stand to the target, looked at before a move is asked for. It
 * is shown only: a move is judged anew when it is commanded.
 */
#ifndef BORESIGHT_TARGET_WAY_H
#define BORESIGHT_TARGET_WAY_H

#include "robot/robot.h"

#include <stdint.h>

/** Pose to go to first: of ways that leave a limit none was found that does so from there, too. */
#define TARGET_WAY_POSE POSE_DRAPING

typedef enum {
    TARGET_WAY_DIRECT = 0,
    TARGET_WAY_BY_POSE = 1,  /**< By TARGET_WAY_POSE, that way leaves a limit. */
    TARGET_WAY_NONE = 2,     /**< By neither. */
    TARGET_WAY_UNKNOWN = 3,  /**< Nothing was judged yet. */
    TARGET_WAY_TO_POSE = 4,  /**< Not direct; the way to the pose is judged next... */
    TARGET_WAY_FROM_POSE = 5 /**< ...and then the one from there. */
} target_way_kind_t;

/** At first all zero. The verdict, and its ways: the 17 values of a curved limit are too many for
 * each cycle. Has a seal of its own. */
typedef struct {
    int32_t from_ticks[ROBOT_AXIS_MAX];
    int32_t to_ticks[ROBOT_AXIS_MAX];
    uint32_t kind; /**< target_way_kind_t. */
    uint32_t seal;
} target_way_t;

/**
 * Looks from `from` to `to` (ticks), unless that is known already: one way in each call, so it is
 * known in the first whether the direct one leaves a limit, and in the third whether the other
 * does.
 *
 * @satisfies SWR-NEXT-023
 */
void target_way_look(target_way_t *self, const robot_t *robot, const int32_t from[ROBOT_AXIS_MAX],
                     const int32_t to[ROBOT_AXIS_MAX]);

/** The way from `from` to `to` was judged and is direct. */
void target_way_take(target_way_t *self, const robot_t *robot, const int32_t from[ROBOT_AXIS_MAX],
                     const int32_t to[ROBOT_AXIS_MAX]);

#endif
