/* SPDX-License-Identifier: Apache-2.0 */
/**
 * @file
 * Axes that carry one linkage home as a block: while one homes by its switch, those that follow it
 * (axis_config_t.leaders) go the same way, each at the distance from it that they had when that
 * homing began. No length between them changes while their positions are not known yet. Without
 * state but homing_t.start_ticks of each axis, which its owner seals.
 */
#ifndef BORESIGHT_FOLLOWER_H
#define BORESIGHT_FOLLOWER_H

#include "axis/axis.h"
#include "robot/robot.h"

#include <stdbool.h>
#include <stdint.h>

/** @return true when axis `index` follows axis `leader` whenever that homes */
bool follower_is_of(const robot_t *robot, uint32_t index, uint32_t leader);

/** @return true when any axis follows axis `leader` */
bool follower_has_one(const robot_t *robot, uint32_t leader);

/** @return true when axis `index` does not home alone: it follows one in some stage, or one follows
 * it */
bool follower_is_in_block(const robot_t *robot, uint32_t index);

/** @return the axis with which axis `index` travels now: the one that homes and that it follows;
 * itself when there is none */
uint32_t follower_leader(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX], uint32_t index);

/**
 * Axis `leader` has begun to home: its followers keep their distance from here on.
 *
 * @satisfies SWR-AXIS-028
 * @satisfies SWR-AXIS-031
 */
void follower_tie(const robot_t *robot, axis_t axes[ROBOT_AXIS_MAX], uint32_t leader);

/** @return how far the follower is above where its leader has it, ticks. `pace`, here and below:
 * its ticks for each of the leader's, 1 in a block */
int32_t follower_apart_ticks(const axis_t *self, const axis_t *leader, uint32_t pace);

/**
 * Request for following `leader`, which homes and has been asked for its request of this cycle.
 *
 * @satisfies SWR-AXIS-028
 */
card_drive_t follower_step(axis_t *self, const axis_config_t *config, const axis_t *leader,
                           uint32_t pace, uint32_t elapsed_us);

/**
 * @return true when `request` is towards its active switch, or beyond a soft limit by what its
 * counts say of where it is
 *
 * @satisfies SWR-AXIS-029
 * @satisfies SWR-AXIS-053
 */
bool follower_is_at_end(const axis_t *self, const axis_config_t *config,
                        const card_drive_t *request);

/**
 * @return true when it cannot follow: it is LIMIT_FOLLOWER_WAY_NM or LIMIT_FOLLOWER_WAY_BAM from
 * where its leader has it, or at its end
 *
 * @satisfies SWR-AXIS-029
 */
bool follower_is_stuck(const axis_t *self, const axis_config_t *config, const axis_t *leader,
                       uint32_t pace, const card_drive_t *request);

#endif
