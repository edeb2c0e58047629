/* SPDX-License-Identifier: Apache-2.0 */
#include "safety/needle.h"

#include "limits/requirement_limits.h"
#include "robot/joints.h"

int32_t needle_out_ticks(const robot_t *robot)
{
    const axis_config_t *const needle = &robot->axes[robot->needle_axis];
    return needle->home_ticks +
           (int32_t)(((int64_t)LIMIT_NEEDLE_OUT_NM * 65536) / needle->unit_per_tick_q16);
}

int32_t needle_retracted_ticks(const robot_t *robot)
{
    const int32_t home_ticks = robot->axes[robot->needle_axis].home_ticks;
    return home_ticks + ((needle_out_ticks(robot) - home_ticks) / 2);
}

/* By its counts. */
static bool is_in(const robot_t *robot, const axis_t *needle)
{
    const axis_config_t *const config = &robot->axes[robot->needle_axis];
    const int64_t in_ticks =
        (int64_t)needle->sealed.encoder.position_ticks - (int64_t)config->home_ticks;
    return joints_is_beyond(config, in_ticks, LIMIT_NEEDLE_OUT_NM, LIMIT_NEEDLE_OUT_NM);
}

/* A switch alone, which may be broken, does not say so. */
bool needle_is_out(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX])
{
    const axis_t *const needle = &axes[robot->needle_axis];
    return axis_is_homed(needle) && !is_in(robot, needle);
}

bool needle_may_be_in(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX])
{
    const axis_t *const needle = &axes[robot->needle_axis];
    return !axis_is_as_parked(needle) &&
           ((needle->sealed.place != AXIS_PLACE_COUNTED) || is_in(robot, needle));
}

bool needle_must_leave(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX])
{
    bool is_base_unknown = false;
    if (!axis_is_homed(&axes[robot->needle_axis]) || needle_is_out(robot, axes)) {
        return false;
    }
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const bool is_across = robot->axes[i].needle_motion == (uint32_t)NEEDLE_ACROSS;
        if (is_across && !axis_is_homed(&axes[i])) {
            is_base_unknown = true;
        }
    }
    return is_base_unknown;
}

bool needle_forbids_jog(const robot_t *robot, const axis_t axes[ROBOT_AXIS_MAX], uint32_t index,
                        bool is_upwards)
{
    const uint32_t motion = robot->axes[index].needle_motion;
    bool is_forbidden = false;
    if (motion == (uint32_t)NEEDLE_ACROSS) {
        is_forbidden = !needle_is_out(robot, axes);
    } else if (motion == (uint32_t)NEEDLE_ALONG) {
        is_forbidden = is_upwards && !axis_is_homed(&axes[index]);
    } else {
        /* It turns about its own line. */
    }
    return is_forbidden;
}
