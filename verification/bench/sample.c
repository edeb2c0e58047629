/* SPDX-License-Identifier: Apache-2.0 */
#include "bench/sample.h"

#include <string.h>

const robot_t *sample_robot(const robot_t *robot, bool is_sensorless)
{
    static robot_t sensorless;
    if (!is_sensorless) {
        return robot;
    }
    sensorless = *robot;
    (void)memset(&sensorless.force, 0, sizeof sensorless.force);
    return &sensorless;
}
