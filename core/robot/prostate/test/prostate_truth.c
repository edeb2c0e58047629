/* SPDX-License-Identifier: Apache-2.0 */
#include "robot/prostate/test/prostate_truth.h"

#include "robot/prostate/test/prostate_reference.h"

double prostate_truth_coupled(const robot_t *robot, uint32_t index,
                              const double places[ROBOT_AXIS_MAX])
{
    double front[3];
    double direction[3];
    double angles[2];
    const double gaps[2] = {places[PROSTATE_AXIS_FRONT_LEFT] - places[PROSTATE_AXIS_FRONT_RIGHT],
                            places[PROSTATE_AXIS_REAR_LEFT] - places[PROSTATE_AXIS_REAR_RIGHT]};
    if (index < 2U) {
        return gaps[index];
    }
    reference_line(robot, places, front, direction);
    reference_angles(direction, &angles[0], &angles[1]);
    return angles[index - 2U] * (180.0 / REFERENCE_PI);
}
