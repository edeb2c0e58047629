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

static bool has_pose(const robot_t *robot)
{
    const uint32_t pose = (uint32_t)TARGET_WAY_POSE;
    return robot_has_pose(robot, pose) && !robot_is_pose_damaged(robot, pose);
}

/* Verdict after one more way. */
static target_way_kind_t judge_next(const target_way_t *self, const robot_t *robot)
{
    const int32_t *const pose_ticks = robot->poses[TARGET_WAY_POSE].ticks;
    target_way_kind_t kind = TARGET_WAY_NONE;
    if (self->kind == (uint32_t)TARGET_WAY_UNKNOWN) {
        kind = is_free(robot, self->from_ticks, self->to_ticks) ? TARGET_WAY_DIRECT
                                                                : TARGET_WAY_TO_POSE;
    } else if (!has_pose(robot)) {
        kind = TARGET_WAY_NONE;
    } else if (self->kind == (uint32_t)TARGET_WAY_TO_POSE) {
        kind =
            is_free(robot, self->from_ticks, pose_ticks) ? TARGET_WAY_FROM_POSE : TARGET_WAY_NONE;
    } else {
        kind = is_free(robot, pose_ticks, self->to_ticks) ? TARGET_WAY_BY_POSE : TARGET_WAY_NONE;
    }
    return kind;
}

static uint32_t seal_of_way(const target_way_t *self)
{
    return seal_of(SEAL_START, (const uint8_t *)self, WHOLE_WORDS(offsetof(target_way_t, seal)));
}

static bool is_of(const target_way_t *self, const robot_t *robot,
                  const int32_t from[ROBOT_AXIS_MAX], const int32_t to[ROBOT_AXIS_MAX])
{
    const size_t length = robot->axis_count * sizeof from[0];
    return (memcmp(self->from_ticks, from, length) == 0) &&
           (memcmp(self->to_ticks, to, length) == 0) && (self->seal == seal_of_way(self));
}

static void set(target_way_t *self, target_way_kind_t kind)
{
    self->kind = (uint32_t)kind;
    self->seal = seal_of_way(self);
}

void target_way_take(target_way_t *self, const robot_t *robot, const int32_t from[ROBOT_AXIS_MAX],
                     const int32_t to[ROBOT_AXIS_MAX])
{
    const size_t length = robot->axis_count * sizeof from[0];
    (void)memcpy(self->from_ticks, from, length);
    (void)memcpy(self->to_ticks, to, length);
    set(self, TARGET_WAY_DIRECT);
}

void target_way_look(target_way_t *self, const robot_t *robot, const int32_t from[ROBOT_AXIS_MAX],
                     const int32_t to[ROBOT_AXIS_MAX])
{
    if (!is_of(self, robot, from, to)) {
        target_way_take(self, robot, from, to);
        self->kind = (uint32_t)TARGET_WAY_UNKNOWN;
    }
    if (self->kind >= (uint32_t)TARGET_WAY_UNKNOWN) {
        set(self, judge_next(self, robot));
    }
}
