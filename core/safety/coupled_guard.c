/* SPDX-License-Identifier: Apache-2.0 */
#include "safety/coupled_guard.h"

#include "axis/follower.h"
#include "limits/requirement_limits.h"
#include "robot/joints.h"

#define TICK_Q8_US INT64_C(256000000)
/* A count says where an axis is to within one. */
#define COUNT_TICKS INT64_C(1)

static bool is_of(const coupled_limit_t *limit, uint32_t index)
{
    return (limit->first == index) || (limit->second == index);
}

static bool is_known(const coupled_limit_t *limit, const axis_t axes[ROBOT_AXIS_MAX])
{
    return axis_is_homed(&axes[limit->first]) && axis_is_homed(&axes[limit->second]);
}

static bool is_in_force(const coupled_limit_t *limit, const axis_t axes[ROBOT_AXIS_MAX],
                        uint32_t index)
{
    return is_of(limit, index) && is_known(limit, axes);
}

static bool drives(const axis_config_t *config, const card_drive_t *drive, bool is_upwards)
{
    return (drive->mode != (uint32_t)CARD_DRIVE_OFF) &&
           (servo_is_upwards(config, drive) == is_upwards);
}

/* How far the axis may still go this way. */
static int64_t way_nm(const robot_t *robot, const coupled_view_t *view, uint32_t index,
                      bool is_upwards)
{
    const axis_config_t *const config = &robot->axes[index];
    const int64_t full_q8 = (int64_t)config->full_speed_ticks_per_s * 256;
    const int64_t measured_q8 = (int64_t)view->axes[index].encoder.speed_ticks_per_s_q8;
    int64_t speed_q8 = 0;
    if (drives(config, &view->sent[index], is_upwards) ||
        drives(config, &view->requests[index], is_upwards)) {
        speed_q8 = full_q8;
    }
    if ((is_upwards ? measured_q8 : -measured_q8) > speed_q8) {
        speed_q8 = is_upwards ? measured_q8 : -measured_q8;
    }
    const int64_t ticks =
        ((speed_q8 * (int64_t)LIMIT_COUPLED_STOP_US) + TICK_Q8_US - 1) / TICK_Q8_US;
    return joints_value(config, (int32_t)(ticks + COUNT_TICKS));
}

static bool may_leave(const robot_t *robot, const coupled_limit_t *limit,
                      const coupled_view_t *view, bool is_growing)
{
    const int64_t now_nm =
        coupled_limit_nm(robot, limit, view->axes[limit->first].encoder.position_ticks,
                         view->axes[limit->second].encoder.position_ticks);
    const int64_t more_nm = way_nm(robot, view, limit->first, is_growing) +
                            way_nm(robot, view, limit->second, !is_growing);
    return is_growing ? ((now_nm + more_nm) > (int64_t)limit->maximum_nm)
                      : ((now_nm - more_nm) < (int64_t)limit->minimum_nm);
}

static uint32_t other_of(const coupled_limit_t *limit, uint32_t index)
{
    return (limit->first == index) ? limit->second : limit->first;
}

/* Nobody knows where an axis is that is not homed, but where its switch is. */
static bool is_home_beyond(const robot_t *robot, const coupled_limit_t *limit,
                           const axis_t axes[ROBOT_AXIS_MAX], uint32_t index)
{
    const bool is_first = limit->first == index;
    const uint32_t other = other_of(limit, index);
    const axis_config_t *const config = &robot->axes[index];
    const int32_t there = axes[other].encoder.position_ticks;
    if ((config->limit_switch == (uint8_t)LIMIT_SWITCH_NONE) || !is_of(limit, index) ||
        axis_is_homed(&axes[index]) || !axis_is_homed(&axes[other])) {
        return false;
    }
    const int64_t above_nm = coupled_limit_nm(robot, limit, is_first ? config->home_ticks : there,
                                              is_first ? there : config->home_ticks);
    return (above_nm < (int64_t)limit->minimum_nm) || (above_nm > (int64_t)limit->maximum_nm);
}

/* Both follow one, or one the other: what is between them stays. */
static bool is_block(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX], uint32_t index,
                     uint32_t other)
{
    return follower_leader(robot, axes, index) == follower_leader(robot, axes, other);
}

bool coupled_guard_bars_homing(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                               uint32_t index)
{
    bool is_barred = false;
    for (uint32_t i = 0U; i < robot->coupled_limit_count; i++) {
        const coupled_limit_t *const limit = &robot->coupled_limits[i];
        if (is_home_beyond(robot, limit, axes, index) &&
            !follower_is_of(robot, other_of(limit, index), index)) {
            is_barred = true;
        }
    }
    return is_barred;
}

bool coupled_guard_blocks(const robot_t *robot, const coupled_view_t *view, uint32_t index)
{
    const card_drive_t *const request = &view->requests[index];
    const axis_config_t *const config = &robot->axes[index];
    const bool is_upwards = servo_is_upwards(config, request);
    const bool is_upper = config->limit_switch == (uint8_t)LIMIT_SWITCH_UPPER;
    const bool is_towards_switch = is_upwards == is_upper;
    bool is_blocked = false;
    if (request->mode == (uint32_t)CARD_DRIVE_OFF) {
        return false;
    }
    for (uint32_t i = 0U; i < robot->coupled_limit_count; i++) {
        const coupled_limit_t *const limit = &robot->coupled_limits[i];
        const bool is_first = limit->first == index;
        const bool is_growing = is_upwards == is_first;
        if (is_in_force(limit, view->axes, index) && may_leave(robot, limit, view, is_growing)) {
            is_blocked = true;
        }
        if (is_towards_switch && is_home_beyond(robot, limit, view->axes, index) &&
            !is_block(robot, view->axes, index, other_of(limit, index))) {
            is_blocked = true;
        }
    }
    return is_blocked;
}

bool coupled_guard_is_known(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX], uint32_t index)
{
    bool is_every_known = axis_is_homed(&axes[index]);
    for (uint32_t i = 0U; i < robot->coupled_limit_count; i++) {
        const coupled_limit_t *const limit = &robot->coupled_limits[i];
        is_every_known = is_every_known && (!is_of(limit, index) || is_known(limit, axes));
    }
    return is_every_known;
}

solution_t coupled_guard_judge(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX],
                               uint32_t index, int32_t ticks)
{
    solution_t result = {STATUS_OK, 0U, 0U};
    for (uint32_t i = 0U; (i < robot->coupled_limit_count) && (result.status == STATUS_OK); i++) {
        const coupled_limit_t *const limit = &robot->coupled_limits[i];
        const bool is_first = limit->first == index;
        const int32_t first = is_first ? ticks : axes[limit->first].encoder.position_ticks;
        const int32_t second = is_first ? axes[limit->second].encoder.position_ticks : ticks;
        if (is_in_force(limit, axes, index)) {
            result = coupled_limit_refusal(
                limit, coupled_limit_side(limit, coupled_limit_nm(robot, limit, first, second)));
        }
    }
    result.axis = (result.status == STATUS_OK) ? 0U : (uint8_t)index;
    return result;
}
