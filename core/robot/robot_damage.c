/* SPDX-License-Identifier: Apache-2.0 */
#include "robot/robot_damage.h"

#include "base/seal.h"

#include <stdbool.h>
#include <stddef.h>

uint32_t robot_damage(const robot_t *robot)
{
    uint32_t damage = 0U;
    const uint32_t seal = seal_of(SEAL_START, (const uint8_t *)robot, offsetof(robot_t, seal));
    if (seal != robot->seal) {
        return (uint32_t)1U << ROBOT_PART_GEOMETRY;
    }
    for (uint32_t i = 0U; i < ROBOT_POSES; i++) {
        const pose_t *const pose = &robot->poses[i];
        const bool is_given = (robot->pose_mask & ((uint32_t)1U << i)) != 0U;
        if (is_given &&
            (seal_of(SEAL_START, (const uint8_t *)pose, offsetof(pose_t, seal)) != pose->seal)) {
            damage |= (uint32_t)1U << ROBOT_PART_GEOMETRY;
        }
    }
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const axis_config_t *const row = &robot->axes[i];
        if (seal_of(SEAL_START, (const uint8_t *)row, offsetof(axis_config_t, seal)) != row->seal) {
            damage |= (uint32_t)1U << i;
        }
    }
    return damage;
}
