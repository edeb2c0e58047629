/* SPDX-License-Identifier: Apache-2.0 */
#include "procedure/target_way.h"

#include "base/seal.h"
#include "robot/coupled_path.h"
#include "robot/robot_damage.h"

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

static bool is_free(const robot_t *robot, const int32_t from[ROBOT_AXIS_MAX],
                    const int32_t to[ROBOT_AXIS_MAX])
{
    return coupled_path_judge(robot, from, to).status == STATUS_OK;
}

static bool leads_by_pose(const robot_t *robot, const int32_t from[ROBOT_AXIS_MAX],
                          const int32_t to[ROBOT_AXIS_MAX])
{
    const uint32_t pose = (uint32_t)TARGET_WAY_POSE;
    return robot_has_pose(robot, pose) && !robot_is_pose_damaged(robot, pose) &&
           is_free(robot, from, robot->poses[pose].ticks) &&
           is_free(robot, robot->poses[pose].ticks, to);
}

static target_way_kind_t find(const robot_t *robot, const int32_t from[ROBOT_AXIS_MAX],
                              const int32_t to[ROBOT_AXIS_MAX])
{
    target_way_kind_t kind = TARGET_WAY_DIRECT;
    if (!is_free(robot, from, to)) {
        kind = leads_by_pose(robot, from, to) ? TARGET_WAY_BY_POSE : TARGET_WAY_NONE;
    }
    return kind;
}

static uint32_t seal_of_way(const target_way_t *self)
{
    return seal_of(SEAL_START, (const uint8_t *)self, offsetof(target_way_t, seal));
}

void target_way_look(target_way_t *self, const robot_t *robot, const int32_t from[ROBOT_AXIS_MAX],
                     const int32_t to[ROBOT_AXIS_MAX])
{
    const size_t length = robot->axis_count * sizeof from[0];
    if ((memcmp(self->from_ticks, from, length) == 0) &&
        (memcmp(self->to_ticks, to, length) == 0) && (self->seal == seal_of_way(self))) {
        return;
    }
    (void)memcpy(self->from_ticks, from, length);
    (void)memcpy(self->to_ticks, to, length);
    self->kind = (uint32_t)find(robot, from, to);
    self->seal = seal_of_way(self);
}
