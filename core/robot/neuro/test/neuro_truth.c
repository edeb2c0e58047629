/* SPDX-License-Identifier: Apache-2.0 */
#include "robot/neuro/test/neuro_truth.h"

#include "robot/robot_neuro.h"

double neuro_truth_coupled(const robot_t *robot, uint32_t index,
                           const double places[ROBOT_AXIS_MAX])
{
    (void)index;
    return (robot->geometry_nm[NEURO_HOME_SEPARATION] / 1e6) + places[NEURO_AXIS_HEAD] -
           places[NEURO_AXIS_FEET];
}
