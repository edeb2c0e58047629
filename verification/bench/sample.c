/* SPDX-License-Identifier: Apache-2.0 */
#include "bench/sample.h"

#include <string.h>

const robot_t *sample_robot(const robot_t *robot, bool is_handless)
{
    static robot_t handless;
    if (!is_handless) {
        return robot;
    }
    handless = *robot;
    (void)memset(&handless.force, 0, sizeof handless.force);
    return &handless;
}
