/* SPDX-License-Identifier: Apache-2.0 */
#include "robot/coupled_path.h"

#include "robot/coupled_limit.h"
#include "robot/kinematics.h"

#include <string.h>

#define STEPS 16U

/* Position of the axis after `step` steps, for a way up or down between any ticks. */
static int32_t ticks_at(int32_t from, int32_t to, uint32_t step)
{
    const int64_t way = ((int64_t)to - from) * (int64_t)step;
    return (int32_t)(from + (way / (int64_t)STEPS));
}

static void look(const robot_t *robot, uint32_t index, const int32_t from[ROBOT_AXIS_MAX],
                 const int32_t to[ROBOT_AXIS_MAX], int64_t values[STEPS + 1U])
{
    const coupled_limit_t *const limit = &robot->coupled_limits[index];
    joints_t joints;
    (void)memset(&joints, 0, sizeof joints);
    for (uint32_t step = 0U; step <= STEPS; step++) {
        for (uint32_t i = 0U; i < robot->axis_count; i++) {
            if (coupled_limit_has(limit, i)) {
                joints.value[i] = joints_of(&robot->axes[i], ticks_at(from[i], to[i], step));
            }
        }
        values[step] = kinematics_coupled(robot, index, &joints);
    }
}

/* Distance of the value beyond two looks that is possible between them: twice an eighth of its
 * largest bend. */
static int64_t most_between(const int64_t values[STEPS + 1U])
{
    int64_t most = 0;
    for (uint32_t i = 1U; i < STEPS; i++) {
        const int64_t bend = (values[i - 1U] - values[i]) + (values[i + 1U] - values[i]);
        const int64_t size = (bend < 0) ? -bend : bend;
        most = (size > most) ? size : most;
    }
    return most / 4;
}

static solution_t judge(const coupled_limit_t *limit, const int64_t values[STEPS + 1U])
{
    const int64_t margin = coupled_limit_margin(limit);
    const int64_t between = most_between(values);
    const int64_t room = (between > margin) ? between : margin;
    const int64_t least = (int64_t)limit->minimum + room;
    const int64_t most = (int64_t)limit->maximum - room;
    const int64_t lowest = (values[0] < least) ? values[0] : least;
    const int64_t highest = (values[0] > most) ? values[0] : most;
    solution_t result = {.status = STATUS_OK};
    for (uint32_t i = 1U; (i <= STEPS) && (result.status == STATUS_OK); i++) {
        if ((values[i] < lowest) || (values[i] > highest)) {
            result.status = (status_t)limit->refusal;
            result.is_maximum = (values[i] > highest) ? 1U : 0U;
        }
    }
    return result;
}

solution_t coupled_path_judge(const robot_t *robot, const int32_t from[ROBOT_AXIS_MAX],
                              const int32_t to[ROBOT_AXIS_MAX])
{
    solution_t result = {.status = STATUS_OK};
    for (uint32_t i = 0U; (i < robot->coupled_limit_count) && (result.status == STATUS_OK); i++) {
        const coupled_limit_t *const limit = &robot->coupled_limits[i];
        if (limit->is_curved != 0U) {
            int64_t values[STEPS + 1U];
            look(robot, i, from, to, values);
            result = judge(limit, values);
        }
    }
    return result;
}
