/* SPDX-License-Identifier: Apache-2.0 */
#include "axis/follower.h"

#include "base/fixed.h"
#include "limits/requirement_limits.h"
#include "robot/joints.h"

bool follower_is_of(const robot_t *robot, uint32_t index, uint32_t leader)
{
    const uint32_t stage = (uint32_t)robot->axes[leader].home_stage;
    return (uint32_t)robot->axes[index].leaders[(stage - 1U) % ROBOT_HOME_STAGES] == (leader + 1U);
}

bool follower_has_one(const robot_t *robot, uint32_t leader)
{
    bool has_one = false;
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        has_one = has_one || follower_is_of(robot, i, leader);
    }
    return has_one;
}

bool follower_is_in_block(const robot_t *robot, uint32_t index)
{
    bool is_in_one = follower_has_one(robot, index);
    for (uint32_t i = 0U; i < ROBOT_HOME_STAGES; i++) {
        is_in_one = is_in_one || (robot->axes[index].leaders[i] != 0U);
    }
    return is_in_one;
}

uint32_t follower_leader(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX], uint32_t index)
{
    uint32_t found = index;
    for (uint32_t i = 0U; i < ROBOT_HOME_STAGES; i++) {
        const uint32_t leader = (uint32_t)robot->axes[index].leaders[i];
        if ((leader != 0U) && axis_is_homing(&axes[leader - 1U])) {
            found = leader - 1U;
        }
    }
    return found;
}

void follower_tie(const robot_t *robot, axis_t axes[ROBOT_AXIS_MAX], uint32_t leader)
{
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        if (follower_is_of(robot, i, leader)) {
            axes[i].sealed.homing.start_ticks = axes[i].sealed.encoder.position_ticks;
        }
    }
}

static int64_t way_ticks(const axis_t *self, int32_t ticks)
{
    return (int64_t)ticks - (int64_t)self->sealed.homing.start_ticks;
}

int32_t follower_apart_ticks(const axis_t *self, const axis_t *leader, uint32_t pace)
{
    return fixed_saturate(
        way_ticks(self, self->sealed.encoder.position_ticks) -
        ((int64_t)pace * way_ticks(leader, leader->sealed.encoder.position_ticks)));
}

card_drive_t follower_step(axis_t *self, const axis_config_t *config, const axis_t *leader,
                           uint32_t pace, uint32_t elapsed_us)
{
    const int64_t setpoint = (int64_t)self->sealed.homing.start_ticks +
                             ((int64_t)pace * way_ticks(leader, leader->sealed.setpoint_ticks));
    const int64_t speed = (int64_t)pace * (int64_t)leader->sealed.setpoint_speed_ticks_per_s_q8;
    return axis_follow(self, config, fixed_saturate(setpoint), fixed_saturate(speed), elapsed_us);
}

bool follower_is_at_end(const axis_t *self, const axis_config_t *config,
                        const card_drive_t *request)
{
    return axis_is_towards_switch(self, config, request) ||
           (axis_is_placed(self) && axis_is_driven_out(self, config, request));
}

bool follower_is_stuck(const axis_t *self, const axis_config_t *config, const axis_t *leader,
                       uint32_t pace, const card_drive_t *request)
{
    const int64_t apart = (int64_t)follower_apart_ticks(self, leader, pace);
    return joints_is_beyond(config, (apart < 0) ? -apart : apart, LIMIT_FOLLOWER_WAY_NM,
                            LIMIT_FOLLOWER_WAY_BAM) ||
           follower_is_at_end(self, config, request);
}
