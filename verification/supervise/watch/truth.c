/* SPDX-License-Identifier: Apache-2.0 */
#include "supervise/watch/truth.h"

#include "robot/kinematics.h"
#include "robot/neuro/test/neuro_truth.h"
#include "robot/prostate/test/prostate_truth.h"
#include "robot/robot_kind.h"

#include <math.h>

#define NM_PER_MM 1e6

double truth_in_words(uint8_t unit, double units)
{
    return (unit == (uint8_t)AXIS_UNIT_MM) ? (units / NM_PER_MM) : (units * 360.0 / 4294967296.0);
}

double truth_measure(const axis_config_t *axis, double ticks)
{
    return truth_in_words(axis->unit, ticks * (double)axis->unit_per_tick_q16 / 65536.0);
}

/* Coupled limit of a robot without a reference of its own, by the core. */
static double core_coupled(const robot_t *robot, uint32_t index, const double ticks[ROBOT_AXIS_MAX])
{
    int32_t whole[ROBOT_AXIS_MAX] = {0};
    joints_t joints;
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        whole[i] = (int32_t)lround(ticks[i]);
    }
    joints_from_ticks(robot, whole, &joints);
    return truth_in_words(robot->coupled_limits[index].unit,
                          (double)kinematics_coupled(robot, index, &joints));
}

double truth_coupled(const robot_t *robot, uint32_t index, const double ticks[ROBOT_AXIS_MAX])
{
    double places[ROBOT_AXIS_MAX] = {0.0};
    double value = 0.0;
    for (uint32_t i = 0U; i < robot->axis_count; i++) {
        places[i] = truth_measure(&robot->axes[i], ticks[i]);
    }
    switch (robot->kind) {
    case ROBOT_KIND_NEURO:
        value = neuro_truth_coupled(robot, index, places);
        break;
    case ROBOT_KIND_PROSTATE:
        value = prostate_truth_coupled(robot, index, places);
        break;
    default:
        value = core_coupled(robot, index, ticks);
        break;
    }
    return value;
}

double truth_coupled_beyond(const robot_t *robot, uint32_t index,
                            const double ticks[ROBOT_AXIS_MAX])
{
    const coupled_limit_t *const limit = &robot->coupled_limits[index];
    const double value = truth_coupled(robot, index, ticks);
    return fmax(truth_in_words(limit->unit, limit->minimum) - value,
                value - truth_in_words(limit->unit, limit->maximum));
}

double truth_coupled_range(const robot_t *robot, uint32_t index)
{
    const coupled_limit_t *const limit = &robot->coupled_limits[index];
    return truth_in_words(limit->unit, (double)limit->maximum - limit->minimum);
}

uint32_t truth_coupled_axes(const robot_t *robot, uint32_t index)
{
    return robot->coupled_limits[index].axes;
}
