/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/scenario/targets.h"

#include "integration/support/rig.h"
#include "robot/kinematics.h"
#include "robot/robot_kind.h"
#include "robot/robot_neuro.h"
#include "supervise/scenario/prng.h"
#include "supervise/watch/truth.h"

#include <stddef.h>

#define TRIES 32U
#define NEAR_PARTS 50 /* Part of the ways of the axes that is near. */
#define ONE_Q30 1073741824

static bool is_neuro(const robot_t *robot)
{
    return robot->kind == ROBOT_KIND_NEURO;
}

static rigid_t pose_at(const robot_t *robot, const int32_t ticks[ROBOT_AXIS_MAX])
{
    joints_t joints;
    rigid_t pose;
    joints_from_ticks(robot, ticks, &joints);
    kinematics_forward(robot, &robot->probe, &joints, &pose);
    return pose;
}

static bool is_in_reach(const robot_t *robot, const int32_t ticks[ROBOT_AXIS_MAX])
{
    double places[ROBOT_AXIS_MAX] = {0.0};
    bool is_inside = true;
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        places[i] = ticks[i];
    }
    for (uint32_t i = 0U; i < robot->coupled_limit_count; i++) {
        is_inside = is_inside && (truth_coupled_beyond(robot, i, places) < 0.0);
    }
    return is_inside;
}

/* The middle of all ways, and up to one of `parts` of each beyond it. */
static rigid_t past_middle(const robot_t *robot, uint32_t *random, int32_t parts)
{
    int32_t ticks[ROBOT_AXIS_MAX] = {0};
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        const axis_config_t *const axis = &robot->axes[i];
        const int32_t span = axis->target_maximum_ticks - axis->target_minimum_ticks;
        ticks[i] = axis->target_minimum_ticks + (span / 2);
        ticks[i] += (parts != 0) ? (int32_t)prng_below(random, (uint32_t)(span / parts) + 1U) : 0;
    }
    return pose_at(robot, ticks);
}

/* A straight needle with its point in a box, mm. */
static rigid_t straight(uint32_t *random, const int32_t least_mm[3], const uint32_t counts[3],
                        int32_t step_nm)
{
    int32_t at_nm[3];
    for (uint32_t i = 3U; i > 0U; i--) {
        at_nm[i - 1U] =
            (least_mm[i - 1U] * 1000000) + ((int32_t)prng_below(random, counts[i - 1U]) * step_nm);
    }
    return rig_pose(at_nm[0], at_nm[1], at_nm[2]);
}

rigid_t targets_first(const robot_t *robot)
{
    return is_neuro(robot) ? rig_pose(5000000, 190000000, 60000000) : past_middle(robot, NULL, 0);
}

rigid_t targets_any(const robot_t *robot, uint32_t *random)
{
    int32_t ticks[ROBOT_AXIS_MAX] = {0};
    if (is_neuro(robot)) {
        return straight(random, (const int32_t[]){-15, 175, 40}, (const uint32_t[]){30U, 25U, 40U},
                        1000000);
    }
    for (uint32_t tries = 0U; (tries == 0U) || ((tries < TRIES) && !is_in_reach(robot, ticks));
         tries++) {
        for (uint32_t i = 0U; i < robot->axis_count; i++) {
            const axis_config_t *const axis = &robot->axes[i];
            const int32_t span = axis->target_maximum_ticks - axis->target_minimum_ticks;
            ticks[i] =
                axis->target_minimum_ticks + (int32_t)prng_below(random, (uint32_t)span + 1U);
        }
    }
    return pose_at(robot, ticks);
}

rigid_t targets_near(const robot_t *robot, uint32_t *random)
{
    return is_neuro(robot) ? straight(random, (const int32_t[]){0, 190, 60},
                                      (const uint32_t[]){9U, 9U, 9U}, 250000)
                           : past_middle(robot, random, NEAR_PARTS);
}

bool targets_entry(const robot_t *robot, const joints_t *joints, const rigid_t *target,
                   point_t *entry)
{
    if (!is_neuro(robot)) {
        return false;
    }
    const int64_t back_nm = joints->value[robot->needle_axis] +
                            robot->probe.length_nm[NEURO_PROBE_ROBOT_TO_TREATMENT] -
                            robot->probe.length_nm[NEURO_PROBE_ROBOT_TO_ENTRY];
    const int32_t way_nm[3] = {(int32_t)(back_nm * target->rotation_q30[0][2] / ONE_Q30),
                               (int32_t)(back_nm * target->rotation_q30[1][2] / ONE_Q30),
                               (int32_t)(back_nm * target->rotation_q30[2][2] / ONE_Q30)};
    *entry = (point_t){target->translation.x_nm - way_nm[0], target->translation.y_nm - way_nm[1],
                       target->translation.z_nm - way_nm[2]};
    return true;
}
