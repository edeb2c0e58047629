/* SPDX-License-Identifier: Apache-2.0 */
#include "robot/robot_damage.h"

#include "base/seal.h"

#include <stdbool.h>
#include <stddef.h>

bool robot_is_pose_damaged(const robot_t *robot, uint32_t pose)
{
    const pose_t *const row = &robot->poses[pose];
    return seal_of(SEAL_START, (const uint8_t *)row, WHOLE_WORDS(offsetof(pose_t, seal))) !=
           row->seal;
}

bool robot_is_force_damaged(const robot_t *robot)
{
    const force_config_t *const force = &robot->force;
    uint32_t seal = 0U; /* As that of no sensor. */
    if (force->is_there != 0U) {
        seal = seal_of(SEAL_START, (const uint8_t *)force,
                       WHOLE_WORDS(offsetof(force_config_t, seal)));
    }
    return seal != force->seal;
}

uint32_t robot_damage(const robot_t *robot)
{
    uint32_t damage = 0U;
    const uint32_t seal =
        seal_of(SEAL_START, (const uint8_t *)robot, WHOLE_WORDS(offsetof(robot_t, seal)));
    if (seal != robot->seal) {
        return (uint32_t)1U << ROBOT_PART_GEOMETRY;
    }
    if (robot_has_pose(robot, (uint32_t)POSE_HOME) &&
        robot_is_pose_damaged(robot, (uint32_t)POSE_HOME)) {
        damage |= (uint32_t)1U << ROBOT_PART_GEOMETRY;
    }
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const axis_config_t *const row = &robot->axes[i];
        if (seal_of(SEAL_START, (const uint8_t *)row, WHOLE_WORDS(offsetof(axis_config_t, seal))) !=
            row->seal) {
            damage |= (uint32_t)1U << i;
        }
    }
    return damage;
}
